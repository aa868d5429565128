"""By how much a row misses its pose: the entries of (A_1 ... A_m)^-1 U_0 = A_{m+1} ... A_n.

Seen from whichever frame m a column differs as much, and one frame takes the fewest operations.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import POSE_PLACES
from dhgen.kinematics.task import telling_entries
from dhgen.program.lowering.vectors import inner

if TYPE_CHECKING:
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.context import Lowering

Miss = tuple["Node", int]  # a difference, and the lengths in it: one or none


def misses(context: Lowering) -> list[Miss]:
    """What each entry that tells the task differs by.

    Seen from the base, or from the frame from where it takes the fewest operations.
    """
    places = [POSE_PLACES[name] for name in sorted(telling_entries(context.chain.task))]
    columns = {column for _, column in places}
    before = len(context.builder.entries)
    whole = len(places) == 3 * len(columns)  # another frame needs all of a column
    frames = range(context.chain.dof + 1 if context.checks.moved and whole else 1)
    found = [_seen_from(context, m, places) for m in frames]
    return min(
        found, key=lambda each: context.builder.operations([miss for miss, _ in each], before)
    )


def _seen_from(context: Lowering, m: int, places: list[tuple[int, int]]) -> list[Miss]:
    """The same from frame m; those that vanish identically are left out."""
    reached = context.problem.spans.product(m, len(context.problem.links))
    found = []
    for row, column in places:
        wanted = _wanted(context, m, row, column)
        miss = context.builder.sub(wanted, context.lower(reached.entry(row, column)))
        if not context.builder.is_zero(miss):
            found.append((miss, int(column == 3)))
    return found


def _wanted(context: Lowering, m: int, row: int, column: int) -> Node:
    """An entry of (A_1 ... A_m)^-1 U_0."""
    if not m:
        return context.value(f"t{row + 1}{column + 1}")
    builder, moved = context.builder, context.problem.spans.product(0, m)
    there = [context.value(f"t{k + 1}{column + 1}") for k in range(3)]
    if column == 3:
        origin = map(context.lower, moved.translation)
        there = [builder.sub(*both) for both in zip(there, origin, strict=True)]
    return inner(builder, [context.lower(moved.rotation[k][row]) for k in range(3)], there)
