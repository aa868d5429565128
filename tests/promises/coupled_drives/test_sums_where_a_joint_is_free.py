"""Where a joint is free it takes a value that keeps the limits of sums, too.

By brute force: an arm of the same shape that has no limits is asked for rows with many values of
the free joint, and of these all whole turns of all drives are looked at.
"""

from __future__ import annotations

import re
from functools import cache
from itertools import product
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from tests.compiling import library, written
from tests.promises.coupled_drives.test_coupled_drives import bounds, is_inside, shares
from tests.targets.calling import FREE_JOINT, HELD, LANGUAGES, OK, Solver
from tests.targets.made import folder, poses_of, robot, robot_path, turning

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.verify.native import CompiledSolver

# With what makes each of them singular: a joint, from 0, and its value.
STRAIGHT = {"summed_wrist": (1, 0.0), "summed_wrist_6r": (4, 0.0), "screw_on_axis": (1, np.pi)}
SWEPT = 72  # values of the free joint around the turn
STEP = 2.0 * np.pi / SWEPT
CLEAR = 2.0 * STEP  # a sum may change by this between two of them
POSES = 24
names = pytest.mark.parametrize("name", STRAIGHT)


@cache
def unlimited(name: str) -> CompiledSolver:
    """The C of the arm without its limits."""
    text = robot_path(name).read_text(encoding="utf-8").split("\nlimits:")[0]
    text = re.sub(r", limits: \[[^]]*\]", "", text).replace(f"name: {name}", f"name: {name}_open")
    path = folder() / f"{name}_open.yaml"
    path.write_text(text, encoding="utf-8")
    return library(written(path, folder()).module, folder())


def singular(name: str, count: int) -> FloatArray:
    """Drives' values with a free joint: half of them inside all limits, half of them not."""
    low, high = bounds(name)
    joint, value = STRAIGHT[name]
    q = np.random.default_rng(8).uniform(low, high, (100 * count, len(low)))
    q[:, joint] = value
    inside = is_inside(name, q, 1e-3)
    half = count // 2
    assert inside.sum() >= half
    return np.concatenate([q[inside][:half], q[~inside][: count - half]])


def seeds(q: FloatArray) -> FloatArray:
    """Zeros, anywhere, and beside the values that made the pose, in turn."""
    source = np.random.default_rng(9)
    made = np.stack([0.0 * q, source.uniform(-3.0, 3.0, q.shape), q + 0.02])
    return np.asarray(made[np.arange(len(q)) % 3, np.arange(len(q))])


def is_possible(name: str, T: FloatArray) -> bool:
    """Whether some value of the free joint has a row that whole turns take inside all limits."""
    moved = 2.0 * np.pi * np.linalg.inv(shares(name)).T
    ways = [(0, -1, 1) if turns else (0,) for turns in turning(name)]
    copies = np.array(list(product(*ways))) @ moved
    for value in np.arange(SWEPT) * STEP - np.pi:
        rows, status = unlimited(name).ik(T, np.full(copies.shape[1], value))
        found = rows[np.isin(status, HELD)]
        if is_inside(name, found[:, None] + copies, CLEAR).any():
            return True
    return False


@names
def test_a_row_is_inside_all_limits_wherever_one_can_be(name: str) -> None:
    q, solver, possible = singular(name, POSES), Solver(name, "C"), 0
    for values, T, seed in zip(q, poses_of(name, q), seeds(q), strict=True):
        rows, status = solver.all(T, seed)
        inside = rows[(status == OK) | (status == FREE_JOINT)]
        assert is_inside(name, inside, -1e-8).all()
        reached = np.asarray(forward(robot(name), inside), dtype=float)
        assert np.abs(reached - T)[:, :3].max(initial=0.0) < 1e-9
        if is_possible(name, T):
            possible += 1
            assert len(inside), (values.tolist(), seed.tolist())
    assert possible > POSES // 2


@names
def test_c_and_python_are_alike(name: str) -> None:
    q = singular(name, 2)
    for T, seed in zip(poses_of(name, q), seeds(q), strict=True):
        solved = []
        for language in LANGUAGES:
            rows, status = Solver(name, language).all(T, seed)
            solved.append(np.where(np.isin(status, (OK, FREE_JOINT))[:, None], rows, np.nan))
        np.testing.assert_allclose(solved[0], solved[1], atol=1e-6)


@pytest.mark.parametrize("language", LANGUAGES)
def test_it_is_the_value_nearest_to_the_seed(language: str) -> None:
    """Of a straight wrist q1 + q3 is fixed, q1 - q3 has to be between 60 and 120 degrees."""
    name = "summed_wrist"
    q = singular(name, 10 if language == "C" else 2)
    low, high = bounds(name)
    anywhere = np.random.default_rng(10).uniform(-3.0, 3.0, q.shape)
    for values, T, seed in zip(q, poses_of(name, q), anywhere, strict=True):
        rows, status = Solver(name, language).all(T, seed)
        (row,) = rows[status == FREE_JOINT]
        first = np.arange(low[0], high[0], 1e-4)
        third = values[0] + values[2] - first[:, None] + 2.0 * np.pi * np.array([-2, -1, 0, 1, 2])
        apart = first[:, None] - third
        keeps = (low[2] <= third) & (third <= high[2])
        keeps &= (np.pi / 3 <= apart) & (apart <= 2 * np.pi / 3)
        away = first[keeps.any(axis=1)] - seed[0]
        least = np.abs(away - 2.0 * np.pi * np.round(away / (2.0 * np.pi))).min()
        off = row[0] - seed[0]
        off = abs(off - 2.0 * np.pi * np.round(off / (2.0 * np.pi)))
        assert off == pytest.approx(least, abs=2e-4)


def test_a_seed_beyond_a_sum_replaces_no_row_that_is_inside() -> None:
    """Near a singular pose rows follow the seed; here it meets the pose, but not the limits."""
    name = "summed_wrist_6r"
    q = singular(name, POSES)[: POSES // 2]
    for values, T in zip(q, poses_of(name, q), strict=True):
        seed = values + np.array([0.0, 0.0, 0.0, 1.5, 0.0, -1.5])
        _, status = Solver(name, "C").all(T, seed)
        assert np.isin(status, (OK, FREE_JOINT)).any()


def test_a_seed_beyond_all_digits_is_answered() -> None:
    """So far out one turn more changes no number: a walk that counted turns would not end."""
    name = "scara_ball_screw"
    q = np.array([[0.3, -0.8, -0.05, 1.0]])
    (T,) = poses_of(name, q)
    for far in (1e16, 1e17, 1e18, 1e300):
        solved = unlimited(name).nearest(T, np.array([0.0, 0.0, 0.0, far]))
        assert np.isfinite(solved).all()
