"""Type 9: two equations linear in two angles; the unit circle of one leaves a quartic."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.effects import free_effect, nothing_said
from dhgen.derivation.notation.names import DET_J, cosine, letter, sine, theta
from dhgen.derivation.step_context import Singularity, StepText, type_letter
from dhgen.derivation.text.blocks import display, paragraph, say
from dhgen.derivation.text.formula import (
    ZERO,
    Call,
    Formula,
    Power,
    Symbol,
    add,
    equal,
    number,
    over,
    square,
    subtract,
    times,
)
from dhgen.derivation.text.template import blocks_of
from dhgen.derivation.types.lost_equation import lost_where
from dhgen.derivation.velocity.determinant import OF_VELOCITY, determinant_of
from dhgen.kinematics.algebra import AngleSum
from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from dhgen.derivation.step_context import StepContext
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.kinematics.constants import Polynomial

P1, Q1, R1, P2, Q2, R2 = (type_letter(name) for name in ("P1", "Q1", "R1", "P2", "Q2", "R2"))
V1, V2 = (type_letter(name) for name in ("V1", "V2"))
I = Symbol("i", "i")
HALF = letter("x", "x")
JACOBIAN = Symbol("J", "J")


def print_circle(context: StepContext) -> StepText:
    """The polynomial in the angle that remains, and how many roots it has."""
    kept = context.angle
    gone = _eliminated(context)
    c, s = cosine(gone), sine(gone)
    letters = ((P1, Q1, R1), (P2, Q2, R2))
    rows = [equal(add(times(p, c), times(q, s), r), ZERO) for p, q, r in letters]
    blocks: list[Block] = [
        paragraph("These are {} and {}, with {} as the only unknown in", *rows, theta(kept)),
        display(*(_definition(context, f"{x}{n}") for n in "12" for x in "PQR")),
        *_elimination(context, c, s, gone),
        *blocks_of(
            "quartic",
            kept=theta(kept),
            cosine=cosine(kept),
            sine=sine(kept),
            tangent=equal(HALF, Call("tan", (over(theta(kept), number(2)),))),
            half=HALF,
            fourth=Power(HALF, 4),
            follows=_follows(context, gone),
            gone=theta(gone),
        ),
    ]
    met = _met(context)
    text = "No solution when it has no real root. Where {}, {}{}; {}."
    also = say("") if met.joints is None else say(", and {}", met.joints)
    blocks.append(paragraph(text, met.condition, met.meaning, also, met.effect))
    free = Singularity(
        context.number,
        _vanishing(context),
        None,
        say(nothing_said(context), theta(kept)),
        free_effect(context),
        frees=True,
    )
    text = "Degenerate when {}: {}. Then {}."
    blocks.append(paragraph(text, free.condition, free.meaning, free.effect))
    return StepText(tuple(blocks), (met, free))


def _vanishing(context: StepContext) -> Prose:
    """Where the equation says nothing, and an example of it where that has a name."""
    names = [f"{x}{n}" for n in "12" for x in "PQR"]
    parts = [context.polynomial(name + part) for name in names for part in "cs"]
    (joint, _), *others = context.angle.terms
    where = None
    if not (others or context.step.has("V1x")):
        rest = [context.polynomial(name) for name in names]
        where = lost_where(context.story, joint, [each for each in parts if each], rest)
    if where is None:
        return say("all coefficients of the equation vanish at once")
    return say(
        "all coefficients of the equation vanish at once, for instance where {} in a pose that can "
        "be reached",
        where,
    )


def _met(context: StepContext) -> Singularity:
    """Where two roots meet, with them two solutions."""
    return Singularity(
        context.number,
        say("two roots of the equation meet"),
        _singular(context),
        say("two solutions become one"),
        say("they count once, and the rows of the last roots stay empty"),
    )


def _singular(context: StepContext) -> Formula | Prose | None:
    """Where the arm is singular, in short."""
    chain = context.story.algebra.chain
    if chain.dof != chain.task.dimension:
        return None
    if chain.task.kind is TaskKind.POSE:
        return say("{}", equal(DET_J, ZERO))
    found = determinant_of(context.story)
    if chain.task.kind is not TaskKind.POSITION:
        return None if found is None else say("{}", equal(DET_J, ZERO))
    vanishing = [each for each in found.factors if not each.is_never_zero] if found else []
    if len(vanishing) == 1 and vanishing[0].formula != OF_VELOCITY:
        return equal(vanishing[0].formula, ZERO)
    return say("the determinant of the first three rows of {} is zero", JACOBIAN)


def _eliminated(context: StepContext) -> AngleSum:
    unknowns = context.step.forms[0].unknowns
    angles = [u for u in unknowns if isinstance(u, AngleSum) and u != context.angle]
    return angles[0]


def _follows(context: StepContext, gone: AngleSum) -> bool:
    """Whether a root leaves one value of the other angle."""
    later = context.story.steps[context.number :]
    return all(step.roots == 1 for step in later if gone in step.unknowns)


def _definition(context: StepContext, name: str) -> Formula:
    """P_1 = its known part + what multiplies c_j + what multiplies s_j."""
    algebra = context.story.algebra
    c, s = (algebra.generator(n) for n in (context.angle.cosine, context.angle.sine))
    whole: Polynomial = context.polynomial(name)
    whole = whole + context.polynomial(name + "c") * c + context.polynomial(name + "s") * s
    return equal(
        type_letter(name), context.in_full(whole), context.story.write(whole, context.number)
    )


def _elimination(context: StepContext, c: Formula, s: Formula, gone: AngleSum) -> list[Block]:
    """How the other angle drops out."""
    step = context.step
    if not step.has("V1x"):
        text = "Cramer's rule gives {} and {}. Their squares add up to 1, so {} drops out:"
        return [paragraph(text, c, s, theta(gone)), display(_by_cramer())]
    ring = context.story.algebra.ring
    if (step.coefficient("V1x"), step.coefficient("V1y")) == (ring.one, ring.zero):
        text = (
            "{} is {} turned by a right angle. So the two equations give, up to signs, the "
            "elements of {} turned by {}. A turn does not change its length:"
        )
        first, second = (
            Symbol(f"(P_{n}, Q_{n})", f"(P{sub}, Q{sub})") for n, sub in (("1", "₁"), ("2", "₂"))
        )
        turned = equal(add(square(R1), square(R2)), add(square(P1), square(Q1)))
        return [paragraph(text, second, first, first, theta(gone)), display(turned)]
    text = (
        "{} and {} are the same vector, turned and stretched by known amounts. As complex "
        "numbers, {} with"
    )
    vectors = [add(p, times(I, q)) for p, q in ((P1, Q1), (P2, Q2))]
    same = equal(times(vectors[0], V2), times(vectors[1], V1))
    known = [
        equal(v, context.story.write(context.polynomial(f"{name}x"), context.number))
        for v, name in ((Call("Re", (V1,)), "V1"), (Call("Re", (V2,)), "V2"))
    ]
    known += [
        equal(v, context.story.write(context.polynomial(f"{name}y"), context.number))
        for v, name in ((Call("Im", (V1,)), "V1"), (Call("Im", (V2,)), "V2"))
    ]
    size = Symbol(
        r"\lvert V_1 \rvert^2 \lvert R_1 V_2 - R_2 V_1 \rvert^2", "|V₁|² |R₁ V₂ − R₂ V₁|²"
    )
    apart = Symbol(r"\mathrm{Im}(V_1 \overline{V_2})^2", "Im(V₁ V̄₂)²")
    condition = equal(size, times(apart, add(square(P1), square(Q1))))
    return [
        paragraph(text, *vectors, same),
        display(*known),
        paragraph("The size of that vector does not depend on {}, which gives", theta(gone)),
        display(condition),
    ]


def _by_cramer() -> Formula:
    return equal(
        add(
            square(subtract(times(Q1, R2), times(Q2, R1))),
            square(subtract(times(R1, P2), times(R2, P1))),
        ),
        square(subtract(times(P1, Q2), times(Q1, P2))),
    )
