"""The kernel of type 9: a trigonometric polynomial of degree 2 in the angle that remains."""

from __future__ import annotations

from functools import partial, reduce
from typing import TYPE_CHECKING

from dhgen.program.ir import Failure
from dhgen.program.lowering.coefficients import is_short, letters

if TYPE_CHECKING:
    from dhgen.kinematics.algebra import AngleSum
    from dhgen.paul.step import Step
    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.context import Lowering

Linear = tuple["Node", "Node", "Node"]  # l0 + l1 cos x + l2 sin x
Circle = tuple["Node", ...]  # a0, a1, b1, a2, b2


def lower_circle(context: Lowering, step: Step) -> None:
    """Type 9: the sum of the squares of c_i and s_i is 1.

    With P and Q known, by Cramer's rule (Q1 R2 - Q2 R1)^2 + (R1 P2 - R2 P1)^2 = (P1 Q2 - Q1 P2)^2;
    with (P1 + i Q1) V2 = (P2 + i Q2) V1,
    |V1|^2 |R1 V2 - R2 V1|^2 = Im(V1 conj V2)^2 (P1^2 + Q1^2).
    """
    angle = step.angle
    builder = context.builder
    left, right = _sides(context, step)
    polynomial = tuple(builder.sub(a, b) for a, b in zip(left, right, strict=True))
    size = _size(builder, polynomial)
    free = is_short(context, size, _degree(context, step), f"free{angle.suffix}")
    rounding = _rounding(context, left, right)
    root = context.new_root(angle, (*_with_one_root(builder, free, polynomial), rounding))
    builder.guard(builder.apply("at_most", root, builder.integer(4)), Failure.REACH)
    if context.doubts_rows:
        context.meeting.append(_is_close(context, angle, polynomial, root))
    seed = context.angles.seed(angle)
    context.angles.chosen(angle, free)
    if len(angle.terms) == 1 and context.may_be_lost:
        root = _with_serving_digits(context, angle, polynomial, root, rounding)
    context.angles.solved_by_angle(angle, builder.select(free, seed, root))


def _sides(context: Lowering, step: Step) -> tuple[Circle, Circle]:
    """The sums of squares that are to be equal."""
    builder = context.builder
    p1, p2, q1, q2, r1, r2 = (
        _linear(context, step, name) for name in ("P1", "P2", "Q1", "Q2", "R1", "R2")
    )
    if step.has("V1x"):
        left, factor = _turned(context, step, (r1, r2))
        vector = _sum(builder, _square(builder, p1), _square(builder, q1))
        return left, _scaled(builder, factor, vector)
    cosine = _combined(builder, r2, q1[0], r1, q2[0])
    sine = _combined(builder, r1, p2[0], r2, p1[0])
    determinant = builder.sub(builder.mul(p1[0], q2[0]), builder.mul(q1[0], p2[0]))
    left = _sum(builder, _square(builder, cosine), _square(builder, sine))
    return left, (builder.square(determinant), *(builder.integer(0) for _ in left[1:]))


def _degree(context: Lowering, step: Step) -> int:
    """How many lengths are multiplied in the polynomial's coefficients."""

    def of(*letters: str) -> int:
        return context.scales.degree(*(step.coefficient(letter) for letter in letters))

    if step.has("V1x"):
        return 2 * (of("V1x", "V1y") + of("V2x", "V2y") + of("R1", "R1c", "R1s"))
    vectors = (of(*(f"{x}{n}{part}" for x in "PQR" for part in ("", "c", "s"))) for n in (1, 2))
    return 2 * sum(vectors)


def _size(builder: Builder, polynomial: Circle) -> Node:
    """What the polynomial's values are compared with."""
    return reduce(builder.add, map(builder.absolute, polynomial))


def _rounding(context: Lowering, left: Circle, right: Circle) -> Node:
    """What rounding may add to values of a difference of sums of squares, most of which cancels.

    Beside a place where every angle works nearly all of it does.
    """
    builder = context.builder
    nothing = context.scales.tolerance(context.scales.tolerances.nothing, 0, "nothing")
    return builder.mul(nothing, builder.add(left[0], right[0]))


def _with_one_root(builder: Builder, free: Node, polynomial: Circle) -> Circle:
    """The polynomial; where it vanishes and every angle works, 1 - cos x: one branch will do."""
    instead = map(builder.integer, (1, -1, 0, 0, 0))
    return tuple(builder.select(free, a, b) for a, b in zip(instead, polynomial, strict=True))


def _is_close(context: Lowering, angle: AngleSum, polynomial: Circle, root: Node) -> Node:
    """Whether the root may be double: there the slope is small."""
    builder, scales = context.builder, context.scales
    simple = scales.tolerance(scales.tolerances.simple, 0, "simple")
    size = _size(builder, polynomial)
    slope = builder.absolute(_Place(builder, root).slope(polynomial))
    close = builder.apply("at_most", slope, builder.mul(simple, size))
    return builder.name(close, f"meeting{angle.suffix}")


def _with_serving_digits(
    context: Lowering, angle: AngleSum, polynomial: Circle, root: Node, rounded: Node
) -> Node:
    """The root, or a seed beside it that is a root as well, up to rounding.

    The nearer two roots are, the fewer of their digits are right, and an arm that is stretched is
    then out of reach by the wrong ones, as in `finish_direction`.
    """
    builder, tolerances = context.builder, context.scales.tolerances
    seed = context.angles.seed(angle)
    at_root, at_seed = _Place(builder, root), _Place(builder, seed)
    size = _size(builder, polynomial)
    rate = at_root.slope(polynomial)
    flat = builder.mul(context.scales.tolerance(tolerances.near, 0, "near"), size)
    near = builder.name(
        builder.apply("at_most", builder.absolute(rate), flat), f"near{angle.suffix}"
    )
    rounding = context.scales.tolerance(tolerances.double, 0, "double")
    across = builder.sub(
        builder.mul(at_seed.sine, at_root.cosine), builder.mul(at_seed.cosine, at_root.sine)
    )
    ahead = builder.add(
        builder.mul(at_seed.cosine, at_root.cosine), builder.mul(at_seed.sine, at_root.sine)
    )
    same_side = builder.mul(rate, at_seed.slope(polynomial))
    conditions = (
        near,
        builder.apply(
            "at_most",
            builder.absolute(at_seed.value(polynomial)),
            builder.add(builder.mul(rounding, size), rounded),
        ),
        builder.apply(
            "at_most",
            builder.absolute(across),
            context.scales.tolerance(tolerances.near, 0, "near"),
        ),
        builder.apply("less", builder.integer(0), ahead),
        builder.apply(
            "at_most", builder.neg(builder.mul(rounding, builder.square(size))), same_side
        ),
    )
    same = builder.name(reduce(partial(builder.apply, "and"), conditions), f"same{angle.suffix}")
    taken = builder.select(same, seed, root)
    ((joint, _),) = angle.terms
    context.angles.nearly_chosen(joint, near, taken)
    return taken


class _Place:
    """An angle at which a trigonometric polynomial is looked at."""

    def __init__(self, builder: Builder, angle: Node) -> None:
        self.cosine, self.sine = builder.apply("cos", angle), builder.apply("sin", angle)
        self._builder = builder
        self._twice = (
            builder.sub(builder.square(self.cosine), builder.square(self.sine)),
            builder.mul(builder.integer(2), builder.mul(self.cosine, self.sine)),
        )

    def value(self, f: Circle) -> Node:
        """f."""
        one, *others = f
        return self._builder.add(one, self._combined(*others))

    def slope(self, f: Circle) -> Node:
        """The derivative of f."""
        _, a1, b1, a2, b2 = f
        neg, two = self._builder.neg, self._builder.integer(2)
        mul = self._builder.mul
        return self._combined(b1, neg(a1), mul(two, b2), neg(mul(two, a2)))

    def _combined(self, a1: Node, b1: Node, a2: Node, b2: Node) -> Node:
        """a1 cos x + b1 sin x + a2 cos 2x + b2 sin 2x."""
        mul = self._builder.mul
        parts = (mul(a1, self.cosine), mul(b1, self.sine))
        twice = (mul(a2, self._twice[0]), mul(b2, self._twice[1]))
        return reduce(self._builder.add, (*parts, *twice))


def _turned(context: Lowering, step: Step, sides: tuple[Linear, Linear]) -> tuple[Circle, Node]:
    """|V1|^2 |R1 V2 - R2 V1|^2 and Im(V1 conj V2)^2."""
    builder = context.builder
    x1, y1, x2, y2 = letters(context, step, "V1x V1y V2x V2y")
    r1, r2 = sides
    real = _square(builder, _combined(builder, r1, x2, r2, x1))
    imaginary = _square(builder, _combined(builder, r1, y2, r2, y1))
    size = builder.add(builder.square(x1), builder.square(y1))
    apart = builder.sub(builder.mul(y1, x2), builder.mul(x1, y2))
    return _scaled(builder, size, _sum(builder, real, imaginary)), builder.square(apart)


def _scaled(builder: Builder, factor: Node, f: Circle) -> Circle:
    return tuple(builder.mul(factor, part) for part in f)


def _linear(context: Lowering, step: Step, name: str) -> Linear:
    one, cosine, sine = letters(context, step, f"{name} {name}c {name}s")
    return one, cosine, sine


def _combined(builder: Builder, f: Linear, a: Node, g: Linear, b: Node) -> Linear:
    """a f - b g."""
    one, cosine, sine = (
        builder.sub(builder.mul(a, u), builder.mul(b, v)) for u, v in zip(f, g, strict=True)
    )
    return one, cosine, sine


def _square(builder: Builder, f: Linear) -> Circle:
    """The square of l0 + l1 cos x + l2 sin x."""
    one, cosine, sine = f
    half = builder.div(builder.integer(1), builder.integer(2))
    cc, ss = builder.square(cosine), builder.square(sine)
    twice = builder.mul(builder.integer(2), one)
    return (
        builder.add(builder.square(one), builder.mul(half, builder.add(cc, ss))),
        builder.mul(twice, cosine),
        builder.mul(twice, sine),
        builder.mul(half, builder.sub(cc, ss)),
        builder.mul(cosine, sine),
    )


def _sum(builder: Builder, f: Circle, g: Circle) -> Circle:
    return tuple(builder.add(a, b) for a, b in zip(f, g, strict=True))
