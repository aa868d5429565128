"""What the two values of a step are called: the words of BRANCHES and of the solution tree.

The words name the sign, by the part of the arm that the step places: shoulder (left, right),
elbow (down, up), wrist (noflip, flip), a slide (forward, backward). Which of the two looks like
its name depends on how the arm is mounted; what a row means never changes.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum
from dhgen.paul.kind import Part

if TYPE_CHECKING:
    from dhgen.paul.step import Step

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
