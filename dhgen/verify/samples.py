"""Joint values on which solvers are tried: random ones, and where arms are singular."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.algebra import POSE_PLACES
from dhgen.kinematics.numeric import numeric_arm
from dhgen.kinematics.task import compared_entries, task_rates, units
from dhgen.robot.robot import JointKind
from dhgen.robot.task import TaskKind
from dhgen.verify.singular import TRIED, singular_places, whole_turns

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain
    from dhgen.robot.task import Task


NEAR = (1e-6, 1e-8, 1e-10)  # [rad] distances from a singular angle
CLEAR = 1e-3  # least growth of the singular value from a singular place
TRIES = 200  # at joint values that keep limits of sums
SINGULAR_SHARE = 10  # random poses for each that is singular by one joint


@dataclass(frozen=True, slots=True)
class Sample:
    """Joint values of one sort.

    Attributes:
        name: What sort.
        q: Shape (N, n), inside the limits unless the arm is singular there.
        near: Whether some lie beside singular ones, where rounding may decide which they are.
    """

    name: str
    q: FloatArray
    near: bool = False


def samples(chain: Chain, count: int) -> tuple[Sample, ...]:
    """Every sort of joint values, `count` of each; equal at every run."""
    source = np.random.default_rng(7)
    everywhere = _uniform(chain, source, count)
    right = _right_angles(chain, source, count)
    mixed = np.where(source.random(everywhere.shape) < 0.4, right, everywhere)
    near = mixed + source.choice(NEAR, mixed.shape) * source.choice([-1.0, 1.0], mixed.shape)
    low, high = _ranges(chain)
    edge = np.where(
        source.random(everywhere.shape) < 0.3, np.where(right > 0, high, low), everywhere
    )
    return (
        Sample("random", everywhere),
        Sample("right angles", right),
        Sample("some joints at right angles", mixed),
        Sample("near right angles", np.clip(near, low, high), near=True),
        Sample("at joint limits", edge),
        *_singular(chain, source, -(-count // SINGULAR_SHARE)),
    )


def _singular(chain: Chain, source: np.random.Generator, count: int) -> tuple[Sample, ...]:
    """Where one joint's value makes the arm singular, `count` for each such joint; and beside.

    Beyond limits, too: there a row has to hold the joint values all the same.
    """
    arm = numeric_arm(chain)
    turns = np.array(chain.turning)
    unit = units(chain)
    moving = [joint.number - 1 for joint in chain.solved]
    low, high = _strokes(chain)
    tried = TRIED * count
    joints = np.repeat(moving, tried)
    q = source.uniform(low, high, (len(joints), chain.dof)) / unit
    ends = whole_turns(low / unit, high / unit, turns)
    numbers, found = singular_places(
        lambda q: task_rates(arm, q * unit), q, joints, (ends[0][joints], ends[1][joints]), source
    )
    kept = np.concatenate([np.flatnonzero(joints[numbers] == j)[:count] for j in moving])
    exact, moved = found[kept] * unit, joints[numbers[kept]]
    if not len(exact):
        return ()
    beside = exact.copy()
    off = source.choice(NEAR, len(exact)) * source.choice([-1.0, 1.0], len(exact))
    beside[np.arange(len(exact)), moved] += off * unit[moved]
    # where the arm is nearly singular in another way too, the place is not known exactly
    values = np.linalg.svd(task_rates(arm, beside), compute_uv=False)[:, -1]
    clear = values >= CLEAR * np.abs(off)
    return (
        Sample("singular", exact[clear]),
        Sample("nearly singular", np.concatenate([beside, exact[~clear]]), near=True),
    )


def _ranges(chain: Chain) -> tuple[FloatArray, FloatArray]:
    """Lowest and highest value of each joint; without limits a turn, or the arm's size."""
    free = zip(*_strokes(chain), strict=True)
    pairs = [joint.limits or pair for joint, pair in zip(chain.joints, free, strict=True)]
    low, high = np.array(pairs).T
    return low, high


def _strokes(chain: Chain) -> tuple[FloatArray, FloatArray]:
    """Samples with whole turns of every joint that turns."""
    turn, size = (-np.pi, np.pi), (-chain.size, chain.size)
    pairs = [
        turn if joint.kind is JointKind.REVOLUTE else joint.limits or size for joint in chain.joints
    ]
    low, high = np.array(pairs).T
    return low, high


def _uniform(chain: Chain, source: np.random.Generator, count: int) -> FloatArray:
    low, high = _ranges(chain)
    q = source.uniform(low, high, (count, chain.dof))
    for _ in range(TRIES):
        beyond = ~keeps_sums(chain, q)
        if not beyond.any():
            break
        q[beyond] = source.uniform(low, high, (int(beyond.sum()), chain.dof))
    return q


def keeps_sums(chain: Chain, q: FloatArray) -> NDArray[np.bool_]:
    """Whether sums of joint values (N, n) are inside their limits, (N,)."""
    kept = np.ones(len(q), bool)
    for limit in chain.sums:
        total = q @ np.array(limit.factors)
        kept &= (limit.lowest <= total) & (total <= limit.highest)
    return kept


def _right_angles(chain: Chain, source: np.random.Generator, count: int) -> FloatArray:
    """Multiples of a right angle where the limits allow it, lengths at simple fractions."""
    low, high = _ranges(chain)
    angles = source.integers(-2, 3, (count, chain.dof)) * (np.pi / 2)
    angles = np.where((angles < low) | (angles > high), 0.0, angles)
    lengths = low + (high - low) * source.integers(0, 5, (count, chain.dof)) / 4
    return np.clip(np.where(chain.turning, angles, lengths), low, high)


def spoiled_poses(task: Task, T: FloatArray) -> list[FloatArray]:
    """Poses like T that are none: not finite, mirrored, stretched, in other coordinates."""
    name = min(compared_entries(task), key=lambda name: (name[2] != "4", name))
    row, column = POSE_PLACES[name]
    spoiled = [T.copy() for _ in range(4 if task.names_rotation else 2)]
    spoiled[0][row, column] = np.nan
    spoiled[1][row, column] = np.inf
    if task.kind is TaskKind.POSE:
        spoiled.append(T.copy())
        spoiled[-1][3, 3] = 0.5
    if task.names_rotation:
        spoiled[2][:3, 0] *= -1.0
        spoiled[3][:3, :3] *= 1.01
    return spoiled
