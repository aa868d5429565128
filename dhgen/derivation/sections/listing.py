"""The steps as an algorithm, with its branches: what document 004 ends with, to be programmed."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.definitions import in_order
from dhgen.derivation.effects import open_joints
from dhgen.derivation.notation.names import cosine, joint_symbol, sine, theta, unknown_symbol
from dhgen.derivation.sections.elements import element_blocks, known_side_blocks
from dhgen.derivation.sections.inverse import inverse_beginning
from dhgen.derivation.sections.joints import joint_values
from dhgen.derivation.step_context import StepContext
from dhgen.derivation.steps import step_blocks
from dhgen.derivation.text.blocks import Display, Drawing, Folded, Paragraph, paragraph
from dhgen.derivation.text.formula import ONE, Listing, Relation, Symbol, equal, minus
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import PLAIN
from dhgen.derivation.text.walk import symbols_of
from dhgen.kinematics.algebra import AngleSum
from dhgen.paul.kind import Kind

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator

    from dhgen.derivation.step_context import Singularity
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block
    from dhgen.derivation.text.formula import Formula

TITLE = "The steps as an algorithm"
INTRO = "The letters in the order in which they become known, with the branches:"
TOO_WIDE = "As an algorithm the steps would have lines that are wider than a page."
TOO_LONG = "As an algorithm the steps would fill more than a page."
INDENT = "  "
WIDE = 100  # characters of a line; longer ones are left to the steps
MOST = 60  # lines, about a page
BETWEEN = ",  "
NONE_THERE = "No solution when"


def listing_blocks(story: Story) -> list[Block]:
    """The algorithm, folded, or that it is too long; nothing with roots of a polynomial."""
    if any(step.kind is Kind.CIRCLE for step in story.steps) or story.algebra.chain.arm_angle:
        return []
    lines = list(_lines(story))
    if max(map(len, lines)) > WIDE:
        return [paragraph(TOO_WIDE)]
    if len(lines) > MOST:
        return [paragraph(TOO_LONG)]
    return [Folded(TITLE, (paragraph(INTRO), Drawing("\n".join(lines))))]


def _lines(story: Story) -> Iterator[str]:
    depth = 0
    yield from _packed(map(_shown, _definitions(inverse_beginning(story))))
    for number, step in enumerate(story.steps, start=1):
        before = [*known_side_blocks(story, number), *element_blocks(story, number)]
        for relation in _definitions(before):
            yield INDENT * depth + _shown(relation)
        if step.roots == 2:
            sign = story.sign_of(number)
            yield f"{INDENT * depth}for {show(equal(sign, ONE), PLAIN)}, {show(minus(ONE), PLAIN)}"
            depth += 1
        yield from (INDENT * depth + line for line in _of_step(story, number))
    for relation in _definitions(joint_values(story)):
        yield INDENT * depth + _shown(relation)


def _of_step(story: Story, number: int) -> list[str]:
    """The letters of a step in order, and its branches as soon as their letters are known."""
    blocks, places = step_blocks(story, number)
    unknowns = {unknown_symbol(unknown) for unknown in story.steps[number - 1].unknowns}
    own = {unknown for unknown in story.steps[number - 1].unknowns if isinstance(unknown, AngleSum)}
    others = {
        each for angle in {*story.algebra.angles} - own for each in (cosine(angle), sine(angle))
    }
    relations = [each for each in _definitions(blocks) if each.sides[0] not in others]
    names = [relation.sides[0] for relation in relations]
    waiting = [*_without_solution(blocks), *_branches(story, number, places, frees=False)]
    free = list(_branches(story, number, places, frees=True))
    lines: list[str] = []
    for place, relation in enumerate(relations):
        name, known = relation.sides[0], set(names[:place])
        for each in [each for each in waiting if not _missing(each[0], names, known)]:
            lines.append(each[1])
            waiting.remove(each)
        otherwise = [line for condition, line in free if not _missing(condition, names, known)]
        if name in unknowns and otherwise:
            lines += otherwise
            free = []
        lines.append(("else " if name in unknowns and otherwise else "") + _shown(relation))
    return [*lines, *(line for _, line in [*waiting, *free])]


def _missing(condition: Formula, names: list[Formula], known: set[Formula]) -> bool:
    """Whether a condition has letters that the step has not given yet."""
    return bool((symbols_of([Display((condition,))]) & set(names)) - known)


def _packed(shown: Iterable[str]) -> Iterator[str]:
    """Several in a line, as many as fit."""
    line = ""
    for each in shown:
        if line and len(line) + len(each) > WIDE - len(BETWEEN):
            yield line
            line = ""
        line += BETWEEN * bool(line) + each
    if line:
        yield line


def _without_solution(blocks: Iterable[Block]) -> Iterator[tuple[Formula, str]]:
    """Where a branch ends."""
    for block in blocks:
        if isinstance(block, Paragraph) and block.prose.text.startswith(NONE_THERE):
            condition = block.prose.parts[0]
            if isinstance(condition, Relation):
                yield condition, f"if {show(condition, PLAIN)}: no solution"


def _branches(
    story: Story, number: int, places: Iterable[Singularity], *, frees: bool
) -> Iterator[tuple[Formula, str]]:
    """Where the two values of a step meet, or a joint takes the seed's value."""
    context = StepContext(story, number, story.steps[number - 1])
    alone = [f"{show(equal(context.sign, ONE), PLAIN)} alone"] * (context.step.roots == 2)
    for place in places:
        if not isinstance(place.condition, Relation) or place.frees != frees:
            continue
        joints = open_joints(context) if place.frees else []
        whole = len(joints) > 1 and context.step.kind is not Kind.TWO_LENGTHS
        letters = [theta(context.angle)] if whole else map(joint_symbol, joints)
        free = [f"{show(letter, PLAIN)} the seed's value" for letter in letters]
        yield place.condition, f"if {show(place.condition, PLAIN)}: {', '.join([*alone, *free])}"


def _definitions(blocks: Iterable[Block]) -> list[Relation]:
    """What gives a letter its value, each letter once."""
    return list({each.sides[0]: each for each in in_order(_all_definitions(blocks))}.values())


def _all_definitions(blocks: Iterable[Block]) -> Iterator[Relation]:
    for block in blocks:
        formulas: Iterable[object] = ()
        if isinstance(block, Display):
            formulas = block.formulas
        elif isinstance(block, Paragraph) and block.prose.text.startswith("This is"):
            formulas = block.prose.parts[1:]
        for formula in formulas:
            for each in formula.items if isinstance(formula, Listing) else (formula,):
                if isinstance(each, Relation) and isinstance(each.sides[0], Symbol):
                    yield each


def _shown(relation: Relation) -> str:
    """A letter and its value, of several forms the last."""
    return show(equal(relation.sides[0], relation.sides[-1]), PLAIN)
