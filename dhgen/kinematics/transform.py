"""Rigid transforms whose entries are polynomials, and the normal form of their products."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from sympy.polys.rings import PolyRing

    from dhgen.kinematics.constants import ConstantTable, Polynomial
    from dhgen.kinematics.normal import NormalForm
    from dhgen.robot.robot import Frame


AXES = range(3)


@dataclass(frozen=True, slots=True)
class Transform:
    """A rotation (three rows of three) and a translation.

    Attributes:
        rotation: Rows of the rotation matrix.
        translation: Origin of the second frame in the first [length].
    """

    rotation: tuple[tuple[Polynomial, ...], ...]
    translation: tuple[Polynomial, ...]

    def entry(self, row: int, column: int) -> Polynomial:
        """The element in `row` and `column`, both from 0; column 3 is the translation."""
        return self.translation[row] if column == 3 else self.rotation[row][column]

    def column(self, column: int) -> tuple[Polynomial, ...]:
        """One column, from 0; column 3 is the translation."""
        return tuple(self.entry(row, column) for row in AXES)

    def mapped(self, change: Callable[[Polynomial], Polynomial]) -> Transform:
        """The transform with every entry changed."""
        return Transform(
            tuple(tuple(change(entry) for entry in row) for row in self.rotation),
            tuple(change(entry) for entry in self.translation),
        )


def identity(ring: PolyRing) -> Transform:
    """No motion."""
    zero, one = ring.zero, ring.one
    rows = tuple(tuple(one if i == j else zero for j in AXES) for i in AXES)
    return Transform(rows, (zero, zero, zero))


def translation(ring: PolyRing, vector: Sequence[Polynomial]) -> Transform:
    """A pure translation."""
    return Transform(identity(ring).rotation, tuple(vector))


def rotation_x(ring: PolyRing, cosine: Polynomial, sine: Polynomial) -> Transform:
    """A rotation about x."""
    zero, one = ring.zero, ring.one
    rows = ((one, zero, zero), (zero, cosine, -sine), (zero, sine, cosine))
    return Transform(rows, (zero, zero, zero))


def rotation_z(ring: PolyRing, cosine: Polynomial, sine: Polynomial) -> Transform:
    """A rotation about z."""
    zero, one = ring.zero, ring.one
    rows = ((cosine, -sine, zero), (sine, cosine, zero), (zero, zero, one))
    return Transform(rows, (zero, zero, zero))


def dot(row: Sequence[Polynomial], column: Sequence[Polynomial], normal: NormalForm) -> Polynomial:
    """A row times a column, in normal form."""
    return normal.products((1, left, right) for left, right in zip(row, column, strict=True))


def compose(first: Transform, second: Transform, normal: NormalForm) -> Transform:
    """The product of two transforms, every entry in normal form."""
    columns = tuple(zip(*second.rotation, strict=True))
    rows = tuple(tuple(dot(row, column, normal) for column in columns) for row in first.rotation)
    moved = tuple(
        normal(dot(row, second.translation, normal) + start)
        for row, start in zip(first.rotation, first.translation, strict=True)
    )
    return Transform(rows, moved)


def inverse(transform: Transform, normal: NormalForm) -> Transform:
    """The inverse of a rigid transform: transposed rotation (document 002)."""
    rows = tuple(zip(*transform.rotation, strict=True))
    moved = tuple(-dot(row, transform.translation, normal) for row in rows)
    return Transform(rows, moved)


def turn_between(rotation: Sequence[Sequence[Polynomial]]) -> int:
    """+1 or -1 when the rotation keeps or reverses the direction of z, else 0."""
    third = rotation[2][2]
    if third.ring.one == third:
        return 1
    return -1 if -third.ring.one == third else 0


def read_frame(frame: Frame, table: ConstantTable, letter: str, meaning: str) -> Transform:
    """A constant frame; its numbers get names that begin with `letter`."""
    rotation = [
        table.scalar(
            entry,
            f"{letter}{place // 3 + 1}{place % 3 + 1}",
            f"{meaning}, entry {place // 3 + 1},{place % 3 + 1}",
        )
        for place, entry in enumerate(frame.rotation)
    ]
    origin = [
        table.length(entry, f"{letter}{axis}", f"{axis} of the {meaning}")
        for axis, entry in zip("xyz", frame.xyz, strict=True)
    ]
    rows = tuple(tuple(rotation[3 * row : 3 * row + 3]) for row in range(3))
    return Transform(rows, tuple(origin))
