"""The numbers of a robot file as exact ring elements: lengths keep names, exact twists are exact.

A length is a polynomial in named constants with rational coefficients; a twist gives a cosine and a
sine. Multiples of 90 degrees become 0 and 1, multiples of 15 degrees use the square roots of 2 and
3, any other twist becomes a named pair (cosine, sine) that is shared by all twists of its size.
"""

from __future__ import annotations

import math
import operator as arithmetic
import re
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, TypeAlias

from sympy.polys.domains import QQ
from sympy.polys.rings import PolyElement, PolyRing

from dhgen.kinematics.expressions import (
    bare_number,
    has_parameters,
    is_polynomial,
    multiple_of_pi,
    rational_number,
)
from dhgen.robot.exact import surd
from dhgen.robot.expression import Binary, Call, Name, Negate, Number, evaluate

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from dhgen.robot.expression import Expression

Polynomial: TypeAlias = PolyElement  # over the rationals, in a ring of named generators

# what other generators of an arm's ring are called: a parameter of that name gets an underscore
_GENERATORS = re.compile(r"[cs](m?_?\d+)+|r\d+|t\d\d|w[2-6]?[xyz]|sqrt[23]|unit")
_ARITHMETIC = {"+": arithmetic.add, "-": arithmetic.sub, "*": arithmetic.mul}
TURN_TOLERANCE = 1e-12  # [rad] two twists nearer than this share one cosine and sine


@dataclass(frozen=True, slots=True)
class Constant:
    """A named number of the arm.

    Attributes:
        name: Generator of the ring, and name in the emitted code.
        value: Its value [length unit, or 1].
        meaning: What it is, for comments: "link length 2", of a shared number all that it is.
        square: Its square if that is rational (square roots), else None.
        cosine: For the sine of a twist, the name of its cosine, else None.
        is_length: Whether it scales with the arm.
        parameter: What it is called in the robot file, where it has a name there.
        angle: For a cosine and its sine, the angle as it was first written [rad], of which they
            have the sizes alone; else None.
    """

    name: str
    value: float
    meaning: str
    square: Fraction | None = None
    cosine: str | None = None
    is_length: bool = True
    parameter: str | None = None
    angle: float | None = None


SQRT2 = Constant("sqrt2", math.sqrt(2.0), "square root of 2", square=Fraction(2), is_length=False)
SQRT3 = Constant("sqrt3", math.sqrt(3.0), "square root of 3", square=Fraction(3), is_length=False)

# cos of k times 15 degrees as (rational, sqrt2, sqrt3, sqrt2 sqrt3) coefficients
_COSINES: tuple[tuple[Fraction, Fraction, Fraction, Fraction], ...] = (
    (Fraction(1), Fraction(0), Fraction(0), Fraction(0)),
    (Fraction(0), Fraction(1, 4), Fraction(0), Fraction(1, 4)),
    (Fraction(0), Fraction(0), Fraction(1, 2), Fraction(0)),
    (Fraction(0), Fraction(1, 2), Fraction(0), Fraction(0)),
    (Fraction(1, 2), Fraction(0), Fraction(0), Fraction(0)),
    (Fraction(0), Fraction(-1, 4), Fraction(0), Fraction(1, 4)),
    (Fraction(0), Fraction(0), Fraction(0), Fraction(0)),
)


@dataclass(frozen=True, slots=True)
class _Cell:
    """What is read, and the name that its number gets where it has none.

    Attributes:
        whole: The cell's whole expression.
        name: The name.
        meaning: What the whole is.
        is_length: Whether it scales with the arm.
    """

    whole: Expression
    name: str
    meaning: str
    is_length: bool = True

    def meaning_of(self, part: Expression) -> str:
        """What a part is; the whole but for its sign is the whole."""
        is_whole = self.whole in (part, Negate(part))
        return self.meaning if is_whole else f"part of {self.meaning}"


def constant_ring(names: Iterable[str]) -> PolyRing:
    """The ring of polynomials over the rationals in these generators (at least one)."""
    return PolyRing(list(names) or ["unit"], QQ)


def generator(ring: PolyRing, name: str) -> Polynomial:
    """The generator of that name."""
    return ring.gens[[symbol.name for symbol in ring.symbols].index(name)]


class ConstantTable:
    """Collects the constants of one arm while its transforms are read, in order of appearance.

    Values are kept as expressions here; `ring` is made when all constants are known, and `length`,
    `cosine_sine` are asked twice: first to collect the names, then to give the polynomials.
    """

    def __init__(self, parameters: Mapping[str, float]) -> None:
        self.parameters = dict(parameters)
        self.constants: dict[str, Constant] = {}
        self._opaque: dict[tuple[Expression, str], str] = {}
        self._places: dict[str, list[str]] = {}
        self._sizes: dict[tuple[Fraction, str], str] = {}
        self._twists: list[tuple[float, str]] = []
        self._ring: PolyRing | None = None

    def close(self) -> PolyRing:
        """Fixes the ring: from now on polynomials come out."""
        self._ring = constant_ring(self.constants)
        return self._ring

    def length(self, expression: Expression, name: str, meaning: str) -> Polynomial:
        """A length cell as a polynomial; a parameter keeps its name.

        A number gets `name`, and so does what is written as a sum, a nominal length and what
        calibration added: of its fraction no reader learns anything. A number that is added to
        parameters gets it, too, or that of another one of its size along such an axis.
        """
        if value := rational_number(expression):
            expression = Number(value)
        cell = _Cell(expression, name, meaning)
        if has_parameters(expression):
            return self._sum(expression, cell)
        if value:
            self._sizes.setdefault((value, _kind(name)), name)
        if value or not is_polynomial(expression):
            return self._named(expression, cell)
        return self._polynomial(expression, cell)

    def scalar(self, expression: Expression, name: str, meaning: str) -> Polynomial:
        """A number without a unit, such as an entry of a rotation matrix."""
        value = bare_number(expression)
        if value is not None and value.denominator == 1:
            return self._number(value)
        cell = _Cell(expression, name, meaning, is_length=False)
        if not is_polynomial(expression):
            return self._named(expression, cell)
        return self._polynomial(expression, cell)

    def cosine_sine(
        self, expression: Expression, name: str, meaning: str
    ) -> tuple[Polynomial, Polynomial]:
        """Cosine and sine of a constant angle; `name` ends the names of a new pair."""
        turns = multiple_of_pi(expression)
        if turns is not None and (turns * 12).denominator == 1:
            step = int(turns * 12) % 24
            return self._exact_cosine(step), self._exact_cosine((step - 6) % 24)
        return self._pair(evaluate(expression, self.parameters), name, meaning)

    def _add(self, constant: Constant) -> Polynomial:
        self.constants.setdefault(constant.name, constant)
        return self._generator(constant.name)

    def _parameter(self, name: str, meaning: str, *, is_length: bool) -> Polynomial:
        free = name
        while _GENERATORS.fullmatch(free) or (free != name and free in self.parameters):
            free += "_"
        value = self.parameters[name]
        return self._add(Constant(free, value, meaning, is_length=is_length, parameter=name))

    def _generator(self, name: str) -> Polynomial:
        return generator(self._ring, name) if self._ring is not None else _ANY

    def _number(self, value: Fraction) -> Polynomial:
        if self._ring is None:
            return _ANY
        return self._ring.ground_new(QQ(value.numerator, value.denominator))

    def _exact_cosine(self, step: int) -> Polynomial:
        step = min(step, 24 - step)
        sign, index = (1, step) if step <= 6 else (-1, 12 - step)
        return self._of_roots([sign * part for part in _COSINES[index]])

    def _of_roots(self, coefficients: Sequence[Fraction]) -> Polynomial:
        """The sum of multiples of 1, sqrt(2), sqrt(3) and sqrt(6) = sqrt(2) sqrt(3)."""
        rational, root2, root3, root6 = coefficients
        result = self._number(rational)
        if root2 or root6:
            result = result + self._number(root2) * self._add(SQRT2)
        if root3:
            result = result + self._number(root3) * self._add(SQRT3)
        if root6:
            result = result + self._number(root6) * self._add(SQRT2) * self._add(SQRT3)
        return result

    def _pair(self, angle: float, name: str, meaning: str) -> tuple[Polynomial, Polynomial]:
        """A twist that is no exact angle: reduced to the first quadrant, shared by size."""
        angle = math.remainder(angle, 2.0 * math.pi)
        size = abs(angle)
        folded = min(size, math.pi - size)
        for known, suffix in self._twists:
            if abs(known - folded) < TURN_TOLERANCE:
                name = suffix
                break
        else:
            # one cell can hold two angles, as the entries of a roll-pitch-yaw matrix do
            while {f"ca{name}", f"sa{name}"} & (self.constants.keys() | self.parameters.keys()):
                name += "_"
            self._twists.append((folded, name))
        cosine = Constant(
            f"ca{name}",
            math.cos(folded),
            f"cosine of {meaning}",
            is_length=False,
            angle=angle,
        )
        sine = Constant(
            f"sa{name}",
            math.sin(folded),
            f"sine of {meaning}",
            cosine=cosine.name,
            is_length=False,
            angle=angle,
        )
        c, s = self._add(cosine), self._add(sine)
        return (c if size <= math.pi / 2 else -c), (s if angle >= 0 else -s)

    def _named(self, expression: Expression, cell: _Cell) -> Polynomial:
        key = (expression, cell.name)
        if key not in self._opaque:
            unique = cell.name
            while unique in self.constants or unique in self.parameters:
                unique += "_"
            self._opaque[key] = unique
            value = evaluate(expression, self.parameters)
            self.constants[unique] = Constant(unique, value, "", is_length=cell.is_length)
        name = self._opaque[key]
        places = self._places.setdefault(name, [])
        if (place := cell.meaning_of(expression)) not in places:
            places.append(place)
            self.constants[name] = replace(self.constants[name], meaning=_listed(places))
        return self._generator(name)

    def _sum(self, expression: Expression, cell: _Cell) -> Polynomial:
        """A length whose terms are lengths; numbers of one size share a name, so they cancel."""
        if value := rational_number(expression):
            size = Number(abs(value))
            name = self._sizes.setdefault((size.value, _kind(cell.name)), cell.name)
            return self._named(size, replace(cell, name=name)) * (1 if value > 0 else -1)
        match expression:
            case Negate(operand):
                return -self._sum(operand, cell)
            case Binary("+" | "-" as operator, left, right):
                return _ARITHMETIC[operator](self._sum(left, cell), self._sum(right, cell))
            case _:
                return self._polynomial(expression, cell)

    def _polynomial(self, expression: Expression, cell: _Cell) -> Polynomial:
        match expression:
            case Number(value):
                result = self._number(value)
            case Name(parameter):
                result = self._parameter(parameter, cell.meaning, is_length=cell.is_length)
            case Negate(operand):
                result = -self._polynomial(operand, cell)
            case Binary("+" | "-" | "*" as operator, left, right):
                first, second = self._polynomial(left, cell), self._polynomial(right, cell)
                result = _ARITHMETIC[operator](first, second)
            case Binary("/", left, Number(value)) if value != 0:
                result = self._polynomial(left, cell) * self._number(1 / value)
            case Binary("**", left, Number(value)) if value.denominator == 1 and value >= 0:
                result = self._polynomial(left, cell) ** int(value)
            case _ if (roots := surd(expression)) is not None:
                result = self._of_roots(roots.coefficients)
            case Call("cos" | "sin" as function, argument):
                cosine, sine = self.cosine_sine(argument, cell.name, _angle(argument, cell))
                result = cosine if function == "cos" else sine
            case _:
                result = self._named(expression, cell)
        return result


def _kind(name: str) -> str:
    """What lengths that can cancel share of their names: d of d1, z of p2z and of ez."""
    return name.rstrip("0123456789_")[-1:]


def _listed(places: Sequence[str]) -> str:
    """What a number is, at every place that shares it: who edits it changes all of them."""
    *others, last = places
    return f"{', '.join(others)} and {last}" if others else last


def _angle(argument: Expression, cell: _Cell) -> str:
    """What an angle is whose cosine or sine is in a cell."""
    match argument:
        case Name(parameter) | Negate(Name(parameter)):
            return f"the parameter {parameter}"
        case _:
            return cell.meaning


class _Any:
    """A placeholder for a polynomial while names are being collected."""

    def _same(self, *_: Any) -> _Any:  # noqa: ANN401 - any operand leaves it what it is
        return self

    __add__ = __radd__ = __sub__ = __rsub__ = __mul__ = __rmul__ = __pow__ = __neg__ = _same


_ANY: Any = _Any()
