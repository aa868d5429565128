"""What the pose gives to the steps: the elements of the U matrices that they use, and points."""

from __future__ import annotations

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
from dhgen.paul.arm_plane import SHOULDER
from dhgen.paul.equation import MOMENT

if TYPE_CHECKING:
    from dhgen.derivation.known_side import KnownSide
    from dhgen.derivation.notation.matrices import Form
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.equation import Matrix, Origin
    from dhgen.paul.pool import BasePoint, Point
    from dhgen.paul.step import Step


def element_blocks(story: Story) -> list[Block]:
    """Both sides of every element in the columns that the steps use, each once."""
    used: dict[tuple[bool, bool, int, int], list[Origin]] = {}
    first: dict[Matrix, int] = {}
    for number, step in enumerate(story.steps, start=1):
        for origin in (*step.origins, *_second_origins(step)):
            key = (origin.shoulder, origin.inverse, origin.m, -origin.k)
            used.setdefault(key, []).append(origin)
            first.setdefault(origin.matrix, number)
    blocks: list[Block] = []
    letters: list[Block] = []
    side = story.known_side
    for _, origins in sorted(used.items()):
        form = story.form(origins[0].matrix)
        number = first[form.place]
        equations = [
            _element_equation(story, form, *place, number)
            for place in _wanted(story, form, origins)
        ]
        if not equations:
            continue
        if side is not None and number > side.after and not letters:
            letters = _known_side_blocks(story, side)
        blocks += [paragraph("{}", _form_sentence(story, form)), display(*equations)]
    if not blocks:
        return []
    text = "The elements that are used below, and their neighbours in column 4:"
    return [*letters, paragraph(text), *blocks]


def _known_side_blocks(story: Story, side: KnownSide) -> list[Block]:
    """The letters of a matrix that is known before the steps that are left."""
    name, middle = left_name(side.place, story.dof), middle_name(side.place)
    sides = (name, middle) if side.symbol == name else (side.symbol, name, middle)
    text = (
        "After step {} all of {} is known. Its entries are written {} from there on; those that "
        "are used are"
    )
    return [
        paragraph(text, Given(str(side.after)), equal(*sides), side.entry),
        display(*(equal(symbol, story.write(entry)) for entry, symbol in side.entries)),
    ]


def _second_origins(step: Step) -> tuple[Origin, ...]:
    """The place of a step's second equation; that of a cross product is printed in the step."""
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


def _element_equation(story: Story, form: Form, row: int, column: int, step: int) -> Formula:
    """Both sides, with the letters that there are before the first step that uses the form."""
    left, right = sides(form, row, column)
    name = Element(story.left_name(form.place), row, column)
    return equal(name, story.write_quoted(left, step), story.write_forward(right))


def point_blocks(story: Story) -> list[Block]:
    """Those that the steps use."""
    pool = story.derivation.pool
    blocks: list[Block] = []
    for point in pool.points:
        if _is_used(story, point):
            blocks += _point(story, point)
    for base_point in pool.base_points:
        if _is_used(story, base_point):
            blocks += _base_point(story, base_point)
    return blocks


def _is_used(story: Story, point: Point | BasePoint) -> bool:
    places = [story.algebra.index[name] for name in point.names]
    return any(
        monomial[place]
        for quotes in story.quotes
        for quote in quotes
        for side in (quote.left, quote.right)
        for monomial in side
        for place in places
    )


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
