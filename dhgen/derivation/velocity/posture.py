"""A posture in numbers of any kind: frames, the Jacobian, the letters of formulas."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import accumulate
from math import prod
from operator import add
from typing import TYPE_CHECKING

from dhgen.derivation.text.formula import Minus, Number, Power, Product, Quotient, Sum, Symbol
from dhgen.kinematics.chain import Fixed
from dhgen.kinematics.product import product
from dhgen.robot.task import Directions

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dhgen.derivation.story import Story
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.chain import Element
    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.transform import Transform

# Whole numbers and fractions where something is proven, floats where it is looked at.
Real = Fraction | float
Vector = list[Real]
Rows = list[Vector]


@dataclass(frozen=True, slots=True)
class Motion:
    """What turns about, or slides along, an axis.

    Attributes:
        joints: The joints that move it, each with a factor: one, or those of a passive row.
        axis: Its direction.
        point: Where it is; None for what slides.
    """

    joints: tuple[tuple[int, int], ...]
    axis: Vector
    point: Vector | None

    def velocity(self, tip: Vector) -> tuple[Vector, Vector]:
        """What it gives a point of velocity, and the angular velocity."""
        if self.point is None:
            return self.axis, [0, 0, 0]
        z, arm = self.axis, [a - b for a, b in zip(tip, self.point, strict=True)]
        return [z[i - 2] * arm[i - 1] - z[i - 1] * arm[i - 2] for i in range(3)], z


@dataclass(frozen=True, slots=True)
class Posture:
    """Values of the joints and of the arm's lengths.

    Attributes:
        story: The arm.
        turns: Cosine and sine of the angle of every joint that turns, by its number.
        slides: The length of every other.
        constants: The values of the arm's constants by their names.
    """

    story: Story
    turns: Mapping[int, tuple[Real, Real]]
    slides: Mapping[int, Real]
    constants: Mapping[str, Real]

    def letters(self) -> dict[str, Real]:
        """The value of every letter of formulas in joints, by its spelling in a terminal."""
        algebra, letters = self.story.algebra, self.story.letters
        found = {letters[name].text: value for name, value in self.constants.items()}
        for angle in algebra.angles:
            cosine, sine = self._turned(angle.terms)
            found[letters[angle.cosine].text] = cosine
            found[letters[angle.sine].text] = sine
        return found | {letters[name].text: self.slides[j] for j, name in algebra.slides.items()}

    def _turned(self, terms: Sequence[tuple[int, int]]) -> tuple[Real, Real]:
        """Cosine and sine of a sum of joints' angles, each times a whole number."""
        cosine: Real = 1
        sine: Real = 0
        for joint, times in terms:
            c, s = self.turns[joint]
            s = s if times > 0 else -s
            for _ in range(abs(times)):
                cosine, sine = cosine * c - sine * s, sine * c + cosine * s
        return cosine, sine

    def frames(self) -> tuple[list[Rows], list[Motion]]:
        """Frames 0 to n and the tool's, three rows each, and what moves from base to tool."""
        chain = self.story.algebra.chain
        T = self._matrix(chain.base)
        frames: list[Rows] = [T]
        motions: list[Motion] = []
        for link in chain.links:
            for element in link:
                if not isinstance(element, Fixed):
                    axis, point = ([row[column] for row in T] for column in (2, 3))
                    motions.append(Motion(element.signed, axis, point if element.turns else None))
                T = _chained(T, self._element(element))
            frames.append(T)
        frames.append(_chained(T, self._matrix(chain.tool)))
        return frames, motions

    def jacobian(self) -> Rows:
        """The rows of the Jacobian that the task names, of the joints that are solved for."""
        chain = self.story.algebra.chain
        frames, motions = self.frames()
        tip = [row[3] for row in frames[-1]]
        directions = spins_that_count(self.story, frames)
        size = len(chain.task.position_rows) + len(directions)
        columns: dict[int, Vector] = {joint.number: [0] * size for joint in chain.solved}
        for motion in motions:
            moved, spin = motion.velocity(tip)
            named = [moved[row] for row in chain.task.position_rows]
            named += [sum(a * b for a, b in zip(each, spin, strict=True)) for each in directions]
            for joint, times in motion.joints:
                if joint in columns:
                    factor = times * chain.joints[joint - 1].sign
                    added = zip(columns[joint], named, strict=True)
                    columns[joint] = [old + factor * new for old, new in added]
        return [list(row) for row in zip(*columns.values(), strict=True)]

    def _element(self, element: Element) -> Rows:
        if isinstance(element, Fixed):
            return self._matrix(element.transform)
        if element.turns:
            c, s = self._turned(element.signed)
            return [[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0]]
        length = sum(times * self.slides[joint] for joint, times in element.signed)
        return [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, length]]

    def _matrix(self, transform: Transform) -> Rows:
        return [[self._value(transform.entry(i, j)) for j in range(4)] for i in range(3)]

    def _value(self, polynomial: Polynomial) -> Real:
        """A polynomial in the chain's constants."""
        names = [symbol.name for symbol in polynomial.ring.symbols]
        total: Real = 0
        for powers, coefficient in polynomial.terms():
            above, below = int(coefficient.numerator), int(coefficient.denominator)
            factor = above if below == 1 else Fraction(above, below)
            used = zip(names, powers, strict=True)
            total += factor * prod(self.constants[name] ** power for name, power in used if power)
        return total


@lru_cache(maxsize=8)
def level_axis(story: Story) -> int | None:
    """The first frame whose z axis is always level, and at right angles to the tool's x axis.

    A turn about it changes the pitch by its own angle.
    """
    algebra = story.algebra
    links = [algebra.lifted(link) for link in algebra.chain.links]
    base, tool = (Fixed(algebra.lift(each)) for each in (algebra.chain.base, algebra.chain.tool))
    *frames, last = accumulate(links, add, initial=(base,))
    pointing = product([*last, tool], algebra).column(0)
    for frame, elements in enumerate([*frames, last]):
        axis = product(elements, algebra).column(2)
        along = sum((a * b for a, b in zip(axis, pointing, strict=True)), algebra.ring.zero)
        if not axis[2] and not algebra.normal(along):
            return frame
    return None


def spins_that_count(story: Story, frames: list[Rows]) -> list[Vector]:
    """What the task names of an angular velocity is its product with these vectors.

    That of the yaw is for tools whose x axis stays level, that of the pitch for those with a
    `level_axis`.

    Args:
        story: The arm.
        frames: Frames 0 to n and the tool's.
    """
    tool, directions = frames[-1], story.algebra.chain.task.directions
    match directions:
        case Directions.ROTATION:
            return [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
        case Directions.POINTING:
            return [[row[column] for row in tool] for column in (0, 1)]
        case Directions.TILT:
            return [[1, 0, 0], [0, 1, 0]]
        case Directions.YAW:
            return [[0, 0, 1]]
        case Directions.PITCH if (frame := level_axis(story)) is not None:
            return [[row[2] for row in frames[frame]]]
    return []


def _chained(A: Rows, B: Rows) -> Rows:
    """The product of two transforms."""
    product_ = [[sum(A[i][k] * B[k][j] for k in range(3)) for j in range(4)] for i in range(3)]
    for i in range(3):
        product_[i][3] += A[i][3]
    return product_


def exact_value(formula: Formula, letters: Mapping[str, Real]) -> Real:
    """What a formula of sums, products and powers is worth, in the arithmetic of its letters.

    Raises:
        KeyError: It is another formula, or a letter has no value.
    """
    match formula:
        case Symbol(text=text):
            return letters[text]
        case Number(value):
            return value
        case Minus(operand):
            return -exact_value(operand, letters)
        case Sum(terms):
            return sum(exact_value(term, letters) for term in terms)
        case Product(factors):
            return prod(exact_value(factor, letters) for factor in factors)
        case Quotient(over, under):
            return exact_value(over, letters) / exact_value(under, letters)
        case Power(base, exponent) if exponent > 0:
            return exact_value(base, letters) ** exponent
    raise KeyError(formula)
