"""The C target: a header and a C99 source that needs nothing but <math.h>."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.program.flatten import flatten
from dhgen.program.role import LimitEnd, Source
from dhgen.program.tolerances import SINGLE
from dhgen.targets.c_irregular import finite_entries, finite_given
from dhgen.targets.c_language import C
from dhgen.targets.c_regular import best_lanes, entry_lines, regular_values
from dhgen.targets.c_single import in_single_precision
from dhgen.targets.comments import plain
from dhgen.targets.constants import constant_texts
from dhgen.targets.general.emit import c_rows, c_source
from dhgen.targets.layout import INDENT, WIDTH, c_array, call, fitted, listed, packed, paragraph
from dhgen.targets.module import made_text, named_entries, regular_solver
from dhgen.targets.numerical.emit import c_both_sides, c_search, c_seeking, c_tightening, c_tools
from dhgen.targets.scalar import arm_angle_values, output_texts, solver_lines, straight_lines
from dhgen.targets.solver.common import common_of
from dhgen.targets.solver.searches import fan_steps
from dhgen.targets.solver.task import meaning
from dhgen.targets.templates import named, render
from dhgen.targets.walk import finds_roots, parted, whole_arm

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.program.ir import Program
    from dhgen.targets.constants import ConstantText
    from dhgen.targets.module import SolverModule
    from dhgen.targets.solver.module import Module

MOST_LANES = 8  # of a vector, with AVX-512


def c_files(module: SolverModule) -> dict[str, str]:
    """The header and the source by their names."""
    solver = regular_solver(module)
    flats = () if solver is None else (flatten(solver), best_lanes(solver))
    common = common_of(module)
    values = named(common) | _texts(module) | _functions(module) | _bodies(module, common.module)
    values |= _constants(module, *(flat.program for flat in flats))
    values |= {"regular": bool(flats), "lanes": module.precision is not SINGLE}
    if flats:
        values |= regular_values(module, *flats)
    if (kernel := parted(module.solver)) is not None:
        values["both_sides"] = c_both_sides(kernel, module.solver.turning, values)
    if module.solver.tightened is not None:
        values["seeking"] = c_seeking(module.solver.tightened, values)
    texts = {
        f"{module.name}.h": fitted(render("c/solver.h.jinja", **values)),
        f"{module.name}.c": fitted(render("c/solver.c.jinja", **values)),
    }
    if module.precision is SINGLE:
        return {name: fitted(in_single_precision(text)) for name, text in texts.items()}
    return texts


def _texts(module: SolverModule) -> dict[str, object]:
    """Comments, constants and arrays."""
    limits = [joint.limits for joint in module.chain.joints]
    low = [repr(pair[0]) if pair else "-INFINITY" for pair in limits]
    high = [repr(pair[1]) if pair else "INFINITY" for pair in limits]
    flags = ["1" if kind == "R" else "0" for kind in module.joint_types]
    dof = module.chain.dof
    frames = "Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in "
    finite, given = finite_entries(module), finite_given(module)
    named_places = [str(entry.place) for entry in named_entries(module.chain)]
    single = f", all in {SINGLE.name}" if module.precision is SINGLE else ""
    return {
        "about": paragraph(f"{module.name}: {plain(module.title)}", " * "),
        "made_h": made_text(module, "c/solver.h.jinja", " * "),
        "made_c": made_text(module, "c/solver.c.jinja", " * "),
        "frames": paragraph(
            f"{frames}{module.length_unit}, angles in rad{single}. {meaning(module.chain.task)}",
            " * ",
        ),
        "branch_names": _strings(module.branches),
        "lowest": c_array(f"static const double lowest[{dof}]", low),
        "highest": c_array(f"static const double highest[{dof}]", high),
        "revolute": c_array(f"static const int revolute[{dof}]", flags),
        "weight": c_array(f"static const double weight[{dof}]", map(repr, module.weights)),
        "fan_step": c_array(f"static const double fan_step[{dof}]", map(repr, fan_steps(module))),
        "finite": " && ".join(f"isfinite({each})" for each in finite),
        "given_finite": " && ".join(f"isfinite({each})" for each in given),
        "named_places": c_array(f"static const int named[{len(named_places)}]", named_places),
        "named_count": len(named_places),
        "length_weight": repr(1.0 / module.chain.size),
        "row_size": module.solver.rows * dof,
        "fills_lanes": module.solver.rows * dof >= MOST_LANES,
    }


def _constants(module: SolverModule, *flats: Program) -> dict[str, object]:
    """The constants of all builds, and those that only branches in lanes need; limits are told."""
    common, all_texts = (
        [each for each in constant_texts(module, programs) if not isinstance(each.role, LimitEnd)]
        for programs in (flats[:1], flats)
    )
    only = [each for each in all_texts if each not in common]
    return {
        "constants": _constant_lines(common),
        "lane_constants": _constant_lines(only),
    }


def _constant_lines(constants: list[ConstantText]) -> list[str]:
    """Definitions of those with a comment, of coefficients, and of those whose names say all."""
    coefficients = [each for each in constants if each.role is Source.COEFFICIENT]
    told = [each for each in constants if each.comment and each not in coefficients]
    lines = ["static const double"] if told else []
    for each in told:
        lines += _constant(each, ";" if each is told[-1] else ",")
    if coefficients:
        lines += ["/* coefficients */", *_bare(coefficients)]
    return lines + _bare([each for each in constants if not each.comment])


def _bare(constants: list[ConstantText]) -> list[str]:
    """A definition without comments, if there is anything to be defined."""
    if not constants:
        return []
    first, *others = (f"{each.name} = {each.value}" for each in constants)
    *full, last = packed([f"static const double {first}", *others], "", ", ")
    return [*(f"{line}," for line in full), f"{last};"]


def _functions(module: SolverModule) -> dict[str, str]:
    """Prototypes of the header's functions, and what they share."""
    name, dof, rows = module.name, module.chain.dof, module.solver.rows
    count = module.chain.given
    free = [f"const double free_joints[{count}]"] if count else []
    pose = "const double T[16]"
    table = [f"double q[{rows}][{dof}]", f"unsigned char status[{rows}]"]
    moved = ["double moved"] if finds_roots(module.solver) else []
    batch_free = ["const double *free_joints"] if count else []
    given = ["free_joints"] if count else []
    batch = ["size_t n", "const double *T", *batch_free, "double *q", "unsigned char *status"]
    seed = f"const double q_seed[{dof}]"
    inputs = [pose, *free, "const double *q_seed", *table]
    of_a_row = [pose, *free, f"const double seed[{dof}]", "int row", *table]

    def inputs_at(k: str) -> list[str]:
        return [_part("T", 16, k), *(_part(each, count, k) for each in given)]

    def one(k: str) -> list[str]:
        table = f"(double (*)[{dof}])({_part('q', rows * dof, k)})"
        return [*inputs_at(k), "NULL", table, _part("status", rows, k)]

    def tile(k: str) -> list[str]:
        return [*inputs_at(k), _part("q", rows * dof, k), _part("status", rows, k)]

    return {
        "ik_prototype": call(f"int {name}_ik", inputs, ""),
        "careful_prototype": call("int ik_carefully", inputs, ""),
        "nearest_prototype": call(
            f"int {name}_ik_nearest", [pose, *free, seed, f"double q[{dof}]"], ""
        ),
        "batch_prototype": call(f"void {name}_ik_batch", batch, ""),
        "solve_prototype": call(
            "static void solve", [pose, *free, f"const double seed[{dof}]", *moved, *table], ""
        ),
        "choose_prototype": call("static void choose_again", of_a_row, ""),
        "keep_prototype": call("static void keep_limits", of_a_row, ""),
        "search_given": ", .free_joints = free_joints" if count else "",
        "batch_call": call(f"(void){name}_ik", one("k"), ";", INDENT * 2),
        "tile_call": call("solve_tile", tile("k"), ""),
        "tile_again": call(f"(void){name}_ik", one("i"), ";", INDENT * 4),
        "free_parameter": "".join(f", {each}" for each in free),
        "free_argument": "".join(f", {each}" for each in given),
    }


def _part(array: str, size: int, place: str) -> str:
    """Where the part of an array begins that is one of several of a size."""
    return f"{array} + {place}" if size == 1 else f"{array} + {size} * {place}"


def _bodies(module: SolverModule, text: Module) -> dict[str, object]:
    """The programs as lines."""
    language = C()
    forward = output_texts(module.forward, language)
    jacobian = output_texts(module.jacobian, language)
    return {
        "entries": entry_lines(module.solver),
        "entries_macro": [],
        "all_joints": _all_joints(module, text),
        "tightening": _tightening(module, text),
        "solver": solver_lines(module.solver, language, INDENT),
        "forward": straight_lines(module.forward, language, INDENT),
        "forward_rows": _assignments("T", forward, 4),
        "jacobian": straight_lines(module.jacobian, language, INDENT),
        "arm_angle": arm_angle_values(module.arm_angle, language),
        "jacobian_rows": _assignments("J", jacobian, module.chain.dof),
    }


def _all_joints(module: SolverModule, text: Module) -> str:
    """The function that solves all joints at once, where there is one."""
    whole = whole_arm(module.solver)
    if whole is None:
        return ""
    parts = [c_tools(whole.descent, text)]
    if whole.general is None:
        parts.append(c_search(whole.descent, text))
    else:
        parts.append(c_source(whole.general, module.name))
        parts.append(c_rows(whole.general, module.chain, module.name))
    return "\n".join(parts)


def _tightening(module: SolverModule, text: Module) -> str:
    """The function that tightens rows, where they may need it."""
    kernel = module.solver.tightened
    return "" if kernel is None else c_tightening(kernel, text)


def _constant(constant: ConstantText, end: str) -> list[str]:
    line = f"{INDENT}{constant.name} = {constant.value}{end}"
    if len(line) + len(constant.comment) + 7 <= WIDTH:
        return [f"{line} /* {constant.comment} */"]
    # the end of a comment has to fit, too
    told = paragraph(f"{constant.comment} ##", f"{INDENT} * ").replace(" ##", "").rstrip()
    return [f"{INDENT}/* {told} */", line]


def _strings(texts: Iterable[str]) -> list[str]:
    return listed([f'"{text}"' for text in texts], INDENT)


def _assignments(array: str, entries: list[str], columns: int) -> list[str]:
    """A matrix, one of its rows after another."""
    lines: list[str] = []
    for start in range(0, len(entries), columns):
        row = entries[start : start + columns]
        pieces = [f"{array}[{start + place}] = {entry};" for place, entry in enumerate(row)]
        lines += packed(pieces, INDENT)
    return lines
