"""Platforms that can move while their drives are held: their poses are a continuum."""

from __future__ import annotations

import os
import subprocess
import sys
from typing import TYPE_CHECKING

import numpy as np
import pytest

from tests.parallel.made import native, python
from tests.structures import quick_first

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

CRANKS = 0.3, 0.25
FEET = -0.1, 0.2


def meeting(radius: float) -> tuple[float, float]:
    """The cranks of the unequal five-bar with their ends at one point above the base."""
    angles = []
    for foot, crank, other in zip(FEET, CRANKS, CRANKS[::-1], strict=True):
        apart = FEET[1] - FEET[0]
        along = (apart**2 + crank**2 - other**2) / (2.0 * apart) * (1 if foot < 0 else -1)
        angles.append(float(np.arctan2(np.sqrt(crank**2 - along**2), along)))
    return angles[0] + radius, angles[1]


@pytest.mark.parametrize(
    ("name", "drives", "status", "told"),
    [
        ("equal_platform", (0.4, 0.4, 0.4), "FREE_JOINT", "can move while its drives are held"),
        ("equal_platform", (0.9, 0.9, 0.9), "FREE_JOINT", "can move while its drives are held"),
        ("one_rail", (0.1, 0.1, 0.1), "FREE_JOINT", "can move while its drives are held"),
        ("one_rail", (0.1, 0.1, 0.4), "FREE_JOINT", "can move while its drives are held"),
        ("one_rail", (0.1, 0.4, 0.1), "FREE_JOINT", "can move while its drives are held"),
        ("one_rail", (0.4, 0.1, 0.1), "FREE_JOINT", "can move while its drives are held"),
        ("equal_platform", (0.4, np.nan, 0.4), "INVALID_POSE", "not finite"),
        ("parallel_3rpr", (np.inf, 1.0, 1.0), "INVALID_POSE", "not finite"),
        ("delta", (0.1, 0.1, -np.inf), "INVALID_POSE", "not finite"),
    ],
)
def test_a_continuum_is_told(name: str, drives: Sequence[float], status: str, told: str) -> None:
    with pytest.raises(ValueError, match=told):
        python(name).assemblies(drives)
    with pytest.raises(ValueError, match=status):
        native(name).assemblies(np.array(drives))


@pytest.mark.slow
def test_a_platform_on_equal_cranks_goes_around_in_both_languages() -> None:
    """At every place on the circle the direct model says that other poses meet that one."""
    for angle in (0.3, 2.0, 4.4):
        T = np.eye(4)
        T[:2, 3] = 0.4 * np.array([np.cos(angle), np.sin(angle)])
        told, found, _ = native("equal_platform").fk(np.full(3, 0.4), T)
        pose, _, status = python("equal_platform").fk(np.full(3, 0.4), T)
        assert told == status == 2
        np.testing.assert_allclose(found, T, rtol=0, atol=1e-9)
        np.testing.assert_allclose(pose, T, rtol=0, atol=1e-9)


@pytest.mark.parametrize("longer", [1e-5, 1e-4, 1e-2, 0.1])
def test_beside_a_continuum_there_are_few(longer: float) -> None:
    """Two cylinders of one length, a third that is longer."""
    drives = np.array([0.4, 0.4, 0.4 + longer])
    found, others = (each("equal_platform").assemblies(drives) for each in (native, python))
    assert len(found) == len(others) >= 2
    np.testing.assert_allclose(found, others, rtol=0, atol=1e-6)
    feet = 0.3 * np.array([[np.cos(a), np.sin(a)] for a in np.radians([0, 120, 240])])
    for T in found:
        lengths = np.linalg.norm(feet @ T[:2, :2].T + T[:2, 3] - feet, axis=1)
        np.testing.assert_allclose(lengths, drives, rtol=0, atol=1e-11)


def test_cranks_that_end_at_one_point() -> None:
    """Rods of two lengths meet nowhere then."""
    drives = np.array(meeting(0.0))
    ends = [
        [foot + crank * np.cos(q), crank * np.sin(q)]
        for foot, crank, q in zip(FEET, CRANKS, drives, strict=True)
    ]
    np.testing.assert_allclose(ends[0], ends[1], rtol=0, atol=1e-15)
    assert len(native("unequal_five_bar").assemblies(drives)) == 0
    assert len(python("unequal_five_bar").assemblies(drives)) == 0


@pytest.mark.parametrize("size", quick_first([1e-5, 1e-3]))
def test_nearly_equal_cranks_hide_none(size: float) -> None:
    """Four roots lie near one angle, and have a fourth of the digits: an even number is found."""
    source = np.random.default_rng(2)
    for _ in range(12):
        drives = source.choice([0.3, 0.4, 0.9]) + size * source.normal(size=3)
        found, others = (each("equal_platform").assemblies(drives) for each in (native, python))
        assert len(found) == len(others)
        assert len(found) in {2, 4}
        np.testing.assert_allclose(found, others, rtol=0, atol=1e-6)


@pytest.mark.parametrize(
    ("drives", "heights"),
    [((0.1, 0.2, 0.4), []), ((-0.6, -0.6, 0.6), []), ((-0.5, -0.5, 0.5), [0.0])],
)
def test_spheres_in_a_line(drives: Sequence[float], heights: Sequence[float]) -> None:
    """They meet nowhere, or touch between their centres."""
    for robot in (native("one_rail"), python("one_rail")):
        found = robot.assemblies(np.array(drives))
        assert len(found) == len(heights)
        for T, z in zip(found, heights, strict=True):
            np.testing.assert_allclose(T[:3, 3], [0.0, 0.0, z], rtol=0, atol=1e-12)


FREE_POINTS = """\
name: one_point
legs:
  - base: {xyz: [0.5, 0, 0]}
    joints: [{theta: q, alpha: 90 deg}, {d: q, limits: [0.05, 2]}]
    actuated: [2]
    point: [0, 0, 0]
    turned: [0, 120 deg, 240 deg]
task: [x, y, yaw]
"""


@pytest.mark.slow
def test_a_platform_that_drives_never_hold_is_refused(tmp_path: Path) -> None:
    """Its three cylinders carry one point: nothing keeps its yaw, whatever the count says."""
    path = tmp_path / "one_point.yaml"
    path.write_text(FREE_POINTS, encoding="utf-8")
    plain = {**os.environ, "NUMBA_DISABLE_JIT": "1"}
    command = [sys.executable, "-m", "dhgen", str(path), "--out", str(tmp_path / "out")]
    done = subprocess.run(command, capture_output=True, text=True, check=False, env=plain)
    assert done.returncode != 0
    assert "at all 60 poses the platform can move while its drives are held" in done.stderr
    assert not (tmp_path / "out").exists()


def test_a_robot_without_an_elimination_says_so() -> None:
    assert python("stewart").ASSEMBLIES == 0
    with pytest.raises(NotImplementedError, match="is not known of this robot: `fk` finds the one"):
        python("stewart").assemblies(np.full(6, 0.5))
