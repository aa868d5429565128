"""What each language writes for joints that slide, and for joints whose values the caller gives."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi
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


@dataclass(frozen=True, slots=True)
class PythonSpelling:
    """What Python writes.

    Attributes:
        slides: The places of the joints that slide, as a tuple.
        knows_slides: Whether anything slides, of what is solved for and what is given.
        sine_of_start: What goes with the cosine of joint i.
        circular_gap: How far apart two values of joint i are, whose difference is `gap`.
        free_type: The type of the values that the caller gives, before the others.
        free_argument: Hands them on.
        useless_type: The type of what says which formulations are not tried, before the others.
        useless_argument: Hands it on.
    """

    slides: str
    knows_slides: bool
    sine_of_start: str
    circular_gap: str
    free_type: str
    free_argument: str
    useless_type: str
    useless_argument: str


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


def python_spelling(kernel: GeneralKernel) -> PythonSpelling:
    """What Python writes for an arm."""
    slides, given = kernel.loop.slides, bool(kernel.given)
    held = any(each.slides for link in kernel.links for each, _ in link.rest)
    return PythonSpelling(
        slides=repr(slides),
        knows_slides=bool(slides) or held,
        sine_of_start=_unless_slide("q[i]", "math.sin(q[i])", slides),
        circular_gap=_unless_slide("gap", f"min(gap, {2 * pi!r} - gap)", slides),
        free_type="float64[::1], " if given else "",
        free_argument=", q_free" if given else "",
        useless_type="int64, " if kernel.vanishing else "",
        useless_argument=", useless" if kernel.vanishing else "",
    )


def _unless_slide(length: str, angle: str, slides: tuple[int, ...]) -> str:
    """What is written for joint i: one thing where it slides, another where it turns."""
    return f"{length} if i in {slides!r} else {angle}" if slides else angle
