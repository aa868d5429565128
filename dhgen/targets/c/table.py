"""The table of an arm that the runtime works on, as C writes it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.robot.task import TaskKind
from dhgen.targets.layout import INDENT, c_array, packed
from dhgen.targets.module import named_entries, slacks
from dhgen.targets.solver.searches import fan_steps, searches_of
from dhgen.targets.solver.settle import paces_of, settle_of
from dhgen.targets.solver.standing import standing_of
from dhgen.targets.walk import checks_again, choosable, lost_together

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class CTable:
    """Definitions.

    Attributes:
        joints: A row of numbers for each joint.
        places: Arrays of joints and of entries of a pose that the arm's table names.
        arm: What the arm's table holds, but for the function of regular poses.
    """

    joints: Sequence[str]
    places: Sequence[str]
    arm: Sequence[str]


@dataclass(frozen=True, slots=True)
class _Places:
    """An array that the arm's table names, and how many places it has."""

    name: str
    places: tuple[int, ...]

    @property
    def named(self) -> str:
        return f"{self.name if self.places else 'NULL'}, {len(self.places)}"

    @property
    def definition(self) -> str:
        return c_array(f"static const int {self.name}[{len(self.places)}]", map(str, self.places))


def c_table(module: SolverModule) -> CTable:
    """The table of a robot, but for its last entry: the function for regular poses."""
    chain, solver = module.chain, module.solver
    together = () if solver.tightened is not None else lost_together(solver)
    given = _Places("given_joints", tuple(number - 1 for number in chain.free))
    entries = _Places("entries", tuple(entry.place for entry in named_entries(chain)))
    choosing = _Places("choosable", tuple(joint - 1 for joint in choosable(solver)))
    choosing_together = _Places("together", tuple(joint - 1 for joint in together))
    arrays = (given, entries, choosing, choosing_together)
    weights = settle_of(module).miss_weights
    size = f"{chain.dof}, {solver.rows}, {chain.given}"
    return CTable(
        joints=_joints(module),
        places=[each.definition for each in arrays if each.places],
        arm=[
            f"{INDENT}{size}, {_task(module)}, joints, {given.named},",
            f"{INDENT}{{ {weights} }}, {1.0 / chain.size!r}, {entries.named},",
            *_policy(module, choosing.named, choosing_together.named),
            *_functions(module),
        ],
    )


def _policy(module: SolverModule, choosing: str, together: str) -> list[str]:
    """What has to be done around the formulas, each with its name."""
    searches, standing = searches_of(module), standing_of(module)
    flags = {
        "slides": not all(module.chain.turning),
        "retries": searches.chooses_again,
        "checks": checks_again(module.solver),
        "keeps limits": searches.keeps_limits,
    }
    others = {
        "merges": standing.tells_once,
        "refines": standing.leads,
        "clamps": standing.on_limits,
        "far": standing.far,
        "winds": standing.winds,
        "follows seed": standing.stays,
    }
    completes = module.solver.tightened is not None
    completion = "&completion, dhgen_complete_rows," if completes else "NULL, NULL,"
    return [
        *_flags(flags),
        f"{INDENT}{choosing}, {together}, {searches.cuts},",
        *_flags(others),
        f"{INDENT}{completion}",
    ]


def _functions(module: SolverModule) -> list[str]:
    """The robot's own."""
    names = (f"{module.name}_fk", f"{module.name}_jacobian", "solve")
    return packed([f"{name}," for name in names], INDENT)


def _flags(flags: dict[str, bool]) -> list[str]:
    return packed([f"{int(flag)}, /* {name} */" for name, flag in flags.items()], INDENT)


def _joints(module: SolverModule) -> list[str]:
    """A row for each joint."""
    chain = module.chain
    numbers = zip(slacks(module), module.weights, paces_of(chain), fan_steps(module), strict=True)
    rows = []
    for joint, turns, (slack, weight, pace, step) in zip(
        chain.joints, chain.turning, numbers, strict=True
    ):
        low, high = map(repr, joint.limits) if joint.limits else ("-HUGE_VAL", "HUGE_VAL")
        rows.append(f"{{ {low}, {high}, {slack!r}, {weight!r}, {pace}, {step!r}, {int(turns)} }},")
    return rows


def _task(module: SolverModule) -> str:
    """What of a pose is checked."""
    task = module.chain.task
    if task.kind is TaskKind.POSE:
        return "DHGEN_POSE"
    if task.kind is TaskKind.POINTING:
        return "DHGEN_POINTING"
    return "DHGEN_ROTATION" if task.names_rotation else "DHGEN_COORDINATES"
