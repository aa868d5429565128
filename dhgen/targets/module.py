"""What the code targets print: the programs of a robot and the facts around them."""

from __future__ import annotations

import math
import shlex
from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import POSE_PLACES
from dhgen.paul.branches import branch_labels
from dhgen.paul.problem import telling_entries
from dhgen.program.circle import DIRECTIONS, NEWTON_STEPS
from dhgen.program.limits import Limits
from dhgen.program.regular import regular
from dhgen.program.tolerances import DOUBLE, Precision
from dhgen.robot.robot import JointKind
from dhgen.robot.task import TaskKind
from dhgen.status import Status
from dhgen.targets.comments import plain, plain_path
from dhgen.targets.layout import paragraph
from dhgen.targets.standing import settles, standing, stands_on_limits, winds
from dhgen.targets.walk import (
    checks_again,
    choosable,
    chooses_again,
    finds_roots,
    reads,
    uses,
    whole_arm,
)

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.kinematics.chain import Chain
    from dhgen.method import Method
    from dhgen.program.ir import Program
    from dhgen.program.unguarded import Regular


LAST = 3  # column of a pose: its translation
FAN = 64  # values of a free joint that are tried first
LEAST_MOVE = 1e-15  # of a joint that is nearly free [rad]
MOST_MOVE = 0.1
HALVINGS = 52  # until an interval of a turn is as small as rounding
GOLDEN_CUTS = 72  # the same by golden section, which leaves 0.62 of it
ELSEWHERE = 0.1  # how far a joint is moved to see which others move with it [rad or length]


@dataclass(frozen=True, slots=True)
class SolverModule:
    """A robot's programs, ready to be printed in any language.

    Attributes:
        name: The robot's identifier, and the suffix of the precision.
        title: What a person calls it.
        source: How the robot file is called, relative; may hold any character.
        chain: The arm.
        method: How it is solved.
        solver: From pose to rows of joint values.
        forward: From joint values to the pose.
        jacobian: From joint values to the geometric Jacobian.
        length_unit: How lengths are called.
        arm_angle: From joint values to the arm angle, where the caller gives that.
        precision: The arithmetic that the programs are for; its suffix ends `name`.
    """

    name: str
    title: str
    source: str
    chain: Chain
    method: Method
    solver: Program
    forward: Program
    jacobian: Program
    length_unit: str
    arm_angle: Program | None = None
    precision: Precision = DOUBLE

    @property
    def robot(self) -> str:
        """The robot's identifier."""
        return self.name.removesuffix(self.precision.suffix)

    @property
    def branches(self) -> tuple[str, ...]:
        """The name of every row."""
        return branch_labels(tuple(axis.meaning for axis in self.solver.axes))

    @property
    def joint_types(self) -> str:
        """R or P for every joint."""
        turning = JointKind.REVOLUTE
        return "".join("R" if joint.kind is turning else "P" for joint in self.chain.joints)

    @property
    def programs(self) -> tuple[Program, ...]:
        """All programs."""
        others = () if self.arm_angle is None else (self.arm_angle,)
        return self.solver, self.forward, self.jacobian, *others

    @property
    def weights(self) -> tuple[float, ...]:
        """What squared differences of joint values count: lengths in arm sizes."""
        slide = 1.0 / self.chain.size**2
        return tuple(1.0 if kind == "R" else slide for kind in self.joint_types)

    @property
    def fan_steps(self) -> tuple[float, ...]:
        """From one value of a free joint that is tried to the next: half a fan is enough.

        Angles are tried in a whole turn, slides to both sides as far as their stroke, or where that
        is endless as in a turn of the arm.
        """
        lengths = (
            joint.limits[1] - joint.limits[0] if joint.limits else math.pi * self.chain.size
            for joint in self.chain.joints
        )
        return tuple(
            2.0 * (math.pi if kind == "R" else length) / FAN
            for kind, length in zip(self.joint_types, lengths, strict=True)
        )


def module_values(module: SolverModule) -> dict[str, object]:
    """What the templates of every language name."""
    chain = module.chain
    task = chain.task
    return {
        "name": module.name,
        "upper": module.name.upper(),
        "title": plain(module.title),
        "dof": chain.dof,
        "rows": module.solver.rows,
        "task": _task_text(module),
        "unit": module.length_unit,
        "joint_types": module.joint_types,
        "has_slides": "P" in module.joint_types,
        "has_turns": "R" in module.joint_types,
        "free_count": chain.given,
        "gives_one": chain.given == 1,
        "given_text": _given_text(chain),
        "given_sentence": _given_text(chain)[0].upper() + _given_text(chain)[1:],
        "given_comment": _given_comment(chain),
        "given_fault": "the arm angle" if chain.arm_angle else "a free joint's value",
        "method": module.method,
        "status": Status,
        "solves_whole": whole_arm(module.solver) is not None,
        "compiles_apart": _compiles_apart(module),
        "uses_circle": finds_roots(module.solver),
        "unmoved": ", 0.0" if finds_roots(module.solver) else "",
        "circle": {"newton_steps": NEWTON_STEPS, "directions": DIRECTIONS},
        "uses_wrap": any(uses(program, "wrap") for program in module.programs),
        "uses_seed": reads(module.solver, "seed"),
        "forward_uses_q": reads(module.forward, "q"),
        "jacobian_uses_q": reads(module.jacobian, "q"),
        "checks_again": checks_again(module.solver),
        "measures_miss": checks_again(module.solver) or module.solver.tightened is not None,
        "checks_directions": task.names_direction,
        "checks_rotation": task.names_rotation,
        "checks_approach": task.kind is TaskKind.POINTING,
        "checks_last_row": task.kind is TaskKind.POSE,
        "tolerances": module.precision.tolerances,
        "turn": repr(2.0 * math.pi),
        **_searches(module),
        **standing(module),
    }


def has_to_be_finite(module: SolverModule, entries: Iterable[str]) -> list[str]:
    """What is finite where entries of the pose and given values serve.

    A slide follows the pose wherever it is; then sums of squares have to be finite, too, and are
    where cubes are.
    """
    slides = "P" in module.joint_types
    return [" * ".join([each] * 3) if slides else each for each in entries]


def _searches(module: SolverModule) -> dict[str, object]:
    """What looks for other values of free joints, and its constants."""
    again, within = chooses_again(module.solver), keeps_limits(module)
    tolerances = module.precision.tolerances
    return {
        "searches": searches(module),
        "chooses_again": again,
        "keeps_limits": within,
        "measures_limits": within or stands_on_limits(module),
        # by how much a row is beyond; where limits are wide only searches ask for it
        "sums_limits": (
            within or not winds(module) or bool(module.solver.tightened) or tolerances.blur_limits
        ),
        "both_searches": again and within,
        "searches_slides": searches(module) and "P" in module.joint_types,
        "choosable": ", ".join(str(joint - 1) for joint in choosable(module.solver)),
        "choices": len(choosable(module.solver)),
        "turn_step": repr(2.0 * math.pi / FAN),
        "half_fan": FAN // 2,
        "least_move": LEAST_MOVE,
        "most_move": MOST_MOVE,
        "halvings": HALVINGS,
        "cuts": GOLDEN_CUTS if checks_again(module.solver) else HALVINGS,
        # what rounding does to joint values [rad or length]: how near branches that meet end a
        # search, what has not moved, and two distances from the seed that it alone tells apart
        "rounding": tolerances.limit,
        "met": tolerances.told,
        "elsewhere": ELSEWHERE,
    }


def keeps_limits(module: SolverModule) -> bool:
    """Whether a joint that may be free can keep others, or itself, inside limits."""
    limited = any(joint.limits for joint in module.chain.joints)
    return limited and bool(choosable(module.solver))


def searches(module: SolverModule) -> bool:
    """Whether other values than the seed's are looked for where a joint is free."""
    return chooses_again(module.solver) or keeps_limits(module)


def _compiles_apart(module: SolverModule) -> bool:
    """Whether there are functions that few poses need."""
    solver = module.solver
    rare = searches(module) or settles(module) or solver.tightened is not None
    return rare or whole_arm(solver) is not None


@dataclass(frozen=True, slots=True)
class NamedEntry:
    """An entry of the pose by which it is told whether a row fits.

    Attributes:
        place: In sixteen numbers, row by row.
        weight: Of its miss: lengths count in arm sizes.
    """

    place: int
    weight: str


def named_entries(chain: Chain) -> list[NamedEntry]:
    """Those of the task, in order."""
    places = (POSE_PLACES[name] for name in sorted(telling_entries(chain.task)))
    size = repr(1.0 / chain.size)
    return [
        NamedEntry(4 * row + column, size if column == LAST else "1.0") for row, column in places
    ]


def made_text(module: SolverModule, template: str, indent: str) -> str:
    """Where a file comes from; the lines after the first are indented."""
    source = plain_path(module.source)
    made = f"Inverse kinematics, generated from {source} and templates/{template}."
    # a path that can't be written here is for nobody to type from here
    command = shlex.join(["dhgen", source]) if source == module.source else "dhgen on that file"
    mended = f"Do not edit: run {command}."
    told = f"The formulas and where they come from: {module.robot}.md."
    return f"\n{indent}".join([paragraph(made, indent), paragraph(f"{mended} {told}", indent)])


def _given_text(chain: Chain) -> str:
    """What the caller gives besides the pose."""
    if chain.arm_angle:
        return "the arm angle [rad]"
    return f"values of the joints {', '.join(map(str, chain.free))}"


def _given_comment(chain: Chain) -> str:
    """The same in the C header."""
    if chain.arm_angle:
        return "the arm angle, which the caller gives [rad]"
    return f"free joints, whose values the caller gives: {', '.join(map(str, chain.free))}"


def _task_text(module: SolverModule) -> str:
    task = module.chain.task
    match task.kind:
        case TaskKind.POSE:
            return "Every entry of a pose counts."
        case TaskKind.POSITION:
            meant = "the position T[0:3, 3]"
        case TaskKind.ORIENTATION:
            meant = "the orientation T[0:3, 0:3]"
        case TaskKind.POINTING:
            meant = "the position T[0:3, 3] and the tool's z axis T[0:3, 2]"
        case TaskKind.COORDINATES:
            places = zip(task.coordinates, task.position_rows, strict=True)
            meant = " and ".join(f"{name} = T[{row}, 3]" for name, row in places)
    return f"Of a pose, {meant} counts; other entries are ignored."


def regular_solver(module: SolverModule) -> Regular | None:
    """The program of regular poses, with limits."""
    return regular(module.solver, tuple(_limits(module)), module.precision.tolerances)


def _limits(module: SolverModule) -> list[Limits | None]:
    slack = module.precision.tolerances.limit
    return [
        Limits(joint.limits[0] - slack, joint.limits[1] + slack, kind == "R")
        if joint.limits
        else None
        for joint, kind in zip(module.chain.joints, module.joint_types, strict=True)
    ]
