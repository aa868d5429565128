"""What the code targets print: the programs of a robot and the facts around them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.paul.branches import branch_labels
from dhgen.program.ir import Apply, Guard, Joint, Let
from dhgen.program.tolerances import TOLERANCES
from dhgen.robot.robot import JointKind, TaskKind
from dhgen.targets.scalar import merged_constants

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.kinematics.chain import Chain
    from dhgen.program.ir import Expression, NamedConstant, Program


@dataclass(frozen=True, slots=True)
class SolverModule:
    """A robot's programs, ready to be printed in any language.

    Attributes:
        name: The robot's identifier.
        title: What a person calls it.
        source: Path of the robot file as it stands in the emitted header, relative.
        chain: The arm.
        solver: From pose to rows of joint values.
        forward: From joint values to the pose.
        jacobian: From joint values to the geometric Jacobian.
        length_unit: How lengths are called.
    """

    name: str
    title: str
    source: str
    chain: Chain
    solver: Program
    forward: Program
    jacobian: Program
    length_unit: str

    @property
    def branches(self) -> tuple[str, ...]:
        """The name of every row."""
        return branch_labels(tuple(axis.meaning for axis in self.solver.axes))


def module_values(module: SolverModule) -> dict[str, object]:
    """What the templates of every language name."""
    chain = module.chain
    kind = chain.task.kind
    programs = (module.solver, module.forward, module.jacobian)
    limits = [joint.limits for joint in chain.joints]
    return {
        "name": module.name,
        "upper": module.name.upper(),
        "title": _plain(module.title),
        "source": module.source,
        "dof": chain.dof,
        "rows": module.solver.rows,
        "branches": module.branches,
        "branch_list": ", ".join(module.branches),
        "task": _task_text(kind, chain.task.coordinates),
        "unit": module.length_unit,
        "constants": [_constant(constant) for constant in merged_constants(*programs)],
        "joint_types": joint_types(module),
        "has_slides": not all(_turns(joint.kind) for joint in chain.joints),
        "has_turns": any(_turns(joint.kind) for joint in chain.joints),
        "low": [repr(limit[0]) if limit else "-inf" for limit in limits],
        "high": [repr(limit[1]) if limit else "inf" for limit in limits],
        "weights": [repr(1.0 if _turns(j.kind) else 1.0 / chain.size**2) for j in chain.joints],
        "free": chain.free,
        "free_count": len(chain.free),
        "uses_wrap": any(_uses(program, "wrap") for program in programs),
        "uses_seed": _reads(module.solver, "seed"),
        "forward_uses_q": _reads(module.forward, "q"),
        "jacobian_uses_q": _reads(module.jacobian, "q"),
        "chooses_again": any(
            isinstance(statement, Guard) and statement.chosen and statement.margin is not None
            for statement in module.solver.body
        ),
        "checks_position": kind is not TaskKind.ORIENTATION,
        "checks_rotation": kind in {TaskKind.POSE, TaskKind.ORIENTATION},
        "checks_approach": kind is TaskKind.POINTING,
        "checks_last_row": kind is TaskKind.POSE,
        "position_entries": _position_entries(kind, chain.task.coordinates),
        "tolerances": TOLERANCES,
        "turn": repr(2.0 * math.pi),
    }


def joint_types(module: SolverModule) -> str:
    """R or P for every joint."""
    return "".join("R" if _turns(joint.kind) else "P" for joint in module.chain.joints)


def _turns(kind: JointKind) -> bool:
    return kind is JointKind.REVOLUTE


def _plain(text: str) -> str:
    """Free text that cannot end a comment or a docstring."""
    return text.replace("*/", "* /").replace("/*", "/ *").replace('"""', "'''").replace("\\", "/")


def _constant(constant: NamedConstant) -> tuple[str, str, str]:
    return constant.name, repr(constant.value), _plain(constant.meaning)


def _position_entries(kind: TaskKind, coordinates: tuple[str, ...]) -> list[int]:
    """Rows, from 0, of the translation that the task names."""
    if kind is TaskKind.ORIENTATION:
        return []
    if kind is TaskKind.COORDINATES:
        return ["xyz".index(name) for name in coordinates]
    return [0, 1, 2]


def _task_text(kind: TaskKind, coordinates: tuple[str, ...]) -> str:
    texts = {
        TaskKind.POSE: "the whole pose",
        TaskKind.POSITION: "the position T[0:3, 3]",
        TaskKind.ORIENTATION: "the orientation T[0:3, 0:3]",
        TaskKind.POINTING: "the position T[0:3, 3] and the tool's z axis T[0:3, 2]",
    }
    return texts.get(kind, f"the coordinates {', '.join(coordinates)} of the position")


def _expressions(program: Program) -> Iterator[Expression]:
    pending: list[Expression] = list(program.outputs)
    for statement in program.body:
        if isinstance(statement, Let):
            pending.append(statement.expression)
        elif isinstance(statement, Guard):
            pending.append(statement.condition)
    while pending:
        expression = pending.pop()
        yield expression
        if isinstance(expression, Apply):
            pending += expression.operands


def _uses(program: Program, operator: str) -> bool:
    return any(isinstance(e, Apply) and e.operator == operator for e in _expressions(program))


def _reads(program: Program, role: str) -> bool:
    return any(isinstance(e, Joint) and e.role == role for e in _expressions(program))
