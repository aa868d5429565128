"""The elimination of M. Raghavan and B. Roth, in words and equations."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.sections.general_loop import (
    joint_symbol,
    loop_from_the_hidden_joint,
)
from dhgen.derivation.sections.size import size_in_words
from dhgen.derivation.text.blocks import Display, Paragraph, paragraph, say
from dhgen.derivation.text.formula import Symbol
from dhgen.general.hidden_slide import UNIT

if TYPE_CHECKING:
    from dhgen.derivation.text.blocks import Block
    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain


PHI, HALF = Symbol(r"\varphi", "φ"), Symbol(r"\tan\frac{\varphi}{2}", "tan(φ/2)")


def elimination(kernel: GeneralKernel, chain: Chain) -> list[Block]:
    """The fourteen equations, the polynomial, and the other joints."""
    return [*_equations(kernel), *_polynomial(kernel, chain), _null_vectors()]


def _equations(kernel: GeneralKernel) -> list[Block]:
    first = kernel.first
    hidden, one, two, idle, *others = (joint_symbol(kernel, place) for place in first.joints)
    degree = (
        "quadratic in {}" if kernel.hides_a_slide else "linear in the cosine and the sine of {}"
    )
    return [
        Paragraph(
            say(
                "The loop is written with three joints, {}, {} and {}, on the left and the others "
                "on the right:",
                hidden,
                one,
                two,
            ),
            say("1. Fourteen equations."),
        ),
        Display((loop_from_the_hidden_joint(kernel),)),
        paragraph(
            "Let {} and {} be the third and fourth columns of a side; {} moves neither. The "
            "fourteen numbers in",
            Symbol("l", "l"),
            Symbol("p", "p"),
            idle,
        ),
        Display(
            (
                Symbol(
                    r"l,\quad p,\quad p \cdot p,\quad p \cdot l,\quad p \times l,\quad "
                    r"(p \cdot p)\,l - 2\,(p \cdot l)\,p",
                    "l,  p,  p·p,  p·l,  p×l,  (p·p) l − 2 (p·l) p",
                ),
            )
        ),
        paragraph(
            "are the same on both sides. On the left they are linear in nine monomials of {} and "
            f"{{}}, with coefficients {degree}; on the right they are linear in eight "
            "monomials of {} and {}. Eliminating these eight leaves six equations in the three "
            "joints on the left.",
            one,
            two,
            hidden,
            *others,
        ),
        *([_right_slide(kernel)] if kernel.slides_on_the_right else []),
    ]


def _right_slide(kernel: GeneralKernel) -> Block:
    (slide,) = kernel.loop.slides
    return paragraph(
        "{} slides, and stands on the right for a reason: with it on the left the determinant "
        "below would vanish for every angle, or at places that are no solutions.",
        joint_symbol(kernel, slide),
    )


def _polynomial(kernel: GeneralKernel, chain: Chain) -> list[Block]:
    hidden, one, two = (joint_symbol(kernel, kernel.first.joints[place]) for place in (0, 1, 2))
    blocks: list[Block] = [
        Paragraph(
            say(
                f"With {_variables(kernel)}, and each equation also multiplied by the first of "
                "them, there are twelve linear equations in twelve monomials. They have a solution "
                "where the determinant vanishes,",
                one,
                two,
            ),
            say("2. One polynomial."),
        ),
        Display(
            (
                Symbol(
                    r"f(\varphi) = \det M(\varphi) = \sum_{m=0}^{8} \lambda_m \cos m\varphi + "
                    r"\mu_m \sin m\varphi = 0,",
                    "f(φ) = det M(φ) = Σ λₘ cos mφ + μₘ sin mφ = 0,  m = 0 … 8,",
                ),
            )
        ),
        paragraph(
            f"a trigonometric polynomial of degree 8 in {{}}, the angle {_whose(kernel)} {{}}, and "
            "so of degree 16 in {}, with at most sixteen roots. Its "
            "coefficients come from its values at 24 angles. Where its roots crowd together, as "
            "they do near the boundary of the reach, so do these angles: a Möbius map of the "
            "circle spreads the roots. Bounds on the circle isolate all real roots.",
            PHI,
            hidden,
            HALF,
        ),
    ]
    if kernel.hides_a_slide:
        blocks.append(_hidden_slide(kernel, chain))
    return blocks


def _whose(kernel: GeneralKernel) -> str:
    return "that stands for" if kernel.hides_a_slide else "of"


def _hidden_slide(kernel: GeneralKernel, chain: Chain) -> Block:
    return paragraph(
        "With a turn in its place the determinant would vanish for every angle, or at places "
        f"that are no solutions; so it is the slide. {{}} is {UNIT:g} times the arm's size, "
        f"{size_in_words(chain)}, times the tangent of half an angle that differs from {{}} by a "
        "constant. The rows are then linear in {} and {}, and a polynomial of degree 16 or less in "
        "the length becomes one on the circle. The determinant has one more zero, where the length "
        "is infinite; it is divided out.",
        joint_symbol(kernel, kernel.first.joints[0]),
        PHI,
        Symbol(r"\cos \varphi", "cos φ"),
        Symbol(r"\sin \varphi", "sin φ"),
    )


def _variables(kernel: GeneralKernel) -> str:
    """In which the equations are polynomials: of both partners of the hidden joint."""
    slide = [place in kernel.loop.slides for place in kernel.first.joints[1:3]]
    if not any(slide):
        return "the half-angle tangents of {} and {}"
    return " and ".join(
        "the length {}" if each else "the half-angle tangent of {}" for each in slide
    )


def _null_vectors() -> Block:
    return Paragraph(
        say(
            "For every root the null vector of the matrix gives the next two joints, a small "
            "linear system gives two more, and what is left of the loop gives the last one. Newton "
            "steps on the loop refine each solution to rounding accuracy, and a solution counts "
            "only if the loop closes."
        ),
        say("3. The other joints."),
    )
