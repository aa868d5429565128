"""Rows along continuous motions: a branch keeps its row, and `ik_nearest` follows."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.poses import ranges
from dhgen.status import HELD
from dhgen.survey.singular import is_redundant, task_jacobian
from tests.generated.asking import POLYNOMIAL, trial
from tests.generated.solvers import NAMES, robot
from tests.structures import one_of_each

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.survey.trial import Trial

MOTIONS, STEPS = 4, 300
REGULAR = 1e-3  # least singular value of the task's Jacobian, lengths in arm sizes
STEEPEST = 3.0  # what a joint's turn changes that by at most, with a margin
SAME = 1e-7


def motions(name: str, *, within_limits: bool) -> list[FloatArray]:
    """Smooth random motions of all joints but the free ones, each (STEPS, n)."""
    low, high = ranges(robot(name))
    if within_limits:
        limits = [joint.limits for joint in robot(name).joints]
        pairs = [pair or (low[i], high[i]) for i, pair in enumerate(limits)]
        low, high = np.array(pairs).T
    middle, half = (low + high) / 2, (high - low) / 2
    source = np.random.default_rng(41)
    time = np.linspace(0.0, 1.0, STEPS)[:, None]
    free = [joint - 1 for joint in robot(name).free]
    found = []
    for _ in range(MOTIONS):
        phase, speed = source.uniform(-np.pi, np.pi, (2, len(low)))
        speed[free] = 0.0
        found.append(middle + 0.98 * half * np.sin(phase + speed * time))
    return found


def least(asked: Trial, q: FloatArray) -> FloatArray:
    """How far joint values (N, n) are from singular."""
    scale = np.where(asked.model.revolute, 1.0, asked.size)
    J = task_jacobian(asked.model.divided_by(asked.size), asked.robot, q / scale)
    return np.asarray(np.linalg.svd(J, compute_uv=False)[..., -1])


def rows_of(
    asked: Trial, T: FloatArray, q: FloatArray, given: list[FloatArray | None]
) -> NDArray[np.intp]:
    """Which row holds each of the joint values (N, n) that are the seeds, too."""
    rows = np.array([asked.solver.ik(*each)[0] for each in zip(T, q, given, strict=True)])
    gaps = asked.apart(rows, q[:, None])
    assert (np.nanmin(gaps, axis=1) < SAME).all(), q[np.nanmin(gaps, axis=1).argmax()]
    return np.asarray(np.nanargmin(gaps, axis=1))


@pytest.mark.parametrize("name", one_of_each(name for name in NAMES if name not in POLYNOMIAL))
def test_a_branch_keeps_its_row(name: str) -> None:
    """From one singular place to the next.

    Not where a task has more numbers than the arm has joints: there two solutions of one pose may
    be joined by a motion without any singular place (a katana's wrist passes over axis 1), so no
    naming of rows could keep them apart.
    """
    asked = trial(name)
    if not is_square(asked):
        assert len(robot(name).joints) < 6
        return
    compared = 0
    for q in motions(name, within_limits=False):
        regular = crossed_nothing(asked, q)
        rows = rows_of(asked, asked.poses(q), q, given_along(asked, q))
        left = np.flatnonzero(regular & (rows[1:] != rows[:-1]))
        assert not left.size, q[left + 1].tolist()
        compared += int(regular.sum())
    assert compared > 20


def given_along(asked: Trial, q: FloatArray) -> list[FloatArray | None]:
    """What the caller gives besides each pose of a motion (N, n)."""
    values = asked.given(q)
    return [None] * len(q) if values is None else list(values)


def is_square(asked: Trial) -> bool:
    rows, columns = task_jacobian(asked.model, asked.robot, np.zeros(len(asked.robot.joints))).shape
    return bool(rows == columns)


def crossed_nothing(asked: Trial, q: FloatArray) -> NDArray[np.bool_]:
    """Whether no singular place lies between one step and the next, (STEPS - 1,)."""
    far = least(asked, q)
    moved = asked.apart(q[1:], q[:-1])
    return np.asarray(np.minimum(far[1:], far[:-1]) > np.maximum(STEEPEST * moved, REGULAR))


def keep_sums(name: str, q: FloatArray) -> NDArray[np.bool_]:
    """Whether sums of joint values (N, n) are inside their limits, (N,)."""
    kept = np.ones(len(q), bool)
    for each in robot(name).sums:
        total = np.sum([term.value * q[:, term.joint - 1] for term in each.of], axis=0)
        kept &= (each.limits[0] < total) & (total < each.limits[1])
    return kept


@pytest.mark.parametrize("name", one_of_each(NAMES))
def test_the_nearest_solution_follows_a_motion(name: str) -> None:
    """The nearest, but of a family: there it may be nearer to the seed than the motion is."""
    asked = trial(name)
    if is_redundant(robot(name)):
        return
    followed = 0
    for q in motions(name, within_limits=True):
        far = (least(asked, q) > 30 * REGULAR) & keep_sums(name, q)
        T, given = asked.poses(q), given_along(asked, q)
        rows, status = asked.solver.batch(T, asked.given(q))
        moved = asked.apart(q[1:], q[:-1])
        rivals = asked.apart(rows, q[:, None])
        rivals = np.where(np.isin(status, HELD) & (rivals > SAME), rivals, np.inf).min(axis=1)
        # where another solution passes by, which is nearer is a matter of norms
        clear = np.flatnonzero(far[1:] & far[:-1] & (rivals[1:] >= 10 * moved)) + 1
        found = [asked.solver.nearest(T[k], q[k - 1], given[k]) for k in clear]
        if found:
            off = ~(asked.apart(np.array(found), q[clear]) < SAME)
            assert not off.any(), (clear[off], q[clear[off]].tolist())
        followed += len(found)
    assert followed > 20
