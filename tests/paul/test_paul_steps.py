"""What a step says of its letters, at configurations that the search never saw."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from dhgen.kinematics.algebra import AngleSum
from dhgen.paul.kind import Kind
from tests.kinematics.values import number
from tests.paul.arms import all_steps, derivation, random_values
from tests.robots.cases import COUNTS, NAMES

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.paul.step import Step

TWO_VECTORS = {Kind.TWO_ANGLES, Kind.TWO_ANGLES_TURNED, Kind.ANGLE_AND_SUM}


def sides(step: Step, values: Mapping[str, float]) -> list[tuple[float, float]]:
    """The equations of the type's row in the table of document 003, left and right."""
    k = {letter: number(value, values) for letter, value in step.coefficients}
    angle = next((u for u in step.unknowns if isinstance(u, AngleSum)), None)
    length = next((u for u in step.unknowns if not isinstance(u, AngleSum)), None)
    s, c = (values[angle.sine], values[angle.cosine]) if angle else (0.0, 0.0)
    r = values[length.name] if length else 0.0
    match step.kind:
        case Kind.LENGTH:
            return [(k["X"] * r, k["Y"])]
        case Kind.ANGLE:
            return [(k["X"] * s + k["Y"] * c, k["Z"])]
        case Kind.ANGLE_PAIR:
            return [(k["X" + n] * s + k["Y" + n] * c, k["Z" + n]) for n in "12"]
        case Kind.POLAR:
            return [(k["X1"] * r * s, k["Y1"]), (k["X2"] * r * c, k["Y2"])]
        case Kind.ANGLE_AND_LENGTH:
            return [
                (k["X1"] * s, k["Y1"] + k["Z1"] * r),
                (k["X2"] * c, k["Y2"] + k["Z2"] * r),
            ]
        case Kind.SQUARED_LENGTH:
            return [(k["X"] * r * r + k["Y"] * r, k["Z"])]
    # types 6 to 8 are resolved into a type 2 whose right side is |Z|^2 - N, or given as Z
    reach = k["Z1"] ** 2 + k["Z2"] ** 2
    return [(k["X"] * s + k["Y"] * c, k["Z"] if "Z" in k else reach - k["N"])]


@pytest.mark.parametrize("name", NAMES)
def test_letters_mean_what_the_table_of_types_says(name: str) -> None:
    points = random_values(name)
    for step in all_steps(name):
        for values in points:
            for left, right in sides(step, values):
                scale = max(1e-3, abs(left), abs(right), *(v * v for v in values.values()))
                assert abs(left - right) <= 1e-10 * scale, step


@pytest.mark.parametrize("name", NAMES)
def test_rows_are_as_many_as_solutions(name: str) -> None:
    assert derivation(name).branches == COUNTS[name]


@pytest.mark.parametrize("name", NAMES)
def test_roots_belong_to_the_type(name: str) -> None:
    for step in all_steps(name):
        assert step.roots == (1 if step.kind in {Kind.LENGTH, Kind.ANGLE_PAIR} else 2)
        both = step.kind in {Kind.POLAR, Kind.ANGLE_AND_LENGTH}
        assert len(step.unknowns) == (2 if both else 1)


@pytest.mark.parametrize("name", [*NAMES, "adept_cobra600", "scara_ball_screw"])
def test_two_values_of_types_6_to_8_are_two(name: str) -> None:
    """Both are one where Y s - X c, the square root, is zero: at special configurations only."""
    points = random_values(name)
    for step in all_steps(name):
        if step.kind in TWO_VECTORS:
            x, y = step.coefficient("X"), step.coefficient("Y")
            s, c = step.angle.sine, step.angle.cosine
            roots = [number(y, v) * v[s] - number(x, v) * v[c] for v in points]
            assert max(map(abs, roots)) > 1e-6, step
