"""The determinant of the Jacobian's rows of the position, in factors, where no step lists them.

It is worked out in every frame, of which one leaves most zeros, and its factors are found there:
an arm whose steps take roots of a polynomial has no condition that is one of them.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.conditions import are_never_zero, unsigned
from dhgen.derivation.notation.matrices import expanded
from dhgen.derivation.text.formula import ZERO, equal
from dhgen.derivation.velocity.determinant import Determinant, Factor
from dhgen.derivation.velocity.wrist import velocity_columns
from dhgen.kinematics.ring import primitive
from dhgen.kinematics.transform import identity

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.derivation.step_context import Singularity
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.constants import Polynomial

MOST_TERMS = 200  # of a determinant that is taken apart


def position_determinant(story: Story, places: Sequence[Singularity] = ()) -> Determinant | None:
    """In the frame in which it has most factors; None where no frame leaves it short.

    Rows of a plane are those of the base's frame.

    Args:
        story: The derivation.
        places: What the table of singular configurations lists.
    """
    algebra, chain = story.algebra, story.algebra.chain
    rows = chain.task.position_rows
    plain = not (chain.given or chain.passive) and len(rows) == chain.dof
    if not plain or (len(rows) == 2 and chain.base != identity(chain.ring)):
        return None
    frames = range(chain.dof + 1) if len(rows) == 3 else range(1)
    found = [each for frame in frames if (each := _in_factors(story, frame)) is not None]
    if not found:
        return None
    size, taken = min(found, key=_length)
    moving = []
    for form, power in taken:
        written = unsigned(story, form)
        if power % 2 and written != story.write_forward(form):
            size = -size
        never = are_never_zero(algebra, form)
        moving.append(Factor(written, power, _place_of(written, places), never))
    return Determinant(story.write_forward(size), tuple(moving), len(rows))


Factored = tuple["Polynomial", list[tuple["Polynomial", int]]]


def _length(factored: Factored) -> tuple[int, str]:
    """How many terms all factors have; then by alphabet."""
    return sum(len(form) for form, _ in factored[1]), str(factored)


def _place_of(factor: Formula, places: Sequence[Singularity]) -> Singularity | None:
    """The place whose condition in joints a factor is."""
    zero = equal(factor, ZERO)
    return next((place for place in places if place.joints == zero), None)


def _in_factors(story: Story, frame: int) -> Factored | None:
    """What does not move, and the other factors, of the determinant of velocities in a frame."""
    algebra = story.algebra
    columns = [moved for moved, _ in velocity_columns(algebra, frame, None, story.dof)]
    if len(columns) == 2:
        (a, b), (c, d) = ([column[row] for row in _rows(story)] for column in columns)
        size = a * d - b * c
    else:
        first, second, third = columns
        across = (second[i - 2] * third[i - 1] - second[i - 1] * third[i - 2] for i in range(3))
        size = sum((a * b for a, b in zip(first, across, strict=True)), algebra.ring.zero)
    if not size or len(size) > MOST_TERMS:
        return None
    scale, factors = size.factor_list()
    still, moving = algebra.ring.ground_new(scale), []
    for factor, power in factors:
        forms = (algebra.normal(factor), algebra.normal(expanded(algebra, factor)))
        number_, form = primitive(min(forms, key=len))
        still *= number_**power
        if algebra.is_constant(form):
            still *= form**power
        else:
            moving.append((form, power))
    return algebra.normal(still), moving


def _rows(story: Story) -> tuple[int, ...]:
    return story.algebra.chain.task.position_rows
