"""The same arm written otherwise is solved as well: from its tool, in other units, other frames.

Or with an offset that is next to nothing.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from dhgen.kinematics.build import build_chain
from dhgen.method import Method
from dhgen.paul.derive import derive
from dhgen.paul.kind import Kind
from dhgen.robot.load import load
from tests.structures import first_of

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.paul.derivation import Derivation

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

# a cylindrical arm with a spherical wrist, but the wrist stands on the floor
WRIST_FIRST = """\
  - {theta: q, d: 0.1, a: 0, alpha: pi/2}
  - {theta: q, d: 0, a: 0, alpha: -pi/2}
  - {theta: q, d: 0, a: 0, alpha: 0}
  - {theta: 0, d: q, a: 0, alpha: pi/2}
  - {theta: 0, d: q, a: 0, alpha: 0}
  - {theta: q, d: 0.3, a: 0, alpha: 0}
"""
# four turns on a rail that is last: a whole pose fixes one joint more
RAIL_LAST = """\
  - {alpha: 0, a: 0, theta: q, d: 3}
  - {alpha: pi/2, a: 0, theta: q, d: 0}
  - {alpha: pi/2, a: 0, theta: q, d: 1}
  - {alpha: pi/2, a: 0, theta: q, d: 0}
  - {alpha: 0, a: 0, theta: 0, d: q}
tool: {xyz: [2, 0, 0]}
"""
STANFORD = """\
  - {{theta: q, d: {0}, a: 0, alpha: -pi/2}}
  - {{theta: q, d: {1}, a: 0, alpha: pi/2}}
  - {{theta: -pi/2, d: q, a: 0, alpha: 0, limits: [{2}, {3}]}}
  - {{theta: q, d: 0, a: 0, alpha: -pi/2}}
  - {{theta: q, d: 0, a: 0, alpha: pi/2}}
  - {{theta: q, d: 0, a: 0, alpha: 0}}
"""
# a PUMA whose wrist stands on the floor; axes 5 and 6 meet where y is 0.15
PUMA_FROM_ITS_TOOL = """\
  - {direction: [0, 0, 1], point: [0, 0, 0]}
  - {direction: [0, 1, 0], point: [0, 0, 0]}
  - {direction: [0, 0, 1], point: [0, 0, 0]}
  - {direction: [0, 1, 0], point: [-0.0203, 0, -0.4318]}
  - {direction: [0, 1, 0], point: [-0.4521, 0, -0.4318]}
  - {direction: [0, 0, 1], point: [-0.4521, 0.15005, 0]}
"""
PUMA_TABLE_FROM_ITS_TOOL = """\
  - {theta: q, d: 0, a: 0, alpha: 0}
  - {theta: q, d: 0, a: 0, alpha: pi/2}
  - {theta: q, d: 0.4318, a: 0, alpha: pi/2}
  - {theta: q, d: 0, a: -0.0203, alpha: pi/2}
  - {theta: q, d: 0.15005, a: 0.4318, alpha: 0}
  - {theta: q, d: 0, a: 0, alpha: pi/2}
tool: {xyz: [0, 0, 0.67183]}
"""
# axes 2, 3 and 4 meet at y = 0.3 and z = 0.2, which no point says
SLANTING = """\
  - {{direction: [0, 0, 1], point: [0.1, 0, 0]}}
  - {{direction: [0, 3/5, 4/5], point: [0.4, {0[0]}, {0[1]}]}}
  - {{direction: [0, -4/5, 3/5], point: [0.4, {1[0]}, {1[1]}]}}
  - {{direction: [0, 5/13, 12/13], point: [0.4, {2[0]}, {2[1]}]}}
  - {{direction: [1, 0, 0], point: [0, 0.7, 0.5]}}
  - {{direction: [0, 4/5, 3/5], point: [0.8, 0.1, 0.2]}}
"""
# UR5, calibrated: axes 5 and 6 do not meet
OFFSET_WRIST = """\
  - {{theta: q, d: 0.0892, a: 0, alpha: pi/2}}
  - {{theta: q, d: 0, a: -0.425, alpha: 0}}
  - {{theta: q, d: 0, a: -0.39225, alpha: 0}}
  - {{theta: q, d: 0.10915, a: 0, alpha: pi/2}}
  - {{theta: q, d: 0.09465, a: {0}, alpha: -pi/2}}
  - {{theta: q, d: 0.0823, a: 0, alpha: 0}}
"""
MODIFIED = "convention: modified\njoints"


def derived(folder: Path, rows: str, key: str = "joints") -> Derivation:
    path = folder / "arm.yaml"
    path.write_text(f"name: arm\n{key}:\n{rows}", encoding="utf-8")
    return derive(build_chain(load(path)))


def turning(rows: str) -> str:
    return rows.replace("{direction", "{type: revolute, direction")


def test_a_wrist_before_two_slides_needs_square_roots_only(tmp_path: Path) -> None:
    derivation = derived(tmp_path, WRIST_FIRST)
    assert derivation.method is Method.CLOSED_FORM
    assert derivation.branches == 4


def test_a_rail_is_found_as_well_at_the_tool_as_at_the_base(tmp_path: Path) -> None:
    assert derived(tmp_path, RAIL_LAST, MODIFIED).branches == 2


def test_a_puma_seen_from_its_tool_has_eight_rows(tmp_path: Path) -> None:
    assert derived(tmp_path, turning(PUMA_FROM_ITS_TOOL), "axes").branches == 8


@pytest.mark.breadth
def test_angles_are_not_read_from_20_mm_where_directions_tell_them(tmp_path: Path) -> None:
    derivation = derived(tmp_path, PUMA_TABLE_FROM_ITS_TOOL, MODIFIED)
    pairs = [step for step in derivation.steps if step.kind is Kind.ANGLE_PAIR]
    assert len(pairs) == 3
    for step in pairs:
        factors = {str(step.coefficient(letter)) for letter in ("X1", "Y1", "X2", "Y2")}
        assert not factors & {"a4", "-a4"}, step.unknowns


@pytest.mark.parametrize("unit", first_of([1e6, 1e-3, 1.0, 1e3], count=2))
def test_the_unit_of_lengths_changes_nothing(tmp_path: Path, unit: float) -> None:
    lengths = [unit * length for length in (0.4, 0.15, 0.3, 1.2)]
    assert derived(tmp_path, STANFORD.format(*lengths)).branches == 8


@pytest.mark.breadth
def test_axes_that_meet_aside_of_their_points_are_concurrent(tmp_path: Path) -> None:
    """They do so wherever along them the file's points are."""
    points = [(0.3 + y, 0.2 + z) for y, z in ((0.3, 0.4), (-0.8, 0.6), (1.0, 2.4))]
    rows = turning(SLANTING.format(*points))
    assert derived(tmp_path, rows, "axes").method is Method.QUARTIC


@pytest.mark.parametrize(
    ("offset", "method"),
    first_of(
        [
            (0.0, Method.CLOSED_FORM),
            (1e-6, Method.GENERAL_6R),
            (1e-7, Method.GENERAL_6R),
            (1e-3, Method.QUARTIC),
        ],
        count=2,
    ),
)
def test_a_quartic_whose_roots_meet_is_left_to_the_general_algorithm(
    tmp_path: Path, offset: float, method: Method
) -> None:
    """With an offset of 1e-7 in the wrist it lost one row in ten."""
    assert derived(tmp_path, OFFSET_WRIST.format(offset)).method is method
