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
from dhgen.targets.module import made_text
from dhgen.targets.python.literal import literal
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
    """What a module says of itself.

    Attributes:
        about: What it is.
        made: Where it comes from.
        frames: What poses are.
        no_pose: What is wrong with a pose that is none.
        no_row: What is wrong with a pose without solutions.
        allocates: Where memory is allocated.
    """

    about: str
    made: str
    frames: str
    no_pose: str
    no_row: str
    allocates: str


@dataclass(frozen=True, slots=True)
class PythonTables:
    """Constants of a module.

    Attributes:
        joint_names: A tuple with the name of each joint.
        limits: Of each joint.
        branch_names: The name of every row, as lines.
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
    limits: Sequence[str]
    branch_names: Sequence[str]
    free_joints: str
    links: str
    turned_together: Sequence[str]
    arm: Sequence[str]
    table_about: str
    table: str
    frames: Sequence[str]
    constants: Sequence[str]


@dataclass(frozen=True, slots=True)
class PythonPose:
    """How a pose is read.

    Attributes:
        entries: The names of its entries, _ for those that the solver does not read.
        task: What counts of it beside coordinates, as functions of the runtime are called.
        counted: Which coordinates it names.
    """

    entries: str
    task: str
    counted: str


def python_comments(module: SolverModule, flat: Flat | None) -> PythonComments:
    """What the module of a robot says of itself."""
    frames = (
        "Poses are 4 x 4 matrices of the tool in the base frame, lengths in "
        f"{module.length_unit}, angles in rad. {meaning(module.chain.task)}"
    )
    return PythonComments(
        about=paragraph(f"{module.name}: {plain(module.title).rstrip('.')}.", ""),
        made=made_text(module, "python/solver.py.jinja", ""),
        frames=paragraph(frames, ""),
        no_pose=_no_pose(module),
        no_row=_no_row(module),
        allocates=_allocates(flat),
    )


def _allocates(flat: Flat | None) -> str:
    """Where memory is allocated."""
    if flat is None:
        return "at every pose"
    return "only where a pose is singular or rounded"


def _no_pose(module: SolverModule) -> str:
    """What is wrong with a pose that is none."""
    task = module.chain.task
    what = "the arm angle" if module.chain.arm_angle else "the value of a free joint"
    free = f", or {what} not finite" if module.chain.given else ""
    sound = "not finite" if all(module.chain.turning) else "not finite or beyond 5e102"
    if task.names_rotation:
        last = ", or its last row not 0, 0, 0, 1 (is it transposed?)"
        return f"{sound}, or not a right-handed rotation to six digits{last}{free}"
    return f"{sound}{_NO_DIRECTION[task.directions]}{free}"


_NO_DIRECTION = {
    Directions.NONE: "",
    Directions.POINTING: ", or its z axis not of length one to six digits",
    Directions.YAW: "",
    Directions.PITCH: ", or T[2, 0], minus the sine of the pitch, beyond one",
    Directions.TILT: ", or T[2, 0:3] not of length one to six digits",
}


def _no_row(module: SolverModule) -> str:
    """Why a pose has no solution."""
    if not module.chain.overdetermined:
        return "the pose is out of reach"
    joints = module.chain.dof - len(module.chain.free)
    return f"the pose is out of reach, or one that {joints} joints can't take"


def python_tables(module: SolverModule, flat: Flat | None) -> PythonTables:
    """Constants of a robot, and of its program for regular poses, where there is one."""
    free, none = module.chain.free, "(-math.inf, math.inf)"
    limits = [joint.limits for joint in module.chain.joints]
    constants = constant_texts(module, () if flat is None else (flat.program,))
    return PythonTables(
        joint_names=_joint_names(module),
        limits=[f"({pair[0]!r}, {pair[1]!r})" if pair else none for pair in limits],
        branch_names=listed([f'"{text}"' for text in module.branches], INDENT),
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
    named: dict[str, object] = {"drives": table.drives} if table.drives else {}
    named |= {"base": table.base} if table.base != IDENTITY else {}
    named |= {"tool": table.tool} if table.tool != IDENTITY else {}
    types = "JOINT_TYPES" if table.types == module.chain.joint_types else f'"{table.types}"'
    return [
        f"{INDENT}types={types},",
        f"{INDENT}table={_table_name(module)},",
        f'{INDENT}convention="{table.convention}",',
        *(f"{INDENT}{name}={literal(value, {}, INDENT)}," for name, value in named.items()),
    ]


def _joint_names(module: SolverModule) -> str:
    names = [f'"{name}"' for name in module.chain.joint_names]
    line = f"({', '.join(names)}{',' * (len(names) == 1)})"
    if len(line) <= WIDTH - len("JOINT_NAMES = "):
        return line
    return "\n".join(["(", *listed(names, INDENT), ")"])


def constant_lines(constants: Sequence[ConstantText]) -> list[str]:
    """Definitions of constants, and what their formulas name beside them."""
    return [
        *packed(made_of(constants, []), "# "),
        *(line for each in constants for line in _constant(each)),
    ]


def _constant(constant: ConstantText) -> list[str]:
    bare, comment = f"{constant.name} = {constant.value}", constant.comment
    line = f"{bare}  # {comment}" if comment else bare
    return [line] if len(line) <= WIDTH else [f"# {paragraph(comment, '# ')}", bare]


def python_pose(module: SolverModule) -> PythonPose:
    """How a robot's pose is read."""
    task = module.chain.task
    counted = tuple(row in task.position_rows for row in range(3))
    return PythonPose(_entries(module.solver), _task(task), str(counted))


def _task(task: Task) -> str:
    """What counts of a pose beside coordinates."""
    if task.kind is TaskKind.POSE:
        return "pose"
    words = {Directions.ROTATION: "orientation", Directions.NONE: "position"}
    return words.get(task.directions, task.directions.value)


def _entries(program: Program) -> str:
    """The names of the pose's entries, _ for those that are not read."""
    read = {(entry.row, entry.column) for entry in pose_entries(program)}
    places = [(row, column) for row in (1, 2, 3) for column in (1, 2, 3, 4)]
    return ", ".join(f"T{place[0]}{place[1]}" if place in read else "_" for place in places)
