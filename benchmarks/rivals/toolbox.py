"""Robotics Toolbox for Python (Corke): `analytic_ik`, in Python and as the C that it exports."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from benchmarks.contestant import AbsentError, Contestant, imported, timed, versioned
from benchmarks.native import NATIVE, Interface, compiled
from benchmarks.rivals.common_normals import standard_table
from benchmarks.screws import screws
from dhgen.robot.expression import evaluate
from dhgen.robot.robot import Convention, DhTable, JointKind

if TYPE_CHECKING:
    from pathlib import Path

    from benchmarks.arms import Arm
    from benchmarks.contestant import Run
    from benchmarks.rivals.common_normals import Link
    from dhgen.arrays import FloatArray

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
    table = standard(arm)
    solver = _derived(arm, table)
    tool = versioned("roboticstoolbox-python").replace("roboticstoolbox-python", "Robotics Toolbox")

    def answer(pose: FloatArray) -> FloatArray:
        return np.array(solver.solve(pose, joint_limits=False).q).reshape(-1, 6)

    def one(T: FloatArray) -> Run:
        poses = list(T)

        def work() -> None:
            for pose in poses:
                solver.solve(pose, joint_limits=False)

        return timed(work)

    source = folder / f"{arm.case.name}_rtb.c"
    source.write_text(solver.generate("c", f"{arm.case.name}_rtb"), encoding="utf-8")
    shim = SHIM.format(name=arm.case.name)
    native = compiled(source, Interface(shim, rows=64, dof=6), FLAGS, folder)

    def bare(T: FloatArray) -> FloatArray:
        """Its C knows neither base nor tool."""
        return np.asarray(np.linalg.inv(table.base) @ T @ np.linalg.inv(table.tool))

    return [
        Contestant(tool, "one call from Python", lambda T: [answer(pose) for pose in T], one),
        Contestant(
            tool,
            "exported C, one pose",
            lambda T: native.solve(bare(T)),
            lambda T: native.prepare(bare(T)),
        ),
    ]


@dataclass(frozen=True, slots=True)
class Table:
    """A standard table, every row with theta (or d) at q = 0, the sign of q, and its limits."""

    base: FloatArray
    links: list[Link]
    kinds: list[JointKind]
    signs: list[int]
    limits: list[tuple[float, float] | None]
    tool: FloatArray


def standard(arm: Arm) -> Table:
    """The arm's table.

    Raises:
        AbsentError: The arm is not what the Toolbox takes.
    """
    if arm.dof != 6:
        raise AbsentError("takes six joints only")
    kinds = [joint.kind for joint in arm.robot.joints]
    limits = [joint.limits for joint in arm.robot.joints]
    table = arm.robot.geometry
    if not isinstance(table, DhTable):
        base, links, tool = standard_table(screws(arm))
        return Table(base, links, kinds, [1] * len(links), limits, tool)
    values = {parameter.name: parameter.value for parameter in arm.robot.parameters}
    cells = [
        [evaluate(cell, values) for cell in (row.theta, row.d, row.a, row.alpha)]
        for row in table.rows
    ]
    base, lengths = arm.model.base, [cell[2:] for cell in cells]
    if table.convention is Convention.MODIFIED:  # a and alpha move to the row before
        base = base @ _link_transform(*lengths[0])
        lengths = [*lengths[1:], [0.0, 0.0]]
    links = [
        (theta, d, a, alpha) for (theta, d, *_), (a, alpha) in zip(cells, lengths, strict=True)
    ]
    signs = [row.sign for row in table.rows]
    return Table(base, links, kinds, signs, limits, arm.model.tool)


def _link_transform(a: float, alpha: float) -> FloatArray:
    T = np.eye(4)
    T[0, 3] = a
    T[1:3, 1:3] = [[np.cos(alpha), -np.sin(alpha)], [np.sin(alpha), np.cos(alpha)]]
    return T


def _derived(arm: Arm, table: Table) -> Any:  # noqa: ANN401 - a type of the Toolbox
    """Its solver of the arm."""
    toolbox, place = imported("roboticstoolbox"), imported("spatialmath").SE3
    links = []
    for (theta, d, a, alpha), kind, sign, limits in zip(
        table.links, table.kinds, table.signs, table.limits, strict=True
    ):
        known = {"a": a, "alpha": alpha, "flip": sign < 0}
        if kind is JointKind.PRISMATIC:  # it insists on limits, and is told not to mind them
            given = {"theta": theta, "offset": d, "qlim": limits or (0.0, 1.0)}
            links.append(toolbox.PrismaticDH(**known, **given))
        else:
            links.append(toolbox.RevoluteDH(**known, d=d, offset=theta))
    robot = toolbox.DHRobot(
        links, name=arm.case.name, base=place(table.base), tool=place(table.tool)
    )
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return robot.analytic_ik()
