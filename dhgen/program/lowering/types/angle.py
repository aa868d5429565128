"""Types 2 and 3: an angle, from one equation or from two."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

from dhgen.kinematics.ring import constant_value
from dhgen.paul.types.angle_pair import link_lengths, stretch
from dhgen.program.lowering.coefficients import (
    is_nearly_short,
    is_short,
    is_short_square,
    letters,
    named,
    remember,
)
from dhgen.program.lowering.distances import Distance, extremes_of, reached, squared_distance
from dhgen.program.lowering.roots import Reach, keep_one, over, reach_of, signed_root
from dhgen.program.lowering.set_angle import (
    NearlyFree,
    finish,
    finish_direction,
    finish_nearly_free,
)
from dhgen.program.lowering.yaw import free_yaw

if TYPE_CHECKING:
    from fractions import Fraction

    from dhgen.paul.step import Step
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.context import Lowering


def lower_angle(context: Lowering, step: Step) -> None:
    """Type 2: X s + Y c = Z."""
    angle = step.angle
    builder = context.builder
    factors = step.coefficient("X"), step.coefficient("Y")
    x = builder.name(context.lower(factors[0]), f"X{angle.suffix}")
    y = builder.name(context.lower(factors[1]), f"Y{angle.suffix}")
    degree = context.scales.degree(*factors)
    if not step.coefficient("Z"):
        _lower_homogeneous(context, step, (x, y), degree)
        return
    square = builder.name(builder.add(builder.square(x), builder.square(y)), f"N{angle.suffix}")
    fixed = context.are_constant(*factors)
    free = None if fixed else is_short_square(context, square, degree, angle)
    if free is not None and _ends_before_it_is_short(context, step, degree):
        builder.impossible.add(free)
    distance = squared_distance(context, step.coefficient("Z")) if fixed else None
    if distance is None:
        z, reach = _by_value(context, step, square, degree)
    else:
        z, reach = _by_distance(context, step, distance)
    if free is not None and context.mends_roots:
        short = is_nearly_short(context, square, degree, angle)
        context.short.append(short)
        # then both signs may be anything, and steps decide
        reach = replace(reach, clear=builder.apply("or", reach.clear, short))
    root = signed_root(context, angle.suffix, reach, free)
    safe = square
    if free is not None:
        # where the root is left out (X Z, Y Z) is to be a unit vector all the same
        merged = builder.mul(builder.apply("sqrt", square), builder.absolute(z))
        safe = builder.select(reach.apart, square, merged)
        safe = builder.select(free, builder.integer(1), safe)
    builder.hint(safe, f"divisor{angle.suffix}")
    inverse = builder.hint(builder.div(builder.integer(1), safe), f"inverse{angle.suffix}")
    sine = builder.add(builder.mul(x, z), builder.mul(y, root))
    cosine = builder.sub(builder.mul(y, z), builder.mul(x, root))
    direction = builder.mul(cosine, inverse), builder.mul(sine, inverse)
    small = free is not None and not context.are_constant(step.coefficient("Z"))
    if free is not None and small and len(angle.terms) == 1 and context.may_be_lost:
        equation = NearlyFree((x, y, z), root, square, degree)
        finish_nearly_free(context, angle, direction, equation, free)
    else:
        finish(context, angle, *direction, free)
    remember(context, step, angle, z, root)


def _ends_before_it_is_short(context: Lowering, step: Step, degree: int) -> bool:
    """Whether D = X^2 + Y^2 - Z^2 ends the branch wherever X and Y are so small.

    The guard lets D be below zero by 2 |Z| times rounding, over the root of rounding at most.
    """
    z = step.coefficient("Z")
    if not context.are_constant(z):
        return False
    tolerances = context.scales.tolerances
    least = 4.0 * max(math.sqrt(tolerances.reach), tolerances.near) * context.chain.size**degree
    return abs(constant_value(context.algebra, z)) > least


def _by_value(context: Lowering, step: Step, square: Node, degree: int) -> tuple[Node, Reach]:
    """Z, and D = X^2 + Y^2 - Z^2."""
    angle = step.angle
    builder = context.builder
    z = builder.name(context.lower(step.coefficient("Z")), f"Z{angle.suffix}")
    discriminant = builder.name(builder.sub(square, builder.square(z)), f"D{angle.suffix}_squared")
    twice = builder.mul(builder.integer(2), builder.absolute(z))
    reach, merge, blur = (
        builder.mul(delta, builder.add(twice, delta))  # (|Z| + delta)^2 - Z^2
        for delta in context.scales.distances(degree)
    )
    return z, reach_of(context, discriminant, (reach, merge, blur), degree)


def _by_distance(context: Lowering, step: Step, distance: Distance) -> tuple[Node, Reach]:
    """The discriminant for Z = k |v|^2 + C: D = k^2 (H - |v|^2) (|v|^2 - L)."""
    angle = step.angle
    builder = context.builder
    square = builder.name(distance.square, f"V{angle.suffix}")
    factor = _ratio(context, distance.factor)
    z = builder.add(builder.mul(factor, square), context.lower(distance.rest))
    builder.name(z, f"Z{angle.suffix}")
    ends = extremes_of(context, distance, step.coefficient("X"), step.coefficient("Y"))
    reach = reached(context, square, ends, angle.suffix)
    scaled = builder.mul(_ratio(context, distance.factor**2), reach.discriminant)
    return z, replace(reach, discriminant=scaled)


def _ratio(context: Lowering, value: Fraction) -> Node:
    builder = context.builder
    return builder.div(builder.integer(value.numerator), builder.integer(value.denominator))


def _lower_homogeneous(
    context: Lowering, step: Step, vector: tuple[Node, Node], degree: int
) -> None:
    """Type 2 with Z = 0: the angle of a vector or its opposite, always solvable."""
    angle = step.angle
    builder = context.builder
    x, y = vector
    if step.fallback is not None:
        builder.explain(_plain_formula(context, step, step.fallback, vector))
        x, y = _lengthened(context, vector, step.fallback, degree)
    square = builder.add(builder.square(x), builder.square(y))
    length = builder.name(builder.apply("sqrt", square), f"w{angle.suffix}")
    free = is_short(context, length, degree, f"free{angle.suffix}")
    if context.mends_roots:
        context.short.append(is_nearly_short(context, square, degree, angle))
    sign = context.new_sign(angle.suffix)
    keep_one(context, sign, free)
    factor = over(context, sign, length, free, angle.suffix)
    direction = builder.neg(builder.mul(x, factor)), builder.mul(y, factor)
    if degree == 0 and len(angle.terms) == 1 and context.may_be_lost:
        finish_direction(context, angle, direction, length, free)
    else:
        finish(context, angle, *direction, free)
    if step.fallback is None:
        root = builder.hint(builder.mul(sign, length), f"D{angle.suffix}")
        remember(context, step, angle, builder.integer(0), root)


def _plain_formula(context: Lowering, step: Step, second: Step, vector: tuple[Node, Node]) -> str:
    """The first equation's formula, which a reader looks for, and then what protects it."""
    builder = context.builder
    opposite = [builder.entries[each].operator == "neg" for each in vector]
    x, y = (
        builder.spelled(builder.neg(each) if minus else each, f"{letter}{step.angle.suffix}")
        for letter, each, minus in zip("XY", vector, opposite, strict=True)
    )
    x = x if opposite[0] != opposite[1] else f"-{x}"
    return (
        f"so theta{step.angle.suffix} = atan2({y}, {x}) or half a turn from it. Where both are "
        f"small, {second.origins[0].name} says more: its vector, along the same line, is added"
    )


def _lengthened(
    context: Lowering, vector: tuple[Node, Node], second: Step, degree: int
) -> tuple[Node, Node]:
    """(X, Y) plus a second equation's, turned to the same side: short only with both."""
    builder = context.builder
    angle = second.angle
    x, y = vector
    u, v = (
        builder.hint(context.lower(second.coefficient(name)), named(f"{name}2", angle.suffix))
        for name in "XY"
    )
    power = degree - context.scales.degree(*(second.coefficient(name) for name in "XY"))
    along = builder.add(builder.mul(x, u), builder.mul(y, v))
    weight = builder.apply("copysign", context.scales.weight(power), along)
    builder.hint(weight, f"sigma{angle.suffix}")
    sums = builder.add(x, builder.mul(weight, u)), builder.add(y, builder.mul(weight, v))
    for name, each in zip("XY", sums, strict=True):
        entry = builder.entries[each]
        size = entry.operands[0] if entry.operator == "neg" else each
        builder.hint(size, named(f"{name}hat", angle.suffix))
    return sums


def lower_angle_pair(context: Lowering, step: Step) -> None:
    """Type 3: Cramer's rule, made a unit vector where rounding or the pose may spoil it."""
    angle = step.angle
    builder = context.builder
    x1, y1, z1, x2, y2, z2 = letters(context, step, "X1 Y1 Z1 X2 Y2 Z2")
    determinant = builder.sub(builder.mul(x1, y2), builder.mul(x2, y1))
    sine = builder.sub(builder.mul(z1, y2), builder.mul(z2, y1))
    cosine = builder.sub(builder.mul(x1, z2), builder.mul(x2, z1))
    builder.hint(sine, f"S{angle.suffix}")
    builder.hint(cosine, f"C{angle.suffix}")
    factors = [step.coefficient(letter) for letter in ("X1", "Y1", "X2", "Y2")]
    if context.are_constant(*factors) and not context.overdetermined:
        sine, cosine = builder.div(sine, determinant), builder.div(cosine, determinant)
        finish(context, angle, cosine, sine, free_yaw(context, step))
        return
    sides = step.coefficient("Z1"), step.coefficient("Z2")
    degree = context.scales.degree(*factors) + context.scales.degree(*sides)
    facing = _sign_of(context, determinant, step)
    length = builder.apply("sqrt", builder.add(builder.square(sine), builder.square(cosine)))
    length = builder.name(length, f"w{angle.suffix}")
    if context.are_constant(*factors):
        # the pose is checked: one that the arm can take has sides as long as the factors
        short = is_short(context, length, degree, f"short{angle.suffix}")
        context.short.append(short)
        factor = over(context, facing, length, short, angle.suffix)
        finish(context, angle, builder.mul(cosine, factor), builder.mul(sine, factor))
        return
    # the product of two vectors of equal length, which vanish together
    free = is_short_square(context, length, degree // 2, angle)
    if _are_links_apart(context, step):
        builder.impossible.add(free)
    if context.mends_roots:
        context.short.append(is_nearly_short(context, length, degree // 2, angle))
    factor = over(context, facing, length, free, angle.suffix)
    finish(context, angle, builder.mul(cosine, factor), builder.mul(sine, factor), free)


def _are_links_apart(context: Lowering, step: Step) -> bool:
    """Whether two links span no distance that is nearly zero: where they differ in length.

    The step that gave the angle between them has ended branches whose distance is shorter than
    they allow. Its guard lets (H - |v|^2) (|v|^2 - L) be below zero by what rounding adds to the
    longest distance, over the root of rounding at most.
    """
    lengths = link_lengths(context.algebra, context.earlier_steps, step)
    if lengths is None:
        return False
    slack = 4.0 * math.sqrt(context.scales.tolerances.reach) * context.chain.size
    return (lengths[0] - lengths[1]) ** 2 > slack * sum(lengths)


def _sign_of(context: Lowering, determinant: Node, step: Step) -> Node:
    """+1 or -1 as the determinant, which is known where X2, Y2 is X1, Y1 turned and stretched.

    And where it is made of the arm's lengths and twists alone.
    """
    builder = context.builder
    x1, y1, x2, y2 = (step.coefficient(letter) for letter in ("X1", "Y1", "X2", "Y2"))
    factor = stretch(x1, y1, x2, y2)
    if factor is None and context.are_constant(x1, y1, x2, y2):
        factor = x1 * y2 - x2 * y1
    if factor is not None and context.are_constant(factor):
        return builder.integer(1 if constant_value(context.algebra, factor) > 0.0 else -1)
    negative = builder.apply("less", determinant, builder.integer(0))
    return builder.select(negative, builder.integer(-1), builder.integer(1))
