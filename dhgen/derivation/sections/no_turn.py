"""A joint too few for the task, in words: the turn that the arm does not have, and the check."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.sections.general_loop import joint_symbol
from dhgen.derivation.sections.size import size_in_words
from dhgen.derivation.text.blocks import Paragraph, paragraph, say
from dhgen.derivation.text.formula import Symbol
from dhgen.derivation.text.words import numeral
from dhgen.general.no_turn import NEARLY_NONE, NEARLY_NONE_IN_DOUBT
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from dhgen.derivation.text.blocks import Block
    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain


def one_more_turn(kernel: GeneralKernel) -> Block:
    """Where the joint of the loop comes from that is none of the arm's."""
    count = kernel.asked
    last, turn = joint_symbol(kernel, count - 1), joint_symbol(kernel, count)
    return paragraph(
        f"The task names {numeral(count + 1)} numbers and the arm has {numeral(count)} joints: it "
        "cannot take most poses, and usually takes one that it can in a single way. To find that "
        "way, an imaginary further joint, {}, is put between {} and the tool. It turns about an "
        "axis that was chosen freely, skew to that of {}: a constant transform {} leads to it, and "
        "{} leads back. With it, the arm can take all nearby poses too. The solutions of the arm "
        "are those in which {} comes out as zero.",
        turn,
        last,
        last,
        *(Symbol("W", "W"), Symbol("W^{-1}", "W⁻¹")),
        turn,
    )


def check(kernel: GeneralKernel, chain: Chain) -> Block:
    """Which solutions of the loop are solutions of the arm."""
    turn = joint_symbol(kernel, kernel.asked)
    return Paragraph(
        say(
            f"Solutions in which {{}} is larger than {NEARLY_NONE:g} rad are set aside, or larger "
            f"than {NEARLY_NONE_IN_DOUBT:g} rad where the certificate fails or solutions meet. In "
            "the others it is dropped, and damped least squares take the arm's joints to where "
            "they miss the pose least. Because a pose may have been rounded, they count if they "
            f"miss it by no more than {_power(TOLERANCES.consistent)}, angles in rad and lengths "
            f"divided by the arm's size ({size_in_words(chain)}); but if one misses it by less "
            f"than {_power(TOLERANCES.polished)}, the pose was not rounded, and all have to come "
            "as close. If none is left, the same is tried from the seed and from a few evenly "
            "spread starts before the pose is UNREACHABLE.",
            turn,
        ),
        say("5. The check."),
    )


def _power(value: float) -> str:
    """A power of ten, without the zero that Python puts before its exponent."""
    return f"{value:.0e}".replace("e-0", "e-")
