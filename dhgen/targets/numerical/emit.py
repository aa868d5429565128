"""Fills in the templates of the numerical solver."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.targets.numerical.descent import Descent
from dhgen.targets.numerical.problem import problem_of
from dhgen.targets.numerical.texts import turning_places

if TYPE_CHECKING:
    from dhgen.numerical.both_sides import Turning
    from dhgen.numerical.kernel import NumericalKernel
    from dhgen.targets.solver.calls import Calls
    from dhgen.targets.solver.common import Common
    from dhgen.targets.solver.module import Module
    from dhgen.targets.writing import Writing


@dataclass(frozen=True, slots=True)
class TableEntries:
    """Entries of the arm's table in C that depend on what the arm has; names of nothing are 0.

    Attributes:
        coordinates: How many the task names.
        elbow: Whether the arm angle is an equation.
        flags: Whether solutions are families, joints have limits, and the pose is checked.
        coordinate: Rows of the coordinates.
        measure: What steps move.
        bounds: Of descents.
        loop_joints: How the loop of the general algorithm counts the joints.
        given: How many joints' values the caller gives, and which.
        given_joints: The same joints, from 0.
        free_joints: Their values.
        plane_miss: The function that measures how the arm angle is missed.
    """

    coordinates: int
    elbow: int
    flags: str
    coordinate: str
    measure: str
    bounds: str
    loop_joints: str
    given: str
    given_joints: str
    free_joints: str
    plane_miss: str


def _entries(kernel: NumericalKernel, *, in_loop: bool) -> TableEntries:
    problem = problem_of(kernel)
    flags = kernel.redundant, kernel.limited, kernel.checked
    given = [str(each.joint) for each in problem.given]
    return TableEntries(
        coordinates=len(problem.position),
        elbow=int(problem.elbow),
        flags=", ".join(str(int(flag)) for flag in flags),
        coordinate="coordinate" if problem.position else "0",
        measure="measure" if problem.position else "0",
        bounds="least_u, most_u" if problem.bounded else "0, 0",
        loop_joints="facing, zero" if in_loop else "0, 0",
        given=f"{len(given)}, {'given_places' if given else '0'}",
        given_joints=", ".join(given),
        free_joints="free_joints" if given else "0",
        plane_miss="plane_miss" if problem.elbow else "0",
    )


def table(
    kernel: NumericalKernel, module: Module, writing: Writing, facing: str = "", zero: str = ""
) -> str:
    """The arm's table for the runtime, and the function `all_joints`.

    Args:
        kernel: The arm.
        module: Its name and sizes.
        writing: C.
        facing: Defines how the loop of the general algorithm counts the joints, where there is one.
        zero: And from where.
    """
    entries = _entries(kernel, in_loop=bool(facing))
    return _filled("arm", kernel, module, writing, facing=facing, zero=zero, entries=entries)


def tightening(kernel: NumericalKernel, module: Module, writing: Writing) -> str:
    """The function `tighten`, with all that it needs."""
    return _filled("tighten", kernel, module, writing)


def both_sides(
    kernel: NumericalKernel, turning: Turning, common: Common, calls: Calls, writing: Writing
) -> str:
    """The function `both_sides`; it needs `solve` and what tightens."""
    places = turning_places(turning)
    others = {"searches": common.searches, "calls": calls}
    others |= {"turning": places, "turned": places[0].place}
    return _filled("both_sides", kernel, common.module, writing, **others)


def seeking(kernel: NumericalKernel, common: Common, calls: Calls, writing: Writing) -> str:
    """The function `seek`; it needs what tightens and, with limits, searches."""
    others = {"searches": common.searches, "standing": common.standing, "calls": calls}
    return _filled("seek", kernel, common.module, writing, **others)


def _filled(
    template: str, kernel: NumericalKernel, module: Module, writing: Writing, **others: object
) -> str:
    """A template with what all of them name, and what only some do."""
    return writing.filled(
        f"numerical/{template}",
        module=module,
        problem=problem_of(kernel),
        descent=Descent(),
        arrays=writing.arrays(kernel),
        **others,
    )
