"""Squared distances between points that links hold apart: what is lost of them by cancelling.

Z = k |v|^2 + C is written with v itself, found by completing squares. Of the sum that Z is
otherwise, an arm that is folded upon itself keeps no digit of |v|.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import partial, reduce
from typing import TYPE_CHECKING, Literal

from mpmath import mp, mpf

from dhgen.kinematics.ring import divided, split, used_places
from dhgen.program.lowering.arm_scale import Extremes
from dhgen.program.lowering.roots import Reach, follows, not_below

if TYPE_CHECKING:
    from dhgen.kinematics.constants import Polynomial
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.context import Lowering

DIGITS = 40  # before numbers are rounded: the same on every machine


@dataclass(frozen=True, slots=True)
class Distance:
    """k |v|^2 + C.

    Attributes:
        square: |v|^2.
        factor: k.
        rest: C, of the arm's lengths.
    """

    square: Node
    factor: Fraction
    rest: Polynomial


def squared_distance(context: Lowering, polynomial: Polynomial) -> Distance | None:
    """A polynomial as a squared distance; None where it is none."""
    factors, parts, rest = set(), [], polynomial
    for place in sorted(used_places(polynomial)):
        generator = polynomial.ring.gens[place]
        if context.are_constant(generator):
            continue
        inside, _ = split(polynomial, {place})
        factor = inside.coeff(generator**2)
        if not factor:
            return None
        slope = divided(inside - factor * generator**2, place)
        if not context.are_constant(slope):
            return None
        parts.append(generator + slope.mul_ground(1 / (2 * factor)))
        factors.add(factor)
        rest -= factor * parts[-1] ** 2
    if len(factors) != 1 or not context.are_constant(rest):
        return None
    (factor,) = factors
    builder = context.builder
    total = reduce(builder.add, (builder.square(context.lower(part)) for part in parts))
    return Distance(total, Fraction(int(factor.numerator), int(factor.denominator)), rest)


def extremes_of(context: Lowering, distance: Distance, x: Polynomial, y: Polynomial) -> Extremes:
    """The distances |v| at which X s + Y c = k |v|^2 + C, of lengths alone, has a double root."""
    with mp.workdps(DIGITS):
        size = mp.hypot(_precise(context, x), _precise(context, y))
        rest = _precise(context, distance.rest)
        factor = _number(distance.factor)
        squares = sorted((side * size - rest) / factor for side in (-1, 1))
        shortest, longest = (mp.sqrt(max(square, mpf(0))) for square in squares)
        return Extremes(float(longest), float(shortest))


def _precise(context: Lowering, polynomial: Polynomial) -> mpf:
    """A polynomial of the arm's constants, roots of rational numbers to all digits."""
    algebra = context.algebra
    values = {
        algebra.index[c.name]: mpf(c.value) if c.square is None else mp.sqrt(_number(c.square))
        for c in algebra.chain.constants
    }
    total = mpf(0)
    for monomial, coefficient in polynomial.terms():
        part = _number(coefficient)
        for place, exponent in enumerate(monomial):
            part *= values[place] ** exponent if exponent else 1
        total += part
    return total


def _number(ratio: Fraction) -> mpf:
    return mpf(int(ratio.numerator)) / int(ratio.denominator)


def reached(context: Lowering, square: Node, ends: Extremes, suffix: str) -> Reach:
    """D = (H - |v|^2) (|v|^2 - L), of the squares of the ends.

    This is accurate also where the arm is nearly folded, and so are the bounds of what rounding
    adds, which are taken of the distances themselves.
    """
    builder, tolerances = context.builder, context.scales.tolerances
    extremes = partial(context.scales.extreme_reach, ends, suffix)

    def between(operator: Literal["less", "at_most"], low: Node, high: Node) -> Node:
        above, below = builder.apply(operator, low, square), builder.apply(operator, square, high)
        return builder.apply("and", above, below)

    longest, shortest = extremes("square of the {} reach")
    discriminant = builder.mul(builder.sub(longest, square), builder.sub(square, shortest))
    builder.name(discriminant, f"D{suffix}_squared")
    if follows(context, square):
        off = context.scales.out_of_reach(ends, suffix)
        inside = not_below(context, discriminant, off)
    else:
        far, near = extremes("the {}, with what rounding adds", "reach", tolerances.reach)
        inside = between("at_most", near, far)
    below, above = extremes("the {}, where branches merge", "apart", -tolerances.merge)
    beneath, beyond = extremes("the {}, where blurred branches do", "clear", -tolerances.blur)
    return Reach(
        discriminant=discriminant,
        inside=inside,
        apart=between("less", above, below),
        clear=between("less", beyond, beneath),
        degree=2,
    )
