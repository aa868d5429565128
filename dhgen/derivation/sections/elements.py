"""What the pose gives to the steps: the elements of the U matrices that they use, and points."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

from dhgen.derivation.notation.matrices import (
    left_name,
    middle_name,
    sides,
)
from dhgen.derivation.notation.names import inverse as inverse_name
from dhgen.derivation.notation.names import letter, link
from dhgen.derivation.text.blocks import (
    Given,
    display,
    paragraph,
    say,
)
from dhgen.derivation.text.formula import Element, Product, Symbol, equal
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import LATEX, PLAIN
from dhgen.derivation.text.words import many
from dhgen.kinematics.ring import used_places
from dhgen.paul.arm_plane import SHOULDER
from dhgen.paul.equation import MOMENT

if TYPE_CHECKING:
    from dhgen.derivation.notation.matrices import Form
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.equation import Matrix, Origin
    from dhgen.paul.pool import BasePoint, Point
    from dhgen.paul.step import Step


@dataclass(frozen=True, slots=True)
class _Group:
    """The elements that are shown of one matrix.

    Attributes:
        form: The matrix.
        step: The first step that uses it, from 1.
        places: Rows and columns of its elements.
    """

    form: Form
    step: int
    places: tuple[tuple[int, int], ...]


def element_blocks(story: Story, number: int) -> list[Block]:
    """The points and the elements that come in with a step, each once."""
    groups = [group for group in _groups(story) if group.step == number]
    blocks = _point_blocks(story, number)
    if not groups:
        return blocks
    beside = any(column == 4 for group in groups for _, column in group.places)
    also = ", and their neighbours in column 4" if beside else ""
    blocks.append(paragraph(f"New elements in step {number}{also}:"))
    for group in groups:
        equations = [_element_equation(story, group, *place) for place in group.places]
        blocks += [paragraph("{}", _form_sentence(story, group.form)), display(*equations)]
    return blocks


@lru_cache(maxsize=2)
def _groups(story: Story) -> tuple[_Group, ...]:
    """The matrices of which both sides of elements are shown, in the columns that steps use."""
    used: dict[tuple[bool, bool, int, int], list[Origin]] = {}
    first: dict[Matrix, int] = {}
    for number, step in enumerate(story.steps, start=1):
        for origin in (*step.origins, *_second_origins(step)):
            key = (origin.shoulder, origin.inverse, origin.m, -origin.k)
            used.setdefault(key, []).append(origin)
            first.setdefault(origin.matrix, number)
    found = []
    for _, origins in sorted(used.items()):
        form = story.form(origins[0].matrix)
        if places := _wanted(story, form, origins):
            found.append(_Group(form, first[form.place], tuple(places)))
    return tuple(found)


def known_side_blocks(story: Story, number: int) -> list[Block]:
    """The letters of a matrix that is known from a step on."""
    side = story.known_side
    if side is None or number != side.after + 1:
        return []
    name, middle = left_name(side.place, story.dof), middle_name(side.place)
    sides = (name, middle) if side.symbol == name else (side.symbol, name, middle)
    text = (
        "By now all of {} is known. Its entries are written {} from here on; those that are used "
        "are"
    )
    return [
        paragraph(text, equal(*sides), side.entry),
        display(*(equal(symbol, story.write(entry)) for entry, symbol in side.entries)),
    ]


def _second_origins(step: Step) -> tuple[Origin, ...]:
    """The place of a step's second equation; a cross product's is printed in the step."""
    if step.fallback is None:
        return ()
    return tuple(origin for origin in step.fallback.origins if origin.column != MOMENT)


def _form_sentence(story: Story, form: Form) -> Prose:
    """U_m = A_m^-1 U_{m-1} = A_{m+1} ... A_k."""
    m, k, inverted, shoulder = form.place
    name, middle = left_name(form.place, story.dof), middle_name(form.place)
    last = SHOULDER if shoulder else story.dof
    if inverted:
        seen = [Given(str(number)) for number in (m, k)]
        return say("{} (frame {} seen from frame {}):", equal(name, middle), *seen)
    if k == last:
        before: tuple[Formula, ...] = ()
        if m:
            earlier = left_name((m - 1, k, inverted, shoulder), story.dof)
            before = (Product((inverse_name(link(m)), earlier)),)
        return say("{}:", equal(name, *before, middle))
    joints, known = story.moved_right(form.place)
    moved = many("joint", [str(j) for j in joints])
    text = f"{{}} ({moved} moved to the side of {{}}):"
    return say(text, equal(name, story.left_name(form.place), middle), known)


def _wanted(story: Story, form: Form, origins: list[Origin]) -> list[tuple[int, int]]:
    """The elements to show: used ones, and the whole of column 4 where the task gives it."""
    withheld = {story.algebra.index[f"t{i}{j}"] for i in (1, 2, 3) for j in (1, 2, 3, 4)} - {
        story.algebra.index[name] for name in story.derivation.problem.known
    }

    def is_given(polynomial: Polynomial) -> bool:
        return not any(monomial[place] for monomial in polynomial for place in withheld)

    wanted = {(origin.row, origin.column) for origin in origins if origin.row}
    if any(origin.column == 4 for origin in origins):
        wanted |= {(row, 4) for row in (1, 2, 3) if is_given(form.left.entry(row - 1, 3))}
    kept = []
    for row, column in sorted(wanted, key=lambda place: (place[1], place[0])):
        left, right = sides(form, row, column)
        if left != right:
            kept.append((row, column))
    return kept


def _element_equation(story: Story, group: _Group, row: int, column: int) -> Formula:
    """Both sides, with the letters that there are before the first step that uses the form."""
    left, right = sides(group.form, row, column)
    name = Element(story.left_name(group.form.place), row, column)
    return equal(name, story.write_quoted(left, group.step), story.write_forward(right))


def _point_blocks(story: Story, number: int) -> list[Block]:
    """The points that come in with a step."""
    pool = story.derivation.pool
    blocks: list[Block] = []
    for point in pool.points:
        if _first_use(story, point) == number:
            blocks += _point(story, point)
    for base_point in pool.base_points:
        if _first_use(story, base_point) == number:
            blocks += _base_point(story, base_point)
    return blocks


def _first_use(story: Story, point: Point | BasePoint) -> int | None:
    """The first step that quotes a point's coordinates, or shows an element that holds them."""
    names = {story.algebra.index[name] for name in point.names}
    quoted = [
        number
        for number, quotes in enumerate(story.quotes, start=1)
        if any(names & used_places(side) for each in quotes for side in (each.left, each.right))
    ]
    if not quoted:
        return None
    shown = [
        group.step
        for group in _groups(story)
        for place in group.places
        if any(names & used_places(side) for side in sides(group.form, *place))
    ]
    return min(quoted + shown)


def _point(story: Story, point: Point) -> list[Block]:
    problem = story.derivation.problem
    k = story.frame_of(point)
    coordinates = []
    for row, name in enumerate(point.names):
        total = problem.target.entry(row, 3)
        for column, length in enumerate(point.in_tool):
            total += problem.target.entry(row, column) * length
        coordinates.append(equal(story.letters[name], story.write(total)))
    joints = many("joint", [str(j) for j in range(k + 1, story.dof + 1)])
    turn = "does" if k + 1 == story.dof else "do"
    assert story.wrist is not None or not story.is_wrist_frame(k)
    if story.wrist is not None and story.is_wrist_frame(k):
        first = "The wrist centre {} is the origin of frame {}, where the axes {}, {} and {} meet"
        three = [Given(str(joint)) for joint in story.wrist]
        head = say(first, Symbol("w", "w"), Given(str(k)), *three)
    else:
        text = "The pose gives a second point {}, the origin of frame {}"
        head = say(text, Symbol("w", "w"), Given(str(k)))
    text = (
        f"{{}}: {joints} {turn} not move it. In the last frame it is {{}}, so its position "
        "follows from the pose alone:"
    )
    entries = [story.write(entry) for entry in point.in_tool]
    shown = Symbol(*(f"({', '.join(show(e, style) for e in entries)})" for style in (LATEX, PLAIN)))
    return [paragraph(text, head, shown), display(*coordinates)]


def _base_point(story: Story, point: BasePoint) -> list[Block]:
    """A point of the base as the tool sees it: R' (b - t)."""
    target = story.derivation.problem.target
    name = letter("w", "w", point.names[0][1:-1])
    coordinates = []
    for column, own in enumerate(point.names):
        total = story.algebra.ring.zero
        for row, length in enumerate(point.in_base):
            total += target.entry(row, column) * (length - target.entry(row, 3))
        coordinates.append(equal(story.letters[own], story.write(total)))
    entries = [story.write(entry) for entry in point.in_base]
    shown = Symbol(*(f"({', '.join(show(e, style) for e in entries)})" for style in (LATEX, PLAIN)))
    text = "The point {} is fixed in the base. Seen from the last frame it is at {}:"
    return [paragraph(text, shown, name), display(*coordinates)]
