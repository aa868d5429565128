"""The tree of solutions, drawn with the branch signs as document 004 does."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import branch_sign, unknown_symbol

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.program.ir import Axis


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
        for place, axis in enumerate(story.program.axes):
            if axis.step == number:
                levels.append((_choices(place, axis), []))
        levels[-1][1].extend(unknown_symbol(unknown).text for unknown in step.unknowns)
    return [(choices, " ".join(names)) for choices, names in levels]


def _choices(place: int, axis: Axis) -> tuple[str, ...]:
    """The two values of a sign, or the roots of a polynomial."""
    if axis.count == 2:
        sign = branch_sign(place).text
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
