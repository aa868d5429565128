"""Whether an arm can be solved at all: does every joint matter, everywhere, for the task?

At a general position the Jacobian of the task has one column for each joint that is solved for.
When their rank is less than their number, joints can be moved against each other without moving
the tool: the arm is redundant for its task, or degenerate (collinear axes, all axes parallel or
concurrent).
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.numeric import numeric_arm
from dhgen.robot.robot import JointKind, TaskKind

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.numeric import NumericArm

    Array = NDArray[np.float64]

POSITIONS = 3
NULL = 1e-9  # a singular value, or a joint's part in a null vector, this small is zero
SAME_LINE = 1e-9


@dataclass(frozen=True, slots=True)
class Surplus:
    """The joints that a task does not fix.

    Attributes:
        count: How many joints more there are than the task fixes, everywhere.
        joints: Those that can be moved against each other, from 1.
    """

    count: int
    joints: tuple[int, ...]


def surplus(chain: Chain) -> Surplus:
    """What the task leaves open at every pose, the free joints held."""
    source = np.random.default_rng(3)
    arm = numeric_arm(chain)
    solved = [joint.number for joint in chain.joints if joint.number not in chain.free]
    moving = np.ones(len(solved), dtype=bool)
    count = len(solved)
    for _ in range(POSITIONS if solved else 0):
        jacobian = task_jacobian(arm, source.uniform(-2.0, 2.0, chain.dof))
        columns = jacobian[:, [number - 1 for number in solved]]
        _, values, rows = np.linalg.svd(columns)
        rank = int(np.sum(values > NULL * max(values.max(), NULL)))
        count = min(count, len(solved) - rank)
        null = rows[rank:]
        moving &= np.abs(null).max(axis=0, initial=0.0) > NULL**0.5
    return Surplus(count, tuple(j for j, moves in zip(solved, moving, strict=True) if moves))


def task_jacobian(arm: NumericArm, q: Array) -> Array:
    """How the numbers that the task names change with the joints, lengths in arm sizes."""
    chain = arm.chain
    full = arm.jacobian(q)
    full[:3] /= chain.size
    match chain.task.kind:
        case TaskKind.POSE:
            return full
        case TaskKind.POSITION:
            return full[:3]
        case TaskKind.ORIENTATION:
            return full[3:]
        case TaskKind.POINTING:
            # two directions normal to the tool's z
            across = np.linalg.svd(arm.pose(q)[:3, 2:3])[0][:, 1:]
            return np.vstack([full[:3], across.T @ full[3:]])
        case TaskKind.COORDINATES:
            return full[["xyz".index(name) for name in chain.task.coordinates]]


def coincident_axes(chain: Chain) -> list[str]:
    """Revolute neighbours whose axes are one line."""
    directions, points = numeric_arm(chain).axes(np.zeros(chain.dof))
    revolute = [j.number for j in chain.joints if j.kind is JointKind.REVOLUTE]
    lines = []
    for first, second in pairwise(revolute):
        z, other = directions[first - 1], directions[second - 1]
        between = points[second - 1] - points[first - 1]
        turned = np.linalg.norm(np.cross(z, other))
        aside = np.linalg.norm(np.cross(z, between))
        if second == first + 1 and turned < SAME_LINE and aside < SAME_LINE * chain.size:
            lines.append(f"axes {first} and {second} are the same line")
    return lines
