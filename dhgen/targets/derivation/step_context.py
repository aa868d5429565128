"""One step on its way to paper: its equations, letters, sign, and what it leaves to say."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum
from dhgen.targets.derivation.formula import Formula, Number, Symbol, equal, number
from dhgen.targets.derivation.names import letter, unknown_symbol
from dhgen.targets.derivation.story import Story, other_form, remembered_letter

if TYPE_CHECKING:
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.step import Step
    from dhgen.targets.derivation.blocks import Block, Prose


@dataclass(frozen=True, slots=True)
class Singularity:
    """A place where a step gives other than its usual number of values.

    Attributes:
        step: Its number.
        condition: In terms of the pose or of earlier steps.
        joints: The same in terms of the joint angles, when that is short.
        meaning: What the arm looks like there.
        effect: What happens.
    """

    step: int
    condition: Formula
    joints: Formula | None
    meaning: Prose
    effect: Prose


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
    def sign(self) -> Formula:
        """The branch sign."""
        return self.story.sign_of(self.number) or number(1)

    @property
    def unknown(self) -> Symbol:
        """The letter of the first unknown."""
        return unknown_symbol(self.step.unknowns[0])

    def polynomial(self, name: str) -> Polynomial:
        """What stands behind a letter of the type."""
        return self.step.coefficient(name)

    def value(self, name: str) -> Formula:
        """The same, with the letters that earlier steps gave to forms."""
        return self.story.write(self.polynomial(name), self.number)

    def definition(self, name: str) -> Formula:
        """X = ..., in full and, when that differs, with the letters of earlier steps."""
        polynomial = self.polynomial(name)
        full = self.story.write(polynomial)
        return equal(type_letter(name), full, self.story.write(polynomial, self.number))

    def is_constant(self, *names: str) -> bool:
        """Whether letters are made of the arm's lengths alone."""
        return all(self.story.algebra.is_constant(self.polynomial(name)) for name in names)

    def is_number(self, name: str) -> bool:
        """Whether a letter is a plain number."""
        polynomial = self.polynomial(name)
        return not polynomial or polynomial.is_ground

    def is_used_later(self) -> bool:
        """Whether a later step needs Y s - X c of this one."""
        mine = other_form(self.story.algebra, self.step)
        letter_ = remembered_letter(self.step)
        if all(number != self.number for number, _, _ in self.story.remembered):
            return False
        del mine
        later = enumerate(self.story.steps[self.number :], start=self.number + 1)
        return any(
            occurs(letter_, self.story.write(polynomial, number))
            for number, step in later
            for _, polynomial in step.coefficients
        )


def type_letter(name: str) -> Symbol:
    """X, Z_1."""
    return letter(name[0], name[0], name[1:])


def occurs(symbol: Symbol, formula: Formula) -> bool:
    """Whether a symbol stands in a formula."""
    if formula == symbol:
        return True
    if isinstance(formula, Symbol | Number):
        return False
    return any(occurs(symbol, part) for part in parts_of(formula))


def parts_of(formula: Formula) -> tuple[Formula, ...]:
    """The formulas that a formula is made of."""
    match formula:
        case Symbol() | Number():
            return ()
        case _:
            found: list[Formula] = []
            for name in formula.__slots__:
                part = getattr(formula, name)
                if isinstance(part, tuple):
                    found += [p for p in part if not isinstance(p, str | tuple)]
                elif not isinstance(part, int | str):
                    found.append(part)
            return tuple(found)
