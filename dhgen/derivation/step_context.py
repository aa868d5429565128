"""One step on its way to paper: its equations, letters, sign, and what is left to print."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.derivation.geometry import NEAR
from dhgen.derivation.notation.names import letter, unknown_symbol
from dhgen.derivation.text.formula import equal
from dhgen.derivation.text.lines import width
from dhgen.derivation.text.walk import occurs
from dhgen.kinematics.algebra import AngleSum
from dhgen.kinematics.ring import terms_in_numbers
from dhgen.paul.kind import Kind

if TYPE_CHECKING:
    from dhgen.derivation.quotes import Quote
    from dhgen.derivation.story import Remembered, Story
    from dhgen.derivation.sums_left import SumLeft
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.derivation.text.formula import Formula, Relation, Symbol
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.step import Step

SHORT = 14  # visible characters of a value that may be in a line of text


@dataclass(frozen=True, slots=True)
class Singularity:
    """A place where a step gives other than its usual number of values.

    Attributes:
        step: Its number; 0 for the arm angle.
        condition: In terms of the pose or of the step's letters, or in words.
        joints: The same in terms of the joint angles, when that is short.
        meaning: What the arm looks like there.
        effect: What happens.
        frees: Whether a joint takes the seed's value.
        left: What is still known of two angles, where it is their sum or difference.
    """

    step: int
    condition: Formula | Prose
    joints: Formula | Prose | None
    meaning: Prose
    effect: Prose
    frees: bool = False
    left: SumLeft | None = None


@dataclass(frozen=True, slots=True)
class StepText:
    """A step written out.

    Attributes:
        blocks: What follows the equations.
        singularities: For the table.
    """

    blocks: tuple[Block, ...]
    singularities: tuple[Singularity, ...] = ()


@dataclass(frozen=True, slots=True)
class StepContext:
    """What a type's printer draws from.

    Attributes:
        story: The derivation.
        number: The step's number, from 1.
        step: The step.
    """

    story: Story
    number: int
    step: Step

    @property
    def angle(self) -> AngleSum:
        """The angle that becomes known."""
        return next(u for u in self.step.unknowns if isinstance(u, AngleSum))

    @property
    def quotes(self) -> tuple[Quote, ...]:
        """The equations as they are in the matrices."""
        return self.story.quotes[self.number - 1]

    @property
    def sign(self) -> Formula:
        """The branch sign."""
        return self.story.sign_of(self.number)

    @property
    def unknown(self) -> Symbol:
        """The letter of the first unknown."""
        return unknown_symbol(self.step.unknowns[0])

    @property
    def remembered(self) -> Remembered | None:
        """Y s - X c of this step, when a later step uses it."""
        for each in self.story.remembered:
            if each.step == self.number and self._is_used(each.letter):
                return each
        return None

    def _is_used(self, symbol: Symbol) -> bool:
        later = enumerate(self.story.steps[self.number :], start=self.number + 1)
        return any(
            occurs(symbol, self.story.write(polynomial, number_))
            for number_, step in later
            for _, polynomial in step.coefficients
        )

    def polynomial(self, name: str) -> Polynomial:
        """The value of a letter of the type, for the equation as it is read."""
        return self.step.coefficient(name) * self._facing(name)

    def _facing(self, name: str) -> int:
        if self.step.kind is Kind.ANGLE:
            return 1  # its sign is that of the rule for the two values
        facings = [quote.facing for quote in self.quotes]
        if len(facings) == 1:
            return facings[0]
        if not name[1:2].isdigit():
            return 1  # of what both equations become
        if self.step.kind.is_two_links and name not in {"Z1", "Z2"}:
            return 1
        return facings[int(name[1]) - 1]  # X1, Z2, P1c: the equation's number comes second

    @property
    def determinant(self) -> Polynomial:
        """X1 Y2 - X2 Y1 of a pair of equations as they are quoted."""
        x1, y1, x2, y2 = (self.polynomial(name) for name in ("X1", "Y1", "X2", "Y2"))
        return self.story.algebra.normal(x1 * y2 - x2 * y1)

    def value(self, name: str) -> Formula:
        """The value as a formula, with the letters that earlier steps gave to forms."""
        return self.story.write(self.polynomial(name), self.number)

    def in_full(self, polynomial: Polynomial) -> Formula:
        """A polynomial without the letters that earlier steps gave to forms."""
        return self.story.write_quoted(polynomial, self.number)

    def definition(self, name: str) -> Relation:
        """X = ..., in full and, when that differs, with the letters of earlier steps."""
        polynomial = self.polynomial(name)
        full, short = self.in_full(polynomial), self.story.write(polynomial, self.number)
        return equal(type_letter(name), full, short)

    def are_short(self, *names: str) -> bool:
        """Whether the letters' values are short enough for a line of text."""
        return all(width(self.definition(name)) <= SHORT + 4 for name in names)

    def is_constant(self, *names: str) -> bool:
        """Whether letters are made of the arm's lengths alone."""
        return all(self.story.algebra.is_constant(self.step.coefficient(name)) for name in names)

    def vanishes(self, name: str) -> bool:
        """Whether a letter is zero, or made of lengths that cancel with the arm's numbers."""
        if not self.is_constant(name):
            return False
        values = {constant.name: constant.value for constant in self.story.algebra.chain.constants}
        terms = terms_in_numbers(self.polynomial(name), values)
        return abs(sum(terms)) <= NEAR * sum(map(abs, terms))

    def is_number(self, name: str) -> bool:
        """Whether a letter is a plain number."""
        polynomial = self.polynomial(name)
        return not polynomial or bool(polynomial.is_ground)


def type_letter(name: str) -> Symbol:
    """X, Z_1."""
    return letter(name[0], name[0], name[1:])
