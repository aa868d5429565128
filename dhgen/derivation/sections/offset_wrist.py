"""The polynomial of an arm with an offset wrist, in words and equations."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from dhgen.derivation.sections.general_loop import joint_symbol
from dhgen.derivation.text.blocks import Display, Paragraph, paragraph, say
from dhgen.derivation.text.formula import Symbol
from dhgen.kinematics.neighbours import short_number

if TYPE_CHECKING:
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.general.kernel import GeneralKernel
    from dhgen.general.offset_wrist import OffsetWrist

S, B, W = (Symbol(each, each) for each in "SBW")
UPPER, LOWER, PSI = Symbol("a", "a"), Symbol("r", "r"), Symbol(r"\psi", "ψ")
TAU, EPSILON = Symbol(r"\tau", "τ"), Symbol(r"\varepsilon", "ε")
U, V, N = (Symbol(each, each) for each in "uvn")  # directions of axes
NO_V, SQUARE = Symbol("V = 0", "V = 0"), Symbol("w^2", "w²")
PRODUCT = Symbol("U^2 - V^2 D", "U² − V² D")
SHORT = (
    Symbol(
        r"w = \vec{SW} \cdot \vec{SW}, \quad c = \vec{SW} \cdot n, \quad "
        r"h = \vec{SW} \cdot u, \quad k = u \cdot n,",
        "w = SW·SW,  c = SW·n,  h = SW·u,  k = u·n,",
    ),
    Symbol(
        r"\rho^2 = w - h^2, \quad m = k w - h c, \quad Q = w - a^2 + r^2, \quad "
        r"D = 4 a^2 w - (a^2 - r^2 + w)^2",
        "ρ² = w − h²,  m = k w − h c,  Q = w − a² + r²,  D = 4 a² w − (a² − r² + w)²",
    ),
)
CONDITION = Symbol(
    r"c \rho\,(Q \cos\psi + \varepsilon \sqrt{D} \sin\psi) + "
    r"\tau m\,(Q \sin\psi - \varepsilon \sqrt{D} \cos\psi) = 0,",
    "c ρ (Q cos ψ + ε √D sin ψ) + τ m (Q sin ψ − ε √D cos ψ) = 0,",
)
PARTS = Symbol(
    r"U = c^2 \rho^2 (Q^2 \cos^2\psi + D \sin^2\psi) - m^2 (Q^2 \sin^2\psi + D \cos^2\psi), "
    r"\qquad V = Q \sin 2\psi\,(c^2 \rho^2 + m^2).",
    "U = c² ρ² (Q² cos² ψ + D sin² ψ) − m² (Q² sin² ψ + D cos² ψ),  V = Q sin 2ψ (c² ρ² + m²).",
)
OF_EIGHT = Symbol(r"f = \frac{U^2 - V^2 D}{w^2} = 0.", "f = (U² − V² D) / w² = 0.")
OF_FOUR = Symbol(r"f = \frac{U}{w} = 0.", "f = U / w = 0.")


def offset_wrist(kernel: GeneralKernel, wrist: OffsetWrist, unit: str) -> list[Block]:
    """What is tried before the elimination; `unit` is that of lengths."""
    return [
        *_geometry(kernel, wrist, unit),
        *_condition(kernel),
        *_polynomial(kernel, wrist),
        _others(kernel),
    ]


def _geometry(kernel: GeneralKernel, wrist: OffsetWrist, unit: str) -> list[Block]:
    """Points and directions that the angle of the last joint gives."""
    last = joint_symbol(kernel, 5)
    one, two, three, four, five, _ = kernel.numbers
    return [
        Paragraph(
            say(
                f"Axes {one} and {two} meet at right angles in {{}}, axes {four} and {five} in "
                f"{{}}; axes {two} and {three} are parallel, and axis {four} lies in the plane "
                f"through {{}} across axis {two}. So {{}} can be found by itself. Let {{}} be the "
                f"direction of axis {one}, {{}} that of axis {five}, and {{}} where axis {three} "
                "cuts the plane. By the loop,",
                *(S, W, S, last, U, N, B),
            ),
            say("The offset wrist."),
        ),
        Display((Symbol(rf"P\,R_z(-{last.latex})\,K_4^{{-1}}", f"P Rz(−{last.text}) K4⁻¹"),)),
        paragraph(
            f"is the frame behind joint {five}. It gives {{}} and {{}}, both linear in the cosine "
            "and the sine of {}. The triangle of {}, {} and {} has the known sides {} and {}, and "
            f"{{}} is the known angle from {{}} to axis {four}; here {{}}.",
            *(W, N, last, S, B, W),
            Symbol(r"\lvert SB \rvert = a", "|SB| = a"),
            Symbol(r"\lvert BW \rvert = r", "|BW| = r"),
            *(PSI, Symbol(r"\vec{BW}", "BW")),
            _numbers(wrist, kernel.loop.size, unit),
        ),
    ]


def _numbers(wrist: OffsetWrist, size: float, unit: str) -> Prose:
    lengths = (short_number(each * size, 6) for each in (wrist.upper, wrist.lower))
    texts = [f"{each} {unit}" for each in lengths]
    angle = short_number(math.degrees(math.atan2(wrist.sine, wrist.cosine)), 6)
    value = Symbol(rf"\psi = {angle}^\circ", f"ψ = {angle.replace('-', '−')}°")
    return say(f"{{}} is {texts[0]}, {{}} is {texts[1]} and {{}}", UPPER, LOWER, value)


def _condition(kernel: GeneralKernel) -> list[Block]:
    """Two axes at right angles, and all that this holds for."""
    *_, four, five, _ = kernel.numbers
    across = Symbol(r"v \cdot n = 0", "v·n = 0")
    return [
        paragraph(f"Axis {four} has to be at right angles to axis {five}. With"),
        Display(SHORT),
        paragraph(f"and {{}} the direction of axis {four}, the condition {{}} is", V, across),
        Display((CONDITION,)),
        paragraph(
            "with the sign {} for the two ways to turn the plane, and {} for the two elbows. The "
            "product over all four is {} with",
            *(TAU, EPSILON, PRODUCT),
        ),
        Display((PARTS,)),
    ]


def _polynomial(kernel: GeneralKernel, wrist: OffsetWrist) -> list[Block]:
    last = joint_symbol(kernel, 5)
    if wrist.sine:
        text = "Divided by {} it is a trigonometric polynomial of degree 8 in {}:"
        return [paragraph(text, SQUARE, last), Display((OF_EIGHT,))]
    text = (
        f"Here axis {kernel.numbers[3]} goes through {{}}, so that {{}}. The root of the product, "
        "divided by {}, is a trigonometric polynomial of degree 4 in {}, and each of its roots "
        "serves two of the four ways:"
    )
    return [paragraph(text, B, NO_V, Symbol("w", "w"), last), Display((OF_FOUR,))]


def _others(kernel: GeneralKernel) -> Block:
    return paragraph(
        "At a root the signs for which the condition holds give the plane, {} and axis "
        f"{kernel.numbers[3]}; the other joints follow one after the other, each from a point or a "
        "direction that it turns (type 3). Newton steps on the loop refine each solution. The "
        "elimination is needed only where the certificate, the last step below, does not hold "
        "with these.",
        B,
    )
