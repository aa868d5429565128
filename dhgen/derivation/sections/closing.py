"""The last sections: the tree, singular configurations."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import unknown_symbol
from dhgen.derivation.sections.shoulder import PSI
from dhgen.derivation.steps import has_signed_roots
from dhgen.derivation.text.blocks import Drawing, Heading, Table, joined, paragraph, say
from dhgen.derivation.text.formula import ZERO, Symbol, equal
from dhgen.derivation.velocity.determinant import OF_VELOCITY, determinant_of
from dhgen.program.walk import finds_roots
from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from dhgen.derivation.step_context import Singularity
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block
    from dhgen.program.ir import Axis


ENDING = (
    "A branch ends where a square root has a negative argument; its rows are empty and the other "
    "rows keep their places."
)
ASCENDING = (
    "The roots are in the order of their angles, from root 1; where there are fewer than four, the "
    "rows of the last ones are empty. So where two roots meet and vanish, the roots "
    "above them change their rows."
)
UNDER_A_ROOT = (
    " Under each root a branch ends where a square root has a negative argument; its row is empty "
    "and the other one keeps its place."
)


def solutions_section(story: Story) -> list[Block]:
    """The tree, and what becomes of branches that have no solution."""
    blocks: list[Block] = [Heading(2, say("The solutions")), Drawing(tree_text(story))]
    if finds_roots(story.program):
        blocks.append(paragraph(ASCENDING + (UNDER_A_ROOT if has_signed_roots(story) else "")))
    elif has_signed_roots(story):
        blocks.append(paragraph(ENDING))
    return blocks


def singular_section(story: Story, found: list[Singularity]) -> list[Block]:
    """One line for every place where a step gives other than its usual number of values.

    Args:
        story: The derivation.
        found: The places.
    """
    blocks: list[Block] = [Heading(2, say("Singular configurations"))]
    if not found:
        return [
            *blocks,
            paragraph("None: no step degenerates, and no two solutions meet."),
            *_by_position_alone(story),
        ]
    header = tuple(say(word) for word in ("step", "condition", "in joint angles", "then"))
    rows = tuple(
        (
            say(str(each.step)) if each.step else say("{}", PSI),
            say("{}", each.condition),
            say("no short form") if each.joints is None else say("{}", each.joints),
            say("{}; {}", each.meaning, each.effect),
        )
        for each in found
    )
    return [*blocks, Table(header, rows)]


def _by_position_alone(story: Story) -> list[Block]:
    """Where an arm would be singular for positions alone, though it is not for whole poses."""
    if story.algebra.chain.task.kind is not TaskKind.POSE:
        return []
    found = determinant_of(story, by_position=True)
    factors = found.factors if found else ()
    vanishing = [f for f in factors if not f.is_never_zero and f.formula != OF_VELOCITY]
    if not vanishing:
        return []
    return [
        paragraph(
            "Where {} the rows of {} for the position alone are dependent, as in any arm that is "
            "stretched or drawn in; the given orientation still fixes the joints.",
            joined([say("{}", equal(each.formula, ZERO)) for each in vanishing], " or "),
            Symbol("J", "J"),
        )
    ]


def tree_text(story: Story) -> str:
    """One line for every leaf, with its row."""
    levels = _levels(story)
    lines = _draw(levels, 0)
    if len(lines) == 1:
        return f"{lines[0]}   row 0"
    margin = max(map(len, lines)) + 3
    named = story.has_branch_words
    rows = [
        f"{line:<{margin}}row {row}" + (f"  {story.branch_names[row]}" if named else "")
        for row, line in enumerate(lines)
    ]
    return "\n".join(rows)


def _levels(story: Story) -> list[tuple[tuple[str, ...], str]]:
    """Before each choice and after the last: what may be chosen, and the unknowns that follow."""
    levels: list[tuple[tuple[str, ...], list[str]]] = [((), [])]
    for number, step in enumerate(story.steps, start=1):
        axes = (axis for axis in story.program.axes if axis.step == number)
        levels += [(_choices(story, axis), []) for axis in axes]
        levels[-1][1].extend(unknown_symbol(unknown).text for unknown in step.unknowns)
    return [(choices, " ".join(names)) for choices, names in levels]


def _choices(story: Story, axis: Axis) -> tuple[str, ...]:
    """The two values of a sign, or the roots of a polynomial."""
    if axis.count == 2:
        sign = story.sign(axis).text
        return f"{sign} = +1", f"{sign} = −1"
    return tuple(f"root {number}" for number in range(1, axis.count + 1))


def _draw(levels: list[tuple[tuple[str, ...], str]], depth: int) -> list[str]:
    """The lines of the part of the tree that begins with the unknowns of a level."""
    _, names = levels[depth]
    if depth + 1 == len(levels):
        return [names]
    choices, _ = levels[depth + 1]
    below = _draw(levels, depth + 1)
    stem = f"{names} ─" if names else ""
    blank = " " * len(stem)
    lines = []
    for number, choice in enumerate(choices):
        last = number + 1 == len(choices)
        knot = "└" if last else "├" if number else "┬" if stem else "┌"
        lines.append(f"{blank if number else stem}{knot} {choice} ─ {below[0]}")
        gap = blank + (" " if last else "│") + " " * len(f" {choice} ─ ")
        lines += [gap + line for line in below[1:]]
    return lines
