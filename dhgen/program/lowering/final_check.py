"""Whether a row reproduces its pose, which may have more entries than the arm can choose.

The entries of (A_1 ... A_m)^-1 U_0 = A_{m+1} ... A_n are compared: seen from whichever frame m a
column differs as much, and one frame takes the fewest operations.
"""

from __future__ import annotations

from functools import partial, reduce
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import POSE_PLACES
from dhgen.kinematics.task import compared_entries
from dhgen.program.ir import Failure
from dhgen.program.lowering.vectors import inner

if TYPE_CHECKING:
    from dhgen.program.building.graph import Node
    from dhgen.program.building.schedule import Option
    from dhgen.program.lowering.context import Lowering


Miss = tuple["Node", int]  # a difference, and the lengths in it: one or none


def misses(context: Lowering) -> list[Miss]:
    """The difference of each entry that fixes the task.

    Seen from the base, or from the frame from where it takes the fewest operations.
    """
    places = [POSE_PLACES[name] for name in sorted(compared_entries(context.chain.task))]
    columns = {column for _, column in places}
    before = len(context.builder.entries)
    whole = len(places) == 3 * len(columns)  # another frame needs all of a column
    frames = range(context.chain.dof + 1 if context.checks.moved and whole else 1)
    found = [_seen_from(context, m, places) for m in frames]
    return min(
        found, key=lambda each: context.builder.operations([miss for miss, _ in each], before)
    )


def _seen_from(context: Lowering, m: int, places: list[tuple[int, int]]) -> list[Miss]:
    """The equations seen from frame m, without equations that vanish identically."""
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


def check_rows(context: Lowering) -> None:
    """A pose with more entries than the arm can choose has to be one of its poses."""
    _Check(context).run()


class _Check:
    def __init__(self, context: Lowering) -> None:
        self._context = context
        self._builder = context.builder
        self._scales = context.scales
        self._checks = context.checks

    def run(self) -> None:
        builder = self._builder
        builder.heading("is the pose one that the arm can take?")
        found = misses(self._context)
        total = self._length(found) if self._checks.again else None
        chosen = (
            () if total is None else builder.deciding(self._context.angles.free_options(), total)
        )
        groups: dict[tuple[int, ...], list[Node]] = {}  # by the signs that they depend on
        for miss, degree in found:
            slack = self._slack(degree, chosen)
            near = builder.apply("at_most", builder.absolute(miss), slack)
            groups.setdefault(builder.axes_of(near), []).append(near)
        if total is None or not chosen:
            for group in groups.values():
                fits = reduce(partial(builder.apply, "and"), group)
                builder.guard(self._or_between(fits, chosen), Failure.INCONSISTENT)
            return
        # all at once, so that the whole miss is known where a branch ends
        builder.name(total, "missed")
        every = [near for group in groups.values() for near in group]
        fits = reduce(partial(builder.apply, "and"), every)
        builder.guard(self._or_between(fits, chosen), Failure.INCONSISTENT, total, chosen)

    def _or_between(self, fits: Node, chosen: tuple[Option, ...]) -> Node:
        """Whether a row fits, or may be between two that do, however far it misses the pose.

        Between roots that nearly meet, what follows from them may be anything. Where a joint was
        chosen another choice is looked for instead.
        """
        either, neither = partial(self._builder.apply, "or"), partial(self._builder.apply, "not")
        if not self._context.meeting:
            return fits
        between = reduce(either, self._context.meeting)
        for option in chosen:
            between = self._builder.apply("and", between, neither(option.flag))
        return either(fits, between)

    def _slack(self, degree: int, chosen: tuple[Option, ...]) -> Node:
        """What an entry may differ by, of rounding of the pose or of what the row was taken from.

        What is to be refined may differ by more, but not where another choice can mend it.
        """
        builder, scales = self._builder, self._scales
        tolerances = scales.tolerances
        slack = scales.tolerance(tolerances.consistent, degree, "consistent")
        if not self._checks.completes:
            return slack
        wide = scales.tolerance(tolerances.doubtful, degree, "doubtful")
        flags = list(dict.fromkeys(option.flag for option in chosen))
        if not flags:
            return wide
        return builder.select(builder.either(flags), slack, wide)

    def _length(self, found: list[Miss]) -> Node:
        """The root of the sum of their squares, lengths in arm sizes."""
        builder = self._builder
        squares: dict[int, list[Node]] = {}
        for miss, degree in found:
            squares.setdefault(degree, []).append(builder.square(miss))
        total = builder.integer(0)
        for degree, group in sorted(squares.items()):
            part = reduce(builder.add, group)
            weighted = builder.mul(part, self._scales.weight(-2 * degree)) if degree else part
            total = builder.add(total, weighted)
        return builder.apply("sqrt", total)
