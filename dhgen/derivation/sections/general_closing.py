"""The last sections for an arm without a closed form: singular configurations, the cost."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.text.blocks import Heading, paragraph, say
from dhgen.derivation.text.formula import ZERO, Symbol, equal
from dhgen.general.circle import SAMPLES

if TYPE_CHECKING:
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.general.kernel import GeneralKernel

JACOBIAN, DETERMINANT = Symbol("J", "J"), Symbol(r"\det J", "det J")
SINGULAR = (
    "A configuration is singular where {}. A solution there may be double or belong to a "
    "continuum: then it is pulled along the continuum towards the seed, and its status is "
    "FREE_JOINT."
)
MEETING = " Where two solutions meet, so do roots of the polynomial."
DETERMINANTS = (
    f"For a pose the determinant of twelve rows is evaluated at {SAMPLES} angles, and where its "
    f"roots crowd together at {SAMPLES} more. Every real root then takes a null vector, a small "
    "linear system and Newton steps. How long that is depends on the pose: on how many real roots "
    "there are, and on whether the certificate holds; each time that it does not, about as much is "
    "done again."
)
CLOSED = (
    " Where the closed form for the offset wrist succeeds, no determinant is evaluated: this form "
    "takes its place at these angles."
)
FOUR_TURNS = (
    f"For a pose the polynomial is evaluated at {SAMPLES} angles, and where its roots crowd "
    f"together at {SAMPLES} more; no determinant of the whole loop is needed. Every real root then "
    "takes two linear equations and Newton steps. How long that is depends on the pose: on how "
    "many real roots there are, and on whether the certificate holds; each time that it does not, "
    "about as much is done again."
)


def general_closing(kernel: GeneralKernel) -> list[Block]:
    """Where solutions meet, and what a pose takes."""
    cost = DETERMINANTS if kernel.eliminations else FOUR_TURNS
    return [
        Heading(2, say("Singular configurations")),
        paragraph(SINGULAR + ("" if kernel.checked else MEETING), _where(kernel)),
        Heading(2, say("Cost")),
        paragraph(cost + (CLOSED if kernel.wrist is not None else "")),
    ]


def _where(kernel: GeneralKernel) -> Prose:
    """What the Jacobian is there."""
    moving = "the joints can move, to first order, without moving"
    if kernel.pointing:
        return say(f"{moving} the tool's origin or turning its z axis")
    if kernel.given:
        text = "the columns of {} of the joints that are not given are linearly dependent: there "
        return say(f"{text}{moving} the tool", JACOBIAN)
    if kernel.checked:
        text = "the columns of {} are linearly dependent: there "
        return say(f"{text}{moving} the tool", JACOBIAN)
    return say(f"{{}}: there {moving} the tool", equal(DETERMINANT, ZERO))
