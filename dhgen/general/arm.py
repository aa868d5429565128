"""The general algorithm for a chain: whether it applies, and its constants."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from dhgen.general.links import Held, Link
from dhgen.general.loop import JOINTS
from dhgen.general.rigid import IDENTITY
from dhgen.general.setup import setup
from dhgen.kinematics.numeric import numeric_arm
from dhgen.robot.robot import JointKind, TaskKind

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.general.kernel import GeneralKernel
    from dhgen.general.rigid import Matrix
    from dhgen.kinematics.chain import Chain, ChainJoint

MOST_SLIDES = 1


def general_kernel(chain: Chain) -> GeneralKernel | None:
    """The kernel of an arm with six joints that are asked for, at most one of them a slide.

    The others are held at the values that the caller gives. None for arms of other kinds, for
    tasks other than poses, and where every elimination vanishes.
    """
    if not is_general(chain):
        return None
    solved = _solved(chain)
    slides = [place for place, joint in enumerate(solved) if joint.kind is JointKind.PRISMATIC]
    given = tuple((joint.sign, joint.offset) for joint in (chain.joints[n - 1] for n in chain.free))
    kernel = setup(loop_constants(chain), slides[0] if slides else None)
    numbers = tuple(joint.number for joint in solved)
    return None if kernel is None else replace(kernel, numbers=numbers, given=given)


def is_general(chain: Chain) -> bool:
    """Whether there are six joints to be solved for, at most one of them a slide, from poses."""
    solved = _solved(chain)
    slides = [joint for joint in solved if joint.kind is JointKind.PRISMATIC]
    whole = chain.task.kind is TaskKind.POSE
    return len(solved) == JOINTS and len(slides) <= MOST_SLIDES and whole


def _solved(chain: Chain) -> list[ChainJoint]:
    return [joint for joint in chain.joints if joint.number not in chain.free]


def joint_values(angles: NDArray[np.float64], chain: Chain) -> NDArray[np.float64]:
    """The values (k, 6) of the joints that are solved for, from the loop's angles and lengths."""
    solved = _solved(chain)
    signs = np.array([joint.sign for joint in solved])
    return np.asarray(signs * (angles - [joint.offset for joint in solved]))


def loop_constants(chain: Chain) -> list[Link]:
    """C0 ... C6 of T = C0 J1 C1 ... J6 C6, base and tool included, J of joints that are solved for.

    Multiplied one after the other in plain floating point, so that every machine gets the same.
    """
    arm = numeric_arm(chain)
    links = [Link(_matrix(arm.base))]
    for element in arm.elements:
        if not isinstance(element, tuple):
            links[-1] = links[-1].between(IDENTITY, _matrix(element))
            continue
        joint = chain.joints[element[0] - 1]
        if joint.number in chain.free:
            links[-1] = _with_held(links[-1], joint, chain.free.index(joint.number))
        else:
            links.append(Link(IDENTITY))
    links[-1] = links[-1].between(IDENTITY, _matrix(arm.tool))
    return links


def _matrix(array: NDArray[np.float64]) -> Matrix:
    return tuple(tuple(row) for row in array.tolist())


def _with_held(link: Link, joint: ChainJoint, place: int) -> Link:
    held = Held(place, joint.kind is JointKind.PRISMATIC, 1.0)
    return Link(link.first, (*link.rest, (held, IDENTITY)))
