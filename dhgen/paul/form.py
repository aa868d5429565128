"""An equation as it looks at one point of a derivation: linear in one or two unknowns."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from dhgen.kinematics.algebra import AngleSum

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.equation import Equation


@dataclass(frozen=True, slots=True, order=True)
class Length:
    """The unknown of a prismatic joint."""

    joint: int
    name: str


Unknown = AngleSum | Length
Exponents = tuple[int, ...]
Monomial = tuple[str, ...]  # names of unknown generators, e.g. ("c2", "r3"); () is the constant


@dataclass(frozen=True, slots=True)
class Form:
    """An equation, sum of coefficient times unknown monomial = 0.

    Attributes:
        equation: Where it comes from.
        unknowns: In the order of the joints, angles first.
        terms: The coefficient of every unknown monomial.
    """

    equation: Equation
    unknowns: tuple[Unknown, ...]
    terms: Mapping[Monomial, Polynomial]

    @property
    def only_angle(self) -> AngleSum | None:
        """The unknown, when it is one angle sum."""
        match self.unknowns:
            case (AngleSum() as angle,):
                return angle
        return None

    @property
    def only_length(self) -> Length | None:
        """The unknown, when it is one length."""
        match self.unknowns:
            case (Length() as length,):
                return length
        return None

    @property
    def angle_and_length(self) -> tuple[AngleSum, Length] | None:
        """The unknowns, when they are an angle sum and a length."""
        match self.unknowns:
            case (AngleSum() as angle, Length() as length):
                return angle, length
        return None

    @property
    def two_angles(self) -> tuple[AngleSum, AngleSum] | None:
        """The unknowns, when they are two angle sums."""
        match self.unknowns:
            case (AngleSum() as first, AngleSum() as second):
                return first, second
        return None

    @property
    def two_lengths(self) -> tuple[Length, Length] | None:
        """The unknowns, when they are two lengths."""
        match self.unknowns:
            case (Length() as first, Length() as second):
                return first, second
        return None

    def coefficient(self, *names: str) -> Polynomial:
        """The coefficient of a monomial, zero if it does not occur."""
        found = self.terms.get(names if len(names) < 2 else tuple(sorted(names)))
        return self.equation.difference.ring.zero if found is None else found

    def within(self, allowed: Iterable[Monomial]) -> bool:
        """Whether no other monomials occur."""
        return self.terms.keys() <= {tuple(sorted(monomial)) for monomial in allowed}


def unknown_name(unknown: Unknown) -> str:
    """How a message calls an angle sum or a length."""
    return f"theta{unknown.suffix}" if isinstance(unknown, AngleSum) else unknown.name


def common_angle_and_length(forms: Sequence[Form]) -> tuple[AngleSum, Length] | str:
    """The unknowns of both equations, or why they are not one angle and one length."""
    first, second = forms
    if first.unknowns != second.unknowns or len(first.unknowns) != 2:
        return "not the same two unknowns"
    return first.angle_and_length or "the unknowns are not an angle and a length"


def is_multiple(
    polynomial: Mapping[Exponents, Any], other: Mapping[Exponents, Any], sign: int
) -> bool:
    """Whether a polynomial, as its coefficients by exponents, is another one times +1 or -1."""
    return len(polynomial) == len(other) and all(
        other.get(exponents) == sign * coefficient for exponents, coefficient in polynomial.items()
    )
