"""Comments, tables and checks of a Python module as its templates name them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.kinematics.link_table import AXES
from dhgen.printing.comments import plain
from dhgen.robot.task import Directions, TaskKind
from dhgen.runtime.python.frames import IDENTITY
from dhgen.targets.constants import constant_texts, made_of
from dhgen.targets.coupled import coupling_fields
from dhgen.targets.layout import INDENT, WIDTH, listed, packed, paragraph
from dhgen.targets.module import made_text, stamp
from dhgen.targets.python.literal import Name, fields_of
from dhgen.targets.python.table import arm_lines
from dhgen.targets.python.whole import python_links
from dhgen.targets.scalar import pose_entries
from dhgen.targets.solver.links import about_table
from dhgen.targets.solver.task import meaning

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.program.ir import Program
    from dhgen.program.regular.flatten import Flat
    from dhgen.robot.task import Task
    from dhgen.targets.constants import ConstantText
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class PythonComments:
    """The docstring and comments of a module.

    Attributes:
        about: What it is.
        made: Where it comes from.
        stamp: By what it was made, and of what.
        frames: What poses are.
    """

    about: str
    made: str
    stamp: str
    frames: str


@dataclass(frozen=True, slots=True)
class PythonTables:
    """Constants of a module.

    Attributes:
        joint_names: A tuple with the name of each joint.
        limits: Of each joint.
        branch_names: The name of every row.
        free_joints: Whose values the caller gives; empty without any.
        links: The arm as descents work on it; empty where none do.
        turned_together: Fields of what is chosen together of its drives; empty without.
        arm: What the arm's table in the runtime is made of.
        table_about: What the rows of the table of links are.
        table: Its definition.
        frames: What their frames are computed from, as lines.
        constants: Of the programs, as lines.
    """

    joint_names: str
    limits: str
    branch_names: str
    free_joints: str
    links: str
    turned_together: Sequence[str]
    arm: Sequence[str]
    table_about: str
    table: str
    frames: Sequence[str]
    constants: Sequence[str]


def python_comments(module: SolverModule) -> PythonComments:
    """The docstring and comments of a robot's module."""
    frames = (
        "Poses are 4 x 4 matrices of the tool in the base frame, lengths in "
        f"{module.length_unit}, angles in rad. {meaning(module.chain.task)}"
    )
    return PythonComments(
        about=paragraph(f"{module.name}: {plain(module.title).rstrip('.')}.", ""),
        made=made_text(module, "python/solver.py.jinja", ""),
        stamp=stamp(module.digest),
        frames=paragraph(frames, ""),
    )


def python_tables(module: SolverModule, flat: Flat | None) -> PythonTables:
    """Constants of a robot, and of its program for regular poses, where there is one."""
    free, none = module.chain.free, "(-math.inf, math.inf)"
    limits = [joint.limits for joint in module.chain.joints]
    constants = constant_texts(module, () if flat is None else (flat.program,))
    return PythonTables(
        joint_names=_tuple("JOINT_NAMES", [f'"{name}"' for name in module.chain.joint_names]),
        limits=_tuple("JOINT_LIMITS", [repr(pair) if pair else none for pair in limits]),
        branch_names=_tuple("BRANCHES", [f'"{text}"' for text in module.branches]),
        free_joints=f"({', '.join(map(str, free))},)" if free else "",
        links=python_links(module.solver),
        turned_together=coupling_fields(module),
        arm=arm_lines(module),
        table_about=about_table(module, "# "),
        table="\n".join(
            [f"{_table_name(module)} = (", *(f"{INDENT}{row!r}," for row in module.links.rows), ")"]
        ),
        frames=_frames(module),
        constants=constant_lines(constants),
    )


def _table_name(module: SolverModule) -> str:
    return "AXES" if module.links.convention == AXES else "TABLE"


def _frames(module: SolverModule) -> list[str]:
    """What the frames of the links are computed from."""
    table = module.links
    types = table.types if table.types != module.chain.joint_types else Name("JOINT_TYPES")
    named = {
        "types": types,
        "table": Name(_table_name(module)),
        "convention": table.convention,
        "drives": table.drives,
        "base": table.base,
        "tool": table.tool,
    }
    return fields_of(
        [(name, value) for name, value in named.items() if value and value != IDENTITY], {}, INDENT
    )


def _tuple(name: str, entries: Sequence[str]) -> str:
    """The value of a name, in as many lines as it takes."""
    line = f"({', '.join(entries)}{',' * (len(entries) == 1)})"
    if len(f"{name} = {line}") <= WIDTH:
        return line
    return "\n".join(["(", *listed(entries, INDENT), ")"])


def constant_lines(constants: Sequence[ConstantText]) -> list[str]:
    """Definitions of constants, and what else their formulas name."""
    return [
        *packed(made_of(constants, []), "# "),
        *(line for each in constants for line in _constant(each)),
    ]


def _constant(constant: ConstantText) -> list[str]:
    bare, comment = f"{constant.name} = {constant.value}", constant.comment
    line = f"{bare}  # {comment}" if comment else bare
    return [line] if len(line) <= WIDTH else [f"# {paragraph(comment, '# ')}", bare]


def python_task(task: Task) -> str:
    """What counts of a pose besides coordinates, as functions of the runtime are called."""
    if task.kind is TaskKind.POSE:
        return "pose"
    words = {Directions.ROTATION: "orientation", Directions.NONE: "position"}
    return words.get(task.directions, task.directions.value)


def python_entries(program: Program) -> str:
    """The names of the pose's entries, _ for entries that are not read."""
    read = {(entry.row, entry.column) for entry in pose_entries(program)}
    places = [(row, column) for row in (1, 2, 3) for column in (1, 2, 3, 4)]
    return ", ".join(f"T{place[0]}{place[1]}" if place in read else "_" for place in places)
