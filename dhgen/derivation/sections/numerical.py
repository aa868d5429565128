"""What is said of an arm that is solved numerically: the iteration, and what it does not say."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.sections.size import size_in_words
from dhgen.derivation.text.blocks import Display, Heading, Paragraph, paragraph, say
from dhgen.derivation.text.formula import Symbol
from dhgen.numerical import kernel as constants

if TYPE_CHECKING:
    from dhgen.derivation.text.blocks import Block
    from dhgen.kinematics.chain import Chain
    from dhgen.numerical.kernel import NumericalKernel


def numerical_section(kernel: NumericalKernel, chain: Chain) -> list[Block]:
    """What replaces the steps of Paul's method."""
    why = (
        "The arm has more joints than its task fixes: a pose inside its reach has in general "
        "infinitely many solutions."
        if kernel.redundant
        else "No order of equations gives the joints one after the other, and no elimination is "
        "known to dhgen for an arm of this kind."
    )
    return [
        Heading(2, say("Inverse, numerically")),
        paragraph(
            f"{why} It is solved by iteration, as the robot file asks. What follows is not a "
            "derivation, and nothing proves that there are no solutions besides those found."
        ),
        Paragraph(
            say(
                "Let {} be the motion that the tool still lacks to the wanted pose: lengths "
                f"divided by the arm's size ({size_in_words(chain)}) and, where directions count, "
                "a rotation vector. Let {} be the rows of the Jacobian {} that the task names, "
                "with all lengths in units of that size. From a start the joints go by steps of "
                "damped least squares (C. W. Wampler, 1986). The damping {} is proportional to the "
                "squared miss (T. Sugihara, 2011), so that the last steps are Newton's:",
                Symbol("e", "e"),
                Symbol(r"\hat J", "J^"),
                Symbol("J", "J"),
                Symbol(r"\lambda", "λ"),
            ),
            say("1. A descent."),
        ),
        Display((_step(),)),
        *(_nearest() if kernel.redundant else _all(kernel)),
    ]


def _step() -> Symbol:
    return Symbol(
        r"\Delta q = \hat J^{T} (\hat J \hat J^{T} + \lambda I)^{-1} e, \qquad "
        rf"\lambda = {constants.DAMPING}\,\min(e \cdot e, 1) + 10^{{-13}}",
        f"Δq = J^ᵀ (J^ J^ᵀ + λ I)⁻¹ e,  λ = {constants.DAMPING} min(e·e, 1) + 1e-13",
    )


def _all(kernel: NumericalKernel) -> list[Block]:
    return [
        Paragraph(
            say(
                "The first start is the seed (joint values that the caller may give), the others "
                "fill the joint space evenly (M. Roberts, 2018). They are tried "
                f"{constants.STARTS} at a time, until a round finds nothing new, "
                f"{constants.ROUNDS} rounds at most; {kernel.rows} solutions are kept. A "
                f"solution misses its pose by {kernel.residual:.0e} at most. Rows are ordered by "
                "the first joint, then by the second and so on."
            ),
            say("2. The search."),
        ),
        Paragraph(
            say(
                "Where the joints can move in a direction without moving the tool, solutions are "
                "looked for on both sides along it. If there are any, the solution is one of a "
                "continuum: it is pulled along it towards the seed, and its status is FREE_JOINT."
            ),
            say("3. Singular poses."),
        ),
    ]


def _nearest() -> list[Block]:
    return [
        Paragraph(
            say(
                "Each step also goes half of the way to the seed (joint values that the caller may "
                "give, those beyond a limit put on it), as far as that does not move the tool; a "
                "joint that would exceed a limit is put on it and held. This is "
                f"done from the seed and from {constants.REDUNDANT_STARTS - 1} more starts, which "
                "fill the joint space evenly (M. Roberts, 2018). Row 0 is the solution nearest to "
                "the seed among those inside the limits, or among all if none is inside."
            ),
            say("2. The solution near the seed."),
        )
    ]
