"""Letters: how the generators of the algebra, joints, frames and matrices are written."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from typing import TYPE_CHECKING

from dhgen.derivation.text.formula import Power, Symbol, times
from dhgen.kinematics.algebra import POSE_NAMES, SHOULDER_NAMES, AngleSum

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Constant
    from dhgen.paul.form import Unknown
    from dhgen.paul.step import Step

_SUBSCRIPTS = str.maketrans("0123456789-,", "₀₁₂₃₄₅₆₇₈₉₋,")
_GREEK = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "zeta": "ζ", "eta": "η",
    "theta": "θ", "kappa": "κ", "lambda": "λ", "mu": "μ", "nu": "ν", "xi": "ξ", "rho": "ρ",
    "sigma": "σ", "tau": "τ", "phi": "φ", "chi": "χ", "psi": "ψ", "omega": "ω",
}  # fmt: skip
_MADE = re.compile(r"([ezhup])(\d*[xyz]|\d\d)")  # numbers of frames and axes without a name
_PARTS = re.compile(r"([A-Za-z]+)_?(\d+p+|\d*)")  # 3p is a passive row behind joint 3


_TAKEN = frozenset("ABCEJKPQRTUVWXYZcqrstw")  # letters that formulas use for other things
_BARE = _TAKEN | {"D", "H", "POS"}  # and what else is written without an index

BASE, TOOL = Symbol("Z", "Z"), Symbol("E", "E")
POSE = Symbol(r"\mathit{POS}", "POS")
ARM_SIZE = Symbol(r"\ell", "ℓ")
DET_J = Symbol(r"\det J", "det J")


def letter(latex: str, text: str, index: str = "", name: str = "") -> Symbol:
    """A letter with an index of digits and signs."""
    if not index:
        return Symbol(latex, text, name)
    below = index if len(index) == 1 else f"{{{index}}}"
    spoken = any(c.isalpha() for c in index)
    plain = f"{text}_{index}" if spoken else text + index.translate(_SUBSCRIPTS)
    return Symbol(f"{latex}_{below}", plain, name)


def is_primed(name: str) -> bool:
    """Whether a parameter has the name of something else in the formulas."""
    return name in _BARE


def parameter(name: str) -> Symbol:
    """A parameter of the robot file: L1 and L_1 with an index, a word as a word.

    A prime distinguishes it from what formulas call so themselves, and numbers without a name from
    the parameter whose name they would have (a2_).
    """
    if name.endswith("_"):
        other = parameter(name[:-1])
        return Symbol(f"{other.latex}'", f"{other.text}′", name)
    if is_primed(name):
        return Symbol(rf"\mathit{{{name}}}'", f"{name}′", name)
    match = _PARTS.fullmatch(name)
    if match is not None:
        base, index = match.groups()
        if len(base) == 1 and base not in _TAKEN:
            return letter(base, base, index, name)
        if base in _GREEK:
            return letter(f"\\{base}", _GREEK[base], index, name)
    return Symbol(r"\mathit{" + name.replace("_", r"\_") + "}", name, name)


def joint_index(angle: AngleSum) -> str:
    """The index of an angle sum: 23, or 12-4 for a difference."""
    first, *others = angle.terms
    wide = any(joint > 9 for joint, _ in angle.terms)
    text = str(first[0])
    for joint, sign in others:
        text += ("-" if sign < 0 else "," if wide else "") + str(joint)
    return text


def theta(angle: AngleSum) -> Symbol:
    """The angle of a joint, or a sum of such angles."""
    return letter(r"\theta", "θ", joint_index(angle), f"theta{angle.suffix}")


def cosine(angle: AngleSum) -> Symbol:
    """The cosine of an angle sum, in short."""
    return letter("c", "c", joint_index(angle), angle.cosine)


def sine(angle: AngleSum) -> Symbol:
    """The sine of an angle sum, in short."""
    return letter("s", "s", joint_index(angle), angle.sine)


def single(joint: int) -> AngleSum:
    """The angle of one joint."""
    return AngleSum(((joint, 1),))


def unknown_symbol(unknown: Unknown) -> Symbol:
    """The letter of an angle sum or a length."""
    if isinstance(unknown, AngleSum):
        return theta(unknown)
    return letter("r", "r", str(unknown.joint), unknown.name)


def joint_symbol(joint: int) -> Symbol:
    """The joint variable that the caller sees."""
    return letter("q", "q", str(joint))


def branch_sign(step: Step) -> Symbol:
    """The sign that a step brings in, numbered by the joint that it gives (document 004)."""
    unknown = next((each for each in step.unknowns if isinstance(each, AngleSum)), None)
    if unknown is None:
        return letter(r"\varepsilon", "ε", str(step.length.joint), f"e{step.length.joint}")
    return letter(r"\varepsilon", "ε", joint_index(unknown), f"e{unknown.suffix}")


def link(number: int) -> Symbol:
    """A_i."""
    return letter("A", "A", str(number))


def target(m: int) -> Symbol:
    """U_m."""
    return letter("U", "U", str(m))


def shoulder_target(m: int) -> Symbol:
    """B_m: the rotation of the shoulder's joints after m."""
    return letter("B", "B", str(m))


def forward_matrix(number: int) -> Symbol:
    """T_i^0."""
    index = str(number)
    below = index if len(index) == 1 else f"{{{index}}}"
    return Symbol(f"T_{below}^0", "T" + index.translate(_SUBSCRIPTS) + "⁰")


def pose_letter(letters: Mapping[str, Symbol]) -> str:
    """The letter of the entries of POS: p, or m where points of axes are called p."""
    return "m" if any(each.text.startswith("p_") for each in letters.values()) else "p"


def inverse(matrix: Formula) -> Formula:
    """The inverse of a matrix."""
    return Power(matrix, -1)


def product_of(links: Iterable[int]) -> Formula:
    """A_i ... A_k."""
    return times(*(link(number) for number in links))


def symbols(algebra: Algebra) -> dict[str, Symbol]:
    """The letter of every generator of an arm."""
    table: dict[str, Symbol] = {}
    for name in POSE_NAMES:
        table[name] = letter("t", "t", name[1:], name)
    for name in algebra.coordinates:
        table[name] = letter("w", "w", name[1:], name)
    for names in SHOULDER_NAMES if algebra.chain.arm_angle else ():
        table |= {name: letter("b", "b", name[-2:], name) for name in names}
    for angle in algebra.angles:
        table[angle.cosine] = cosine(angle)
        table[angle.sine] = sine(angle)
    for joint, name in algebra.slides.items():
        table[name] = letter("r", "r", str(joint), name)
    for each in (passive for passive in algebra.chain.passive if passive.apart):
        if each.turns:
            angle = AngleSum(each.terms)
            table[angle.cosine] = letter("c", "c", each.label, angle.cosine)
            table[angle.sine] = letter("s", "s", each.label, angle.sine)
        else:
            name = algebra.slides[each.terms[0][0]]
            table[name] = letter("r", "r", each.label, name)
    for constant in algebra.chain.constants:
        table[constant.name] = constant_symbol(constant, algebra.chain.constants)
    return table


def constant_symbol(constant: Constant, constants: tuple[Constant, ...]) -> Symbol:
    """A length by its name, a root as a root, a twist's cosine and sine as such."""
    name = constant.name
    if constant.parameter is not None:
        return replace(parameter(constant.parameter), name=name)
    if constant.square is not None:
        return Symbol(rf"\sqrt{{{constant.square}}}", f"√{constant.square}", name)
    if constant.cosine is not None:
        return _function("sin", reference_angle(constant, constants), name)
    if any(other.cosine == name for other in constants):
        return _function("cos", reference_angle(constant, constants), name)
    if made := _MADE.fullmatch(name):
        return letter(made[1], made[1], made[2], name)
    return parameter(name)


def _function(function: str, angle: Symbol, name: str) -> Symbol:
    return Symbol(rf"\{function} {angle.latex}", f"{function} {angle.text}", name)


def reference_angle(constant: Constant, constants: tuple[Constant, ...]) -> Symbol:
    """The angle between 0 and pi/2 of a cosine and sine that have no sign.

    α_2 out of ca2, θ_3 out of cat3, with a hat where the table's angle is another one; any other
    angle is η, numbered as they appear.
    """
    cosine = constant.cosine or constant.name
    index = _angle_index(cosine)
    if index is None:
        cosines = [c.cosine for c in constants if c.cosine and _angle_index(c.cosine) is None]
        return letter(r"\eta", "η", str(cosines.index(cosine) + 1))
    latex, text, number = index
    if is_turned(constant.angle):
        return letter(rf"\hat{latex}", f"{text}^", number)
    return letter(latex, text, number)


def is_turned(angle: float | None) -> bool:
    """Whether an angle lies outside the first quadrant."""
    return angle is not None and not 0.0 <= angle <= math.pi / 2


def _angle_index(cosine: str) -> tuple[str, str, str] | None:
    """The letter and the index of a twist or of the angle of a joint, by its cosine."""
    rest = cosine[2:].rstrip("_")
    if rest.isdigit():
        return r"\alpha", "α", rest
    if rest.startswith("t") and rest[1:].isdigit():
        return r"\theta", "θ", rest[1:]
    return None
