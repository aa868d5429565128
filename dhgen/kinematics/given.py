"""What the caller gives besides the pose: values of free joints, or the arm angle."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.arm_angle import arm_angles
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.numeric import NumericArm
    from dhgen.tolerances import Tolerances


def given_values(arm: NumericArm, q: FloatArray, tolerances: Tolerances = TOLERANCES) -> FloatArray:
    """The values that a caller would give to get joint values back.

    Args:
        arm: The arm.
        q: Joint values, shape (..., n).
        tolerances: Of the arithmetic that solves.

    Returns:
        Shape (..., k), with k of none where nothing is to be given.
    """
    q = np.asarray(q, np.float64)
    if arm.chain.arm_angle:
        return arm_angles(arm, q, aside=tolerances.free, merge=tolerances.merge)[..., None]
    return np.ascontiguousarray(q[..., [joint - 1 for joint in arm.chain.free]])
