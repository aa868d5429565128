"""Whether an arm can be solved at all: does every joint matter, everywhere, for the task?

At a general position the Jacobian of the task has one column for each joint that is solved for.
When their rank is less than their number, joints can be moved against each other without moving
the tool: the arm is redundant for its task, or degenerate (collinear axes, all axes parallel or
concurrent).
"""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.numeric import numeric_arm
from dhgen.robot.robot import JointKind, TaskKind

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.kinematics.chain import Chain

    Array = NDArray[np.float64]

POSITIONS = 3
NULL = 1e-9  # a singular value, or a joint's part in a null vector, this small is zero
SAME_LINE = 1e-9


def immobility(chain: Chain) -> str | None:
    """Why the arm has infinitely many solutions everywhere, or None when it has not."""
    source = np.random.default_rng(3)
    solved = [joint.number for joint in chain.joints if joint.number not in chain.free]
    if not solved:
        return "every joint is free: there is nothing to solve"
    moving = np.ones(len(solved), dtype=bool)
    surplus = len(solved)
    for _ in range(POSITIONS):
        jacobian = task_jacobian(chain, source.uniform(-2.0, 2.0, chain.dof))
        columns = jacobian[:, [number - 1 for number in solved]]
        _, values, rows = np.linalg.svd(columns)
        rank = int(np.sum(values > NULL * max(values.max(), NULL)))
        surplus = min(surplus, len(solved) - rank)
        null = rows[rank:]
        moving &= np.abs(null).max(axis=0, initial=0.0) > NULL**0.5
    if surplus == 0:
        return None
    candidates = [number for number, moves in zip(solved, moving, strict=True) if moves]
    return _explanation(chain, surplus, candidates)


def task_jacobian(chain: Chain, q: Array) -> Array:
    """How the numbers that the task names change with the joints, lengths in arm sizes."""
    frames = _joint_frames(chain, q)
    tip = numeric_arm(chain).pose(q)
    columns = []
    for joint, frame in zip(chain.joints, frames, strict=True):
        axis, origin = frame[:3, 2], frame[:3, 3]
        if joint.kind is JointKind.PRISMATIC:
            columns.append(np.concatenate([axis, np.zeros(3)]))
        else:
            arm = (tip[:3, 3] - origin) / chain.size
            columns.append(np.concatenate([np.cross(axis, arm), axis]))
    full = np.array(columns).T
    match chain.task.kind:
        case TaskKind.POSE:
            return full
        case TaskKind.POSITION:
            return full[:3]
        case TaskKind.ORIENTATION:
            return full[3:]
        case TaskKind.POINTING:
            across = np.linalg.svd(tip[:3, 2:3])[0][:, 1:]  # two directions normal to the tool's z
            return np.vstack([full[:3], across.T @ full[3:]])
        case TaskKind.COORDINATES:
            return full[["xyz".index(name) for name in chain.task.coordinates]]


def _joint_frames(chain: Chain, q: Array) -> list[Array]:
    """The frame just before each joint moves, its z along the joint's axis."""
    arm = numeric_arm(chain)
    frames: list[Array] = []
    T = arm.base
    for element in arm.elements:
        if isinstance(element, tuple):
            frames.append(T)
        T = T @ arm.step(q, element)
    return frames


def _explanation(chain: Chain, surplus: int, candidates: list[int]) -> str:
    names = ", ".join(map(str, candidates))
    lines = [
        (
            f"the arm has infinitely many solutions for every pose: joints {names} can be moved "
            "against each other without moving what the task names"
        )
    ]
    lines += _coincident(chain)
    given = "one of them" if surplus == 1 else f"{surplus} of them"
    lines.append(f"name {given} under `free` to solve for the others with its value given")
    return "\n".join(lines)


def _coincident(chain: Chain) -> list[str]:
    """Revolute neighbours whose axes are one line."""
    frames = _joint_frames(chain, np.zeros(chain.dof))
    revolute = [
        (joint.number, frame)
        for joint, frame in zip(chain.joints, frames, strict=True)
        if joint.kind is JointKind.REVOLUTE
    ]
    lines = []
    for (first, one), (second, other) in pairwise(revolute):
        z, between = one[:3, 2], other[:3, 3] - one[:3, 3]
        turned = np.linalg.norm(np.cross(z, other[:3, 2]))
        aside = np.linalg.norm(np.cross(z, between))
        if second == first + 1 and turned < SAME_LINE and aside < SAME_LINE * chain.size:
            lines.append(f"axes {first} and {second} are the same line")
    return lines
