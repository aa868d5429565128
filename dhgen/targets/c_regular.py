"""C of regular poses: one pose with its branches in lanes, and one lane a pose."""

from __future__ import annotations

import math
from collections import Counter
from itertools import combinations
from typing import TYPE_CHECKING

from dhgen.program.arctangent import STEEP, arctangent_coefficients
from dhgen.program.arrival import arrivals
from dhgen.program.flatten import MINUS, flatten
from dhgen.program.ir import Apply, Heading, Let, Variable
from dhgen.program.walk import names_in
from dhgen.targets.c_declared import dense
from dhgen.targets.c_irregular import irregularities
from dhgen.targets.c_lanes import LaneText, operators
from dhgen.targets.c_language import C
from dhgen.targets.c_packing import angle_declarations, in_order, packed_angles
from dhgen.targets.c_rows import status_lines, store_places, stores, words
from dhgen.targets.layout import call, listed, packed, wrapped
from dhgen.targets.scalar import pose_entries

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.program.flatten import Choice, Flat
    from dhgen.program.ir import Expression, Program, Statement
    from dhgen.program.unguarded import Regular
    from dhgen.targets.c_declared import Declaration
    from dhgen.targets.module import SolverModule

INDENT = "    "
COSTS = {"atan2": 30, "div": 4, "sqrt": 6}  # of an operator in lanes; of any other 1


def regular_values(module: SolverModule, flat: Flat, lanes: Flat) -> dict[str, object]:
    """What the templates name.

    Args:
        module: The robot.
        flat: Its program for regular poses, all branches unrolled.
        lanes: The same, branches in lanes.
    """
    used = set(operators(flat.program))
    sizes = {size for _, size in store_places(module.chain.dof)}
    programs = module.solver, flat.program, lanes.program
    alike = len({tuple(pose_entries(program)) for program in programs}) == 1
    wide = _wide(module, flat, entry_lines(flat.program, "wide", alike=alike))
    return {
        "functions": sorted(used & {"sin", "cos", "wrap"}),
        "stores": {name: size in sizes for name, size in (("one", 1), ("two", 2))},
        "arctangent": _arctangent(),
        "irregularity": irregularities(module, _inputs(module, "%")),
        "wide": wide,
        "spreads_truths": "where_wide(" in str(wide["lines"]),
        "one": _one(module, lanes, entry_lines(lanes.program, alike=alike)),
        "entries": entry_lines(module.solver, alike=alike),
        "entries_macro": _entries_macro(flat.program) if alike else [],
        "words": words(module.solver.rows),
        "tile": {"prototype": _prototype(module, "HELPER unsigned solve_tile", "tile")},
    }


def _inputs(module: SolverModule, number: str) -> list[str]:
    """The pose, and the values of free joints."""
    count = module.chain.given
    free = [f"const {number} free_joints[{count}]"] if count else []
    return [f"const {number} T[16]", *free]


def best_lanes(solver: Regular) -> Flat:
    """Two signs in lanes, or all if there are fewer: those that leave the least to be computed."""
    axes = range(len(solver.program.axes))
    choices = combinations(axes, min(2, len(axes)))
    return min((flatten(solver, lanes) for lanes in choices), key=_cost)


def _cost(flat: Flat) -> int:
    return sum(COSTS.get(operator, 1) for operator in operators(flat.program))


def _arctangent() -> dict[str, object]:
    """Estrin's scheme for the polynomial, and multiples of pi / 4."""
    names = [f"odd[{place}]" for place in range(len(arctangent_coefficients()))]
    numbers = listed([repr(coefficient) for coefficient in arctangent_coefficients()], INDENT)
    pairs = [f"({a} + {b} * u)" for a, b in zip(names[::2], names[1::2], strict=False)]
    fours = [f"{a} + {b} * u2" for a, b in zip(pairs[::2], pairs[1::2], strict=False)]
    return {
        "odd": "\n".join([f"static const double odd[{len(names)}] = {{", *numbers, "};"]),
        "lines": [
            f"p0 = {fours[0]}",
            f"p4 = {fours[1]}",
            f"p8 = {pairs[4]} + {names[10]} * u2",
            "p = p0 + (p4 + p8 * u4) * u4",
        ],
        "tangent": repr(STEEP),
        "quarter": repr(math.pi / 4),
        "half": repr(math.pi / 2),
    }


def _prototype(module: SolverModule, head: str, form: str) -> str:
    rows, dof, count = module.solver.rows, module.chain.dof, module.chain.given
    tables = {
        "wide": [f"wide q[{rows * dof}]", f"wide_mask kind[{rows}]"],
        "one": [f"double q[{rows}][{dof}]", f"unsigned char status[{rows}]"],
        "tile": ["double *q", "unsigned char *status"],
    }[form]
    inputs = _inputs(module, "wide" if form == "wide" else "double")
    if form == "tile":
        inputs = ["const double *T", *(["const double *free_joints"] if count else [])]
    return call(head, [*inputs, *tables], "")


def _row(module: SolverModule, flat: Flat, choice: Choice, lane: int) -> int:
    """The number of the row of a lane."""
    signs = dict(zip(flat.unrolled, choice, strict=True))
    for place, axis in enumerate(flat.lanes):
        first = lane < 2 if place == 0 and len(flat.lanes) == 2 else lane % 2 == 0
        signs[axis] = 1 if first else MINUS
    row = 0
    for axis in range(len(module.solver.axes)):
        row = 2 * row + (signs[axis] == MINUS)
    return row


def _lets(statements: Iterable[Statement], text: LaneText) -> list[str]:
    """Values under their headings."""
    sections: list[tuple[str, list[Declaration]]] = [("", [])]
    for statement in statements:
        if isinstance(statement, Heading):
            sections.append((C().comment(statement.text), []))
        elif isinstance(statement, Let):
            sections[-1][1].append(text.let(statement))
    lines: list[str] = []
    for heading, values in sections:
        if heading and values:
            lines += ["", INDENT + heading]
        lines += dense(values, INDENT)
    return lines


def _with_angles(flat: Flat, text: LaneText) -> list[str]:
    """Values, first those without angles, then the angles together, then the others."""
    late: set[str] = set()
    first: list[Statement] = []
    angles: list[Let] = []
    last: list[Statement] = []
    for statement in flat.program.body:
        if not isinstance(statement, Let):
            first.append(statement)
        elif names_in(statement.expression) & late:
            late.add(statement.name)
            last.append(statement)
        elif isinstance(statement.expression, Apply) and statement.expression.operator == "atan2":
            late.add(statement.name)
            angles.append(statement)
        else:
            first.append(statement)
    places = {axis: axis + 2 - len(flat.lanes) for axis in range(len(flat.lanes))}
    lines = [*_lets(first, text), ""]
    vectors = in_order(packed_angles(angles, places), arrivals(flat.program))
    lines += dense(angle_declarations(vectors, text), INDENT)
    return [*lines, *_lets(last, text)]


def _wide(module: SolverModule, flat: Flat, entries: list[str]) -> dict[str, object]:
    """One lane a pose."""
    text = LaneText("wide", flat.program, wide=True)
    at_once = _needed_once(flat)
    named = [statement for statement in flat.program.body if statement not in at_once.values()]
    lines = [*entries, *_lets(named, text), ""]
    dof = module.chain.dof
    for place, (choice, group) in enumerate(zip(flat.choices, flat.groups, strict=True)):
        row = _row(module, flat, choice, 0)
        results = (at_once[each].expression if each in at_once else each for each in group)
        values = enumerate(map(text.vector, results), start=dof * row)
        lines += packed([f"q[{place}] = {value};" for place, value in values], INDENT)
        first = f"q[{dof * row}]"
        beyond = [at_once[each].expression if each in at_once else each for each in flat.outside]
        outside = text.mask(beyond[place]) if beyond else "0"
        lines += wrapped(f"{INDENT}kind[{row}] = kind_of({first}, {outside});", INDENT)
    given = ", ".join(["T", *(["free_joints"] if module.chain.given else [])])
    limit = repr(module.precision.tolerances.orthonormal)
    lines.append(f"{INDENT}const wide_mask exact = irregularity_wide({given}) <= {limit};")
    doubt = "" if flat.doubt is None else f" | ({text.text(flat.doubt).text})"
    lines.append(f"{INDENT}return (exact == 0){doubt};")
    head = "HELPER wide_mask solve_wide"
    return {"prototype": _prototype(module, head, "wide"), "lines": lines}


def _needed_once(flat: Flat) -> dict[Expression, Let]:
    """What only one row needs: it is written where it belongs as soon as it is known."""
    lets = [statement for statement in flat.program.body if isinstance(statement, Let)]
    outputs = flat.program.outputs
    composed = [output for output in outputs if not isinstance(output, Variable)]
    elsewhere = names_in(*composed, *(let.expression for let in lets))
    needed = Counter(outputs)
    written = [*(each for group in flat.groups for each in group), *flat.outside]
    joints = {each for each in written if needed[each] == 1}
    return {
        Variable(let.name): let
        for let in lets
        if Variable(let.name) in joints and let.name not in elsewhere
    }


def entry_lines(program: Program, number: str = "double", *, alike: bool = False) -> list[str]:
    """The entries of the pose get their names, row by row.

    Args:
        program: Which reads them.
        number: Their type.
        alike: Whether all programs read the same, and a macro holds the names.
    """
    if alike:
        return [f"{INDENT}ENTRIES({number});"]
    lines = []
    for row in (1, 2, 3):
        named = [
            f"T{entry.row}{entry.column} = T[{4 * (row - 1) + entry.column - 1}]"
            for entry in pose_entries(program)
            if entry.row == row
        ]
        lines += [f"{INDENT}const {number} {', '.join(named)};"] if named else []
    return lines


def _entries_macro(program: Program) -> list[str]:
    *lines, last = entry_lines(program, "number")
    ending = [f"{line} \\" for line in ["#define ENTRIES(number)", *lines]]
    return [*ending, last.removesuffix(";")]


def _one(module: SolverModule, flat: Flat, entries: list[str]) -> dict[str, object]:
    """Branches in lanes."""
    text = LaneText("four", flat.program, wide=False)
    values = {1: ["1.0, -1.0, 1.0, -1.0"], 2: ["1.0, 1.0, -1.0, -1.0", "1.0, -1.0, 1.0, -1.0"]}
    lines = [
        f"{INDENT}const four {axis.name} = {{ {signs} }};"
        for axis, signs in zip(flat.program.axes, values.get(len(flat.lanes), []), strict=True)
    ]
    lines += [*entries, *_with_angles(flat, text), ""]
    given = ", ".join(["T", *(["free_joints"] if module.chain.given else [])])
    limit = repr(module.precision.tolerances.orthonormal)
    doubts = [text.text(doubt) for doubt in flat.doubts]
    lane = [f"((irregularity_four({given}) <= {limit}) == 0)", *(d.text for d in doubts if d.lanes)]
    single = [f"(unsigned)({d.text})" for d in doubts if not d.lanes]
    doubtful = " | ".join([f"bits_four({' | '.join(lane)})", *single])
    lines += wrapped(f"{INDENT}if ({doubtful})", INDENT)
    lines.append(f"{INDENT}    return -1;")
    rows = [[_row(module, flat, choice, lane) for lane in range(4)] for choice in flat.choices]
    for group, row in zip(flat.groups, rows, strict=True):
        lines += stores(text, group, row)
    nones = [_is_nan(text, group[0]) for group in flat.groups]
    outsides = [text.mask(outside) for outside in flat.outside]
    lines += status_lines(module.name.upper(), module.solver.rows, rows, nones, outsides)
    head = "HELPER int solve_regular"
    about = f"{len(flat.lanes)} signs"
    return {"prototype": _prototype(module, head, "one"), "lines": lines, "about": about}


def _is_nan(text: LaneText, expression: Expression) -> str:
    value = text.vector(expression)
    return f"{value} != {value}"
