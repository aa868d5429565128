"""A pose worked through in numbers."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.cuspidal import joined_rows
from dhgen.derivation.definitions import in_order
from dhgen.derivation.effects import limited_in_words
from dhgen.derivation.notation.names import POSE, joint_symbol, target, unknown_symbol
from dhgen.derivation.sections.forward import moved_left
from dhgen.derivation.sections.roots import quartic_blocks
from dhgen.derivation.sections.shoulder import PSI
from dhgen.derivation.singular_example import find_singular
from dhgen.derivation.steps import step_blocks
from dhgen.derivation.text.blocks import (
    Display,
    Given,
    Heading,
    Paragraph,
    Prose,
    Table,
    display,
    joined,
    paragraph,
    say,
)
from dhgen.derivation.text.formula import Listing, Matrix, Relation, Symbol, equal
from dhgen.derivation.text.lines import WIDTH, width
from dhgen.derivation.text.words import many, numeral
from dhgen.derivation.values import (
    degrees,
    figures,
    joint_value,
    letters_at,
    letters_of_joints,
    signs_of_row,
    value_of,
)
from dhgen.derivation.whole_turns import NEAR_HALF_TURN
from dhgen.paul.kind import Kind
from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping, Sequence

    from dhgen.arrays import FloatArray
    from dhgen.derivation.example import Example
    from dhgen.derivation.known_side import KnownSide
    from dhgen.derivation.singular_example import SingularExample
    from dhgen.derivation.step_context import Singularity
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block
    from dhgen.derivation.text.formula import Formula
    from dhgen.derivation.whole_example import WholeExample

NEXT = 4  # columns between two equations in a line


def example_section(story: Story) -> list[Block]:
    """The example; nothing for arms without steps, or where no pose that was drawn is regular."""
    example = story.example
    if example is None:
        return []
    letters = letters_at(story, list(example.q), example.T)
    return [
        Heading(2, say("An example")),
        *pose_blocks(story, example),
        *_target(story, letters),
        *_steps(story, example, letters),
        *all_rows(story, example),
        *_cuspidal(story, example),
    ]


def _cuspidal(story: Story, example: Example) -> list[Block]:
    """What it means that no sign tells solutions apart, where two of them show it."""
    pair = joined_rows(story.algebra.chain, example.rows)
    if pair is None:
        return []
    return [
        paragraph(
            "The determinant of the first three rows of {} has the same sign in rows {} and {}, "
            "and there is a path from one to the other along which that sign does not change: the "
            "arm changes its posture without passing a singular one. Such an arm is called "
            "cuspidal (P. Wenger), after the cusps of the singular curves in its workspace, where "
            "three solutions meet. No sign tells its solutions apart, so its rows have no names "
            "like elbow up and elbow down.",
            Symbol("J", "J"),
            *(Given(str(row)) for row in pair),
        )
    ]


def pose_blocks(story: Story, example: Example | WholeExample) -> list[Block]:
    """The pose, and what the caller gives besides it."""
    unit = story.robot.length_unit
    values = joined([say("{}", equal(*each)) for each in _joint_values(story, example.q)])
    blocks: list[Block] = [
        paragraph(
            f"Angles are in degrees, lengths in {unit}. Numbers are rounded to five digits where "
            "they are printed, and nowhere before. With {} the tool is at",
            values,
        ),
        display(equal(POSE, _matrix(example.T, story))),
    ]
    if story.robot.arm_angle:
        blocks.append(paragraph("The arm angle is {}.", equal(PSI, degrees(example.given[0]))))
    elif story.robot.free:
        given = joined([say("{}", joint_symbol(joint)) for joint in story.robot.free])
        blocks.append(paragraph("The caller gives {} besides.", given))
    return blocks


def _target(story: Story, letters: Mapping[str, float]) -> list[Block]:
    """U_0, where base or tool are moved to the pose."""
    if not any(moved_left(story)):
        return []
    entries = [letters[story.letters[f"t{k // 4 + 1}{k % 4 + 1}"].text] for k in range(12)]
    U = np.vstack([np.reshape(entries, (3, 4)), [0.0, 0.0, 0.0, 1.0]])
    return [paragraph("With it"), display(equal(target(0), _matrix(U, story)))]


def _joint_values(story: Story, q: FloatArray) -> list[tuple[Formula, Formula]]:
    return [
        (joint_symbol(place), joint_value(story, place, value))
        for place, value in enumerate(q, start=1)
    ]


def _matrix(T: FloatArray, story: Story) -> Matrix:
    size = max(story.algebra.chain.size, 1.0)
    return Matrix(tuple(tuple(figures(float(x), size) for x in row) for row in T))


def _steps(story: Story, example: Example, known: Mapping[str, float]) -> list[Block]:
    """What the letters of every step are in one row."""
    signs = signs_of_row(story, example.followed)
    letters = {**known, **signs}
    chosen = [
        equal(letter, Symbol(f"{sign:+.0f}", f"{sign:+.0f}".replace("-", "−")))
        for letter in map(story.sign, story.program.axes)
        if (sign := signs.get(letter.text))
    ]
    name = story.branch_names[example.followed] if story.has_branch_words else ""
    words = f"Row {example.followed}{f', {name},' if name else ''}"
    blocks: list[Block] = [
        paragraph(words + " has {}:", Listing(tuple(chosen)))
        if chosen
        else paragraph(f"{words} step by step:")
    ]
    side = story.known_side
    for number, step in enumerate(story.steps, start=1):
        if side is not None and number == side.after + 1:
            blocks += _known_side_blocks(story, side, letters)
        unknowns = joined([say("{}", unknown_symbol(unknown)) for unknown in step.unknowns])
        lines = list(_values(story, number, letters))
        if lines:
            blocks += [
                paragraph(f"Step {number}, {{}}:", unknowns),
                Display(tuple(laid_out(lines))),
            ]
        if step.kind is Kind.CIRCLE and example.polynomial is not None:
            blocks += quartic_blocks(example.polynomial, example.followed, step.angle)
    return blocks


def _known_side_blocks(story: Story, side: KnownSide, letters: dict[str, float]) -> list[Block]:
    """The entries with letters of a matrix that is known now; `letters` learns them."""
    size = story.algebra.chain.size
    lines = []
    for entry, symbol in side.entries:
        letters[symbol.text] = value_of(story.write(entry), letters)
        lines.append(equal(symbol, figures(letters[symbol.text], size)))
    return [
        paragraph("Now all of {} is known, of which are used", side.symbol),
        Display(tuple(laid_out(lines))),
    ]


def _values(story: Story, number: int, letters: dict[str, float]) -> Iterable[Relation]:
    """The letters that a step defines, in its order; added to `letters` for later steps."""
    local = dict(letters)
    shown: set[str] = set()
    size = story.algebra.chain.size
    for relation in in_order(_relations(step_blocks(story, number)[0])):
        name = relation.sides[0]
        if not isinstance(name, Symbol) or relation.signs[0] != "=" or name.text in shown:
            continue
        value = _value(relation, local)
        if value is None:
            continue
        local[name.text] = value
        shown.add(name.text)
        yield equal(name, degrees(value) if name.text[0] == "θ" else figures(value, size))
    letters |= {name: value for name, value in local.items() if name[0] in "DFGHM"}


def _value(relation: Relation, letters: dict[str, float]) -> float | None:
    """What the last side is worth of which all letters are known."""
    for side in reversed(relation.sides[1:]):
        try:
            return value_of(side, letters)
        except KeyError:
            continue
    return None


def _relations(blocks: Iterable[Block]) -> Iterable[Relation]:
    """The relations on lines of their own, or defined in a sentence."""
    for block in blocks:
        if isinstance(block, Display):
            yield from _flat(block.formulas)
        elif isinstance(block, Paragraph) and block.prose.text.startswith(
            ("This is", "The determ")
        ):
            yield from _flat(part for part in block.prose.parts if not isinstance(part, Prose))


def _flat(formulas: Iterable[object]) -> Iterable[Relation]:
    for formula in formulas:
        for each in formula.items if isinstance(formula, Listing) else (formula,):
            if isinstance(each, Relation):
                yield each


def laid_out(equations: list[Relation]) -> Iterable[Formula]:
    """Several in a line, as many as a page is wide."""
    line: list[Relation] = []
    for each in equations:
        if line and sum(width(one) + NEXT for one in (*line, each)) > WIDTH:
            yield Listing(tuple(line))
            line = []
        line.append(each)
    yield Listing(tuple(line))


def singular_blocks(story: Story, places: Sequence[Singularity]) -> list[Block]:
    """A singular pose in numbers; nothing where none is near the example in round numbers."""
    example = story.example
    found = None if example is None else find_singular(story, example, places)
    if example is None or found is None or found.place.joints is None:
        return []
    before = int((~np.isnan(example.rows).any(axis=1)).sum())
    limited = limited_in_words(story.algebra.chain)
    text = "For instance the example's joint values, but {}, meet {} (step {}). The tool is then at"
    moved = equal(
        joint_symbol(found.joint), joint_value(story, found.joint, found.q[found.joint - 1])
    )
    return [
        paragraph(text, moved, found.place.joints, Given(str(found.place.step))),
        display(equal(POSE, _matrix(found.T, story))),
        paragraph(" ".join(_statuses(found, before, limited))),
        *all_rows(story, found, _sums_left(story, found)),
    ]


def _statuses(found: SingularExample, before: int, limited: str) -> Iterable[str]:
    """How many rows hold a solution, and which took the seed's value, within limits or not.

    Args:
        found: The pose.
        before: How many rows of the example hold one.
        limited: What has limits.
    """
    solved = int((~np.isnan(found.rows).any(axis=1)).sum())
    holding = "row holds a solution" if solved == 1 else "rows hold solutions"
    yield f"Here {numeral(solved)} {holding}, in the example {numeral(before)}."
    taking = [row for row in np.flatnonzero(found.free).tolist() if row not in found.exceeding]
    if taking:
        rows = many("row", list(map(str, taking)))
        yield f"In {rows} the seed's value, zero here, is taken: the status is FREE_JOINT."
    beyond = [row for row in taking if not found.inside[row]]
    if beyond:
        rows = many("row", list(map(str, beyond)))
        yield (
            f"In {rows} it puts {limited} beyond its limits: the nearest value that works takes "
            "its place, and where there is none the status is OUT_OF_LIMITS."
        )
    for joints in dict.fromkeys(found.exceeding.values()):
        rows = many("row", [str(row) for row, own in found.exceeding.items() if own == joints])
        verb, limits = ("are", "their limits") if joints[1:] else ("is", "its limits")
        yield (
            f"In {rows} {many('joint', list(map(str, joints)))} {verb} beyond {limits} whatever "
            "value is taken: the status is OUT_OF_LIMITS."
        )


def _sums_left(story: Story, found: SingularExample) -> dict[int, Formula]:
    """By row what is still known of two angles, where one took the seed's value."""
    left = found.place.left
    if left is None:
        return {}
    sums: dict[int, Formula] = {}
    for row in np.flatnonzero(found.free).tolist():
        letters = letters_of_joints(story, found.rows[row].tolist())
        combination = left.combination(1 if value_of(left.between, letters) > 0.0 else -1)
        value = value_of(combination, letters)
        turned = math.remainder(value - NEAR_HALF_TURN, 2.0 * math.pi) + NEAR_HALF_TURN
        sums[row] = equal(combination, degrees(turned))
    return sums


def all_rows(
    story: Story,
    example: Example | WholeExample | SingularExample,
    sums: Mapping[int, Formula] | None = None,
) -> list[Block]:
    """All rows, and the check by the forward model; `sums` are what rows determine, by row."""
    solved = ~np.isnan(example.rows).any(axis=1)
    named = story.has_named_rows
    joints = range(1, story.dof + 1)
    header = [say("row"), *([say("name")] * named), *(say("{}", joint_symbol(j)) for j in joints)]
    beyond = bool((solved & ~example.inside).any())
    header += [say("limits")] * beyond + [say("determined")] * bool(sums)
    lines = []
    for row in np.flatnonzero(solved).tolist():
        cells = [say(str(row)), *([say("{}", Given(story.branch_names[row]))] * named)]
        cells += [say("{}", value) for _, value in _joint_values(story, example.rows[row])]
        cells += [say("kept" if example.inside[row] else "exceeded")] * beyond
        if sums:
            cells.append(say("{}", sums[row]) if row in sums else say("—"))
        lines.append(tuple(cells))
    empty = f" {_EMPTY}" if not solved.all() else ""
    named_by = "" if story.robot.task.kind is TaskKind.POSE else "what the task names of "
    return [
        paragraph("All solutions:"),
        Table(tuple(header), tuple(lines)),
        paragraph(
            f"Put into the forward model each of them gives {named_by}{{}} again to all digits "
            f"that are printed.{empty}",
            POSE,
        ),
    ]


_EMPTY = "Rows that are not listed have no solution for this pose."
