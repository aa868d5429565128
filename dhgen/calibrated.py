"""Arms of one kind whose tables come at run time: what they have in common.

Their numbers are not known here, so that one of them is the sample of all: the arm of the data
sheet with other numbers than nominal ones in its table. By it the formulations of the general
algorithm are chosen, and what has to be done around its rows. Zeros of joints, base and tool change
neither; lengths count in sizes of the nominal arm, whose tool has a share in its size.
"""

from __future__ import annotations

from dataclasses import replace
from json import dumps
from typing import TYPE_CHECKING

from dhgen.errors import UnsolvedError
from dhgen.kinematics.build import build_chain
from dhgen.kinematics.link_table import AXES, link_table
from dhgen.kinematics.neighbours import EXACT, axis_triples
from dhgen.method import Method
from dhgen.nominal.certificate import certified
from dhgen.paul.derive import derive
from dhgen.program.lowering.lower import lower
from dhgen.program.lowering.programs import robot_programs
from dhgen.program.policy import policy_of
from dhgen.program.regular.regular import regular
from dhgen.robot.load import load_text
from dhgen.robot.robot import FLEET
from dhgen.robot.task import TaskKind
from dhgen.targets.calibrated import Kind

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.link_table import LinkTable
    from dhgen.program.reserved import Reserved
    from dhgen.robot.robot import Robot
    from dhgen.targets.module import SolverModule

JOINTS = 6
# What the sample arm's numbers are more than nominal ones [rad, arm sizes]: as in calibrations, and
# no two alike in a column.
STEP = 2e-4
PARTS = (0.618, 0.382, 0.854, 0.236, 0.472, 0.708)


def kind_of(robot: Robot, nominal: SolverModule, reserved: Reserved) -> Kind:
    """The kind of arms of a robot file.

    Args:
        robot: The file.
        nominal: Its programs.
        reserved: Names that are kept for others.

    Raises:
        UnsolvedError: Its arms can't be solved with tables that come at run time.
    """
    table = link_table(robot)
    _demand_table(robot, nominal, table)
    whole = regular(nominal.solver)
    own = None if whole is None else certified(whole, 0, frozenset())
    if own is None:
        raise _unsolved(robot, "where rows of its closed form end has no bound")
    name = robot.name + FLEET
    text = _file(name, nominal.chain, table)
    one = replace(build_chain(load_text(text, name)), size=nominal.chain.size)
    derivation = derive(one)
    if derivation.method is not Method.GENERAL_6R:
        raise _unsolved(robot, "what is near it is not solved by the general algorithm")
    precision = nominal.precision
    solver = lower(derivation, precision.tolerances, reserved)
    programs = robot_programs(derivation, solver, name, precision.tolerances, reserved)
    module = replace(
        nominal,
        name=name,
        title=f"{robot.title}, calibrated",
        chain=one,
        method=derivation.method,
        solver=programs.solver,
        forward=programs.forward,
        jacobian=programs.jacobian,
        policy=policy_of(one, programs.solver, precision.tolerances),
        nominal=None,
        nearest_branches=nominal.branches,
    )
    return Kind(module, nominal, table, own)


def _demand_table(robot: Robot, nominal: SolverModule, table: LinkTable) -> None:
    """Stops where an arm has no table of six turning joints, or another method."""
    chain = nominal.chain
    if table.convention == AXES:
        raise _unsolved(robot, "it is given by axes")
    if chain.dof != JOINTS or not all(chain.turning):
        raise _unsolved(robot, "it has other joints than six that turn")
    if robot.free:
        joints = "joint" if len(robot.free) == 1 else "joints"
        listed = ", ".join(map(str, robot.free))
        raise _unsolved(
            robot, f"the caller gives {joints} {listed} (free), and all six are to be solved for"
        )
    if chain.task.kind is not TaskKind.POSE:
        raise _unsolved(robot, "it is not asked for poses alone")
    if robot.sums:
        raise _unsolved(robot, "sums of its joint values have limits")
    if robot.is_coupled:
        raise _unsolved(robot, "its drives are coupled")
    if robot.plain:
        raise _unsolved(robot, "it is plain, without what goes before the general algorithm")
    if nominal.method is not Method.CLOSED_FORM:
        raise _unsolved(robot, f"its own method is {nominal.method}, no closed form")
    within = EXACT * chain.size
    if not any(each.tilt < EXACT or each.miss < within for each in axis_triples(chain)):
        raise _unsolved(robot, "no three of its axes side by side are parallel, or meet")


def _unsolved(robot: Robot, reason: str) -> UnsolvedError:
    advice = "leave calibration out, and make a robot file of each arm by `dhgen calibrate`"
    return UnsolvedError(f"{robot.name}: tables can't come at run time: {reason}; {advice}")


def _file(name: str, chain: Chain, table: LinkTable) -> str:
    """The robot file of the sample arm."""
    rows = []
    for place, (row, joint) in enumerate(zip(table.rows, chain.joints, strict=True)):
        part, other = PARTS[place], PARTS[(place + 2) % len(PARTS)]
        d = row[1] + STEP * chain.size * part
        a = row[2] + STEP * chain.size * other
        alpha = row[3] + STEP * (1.0 - part)
        q = "q" if joint.sign > 0 else "-q"
        limits = f", limits: {list(joint.limits)}" if joint.limits else ""
        called = f", name: {dumps(joint.name)}" if joint.name else ""
        rows.append(f"  - {{theta: {q}, d: {d!r}, a: {a!r}, alpha: {alpha!r}{limits}{called}}}")
    head = f"name: {name}\nsource: computed\nconvention: {table.convention}\njoints:"
    return "\n".join([head, *rows, "task: pose", "units: {angle: rad}", ""])
