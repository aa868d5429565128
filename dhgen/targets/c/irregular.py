"""C that computes how far a pose is from an orthonormal, right-handed, finite one."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.robot.task import Directions, TaskKind
from dhgen.targets.module import has_to_be_finite

if TYPE_CHECKING:
    from dhgen.targets.module import SolverModule


def irregularity_wide(module: SolverModule) -> str:
    """The sum of squares in lanes of poses; NaN if one is not finite."""
    return _sum(_misfits(module, "_wide"), finite_entries(module) + finite_given(module))


def irregularity_four(module: SolverModule) -> str:
    """The irregularity of one pose, its columns in lanes where all of a rotation counts."""
    given, task = finite_given(module), module.chain.task
    if task.kind is TaskKind.POSE:
        return _sum(["dhgen_pose_misfit_four(T)"], given)
    if task.names_rotation:
        return _sum(["dhgen_misfit_four(T)"], given)
    return f"dhgen_all_four({_sum(_misfits(module, ''), finite_entries(module) + given)})"


def finite_entries(module: SolverModule) -> list[str]:
    """What has to be finite of a pose besides its rotation."""
    task = module.chain.task
    places = has_to_be_finite(module, (f"T[{4 * row + 3}]" for row in task.position_rows))
    level = ["T[0] * T[0]", "T[4] * T[4]"] * (task.directions is Directions.YAW)
    return places + level


def finite_given(module: SolverModule) -> list[str]:
    """What has to be finite of the values that the caller gives."""
    return has_to_be_finite(module, (f"free_joints[{k}]" for k in range(module.chain.given)))


def _misfits(module: SolverModule, lanes: str) -> list[str]:
    """What the directions of a pose miss, and its last row."""
    task = module.chain.task
    if task.kind is TaskKind.POSE:
        return [f"dhgen_pose_misfit{lanes}(T)"]
    words = {Directions.ROTATION: "", Directions.POINTING: "approach_"}
    which = words.get(task.directions, f"{task.directions.value}_")
    none = {Directions.NONE, Directions.YAW}  # formulas make a yaw's directions one long
    return [] if task.directions in none else [f"dhgen_{which}misfit{lanes}(T)"]


def _sum(terms: list[str], finite: list[str]) -> str:
    return " + ".join([*terms, *([f"0.0 * ({' + '.join(finite)})"] if finite else [])])
