"""An arm for the runtime: its joints, its task and its forward model in numbers."""

from __future__ import annotations

from math import inf
from typing import TYPE_CHECKING

from dhgen.kinematics.rigid import IDENTITY, multiply
from dhgen.kinematics.turns import solved_alone
from dhgen.robot.robot import JointKind
from dhgen.runtime.python.numerical.arm import Arm, ChainJoint, Drives, Joint

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain, Passive
    from dhgen.kinematics.chain import ChainJoint as OwnJoint
    from dhgen.kinematics.numeric import NumericArm
    from dhgen.kinematics.rigid import Matrix
    from dhgen.numerical.kernel import NumericalKernel


def runtime_arm(kernel: NumericalKernel) -> Arm:
    """The arm of a kernel."""
    chain = kernel.arm.chain
    base, *behind = _between_joints(kernel.arm)
    rows = [element for element in kernel.arm.elements if isinstance(element, int)]
    return Arm(
        rows=kernel.rows,
        size=chain.size,
        coordinates=kernel.position,
        directions=kernel.directions.value,
        joints=tuple(map(_joint, solved_alone(chain))),
        base=twelve(base),
        chain=tuple(
            _link(chain, number, after) for number, after in zip(rows, behind, strict=True)
        ),
        order=tuple(map(rows.index, _order(chain))),
        free=tuple(number - 1 for number in chain.free),
        redundant=kernel.redundant,
        checked=kernel.checked,
        arm_angle=kernel.elbow,
        drives=_drives(kernel),
    )


def _drives(kernel: NumericalKernel) -> Drives | None:
    """How drives hang together, where one moves more than its own joint."""
    if kernel.back is None:
        return None
    back = tuple(map(tuple, kernel.back.tolist()))
    return Drives(back, tuple((place, tuple(moves.tolist())) for place, moves in kernel.turned))


def _order(chain: Chain) -> list[int]:
    """The numbers of joints and passive rows that drives of others move, as shares are added up."""
    passive = [chain.dof + 1 + each.place for each in chain.passive]
    return [*(chain.drives.order if chain.drives.are_coupled else ()), *passive]


def _link(chain: Chain, number: int, after: Matrix) -> ChainJoint:
    """A joint of the forward model; places beyond the last are passive rows."""
    if number > chain.dof:
        passive = chain.passive[number - chain.dof - 1]
        return ChainJoint(
            twelve(after), passive.turns, 0.0, float(passive.offset), _shares(passive)
        )
    joint = chain.joints[number - 1]
    sign, offset = float(joint.sign), float(joint.offset)
    return ChainJoint(twelve(after), _turns(joint), sign, offset, _shares(joint))


def _shares(moved: OwnJoint | Passive) -> tuple[tuple[int, float], ...]:
    return tuple((share.drive - 1, share.factor) for share in moved.shares)


def twelve(K: Matrix) -> tuple[float, ...]:
    """The upper rows of a rigid transform, one after another."""
    return tuple(x for row in K[:3] for x in row)


def _joint(joint: OwnJoint) -> Joint:
    """A joint that is solved for, with the chain's sign and offset in the loop."""
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
