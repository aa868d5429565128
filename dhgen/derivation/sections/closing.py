"""The last sections: the tree, singular configurations, the cost."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import branch_sign, unknown_symbol
from dhgen.derivation.sections.shoulder import PSI
from dhgen.derivation.steps import has_signed_roots, leaves_a_joint_free
from dhgen.derivation.text.blocks import Drawing, Heading, Table, paragraph, say
from dhgen.program.count import count_operations
from dhgen.program.regular.regular import regular
from dhgen.program.walk import finds_roots

if TYPE_CHECKING:
    from dhgen.derivation.step_context import Singularity
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.paul.step import Step
    from dhgen.program.count import OperationCount
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


def singular_section(found: list[Singularity]) -> list[Block]:
    """One line for every place where a step gives other than its usual number of values."""
    blocks: list[Block] = [Heading(2, say("Singular configurations"))]
    if not found:
        return [
            *blocks,
            paragraph("None: no step degenerates, and no two solutions meet."),
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


def cost_section(story: Story) -> list[Block]:
    """The operations of the program for all rows together, and of that of regular poses."""
    count = count_operations(story.program)
    rows = story.program.rows
    label = "the solution" if rows == 1 else f"all {rows} rows"
    lines = [_operations(label, count)]
    made_of = "atan2 and square roots"
    if finds_roots(story.program):
        made_of = "atan2, square roots and roots of a quartic"
    text = (
        "A value that depends on only some of the signs is computed once for each combination of "
        f"those. Besides arithmetic, the solutions take only {made_of}"
        + (_sines(story) if count.sines_cosines else ".")
    )
    solver = regular(story.program)
    if solver is not None:
        quick = count_operations(solver.program)
        lines.append(_operations("at a regular pose", quick))
        text += (
            " At a regular pose no joint is free and no two branches meet, so neither has to be "
            "tested; what is odd or even in a sign is computed once for both of its values, and "
            "additions replace divisions and roots where they can."
        )
        if quick.arctangents < count.arctangents:
            text += (
                " Where the two values of a sign give angles that differ by half a turn or by "
                "their own sign, one atan2 serves both."
            )
    return [Heading(2, say("Cost")), Table(_COUNTED, tuple(lines)), paragraph(text)]


_COUNTED = tuple(
    say(word)
    for word in (
        "",
        "additions",
        "multiplications",
        "divisions",
        "square roots",
        "atan2",
        "sin, cos",
    )
)


def _operations(label: str, count: OperationCount) -> tuple[Prose, ...]:
    numbers = (
        count.additions,
        count.multiplications,
        count.divisions,
        count.square_roots,
        count.arctangents,
        count.sines_cosines,
    )
    return (say(label), *(say(str(each)) for each in numbers))


def _sines(story: Story) -> str:
    if story.robot.free or story.robot.arm_angle:
        return "; sines and cosines are taken of values that the caller gives."
    if finds_roots(story.program):
        return "; sines and cosines are taken of the roots and, where a joint is free, of the seed."
    if not leaves_a_joint_free(story):
        return (
            ". The counts include the code of all cases, also of those that the numbers of this "
            "arm exclude; where a joint would be free it takes sines and cosines of the seed."
        )
    return "; sines and cosines are taken of the seed only, where a joint is free."


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
        levels += [(_choices(step, axis), []) for axis in axes]
        levels[-1][1].extend(unknown_symbol(unknown).text for unknown in step.unknowns)
    return [(choices, " ".join(names)) for choices, names in levels]


def _choices(step: Step, axis: Axis) -> tuple[str, ...]:
    """The two values of a sign, or the roots of a polynomial."""
    if axis.count == 2:
        sign = branch_sign(step).text
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
