"""The general algorithm for a chain: whether it applies, and its constants."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from dhgen.general.kernel import SLIDES_OF_FOUR_TURNS
from dhgen.general.links import Held, Link
from dhgen.general.loop import JOINTS
from dhgen.general.setup import setup
from dhgen.general.virtual_joint import with_virtual_joint
from dhgen.kinematics.numeric import numeric_arm
from dhgen.kinematics.rigid import IDENTITY
from dhgen.robot.robot import JointKind
from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain, ChainJoint
    from dhgen.kinematics.rigid import Matrix


def general_kernel(chain: Chain) -> GeneralKernel | None:
    """The kernel of an arm with six joints that are asked for, at most two of them slides.

    The others are held at the values that the caller gives. Fewer are enough, too, with joints that
    the arm does not have: where the tool only points, its turn about its own axis, whose value
    nobody needs; where then one is still missing, a turn that has to come out as zero. None for
    arms of other kinds, for tasks other than these, for given joints that drives move which are
    solved for, and where every elimination fails.
    """
    if not is_general(chain) or not chain.is_given_alone:
        return None
    given = tuple((joint.sign, joint.offset) for joint in (chain.joints[n - 1] for n in chain.free))
    kernel = setup(loop_constants(chain), slides_of(chain))
    if kernel is None:
        return None
    numbers = *(joint.number for joint in chain.solved), chain.dof + 1, chain.dof + 2
    return replace(
        kernel,
        numbers=numbers[:JOINTS],
        given=given,
        given_shares=_given_shares(chain),
        pointing=_only_points(chain),
        checked=_missing(chain) > 0,
    )


def is_general(chain: Chain) -> bool:
    """Whether there are six joints to be solved for from poses, at most two of them slides.

    Or five from where the tool is and points to; or one less, of either.
    """
    asked = chain.task.kind in {TaskKind.POSE, TaskKind.POINTING}
    fits = _missing(chain) in {0, 1} and len(slides_of(chain)) <= SLIDES_OF_FOUR_TURNS
    return asked and fits


def slides_of(chain: Chain) -> tuple[int, ...]:
    """Which of the joints that are solved for slide, from 0."""
    kinds = enumerate(joint.kind for joint in chain.solved)
    return tuple(place for place, kind in kinds if kind is JointKind.PRISMATIC)


def loop_constants(chain: Chain) -> list[Link]:
    """C0 ... C6 of T = C0 J1 C1 ... J6 C6, base and tool included, J of joints that are solved for.

    The last one is the tool's turn about its own axis where it only points; the one before that, or
    the last one, the turn that has to be zero where the arm has a joint too few for the task.
    Multiplied one after the other in plain floating point, so that every machine gets the same.
    """
    arm = numeric_arm(chain)
    links = [Link(_matrix(arm.base))]
    for element in arm.elements:
        if not isinstance(element, int):
            links[-1] = links[-1].between(IDENTITY, _matrix(element))
            continue
        joint = chain.joints[element - 1]
        if joint.number in chain.free:
            links[-1] = _with_held(links[-1], joint, chain.free.index(joint.number))
        else:
            links.append(Link(IDENTITY))
    links[-1] = links[-1].between(IDENTITY, _matrix(arm.tool))
    if _missing(chain):
        links = with_virtual_joint(links, chain.size)
    return [*links, Link(IDENTITY)] if _only_points(chain) else links


def _given_shares(chain: Chain) -> tuple[tuple[float, ...], ...]:
    """What given values add to each joint that is given; empty where none adds to another's."""
    joints = [chain.joints[number - 1] for number in chain.free]
    if not any(joint.shares for joint in joints):
        return ()
    factors = [{share.drive: float(share.factor) for share in joint.shares} for joint in joints]
    return tuple(tuple(own.get(number, 0.0) for number in chain.free) for own in factors)


def _only_points(chain: Chain) -> bool:
    return chain.task.kind is TaskKind.POINTING


def _missing(chain: Chain) -> int:
    """How many joints too few there are for the task; a tool that only points turns as it likes."""
    return JOINTS - len(chain.solved) - _only_points(chain)


def _matrix(array: FloatArray) -> Matrix:
    return tuple(tuple(row) for row in array.tolist())


def _with_held(link: Link, joint: ChainJoint, place: int) -> Link:
    held = Held(place, joint.kind is JointKind.PRISMATIC, 1.0)
    return Link(link.first, (*link.rest, (held, IDENTITY)))
