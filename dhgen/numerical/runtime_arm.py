"""An arm as the runtime knows it: its joints, its task and its forward model in numbers."""

from __future__ import annotations

from math import inf
from typing import TYPE_CHECKING

from dhgen.errors import UnsolvedError
from dhgen.kinematics.rigid import IDENTITY, multiply
from dhgen.robot.robot import JointKind
from dhgen.runtime.python.numerical.arm import Arm, ChainJoint, Joint

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import ChainJoint as OwnJoint
    from dhgen.kinematics.numeric import NumericArm
    from dhgen.kinematics.rigid import Matrix
    from dhgen.numerical.kernel import NumericalKernel


def runtime_arm(kernel: NumericalKernel) -> Arm:
    """The arm of a kernel.

    Raises:
        UnsolvedError: Rows are passive, which the runtime's least squares know nothing of.
    """
    chain = kernel.arm.chain
    if chain.passive:
        raise UnsolvedError(
            "rows of this arm would have to be refined by least squares, which do not take passive "
            "rows (those without q): ask for as much as the arm can choose, with equations in "
            "closed form"
        )
    base, *behind = _between_joints(kernel.arm)
    return Arm(
        rows=kernel.rows,
        size=chain.size,
        coordinates=kernel.position,
        directions=kernel.directions.value,
        joints=tuple(map(_joint, chain.solved)),
        base=twelve(base),
        chain=tuple(
            ChainJoint(
                twelve(after),
                _turns(joint),
                float(joint.sign),
                float(joint.offset),
                tuple((share.drive - 1, share.factor) for share in joint.shares),
            )
            for joint, after in zip(chain.joints, behind, strict=True)
        ),
        order=tuple(joint - 1 for joint in chain.drives.order) if chain.drives.are_coupled else (),
        free=tuple(number - 1 for number in chain.free),
        redundant=kernel.redundant,
        checked=kernel.checked,
        arm_angle=kernel.elbow,
    )


def twelve(K: Matrix) -> tuple[float, ...]:
    """The upper rows of a rigid transform, one after another."""
    return tuple(x for row in K[:3] for x in row)


def _joint(joint: OwnJoint) -> Joint:
    """A joint that is solved for; its sign and offset in the loop are those of the chain."""
    lowest, highest = joint.limits or (-inf, inf)
    return Joint(
        place=joint.number - 1,
        turns=_turns(joint),
        lowest=float(lowest),
        highest=float(highest),
        facing=float(joint.sign),
        zero=float(joint.offset),
    )


def _turns(joint: OwnJoint) -> bool:
    return joint.kind is JointKind.REVOLUTE


def _between_joints(arm: NumericArm) -> list[Matrix]:
    """The rigid transforms before, between and behind the joints.

    Multiplied one after the other in plain floating point, so that every machine gets the same.
    """
    constants = [_matrix(arm.base)]
    for element in arm.elements:
        if isinstance(element, int):
            constants.append(IDENTITY)
        else:
            constants[-1] = multiply(constants[-1], _matrix(element))
    constants[-1] = multiply(constants[-1], _matrix(arm.tool))
    return constants


def _matrix(array: FloatArray) -> Matrix:
    return tuple(tuple(row) for row in array.tolist())
