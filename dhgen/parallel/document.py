"""The derivation of a parallel robot, and what a terminal is told of it."""

from __future__ import annotations

from collections import Counter
from typing import TYPE_CHECKING

from dhgen.parallel.mobility import Count, counted
from dhgen.printing.comments import plain_path

if TYPE_CHECKING:
    from dhgen.parallel.module import ParallelModule


def parallel_document(module: ParallelModule) -> dict[str, str]:
    """The document by its name."""
    made = (
        f"<!-- {module.name}: the derivation of its inverse kinematics. Generated from "
        f"{plain_path(module.source)} and templates/c/parallel.c.jinja. Do not edit. -->"
    )
    return {
        f"{module.name}.md": f"{made}\n\n# {module.robot.title}\n\n{parallel_summary(module)}\n"
    }


def count_of(module: ParallelModule) -> Count:
    """The platform's freedoms."""
    joints = [leg.solver.chain.dof for leg in module.legs]
    points = [not leg.leg.carries_frame for leg in module.legs]
    return counted(module.robot.task, joints, points, module.robot.drives)


def parallel_summary(module: ParallelModule) -> str:
    """What the robot is and how it is solved, in some lines."""
    kinds = Counter(leg.solver.name for leg in module.legs)
    types = {leg.solver.name: leg.solver.chain.joint_types for leg in module.legs}
    legs = ", ".join(f"{count} {types[name]} ({name})" for name, count in kinds.items())
    of = {leg.solver.name: leg.solver for leg in module.legs}
    rows = " x ".join(str(of[leg.solver.name].solver.rows) for leg in module.legs)
    direct = (
        f"all assemblies by {module.elimination}, or refined from a seed"
        if module.elimination
        else "refined from a seed; how many assemblies there are is not promised"
    )
    return "\n".join(
        [
            f"  legs     {legs}",
            f"  task     {module.robot.task.text}; mobility {count_of(module).text}",
            f"  inverse  that of the legs: rows {rows}",
            f"  direct   {direct}",
        ]
    )
