"""The inverse of an arm without a closed form: the elimination in words, equations and numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.general.hidden_slide import UNIT
from dhgen.targets.derivation.sections.four_turns import four_turns
from dhgen.targets.derivation.sections.general_loop import (
    joint_symbol,
    loop_from_the_hidden_joint,
    loop_letters,
    loop_that_closes,
)
from dhgen.targets.derivation.sections.near import near_blocks
from dhgen.targets.derivation.sections.no_turn import check, one_more_turn
from dhgen.targets.derivation.sections.size import size_in_words
from dhgen.targets.derivation.text.blocks import Display, Heading, Paragraph, paragraph, say
from dhgen.targets.derivation.text.formula import Symbol
from dhgen.targets.derivation.text.words import joined, numeral

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain
    from dhgen.targets.derivation.text.blocks import Block


PHI, HALF = Symbol(r"\varphi", "φ"), Symbol(r"\tan\frac{\varphi}{2}", "tan(φ/2)")
POINTING = (
    "The task names where the tool is and where its z axis points, and leaves its turn about that "
    "axis open. That turn, {}, is taken as a sixth joint behind the tool: with any choice of the x "
    "and y axes the pose is then complete, and the value of the sixth joint is not needed."
)
OFFSET_WRIST = (
    "This arm has an offset wrist: axes 1 and 2 and axes 4 and 5 meet at right angles, axes 2 and "
    "3 are parallel. Its polynomial in {} is known in closed form and is tried first; no "
    "determinant is needed where it succeeds."
)
UNRELATED = "No three neighbouring axes are parallel or meet in one point"


def general_section(kernel: GeneralKernel, chain: Chain, unit: str) -> list[Block]:
    """What replaces the steps of Paul's method; `unit` is that of lengths."""
    blocks: list[Block] = [
        Heading(2, say("Inverse")),
        paragraph(f"{_why(kernel)} {_most(kernel)}"),
        *([paragraph(POINTING, joint_symbol(kernel, 5))] if kernel.pointing else []),
        *([one_more_turn(kernel)] if kernel.checked else []),
        *near_blocks(chain, unit),
        Paragraph(
            say("The forward model is a loop that closes:"),
            say("The loop."),
        ),
        Display((loop_that_closes(kernel),)),
        loop_letters(kernel),
    ]
    if kernel.eliminations:
        blocks += [*_elimination(kernel), *_polynomial(kernel, chain), _null_vectors()]
    else:
        blocks += four_turns(kernel)
    return [*blocks, *_rest(kernel), *([check(kernel, chain)] if kernel.checked else [])]


def _why(kernel: GeneralKernel) -> str:
    """Why the joints do not come one after the other, and what finds them."""
    kinds = "1 to 11" if kernel.eliminations and not kernel.pointing else "1 to 8, 10 and 11"
    steps = f"no order of equations of the types {kinds} gives the joints one after the other."
    if kernel.eliminations:
        beginning = steps.capitalize() if kernel.pointing else f"{UNRELATED}, and {steps}"
        return (
            f"{beginning} {_joints(kernel)} are found together{_given(kernel)}, by the "
            "elimination of M. Raghavan and B. Roth (1993)."
        )
    return (
        f"{steps.capitalize()} {_joints(kernel)}, four turns and two slides, are found "
        f"together{_given(kernel)}: the directions give three turns by the fourth, and the "
        "position an equation in that one."
    )


def _most(kernel: GeneralKernel) -> str:
    count = "sixteen" if kernel.eliminations else "eight"
    if kernel.checked:  # the arm itself has fewer as a rule, as `one_more_turn` says
        return f"Together they have at most {count} solutions."
    return f"An arm of this kind has at most {count} solutions."


def _joints(kernel: GeneralKernel) -> str:
    joints = f"the {numeral(kernel.asked)} joints"
    others = ["a turn behind them"] * kernel.checked + ["the tool's turn"] * kernel.pointing
    return joined([joints, *others]).capitalize()


def _given(kernel: GeneralKernel) -> str:
    """What the other joints are for."""
    others = sorted(set(range(1, 7 + len(kernel.given))) - set(kernel.numbers))
    if not others:
        return ""
    if len(others) == 1:
        return f" while joint {others[0]} keeps the value that the caller gives"
    return f" while joints {', '.join(map(str, others))} keep the values that the caller gives"


def _elimination(kernel: GeneralKernel) -> list[Block]:
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
                f"With the {_variables(kernel)} of {{}} and {{}}, and each equation also "
                "multiplied by the first of them, there are twelve linear equations in twelve "
                "monomials. They have a solution where the determinant vanishes,",
                one,
                two,
            ),
            say("2. One polynomial."),
        ),
        Display(
            (
                Symbol(
                    r"f(\varphi) = \det M(\varphi) = \sum_{m=0}^{8} a_m \cos m\varphi + "
                    r"b_m \sin m\varphi = 0,",
                    "f(φ) = det M(φ) = Σ a_m cos mφ + b_m sin mφ = 0,  m = 0 … 8,",
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
    if kernel.wrist is not None:
        blocks.append(paragraph(OFFSET_WRIST, joint_symbol(kernel, 5)))
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
    if kernel.slides_beside:
        return "half-angle tangent and the length"
    return "half-angle tangents"


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


def _rest(kernel: GeneralKernel) -> list[Block]:
    others = [joint_symbol(kernel, each.joints[0]) for each in kernel.formulations[1:]]
    blocks: list[Block] = [
        Paragraph(
            say(
                "A simple root belongs to one solution and a double root to two. If as many have "
                "been found, and their number is even, none is missing. Otherwise "
                + (
                    f"the same is done with {', then with '.join('{}' for _ in others)} in the "
                    f"place of {{}}, and then from a nearby pose."
                    if others
                    else "the search is repeated from a nearby pose and followed back."
                ),
                *others,
                *([joint_symbol(kernel, kernel.first.joints[0])] if others else []),
            ),
            say("4. The certificate."),
        ),
        paragraph(
            "Rows are ordered by the value of joint 1, then of joint 2 and so on. Where roots meet "
            "or the certificate fails, damped least squares from the seed (joint values that the "
            "caller may give) and from a few evenly spread starts add what they find. Where the "
            "arm is singular, a solution may be double or belong to a continuum: then it is pulled "
            "along the continuum towards the seed, and its status is FREE_JOINT."
        ),
    ]
    return blocks
