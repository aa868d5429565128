"""The kernel of type 9: a trigonometric polynomial of degree 2 in the angle that stays."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum
from dhgen.program.ir import Failure
from dhgen.program.roots import letters

if TYPE_CHECKING:
    from dhgen.paul.step import Step
    from dhgen.program.builder import Builder
    from dhgen.program.graph import Node
    from dhgen.program.lower import Lowering

Linear = tuple["Node", "Node", "Node"]  # l0 + l1 cos x + l2 sin x
Circle = tuple["Node", ...]  # a0, a1, b1, a2, b2


def lower_circle(context: Lowering, step: Step) -> None:
    """Type 9: the sum of the squares of c_i and s_i is 1.

    With P and Q known, by Cramer's rule (Q1 R2 - Q2 R1)^2 + (R1 P2 - R2 P1)^2 = (P1 Q2 - Q1 P2)^2;
    with (P1 + i Q1) V2 = (P2 + i Q2) V1,
    |V1|^2 |R1 V2 - R2 V1|^2 = Im(V1 conj V2)^2 (P1^2 + Q1^2).
    """
    (angle,) = step.unknowns
    assert isinstance(angle, AngleSum)
    builder = context.builder
    p1, p2, q1, q2, r1, r2 = (
        _linear(context, step, name) for name in ("P1", "P2", "Q1", "Q2", "R1", "R2")
    )
    if step.has("V1x"):
        left, right = _turned(context, step, (r1, r2))
        square = _scaled(builder, right, _sum(builder, _square(builder, p1), _square(builder, q1)))
        polynomial = tuple(builder.sub(a, b) for a, b in zip(left, square, strict=True))
    else:
        cosine = _combined(builder, r2, q1[0], r1, q2[0])
        sine = _combined(builder, r1, p2[0], r2, p1[0])
        determinant = builder.sub(builder.mul(p1[0], q2[0]), builder.mul(q1[0], p2[0]))
        total = _sum(builder, _square(builder, cosine), _square(builder, sine))
        polynomial = (builder.sub(total[0], builder.square(determinant)), *total[1:])
    root = context.new_root(f"x{angle.suffix}", polynomial)
    builder.guard(builder.apply("at_most", root, builder.integer(4)), Failure.REACH)
    context.angles.solved_by_angle(angle, root)


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
