"""Whether a row reproduces its pose, which may have more entries than the arm can choose."""

from __future__ import annotations

from functools import partial, reduce
from typing import TYPE_CHECKING

from dhgen.program.ir import Failure
from dhgen.program.lowering.misses import misses

if TYPE_CHECKING:
    from dhgen.program.building.graph import Node
    from dhgen.program.building.schedule import Option
    from dhgen.program.lowering.context import Lowering
    from dhgen.program.lowering.misses import Miss


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
                builder.guard(self._or_leads(fits, chosen), Failure.INCONSISTENT)
            return
        # all at once, so that the whole miss is known where a branch ends
        builder.name(total, "missed")
        every = [near for group in groups.values() for near in group]
        fits = reduce(partial(builder.apply, "and"), every)
        builder.guard(self._or_leads(fits, chosen), Failure.INCONSISTENT, total, chosen)

    def _or_leads(self, fits: Node, chosen: tuple[Option, ...]) -> Node:
        """Whether a row fits, or may stand between two that do, however far it misses the pose.

        Between roots that nearly meet, what follows from them may be anything. Where a joint was
        chosen another choice is looked for instead.
        """
        either, neither = partial(self._builder.apply, "or"), partial(self._builder.apply, "not")
        if not self._context.meeting:
            return fits
        leads = reduce(either, self._context.meeting)
        for option in chosen:
            leads = self._builder.apply("and", leads, neither(option.flag))
        return either(fits, leads)

    def _slack(self, degree: int, chosen: tuple[Option, ...]) -> Node:
        """What an entry may differ by, of rounding of the pose or of what the row was taken from.

        What is to be tightened may differ by more, but not where another choice can mend it.
        """
        builder, scales = self._builder, self._scales
        tolerances = scales.tolerances
        slack = scales.tolerance(tolerances.consistent, degree, "consistent")
        if not self._checks.tightened:
            return slack
        wide = scales.tolerance(tolerances.doubtful, degree, "doubtful")
        flags = list(dict.fromkeys(option.flag for option in chosen))
        if not flags:
            return wide
        return builder.select(reduce(partial(builder.apply, "or"), flags), slack, wide)

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
