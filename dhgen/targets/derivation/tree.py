"""The tree of solutions, drawn with the branch signs as document 004 does."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.targets.derivation.names import branch_sign, unknown_symbol

if TYPE_CHECKING:
    from dhgen.targets.derivation.story import Story


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


def _levels(story: Story) -> list[tuple[str, str]]:
    """Before each sign and after the last: the sign's name and the unknowns that follow it."""
    levels: list[tuple[str, list[str]]] = [("", [])]
    for number, step in enumerate(story.steps, start=1):
        for place, axis in enumerate(story.program.axes):
            if axis.step == number:
                levels.append((branch_sign(place).text, []))
        levels[-1][1].extend(unknown_symbol(unknown).text for unknown in step.unknowns)
    return [(sign, " ".join(names)) for sign, names in levels]


def _draw(levels: list[tuple[str, str]], depth: int) -> list[str]:
    """The lines of the part of the tree that begins with the unknowns of a level."""
    _, names = levels[depth]
    if depth + 1 == len(levels):
        return [names]
    sign, _ = levels[depth + 1]
    below = _draw(levels, depth + 1)
    stem = f"{names} ─" if names else ""
    blank = " " * len(stem)
    lines = []
    for first, value in ((True, "+1"), (False, "−1")):
        for place, line in enumerate(below):
            if place == 0:
                knot = ("┬" if stem else "┌") if first else "└"
                lines.append(f"{stem if first else blank}{knot} {sign} = {value} ─ {line}")
            else:
                gap = " " * len(f" {sign} = {value} ─ ")
                lines.append(f"{blank}{'│' if first else ' '}{gap}{line}")
    return lines
