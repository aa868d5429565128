"""The derivation: the steps that solve an arm, and what the values of a step are called."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum
from dhgen.method import Method
from dhgen.paul.kind import Kind, Part

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel
    from dhgen.numerical.kernel import NumericalKernel
    from dhgen.paul.pool import Pool
    from dhgen.paul.problem import Problem
    from dhgen.paul.step import Step


@dataclass(frozen=True, slots=True)
class Derivation:
    """Why the solver is what it is.

    Attributes:
        pool: The equations, with the points that have names.
        steps: In the order of solving.
        alternatives: At each step, the other steps that would have been valid.
        whole: For arms that no order of steps solves: the algorithm that takes them whole.
    """

    pool: Pool
    steps: tuple[Step, ...]
    alternatives: tuple[tuple[Step, ...], ...]
    whole: GeneralKernel | NumericalKernel | None = None

    @property
    def problem(self) -> Problem:
        """What is asked of the arm."""
        return self.pool.problem

    @property
    def method(self) -> Method:
        """How the arm is solved."""
        if self.whole is not None:
            return self.whole.method
        rooted = any(step.kind is Kind.CIRCLE for step in self.steps)
        return Method.QUARTIC if rooted else Method.CLOSED_FORM

    @property
    def branches(self) -> int:
        """The number of rows: the product of the steps' roots."""
        count = 1 if self.whole is None else self.whole.rows
        for step in self.steps:
            count *= step.roots
        return count


_WORDS = {
    "shoulder": ("left", "right"),
    "elbow": ("down", "up"),
    "wrist": ("noflip", "flip"),
    "slide": ("forward", "backward"),
}


def branch_words(steps: tuple[Step, ...]) -> tuple[tuple[str, ...], ...]:
    """The words for the values of every step with more than one, in the order of the steps.

    Those of a sign are for + and -; the roots of a polynomial are numbered by ascending angle.
    """
    branching = [step for step in steps if step.roots > 1]
    parts = [_part(step) for step in branching]
    words: list[tuple[str, ...]] = []
    for step, part in zip(branching, parts, strict=True):
        if part == "root":
            words.append(tuple(f"root{number}" for number in range(1, step.roots + 1)))
            continue
        plus, minus = _WORDS[part]
        if parts.count(part) > 1:
            joint = _first_joint(step)
            plus, minus = f"{plus}{joint}", f"{minus}{joint}"
        words.append((plus, minus))
    return tuple(words)


def branch_labels(words: tuple[tuple[str, ...], ...]) -> tuple[str, ...]:
    """The name of every row, e.g. left-down-noflip; the first sign changes slowest."""
    labels: list[tuple[str, ...]] = [()]
    for pair in words:
        labels = [(*label, word) for label in labels for word in pair]
    return tuple("-".join(label) or "only" for label in labels)


def _part(step: Step) -> str:
    part = step.kind.value.part
    if part is not Part.END:
        return str(part.value)
    return "shoulder" if _first_joint(step) == 1 else "wrist"


def _first_joint(step: Step) -> int:
    unknown = step.unknowns[0]
    return unknown.terms[0][0] if isinstance(unknown, AngleSum) else unknown.joint
