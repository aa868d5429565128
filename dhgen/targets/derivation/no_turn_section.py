"""Five joints that take whole poses, in words: the turn that they don't have, and the check."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.general.no_turn import NEARLY_NONE
from dhgen.program.tolerances import TOLERANCES
from dhgen.targets.derivation.blocks import Paragraph, paragraph, say
from dhgen.targets.derivation.general_loop import joint_symbol

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel
    from dhgen.targets.derivation.blocks import Block


def one_more_turn(kernel: GeneralKernel) -> Block:
    """Where the sixth joint of the loop comes from."""
    *_, fifth, sixth = (joint_symbol(kernel, place) for place in range(6))
    return paragraph(
        "A pose takes six numbers and the joints are five: most poses the arm cannot take, and "
        "those that it can take it usually takes in one way. To find that way, a sixth joint that "
        "the arm does not have, {}, stands between {} and the tool, about an axis that was chosen "
        "freely, skew to the fifth: the transform W leads to it, and W⁻¹ back. With it the arm "
        "takes every pose nearby, too. The solutions of the arm are those in which {} comes out "
        "as zero.",
        sixth,
        fifth,
        sixth,
    )


def check(kernel: GeneralKernel) -> Block:
    """Which solutions of the six joints are solutions of the five."""
    sixth = joint_symbol(kernel, 5)
    return Paragraph(
        say(
            f"Solutions in which {{}} is above {NEARLY_NONE:g} rad are set aside. In the others it "
            "is dropped, and damped least squares take the five joints to where they miss the "
            f"pose least. They count if that is within {_power(TOLERANCES.consistent)} arm sizes "
            "and rad, because a pose may have been rounded; where one misses it by less than "
            f"{_power(TOLERANCES.polished)}, the pose was not, and all have to. If none is left, "
            "the seed and a few evenly spread starts are followed in the same way before the pose "
            "is UNREACHABLE.",
            sixth,
        ),
        say("5. The check."),
    )


def _power(value: float) -> str:
    """A power of ten, without the zero that Python puts before its exponent."""
    return f"{value:.0e}".replace("e-0", "e-")
