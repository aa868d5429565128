"""The elements of the U matrices that the steps use."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.matrices import (
    known_matrix,
    left_name,
    middle_name,
    sides,
)
from dhgen.derivation.notation.names import inverse as inverse_name
from dhgen.derivation.notation.names import link
from dhgen.derivation.text.blocks import (
    Given,
    display,
    paragraph,
    say,
)
from dhgen.derivation.text.formula import Element, Product, equal
from dhgen.derivation.text.words import many
from dhgen.paul.arm_plane import SHOULDER
from dhgen.paul.equation import MOMENT

if TYPE_CHECKING:
    from dhgen.derivation.notation.matrices import Form
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.equation import Origin
    from dhgen.paul.step import Step


def element_blocks(story: Story) -> list[Block]:
    """Both sides of every element in the columns that the steps use, each once."""
    used: dict[tuple[bool, bool, int, int], list[Origin]] = {}
    for step in story.steps:
        for origin in (*step.origins, *_second_origins(step)):
            key = (origin.shoulder, origin.inverse, origin.m, -origin.k)
            used.setdefault(key, []).append(origin)
    blocks: list[Block] = []
    for _, origins in sorted(used.items()):
        form = story.form(origins[0].matrix)
        equations = [
            _element_equation(story, form, *place) for place in _wanted(story, form, origins)
        ]
        if equations:
            blocks.append(display(*equations))
            blocks.insert(len(blocks) - 1, paragraph("{}", _form_sentence(story, form)))
    if not blocks:
        return []
    text = "The elements that are used below, and their neighbours in column 4:"
    return [paragraph(text), *blocks]


def _second_origins(step: Step) -> tuple[Origin, ...]:
    """Where the second equation of a step stands; that of a cross product is told in the step."""
    if step.second is None:
        return ()
    return tuple(origin for origin in step.second.origins if origin.column != MOMENT)


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
    moved = many("joint", [str(j) for j in range(k + 1, last + 1)])
    text = f"{{}} ({moved} moved to the side of {{}}):"
    return say(text, equal(name, middle), known_matrix(form.place))


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


def _element_equation(story: Story, form: Form, row: int, column: int) -> Formula:
    left, right = sides(form, row, column)
    name = Element(left_name(form.place, story.dof), row, column)
    return equal(name, story.write(left), story.write_forward(right))
