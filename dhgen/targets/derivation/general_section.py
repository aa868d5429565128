"""The inverse of an arm without a closed form: the elimination in words, equations and numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.paul.refusal import near_structure
from dhgen.targets.derivation.blocks import Display, Heading, Paragraph, paragraph, say
from dhgen.targets.derivation.formula import Symbol

if TYPE_CHECKING:
    from dhgen.general.formulation import Formulation
    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain
    from dhgen.targets.derivation.blocks import Block


def general_section(kernel: GeneralKernel, chain: Chain, unit: str) -> list[Block]:
    """What replaces the steps of Paul's method; `unit` is that of lengths."""
    near = near_structure(chain)
    blocks: list[Block] = [
        Heading(2, say("Inverse")),
        paragraph(
            "No three neighbouring axes are parallel or meet in one point, and no order of "
            "equations of the types 1 to 9 gives the joints one after the other. The six joints "
            f"are found together{_given(kernel)}, by the elimination of M. Raghavan and B. Roth "
            "(1993). An arm of this kind has at most sixteen solutions."
        ),
        *(
            [paragraph(f"Near to a closed form: {'; '.join(near)} (lengths in {unit}).")]
            if near
            else []
        ),
        Paragraph(
            say(
                "With the constant transforms between the joints' axes the forward model is a loop "
                "that closes:"
            ),
            say("The loop."),
        ),
        Display((_loop(kernel),)),
    ]
    blocks += _elimination(kernel)
    blocks += _polynomial(kernel)
    blocks += _rest(kernel)
    return blocks


def _given(kernel: GeneralKernel) -> str:
    """What the other joints are for."""
    others = sorted(set(range(1, 7 + len(kernel.given))) - set(kernel.numbers))
    if not others:
        return ""
    if len(others) == 1:
        return f" while joint {others[0]} keeps the value that the caller gives"
    return f" while joints {', '.join(map(str, others))} keep the values that the caller gives"


def _loop(kernel: GeneralKernel) -> Symbol:
    joints = [_motion(kernel, place) for place in range(6)]
    links = [rf"{symbol.latex}\,K_{k}" for k, symbol in enumerate(joints[:5])]
    plain = " ".join(f"{symbol.text} K{k}" for k, symbol in enumerate(joints[:5]))
    return Symbol(
        rf"{' '.join(links)}\,{joints[5].latex} = P, "
        r"\qquad P = C_0^{-1}\,\mathit{POS}\,C_6^{-1}",
        f"{plain} {joints[5].text} = P,  P = C0⁻¹ POS C6⁻¹",
    )


def _motion(kernel: GeneralKernel, place: int) -> Symbol:
    number = kernel.numbers[place]
    if place == kernel.loop.slide:
        return Symbol(f"T_z(d_{number})", f"Tz(d{number})")
    return Symbol(rf"R_z(\theta_{number})", f"Rz(θ{number})")


def _elimination(kernel: GeneralKernel) -> list[Block]:
    first = kernel.first
    hidden, one, two = (_joint(kernel, first, place) for place in (0, 1, 2))
    return [
        Paragraph(
            say(
                "Let three joints, {}, {} and {}, stand on the left and the others on the right. "
                "Let l and p be the third and fourth column of a side. The fourteen features",
                hidden,
                one,
                two,
            ),
            say("1. Fourteen equations."),
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
            "are the same on both sides. On the left they are linear in 1, cos and sin of {} with "
            "nine monomials of {} and {}; on the right one joint does not occur at all and eight "
            "monomials of two joints remain. Eliminating these eight leaves six equations in the "
            "three joints of the left side.",
            hidden,
            one,
            two,
        ),
    ]


def _polynomial(kernel: GeneralKernel) -> list[Block]:
    hidden, one, two = (_joint(kernel, kernel.first, place) for place in (0, 1, 2))
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
            "a trigonometric polynomial of degree 8 in φ, the angle of {}. Its coefficients come "
            "from its values at 24 angles; all its real roots are isolated by bounds on the "
            "circle.",
            hidden,
        ),
    ]
    if kernel.wrist is not None:
        blocks.append(
            paragraph(
                "This arm has an offset wrist: axes 1 and 2 and axes 4 and 5 meet at right angles, "
                "axes 2 and 3 are parallel. Its polynomial in θ6 is known in closed form and is "
                "tried first; no determinant is needed where it succeeds."
            )
        )
    return blocks


def _variables(kernel: GeneralKernel) -> str:
    slides = kernel.loop.slide is not None
    return "half-angle tangent and the length" if slides else "half-angle tangents"


def _rest(kernel: GeneralKernel) -> list[Block]:
    second = kernel.second
    blocks: list[Block] = [
        Paragraph(
            say(
                "For every root the null vector of the matrix gives the next two joints, a small "
                "linear system two more, and what is left of the loop the last one. Newton steps "
                "on the loop bring each solution to rounding, and a solution counts only if the "
                "loop closes."
            ),
            say("3. The other joints."),
        ),
        Paragraph(
            say(
                "Every simple root owns a solution, every double one two, and the number of "
                "solutions is even; otherwise "
                + (
                    "the search is repeated from a pose nearby and followed back."
                    if second is None
                    else "the same is done with {} hidden, and then from a pose nearby."
                ),
                *(() if second is None else (_joint(kernel, second, 0),)),
            ),
            say("4. The certificate."),
        ),
        paragraph(
            "Rows are ordered by the value of joint 1, then of joint 2 and so on. Where roots meet "
            "or the certificate is missing, damped least squares from the seed and from a few "
            "evenly spread starts add what they find. Where the arm is singular, a solution may be "
            "double, or one of a continuum: then it is pulled along the continuum towards the "
            "seed, and its status is FREE_JOINT."
        ),
    ]
    return blocks


def _joint(kernel: GeneralKernel, formulation: Formulation, place: int) -> Symbol:
    joint = formulation.joints[place]
    number = kernel.numbers[joint]
    if joint == kernel.loop.slide:
        return Symbol(f"d_{number}", f"d{number}")
    return Symbol(rf"\theta_{number}", f"θ{number}")
