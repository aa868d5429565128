"""How far values of a program may be away holds at all poses near by, and is not far too much."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.nominal.bounds import Bounds, NoBoundError
from dhgen.program.building.builder import Builder
from dhgen.program.interpret import outputs
from tests.nominal.test_certificate import rotations

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.program.building.graph import Node

POSES, AROUND = 200, 400
ANGLE, LENGTH = 2e-3, 3e-3


def unit(b: Builder) -> Node:
    """What the radii of operands alone can't tell: it is the sine of an angle."""
    x, y = b.pose(1, 4), b.pose(2, 4)
    return b.div(y, b.apply("sqrt", b.add(b.square(x), b.square(y))))


def cancelling(b: Builder) -> Node:
    return b.sub(b.mul(b.pose(1, 1), b.pose(2, 4)), b.mul(b.pose(2, 1), b.pose(1, 4)))


def root(b: Builder) -> Node:
    return b.apply("sqrt", b.sub(b.square(b.pose(3, 4)), b.mul(b.pose(1, 3), b.pose(2, 3))))


def inverse(b: Builder) -> Node:
    return b.div(b.pose(1, 2), b.add(b.square(b.pose(1, 4)), b.square(b.pose(3, 4))))


def constant(b: Builder) -> Node:
    return b.div(b.mul(b.integer(3), b.neg(b.pose(3, 3))), b.integer(2))


def lipschitz(b: Builder) -> Node:
    return b.apply("maximum", b.apply("cos", b.pose(1, 4)), b.apply("abs", b.pose(2, 2)))


def around(T: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """Poses on the edge of the ball around each one, (AROUND * N, 4, 4)."""
    other = np.repeat(T, AROUND, axis=0)
    way = rng.normal(size=(len(other), 3))
    other[:, :3, 3] += LENGTH * way / np.linalg.norm(way, axis=1)[:, None]
    other[:, :3, :3] = rotations(rng, ANGLE, len(other)) @ other[:, :3, :3]
    return other


@pytest.mark.parametrize("made", [unit, cancelling, root, inverse, constant, lipschitz])
def test_values_near_by_are_within_the_radius(made: Callable[[Builder], Node]) -> None:
    builder, rng = Builder(), np.random.default_rng(2)
    value = made(builder)
    radius = Bounds(builder, builder.given(1), builder.given(2)).radius(value)
    assert radius is not None
    program = builder.finish("bound", {"value": value, "radius": radius}, [])
    T = np.tile(np.eye(4), (POSES, 1, 1))
    T[:, :3, :3] = rotations(rng, 2.0, POSES)
    T[:, :3, 3] = rng.uniform(0.4, 1.0, (POSES, 3)) * rng.choice([-1.0, 1.0], (POSES, 3))
    T[:, 2, 3] = np.sign(T[:, 2, 3]) * (
        1.0 + np.abs(T[:, 2, 3])
    )  # what is under the root exceeds 0
    ball = np.tile([ANGLE, LENGTH], (POSES, 1))
    here, bound = (each[:, 0] for each in outputs(program, T, free=ball))
    there = outputs(program, around(T, rng), free=np.repeat(ball, AROUND, axis=0))[0][:, 0]
    most = np.abs(there.reshape(POSES, AROUND) - here[:, None]).max(axis=1)
    assert (most <= bound).all()
    assert np.median(bound / most) < (1.3 if made is not lipschitz else 10.0)


def test_what_has_no_bound() -> None:
    builder = Builder()
    bounds = Bounds(builder, builder.given(1), builder.given(2))
    with pytest.raises(NoBoundError):
        bounds.radius(builder.apply("atan2", builder.pose(1, 4), builder.pose(2, 4)))
    assert bounds.radius(builder.apply("atan2", builder.given(1), builder.integer(1))) is None


def test_sums_of_squares_are_seen_through_products() -> None:
    builder = Builder()
    bounds = Bounds(builder, builder.given(1), builder.given(2))
    x, y, f = builder.pose(1, 3), builder.pose(2, 3), builder.given(3)
    fx = builder.mul(f, x)
    node = builder.add(builder.square(y), builder.mul(f, builder.mul(x, fx)))
    assert set(bounds.squared(node)) == {y, fx}
    assert set(bounds.squared(builder.add(builder.square(y), x))) == {y, None}
