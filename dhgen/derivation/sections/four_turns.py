"""The inverse of an arm with four turns and two slides, in words and equations."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.sections.general_loop import joint_symbol
from dhgen.derivation.text.blocks import Display, Paragraph, paragraph, say
from dhgen.derivation.text.formula import Symbol, minus

if TYPE_CHECKING:
    from dhgen.derivation.text.blocks import Block
    from dhgen.general.kernel import GeneralKernel

PHI, HALF = Symbol(r"\varphi", "φ"), Symbol(r"\tan\frac{\varphi}{2}", "tan(φ/2)")
BETA, GAMMA, DELTA = Symbol(r"\beta", "β"), Symbol(r"\gamma", "γ"), Symbol(r"\delta", "δ")
ROOT = Symbol(r"\sqrt{\Delta}", "√Δ")
M, N, G, W = (Symbol(each, each) for each in "MNgw")
_ROTATIONS = Symbol(
    r"R_z(\varphi)\,A\,R_z(\beta)\,B\,R_z(\gamma)\,C\,R_z(\delta)\,D = 1,",
    "Rz(φ) A Rz(β) B Rz(γ) C Rz(δ) D = 1,",
)
_LINKAGE = Symbol(
    r"R_z(\beta)\,N\,R_z(\delta) = M, \qquad N = B\,R_z(\gamma)\,C, \qquad "
    r"M = A^T R_z(-\varphi)\,D^T.",
    "Rz(β) N Rz(δ) = M,  N = B Rz(γ) C,  M = Aᵀ Rz(−φ) Dᵀ.",
)
_MIDDLE = (
    Symbol(
        r"b \cos\gamma + c \sin\gamma = k, \qquad b = B_{zx} C_{xz} + B_{zy} C_{yz}, \quad "
        r"c = B_{zy} C_{xz} - B_{zx} C_{yz}, \quad k = M_{zz} - B_{zz} C_{zz},",
        "b cos γ + c sin γ = k,  b = Bzx Cxz + Bzy Cyz,  c = Bzy Cxz − Bzx Cyz,  "
        "k = Mzz − Bzz Czz,",
    ),
    Symbol(
        r"\cos\gamma = \frac{b k - c \sqrt{\Delta}}{b^2 + c^2}, \quad "
        r"\sin\gamma = \frac{c k + b \sqrt{\Delta}}{b^2 + c^2}, \quad \Delta = b^2 + c^2 - k^2,",
        "cos γ = (b k − c √Δ) / (b² + c²),  sin γ = (c k + b √Δ) / (b² + c²),  Δ = b² + c² − k²,",
    ),
)
_OUTER = (
    Symbol(
        r"w \cos\beta = M_{xz} N_{xz} + M_{yz} N_{yz}, \quad "
        r"w \sin\beta = M_{yz} N_{xz} - M_{xz} N_{yz},",
        "w cos β = Mxz Nxz + Myz Nyz,  w sin β = Myz Nxz − Mxz Nyz,",
    ),
    Symbol(
        r"w \cos\delta = M_{zx} N_{zx} + M_{zy} N_{zy}, \quad "
        r"w \sin\delta = M_{zx} N_{zy} - M_{zy} N_{zx}, \quad w = 1 - M_{zz}^2.",
        "w cos δ = Mzx Nzx + Mzy Nzy,  w sin δ = Mzx Nzy − Mzy Nzx,  w = 1 − Mzz².",
    ),
)
_POLYNOMIAL = Symbol(
    r"f(\varphi) = w\,(U^2 - V^2 \Delta) = \sum_{m=0}^{4} \lambda_m \cos m\varphi + "
    r"\mu_m \sin m\varphi = 0,",
    "f(φ) = w (U² − V² Δ) = Σ λₘ cos mφ + μₘ sin mφ = 0,  m = 0 … 4,",
)


def four_turns(kernel: GeneralKernel) -> list[Block]:
    """The turns from the directions, the polynomial, and the lengths."""
    return [*_directions(kernel), *_polynomial(kernel), _lengths(kernel)]


def _symbols(kernel: GeneralKernel) -> tuple[list[Symbol], list[Symbol]]:
    """The turns, the hidden one first, and the slides, in the order of the loop from there on."""
    slides = kernel.loop.slides
    order = kernel.first.joints
    return (
        [joint_symbol(kernel, joint) for joint in order if joint not in slides],
        [joint_symbol(kernel, joint) for joint in order if joint in slides],
    )


def _directions(kernel: GeneralKernel) -> list[Block]:
    turns, _ = _symbols(kernel)
    return [
        Paragraph(
            say(
                "Slides do not change directions. Read once around, beginning with {}, the "
                "rotations of the loop are",
                turns[0],
            ),
            say("1. The directions."),
        ),
        Display((_ROTATIONS,)),
        paragraph(
            "where {}, {}, {} and {} are the angles of {}, {}, {} and {}, and {}, {}, {} and {} "
            "the rotations between them, one of which holds the pose. Once {} is known, so is {} "
            "in",
            *(PHI, BETA, GAMMA, DELTA),
            *turns,
            *(Symbol(each, each) for each in "ABCD"),
            PHI,
            M,
        ),
        Display((_LINKAGE,)),
        paragraph(
            "The last entries of the last rows of {} and {} are the same, which is an equation of "
            "type 2 in {}:",
            M,
            N,
            GAMMA,
        ),
        Display(_MIDDLE),
        paragraph(
            "or the same with {}. {} and {} turn the third column and the third row of {} into "
            "those of {}:",
            minus(ROOT),
            BETA,
            DELTA,
            N,
            M,
        ),
        Display(_OUTER),
    ]


def _polynomial(kernel: GeneralKernel) -> list[Block]:
    turns, (first, second) = _symbols(kernel)
    translation = Symbol(
        rf"p + {first.latex}\,u + {second.latex}\,v = 0, \qquad g = \det[u, v, p] = 0,",
        f"p + {first.text} u + {second.text} v = 0,  so  g = det[u, v, p] = 0,",
    )
    return [
        Paragraph(
            say("The loop's translation is linear in the lengths of the slides:"),
            say("2. One polynomial."),
        ),
        Display((translation,)),
        paragraph(
            "where {} and {} are the directions of {} and {}, and {} is the sum of what the rest "
            "of the loop adds. All of this has the form {}. With {}, the product of {} over both "
            "signs of {}, times {}, is",
            *(Symbol("u", "u"), Symbol("v", "v"), first, second, Symbol("p", "p")),
            Symbol(r"x + y \sqrt{\Delta}", "x + y √Δ"),
            Symbol(r"g = U + V \sqrt{\Delta}", "g = U + V √Δ"),
            *(G, ROOT, W),
        ),
        Display((_POLYNOMIAL,)),
        paragraph(
            "a trigonometric polynomial of degree 4 in {}, the angle of {}, and so of degree 8 in "
            "{}, with at most eight roots: in {} the degrees of {} and {} are 3 and 2, so the "
            "product is of degree 6, and {} divides it, because {} stays finite for one of the two "
            "signs where {} vanishes. Its coefficients come from its values at 24 angles; bounds "
            "on the circle isolate all its real roots.",
            *(PHI, turns[0], HALF),
            *(Symbol(r"w\,g", "w g"), Symbol(r"w\,U", "w U"), Symbol(r"w\,V", "w V"), W, G, W),
        ),
    ]


def _lengths(kernel: GeneralKernel) -> Block:
    _, slides = _symbols(kernel)
    return Paragraph(
        say(
            "At a root, the sign of {} for which {} vanishes gives the other turns, and the linear "
            "equations give {} and {}. Newton steps on the loop refine each solution to rounding "
            "accuracy, and a solution counts only if the loop closes.",
            *(ROOT, G, *slides),
        ),
        say("3. The other joints."),
    )
