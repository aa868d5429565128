"""C of regular poses: one pose with its branches in lanes, and one lane a pose."""

from __future__ import annotations

import math
from itertools import combinations
from typing import TYPE_CHECKING

from dhgen.program.arctangent import STEEP, arctangent_coefficients
from dhgen.program.flatten import MINUS, flatten
from dhgen.program.ir import Apply, Heading, Let
from dhgen.program.schedule import names_in
from dhgen.robot.robot import TaskKind
from dhgen.targets.c_lanes import LaneText, operators
from dhgen.targets.c_language import C
from dhgen.targets.c_packing import angle_lines, packed_angles
from dhgen.targets.layout import WIDTH, call, listed, wrapped
from dhgen.targets.scalar import pose_entries

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.program.flatten import Choice, Flat
    from dhgen.program.ir import Expression, Program, Statement
    from dhgen.program.regular import Regular
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
    functions = sorted(used & {"sin", "cos", "wrap"})
    return {
        "functions": functions,
        "vectors": [
            {"name": "four", "lanes": 4, "functions": functions},
            {"name": "wide", "lanes": "LANES", "functions": functions},
        ],
        "arctangent": _arctangent(),
        "irregularity": {name: _irregularity(module, name) for name in ("wide", "double")},
        "wide": _wide(module, flat),
        "one": _one(module, lanes),
        "tile": {"prototype": _prototype(module, "HELPER unsigned solve_tile", "tile")},
    }


def _inputs(module: SolverModule, number: str) -> list[str]:
    """The pose, and the values of free joints."""
    count = len(module.chain.free)
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
        "pi": repr(math.pi),
    }


def _irregularity(module: SolverModule, number: str) -> dict[str, object]:
    """The head and the statements of the function, for one type of numbers."""
    given = ", ".join(_inputs(module, number))
    lines = [line.replace("%", number) for line in _irregular_lines(module)]
    return {"head": f"HELPER {number} irregularity_{number}({given})", "lines": lines}


def _irregular_lines(module: SolverModule) -> list[str]:
    """Statements; % is the type."""
    kind = module.chain.task.kind
    positions = [f"T[{4 * row + 3}]" for row in module.position_entries]
    positions += [f"free_joints[{place}]" for place in range(len(module.chain.free))]
    lines, terms = [], []
    if kind in {TaskKind.POSE, TaskKind.ORIENTATION}:
        for row in range(3):
            entries = [f"{'xyz'[row]}{column} = T[{4 * row + column}]" for column in range(3)]
            lines.append(f"const % {', '.join(entries)};")
        lines += [
            "const % xx = x0 * x0 + x1 * x1 + x2 * x2 - 1.0;",
            "const % yy = y0 * y0 + y1 * y1 + y2 * y2 - 1.0;",
            "const % xy = x0 * y0 + x1 * y1 + x2 * y2;",
            "const % zx = x1 * y2 - x2 * y1 - z0;",
            "const % zy = x2 * y0 - x0 * y2 - z1;",
            "const % zz = x0 * y1 - x1 * y0 - z2;",
        ]
        terms.append("xx * xx + yy * yy + 2.0 * xy * xy + zx * zx + zy * zy + zz * zz")
    elif kind is TaskKind.POINTING:
        lines.append("const % zz = T[2] * T[2] + T[6] * T[6] + T[10] * T[10] - 1.0;")
        terms.append("zz * zz")
    if kind is TaskKind.POSE:
        lines.append("const % w0 = T[12], w1 = T[13], w2 = T[14], w3 = T[15] - 1.0;")
        terms.append("w0 * w0 + w1 * w1 + w2 * w2 + w3 * w3")
    if positions:
        terms.append(f"0.0 * ({' + '.join(positions)})")
    return [*lines, *wrapped(f"return {' + '.join(terms)};", "", width=WIDTH - 4)]


def _prototype(module: SolverModule, head: str, form: str) -> str:
    rows, dof, count = module.solver.rows, module.chain.dof, len(module.chain.free)
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
    lines: list[str] = []
    heading = ""
    for statement in statements:
        if isinstance(statement, Heading):
            heading = C().comment(statement.text)
        elif isinstance(statement, Let):
            if heading:
                lines += ["", INDENT + heading]
                heading = ""
            lines += wrapped(INDENT + text.let(statement), INDENT)
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
        elif names_in([statement.expression]) & late:
            late.add(statement.name)
            last.append(statement)
        elif isinstance(statement.expression, Apply) and statement.expression.operator == "atan2":
            late.add(statement.name)
            angles.append(statement)
        else:
            first.append(statement)
    places = {axis: axis + 2 - len(flat.lanes) for axis in range(len(flat.lanes))}
    lines = [*_lets(first, text), ""]
    for line in angle_lines(packed_angles(angles, places), text):
        lines += wrapped(INDENT + line, INDENT)
    return [*lines, *_lets(last, text)]


def _wide(module: SolverModule, flat: Flat) -> dict[str, object]:
    """One lane a pose."""
    text = LaneText("wide", flat.program, wide=True)
    lines = [*entry_lines(flat.program, "wide"), *_lets(flat.program.body, text), ""]
    dof = module.chain.dof
    for place, (choice, group) in enumerate(zip(flat.choices, flat.groups, strict=True)):
        row = _row(module, flat, choice, 0)
        for joint, value in enumerate(group):
            lines += wrapped(f"{INDENT}q[{dof * row + joint}] = {text.vector(value)};", INDENT)
        first = f"q[{dof * row}]"
        outside = text.mask(flat.outside[place]) if flat.outside else "0"
        lines += wrapped(f"{INDENT}kind[{row}] = kind_of({first} != {first}, {outside});", INDENT)
    given = ", ".join(["T", *(["free_joints"] if module.chain.free else [])])
    limit = repr(module.precision.tolerances.orthonormal)
    lines.append(f"{INDENT}const wide_mask exact = irregularity_wide({given}) <= {limit};")
    doubt = "" if flat.doubt is None else f" | ({text.text(flat.doubt).text})"
    lines.append(f"{INDENT}return (exact == 0){doubt};")
    head = "HELPER wide_mask solve_wide"
    return {"prototype": _prototype(module, head, "wide"), "lines": lines}


def entry_lines(program: Program, number: str = "double") -> list[str]:
    """The entries of the pose get their names, row by row."""
    lines = []
    for row in (1, 2, 3):
        named = [
            f"T{entry.row}{entry.column} = T[{4 * (row - 1) + entry.column - 1}]"
            for entry in pose_entries(program)
            if entry.row == row
        ]
        lines += [f"{INDENT}const {number} {', '.join(named)};"] if named else []
    return lines


def _one(module: SolverModule, flat: Flat) -> dict[str, object]:
    """Branches in lanes."""
    text = LaneText("four", flat.program, wide=False)
    values = {1: ["1.0, -1.0, 1.0, -1.0"], 2: ["1.0, 1.0, -1.0, -1.0", "1.0, -1.0, 1.0, -1.0"]}
    lines = [
        f"{INDENT}const four {axis.name} = {{ {signs} }};"
        for axis, signs in zip(flat.program.axes, values.get(len(flat.lanes), []), strict=True)
    ]
    lines += [*entry_lines(flat.program), *_with_angles(flat, text), ""]
    given = ", ".join(["T", *(["free_joints"] if module.chain.free else [])])
    limit = repr(module.precision.tolerances.orthonormal)
    lines.append(f"{INDENT}if (!(irregularity_double({given}) <= {limit}))")
    lines.append(f"{INDENT}    return -1;")
    if flat.doubt is not None:
        doubt = text.text(flat.doubt)
        asked = f"bits_four({doubt.text})" if doubt.lanes else doubt.text
        lines += wrapped(f"{INDENT}if ({asked})", INDENT)
        lines.append(f"{INDENT}    return -1;")
    lines.append(f"{INDENT}int count = 0;")
    for place, (choice, group) in enumerate(zip(flat.choices, flat.groups, strict=True)):
        row = [_row(module, flat, choice, lane) for lane in range(4)]
        lines += _stores(text, group, row)
        name = f"kind{place + 1}"
        first = text.vector(group[0])
        outside = text.mask(flat.outside[place]) if flat.outside else "0"
        kind = f"kind_of({first} != {first}, {outside})"
        lines += wrapped(f"{INDENT}const four_mask {name} = {kind};", INDENT)
        used = sorted({r: lane for lane, r in reversed(list(enumerate(row)))}.items())
        mask = sum(1 << lane for _, lane in used)
        lines.append(f"{INDENT}count += __builtin_popcount(bits_four({name} == 0) & {mask}u);")
        lines += [f"{INDENT}status[{r}] = (unsigned char){name}[{lane}];" for r, lane in used]
    lines.append(f"{INDENT}return count;")
    head = "HELPER int solve_regular"
    about = f"{len(flat.lanes)} signs"
    return {"prototype": _prototype(module, head, "one"), "lines": lines, "about": about}


def _stores(text: LaneText, group: tuple[Expression, ...], rows: list[int]) -> list[str]:
    lines = []
    place = 0
    while place < len(group):
        left = len(group) - place
        size = 4 if left >= 4 else 2 if left >= 2 else 1
        parts = ", ".join(text.vector(value) for value in group[place : place + size])
        where = ", ".join(f"&q[{row}][{place}]" for row in rows)
        lines += wrapped(f"{INDENT}store_{size}({where}, {parts});", INDENT)
        place += size
    return lines
