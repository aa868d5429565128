"""The joints of a general arm and their loop, as formulas."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.text.formula import Symbol
from dhgen.kinematics.chain import Slide, Turn

if TYPE_CHECKING:
    from dhgen.general.formulation import Formulation
    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain


def loop_that_closes(kernel: GeneralKernel) -> Symbol:
    """The forward model as a loop."""
    joints = [_motion(kernel, place) for place in range(6)]
    links = [rf"{symbol.latex}\,K_{k}" for k, symbol in enumerate(joints[:5])]
    plain = " ".join(f"{symbol.text} K{k}" for k, symbol in enumerate(joints[:5]))
    return Symbol(
        rf"{' '.join(links)}\,{joints[5].latex} = P, "
        r"\qquad P = C_0^{-1}\,\mathit{POS}\,C_6^{-1}",
        f"{plain} {joints[5].text} = P,  P = C0⁻¹ POS C6⁻¹",
    )


def begin_with_motions(kernel: GeneralKernel, chain: Chain) -> bool:
    """Whether the transform between two joints is one link's constant part."""
    own = kernel.asked == len(chain.links) == len(kernel.numbers)
    return own and all(isinstance(link[0], Turn | Slide) for link in chain.links)


def _motion(kernel: GeneralKernel, place: int) -> Symbol:
    number = kernel.numbers[place]
    if place in kernel.loop.slides:
        return Symbol(f"T_z(r_{number})", f"Tz(r{number})")
    return Symbol(rf"R_z(\theta_{number})", f"Rz(θ{number})")


def loop_from_the_hidden_joint(kernel: GeneralKernel) -> Symbol:
    """The loop with three joints on the left, the hidden one first, and three on the right."""
    first = kernel.first
    turns = [_moved(kernel, joint, first.sign) for joint in first.joints]
    back = [_moved(kernel, joint, -first.sign) for joint in first.joints]
    links = [_link(first, joint) for joint in first.joints]
    undone = [_link(first, joint, undone=True) for joint in first.joints]
    left = [links[5], turns[0], links[0], turns[1], links[1], turns[2], links[2]]
    right = [back[5], undone[4], back[4], undone[3], back[3]]
    sides = left, right
    return Symbol(
        " = ".join(r"\,".join(each.latex for each in side) for side in sides),
        " = ".join(" ".join(each.text for each in side) for side in sides),
    )


def _link(first: Formulation, joint: int, *, undone: bool = False) -> Symbol:
    """The transform behind a joint, in the direction in which the loop is read; or its inverse."""
    number, inverted = first.behind(joint)
    name, inverse = "P" if number is None else f"K_{number}", inverted != undone
    return Symbol(name + "^{-1}" * inverse, name.replace("_", "") + "⁻¹" * inverse)


def _moved(kernel: GeneralKernel, place: int, sign: int) -> Symbol:
    """The motion of a joint, or back."""
    motion = _motion(kernel, place)
    if sign > 0:
        return motion
    return Symbol(motion.latex.replace("(", "(-"), motion.text.replace("(", "(−"))


def joint_symbol(kernel: GeneralKernel, place: int) -> Symbol:
    """The angle or length of a joint of the loop, from 0."""
    number = kernel.numbers[place]
    if place in kernel.loop.slides:
        return Symbol(f"r_{number}", f"r{number}")
    return Symbol(rf"\theta_{number}", f"θ{number}")
