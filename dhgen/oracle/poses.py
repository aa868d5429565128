"""Joint vectors at whose poses a solver must answer: anywhere, at right angles, on limits.

Every set is an array of joint vectors (N, n), equal on every run. Prismatic joints are within their
limits, or within the arm's size when they have none. Revolute joints turn all the way round except
in `boundary`.
"""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING

import numpy as np

from dhgen.oracle.arm import arm_size
from dhgen.robot.robot import JointKind, Robot

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

RIGHT_ANGLES = (0.0, np.pi / 2, np.pi, -np.pi / 2)
NEAR = (1e-6, 1e-8, 1e-10)  # rad


def ranges(robot: Robot) -> FloatArray:
    """Lowest and highest values, (2, n): full turns, and strokes or else the arm's size."""
    size = arm_size(robot)
    low, high = [], []
    for joint in robot.joints:
        if joint.kind is JointKind.REVOLUTE:
            limits = (-np.pi, np.pi)
        else:
            limits = joint.limits or (-size, size)
        low.append(limits[0])
        high.append(limits[1])
    return np.array([low, high])


def random_joints(robot: Robot, count: int, *, seed: int = 0) -> FloatArray:
    """Anywhere: (count, n)."""
    low, high = ranges(robot)
    return np.random.default_rng(seed).uniform(low, high, (count, len(low)))


def right_angles(robot: Robot, most: int = 500, *, seed: int = 0) -> FloatArray:
    """Every joint a multiple of a right angle, slides in or out or in between.

    All combinations, or a sample of `most` of them: home poses, what everyone tries first.
    """
    turns = [joint.kind is JointKind.REVOLUTE for joint in robot.joints]
    choices = [
        RIGHT_ANGLES if revolute else (low, (low + high) / 2, high)
        for revolute, low, high in zip(turns, *ranges(robot), strict=True)
    ]
    if np.prod([float(len(choice)) for choice in choices]) <= most:
        return np.array(list(product(*choices)))
    random = np.random.default_rng(seed)
    return np.stack([random.choice(choice, most) for choice in choices], axis=1)


def boundary(robot: Robot, count: int, *, seed: int = 0) -> FloatArray:
    """Each joint with limits in turn at its lowest and highest value, the others within theirs."""
    limits = [joint.limits for joint in robot.joints]
    low, high = ranges(robot)
    for joint, pair in enumerate(limits):
        low[joint], high[joint] = pair or (low[joint], high[joint])
    found = [np.empty((0, len(limits)))]
    for joint, pair in enumerate(limits):
        for value in pair or ():
            random = np.random.default_rng(seed + len(found))
            q = random.uniform(low, high, (count, len(limits)))
            q[:, joint] = value
            found.append(q)
    return np.concatenate(found)
