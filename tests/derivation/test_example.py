"""The example of a derivation: its numbers are what its formulas say, by another evaluation."""

from __future__ import annotations

import math
import re
from contextlib import suppress
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.derivation.document import singular_places
from dhgen.derivation.example import find_example
from dhgen.derivation.notation.names import cosine, sine, theta
from dhgen.derivation.sections.example import example_section
from dhgen.derivation.sections.shoulder import arm_angle_places
from dhgen.derivation.sections.whole_example import whole_example_section
from dhgen.derivation.singular_example import find_singular
from dhgen.derivation.steps import step_blocks
from dhgen.derivation.text.blocks import Display, Paragraph, Prose, Table
from dhgen.derivation.text.formula import Listing, Relation, Symbol
from dhgen.derivation.values import figures
from dhgen.derivation.whole_example import find_whole_example, hidden_joint
from dhgen.general.kernel import GeneralKernel
from dhgen.oracle.forward import forward, jacobian
from dhgen.paul.kind import Kind
from tests.derivation.stories import EACH, NAMES, document, story
from tests.derivation.test_formulas_hold import relations, with_entries
from tests.derivation.values import Letters, evaluate, letters_of, sign_letter
from tests.structures import first_of

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block

WITHOUT = {"planar_rrrr"}
# Never singular; the condition has no short form in joint angles.
WITHOUT_SINGULAR = {"cartesian", "cuspidal_3r"}
HALF = 0.51e-4  # of the fifth digit, relative


def printed(text: str) -> float:
    """A printed number; an angle in radians."""
    number = float(text.rstrip("°").replace("−", "-"))
    return math.radians(number) if text.endswith("°") else number


ENTRIES = 0  # in the place of a step: what its example says of a matrix that is known


def equations(of: Story) -> dict[int, list[tuple[str, float]]]:
    """What the example says of each step: letters and their values."""
    found: dict[int, list[tuple[str, float]]] = {}
    number: int | None = None
    for block in example_section(of):
        if isinstance(block, Paragraph):
            step = re.match(r"Step (\d+), ", block.prose.text)
            number = int(step[1]) if step else None
            number = ENTRIES if block.prose.text.startswith("Now all of ") else number
        elif isinstance(block, Display) and number is not None:
            for formula in block.formulas:
                for each in formula.items if isinstance(formula, Listing) else (formula,):
                    assert isinstance(each, Relation)
                    name, value = each.sides
                    assert isinstance(name, Symbol)
                    assert isinstance(value, Symbol)
                    found.setdefault(number, []).append((name.text, printed(value.text)))
    return found


def worths(relation: Relation, letters: Letters) -> Iterator[float]:
    """What the sides of an equation are worth, but the first; of unknown letters none."""
    for side in relation.sides[1:]:
        with suppress(KeyError):
            yield float(evaluate(side, letters))


def is_close(shown: float, value: float, unit: float) -> bool:
    return abs(shown - value) <= HALF * abs(value) + 1e-9 * unit


@pytest.mark.parametrize("name", EACH)
def test_numbers_of_steps_are_what_their_formulas_are_worth(name: str) -> None:
    of = story(name)
    example = find_example(of)
    if example is None:
        assert name in WITHOUT
        return
    given = letters_of(of, list(example.q))
    letters = {**with_entries(of, given), "size": of.algebra.chain.size}
    letters["ℓ"] = of.algebra.chain.size
    del letters["Z"], letters["E"]
    row = example.followed
    for place, axis in reversed(list(enumerate(of.program.axes))):
        row, chosen = divmod(row, axis.count)
        letters[sign_letter(of, place)] = 1.0 - 2.0 * chosen
    told = equations(of)
    assert told
    entries = [] if of.known_side is None else [name.text for _, name in of.known_side.entries]
    assert [letter for letter, _ in told.get(ENTRIES, [])] == entries
    for letter, shown in told.get(ENTRIES, []):
        assert is_close(shown, float(letters[letter]), max(1.0, of.algebra.chain.size))
    for number in range(1, len(of.steps) + 1):
        local = dict(letters)
        values: dict[str, list[float]] = {}
        for relation in relations(list(step_blocks(of, number)[0])):
            first = relation.sides[0]
            if isinstance(first, Symbol):
                worth = list(worths(relation, local))
                values.setdefault(first.text, []).extend(worth)
                local |= {first.text: worth[-1]} if worth else {}
        letters |= {key: value for key, value in local.items() if key[0] in "DFGHM"}
        for letter, shown in told.get(number, []):
            size = max(1.0, of.algebra.chain.size) ** 4
            assert any(is_close(shown, value, size) for value in values[letter]), (letter, shown)
            if letter.startswith("θ"):  # the step finds the row's own angle
                off = math.remainder(shown - letters[letter], 2 * math.pi)
                assert abs(off) < 1e-3, (letter, shown)


@pytest.mark.parametrize("name", EACH)
def test_its_rows_reach_its_pose(name: str) -> None:
    of = story(name)
    example = find_example(of)
    if example is None:
        return
    (table,) = (block for block in example_section(of) if isinstance(block, Table))
    solved = np.flatnonzero(~np.isnan(example.rows).any(axis=1))
    assert [int(row[0].text) for row in table.rows] == solved.tolist()
    T = forward(of.robot, example.q)
    size = of.algebra.chain.size
    task = example.rows[solved]
    shown = [[cell.parts[0] for cell in row if cell.parts] for row in table.rows]
    cells = [[printed(each.text) for each in row if isinstance(each, Symbol)] for row in shown]
    assert np.allclose(cells, task, atol=1e-4 * max(1.0, size), rtol=1e-4)
    miss = np.abs(forward(of.robot, task) - T)[:, :3]
    miss[..., 3] /= size
    if of.robot.task.kind.name == "POSE":
        assert miss.max() < 1e-9
    else:
        assert (miss.reshape(len(task), 12).min(axis=1) < 1e-9).all()
    assert example.inside[example.followed]


def test_nothing_depends_on_the_machine() -> None:
    """What is half way between two numbers, but for rounding, is rounded as if exactly."""
    for value in (0.1234565, np.nextafter(0.1234565, 0), np.nextafter(0.1234565, 1)):
        assert figures(float(value)).text == "0.12346"
    assert figures(0.1231850000000001).text == figures(0.123185).text == "0.12318"
    assert figures(-1e-15).text == "0"
    assert figures(240000.0).text == "240000"
    assert figures(123456.7).text == "123460"
    assert figures(-0.5).text == "−0.5"


class Printed(dict[str, float]):
    """Letters, and printed numbers, which stand for themselves."""

    def __missing__(self, text: str) -> float:
        try:
            return printed(text)
        except ValueError:
            raise KeyError(text) from None


def polynomial_blocks(of: Story) -> list[Block]:
    """What the example says of the polynomial of a step."""
    blocks = example_section(of)
    (begin,) = (
        place
        for place, block in enumerate(blocks)
        if isinstance(block, Paragraph) and block.prose.text.startswith("The coefficients of the")
    )
    return blocks[begin : begin + 5]


QUARTICS = [name for name in NAMES if "— type 9" in document(name)]


@pytest.mark.parametrize("name", first_of(QUARTICS))
def test_the_polynomial_is_what_the_printed_equation_is_worth_at_any_angle(name: str) -> None:
    """Its two sides hold P, Q and R, which are letters of the pose and of the angle alone."""
    of = story(name)
    assert of.example is not None
    (number,) = (n for n, s in enumerate(of.steps, start=1) if s.kind is Kind.CIRCLE)
    angle = of.steps[number - 1].angle
    _, coefficients, _, quartic, roots = polynomial_blocks(of)
    assert isinstance(coefficients, Display)
    assert isinstance(quartic, Display)
    assert isinstance(roots, Paragraph)
    found = [each.sides[1] for each in relations([coefficients])]
    l0, l1, m1, l2, m2 = (printed(each.text) for each in found if isinstance(each, Symbol))
    size = max(map(abs, (l0, l1, m1, l2, m2)))
    letters = letters_of(of, list(of.example.q))
    told = relations(list(step_blocks(of, number)[0]))
    equation = [each for each in told if not isinstance(each.sides[0], Symbol)][-1]
    for x in np.linspace(-3.0, 3.0, 9).tolist():
        local = Printed({**letters, cosine(angle).text: math.cos(x), sine(angle).text: math.sin(x)})
        for each in told:
            if isinstance(each.sides[0], Symbol) and each.sides[0].text[0] in "PQRV":
                local[each.sides[0].text] = evaluate(each.sides[1], local)
        left, right = (float(evaluate(side, local)) for side in equation.sides)
        shown = l0 + l1 * math.cos(x) + m1 * math.sin(x)
        shown += l2 * math.cos(2 * x) + m2 * math.sin(2 * x)
        assert left - right == pytest.approx(shown, abs=4e-4 * size)
        (in_tangent,) = relations([quartic])
        worth = float(evaluate(in_tangent.sides[0], Printed({"x": math.tan(x / 2)})))
        assert worth * math.cos(x / 2) ** 4 == pytest.approx(shown, abs=4e-4 * size)
    own = of.example.rows[of.example.followed]
    angles = [each for part in roots.prose.parts for each in angles_in(part)]
    turned = letters_of(of, own.tolist())[theta(angle).text]
    ordinal = ("first", "second", "third", "fourth").index(roots.prose.text.split()[-1].rstrip("."))
    assert math.remainder(angles[ordinal] - turned, 2 * math.pi) == pytest.approx(0.0, abs=1e-3)
    assert angles == sorted(angles)


def angles_in(part: object) -> Iterator[float]:
    """The angles of a sentence's part, by their degree signs."""
    if isinstance(part, Prose):
        for each in part.parts:
            yield from angles_in(each)
    elif isinstance(part, Relation):
        yield from angles_in(part.sides[-1])
    elif isinstance(part, Symbol) and part.text.endswith("°"):
        yield printed(part.text)


GENERAL = [
    "fanuc_crx10ia",
    "general_4r2p",
    "general_5r",
    "general_5r1p_pair",
    "general_6r",
    "xarm7",
]


@pytest.mark.parametrize("name", first_of(GENERAL, count=2))
def test_the_polynomial_of_a_whole_arm_vanishes_where_its_solutions_are(name: str) -> None:
    """Solutions are those that the forward model takes to the pose, whatever found them."""
    of = story(name)
    kernel = of.derivation.whole
    assert isinstance(kernel, GeneralKernel)
    example = find_whole_example(of, kernel)
    assert example is not None
    miss = np.abs(forward(of.robot, example.rows) - example.T)[:, :3]
    miss[..., 3] /= of.algebra.chain.size
    if of.robot.task.kind.name == "POSE":
        assert miss.max() < 1e-9
    blocks = whole_example_section(of, kernel)
    told = [block for block in blocks if isinstance(block, Display)][-1]
    circle = {
        each.sides[0].text: printed(each.sides[1].text)
        for each in relations([told])
        if isinstance(each.sides[0], Symbol) and isinstance(each.sides[1], Symbol)
    }
    values = [
        circle.get(f"λ{'₀₁₂₃₄₅₆₇₈'[m]}", 0.0) - 1j * circle.get(f"μ{'₀₁₂₃₄₅₆₇₈'[m]}", 0.0)
        for m in range(9)
    ]
    places = [block for block in blocks if isinstance(block, Paragraph)]
    (roots,) = (block for block in places if "real roots" in block.prose.text)
    shown = [each for part in roots.prose.parts for each in angles_in(part)]
    assert shown == sorted(shown)
    for root in shown:
        worth = sum(value * np.exp(1j * m * root) for m, value in enumerate(values)).real
        slope = sum(abs(value) * m for m, value in enumerate(values))
        assert abs(worth) < 9e-5 + 1e-4 * slope
    hidden = hidden_joint(kernel)
    if kernel.hides_a_slide or hidden >= kernel.asked:
        return
    letter_ = f"θ{'₀₁₂₃₄₅₆₇'[kernel.numbers[hidden]]}"
    for row in example.rows.tolist():
        own = letters_of(of, row)[letter_]
        assert min(abs(math.remainder(own - root, 2 * math.pi)) for root in shown) < 2e-4


@pytest.mark.parametrize("name", EACH)
def test_the_singular_pose_is_singular_and_its_rows_reach_it(name: str) -> None:
    """By the Jacobian of finite differences, which knows nothing of the steps' conditions."""
    of = story(name)
    places = [*arm_angle_places(of), *singular_places(of)]
    found = None if of.example is None else find_singular(of, of.example, places)
    if found is None:
        assert name in WITHOUT_SINGULAR
        return
    solved = ~np.isnan(found.rows).any(axis=1)
    miss = np.abs(forward(of.robot, found.rows[solved]) - found.T)[:, :3]
    miss[..., 3] /= of.algebra.chain.size
    if of.robot.task.kind.name == "POSE":
        assert miss.max() < 1e-9
    assert found.inside.any()
    if of.algebra.chain.dof == 6 and not of.robot.free:
        assert abs(np.linalg.det(jacobian(of.robot, found.q))) < 1e-9
        assert abs(np.linalg.det(jacobian(of.robot, of.example.q))) > 1e-6  # type: ignore[union-attr]
