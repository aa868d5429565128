"""The files of a parallel robot in C and Python, beside its legs' chains' files."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.legs.robot import inverse
from dhgen.parallel.driven import driven
from dhgen.printing.comments import plain
from dhgen.printing.templates import render
from dhgen.robot.task import TaskKind
from dhgen.runtime.python import INTERFACE
from dhgen.status import Status
from dhgen.targets.c.files import INTERFACE as C_INTERFACE
from dhgen.targets.c.files import switch
from dhgen.targets.c.fitting import fitted
from dhgen.targets.c.runtime import in_one_file
from dhgen.targets.layout import INDENT, c_array, listed, paragraph
from dhgen.targets.module import origin_text, stamp
from dhgen.targets.python.single_file import in_one_file as python_in_one_file

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.legs.robot import Rows
    from dhgen.parallel.module import LegModule, ParallelModule
    from dhgen.robot.task import Task


@dataclass(frozen=True, slots=True)
class ParallelTexts:
    """The comments of the files.

    Attributes:
        about: What they are, in a comment of C.
        plain: The same elsewhere.
        made_h: Where the header comes from.
        made_c: Where the source comes from.
        made_python: Where the module comes from.
        frames_c: What poses are, in a comment of C.
        frames_python: The same in Python.
        velocities: The platform's freedoms.
        stamp: By what they were made, and of what.
    """

    about: str
    plain: str
    made_h: str
    made_c: str
    made_python: str
    frames_c: str
    frames_python: str
    velocities: str
    stamp: str


@dataclass(frozen=True, slots=True)
class ChainTexts:
    """What legs of one chain share in C.

    Attributes:
        name: Of their solver.
        upper: The same in capitals.
        tables: Definitions of what is driven and counted.
        names: The definition of their rows' names.
    """

    name: str
    upper: str
    tables: Sequence[str]
    names: str


@dataclass(frozen=True, slots=True)
class LegTexts:
    """A leg.

    Attributes:
        chain: The name of its solver.
        c: The lines of its table in C.
        base: The rows of the frame from the robot's base to its own, in Python.
        end: Those of what it carries.
    """

    chain: str
    c: Sequence[str]
    base: Sequence[str]
    end: Sequence[str]


def parallel_files(module: ParallelModule, *, single_file: bool = False) -> dict[str, str]:
    """The header, the source and the module by their names.

    Args:
        module: The robot.
        single_file: Whether C and Python hold what they need of the runtime.
    """
    values = _common(module)
    header = fitted(render("c/parallel.h.jinja", **values))
    source = fitted(render("c/parallel.c.jinja", **values, c=_c(module)))
    python = render("python/parallel.py.jinja", **values, python=_python(module))
    if single_file:
        source, python = in_one_file(source, vectors=True), python_in_one_file(python)
    return {f"{module.name}.h": header, f"{module.name}.c": source, f"{module.name}.py": python}


def _common(module: ParallelModule) -> dict[str, object]:
    drives = module.robot.drives
    distinct = {leg.solver.name: leg for leg in module.legs}
    return {
        "name": module.name,
        "upper": module.name.upper(),
        "count": len(module.legs),
        "joints": module.joints,
        "rows": module.rows,
        "drives": drives,
        "squares": drives * drives,
        "size": module.size,
        "task": module.robot.task.text,
        "assemblies": module.elimination.most if module.elimination else 0,
        "chains": [_chain(name, leg) for name, leg in distinct.items()],
        "legs": [_leg(leg) for leg in module.legs],
        "driven": driven(module),
        "status": {each.name: each.value for each in Status},
        "texts": _texts(module),
    }


def _texts(module: ParallelModule) -> ParallelTexts:
    about = f"{module.name}: {plain(module.robot.title)}"
    sources = " ".join(
        f"{name}.c" for name in (module.name, *(c.name for c in module.robot.chains))
    )
    legs = f"A platform on {len(module.legs)} legs, each of which is a serial arm"
    poses = f"lengths in {module.robot.length_unit}, angles in rad. {meaning(module.robot.task)}"
    matrices = "4 x 4 matrices of the platform in the base frame"
    in_c = f"{legs}: compile {sources} together. Poses are row-major {matrices}, {poses}"

    def made(template: str, indent: str) -> str:
        return origin_text(module.source, module.name, template, indent)

    return ParallelTexts(
        about=paragraph(about, " * "),
        plain=about,
        made_h=made("c/parallel.h.jinja", " * "),
        made_c=made("c/parallel.c.jinja", " * "),
        made_python=made("python/parallel.py.jinja", ""),
        frames_c=paragraph(in_c, " * "),
        frames_python=paragraph(f"{legs}. Poses are {matrices}, {poses}", ""),
        velocities=velocities(module),
        stamp=stamp(module.digest),
    )


def _chain(name: str, leg: LegModule) -> ChainTexts:
    types = leg.solver.chain.joint_types
    slides = [int(types[joint] == "P") for joint in leg.driven]
    head = f"static const char *const {name}_names[{leg.solver.solver.rows}]"
    return ChainTexts(
        name=name,
        upper=name.upper(),
        tables=[
            f"DHGEN_TABLE int {name}_driven[{len(leg.driven)}] = {{ {_whole(leg.driven)} }};",
            f"DHGEN_TABLE int {name}_slides[{len(slides)}] = {{ {_whole(slides)} }};",
            f"DHGEN_TABLE int {name}_counted[{len(leg.counted)}] = {{ {_whole(leg.counted)} }};",
        ],
        names=c_array(head, [f'"{branch}"' for branch in leg.solver.branches]),
    )


def _leg(leg: LegModule) -> LegTexts:
    return LegTexts(
        chain=leg.solver.name,
        c=_c_leg(leg),
        base=_python_frame(inverse(leg.leg.base)),
        end=_python_frame(leg.leg.end),
    )


def meaning(task: Task) -> str:
    """What counts of a platform's pose."""
    if task.kind is TaskKind.POSE:
        return "Every entry of a pose counts."
    names = {
        (0, 1): "its place in the plane of x and y",
        (0, 1, 2): "its place",
    }[task.position_rows]
    return f"Of a pose {names}{' and its yaw count' if task.angles else ' alone counts'}."


def velocities(module: ParallelModule) -> str:
    """The platform's freedoms, by name."""
    names = ("vx", "vy", "vz", "wx", "wy", "wz")
    return ", ".join(names[each] for each in module.freedoms)


def _c(module: ParallelModule) -> dict[str, object]:
    return {
        "interface": C_INTERFACE,
        "switches": [
            line for each in ("SCALAR", "LIBM") for line in switch(module.name.upper(), each)
        ],
        "header": "assemblies" if module.elimination else "direct",
        "task": _c_name(module.counts),
        "freedoms": _whole(module.freedoms),
        "is_alike": int(module.is_alike),
        "is_planar": int(module.is_planar),
        "elimination": _c_name(module.elimination) if module.elimination else "",
        "places": c_array(
            f"const int {module.name}_drives[{module.robot.drives}][2]",
            [
                f"{{ {number}, {joint} }}"
                for number, leg in enumerate(module.legs)
                for joint in leg.driven
            ],
        ),
    }


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
    return {
        "interface": INTERFACE,
        "task": module.counts,
        "is_planar": module.is_planar,
        "freedoms": module.freedoms,
        "elimination": module.elimination or "",
        "chains": ", ".join(f'"{leg.solver.name}"' for leg in module.legs),
        "places": tuple(
            (number, joint) for number, leg in enumerate(module.legs) for joint in leg.driven
        ),
        "counted": tuple(leg.counted for leg in module.legs),
    }


def _python_frame(frame: Rows) -> list[str]:
    rows = [frame[4 * i : 4 * i + 4] for i in range(3)]
    return [repr(list(row)) for row in rows] + ["[0.0, 0.0, 0.0, 1.0]"]


def _c_name(words: str) -> str:
    """What the runtime in C calls what that in Python has as words."""
    return f"DHGEN_{words.upper().replace(' ', '_')}"


def _whole(numbers: Iterable[int]) -> str:
    return ", ".join(map(str, numbers))
