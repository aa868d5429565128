"""Vectors of values: what kernels that think in space are made of."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node


def cross(builder: Builder, left: Sequence[Node], right: Sequence[Node]) -> list[Node]:
    """left x right."""
    return [
        builder.sub(
            builder.mul(left[(k + 1) % 3], right[(k + 2) % 3]),
            builder.mul(left[(k + 2) % 3], right[(k + 1) % 3]),
        )
        for k in range(3)
    ]


def inner(builder: Builder, left: Sequence[Node], right: Sequence[Node]) -> Node:
    """left . right."""
    total = builder.integer(0)
    for a, b in zip(left, right, strict=True):
        total = builder.add(total, builder.mul(a, b))
    return total


def length(builder: Builder, vector: Sequence[Node]) -> Node:
    """|vector|."""
    total = builder.integer(0)
    for entry in vector:
        total = builder.add(total, builder.square(entry))
    return builder.apply("sqrt", total)


def scaled(builder: Builder, factor: Node, vector: Sequence[Node]) -> list[Node]:
    """factor times vector."""
    return [builder.mul(factor, entry) for entry in vector]


def plus(builder: Builder, left: Sequence[Node], right: Sequence[Node]) -> list[Node]:
    """left + right."""
    return [builder.add(a, b) for a, b in zip(left, right, strict=True)]


def minus(builder: Builder, left: Sequence[Node], right: Sequence[Node]) -> list[Node]:
    """left - right."""
    return [builder.sub(a, b) for a, b in zip(left, right, strict=True)]


def chosen(
    builder: Builder, condition: Node, yes: Sequence[Node], no: Sequence[Node]
) -> list[Node]:
    """One vector where the condition holds, else the other."""
    return [builder.select(condition, a, b) for a, b in zip(yes, no, strict=True)]
