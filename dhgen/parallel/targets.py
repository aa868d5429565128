"""The files of a parallel robot in C and Python, beside those of its legs' chains."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen import __version__
from dhgen.parallel.module import Elimination
from dhgen.printing.comments import plain
from dhgen.printing.templates import render
from dhgen.robot.task import Directions, TaskKind
from dhgen.runtime.python import INTERFACE
from dhgen.status import Status
from dhgen.targets.c.files import INTERFACE as C_INTERFACE
from dhgen.targets.c.fitting import fitted
from dhgen.targets.c.runtime import in_one_file
from dhgen.targets.layout import INDENT, c_array, listed, paragraph
from dhgen.targets.module import origin_text
from dhgen.targets.python.single_file import in_one_file as python_in_one_file

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.parallel.module import LegModule, ParallelModule
    from dhgen.parallel.robot import Rows
    from dhgen.robot.task import Task

C_TASKS = {Directions.ROTATION: "DHGEN_POSE", Directions.YAW: "DHGEN_YAW"}
PYTHON_TASKS = {Directions.ROTATION: "pose", Directions.YAW: "yaw"}
NO_TURNS = "DHGEN_COORDINATES", "coordinates"
C_ELIMINATIONS = {
    Elimination.TWO_CIRCLES: "DHGEN_TWO_CIRCLES",
    Elimination.THREE_CIRCLES: "DHGEN_THREE_CIRCLES",
    Elimination.THREE_SPHERES: "DHGEN_THREE_SPHERES",
}
MOST = {
    Elimination.TWO_CIRCLES: 2,
    Elimination.THREE_CIRCLES: 6,
    Elimination.THREE_SPHERES: 2,
}
"""How many assemblies there are at most."""


def parallel_files(module: ParallelModule, *, single_file: bool = False) -> dict[str, str]:
    """The header, the source and the module by their names.

    Args:
        module: The robot.
        single_file: Whether C and Python hold what they need of the runtime.
    """
    values = _common(module)
    header = fitted(render("c/parallel.h.jinja", **values))
    source = fitted(render("c/parallel.c.jinja", **values, **_c(module)))
    python = render("python/parallel.py.jinja", **values, **_python(module))
    if single_file:
        source, python = in_one_file(source, vectors=True), python_in_one_file(python)
    return {f"{module.name}.h": header, f"{module.name}.c": source, f"{module.name}.py": python}


def _common(module: ParallelModule) -> dict[str, object]:
    legs = module.legs
    names = tuple(dict.fromkeys(leg.solver.name for leg in legs))
    return {
        "module": module,
        "upper": module.name.upper(),
        "drives": module.robot.drives,
        "legs": legs,
        "chains": names,
        "status": {each.name: each.value for each in Status},
        "length_unit": module.robot.length_unit,
        "about": f"{module.name}: {plain(module.robot.title)}",
        "meaning": meaning(module.robot.task),
        "velocities": velocities(module),
        "assemblies": MOST[module.elimination] if module.elimination else 0,
        "stamp": f"dhgen {__version__}; SHA-256 of the robot file: {module.digest}",
        "sources": " ".join(f"{name}.c" for name in (module.name, *names)),
        "paragraph": paragraph,
        "origin": lambda template, indent: origin_text(
            module.source, module.name, template, indent
        ),
    }


def meaning(task: Task) -> str:
    """What counts of a platform's pose."""
    if task.kind is TaskKind.POSE:
        return "Every entry of a pose counts."
    told = {
        (0, 1): "its place in the plane of x and y",
        (0, 1, 2): "its place",
    }[task.position_rows]
    return f"Of a pose {told}{' and its yaw count' if task.angles else ' alone counts'}."


def velocities(module: ParallelModule) -> str:
    """The platform's freedoms, by name."""
    names = ("vx", "vy", "vz", "wx", "wy", "wz")
    return ", ".join(names[each] for each in module.freedoms)


def _c(module: ParallelModule) -> dict[str, object]:
    task = module.robot.task.directions
    distinct = {leg.solver.name: leg for leg in module.legs}
    return {
        "interface": C_INTERFACE,
        "task": C_TASKS.get(task, NO_TURNS[0]),
        "freedoms": _whole(module.freedoms),
        "elimination": C_ELIMINATIONS[module.elimination] if module.elimination else "",
        "tables": [_tables(name, leg) for name, leg in distinct.items()],
        "rows_of": [_c_leg(leg) for leg in module.legs],
        "names": [
            c_array(
                f"static const char *const {name}_names[{leg.solver.solver.rows}]",
                [f'"{branch}"' for branch in leg.solver.branches],
            )
            for name, leg in distinct.items()
        ],
        "places": c_array(
            f"const int {module.name}_drives[{module.robot.drives}][2]",
            [
                f"{{ {number}, {joint} }}"
                for number, leg in enumerate(module.legs)
                for joint in leg.driven
            ],
        ),
    }


def _tables(name: str, leg: LegModule) -> list[str]:
    """What legs of one chain share."""
    types = leg.solver.chain.joint_types
    slides = [int(types[joint] == "P") for joint in leg.driven]
    return [
        f"static const int {name}_driven[{len(leg.driven)}] = {{ {_whole(leg.driven)} }};",
        f"static const int {name}_slides[{len(slides)}] = {{ {_whole(slides)} }};",
        f"static const int {name}_counted[{len(leg.counted)}] = {{ {_whole(leg.counted)} }};",
    ]


def _c_leg(leg: LegModule) -> list[str]:
    solver = leg.solver
    name, chain = solver.name, solver.chain
    head = f"{chain.dof}, {solver.solver.rows}, {len(leg.driven)}, "
    tables = f'{name}_driven, {name}_slides, "{chain.joint_types}", {name}_counted,'
    functions = f"{name}_rows, {name}_ik_nearest, {name}_ik_batch, {name}_fk, {name}_jacobian"
    base, end = (
        ["{", *listed([repr(entry) for entry in frame], INDENT), "},"]
        for frame in (inverse(leg.leg.base), leg.leg.end)
    )
    return [head + tables, *base, *end, functions]


def _python(module: ParallelModule) -> dict[str, object]:
    task = module.robot.task.directions
    return {
        "interface": INTERFACE,
        "task": PYTHON_TASKS.get(task, NO_TURNS[1]),
        "elimination": module.elimination or "",
        "frames": [
            (_python_frame(inverse(leg.leg.base)), _python_frame(leg.leg.end))
            for leg in module.legs
        ],
        "places": [
            (number, joint) for number, leg in enumerate(module.legs) for joint in leg.driven
        ],
    }


def _python_frame(frame: Rows) -> list[str]:
    rows = [frame[4 * i : 4 * i + 4] for i in range(3)]
    return [repr(list(row)) for row in rows] + ["[0.0, 0.0, 0.0, 1.0]"]


def inverse(frame: Rows) -> Rows:
    """The inverse of a frame; no entry is a negative zero."""
    entries: list[float] = []
    for i in range(3):
        column = [frame[4 * k + i] for k in range(3)]
        entries += [*column, -sum(column[k] * frame[4 * k + 3] for k in range(3))]
    return tuple(entry + 0.0 for entry in entries)


def _whole(numbers: Iterable[int]) -> str:
    return ", ".join(map(str, numbers))
