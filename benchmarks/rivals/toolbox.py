"""Robotics Toolbox for Python (Corke): `analytic_ik`, in Python and as the C that it exports."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

import numpy as np

from benchmarks.contestant import AbsentError, Contestant, imported, timed, versioned
from benchmarks.native import NATIVE, Interface, compiled
from dhgen.robot.expression import evaluate
from dhgen.robot.robot import Convention, DhTable, JointKind

if TYPE_CHECKING:
    from pathlib import Path

    from benchmarks.arms import Arm
    from benchmarks.contestant import Run
    from dhgen.kinematics.numeric import Array
    from dhgen.robot.robot import DhRow

FLAGS = ("-std=gnu99", *NATIVE[1:])  # its C says M_PI_2, which C99 does not know
SHIM = """
int {name}_rtb(const double T[16], double tol, double q[64][6], int *count);
static int solve(const double *T, double *q)
{{
    int count = 0;
    {name}_rtb(T, 1e-6, (double (*)[6])q, &count);
    return count;
}}
"""


def contestants(arm: Arm, folder: Path) -> list[Contestant]:
    """One call from Python, and the exported C."""
    solver = _derived(arm)
    tool = versioned("roboticstoolbox-python").replace("roboticstoolbox-python", "Robotics Toolbox")

    def answer(pose: Array) -> Array:
        return np.array(solver.solve(pose, joint_limits=False).q).reshape(-1, 6)

    def one(T: Array) -> Run:
        poses = list(T)

        def work() -> None:
            for pose in poses:
                solver.solve(pose, joint_limits=False)

        return timed(work)

    source = folder / f"{arm.case.name}_rtb.c"
    source.write_text(solver.generate("c", f"{arm.case.name}_rtb"), encoding="utf-8")
    shim = SHIM.format(name=arm.case.name)
    native = compiled(source, Interface(shim, rows=64, dof=6), FLAGS, folder)
    return [
        Contestant(tool, "one call from Python", lambda T: [answer(pose) for pose in T], one),
        Contestant(tool, "exported C, one pose", native.solve, native.prepare),
    ]


def _derived(arm: Arm) -> Any:  # noqa: ANN401 - a type of the Toolbox
    """Its solver of the arm, from the table of the robot file."""
    toolbox = imported("roboticstoolbox")
    table = arm.robot.geometry
    if not isinstance(table, DhTable) or table.convention is not Convention.STANDARD:
        raise AbsentError("takes standard Denavit-Hartenberg tables only")
    if arm.dof != 6:
        raise AbsentError("takes six joints only")
    values = {parameter.name: parameter.value for parameter in arm.robot.parameters}
    robot = toolbox.DHRobot(
        [_link(toolbox, row, values) for row in table.rows],
        name=arm.case.name,
        base=_frame(arm.model.base),
        tool=_frame(arm.model.tool),
    )
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return robot.analytic_ik()


def _link(toolbox: Any, row: DhRow, values: dict[str, float]) -> Any:  # noqa: ANN401
    theta, d, a, alpha = (evaluate(cell, values) for cell in (row.theta, row.d, row.a, row.alpha))
    if row.kind is JointKind.PRISMATIC:  # it insists on limits, and is told not to mind them
        given = {"theta": theta, "offset": d, "qlim": row.limits or (0.0, 1.0)}
        return toolbox.PrismaticDH(a=a, alpha=alpha, flip=row.sign < 0, **given)
    return toolbox.RevoluteDH(d=d, a=a, alpha=alpha, offset=theta, flip=row.sign < 0)


def _frame(T: Array) -> Any:  # noqa: ANN401 - a type of the Toolbox
    return imported("spatialmath").SE3(T)
