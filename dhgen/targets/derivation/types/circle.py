"""Type 9: two equations linear in two angles; the unit circle of one leaves a quartic."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum
from dhgen.targets.derivation.blocks import display, paragraph
from dhgen.targets.derivation.formula import (
    ZERO,
    Call,
    Formula,
    add,
    equal,
    number,
    over,
    square,
    subtract,
    times,
)
from dhgen.targets.derivation.names import cosine, letter, sine, theta
from dhgen.targets.derivation.step_context import StepText, type_letter

if TYPE_CHECKING:
    from dhgen.kinematics.constants import Polynomial
    from dhgen.targets.derivation.blocks import Block
    from dhgen.targets.derivation.step_context import StepContext

P1, Q1, R1, P2, Q2, R2 = (type_letter(name) for name in ("P1", "Q1", "R1", "P2", "Q2", "R2"))


def print_circle(context: StepContext) -> StepText:
    """The polynomial in the angle that stays, and how many roots it has."""
    kept = context.angle
    gone = _eliminated(context)
    c, s = cosine(gone), sine(gone)
    letters = ((P1, Q1, R1), (P2, Q2, R2))
    rows = [equal(add(times(p, c), times(q, s), r), ZERO) for p, q, r in letters]
    parts = [f"{x}{n}{part}" for x in "PQ" for n in "12" for part in "cs"]
    known = not any(context.polynomial(part) for part in parts)
    half = letter("x", "x")
    tangent = equal(half, Call("tan", (over(theta(kept), number(2)),)))
    names = (cosine(kept), sine(kept), tangent, half, theta(kept), theta(gone))
    blocks: list[Block] = [
        paragraph("These are {} and {}, where {} occurs in", *rows, theta(kept)),
        display(*(_definition(context, f"{x}{n}") for n in "12" for x in "PQR")),
        paragraph(
            "Solved for {} and {} by Cramer's rule, the sum of their squares is 1, and {} drops "
            "out:",
            c,
            s,
            theta(gone),
        ),
        display(_condition(known=known)),
        paragraph(
            "This is of degree 2 in {} and {}. With {} it is an equation of degree 4 in {}, and "
            "its real roots, at most four, give {}; {} follows for each of them.",
            *names,
        ),
        paragraph("No solution when it has no real root; where two roots meet they count once."),
    ]
    return StepText(tuple(blocks))


def _eliminated(context: StepContext) -> AngleSum:
    unknowns = context.step.forms[0].unknowns
    angles = [u for u in unknowns if isinstance(u, AngleSum) and u != context.angle]
    return angles[0]


def _definition(context: StepContext, name: str) -> Formula:
    """P_1 = its known part + what multiplies c_j + what multiplies s_j."""
    algebra = context.story.algebra
    c, s = (algebra.generator(n) for n in (context.angle.cosine, context.angle.sine))
    whole: Polynomial = context.polynomial(name)
    whole = whole + context.polynomial(name + "c") * c + context.polynomial(name + "s") * s
    return equal(
        type_letter(name), context.story.write(whole), context.story.write(whole, context.number)
    )


def _condition(*, known: bool) -> Formula:
    if not known:
        return equal(add(square(R1), square(R2)), add(square(P1), square(Q1)))
    return equal(
        add(
            square(subtract(times(Q1, R2), times(Q2, R1))),
            square(subtract(times(R1, P2), times(R2, P1))),
        ),
        square(subtract(times(P1, Q2), times(Q1, P2))),
    )
