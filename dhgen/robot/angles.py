"""Exact angles: the multiples of pi/12, their cosines, and decimals that mean them."""

from __future__ import annotations

import math
import re
from fractions import Fraction
from typing import Literal, NamedTuple

from dhgen.robot.exact import Surd, number
from dhgen.robot.expression import (
    ONE,
    ZERO,
    Binary,
    Call,
    Expression,
    Name,
    Negate,
    Number,
    Pi,
    evaluate,
    to_text,
)

SNAP = 1e-9  # what is nearer than this to an exact value is taken as exact
SLIP = 1e-3  # what is nearer than this to a multiple of pi/2 probably means it
MEASURED = 12  # a number of so many digits was measured, or computed: nobody types them
SINGLE = 2e-7  # what single precision leaves of angles up to a turn
MOST_QUARTERS = 2  # pi/2 and pi are what radians in a file of degrees mean as a rule
ROUGH = 2e-3  # how far 3.14 is from pi, nearly
MOST_TURNS = 2  # an angle of more looks like degrees
MOST_HALF_TURNS = 21  # unless it is so many half turns: some wrists make ten whole ones
ROUNDED_PI = 3.14
TYPED_TENTHS = 0.05  # half of the last digit of a number with one decimal
TYPED = 6e-3  # how far a number of radians is from what is meant, with two decimals
LARGEST_ANGLE = (
    1e4  # beyond, doubles are too coarse to distinguish a multiple of pi/12 from its neighbours
)
LARGEST_LENGTH = 1e9  # beyond, products of lengths leave the range where 1e-9 means anything
ROUNDING = 1e-15  # what arithmetic with doubles loses for a value of about 1

_DEG = Name("deg")
_NUMBER = re.compile(r"(?<![\w.])(?:\d+\.?\d*|\.\d+)")
_TWELFTH = math.pi / 12
_QUARTER = Fraction(1, 4)
_COSINES = (
    Surd.of(1),
    Surd.of(_QUARTER, 6) + Surd.of(_QUARTER, 2),
    Surd.of(Fraction(1, 2), 3),
    Surd.of(Fraction(1, 2), 2),
    Surd.of(Fraction(1, 2)),
    Surd.of(_QUARTER, 6) + Surd.of(-_QUARTER, 2),
    Surd.of(0),
)


def twelfths(value: float) -> int | None:
    """The k of a value k pi/12, within SNAP; None otherwise."""
    if not abs(value) <= LARGEST_ANGLE:
        return None
    nearest = round(value / _TWELFTH)
    return nearest if abs(value - nearest * _TWELFTH) <= SNAP else None


def exact_angle(k: int) -> Expression:
    """The angle k pi/12 as one writes it: pi/2, -2*pi/3, 0."""
    ratio = Fraction(k, 12)
    if ratio == 0:
        return ZERO
    if abs(ratio.numerator) == 1:
        angle: Expression = Pi() if k > 0 else Negate(Pi())
    else:
        angle = Binary("*", number(Fraction(ratio.numerator)), Pi())
    denominator = Number(Fraction(ratio.denominator))
    return angle if denominator == ONE else Binary("/", angle, denominator)


def exact_cosine(k: int) -> Expression:
    """cos(k pi/12), e.g. sqrt(3)/2."""
    quadrant, rest = divmod(abs(k) % 24, 12)
    value = _COSINES[rest] if rest <= 6 else -_COSINES[12 - rest]
    return (-value if quadrant else value).expression()


def near_cosine(value: float, within: float = SNAP) -> Expression | None:
    """The cosine of a multiple of pi/12 that a number is, within so much; None otherwise."""
    exact = exact_cosine(round(math.acos(max(-1.0, min(1.0, value))) / _TWELFTH))
    return exact if abs(value - evaluate(exact, {})) <= within else None


def cosine(angle: Expression, value: float) -> Expression:
    """cos(angle), exact where the angle's value is a multiple of pi/12."""
    k = twelfths(value)
    return Call("cos", angle) if k is None else exact_cosine(k)


def sine(angle: Expression, value: float) -> Expression:
    """sin(angle), exact where the angle's value is a multiple of pi/12."""
    k = twelfths(value)
    return Call("sin", angle) if k is None else exact_cosine(k - 6)


class Near(NamedTuple):
    """What a cell nearly is.

    Attributes:
        off: How far it is from that, as the file would write the difference.
        of: What it is nearly, of its own: pi/2, 90 deg.
        written: What to write in place of the cell: q + pi/2.
    """

    off: float
    of: str
    written: str


def near_exact(value: float, exact: float, meant: Expression) -> Near | None:
    """What a value is nearly that is replaced by an exact one; None but for rounding."""
    distance = abs(value - exact)
    if distance <= ROUNDING * max(1.0, abs(exact)):
        return None
    return Near(distance, to_text(meant), to_text(meant))


def unit_notice(value: float, unit: Literal["pi", "deg", ""]) -> str | None:
    """The notice for an angle in radians that looks like one in the other unit.

    Args:
        value: The angle in radians; NaN gets no notice.
        unit: How the file writes it: see `near_right_angle`.
    """
    if unit == "pi":
        return turns_notice(value, f"{value:g} deg")
    return None if unit else _radians_notice(math.degrees(value))


def has_all_digits(text: str) -> bool:
    """Whether a cell holds a number that is not rounded to what a person types."""
    return any(
        len(number.replace(".", "").lstrip("0")) >= MEASURED for number in _NUMBER.findall(text)
    )


def near_right_angle(
    value: float, unit: Literal["pi", "deg", ""], joint: str = "", within: float = SLIP
) -> Near | None:
    """The multiple of pi/2 that an angle nearly, but not exactly, is.

    Args:
        value: The angle in radians.
        unit: How the file writes angles: with pi, with the word deg, or as plain degrees.
        joint: The joint's variable with its sign if the angle is an offset to it.
        within: How far away it may be [rad].
    """
    if not math.isfinite(value):
        return None
    quarters, distance = _quarters(value)
    if not SNAP < distance <= within:
        return None
    meant = _multiple(quarters, unit)
    written = meant
    if joint:
        sign = "-" if quarters < 0 else "+"
        written = f"{joint} {sign} {_multiple(abs(quarters), unit)}" if quarters else joint
    return Near(distance if unit == "pi" else math.degrees(distance), meant, written)


def _multiple(quarters: int, unit: str) -> str:
    """A multiple of pi/2 as the file would write it."""
    return to_text(exact_angle(6 * quarters)) if unit == "pi" else f"{90 * quarters} {unit}".strip()


def turns_notice(value: float, meant: str) -> str | None:
    """The notice for radians that look like degrees, and would be written so."""
    if not MOST_TURNS * 2.0 * math.pi < abs(value) < math.inf:
        return None
    turns = abs(value) / (2.0 * math.pi)
    return f"is {turns:.3g} turns: write {meant} if degrees are meant"


def is_half_turns(value: float) -> bool:
    """Whether radians are written that are half turns: 15.708 are five, 62.83 twenty.

    No more than twenty-one are, and no whole number is: 22 and 355 are near some by chance.
    """
    halves = round(value / math.pi)
    near = min(abs(value - halves * pi) for pi in (math.pi, ROUNDED_PI))
    typed = TYPED_TENTHS if round(value, 1) == value else TYPED
    return abs(halves) <= MOST_HALF_TURNS and near < typed and not value.is_integer()


def degrees_text(number: Expression) -> str:
    """So many degrees as a cell writes them."""
    written = to_text(number)
    return f"{written} deg" if isinstance(number, Number) else to_text(Binary("*", number, _DEG))


def _radians_notice(degrees: float) -> str | None:
    """The notice for degrees that look like radians."""
    if not math.isfinite(degrees):
        return None
    quarters, distance = _quarters(degrees)
    if not 0 < abs(quarters) <= MOST_QUARTERS or distance > ROUGH:
        return None
    meant = to_text(exact_angle(6 * quarters))
    return f"is {degrees:g} degrees: write {90 * quarters} if {meant} is meant"


def _quarters(value: float) -> tuple[int, float]:
    """The nearest multiple of pi/2, by its number, and how far it is."""
    quarters = round(value / (math.pi / 2))
    return quarters, abs(value - quarters * math.pi / 2)
