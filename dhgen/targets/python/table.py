"""The table of an arm that the runtime works on, as Python writes it."""

from __future__ import annotations

from dataclasses import fields
from typing import TYPE_CHECKING

from dhgen.kinematics.turns import coupled_turns, joints_alone, turns_alone
from dhgen.runtime.python.arm import OF_ANGLES, Arm
from dhgen.targets.coupled import NO_LIMITS
from dhgen.targets.layout import INDENT
from dhgen.targets.module import fan_steps, named_entries, slacks
from dhgen.targets.python.literal import Name, fields_of
from dhgen.targets.solver.refinement import miss_weights, paces_of

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.program.policy import Policy
    from dhgen.targets.module import SolverModule

# Facts of the joints that the module has under names of its own.
NAMED = {"types": Name("JOINT_TYPES"), "limits": Name("JOINT_LIMITS")}


def arm_lines(module: SolverModule) -> list[str]:
    """The definition of a robot's table, as lines."""
    links = module.solver.completion is not None
    numbers = [")", *[" _joints.arm_numbers(_LINKS)"] * links]
    numbers += [" coupling=_COUPLING"] * (coupled_turns(module.chain) is not None)
    fields = arm_fields(module, INDENT)
    return ["_ARM = _arms.arm_numbers(_arms.Arm(", *fields, f"{','.join(numbers)})"]


def arm_fields(module: SolverModule, indent: str) -> list[str]:
    """The fields of a robot's table that are not what they are without being named."""
    arm = _arm(module)
    named = NAMED if turns_alone(module.chain) else {"types": NAMED["types"]}
    values = ((each.name, getattr(arm, each.name), each.default) for each in fields(arm))
    others = [(name, named.get(name, value)) for name, value, default in values if value != default]
    return fields_of(others, {}, indent)


def _arm(module: SolverModule) -> Arm:
    chain, policy = module.chain, module.policy
    measures = policy.checks or policy.completes
    return Arm(
        types=chain.joint_types,
        limits=tuple(joint.limits or NO_LIMITS for joint in joints_alone(chain)),
        rows=module.solver.rows,
        directions=chain.task.directions.value,
        miss_weights=tuple(map(float, miss_weights(chain))),
        size=chain.size,
        slacks=_column(slacks(module), OF_ANGLES[0]),
        weights=_column(module.weights, OF_ANGLES[1]),
        paces=_column(map(float, paces_of(chain)), OF_ANGLES[2]),
        fan_steps=_column(fan_steps(module) if policy.chooses else (), OF_ANGLES[3]),
        clamped=policy.clamped,
        clamped_again=policy.clamped_again,
        entries=tuple(e.place for e in named_entries(chain)) if measures else (),
        steps=_steps(policy),
        given=tuple(number - 1 for number in chain.free),
        choosable=policy.choosable if policy.chooses else (),
        together=policy.together if policy.retries else (),
        root_turns=tuple((joint - 1, float(sign)) for joint, sign in policy.root_turns),
        cuts=policy.cuts,
    )


def _column(values: Iterable[float], usual: float) -> tuple[float, ...]:
    """A number of every joint, none where all are what they usually are."""
    column = tuple(values)
    return () if all(each == usual for each in column) else column


def _steps(policy: Policy) -> tuple[str, ...]:
    """What has to be done around the formulas."""
    steps = {
        "retries": policy.retries,
        "checks": policy.retries and policy.checks,
        "keeps limits": policy.keeps_limits,
        "completes": policy.completes,
        "adds others": policy.adds_others,
        "ascends": policy.completes and policy.ascends,
        "equations end all": policy.completes and policy.equations_end_all,
        "merges": policy.merges,
        "refines": policy.refines,
        "clamps": policy.clamps,
        "clamps far": policy.clamps_far,
        "range exceeds a turn": policy.range_exceeds_a_turn,
        "follows seed": policy.follows_seed,
    }
    return tuple(step for step, taken in steps.items() if taken)
