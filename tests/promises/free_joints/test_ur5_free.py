"""UR5 at s5 = 0: q6 is free, but not every q6 leads to a solution.

Where the seed's value does not serve, the nearest one that does is taken. What serves is told here
by the arm's geometry: with q6 given, frame 4 is known, and its origin has to lie between the
shortest and the longest reach of links 2 and 3, seen along axis 2.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.poses import random_joints
from tests.robots.cases import dh, lengths
from tests.structures import first_of
from tests.targets.calling import FREE_JOINT, HELD, LANGUAGES, Solver, gap
from tests.targets.made import poses_of, residual, robot

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

COUNT = {"C": 1000, "Python": 25}  # plain Python is slow: 64 and more solves a row
GRID = np.linspace(-np.pi, np.pi, 4097)
SLACK = 1e-9  # of the square of reach: nearer to its bounds rounding may decide


def singular(count: int) -> FloatArray:
    """Joint vectors with q5 = 0 or pi, half of them stretched or folded too, or nearly."""
    source = np.random.default_rng(41)
    q = random_joints(robot("ur5"), count, seed=41)
    q[:, 4] = source.choice([0.0, np.pi], count)
    straight = source.choice([0.0, 1e-6, 1e-3, np.pi], count)
    q[:, 2] = np.where(source.random(count) < 0.5, q[:, 2], straight)
    return q


def margins(T: FloatArray, q1: float, q5: float, q6: FloatArray) -> FloatArray:
    """How far the square of reach lies inside its bounds, for each q6; negative outside."""
    p = lengths("ur5")
    x, y, z, _ = np.linalg.inv(dh(q5, p["d5"], 0.0, -90.0))[:, 3]
    c, s = np.cos(q6), np.sin(q6)
    in_6 = np.stack([c * x + s * y, c * y - s * x, np.full(len(q6), z - p["d6"]), np.ones(len(q6))])
    in_1 = np.linalg.inv(dh(q1, p["d1"], 0.0, 90.0)) @ T @ in_6
    reach = in_1[0] ** 2 + in_1[1] ** 2
    longest, shortest = (abs(p["a2"]) + abs(p["a3"])) ** 2, (abs(p["a2"]) - abs(p["a3"])) ** 2
    return np.asarray(np.minimum(longest - reach, reach - shortest))


def nearest_move(T: FloatArray, q1: float, q5: float, seed: float) -> float:
    """The smallest move of q6 from the seed's value that serves, inf where the grid shows none."""
    served = GRID[margins(T, q1, q5, seed + GRID) >= 0.0]
    if not len(served):
        return np.inf
    outer = served[np.argmin(np.abs(served))]
    inner = outer - np.sign(outer) * (GRID[1] - GRID[0])
    if outer == 0.0:
        return 0.0
    for _ in range(50):
        middle = 0.5 * (inner + outer)
        serves = margins(T, q1, q5, np.array([seed + middle]))[0] >= 0.0
        inner, outer = (inner, middle) if serves else (middle, outer)
    return float(abs(outer))


def turned(angle: FloatArray) -> FloatArray:
    return np.asarray(angle - 2 * np.pi * np.round(angle / (2 * np.pi)))


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_solution_is_found_and_it_is_the_nearest(language: str) -> None:
    q = singular(COUNT[language])
    seeds = random_joints(robot("ur5"), len(q), seed=42)
    moved = 0
    for joints, seed, T in zip(q, seeds, poses_of("ur5", q), strict=True):
        rows, status = Solver("ur5", language).all(T, seed)
        held = rows[np.isin(status, HELD)]
        assert residual("ur5", held, T) < 1e-11
        assert np.abs(turned(held[:, 0] - joints[0])).min() < 1e-6, joints
        for row in rows[status == FREE_JOINT]:
            move = float(abs(turned(row[5] - seed[5])))
            assert margins(T, row[0], row[4], row[5:])[0] > -SLACK
            assert move <= nearest_move(T, row[0], row[4], seed[5]) + 1e-6
            moved += move > 1e-6
    assert moved > COUNT[language] / 10


@pytest.mark.parametrize("name", ["ur5", "ur10e"])
@pytest.mark.parametrize("straight", [0.0, 1e-13, 1e-12, 1e-11, 1e-10])
def test_a_stretched_arm_whose_wrist_is_just_not_straight(name: str, straight: float) -> None:
    """q6 is known to three digits there; any seed within a right angle agrees up to rounding."""
    q = random_joints(robot(name), 300, seed=42)
    q[:, 2], q[:, 4] = 0.0, straight
    for T in poses_of(name, q):
        rows, status = Solver(name, "C").all(T)
        held = rows[np.isin(status, HELD)]
        assert len(held)
        assert residual(name, held, T) < 1e-11


@pytest.mark.parametrize("language", first_of(LANGUAGES))
@pytest.mark.parametrize("off", [1e-10, 1e-11])
def test_beside_three_singularities_at_once_there_is_a_row(language: str, off: float) -> None:
    """Wrist and elbow straight, link 5 in line with the arm: one value of q6 and none beside it.

    It is known to few digits, and the arm just reaches there.
    """
    count = {"C": 300, "Python": 40}[language]
    source = np.random.default_rng(1)
    q = source.uniform(-3.0, 3.0, (count, 6))
    q[:, 2:5] = 0.0, -np.pi / 2, 0.0
    q += source.uniform(-off, off, q.shape)
    solver = Solver("ur5", language)
    for joints, T in zip(q, poses_of("ur5", q), strict=True):
        for seed in (None, joints + source.uniform(-1e-3, 1e-3, 6)):
            rows, status = solver.all(T, seed)
            held = rows[np.isin(status, HELD)]
            assert len(held), joints
            assert residual("ur5", held, T) < 1e-11
            assert seed is None or gap(held, seed).min() < 0.005
