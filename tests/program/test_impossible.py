"""Programs have no test of an angle that no pose leaves free."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from dhgen.kinematics.build import build_chain
from dhgen.program.ir import Let
from dhgen.program.lowering.lower import lower
from dhgen.robot.load import load
from tests.derived import derived
from tests.serial import ROBOTS

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.program.ir import Program


def program(name: str, folder: Path, right: str, given: str) -> Program:
    """The solver of an arm in robots/ with other lengths."""
    text = (ROBOTS / f"{name}.yaml").read_text(encoding="utf-8")
    assert right in text
    path = folder / f"{name}.yaml"
    path.write_text(text.replace(right, given), encoding="utf-8")
    return lower(derived(build_chain(load(path))))


def truths(solver: Program) -> set[str]:
    return {each.name for each in solver.body if isinstance(each, Let) and each.truth}


# As rounding is to be told from a length, links differ by a thousandth of the arm at least.
@pytest.mark.parametrize(
    ("a2", "free"), [("0.3", False), ("0.4", True), ("0.401", False), ("0.40001", True)]
)
def test_links_of_two_lengths_span_no_point(a2: str, free: bool, tmp_path: Path) -> None:  # noqa: FBT001
    solver = program("planar_rr", tmp_path, "a2: 0.3", f"a2: {a2}")
    assert ("free1" in truths(solver)) == free
    assert bool(solver.free) == free


@pytest.mark.parametrize(("d3", "free"), [("0.15005", False), ("0.001", True)])
def test_an_offset_keeps_the_point_off_the_axis(d3: str, free: bool, tmp_path: Path) -> None:  # noqa: FBT001
    solver = program("puma560", tmp_path, "d3: 0.15005", f"d3: {d3}")
    assert ("free1" in truths(solver)) == free
