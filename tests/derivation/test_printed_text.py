"""What the three handouts print is true, and the French one: their text alone is read.

Equations before the steps hold at random joint values, those of the steps at the example's; the
steps, done with a pose alone and all signs, give all its solutions; and the example's numbers are
what its formulas are worth. What has letters of which the text alone says the value is left out.
"""

from __future__ import annotations

import math
import re
from functools import cache
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from dhgen.derivation.formats import derivation_as
from dhgen.derivation.french.language import French
from dhgen.oracle.arm_angle import given_values
from dhgen.oracle.forward import forward, jacobian
from dhgen.oracle.problem import task_entries
from dhgen.program.interpret import interpret
from dhgen.robot.robot import JointKind
from tests.derivation.reading import (
    MINUS,
    PLUS,
    Nodes,
    name_of,
    of_latex,
    relations_in,
    worth,
)
from tests.derivation.reading_mathml import elements, of_mathml
from tests.derivation.stories import document, story
from tests.derivation.values import letters_of
from tests.structures import first_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.arrays import FloatArray
    from dhgen.derivation.story import Story

FORMATS = ("markdown", "latex", "html", "french markdown", "french latex", "french html")
# A slide, wrists of two kinds, parallel axes, five joints, seven with one given, a task of entries.
ARMS = ["scara", "kuka_kr6_r900", "ur5", "rrprrr", "stanford", "franka_panda", "xarm5", "planar_pr"]
KEPT = "DFGHMθε"  # how letters begin that later steps use
DEFINES = (
    *("This is", "These are", "The determinant"),
    *("Cette équation s’écrit", "Ces équations s’écrivent", "Le déterminant"),
)
# What the pose gives to a step stands before it.
INTRODUCES = ("By now all of", "New elements in step", "À ce stade", "Éléments nouveaux à l’étape")
IN_FRENCH = {
    "Forward": "Modèle géométrique direct",
    "Inverse": "Modèle géométrique inverse",
    "An example": "Exemple",
    "Step": "Étape",
    "The joint values.": "Les valeurs articulaires.",
}
# Names and separators as the reader knows them; decimal commas it reads itself.
NOTATION = (
    (r"\{\}\^(\d)([TR]_(?:\{[^{}]*\}|\w))", r"\2^\1"),
    ("base,outil", "base,tool"),
    (r" \\thinspace ;(?=\\quad )", ","),
)
HALF = 0.51e-4  # of the fifth digit
SUBSCRIPTS = str.maketrans("₀₁₂₃₄₅₆₇₈₉₋⁰", "0123456789-0")

Piece = tuple[str, Any]  # ("step", 4), ("heading", "An example"), ("formula", nodes), ("text", ...)


def pieces(name: str, wished: str) -> list[Piece]:
    """A handout's headings, beginnings of steps, texts and formulas, in order."""
    if wished == "markdown":
        return list(_of_markdown(document(name)))
    *language, form = wished.split()
    if not language:
        text, _ = derivation_as(form, story(name), name)
        return list(_of_latex(text) if form == "latex" else _of_html(text))
    text, _ = derivation_as(form, story(name), name, French())
    if form == "html":
        return [_english(piece) for piece in _of_html(text)]
    for french, english in NOTATION:
        text = re.sub(french, english, text)
    return list(_of_markdown(text) if form == "markdown" else _of_latex(text))


def _english(piece: Piece) -> Piece:
    """A French formula of MathML as English ones are read."""
    kind, value = piece
    return (kind, _in_place(value)) if kind == "formula" else piece


def _in_place(node: Any) -> Any:
    match node:
        case ("op" | "id", ";"):
            return ("op", ",")
        case ("id", "base,outil"):
            return ("id", "base,tool")
        case [("sup", ("id", ""), index), matrix, *others]:  # {}^0T_3
            return [("sup", matrix, index), *_in_place(others)]
        case [first, *others] if isinstance(node, list):
            return [_in_place(first), *_in_place(others)]
        case tuple():
            return tuple(_in_place(each) for each in node)
        case _:
            return node


def _of_markdown(text: str) -> Iterator[Piece]:
    text = re.sub(r"</?(?:details|summary)>", "", text)
    for block in re.split(r"\n\n", text):
        if shown := re.fullmatch(r"\s*```math\n(.*?)\n```\s*", block, re.DOTALL):
            yield from _lines(shown[1])
        elif block.startswith("#"):
            yield "heading", block.lstrip("# ").split("\n")[0]
        elif not block.startswith(("|", "```", "!", "<")):
            yield from _paragraph(block.strip(), r"\*\*(\d+)\. ", r"\$`(.+?)`\$|\$([^$`\n]+)\$")


def _of_latex(text: str) -> Iterator[Piece]:
    for block in re.split(r"\n\n", text.partition(r"\begin{document}")[2]):
        if shown := re.search(r"^\\formulas\{%\n(.*)\}$", block, re.DOTALL | re.MULTILINE):
            yield from _lines(shown[1])
        elif heading := re.match(r"\\(?:sub)*section\*?\{(.*)\}", block):
            yield "heading", heading[1]
        else:
            yield from _paragraph(block.strip(), r"\\textbf\{(\d+)\. ", r"\$([^$\n]+)\$()")


def _paragraph(text: str, step: str, formula: str) -> Iterator[Piece]:
    if begun := re.match(step, text):
        yield "step", int(begun[1])
    yield "text", text
    if text.startswith(DEFINES):
        for found in re.finditer(formula, text):
            yield "formula", of_latex(found[1] or found[2])


def _lines(shown: str) -> Iterator[Piece]:
    """The formulas of a display; what a line continues belongs to the one above."""
    body = re.sub(r"\\(?:begin|end)\{aligned\}", "", shown).strip()
    whole: list[str] = []
    for line in re.split(r"\\\\\s*\n", body):
        continues = re.match(r"\s*&\s*(?:\\quad\s*[-+]|[=<>])", line)
        bare = re.sub(r"(?<!\\)&", " ", line) if "matrix}" not in line else line
        if continues and whole:
            whole[-1] += " " + bare.replace(r"\quad", "", 1)
        elif continues:  # what was too much for a page
            yield "rest", of_latex(_without_alignment(bare.replace(r"\quad", "", 1)))
        else:
            whole.append(bare)
    for each in whole:
        yield "formula", of_latex(_without_alignment(each))


def _without_alignment(line: str) -> str:
    """Only matrices have columns."""
    parts = re.split(r"(\\begin\{bmatrix\}.*?\\end\{bmatrix\})", line, flags=re.DOTALL)
    return "".join(p if place % 2 else p.replace("&", " ") for place, p in enumerate(parts))


def _of_html(text: str) -> Iterator[Piece]:
    for element in elements(text).iter():
        if re.fullmatch("h[1-6]", element.tag):
            yield "heading", "".join(element.itertext()).strip()
        elif element.tag == "math" and element.get("display"):
            (table,) = element
            nodes: Nodes = []
            for row in table:
                line = of_mathml(row)
                if nodes and not _continues(line):
                    yield "formula", nodes
                    nodes = []
                nodes = nodes + [n for n in line if n != ("space",) or not _continues(line)]
            yield "formula", nodes
        elif element.tag == "p":
            said = "".join(element.itertext()).strip()
            if begun := re.match(r"(\d+)\. ", said):
                yield "step", int(begun[1])
            yield "text", said
            if said.startswith(DEFINES):
                yield from (("formula", of_mathml(each)) for each in element.iter("math"))


def _continues(line: Nodes) -> bool:
    """Whether a line goes on with what stands above it."""
    first = [node for node in line if node != ("space",)][:1]
    begins = line[:1] == [("space",)] and first and first[0] in (PLUS, MINUS)
    return bool(begins) or (bool(first) and first[0][0] == "op" and first[0][1] in "=<>")


@cache
def read(name: str, wished: str) -> list[Piece]:
    """The pieces, once, each formula in one."""
    found: list[Piece] = []
    for kind, value in pieces(name, wished):
        if kind == "rest":
            found[-1] = "formula", found[-1][1] + value
        else:
            found.append((kind, value))
    return found


def words_for(english: str, wished: str) -> str:
    """What a handout says for some English words."""
    return IN_FRENCH[english] if wished.startswith("french") else english


def section(name: str, wished: str, title: str) -> list[Piece]:
    """What stands under a heading."""
    found, inside = [], False
    for kind, value in read(name, wished):
        if kind == "heading":
            inside = value == words_for(title, wished)
        elif inside:
            found.append((kind, value))
    assert found, title
    return found


class Letters:
    """What letters are worth; cosines and sines of angles also where the angles follow."""

    def __init__(self, values: dict[str, Any], joints: int) -> None:
        self.values = values
        self.joints = joints

    def __call__(self, name: str) -> Any:
        if name in self.values:
            return self.values[name]
        letter, _, index = name.partition("_")
        if letter not in {"c", "s", "θ"} or not re.fullmatch(r"[\d-]+", index):
            raise KeyError(name)
        angle = self._angle(index)
        return {"c": math.cos, "s": math.sin, "θ": float}[letter](angle)

    def _angle(self, index: str) -> float:
        """A sum of angles by those that are known."""
        known = [key for key in self.values if re.fullmatch(r"θ_[\d-]+", key)]
        if not known:
            raise KeyError(index)
        rows = np.array([self._terms(key[2:]) for key in known])
        weights, *_ = np.linalg.lstsq(rows.T, self._terms(index), rcond=None)
        if np.abs(rows.T @ weights - self._terms(index)).max() > 1e-9:
            raise KeyError(index)
        return float(weights @ [self.values[key] for key in known])

    def _terms(self, index: str) -> FloatArray:
        """12-4: theta_1 + theta_2 - theta_4."""
        terms = np.zeros(self.joints)
        for sign, joint in re.findall(r"(-?)(\d)", index):
            terms[int(joint) - 1] = -1.0 if sign else 1.0
        return terms


def plain(values: dict[str, Any]) -> dict[str, Any]:
    """The letters of a configuration by names as they are read: c₁₂ is c_12."""
    found = {}
    for key, value in values.items():
        index = re.sub(r"([₀-₉₋]+)", lambda m: "_" + m[1].translate(SUBSCRIPTS), key, count=1)
        found[index.replace("⁰", "^0").translate(SUBSCRIPTS)] = value
    return found


def constants_of(of: Story, values: dict[str, Any]) -> dict[str, Any]:
    """What is known before a pose is: lengths, twists, what the caller gives."""
    moving = {"c", "s", "θ", "t", "p", "T", "A", "U", "POS", "q", "r", "w", "B", "b", "Z", "E"}
    own = {name: v for name, v in values.items() if name.partition("_")[0] not in moving}
    lengths = plain({of.letters[c.name].text: c.value for c in of.algebra.chain.constants})
    own |= {each.name: each.value for each in of.robot.parameters}
    return {**own, **lengths, "ℓ": of.algebra.chain.size}


def holds(sides: list[Any], size: float, *, turn: bool) -> bool:
    off = np.asarray(sides[:-1]) - np.asarray(sides[-1])
    off = np.remainder(off + math.pi, 2.0 * math.pi) - math.pi if turn else off
    return bool(np.max(np.abs(off)) < 1e-9 * max(1.0, size) ** 4)


def define(nodes: Nodes, letters: Letters, size: float, *, checked: bool) -> int:
    """Learns what equations define; how many had two sides with a value, which are equal."""
    equalities = 0
    for sides, signs in relations_in(nodes):
        if set(signs) != {"="}:
            continue
        found = []
        for side in sides:
            try:
                found.append(worth(side, letters))
            except KeyError:
                continue
        name = name_of(sides[0])
        if checked and len(found) > 1:
            assert holds(found, size, turn=name is not None and name[0] in "θq"), (sides, found)
            equalities += 1
        if name is not None and found:
            letters.values.setdefault(name, found[-1])
    return equalities


def at(of: Story, seed: int) -> tuple[FloatArray, FloatArray, dict[str, Any]]:
    """Joint values, their pose, and what all letters are worth there."""
    source, chain = np.random.default_rng(seed), of.algebra.chain
    q = source.uniform(-3.0, 3.0, chain.dof)
    slides = [joint.kind is JointKind.PRISMATIC for joint in of.robot.joints]
    q[slides] = source.uniform(0.2, 2.0, sum(slides)) * chain.size
    return q, np.asarray(forward(of.robot, q), dtype=float), plain(letters_of(of, list(q)))


@pytest.mark.parametrize("wished", FORMATS)
@pytest.mark.parametrize("name", first_of(ARMS, count=4))
def test_every_equation_before_the_steps_holds(name: str, wished: str) -> None:
    of = story(name)
    for seed in range(2):
        q, T, values = at(of, seed)
        letters = Letters({**values, "POS": T, "J": jacobian(of.robot, q)}, of.dof)
        equalities = 0
        for title in ("Forward", "Inverse"):
            for kind, value in section(name, wished, title):
                if kind == "step":
                    break
                if kind == "formula":
                    equalities += define(value, letters, of.algebra.chain.size, checked=True)
        assert equalities >= 4 * of.dof


def steps_of(name: str, wished: str) -> list[list[Nodes]]:
    """The formulas of every step, and last those of the joint values."""
    steps: list[list[Nodes]] = []
    last: list[Nodes] = []
    introduced = False
    for kind, value in section(name, wished, "Inverse"):
        if kind == "step":
            steps.append([])
            introduced = False
        elif kind == "text" and value.startswith(INTRODUCES):
            introduced = True
        elif kind == "text" and words_for("The joint values.", wished) in value[:40]:
            steps.append(last)
        elif kind == "formula" and steps and not introduced:
            steps[-1].append(value)
    return steps if last in steps[-1:] else [*steps, last]


def beginning_of(name: str, wished: str) -> list[Nodes]:
    """The formulas before the first step, and what comes in with steps."""
    found, introduced = [], True
    for kind, value in section(name, wished, "Inverse"):
        if kind == "step":
            introduced = False
        elif kind == "text" and value.startswith(INTRODUCES):
            introduced = True
        elif kind == "formula" and introduced:
            found.append(value)
    return found


def done(
    of: Story, name: str, wished: str, known: dict[str, Any], *, checked: bool = False
) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    """Does the steps with the signs in `known`; all letters, and those of each step."""
    letters = Letters(dict(known), of.dof)
    size = of.algebra.chain.size
    told = []
    *steps, last = steps_of(name, wished)
    assert len(steps) == len(of.steps)
    for step in steps:
        for nodes in beginning_of(name, wished):  # what the angles that are known now give
            define(nodes, letters, size, checked=False)
        local = Letters(dict(letters.values), of.dof)
        for nodes in step:
            define(nodes, local, size, checked=checked)
        told.append(local.values)
        kept = {n: v for n, v in local.values.items() if n[0] in KEPT or n in _lengths(of)}
        letters.values |= kept
    for nodes in last:
        define(nodes, letters, size, checked=False)
    return letters.values, told


def _lengths(of: Story) -> set[str]:
    return set(plain({of.letters[name].text: 0.0 for name in of.algebra.slides.values()}))


def signs_of(of: Story) -> list[str]:
    return list(plain({of.sign(axis).text: 0.0 for axis in of.program.axes}))


def joint_vector(of: Story, values: dict[str, Any]) -> FloatArray:
    """q_i, or theta_i where the text says no more."""
    letters = Letters(values, of.dof)
    found = []
    for joint in range(1, of.dof + 1):
        own = f"q_{joint}"
        found.append(values[own] if own in values else letters(f"θ_{joint}"))
    return np.array(found, dtype=float)


@pytest.mark.parametrize("wished", FORMATS)
@pytest.mark.parametrize("name", first_of(ARMS, count=4))
def test_the_steps_give_all_solutions_of_a_pose(name: str, wished: str) -> None:
    of = story(name)
    q, T, values = at(of, 5)
    given = given_values(of.robot, q)
    rows = interpret(of.program, T[None], None, given).q[0]
    rows = rows[~np.isnan(rows).any(axis=1)]
    pose = {key: v for key, v in values.items() if re.fullmatch(r"[tp]_\d\d|w\d?_\d?[xyz]", key)}
    known = {**constants_of(of, values), **pose}
    for joint in of.robot.free:
        known |= {f"q_{joint}": q[joint - 1], f"θ_{joint}": values[f"θ_{joint}"]}
    task = task_entries(of.robot.task).reshape(3, 4)
    found = []
    for chosen in product((1.0, -1.0), repeat=len(signs_of(of))):
        signs = dict(zip(signs_of(of), chosen, strict=True))
        row = joint_vector(of, done(of, name, wished, {**known, **signs})[0])
        miss = np.abs(np.asarray(forward(of.robot, row)) - T)[:3][task]
        if miss.max() < 1e-9 * max(1.0, of.algebra.chain.size):
            found.append(row)
    turning = [joint.kind is JointKind.REVOLUTE for joint in of.robot.joints]
    for row in rows:
        off = np.abs(np.array(found) - row)
        off[:, turning] = np.abs(np.remainder(off[:, turning] + math.pi, 2 * math.pi) - math.pi)
        assert off.max(axis=1).min() < 1e-6
    assert len(found) == len(rows)


@pytest.mark.parametrize("wished", FORMATS)
@pytest.mark.parametrize("name", first_of(ARMS, count=4))
def test_numbers_of_the_example_follow_from_the_formulas(name: str, wished: str) -> None:
    of = story(name)
    example = of.example
    assert example is not None
    values = plain(letters_of(of, list(example.q)))
    pose = {key: v for key, v in values.items() if re.fullmatch(r"[tp]_\d\d|w\d?_\d?[xyz]", key)}
    known = {**constants_of(of, values), **pose}
    for joint in of.robot.free:
        known[f"θ_{joint}"] = values[f"θ_{joint}"]
    row, signs = example.followed, {}
    for place, axis in reversed(list(enumerate(of.program.axes))):
        row, chosen = divmod(row, axis.count)
        signs[signs_of(of)[place]] = 1.0 - 2.0 * chosen
    _, told = done(of, name, wished, {**known, **signs}, checked=True)
    every = {key: value for key, value in values.items() if key not in {"Z", "E"}}
    every |= {f"R_{of.dof}^{m}": values[f"U_{m}"][:3, :3] for m in range(of.dof)}
    equalities = 0
    for formulas, found in zip(steps_of(name, wished), told, strict=False):
        for nodes in formulas:  # with all angles known, what a step begins with can be checked, too
            letters = Letters({**every, **found}, of.dof)
            equalities += define(nodes, letters, of.algebra.chain.size, checked=True)
    assert equalities >= 2 * len(of.steps)
    number, compared = 0, 0
    for kind, value in section(name, wished, "An example"):
        if kind == "text":
            step = re.match(rf"{words_for('Step', wished)} (\d+), ", value)
            number = int(step[1]) if step else 0
        elif kind == "formula" and number:
            for (left, right), _ in relations_in(value):
                letter, shown = name_of(left), float(worth(right, Letters({}, of.dof)))
                expected = float(Letters(told[number - 1], of.dof)(str(letter)))
                off = shown - expected
                if letter is not None and letter[0] == "θ":
                    off = math.remainder(off, 2.0 * math.pi)
                unit = max(1.0, of.algebra.chain.size) ** 4
                assert abs(off) <= HALF * abs(expected) + 1e-9 * unit, (letter, shown, expected)
                compared += 1
    assert compared >= 2 * len(of.steps)
