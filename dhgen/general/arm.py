"""The general algorithm for a chain: whether it applies, and its constants."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.general.rigid import IDENTITY, multiply
from dhgen.general.setup import setup
from dhgen.kinematics.numeric import numeric_arm
from dhgen.robot.robot import JointKind, TaskKind

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.general.kernel import GeneralKernel
    from dhgen.general.rigid import Matrix
    from dhgen.kinematics.chain import Chain

TURNS = 6


def general_kernel(chain: Chain) -> GeneralKernel | None:
    """The kernel of an arm with six revolute joints that is asked for poses; None for others."""
    revolute = all(joint.kind is JointKind.REVOLUTE for joint in chain.joints)
    if chain.dof != TURNS or not revolute or chain.free or chain.task.kind is not TaskKind.POSE:
        return None
    return setup(loop_constants(chain))


def joint_values(angles: NDArray[np.float64], chain: Chain) -> NDArray[np.float64]:
    """The joint values (k, 6) behind the angles of the algebra (k, 6)."""
    signs = np.array([joint.sign for joint in chain.joints])
    return np.asarray(signs * (angles - [joint.offset for joint in chain.joints]))


def loop_constants(chain: Chain) -> list[Matrix]:
    """C0 ... C6 of T = C0 Rz(theta1) C1 ... Rz(theta6) C6, base and tool included.

    Multiplied one after the other in plain floating point, so that every machine gets the same.
    """
    arm = numeric_arm(chain)
    constants = [_matrix(arm.base)]
    for element in arm.elements:
        if isinstance(element, tuple):
            constants.append(IDENTITY)
        else:
            constants[-1] = multiply(constants[-1], _matrix(element))
    constants[-1] = multiply(constants[-1], _matrix(arm.tool))
    return constants


def _matrix(array: NDArray[np.float64]) -> Matrix:
    return tuple(tuple(row) for row in array.tolist())
