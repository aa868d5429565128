"""What generated code promises: every real solution, once; rounded poses; the nearest solution."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.poses import random_joints, right_angles
from dhgen.oracle.search import solve
from tests.oracle.sets import one_joint_at
from tests.structures import one_of_each, says
from tests.targets.calling import HELD, LANGUAGES, OK, Solver
from tests.targets.made import (
    MADE_UP_NAMES,
    NAMES,
    apart,
    given,
    made,
    poses_of,
    residual,
    robot,
    robot_path,
    turning,
)

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

EVERY = [*NAMES, *MADE_UP_NAMES]
WHOLE_POSES = [name for name in EVERY if not says(robot_path(name), "task: (?!pose$)")]
TURN = 2 * np.pi
# A root that is nearly double is good to few digits: how far the arm is from stretched is, too.
BESIDE = {
    "parallel_123": [
        [[-np.pi / 2, 0.0, np.pi, np.pi, 0.0, -np.pi / 2]],
        [[np.pi, np.pi, np.pi, np.pi, 0.0, -np.pi / 2]],
    ]
}


def held(name: str, T: FloatArray, q: FloatArray) -> FloatArray:
    """The rows of C that hold joint values, with zeros as the seed."""
    rows, status = Solver(name, "C").all(T, np.zeros(len(q)), *given(name, q))
    return rows[np.isin(status, HELD)]


def half_way_miss(name: str, row: FloatArray, other: FloatArray, T: FloatArray) -> float:
    """By how much joint values half way between those of two rows miss the pose."""
    off = other - row
    off -= 2 * np.pi * np.round(off / (2 * np.pi)) * turning(name)
    return residual(name, (row + 0.5 * off)[None], T)


@pytest.mark.parametrize("name", one_of_each([*EVERY, "parallel_123"]))
def test_no_solution_stands_twice(name: str) -> None:
    """At singular poses branches meet: their rows are one."""
    arm = robot(name)
    sets = [right_angles(arm, 100), one_joint_at(arm, (0.0, np.pi / 2, np.pi), 4)]
    sets += [np.array(q) for q in BESIDE.get(name, ())]
    q = np.concatenate(sets)
    for joints, T in zip(q, poses_of(name, q), strict=True):
        rows = held(name, T, joints)
        assert len(rows), joints
        one, other = np.triu_indices(len(rows), 1)
        gaps = apart(name, rows[one], rows[other]).max(axis=1)
        assert gaps.min(initial=np.inf) > 1e-6, (joints, rows)
        for k in np.flatnonzero(gaps < 1e-5):  # two if half way is none
            assert half_way_miss(name, rows[one[k]], rows[other[k]], T) > 1e-12, (joints, rows)


@pytest.mark.parametrize("name", one_of_each(EVERY))
def test_every_solution_that_a_search_finds(name: str) -> None:
    """Newton's method from very many starts knows nothing of the arm's structure."""
    q = random_joints(robot(name), 2, seed=31)
    for joints, T in zip(q, poses_of(name, q), strict=True):
        rows = held(name, T, joints)
        found = solve(robot(name), T, [float(v) for each in given(name, joints) for v in each])
        wanted = np.concatenate([found.regular, found.singular])
        assert len(rows) == len(found.regular)
        for solution in wanted:
            assert apart(name, rows, solution).max(axis=1).min() < 1e-6


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", one_of_each(WHOLE_POSES))
def test_a_pose_in_single_precision(name: str, language: str) -> None:
    """It is solved like the pose with the nearest rotation, with no branch lost."""
    q = random_joints(robot(name), 6, seed=32)
    for joints, T in zip(q, poses_of(name, q), strict=True):
        rounded = T.astype(np.float32).astype(float)
        rounded[:3, :3] += 3e-7 * np.sign(np.sin(np.arange(9.0) + 1).reshape(3, 3))
        left, _, right = np.linalg.svd(rounded[:3, :3])
        straight = rounded.copy()
        straight[:3, :3] = left @ right
        solver = Solver(name, language)
        rows, status = solver.all(rounded, None, *given(name, joints))
        others, other_status = solver.all(straight, None, *given(name, joints))
        exact = solver.all(T, None, *given(name, joints))[1]
        assert status.tolist() == other_status.tolist() == exact.tolist()
        solved = np.isin(status, HELD)
        assert apart(name, rows[solved], others[solved]).max() < 1e-9


def near(name: str, joint: int, value: float, seed: float) -> float | None:
    """The place nearest to the seed's, whole turns apart and inside the limits."""
    low, high = robot(name).joints[joint].limits or (-np.inf, np.inf)
    turns = range(-3, 4) if turning(name)[joint] else (0,)
    places = [value + k * TURN for k in turns if low - 1e-9 <= value + k * TURN <= high + 1e-9]
    return places[int(np.argmin(np.abs(np.array(places) - seed)))] if places else None


def brute_force(name: str, T: FloatArray, seed: FloatArray, q: FloatArray) -> FloatArray | None:
    """The nearest solution inside the limits, among all whole turns of all rows."""
    rows, _ = Solver(name, "C").all(T, seed, *given(name, q))
    size = made(name).module.chain.size
    weight = np.where(turning(name), 1.0, 1.0 / size**2)
    best, least = None, np.inf
    for row in rows[np.isfinite(rows).all(axis=1)]:
        places = [near(name, joint, row[joint], seed[joint]) for joint in range(len(row))]
        if all(place is not None for place in places):
            values = np.array(places, dtype=float)
            distance = float(weight @ (values - seed) ** 2)
            if distance < least:
                best, least = values, distance
    return best


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", one_of_each(EVERY))
def test_nearest(name: str, language: str) -> None:
    q = random_joints(robot(name), 12, seed=33)
    source = np.random.default_rng(34)
    answers = set()
    for joints, T in zip(q, poses_of(name, q), strict=True):
        seed = joints + source.normal(0.0, 2.0, len(joints))
        for joint in robot(name).free:
            seed[joint - 1] = joints[joint - 1]
        wanted = brute_force(name, T, seed, joints)
        result, nearest = Solver(name, language).nearest(T, seed, *given(name, joints))
        assert (result >= OK) == (wanted is not None)
        answers.add(result)
        if wanted is not None:
            np.testing.assert_allclose(nearest, wanted, rtol=0, atol=1e-9)
            assert residual(name, nearest[None], T) < 1e-11
    assert OK in answers
