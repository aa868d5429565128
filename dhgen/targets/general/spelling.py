"""What C writes for joints that slide, and for joints whose values the caller gives."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.general.formulation import PARTNERS

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel


@dataclass(frozen=True, slots=True)
class CSpelling:
    """What C99 writes.

    Attributes:
        is_slide: Whether `joint` slides.
        sine_of_start: What goes with the cosine of `angle`, of joint i.
        partner_2: The powers that phi_2 comes in: of a half tangent, or of a length.
        partner_3: The same for phi_3.
        hidden: What phi_1 comes in: cosine and sine.
        free_parameter: Declares the values that the caller gives.
        free_argument: Hands them on.
    """

    is_slide: str
    sine_of_start: str
    partner_2: str
    partner_3: str
    hidden: str
    free_parameter: str
    free_argument: str


def c_spelling(kernel: GeneralKernel, name: str) -> CSpelling:
    """What C99 writes for an arm."""
    slides, given = kernel.loop.slides, len(kernel.given)
    partner_2, partner_3 = (_partner(kernel, name, place) for place in PARTNERS)
    return CSpelling(
        is_slide=" || ".join(f"joint == {place}" for place in slides),
        sine_of_start=f"{name}_slides(i) ? angle : sin(angle)" if slides else "sin(angle)",
        partner_2=partner_2,
        partner_3=partner_3,
        hidden=f"{name}_{'on_circle' if kernel.hides_a_slide else 'cosines'}",
        free_parameter=f", const double free_joints[{given}]" if given else "",
        free_argument=", free_joints" if given else "",
    )


def _partner(kernel: GeneralKernel, name: str, place: int) -> str:
    if kernel.slides_beside:
        return f"{name}_slides(form->joint[{place}]) ? {name}_lengths : {name}_tangents"
    return f"{name}_tangents"
