"""The kernels: one closed form for each equation type, with what happens where it degenerates.

Sources: the table of types of document 003 (after W. Khalil and E. Dombre, Modeling, Identification
and Control of Robots, 2002, chapter 4). An angle is found as its cosine and sine, which later steps
take; its value is taken from both of them.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum
from dhgen.kinematics.ring import constant_value
from dhgen.paul.forms import Length
from dhgen.paul.step import Kind
from dhgen.paul.types.angle_pair import stretch
from dhgen.program.ir import Failure
from dhgen.program.lowering.distances import extremes_of, reached, squared_distance
from dhgen.program.lowering.quartic import lower_circle
from dhgen.program.lowering.roots import (
    NearlyFree,
    Reach,
    finish,
    finish_direction,
    finish_nearly_free,
    is_nearly_short,
    is_short,
    is_short_square,
    is_within_reach,
    keep_one,
    letters,
    named,
    remember,
    signed_root,
    vanishes,
)
from dhgen.program.lowering.scales import Extremes

if TYPE_CHECKING:
    from collections.abc import Callable
    from fractions import Fraction

    from dhgen.paul.step import Step
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.context import Lowering
    from dhgen.program.lowering.distances import Distance


def lower_length(context: Lowering, step: Step) -> None:
    """Type 1: r = Y / X; where X may vanish, the seed's r if Y vanishes too."""
    (unknown,) = step.unknowns
    assert isinstance(unknown, Length)
    builder = context.builder
    y, x = letters(context, step, "Y X")
    if context.are_constant(step.coefficient("X")):
        context.angles.solved_slide(unknown.name, builder.div(y, x))
        return
    degree = context.scales.degree(step.coefficient("X"))
    free = is_short(context, builder.absolute(x), degree, f"free{unknown.joint}")
    near = vanishes(context, y, step.coefficient("Y"))
    within = is_within_reach(context, y, x)
    builder.guard(builder.select(free, near, within), Failure.REACH)
    safe = builder.hint(builder.select(free, builder.integer(1), x), f"divisor{unknown.joint}")
    seed = context.angles.chosen_slide(unknown.joint, free)
    length = builder.select(free, seed, builder.div(y, safe))
    context.angles.solved_slide(unknown.name, length)


def lower_angle(context: Lowering, step: Step) -> None:
    """Type 2: X s + Y c = Z."""
    (angle,) = step.unknowns
    assert isinstance(angle, AngleSum)
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
    distance = squared_distance(context, step.coefficient("Z")) if fixed else None
    if distance is None:
        z, reach = _by_value(context, step, square, degree)
    else:
        z, reach = _by_distance(context, step, distance)
    if free is not None and context.mends_roots:
        short = is_nearly_short(context, square, degree, angle)
        context.short.append(short)
        # then both signs may be anything, and steps tell
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


def _by_value(context: Lowering, step: Step, square: Node, degree: int) -> tuple[Node, Reach]:
    """Z, and D = X^2 + Y^2 - Z^2."""
    (angle,) = step.unknowns
    assert isinstance(angle, AngleSum)
    builder = context.builder
    z = builder.name(context.lower(step.coefficient("Z")), f"Z{angle.suffix}")
    discriminant = builder.name(builder.sub(square, builder.square(z)), f"D{angle.suffix}")
    twice = builder.mul(builder.integer(2), builder.absolute(z))
    reach, merge, blur = (
        builder.mul(delta, builder.add(twice, delta))  # (|Z| + delta)^2 - Z^2
        for delta in context.scales.distances(degree)
    )
    return z, _within(context, discriminant, (reach, merge, blur))


def _by_distance(context: Lowering, step: Step, distance: Distance) -> tuple[Node, Reach]:
    """The same for Z = k |v|^2 + C: D = k^2 (H - |v|^2) (|v|^2 - L)."""
    (angle,) = step.unknowns
    assert isinstance(angle, AngleSum)
    builder = context.builder
    square = builder.name(distance.square, f"V{angle.suffix}")
    factor = _ratio(context, distance.factor)
    z = builder.add(builder.mul(factor, square), context.lower(distance.rest))
    builder.name(z, f"Z{angle.suffix}")
    ends = extremes_of(context, distance, step.coefficient("X"), step.coefficient("Y"))
    reach = reached(context, square, ends, angle.suffix)
    scaled = builder.mul(_ratio(context, distance.factor**2), reach.discriminant)
    return z, replace(reach, discriminant=scaled)


def _within(context: Lowering, discriminant: Node, limits: tuple[Node, Node, Node]) -> Reach:
    """What is known of D by what rounding may add to it."""
    builder = context.builder
    reach, merge, blur = limits
    return Reach(
        discriminant,
        inside=builder.apply("at_most", builder.neg(reach), discriminant),
        apart=builder.apply("less", merge, discriminant),
        clear=builder.apply("less", blur, discriminant),
    )


def _ratio(context: Lowering, value: Fraction) -> Node:
    builder = context.builder
    return builder.div(builder.integer(value.numerator), builder.integer(value.denominator))


def _lower_homogeneous(
    context: Lowering, step: Step, vector: tuple[Node, Node], degree: int
) -> None:
    """Type 2 with Z = 0: the angle of a vector or its opposite, always solvable."""
    (angle,) = step.unknowns
    assert isinstance(angle, AngleSum)
    builder = context.builder
    x, y = vector if step.second is None else _lengthened(context, vector, step.second, degree)
    square = builder.add(builder.square(x), builder.square(y))
    length = builder.name(builder.apply("sqrt", square), f"w{angle.suffix}")
    free = is_short(context, length, degree, f"free{angle.suffix}")
    if context.mends_roots:
        context.short.append(is_nearly_short(context, square, degree, angle))
    sign = context.new_sign()
    keep_one(context, sign, free)
    factor = _over(context, sign, length, free, angle.suffix)
    direction = builder.neg(builder.mul(x, factor)), builder.mul(y, factor)
    if degree == 0 and len(angle.terms) == 1 and context.may_be_lost:
        finish_direction(context, angle, direction, length, free)
    else:
        finish(context, angle, *direction, free)
    if step.second is None:
        root = builder.hint(builder.mul(sign, length), f"root{angle.suffix}")
        remember(context, step, angle, builder.integer(0), root)


def _lengthened(
    context: Lowering, vector: tuple[Node, Node], second: Step, degree: int
) -> tuple[Node, Node]:
    """(X, Y) and the same of a second equation, turned to the same side: short only with both."""
    builder = context.builder
    (angle,) = second.unknowns
    assert isinstance(angle, AngleSum)
    x, y = vector
    u, v = (
        builder.hint(context.lower(second.coefficient(name)), named(f"{name}2", angle.suffix))
        for name in "XY"
    )
    power = degree - context.scales.degree(*(second.coefficient(name) for name in "XY"))
    along = builder.add(builder.mul(x, u), builder.mul(y, v))
    weight = builder.apply("copysign", context.scales.weight(power), along)
    return builder.add(x, builder.mul(weight, u)), builder.add(y, builder.mul(weight, v))


def _over(context: Lowering, sign: Node, length: Node, free: Node, suffix: str) -> Node:
    """sign / length, where the length may be none."""
    builder = context.builder
    safe = builder.hint(builder.select(free, builder.integer(1), length), f"divisor{suffix}")
    return builder.hint(builder.div(sign, safe), f"factor{suffix}")


def lower_angle_pair(context: Lowering, step: Step) -> None:
    """Type 3: Cramer's rule, made a unit vector where rounding or the pose may spoil it."""
    (angle,) = step.unknowns
    assert isinstance(angle, AngleSum)
    builder = context.builder
    x1, y1, z1, x2, y2, z2 = letters(context, step, "X1 Y1 Z1 X2 Y2 Z2")
    determinant = builder.sub(builder.mul(x1, y2), builder.mul(x2, y1))
    sine = builder.sub(builder.mul(z1, y2), builder.mul(z2, y1))
    cosine = builder.sub(builder.mul(x1, z2), builder.mul(x2, z1))
    builder.hint(sine, f"S{angle.suffix}")
    builder.hint(cosine, f"C{angle.suffix}")
    factors = [step.coefficient(letter) for letter in ("X1", "Y1", "X2", "Y2")]
    if context.are_constant(*factors) and not context.redundant:
        sine, cosine = builder.div(sine, determinant), builder.div(cosine, determinant)
        finish(context, angle, cosine, sine)
        return
    sides = step.coefficient("Z1"), step.coefficient("Z2")
    degree = context.scales.degree(*factors) + context.scales.degree(*sides)
    facing = _sign_of(context, determinant, step)
    length = builder.apply("sqrt", builder.add(builder.square(sine), builder.square(cosine)))
    length = builder.name(length, f"w{angle.suffix}")
    # the product of two vectors of equal length, which vanish together
    free = is_short_square(context, length, degree // 2, angle)
    if context.mends_roots:
        context.short.append(is_nearly_short(context, length, degree // 2, angle))
    factor = _over(context, facing, length, free, angle.suffix)
    finish(context, angle, builder.mul(cosine, factor), builder.mul(sine, factor), free)


def _sign_of(context: Lowering, determinant: Node, step: Step) -> Node:
    """+1 or -1 as the determinant, which is known where X2, Y2 is X1, Y1 turned and stretched."""
    builder = context.builder
    factor = stretch(*(step.coefficient(letter) for letter in ("X1", "Y1", "X2", "Y2")))
    if factor is not None and context.are_constant(factor):
        return builder.integer(1 if constant_value(context.algebra, factor) > 0.0 else -1)
    negative = builder.apply("less", determinant, builder.integer(0))
    return builder.select(negative, builder.integer(-1), builder.integer(1))


def lower_polar(context: Lowering, step: Step) -> None:
    """Type 4: r and its angle are polar coordinates, or the opposite ones."""
    angle, unknown = step.unknowns
    assert isinstance(angle, AngleSum)
    assert isinstance(unknown, Length)
    builder = context.builder
    x1, y1, x2, y2 = letters(context, step, "X1 Y1 X2 Y2")
    u, v = builder.div(y1, x1), builder.div(y2, x2)
    length = builder.apply("sqrt", builder.add(builder.square(u), builder.square(v)))
    length = builder.name(length, f"w{unknown.joint}")
    free = is_short(context, length, 1, f"free{angle.suffix}")
    sign = context.new_sign()
    keep_one(context, sign, free)
    factor = _over(context, sign, length, free, angle.suffix)
    finish(context, angle, builder.mul(v, factor), builder.mul(u, factor), free)
    context.angles.solved_slide(unknown.name, builder.mul(sign, length))


def lower_angle_and_length(context: Lowering, step: Step) -> None:
    """Type 5: a quadratic in r, then the angle.

    Its discriminant b^2 - a c is written a - (V x W)^2, which loses nothing where it is small.
    """
    angle, unknown = step.unknowns
    assert isinstance(angle, AngleSum)
    assert isinstance(unknown, Length)
    builder = context.builder
    x1, y1, z1, x2, y2, z2 = letters(context, step, "X1 Y1 Z1 X2 Y2 Z2")
    quotients = builder.div(y1, x1), builder.div(z1, x1), builder.div(y2, x2), builder.div(z2, x2)
    for letter, node in zip(("V1", "W1", "V2", "W2"), quotients, strict=True):
        builder.hint(node, named(letter, angle.suffix))
    v1, w1, v2, w2 = quotients
    a = builder.add(builder.square(w1), builder.square(w2))
    b = builder.name(builder.add(builder.mul(v1, w1), builder.mul(v2, w2)), f"B{unknown.joint}")
    off = builder.sub(builder.mul(v1, w2), builder.mul(v2, w1))
    discriminant = builder.name(builder.sub(a, builder.square(off)), f"D{unknown.joint}")
    reach, merge, blur = (
        builder.mul(builder.mul(builder.integer(2), a), delta)
        for delta in context.scales.distances(0)
    )
    within = _within(context, discriminant, (reach, merge, blur))
    root = signed_root(context, angle.suffix, within)
    r = builder.name(builder.div(builder.sub(root, b), a), unknown.name)
    context.angles.solved_slide(unknown.name, r)
    sine = builder.add(v1, builder.mul(w1, r))
    cosine = builder.add(v2, builder.mul(w2, r))
    finish(context, angle, cosine, sine)


def lower_two_angles(context: Lowering, step: Step) -> None:
    """Types 6, 7, 8 for the difference of the angles: the law of cosines.

    For one of the angles themselves, what is left is of type 2, X s + Y c = Z. With H and L the
    squares of the longest and shortest reach, D = (H - |Z|^2)(|Z|^2 - L) is accurate also where
    the arm is nearly folded.
    """
    if step.has("Z"):
        lower_angle(context, step)
        return
    (angle,) = step.unknowns
    assert isinstance(angle, AngleSum)
    builder = context.builder
    z1, z2 = letters(context, step, "Z1 Z2")
    reach = builder.name(builder.add(builder.square(z1), builder.square(z2)), f"N{angle.suffix}")
    x, y, n = letters(context, step, "X Y N")
    k = builder.name(builder.sub(reach, n), f"K{angle.suffix}")
    square = builder.add(builder.square(x), builder.square(y))
    v, w = (
        math.hypot(
            *(constant_value(context.algebra, step.coefficient(letter + part)) for part in "12")
        )
        for letter in "VW"
    )
    ends = Extremes(v + w, abs(v - w))
    root = signed_root(context, angle.suffix, reached(context, reach, ends, angle.suffix))
    if builder.is_zero(x):
        sine, cosine = builder.div(root, y), builder.div(k, y)
    else:
        sine = builder.div(builder.add(builder.mul(x, k), builder.mul(y, root)), square)
        cosine = builder.div(builder.sub(builder.mul(y, k), builder.mul(x, root)), square)
    finish(context, angle, cosine, sine)


def lower_squared_length(context: Lowering, step: Step) -> None:
    """Type 10: a quadratic in r.

    Rounding of Z moves a root by itself over the distance of both. A length that may be nothing
    else is zero: what it gives a direction to is free then, and not anywhere.
    """
    (unknown,) = step.unknowns
    assert isinstance(unknown, Length)
    builder, suffix = context.builder, str(unknown.joint)
    x, y, z = letters(context, step, "X Y Z")
    half = builder.hint(builder.div(y, builder.mul(builder.integer(2), x)), f"H{suffix}")
    square = builder.add(builder.square(half), builder.div(z, x))
    discriminant = builder.name(square, f"D{suffix}")
    within = _within(context, discriminant, context.scales.distances(2))
    root = signed_root(context, suffix, within)
    length = builder.sub(root, half)
    size = builder.absolute(length)
    apart = builder.apply("maximum", builder.absolute(root), size)
    noise = context.scales.tolerance(context.scales.tolerances.nothing, 2, "nothing")
    none = builder.apply("at_most", builder.mul(size, apart), noise)
    length = builder.select(none, builder.integer(0), length)
    context.angles.solved_slide(unknown.name, length)


KERNELS: dict[Kind, Callable[[Lowering, Step], None]] = {
    Kind.LENGTH: lower_length,
    Kind.ANGLE: lower_angle,
    Kind.ANGLE_PAIR: lower_angle_pair,
    Kind.POLAR: lower_polar,
    Kind.ANGLE_AND_LENGTH: lower_angle_and_length,
    Kind.TWO_ANGLES: lower_two_angles,
    Kind.TWO_ANGLES_TURNED: lower_two_angles,
    Kind.ANGLE_AND_SUM: lower_two_angles,
    Kind.CIRCLE: lower_circle,
    Kind.SQUARED_LENGTH: lower_squared_length,
}
