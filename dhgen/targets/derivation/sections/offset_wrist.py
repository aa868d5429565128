"""The polynomial of an arm with an offset wrist, in words and equations."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from dhgen.kinematics.neighbours import short_number
from dhgen.targets.derivation.sections.general_loop import joint_symbol
from dhgen.targets.derivation.text.blocks import Display, Paragraph, paragraph, say
from dhgen.targets.derivation.text.formula import Symbol

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel
    from dhgen.general.offset_wrist import OffsetWrist
    from dhgen.targets.derivation.text.blocks import Block, Prose

S, B, W = (Symbol(each, each) for each in "SBW")
UPPER, LOWER, PSI = Symbol("a", "a"), Symbol("r", "r"), Symbol(r"\psi", "ψ")
TAU, EPSILON = Symbol(r"\tau", "τ"), Symbol(r"\varepsilon", "ε")
NO_V = Symbol("V = 0", "V = 0")
E1, E4, E5 = (Symbol(f"e_{axis}", f"e{axis}") for axis in (1, 4, 5))
ACROSS = Symbol(r"e_4 \cdot e_5 = 0", "e4·e5 = 0")
SHORT = (
    Symbol(
        r"w = \vec{SW} \cdot \vec{SW}, \quad c = \vec{SW} \cdot e_5, \quad "
        r"h = \vec{SW} \cdot e_1, \quad k = e_1 \cdot e_5,",
        "w = SW·SW,  c = SW·e5,  h = SW·e1,  k = e1·e5,",
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
    r"\qquad V = Q \sin 2\psi\,(c^2 \rho^2 + m^2),",
    "U = c² ρ² (Q² cos² ψ + D sin² ψ) − m² (Q² sin² ψ + D cos² ψ),  V = Q sin 2ψ (c² ρ² + m²),",
)
OF_EIGHT = Symbol(r"f = \frac{U^2 - V^2 D}{w^2} = 0,", "f = (U² − V² D) / w² = 0,")
OF_FOUR = Symbol(r"f = \frac{U}{w} = 0,", "f = U / w = 0,")


def offset_wrist(kernel: GeneralKernel, wrist: OffsetWrist, unit: str) -> list[Block]:
    """What is tried before the elimination; `unit` is that of lengths."""
    return [*_geometry(kernel, wrist, unit), *_polynomial(kernel, wrist), _others()]


def _geometry(kernel: GeneralKernel, wrist: OffsetWrist, unit: str) -> list[Block]:
    """Points and directions that the angle of the last joint gives."""
    last = joint_symbol(kernel, 5)
    return [
        Paragraph(
            say(
                "Axes 1 and 2 meet at right angles in {}, axes 4 and 5 in {}; axes 2 and 3 are "
                "parallel, and axis 4 lies in the plane through {} across axis 2. So {} can be "
                "found by itself. Let {} be the direction of axis 1, {} that of axis 5, and {} "
                "where axis 3 cuts the plane. By the loop,",
                *(S, W, S, last, E1, E5, B),
            ),
            say("The offset wrist."),
        ),
        Display((Symbol(rf"P\,R_z(-{last.latex})\,K_4^{{-1}}", f"P Rz(−{last.text}) K4⁻¹"),)),
        paragraph(
            "is the frame behind joint 5. It gives {} and {}, both linear in the cosine and the "
            "sine of {}. The triangle of {}, {} and {} has the known sides {} and {}, and {} is "
            "the known angle from {} to axis 4; here {}.",
            *(W, E5, last, S, B, W),
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
    values = (Symbol(rf"\psi = {angle}^\circ", f"ψ = {angle.replace('-', '−')}°"),)
    return say(f"{{}} is {texts[0]}, {{}} is {texts[1]} and {{}}", UPPER, LOWER, *values)


def _polynomial(kernel: GeneralKernel, wrist: OffsetWrist) -> list[Block]:
    last = joint_symbol(kernel, 5)
    blocks: list[Block] = [
        paragraph("Axis 4 has to be at right angles to axis 5. With"),
        Display(SHORT),
        paragraph("and {} the direction of axis 4, the condition {} is", E4, ACROSS),
        Display((CONDITION,)),
        paragraph(
            "with the sign {} for the two ways to turn the plane, and {} for the two elbows. The "
            "product over all four, with",
            *(TAU, EPSILON),
        ),
        Display((PARTS,)),
    ]
    if wrist.sine:
        text = "is a trigonometric polynomial of degree 8 in {}:"
        return [*blocks, paragraph(text, last), Display((OF_EIGHT,))]
    text = (
        "is a square, because axis 4 goes through {} and {}. Its root is a trigonometric "
        "polynomial of degree 4 in {}, each root of which serves two of the four ways:"
    )
    return [*blocks, paragraph(text, B, NO_V, last), Display((OF_FOUR,))]


def _others() -> Block:
    return paragraph(
        "At a root the signs for which the condition holds give the plane, {} and axis 4; the "
        "other joints follow one after the other, each from a point or a direction that it turns "
        "(type 3). Newton steps on the loop refine each solution. The elimination is needed only "
        "where the certificate, the last step below, does not hold with these.",
        B,
    )
