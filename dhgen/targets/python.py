"""The Python target: a module of numba functions that are plain Python where numba is absent."""

from __future__ import annotations

import math
from hashlib import sha256
from typing import TYPE_CHECKING

from dhgen.program.arctangent import STEEP, arctangent_coefficients
from dhgen.program.flatten import flatten
from dhgen.robot.task import TaskKind
from dhgen.targets.comments import plain
from dhgen.targets.constants import constant_texts
from dhgen.targets.general.emit import python_rows, python_source
from dhgen.targets.layout import INDENT, WIDTH, paragraph, python_array
from dhgen.targets.module import (
    has_to_be_finite,
    made_text,
    named_entries,
    regular_solver,
)
from dhgen.targets.numerical.emit import (
    python_both_sides,
    python_search,
    python_seeking,
    python_tightening,
    python_tools,
)
from dhgen.targets.python_flat import TILE, regular_values
from dhgen.targets.python_language import Python
from dhgen.targets.python_single import assigned
from dhgen.targets.scalar import (
    arm_angle_values,
    output_texts,
    pose_entries,
    solver_lines,
    straight_lines,
)
from dhgen.targets.solver.common import common_of
from dhgen.targets.solver.searches import fan_steps
from dhgen.targets.solver.task import meaning
from dhgen.targets.templates import named, render
from dhgen.targets.walk import parted, uses, whole_arm

if TYPE_CHECKING:
    from dhgen.program.flatten import Flat
    from dhgen.program.ir import Program
    from dhgen.targets.constants import ConstantText
    from dhgen.targets.module import SolverModule
    from dhgen.targets.solver.common import Common
    from dhgen.targets.solver.module import Module

SHARE = 2048  # poses that are worth a thread


def python_files(module: SolverModule) -> dict[str, str]:
    """The module by its name."""
    solver = regular_solver(module)
    flat = None if solver is None else flatten(solver)
    common = common_of(module)
    values = named(common) | _texts(module, common) | _bodies(module, common)
    values |= _flat(module, flat)
    if (kernel := parted(module.solver)) is not None:
        values["both_sides"] = python_both_sides(kernel, module.solver.turning, values)
    if module.solver.tightened is not None:
        values["seeking"] = python_seeking(module.solver.tightened, values)
    text = render("python/solver.py.jinja", **values, digest="")
    digest = sha256(text.encode()).hexdigest()[:16]
    return {f"{module.name}.py": render("python/solver.py.jinja", **values, digest=digest)}


def _texts(module: SolverModule, common: Common) -> dict[str, object]:
    """Comments and constants."""
    none = "(-math.inf, math.inf)"
    limits = [joint.limits for joint in module.chain.joints]
    frames = (
        "Poses are 4 x 4 matrices of the tool in the base frame, lengths in "
        f"{module.length_unit}, angles in rad. {meaning(module.chain.task)}"
    )
    count = module.chain.given
    entries = [f"p{'xyz'[row]}" for row in module.chain.task.position_rows]
    entries += [f"q_free[{place}]" for place in range(count)]
    finite = [f"math.isfinite({each})" for each in has_to_be_finite(module, entries)]
    return {
        "about": paragraph(f"{module.name}: {plain(module.title).rstrip('.')}.", ""),
        "made": made_text(module, "python/solver.py.jinja", ""),
        "frames": paragraph(frames, ""),
        "limits": [f"({pair[0]!r}, {pair[1]!r})" if pair else none for pair in limits],
        "branches": module.branches,
        "weights": python_array("_WEIGHT = np.array", map(repr, module.weights)),
        "fan_steps": python_array("_FAN_STEP = np.array", map(repr, fan_steps(module))),
        "free_tuple": _free_tuple(module),
        "finite": " and ".join(finite) or "True",
        "no_pose": _no_pose(module),
        "free_parameter": ", q_free" if count else "",
        "free_batch": ", q_free[k]" if count else "",
        "share": SHARE,
        "missed_entries": _missed_entries(module),
        "allocates": _allocates(module, common),
        "compiles_apart": _compiles_apart(common, tightens=module.solver.tightened is not None),
        "uses_arctangent": uses(module.solver, "atan2"),
        "arctangent": _arctangent(),
    }


def _bodies(module: SolverModule, common: Common) -> dict[str, object]:
    """The programs as lines."""
    language = Python()
    forward = output_texts(module.forward, language)
    jacobian = output_texts(module.jacobian, language)
    return {
        "entries": _entries(module.solver),
        "all_joints": _all_joints(module, common.module),
        "tightening": _tightening(module, common.module),
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
    parts = [python_tools(whole.descent, text)]
    if whole.general is None:
        parts.append(python_search(whole.descent, text))
    else:
        parts.append(python_source(whole.general, module.name))
        parts.append(python_rows(whole.general, module.chain, module.name))
    return "\n\n".join(parts)


def _tightening(module: SolverModule, text: Module) -> str:
    """The function that tightens rows, where they may need it."""
    kernel = module.solver.tightened
    return "" if kernel is None else python_tightening(kernel, text)


def _flat(module: SolverModule, flat: Flat | None) -> dict[str, object]:
    """What serves regular poses, where there is a program for them, and the constants of all."""
    constants = constant_texts(module, () if flat is None else (flat.program,))
    values: dict[str, object] = {
        "constants": [line for each in constants for line in _constant(each)],
        "regular": None,
    }
    if flat is None:
        return values
    return values | {"regular": regular_values(module, flat), "tile_poses": TILE}


def _entries(program: Program) -> str:
    """The names of the pose's entries, _ for those that are not read."""
    read = {(entry.row, entry.column) for entry in pose_entries(program)}
    places = [(row, column) for row in (1, 2, 3) for column in (1, 2, 3, 4)]
    return ", ".join(f"T{place[0]}{place[1]}" if place in read else "_" for place in places)


def _constant(constant: ConstantText) -> list[str]:
    bare, comment = f"{constant.name} = {constant.value}", constant.comment
    line = f"{bare}  # {comment}" if comment else bare
    return [line] if len(line) <= WIDTH else [f"# {paragraph(comment, '# ')}", bare]


def _assignments(array: str, entries: list[str], columns: int) -> list[str]:
    """A matrix of zeros, its other entries one after another."""
    places = [divmod(place, columns) for place in range(len(entries))]
    return [
        f"{INDENT}{array}[{row}, {column}] = {entry}"
        for (row, column), entry in zip(places, entries, strict=True)
        if entry != "0.0"
    ]


def _free_tuple(module: SolverModule) -> str:
    """The free joints; empty without any."""
    free = module.chain.free
    return f"({', '.join(map(str, free))},)" if free else ""


def _missed_entries(module: SolverModule) -> list[dict[str, object]]:
    """Of each entry that the task names, what joint values miss it by, and the weight of that."""
    reached = output_texts(module.forward, Python())
    return [
        {
            "lines": assigned("off", f"{reached[each.place]} - pose[{each.place}]", INDENT),
            "weight": each.weight,
        }
        for each in named_entries(module.chain)
    ]


def _allocates(module: SolverModule, common: Common) -> str:
    """Where memory is allocated."""
    if regular_solver(module) is None:
        return "at every pose"
    if module.solver.tightened is not None or common.standing.settles:
        return "only where a pose is singular or rounded"
    if common.searches.some:
        return "only where a free joint can't keep the seed's value"
    return "nowhere"


def _compiles_apart(common: Common, *, tightens: bool) -> bool:
    """Whether there are functions that few poses need."""
    rare = common.searches.some or common.standing.settles or tightens
    return rare or common.programs.solves_whole


def _no_pose(module: SolverModule) -> str:
    """What is wrong with a pose that is none."""
    task = module.chain.task
    what = "the arm angle" if module.chain.arm_angle else "the value of a free joint"
    free = f", or {what} not finite" if module.chain.given else ""
    if task.names_rotation:
        last = ", or its last row not 0, 0, 0, 1 (is it transposed?)"
        return f"not finite, or not a right-handed rotation to six digits{last}{free}"
    if task.kind is TaskKind.POINTING:
        return f"not finite, or its z axis not of length one to six digits{free}"
    return f"not finite{free}"


def _arctangent() -> dict[str, object]:
    """The constants of atan2 as text."""
    highest, *others = reversed(arctangent_coefficients())
    return {
        "steep": repr(STEEP),
        "polynomial": [
            f"p = {highest!r}",
            *(f"p = p * u {'-' if c < 0 else '+'} {abs(c)!r}" for c in others),
        ],
        "eighth": repr(math.pi / 4),
        "quarter": repr(math.pi / 2),
        "half": repr(math.pi),
    }
