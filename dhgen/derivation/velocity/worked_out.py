"""The determinant of the Jacobian, worked out and then taken apart, where no conditions make it up.

It is the same in every frame, of which one leaves most zeros, and its factors are found there: an
arm whose steps take roots of a polynomial has no condition for each of them. Of a direction the
task names two numbers; a turn about it at the tool, which changes nothing that the task names,
makes the rows six.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from dhgen.derivation.conditions import are_never_zero, unsigned
from dhgen.derivation.notation.matrices import expanded
from dhgen.derivation.text.formula import ZERO, equal, number, times
from dhgen.derivation.velocity.determinant import Determinant, Factor, raised
from dhgen.derivation.velocity.wrist import approach, velocity_columns
from dhgen.kinematics.ring import primitive
from dhgen.kinematics.transform import identity, turn_between
from dhgen.robot.task import Directions

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.derivation.step_context import Singularity
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial

MOST_TERMS = 200  # of a determinant that is taken apart, and of the minors that it is made of
FEW = 3  # rows whose minors are left as they are: in normal form factors may be lost
LONGEST = 8  # terms of a factor that is still of use to a reader

Rows = tuple[tuple["Polynomial", ...], ...]
Factored = tuple["Polynomial", list[tuple["Polynomial", int]]]


def worked_out(
    story: Story, places: Sequence[Singularity] = (), *, by_position: bool = False
) -> Determinant | None:
    """In the frame in which it has most factors; None where no frame leaves it short.

    Rows of a plane are those of a frame that lies in it as the base does; columns are those of the
    joints that are solved for.

    Args:
        story: The derivation.
        places: What the table of singular configurations lists.
        by_position: Whether the rows are those of the position alone.
    """
    algebra, chain = story.algebra, story.algebra.chain
    named = Directions.NONE if by_position else chain.task.directions
    solved = len(chain.solved)
    level = len(chain.task.position_rows) + named.dimension > solved  # some rows are zero
    flat = level or len(chain.task.position_rows) == 2
    if chain.passive or not story.steps or (flat and chain.base != identity(chain.ring)):
        return None
    spans = story.derivation.problem.spans
    frames = [
        frame
        for frame in range(chain.dof + 1)
        if not flat or turn_between(spans.product(0, frame).rotation) == 1
    ]
    found = [each for frame in frames if (each := _in_factors(story, named, frame)) is not None]
    if not found:
        return None
    size, taken = min(found, key=_length)
    still, moving = [], []
    for form, power in taken:
        if algebra.is_constant(form):
            still.append(raised(story.write_forward(form), power))
            continue
        written = unsigned(story, form)
        if power % 2 and written != story.write_forward(form):
            size = -size
        never = are_never_zero(algebra, form)
        moving.append(Factor(written, power, _place_of(written, places), never))
    # of a sum the number is in front, and not divided among its terms
    scale, rest = primitive(size) if len(size) > 1 else (1, size)
    constant = times(number(scale), story.write_forward(rest), *still)
    return Determinant(constant, tuple(moving), solved)


def _length(factored: Factored) -> tuple[int, str]:
    """How many terms all factors have; then by alphabet."""
    return sum(len(form) for form, _ in factored[1]), str(factored)


def _place_of(factor: Formula, places: Sequence[Singularity]) -> Singularity | None:
    """The place whose condition in joints a factor is."""
    zero = equal(factor, ZERO)
    return next((place for place in places if place.joints == zero), None)


def _in_factors(story: Story, named: Directions, frame: int) -> Factored | None:
    """A monomial that does not move, and the other factors, of the determinant in a frame."""
    algebra = story.algebra
    rows = _rows(story, named, frame)
    moving_rows = tuple(filter(any, rows or ()))
    is_square = {len(row) for row in moving_rows} == {len(moving_rows)}  # and not empty
    size = determinant(algebra, moving_rows) if is_square else None
    if not size:
        return None
    scale, factors = size.factor_list()
    still, others = algebra.ring.ground_new(scale), []
    for factor, power in factors:
        forms = (algebra.normal(factor), algebra.normal(expanded(algebra, factor)))
        number_, form = primitive(min(forms, key=len))
        still *= number_**power
        is_constant = algebra.is_constant(form)
        if is_constant and len(form) == 1:
            still *= form**power
        elif is_constant or len(form) <= LONGEST:
            others.append((form, power))
        else:
            return None
    return algebra.normal(still), others


def _rows(story: Story, named: Directions, frame: int) -> Rows | None:
    """What the task names of joints' velocities, in a frame; None for a part of the rotation."""
    algebra, chain = story.algebra, story.algebra.chain
    every = list(velocity_columns(algebra, frame, None, chain.dof))
    columns = [every[joint.number - 1] for joint in chain.solved]
    match named:
        case Directions.NONE:
            return tuple(
                tuple(moved[row] for moved, _ in columns) for row in chain.task.position_rows
            )
        case Directions.ROTATION | Directions.POINTING if chain.task.position_rows:
            whole = [moved + spin for moved, spin in columns]
            if named is Directions.POINTING:
                whole.append((algebra.ring.zero,) * 3 + approach(algebra, frame))
            return tuple(zip(*whole, strict=True))
    return None


def determinant(algebra: Algebra, rows: Rows) -> Polynomial | None:
    """By minors, rows with most zeros first; None where one has too many terms."""
    count = len(rows)
    order = sorted(range(count), key=lambda row: sum(map(bool, rows[row])))
    turned = sum(order[i] > order[j] for j in range(count) for i in range(j))

    @cache
    def minor(left: tuple[int, ...]) -> Polynomial | None:
        """Of the last rows, in these columns."""
        if not left:
            return algebra.ring.one
        total = algebra.ring.zero
        for place, column in enumerate(left):
            entry = rows[order[count - len(left)]][column]
            if entry:
                below = minor(left[:place] + left[place + 1 :])
                if below is None:
                    return None
                total += (-1) ** place * entry * below
        if count > FEW:
            total = algebra.normal(total)
        return None if len(total) > MOST_TERMS else total

    size = minor(tuple(range(count)))
    return None if size is None else (-1) ** turned * size
