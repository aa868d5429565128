"""The second equation of type 2 with Z = 0, which keeps the angle where X and Y vanish."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.derivation.conditions import unsigned
from dhgen.derivation.geometry import size_in_words
from dhgen.derivation.notation.expressions import number_symbol
from dhgen.derivation.notation.matrices import element_of
from dhgen.derivation.notation.names import ARM_SIZE, cosine, sine, theta
from dhgen.derivation.step_context import type_letter
from dhgen.derivation.text.blocks import Given, display, paragraph, say
from dhgen.derivation.text.formula import (
    ONE,
    ZERO,
    Call,
    Symbol,
    add,
    atan2,
    equal,
    minus,
    over,
    times,
)
from dhgen.paul.equation import MOMENT
from dhgen.paul.fallback_equation import across

if TYPE_CHECKING:
    from dhgen.derivation.step_context import StepContext
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.step import Step


PRIMED = {name: Symbol(f"{name}'", f"{name}'") for name in "XY"}
ADDED = {name: Symbol(rf"\hat {name}", f"{name}^") for name in "XY"}
WEIGHT = Symbol(r"\sigma", "σ")
OF_MOMENT = ", an element of the cross product of columns 3 and 4"
FACING = -1  # the pool's equations are right - left, those on paper left = right


@dataclass(frozen=True, slots=True)
class Fallback:
    """A second equation on paper.

    Attributes:
        context: Its step's.
        step: The equation as a step.
    """

    context: StepContext
    step: Step

    @classmethod
    def of(cls, context: StepContext) -> Fallback | None:
        """The fallback equation of a step, if it has one."""
        return None if context.step.fallback is None else cls(context, context.step.fallback)

    def blocks(self, sign: Formula) -> list[Block]:
        """Its place, its letters, how both are added, and the angle of the sum.

        Args:
            sign: Of the branch.
        """
        story, angle = self.context.story, self.context.angle
        (form,) = self.step.forms
        (origin,) = self.step.origins
        shown = equal(story.write(form.equation.left), story.write_forward(form.equation.right))
        left = add(times(PRIMED["X"], sine(angle)), times(PRIMED["Y"], cosine(angle)))
        letters = (
            equal(PRIMED[name], story.write(self.step.coefficient(name) * FACING)) for name in "XY"
        )
        x, y = type_letter("X"), type_letter("Y")
        sums = (
            equal(ADDED[name], add(type_letter(name), times(WEIGHT, *self._scaled(PRIMED[name]))))
            for name in "XY"
        )
        along = add(times(x, PRIMED["X"]), times(y, PRIMED["Y"]))
        return [
            paragraph(
                "Where {} and {} are small, this says little about {}. The task fixes more numbers "
                "than the arm has joints, so the pose gives a second equation; from {}{}:",
                x,
                y,
                theta(angle),
                element_of(origin),
                say(OF_MOMENT if origin.column == MOMENT else ""),
            ),
            display(shown),
            paragraph("This is {} with", equal(left, ZERO)),
            display(*letters),
            paragraph(
                "For poses that the arm can take the vectors ({}, {}) and ({}, {}) lie along one "
                "line. They are added, the second one turned to the side of the first. With {}{}:",
                x,
                y,
                *PRIMED.values(),
                self._size(),
                equal(Call("sgn", (ZERO,)), ONE),
            ),
            display(equal(WEIGHT, Call("sgn", (along,))), *sums),
            paragraph("The sum has the direction of both, and takes their place:"),
            display(
                equal(
                    theta(angle),
                    atan2(times(sign, ADDED["Y"]), minus(times(sign, ADDED["X"]))),
                )
            ),
        ]

    @property
    def _power(self) -> int:
        """How many lengths more the first equation's letters are products of."""
        degree = self.context.story.algebra.degree
        first, second = (
            degree(*(step.coefficient(name) for name in "XY"))
            for step in (self.context.step, self.step)
        )
        return first - second

    def _scaled(self, letter: Formula) -> tuple[Formula, ...]:
        """A letter of the second equation, with as many lengths as the first equation's."""
        power = self._power
        if power < 0:
            return (over(letter, times(*[ARM_SIZE] * -power)),)
        return (*[ARM_SIZE] * power, letter)

    def _size(self) -> Prose:
        """What makes both comparable."""
        chain = self.context.story.algebra.chain
        if not self._power:
            return say("")
        return say(
            f"{{}} {{}}, the arm's size ({size_in_words(chain)}), and ",
            equal(ARM_SIZE, number_symbol(float(f"{chain.size:.12g}"))),
            Given(self.context.story.robot.length_unit),
        )

    def condition(self, first: Polynomial | None) -> Formula | None:
        """Where both equations degenerate, in joint angles: Y s - X c is zero for both."""
        if first is None:
            return None
        story = self.context.story
        here = across(story.derivation.pool, self.step)
        return equal(unsigned(story, first), unsigned(story, here), ZERO)
