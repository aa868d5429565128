"""Arms of fewer joints than the task has numbers: J has no determinant, but some columns have one.

Columns whose entries other than zero lie in as many rows as there are columns divide all
determinants of as many rows of J as it has columns: theirs is a factor of each.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING

from dhgen.derivation.text.formula import times
from dhgen.derivation.text.lines import width
from dhgen.derivation.velocity.columns import view_from
from dhgen.derivation.velocity.determinant import (
    LONGEST,
    determinant,
    factors_with_powers,
    raised,
    written,
)
from dhgen.derivation.velocity.task_rows import LONGEST as LONGEST_VIEW
from dhgen.robot.task import Directions

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.derivation.step_context import Singularity
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.constants import Polynomial

MOST = 3  # columns: minors of these stay short


@dataclass(frozen=True, slots=True)
class SomeColumns:
    """Columns of J that lie in as many rows.

    Attributes:
        joints: Whose they are.
        frame: From which the velocities are seen.
        centre: The frame of which the origin has the velocity.
        formula: Their determinant in these rows.
    """

    joints: tuple[int, ...]
    frame: int
    centre: int
    formula: Formula


def has_fewer_joints(story: Story) -> bool:
    """Whether the task has more numbers than the arm has joints to solve for."""
    chain = story.algebra.chain
    return len(chain.solved) < chain.task.dimension and not any(p.apart for p in chain.passive)


def some_columns(story: Story, places: Sequence[Singularity]) -> SomeColumns | None:
    """Those with the shortest determinant that may vanish; None where no columns are so."""
    task = story.algebra.chain.task
    whole = task.directions in {Directions.ROTATION, Directions.POINTING}
    if not whole or len(task.position_rows) < 3:
        return None
    return min(
        _found(story, places),
        key=lambda each: (width(each.formula), len(each.joints), each.frame, -each.centre),
        default=None,
    )


def _found(story: Story, places: Sequence[Singularity]) -> Iterator[SomeColumns]:
    solved = [joint.number for joint in story.algebra.chain.solved]
    for frame in range(story.dof + 1):
        view = view_from(story, frame)
        if view.length > LONGEST_VIEW:
            continue
        for centre in range(len(view.frames)):
            every = view.columns(centre)
            columns = {joint: (*every[joint - 1][0], *every[joint - 1][1]) for joint in solved}
            for count in range(2, MOST + 1):
                for joints in combinations(solved, count):
                    formula = _determinant(story, places, [columns[joint] for joint in joints])
                    if formula is not None:
                        yield SomeColumns(joints, frame, centre, formula)


def _determinant(
    story: Story, places: Sequence[Singularity], columns: list[tuple[Polynomial, ...]]
) -> Formula | None:
    """In factors of which one moves; None where rows are not as many as columns, or it is long."""
    rows = tuple(filter(any, zip(*columns, strict=True)))
    size = determinant(story.algebra, rows) if len(rows) == len(columns) else None
    if not size:
        return None
    still, powers = factors_with_powers(story.algebra, size)
    if any(len(form) > LONGEST for form in powers):
        return None
    constant, factors = written(story, places, still, powers)
    if not factors or any(each.is_never_zero for each in factors):
        return None
    return times(constant, *(raised(each.formula, each.power) for each in factors))
