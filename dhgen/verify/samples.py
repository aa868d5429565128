"""Joint values on which solvers are tried: random ones, and where arms are singular."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.robot.robot import JointKind, TaskKind

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.kinematics.chain import Chain
    from dhgen.robot.robot import Task

    Array = NDArray[np.float64]

NEAR = (1e-6, 1e-8, 1e-10)  # [rad] distances from a singular angle


@dataclass(frozen=True, slots=True)
class Sample:
    """Joint values of one sort.

    Attributes:
        name: What sort.
        q: Shape (N, n), inside the limits.
        near: Whether some lie beside singular ones, where rounding may decide which they are.
    """

    name: str
    q: Array
    near: bool = False


def samples(chain: Chain, count: int) -> tuple[Sample, ...]:
    """Every sort of joint values, `count` of each; the same at every run."""
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
    )


def _ranges(chain: Chain) -> tuple[Array, Array]:
    """Lowest and highest value of each joint; without limits a turn, or the arm's size."""
    pairs = [
        joint.limits
        or ((-np.pi, np.pi) if joint.kind is JointKind.REVOLUTE else (-chain.size, chain.size))
        for joint in chain.joints
    ]
    low, high = np.array(pairs).T
    return low, high


def _uniform(chain: Chain, source: np.random.Generator, count: int) -> Array:
    low, high = _ranges(chain)
    return source.uniform(low, high, (count, chain.dof))


def _right_angles(chain: Chain, source: np.random.Generator, count: int) -> Array:
    """Multiples of a right angle where the limits allow it, lengths at simple fractions."""
    low, high = _ranges(chain)
    angles = source.integers(-2, 3, (count, chain.dof)) * (np.pi / 2)
    angles = np.where((angles < low) | (angles > high), 0.0, angles)
    lengths = low + (high - low) * source.integers(0, 5, (count, chain.dof)) / 4
    turns = np.array([joint.kind is JointKind.REVOLUTE for joint in chain.joints])
    return np.clip(np.where(turns, angles, lengths), low, high)


def spoiled_poses(task: Task, T: Array) -> list[Array]:
    """Poses like T that are none: not finite, mirrored, stretched, in other coordinates."""
    rotation = task.kind in {TaskKind.POSE, TaskKind.ORIENTATION}
    row = "xyz".index(task.coordinates[0]) if task.coordinates else 0
    column = 0 if task.kind is TaskKind.ORIENTATION else 3
    spoiled = [T.copy() for _ in range(4 if rotation else 2)]
    spoiled[0][row, column] = np.nan
    spoiled[1][row, column] = np.inf
    if task.kind is TaskKind.POSE:
        spoiled.append(T.copy())
        spoiled[-1][3, 3] = 0.5
    if rotation:
        spoiled[2][:3, 0] *= -1.0
        spoiled[3][:3, :3] *= 1.01
    return spoiled
