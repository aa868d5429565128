"""The derivation in a dozen lines, for the terminal after a run."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.targets.derivation.names import unknown_symbol
from dhgen.targets.derivation.plain import words
from dhgen.targets.derivation.steps import element_of
from dhgen.targets.derivation.style import PLAIN, show
from dhgen.targets.derivation.words import counted, many

if TYPE_CHECKING:
    from dhgen.targets.derivation.step_context import Singularity
    from dhgen.targets.derivation.story import Story


def summary_text(story: Story, singular: list[Singularity]) -> str:
    """A line for every step, then the branches and the singular places."""
    lines = [_step(story, number) for number in range(1, len(story.steps) + 1)]
    width = max(len(head) for head, _ in lines)
    text = [f"{head:<{width}}  {rest}" for head, rest in lines]
    rows = story.program.rows
    signs = ", ".join(axis.name.replace("e", "ε") for axis in story.program.axes)
    text.append(f"branches: {counted(rows, 'row')}" + (f", signs {signs}" if signs else ""))
    if story.has_branch_words:
        text.append("  " + ", ".join(story.branch_names))
    if singular:
        text.append("degenerate: " + "; ".join(_singular(each) for each in singular))
    if story.derivation.problem.redundant:
        text.append("every pose is checked: the task asks for more than the arm can choose")
    return "\n".join(text) + "\n"


def _step(story: Story, number: int) -> tuple[str, str]:
    step = story.steps[number - 1]
    names = ", ".join(unknown_symbol(unknown).text for unknown in step.unknowns)
    where = " and ".join(show(element_of(origin), PLAIN) for origin in step.origins)
    values = counted(step.roots, "value")
    return f"{number}. {names}: type {step.kind.value}, {values},", f"from {where}"


def _singular(each: Singularity) -> str:
    condition = each.condition if each.joints is None else each.joints
    return f"step {each.step} when {show(condition, PLAIN)} ({words(each.meaning)})"


__all__ = ["many", "summary_text"]
