"""A posture in numbers of any kind: frames, the Jacobian, the letters of formulas."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import prod
from typing import TYPE_CHECKING

from dhgen.derivation.text.formula import Minus, Number, Power, Product, Sum, Symbol
from dhgen.kinematics.chain import Fixed, Slide, Turn
from dhgen.robot.task import Directions

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.derivation.story import Story
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.chain import Element
    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.transform import Transform

# Whole numbers and fractions where something is proven, floats where it is looked at.
Real = Fraction | float
Vector = list[Real]
Rows = list[Vector]
Axis = tuple[Vector, Vector | None]  # a direction, and a point where the joint turns


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
            cosine: Real = 1
            sine: Real = 0
            for joint, sign in angle.terms:
                c, s = self.turns[joint]
                cosine, sine = cosine * c - sign * sine * s, sine * c + sign * cosine * s
            found[letters[angle.cosine].text] = cosine
            found[letters[angle.sine].text] = sine
        return found | {letters[name].text: self.slides[j] for j, name in algebra.slides.items()}

    def frames(self) -> tuple[list[Rows], list[Axis]]:
        """Frames 0 to n and the tool's, three rows each; axes with a point where they turn."""
        chain = self.story.algebra.chain
        T = self._matrix(chain.base)
        frames: list[Rows] = [T]
        axes: list[Axis] = []
        for link in chain.links:
            for element in link:
                if not isinstance(element, Fixed):
                    axis: Vector = [element.sign * row[2] for row in T]
                    axes.append(
                        (axis, [row[3] for row in T] if isinstance(element, Turn) else None)
                    )
                T = _chained(T, self._element(element))
            frames.append(T)
        frames.append(_chained(T, self._matrix(chain.tool)))
        return frames, axes

    def jacobian(self) -> Rows:
        """The rows of the Jacobian that the task names, of the joints that are solved for."""
        chain = self.story.algebra.chain
        frames, axes = self.frames()
        tip = [row[3] for row in frames[-1]]
        columns: list[Vector] = []
        for joint, (axis, point) in zip(chain.joints, axes, strict=True):
            arm = None if point is None else [a - b for a, b in zip(tip, point, strict=True)]
            still: Vector = [0, 0, 0]
            spin = axis if arm is not None else still
            moved = axis if arm is None else crossed(axis, arm)
            if joint.number not in chain.free:
                columns.append([joint.sign * each for each in self._named(moved, spin, frames[-1])])
        return [list(row) for row in zip(*columns, strict=True)]

    def _named(self, moved: Vector, spin: Vector, tool: Rows) -> Vector:
        """What the task names of a velocity and an angular velocity."""
        task = self.story.algebra.chain.task
        named = [moved[row] for row in task.position_rows]
        if task.directions is Directions.ROTATION:
            return named + spin
        if task.directions is Directions.POINTING:
            return named + [sum(tool[k][i] * spin[k] for k in range(3)) for i in range(2)]
        return named

    def _element(self, element: Element) -> Rows:
        if isinstance(element, Fixed):
            return self._matrix(element.transform)
        if isinstance(element, Turn):
            c, s = self.turns[element.joint]
            s = element.sign * s
            return [[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0]]
        assert isinstance(element, Slide), "no arm with passive rows"
        length = element.sign * self.slides[element.joint]
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


def crossed(a: Vector, b: Vector) -> Vector:
    """The vector product."""
    return [a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3)]


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
        case Power(base, exponent) if exponent > 0:
            return exact_value(base, letters) ** exponent
    raise KeyError(formula)
