"""Rows of examples are those that the generated solver returns, with its names."""

from __future__ import annotations

import re

import numpy as np
import pytest

from dhgen.runtime.python.status import OUT_OF_LIMITS, UNREACHABLE
from tests.derivation.stories import ALL_WHOLE, document
from tests.targets.made import in_python

BY_POSTURE = [name for name in ALL_WHOLE if "in rows by posture" in document(name)]
DIGITS = 6e-5  # five digits of numbers below half a turn in degrees, relative; and near zero


def example_of(name: str) -> str:
    return document(name).partition("## An example\n")[2].partition("\n## ")[0]


def printed_rows(text: str) -> dict[int, tuple[str, list[float], bool]]:
    """Names, angles in degrees, and whether limits are exceeded, by row."""
    lines = [line.strip("| ").split(" | ") for line in re.findall(r"^\| \d.*", text, re.MULTILINE)]
    return {int(row): (label, *_read(cells)) for row, label, *cells in lines}


def _read(cells: list[str]) -> tuple[list[float], bool]:
    angles = [cell.strip("$").removesuffix(r"^\circ") for cell in cells if cell[0] == "$"]
    return [float(each) for each in angles], "exceeded" in cells


def test_there_are_arms_with_rows_by_posture() -> None:
    assert {"kuka_kr6_r900_calibrated", "puma560_calibrated"} <= set(BY_POSTURE)


@pytest.mark.parametrize("name", BY_POSTURE)
def test_rows_by_posture_are_those_of_the_solver(name: str) -> None:
    """The pose is that of the joint values that the text begins with, which are round numbers."""
    text, module = example_of(name), in_python(name)
    values = text.partition(" the tool is at")[0]
    q = np.radians([float(each) for each in re.findall(r"q_\d = (-?[\d.]+)\^", values)])
    free = [number - 1 for number in getattr(module, "FREE_JOINTS", ())]
    given = [q[free]] if free else []
    rows, status = module.ik_all(module.fk(q), *given)
    shown = printed_rows(text)
    assert sorted(shown) == np.flatnonzero(np.asarray(status) != UNREACHABLE).tolist()
    for row, (label, angles, exceeded) in shown.items():
        assert label == module.BRANCHES[row]
        assert exceeded == (status[row] == OUT_OF_LIMITS)
        assert angles == pytest.approx(np.degrees(rows[row]), rel=DIGITS, abs=DIGITS)
    (followed,) = re.findall(r"^Row (\d+), ([^ ,]+), comes from", text, re.MULTILINE)
    label, angles, exceeded = shown[int(followed[0])]
    assert label == followed[1]
    assert angles == pytest.approx(np.degrees(q))
    assert not exceeded


@pytest.mark.parametrize("name", BY_POSTURE)
def test_names_of_all_rows_are_listed(name: str) -> None:
    names = in_python(name).BRANCHES
    count = next(row for row, each in enumerate(names) if each.startswith("further"))
    assert (
        f"\nThe names of rows 0 to {count - 1} are {', '.join(names[:count])}. Rows {count} to "
        f"{len(names) - 1}, {names[count]} to {names[-1]}, are for further solutions.\n"
    ) in document(name)
    assert "Rows are ordered by the value of joint 1" not in document(name)
