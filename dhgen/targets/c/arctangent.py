"""The arctangent of C in lanes."""

from __future__ import annotations

from dataclasses import dataclass, field

from dhgen.targets.arctangent import STEEP, arctangent_coefficients
from dhgen.targets.layout import INDENT, listed


def _coefficients() -> str:
    numbers = listed([repr(coefficient) for coefficient in arctangent_coefficients()], INDENT)
    head = f"static const double odd[{len(arctangent_coefficients())}] = {{"
    return "\n".join([head, *numbers, "};"])


def _polynomial() -> tuple[str, ...]:
    """Estrin's scheme."""
    names = [f"odd[{place}]" for place in range(len(arctangent_coefficients()))]
    pairs = [f"({a} + {b} * u)" for a, b in zip(names[::2], names[1::2], strict=False)]
    fours = [f"{a} + {b} * u2" for a, b in zip(pairs[::2], pairs[1::2], strict=False)]
    return (
        f"p0 = {fours[0]}",
        f"p4 = {fours[1]}",
        f"p8 = {pairs[4]} + {names[10]} * u2",
        "p = p0 + (p4 + p8 * u4) * u4",
    )


@dataclass(frozen=True, slots=True)
class CArctangent:
    """What the arctangent is made of.

    Attributes:
        odd: The definition of its coefficients.
        lines: Values that lead to that of the polynomial.
        tangent: Up to which ratio the polynomial serves as it is.
    """

    odd: str = field(default_factory=_coefficients)
    lines: tuple[str, ...] = field(default_factory=_polynomial)
    tangent: float = STEEP
