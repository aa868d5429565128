"""C of regular poses: one pose with its branches in lanes, and one lane a pose."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING

from dhgen.program.arrival import arrivals
from dhgen.program.ir import Apply, Let
from dhgen.program.regular.flatten import MINUS, flatten
from dhgen.program.walk import names_in
from dhgen.targets.c.declared import dense
from dhgen.targets.c.irregular import irregularity_four
from dhgen.targets.c.lanes import LaneText, operators
from dhgen.targets.c.language import entry_lines
from dhgen.targets.c.packing import angle_declarations, in_order, packed_angles
from dhgen.targets.c.rows import status_lines, stores
from dhgen.targets.c.shared import NOTHING_SHARED, shared_values
from dhgen.targets.c.wide import lets, row_of, wide_lines
from dhgen.targets.dialect import ATOM
from dhgen.targets.layout import INDENT, paragraph, wrapped
from dhgen.tolerances import SINGLE

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.program.ir import Expression, Program, Statement
    from dhgen.program.regular.flatten import Choice, Flat
    from dhgen.program.regular.unguarded import Regular
    from dhgen.targets.c.shared import Shared
    from dhgen.targets.module import SolverModule

MOST_UNROLLED = 300  # values of unrolled loops: of more, compiling takes long and gains little
COSTS = {"atan2": 30, "div": 4, "sqrt": 6}  # of an operator in lanes; of any other 1

IN_LANES = ("", ", one sign in lanes", ", two signs in lanes")  # by how many there are
RETURNS = "Returns how many rows are OK, or -1 if the pose has to be left to `solve`."


@dataclass(frozen=True, slots=True)
class CRegular:
    """The code of regular poses: bodies of functions.

    Attributes:
        wide: One lane a pose.
        one: Branches in lanes; none where they never are.
        about: What they do.
        shared: What both compute in the same words, as lines.
        rows: How many it fills, where the robot has others.
    """

    wide: Sequence[str]
    one: Sequence[str]
    about: str
    shared: Sequence[str]
    rows: int = 0


def regular_values(module: SolverModule, flats: Flats) -> CRegular:
    """The code of a robot's regular poses, from the program that solves them."""
    flat, lanes = flats.wide, flats.lanes
    in_lanes = module.precision is not SINGLE
    shared = shared_values(lanes) if flats.in_loops and in_lanes else NOTHING_SHARED
    entries = entry_lines(flat.program, "dhgen_wide")
    one = _one(module, lanes, entry_lines(lanes.program), shared)
    return CRegular(
        wide=wide_lines(module, flat, entries, shared, unrolled=flats.unrolled),
        one=one if in_lanes else (),
        about=paragraph(f"One regular pose{IN_LANES[len(lanes.lanes)]}. {RETURNS}", " * "),
        shared=shared.macros,
    )


@dataclass(frozen=True, slots=True)
class Flats:
    """What regular poses compute.

    Attributes:
        wide: One lane a pose.
        lanes: Branches in lanes.
        in_loops: Whether the former goes through branches in loops: the two are then the same.
        unrolled: Whether compilers are asked to unroll the loops.
    """

    wide: Flat
    lanes: Flat
    in_loops: bool
    unrolled: bool

    @property
    def programs(self) -> tuple[Program, Program]:
        """Both."""
        return self.wide.program, self.lanes.program


def flats_of(solver: Regular, *, in_loops: bool) -> Flats:
    """What regular poses compute, branches of one lane a pose written out or in loops."""
    lanes, out = best_lanes(solver), flatten(solver)
    values = sum(isinstance(each, Let) for each in out.program.body)
    return Flats(
        wide=lanes if in_loops else out,
        lanes=lanes,
        in_loops=in_loops,
        unrolled=in_loops and values <= MOST_UNROLLED,
    )


def best_lanes(solver: Regular) -> Flat:
    """Two signs in lanes, or all if there are fewer: those that leave the least to be computed."""
    axes = range(len(solver.program.axes))
    choices = combinations(axes, min(2, len(axes)))
    return min((flatten(solver, lanes) for lanes in choices), key=_cost)


def _cost(flat: Flat) -> int:
    return sum(COSTS.get(operator, 1) for operator in operators(flat.program))


def _row(module: SolverModule, flat: Flat, choice: Choice, lane: int) -> int:
    """The number of the row of a lane."""
    signs = dict(zip(flat.unrolled, choice, strict=True))
    for place, axis in enumerate(flat.lanes):
        first = lane < 2 if place == 0 and len(flat.lanes) == 2 else lane % 2 == 0
        signs[axis] = 1 if first else MINUS
    return row_of(module, signs)


def _with_angles(flat: Flat, text: LaneText, shared: Shared, misfit: str) -> list[str]:
    """Values: first all without angles, then the angles together, then the others.

    Irregular poses leave before the angles, as far as these aren't needed to find them: what waits
    for a root meanwhile makes room for what waits for nothing.
    """
    signs = range(len(flat.lanes) + 1)
    known = [line for k in signs for line in shared.stated(k, "four" if k else "double", "four")]
    late: set[str] = set()
    first: list[Statement] = []
    angles: list[Let] = []
    last: list[Statement] = []
    for statement in flat.program.body:
        if not isinstance(statement, Let):
            first.append(statement)
        elif statement.name in shared.names:
            text.declare(statement.name, lanes=bool(statement.axes))
        elif names_in(statement.expression) & late:
            late.add(statement.name)
            last.append(statement)
        elif isinstance(statement.expression, Apply) and statement.expression.operator == "atan2":
            late.add(statement.name)
            angles.append(statement)
        else:
            first.append(statement)
    places = {axis: axis + 2 - len(flat.lanes) for axis in range(len(flat.lanes))}
    lines = [*known, *lets(first, text), ""]
    early = [doubt for doubt in flat.doubts if not names_in(doubt) & late]
    lines += [*_leaving([misfit], early, text), ""]
    vectors = in_order(packed_angles(angles, places), arrivals(flat.program))
    lines += dense(angle_declarations(vectors, text), INDENT)
    lines += lets(last, text)
    late_ones = [doubt for doubt in flat.doubts if doubt not in early]
    return [*lines, *_leaving([], late_ones, text), *_leaving_rounded(flat, text)]


def _leaving(misfits: list[str], doubts: list[Expression], text: LaneText) -> list[str]:
    """Leaves an irregular pose to the other solver."""
    texts = [text.text(doubt) for doubt in doubts]
    lanes = [*misfits, *(each.within(ATOM) for each in texts if each.lanes)]
    single = [f"(unsigned)({each.text})" for each in texts if not each.lanes]
    reasons = [*([f"dhgen_bits_four({' | '.join(lanes)})"] if lanes else []), *single]
    if not reasons:
        return []
    return [*wrapped(f"{INDENT}if ({' | '.join(reasons)})", INDENT), f"{INDENT}    return -1;"]


def _leaving_rounded(flat: Flat, text: LaneText) -> list[str]:
    """Leaves a pose of which no row is exact, and one is near enough to be refined."""
    if not flat.fits:
        return []
    exact, near = (f"dhgen_bits_four({text.mask(each)})" for each in flat.fits)
    return [*wrapped(f"{INDENT}if ({near} && !{exact})", INDENT), f"{INDENT}    return -1;"]


def _one(module: SolverModule, flat: Flat, entries: list[str], shared: Shared) -> list[str]:
    """Branches in lanes."""
    text = LaneText("four", flat.program, wide=False)
    values = {1: ["1.0, -1.0, 1.0, -1.0"], 2: ["1.0, 1.0, -1.0, -1.0", "1.0, -1.0, 1.0, -1.0"]}
    lines = [
        f"{INDENT}const dhgen_four {axis.name} = {{ {signs} }};"
        for axis, signs in zip(flat.program.axes, values.get(len(flat.lanes), []), strict=True)
    ]
    misfit = f"(({irregularity_four(module)} <= DHGEN_ORTHONORMAL) == 0)"
    lines += [*entries, *_with_angles(flat, text, shared, misfit), ""]
    rows = [[_row(module, flat, choice, lane) for lane in range(4)] for choice in flat.choices]
    for group, row in zip(flat.groups, rows, strict=True):
        lines += stores(text, group, row)
    nones = [_is_nan(text, group[0]) for group in flat.groups]
    outsides = [text.mask(outside) for outside in flat.outside]
    return lines + status_lines(module.solver.rows, rows, nones, outsides)


def _is_nan(text: LaneText, expression: Expression) -> str:
    value = text.vector(expression)
    return f"{value} != {value}"
