"""The steps as an algorithm are run as they are printed: they give the rows of the program."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.derivation.french.language import French
from dhgen.derivation.text.blocks import Drawing
from dhgen.kinematics.given import given_values
from dhgen.kinematics.numeric import numeric_arm
from dhgen.program.interpret import interpret
from tests.derivation.stories import NAMES, document, story

if TYPE_CHECKING:
    from collections.abc import Iterator

LISTING = re.compile(r"become known, with the branches:\n\n```text\n(.*?)\n```", re.DOTALL)
LETTER = "[A-Za-zα-ωΔℓ]"
TOKEN = re.compile(rf"atan2|sgn|\d+(?:\.\d+)?|{LETTER}+[₀-₉₋]*(?:_[xyz\d]+)?[′'^]*|√|²|[-+−*/(),|]")
DIGITS = str.maketrans("₀₁₂₃₄₅₆₇₈₉₋", "0123456789-")
OTHERS = [
    "arm_6r",
    "rrprrr",
    "puma",
    "planar_pr",
    "spherical_offset",
    "wrist_cardan",
    "adept",
    "rpr",
    "bartell_rprpr",  # two equations that are added
    "katana_400",
]
LISTED = [name for name in sorted({*NAMES, *OTHERS}) if LISTING.search(document(name))]
Letters = dict[str, float]


def python_of(text: str) -> str:
    """A formula as a terminal spells it, in Python: letters are looked up in `at`."""
    words: list[str] = []
    for piece in TOKEN.findall(text):
        starts = piece not in "−-+*/),²"
        call = words and words[-1] in {"atan2", "sgn", "sqrt"}
        if starts and words and words[-1] not in {"-", "+", "*", "/", "(", ","} and not call:
            words.append("*")
        known = {"−": "-", "√": "sqrt", "²": "**2", "π": "pi", "atan2": "atan2", "sgn": "sgn"}
        word = known.get(piece, piece)
        if piece not in known and re.match(LETTER, piece):
            word = f"at[{piece!r}]"
        words.append(word)
    joined = "".join(words)
    return re.sub(r"sqrt(at\[[^]]*\]|\d+)", r"sqrt(\1)", joined)


class Known(dict[str, float]):
    """Letters; cosines and sines of angles that are known, and of sums of these."""

    def __missing__(self, name: str) -> float:
        index = name[1:].translate(DIGITS)
        if name[0] not in "cs" or not re.fullmatch(r"\d(?:-?\d)*", index):
            raise KeyError(name)
        total = self.get(f"θ{name[1:]}")
        if total is None:
            parts = re.findall(r"-?\d", index)
            total = sum(
                math.copysign(1, int(part)) * self[f"θ{chr(0x2080 + abs(int(part)))}"]
                for part in parts
            )
        return math.cos(total) if name[0] == "c" else math.sin(total)


def worth(text: str, known: Known) -> float:
    names = {"sqrt": math.sqrt, "atan2": math.atan2, "pi": math.pi, "at": known}
    names["sgn"] = lambda x: math.copysign(1.0, x)
    return float(eval(python_of(text), names))  # noqa: S307  our own text


def run(lines: list[str], known: Known) -> Iterator[Known]:
    """All branches that have a solution at a pose without free joints."""
    for place, line in enumerate(lines):
        if line.startswith("for "):
            sign = line.removeprefix("for ").split(" = ")[0]
            for value in (1.0, -1.0):
                yield from run(lines[place + 1 :], Known({**known, sign: value}))
            return
        if line.startswith("if "):
            condition = line.removeprefix("if ").split(": ")[0]
            if ends := re.fullmatch("(.*) ([<>]) (.*)", condition):
                one, other = (worth(side, known) for side in ends.group(1, 3))
                if (one < other) == (ends[2] == "<"):
                    return
            continue
        for each in line.removeprefix("else ").split(",  "):
            name, formula = each.split(" = ", 1)
            known[name] = worth(formula, known)
    yield known


@pytest.mark.parametrize("name", LISTED)
def test_it_gives_the_rows_of_the_program(name: str) -> None:
    of = story(name)
    found = LISTING.search(document(name))
    assert found is not None
    lines = [line.strip() for line in found[1].split("\n")]
    arm = numeric_arm(of.algebra.chain)
    draw = np.random.default_rng(8)
    reach = np.where(of.algebra.chain.turning, 3.0, 0.9 * of.algebra.chain.size)
    for q in draw.uniform(-reach, reach, (3, arm.chain.dof)):
        T, given = arm.pose(q[None]), given_values(arm, q[None])
        rows = interpret(of.program, T, np.zeros((1, arm.chain.dof)), given)
        wanted = rows.q[0][rows.solved[0]]
        known = known_letters(name, T[0], q)
        solutions = [solution(name, each) for each in run(lines, known)]
        reached = [
            each
            for each in solutions
            if np.abs(compared(arm, each) - compared(arm, q)).max() < 1e-6 * arm.chain.size
        ]
        assert len(reached) == len(wanted)
        for row in wanted:
            off = [np.where(arm.chain.turning, turned(each - row), each - row) for each in reached]
            assert min(np.abs(each).max() for each in off) < 1e-6 * max(1.0, arm.chain.size)


def turned(off: np.ndarray) -> np.ndarray:
    return np.remainder(off + np.pi, 2 * np.pi) - np.pi


def compared(arm: object, q: np.ndarray) -> np.ndarray:
    """What the task names of a pose."""
    task = arm.chain.task  # type: ignore[attr-defined]
    T = arm.pose(np.asarray(q)[None])[0]  # type: ignore[attr-defined]
    named = [T[row, 3] for row in task.position_rows]
    if task.directions.name == "ROTATION":
        named += list(T[:3, :3].ravel())
    elif task.directions.name == "POINTING":
        named += list(T[:3, 2])
    return np.array(named)


def known_letters(name: str, T: np.ndarray, q: np.ndarray) -> Known:
    """Lengths, entries of the pose and of U_0, and what the caller gives."""
    from dhgen.derivation.values import letters_at  # noqa: PLC0415

    of = story(name)
    at = letters_at(of, q.tolist(), T)
    given = {f"θ{chr(0x2080 + joint)}" for joint in of.robot.free}
    kept = re.compile(r"[tmpp][₁-₄]{2}$")
    constants = {of.letters[each.name].text for each in of.algebra.chain.constants}
    return Known(
        {
            letter: value
            for letter, value in at.items()
            if kept.match(letter) or letter in constants or letter in given or letter == "ℓ"
        }
    )


def solution(name: str, known: Known) -> np.ndarray:
    """Joint values; those that no line gives are the angles themselves."""
    chain = story(name).algebra.chain
    values = []
    for joint in range(1, chain.dof + 1):
        index = chr(0x2080 + joint)
        places = (f"q{index}", f"θ{index}", f"r{index}")
        values.append(next(known[each] for each in places if each in known))
    return np.array(values)


def test_most_arms_have_it() -> None:
    assert len(LISTED) > 10


def test_its_words_are_in_french_there() -> None:
    """Document 004's algorithm, in its language."""
    found = LISTING.search(document("rrprrr"))
    assert found is not None
    translated = French().block(Drawing(found[1]))
    assert isinstance(translated, Drawing)
    assert "pour ε₁ = 1, −1" in translated.text
    assert "si t₁₄ = t₂₄ = 0 : ε₁ = 1 seul, q₁ la valeur initiale" in translated.text
    assert not re.search(r"\b(?:for|if|else|alone|seed)\b", translated.text)
