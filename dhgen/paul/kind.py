"""The types of equations, a row each: what a reader finds in the documents, and what it gives."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum, unique


class Part(Enum):
    """The part of the arm that a step with several values places."""

    SLIDE = "slide"
    ELBOW = "elbow"
    END = "shoulder or wrist"  # whichever the joint is nearer to
    ROOT = "root"  # none in particular


@dataclass(frozen=True, slots=True)
class Type:
    """A type of equations.

    Attributes:
        number: In document 003; types beyond its table are counted on.
        equations: s_i and c_i are sine and cosine of an unknown angle, r is an unknown length, and
            capitals are known.
        roots: How many values a step gives.
        part: What these values place.
        divisors: Letters that an unknown is divided by, those of one divisor together.
        leading: Letters of which one has to differ from zero for an equation to hold its angle.
        document_002: Its number in document 002, which has four types.
        in_003: Whether document 003 has it.
    """

    number: int
    equations: tuple[str, ...]
    roots: int
    part: Part = Part.END
    divisors: tuple[tuple[str, ...], ...] = ()
    leading: tuple[str, ...] = ()
    document_002: int | None = None
    in_003: bool = True


@unique
class Kind(Enum):
    """The types that steps are of."""

    LENGTH = Type(1, ("X r = Y",), 1, divisors=(("X",),))
    ANGLE = Type(
        2, ("X s_i + Y c_i = Z",), 2, divisors=(("X", "Y"),), leading=("X", "Y"), document_002=2
    )
    ANGLE_PAIR = Type(
        3,
        ("X_1 s_i + Y_1 c_i = Z_1", "X_2 s_i + Y_2 c_i = Z_2"),
        1,
        divisors=(("X1", "Y1"), ("X2", "Y2")),
        leading=("X1", "Y1"),
        document_002=4,
    )
    POLAR = Type(4, ("X_1 r s_i = Y_1", "X_2 r c_i = Y_2"), 2, Part.SLIDE, leading=("Y1", "Y2"))
    ANGLE_AND_LENGTH = Type(5, ("X_1 s_i = Y_1 + Z_1 r", "X_2 c_i = Y_2 + Z_2 r"), 2, Part.SLIDE)
    TWO_ANGLES = Type(
        6, ("W s_j = X c_i + Y s_i + Z_1", "W c_j = X s_i - Y c_i + Z_2"), 2, Part.ELBOW
    )
    TWO_ANGLES_TURNED = Type(
        7,
        ("W_1 c_j + W_2 s_j = X c_i + Y s_i + Z_1", "W_1 s_j - W_2 c_j = X s_i - Y c_i + Z_2"),
        2,
        Part.ELBOW,
    )
    ANGLE_AND_SUM = Type(
        8,
        (
            r"X c_i + Y \cos(\theta_i + \theta_j) = Z_1",
            r"X s_i + Y \sin(\theta_i + \theta_j) = Z_2",
        ),
        2,
        Part.ELBOW,
        document_002=3,
    )
    CIRCLE = Type(
        9,
        (
            "X_1 s_i + Y_1 c_i + V_1 s_j + W_1 c_j = Z_1",
            "X_2 s_i + Y_2 c_i + V_2 s_j + W_2 c_j = Z_2",
        ),
        4,
        Part.ROOT,
        in_003=False,
    )
    SQUARED_LENGTH = Type(10, ("X r^2 + Y r = Z",), 2, Part.SLIDE, in_003=False)
    TWO_LENGTHS = Type(11, ("X_1 r_i + Y_1 r_j = Z_1", "X_2 r_i + Y_2 r_j = Z_2"), 1, in_003=False)

    @property
    def number(self) -> int:
        """The number that a reader finds."""
        return self.value.number

    @property
    def is_two_links(self) -> bool:
        """Whether the equations are a triangle of two links, of which the squares give an angle."""
        return self.value.part is Part.ELBOW
