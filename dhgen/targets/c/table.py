"""The table of an arm that the runtime works on, as C writes it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.kinematics.turns import coupled_turns, joints_alone
from dhgen.robot.task import Directions, TaskKind
from dhgen.targets.layout import INDENT, c_array, packed
from dhgen.targets.module import fan_steps, named_entries, slacks
from dhgen.targets.solver.refinement import miss_weights, paces_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.kinematics.chain import Chain
    from dhgen.program.policy import Policy
    from dhgen.targets.module import SolverModule


COUPLING, NO_COUPLING = "&coupling, dhgen_coupled_beyond,", "NULL, NULL,"


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
        return c_array(f"DHGEN_TABLE int {self.name}[{len(self.places)}]", map(str, self.places))


def c_table(module: SolverModule, *, has_functions: bool = True) -> CTable:
    """The table of a robot, but for its last entry: the function for regular poses.

    Args:
        module: The robot.
        has_functions: Whether it has forward kinematics and a Jacobian of its own.
    """
    chain, policy = module.chain, module.policy
    given = _Places("given_joints", tuple(number - 1 for number in chain.free))
    entries = _Places("entries", tuple(entry.place for entry in named_entries(chain)))
    choosing = _Places("choosable", policy.choosable)
    choosing_together = _Places("together", policy.together)
    arrays = (given, entries, choosing, choosing_together)
    weights = ", ".join(miss_weights(chain))
    clamped = f"{policy.clamped!r}, {policy.clamped_again!r}"
    size = f"{chain.dof}, {module.solver.rows}, {chain.given}"
    return CTable(
        joints=_joints(module),
        places=[each.definition for each in arrays if each.places],
        arm=[
            f"{INDENT}{size}, {_task(module)}, joints, {given.named},",
            f"{INDENT}{{ {weights} }}, {1.0 / chain.size!r}, {{ {clamped} }}, {entries.named},",
            *packed(
                [
                    *_steps(chain, policy, choosing.named, choosing_together.named),
                    NO_COUPLING if coupled_turns(chain) is None else COUPLING,
                    *_functions(module if has_functions else None),
                ],
                INDENT,
            ),
        ],
    )


def _steps(chain: Chain, policy: Policy, choosing: str, together: str) -> list[str]:
    """What has to be done around the formulas, each with its name."""
    searches = {
        "slides": not all(chain.turning),
        "retries": policy.retries,
        "checks": policy.checks,
        "keeps limits": policy.keeps_limits,
    }
    others = {
        "merges": policy.merges,
        "refines": policy.refines,
        "clamps": policy.clamps,
        "far": policy.clamps_far,
        "range exceeds a turn": policy.range_exceeds_a_turn,
        "follows seed": policy.follows_seed,
    }
    completion = "&completion, dhgen_complete_rows," if policy.completes else "NULL, NULL,"
    return [
        *_flags(searches),
        f"{choosing}, {together}, {policy.cuts},",
        *_flags(others),
        completion,
    ]


def _functions(module: SolverModule | None) -> list[str]:
    """The robot's own, where it has any."""
    own = ("NULL", "NULL") if module is None else (f"{module.name}_fk", f"{module.name}_jacobian")
    names = (*own, "solve")
    return [f"{name}," for name in names]


def _flags(flags: dict[str, bool]) -> list[str]:
    return [f"{int(flag)}, /* {name} */" for name, flag in flags.items()]


def _joints(module: SolverModule) -> list[str]:
    """A row for each joint."""
    chain = module.chain
    numbers = zip(slacks(module), module.weights, paces_of(chain), fan_steps(module), strict=True)
    alone = zip(joints_alone(chain), chain.turning, numbers, strict=True)
    rows = []
    for joint, turns, (slack, weight, pace, step) in alone:
        ends = c_ends(joint.limits)
        rows.append(f"{{ {ends}, {slack!r}, {weight!r}, {pace}, {step!r}, {int(turns)} }},")
    return rows


def c_ends(limits: tuple[float, float] | None) -> str:
    """The lowest and the highest value of a joint."""
    low, high = map(repr, limits) if limits else ("-HUGE_VAL", "HUGE_VAL")
    return f"{low}, {high}"


def _task(module: SolverModule) -> str:
    """What of a pose is checked."""
    task = module.chain.task
    return "DHGEN_POSE" if task.kind is TaskKind.POSE else c_directions(task.directions)


def c_directions(directions: Directions) -> str:
    """What counts of directions."""
    name = "coordinates" if directions is Directions.NONE else directions.value
    return f"DHGEN_{name.upper()}"
