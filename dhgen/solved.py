"""A robot file and how its arm is solved: all that a derivation is printed from.

Stages of the compiler from the robot to the program that solves; what prints solvers and verifies
them, which takes as long to load, is none of it.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from dhgen.derivation.story import Story
from dhgen.errors import UnsolvedError
from dhgen.kinematics.build import build_chain
from dhgen.paul.derive import derive
from dhgen.paul.refusal.other_convention import other_convention
from dhgen.program.lowering.lower import lower
from dhgen.targets.reserved import RESERVED

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.robot_files import RobotFile


def solved(file: RobotFile, progress: Callable[[str], None] = lambda _: None) -> Story:
    """The arm of a robot file, derived, with the program that solves it in double precision.

    Args:
        file: The robot file, read.
        progress: Called with what is being done.

    Raises:
        UnsolvedError: No derivation solves the arm.
    """
    robot = file.robot
    progress("deriving")
    chain = build_chain(robot)
    try:
        derivation = derive(chain, numerical=robot.numerical, steps=robot.steps)
    except UnsolvedError as error:
        raise UnsolvedError("\n".join((str(error), *other_convention(robot)))) from error
    progress("writing programs")
    solver = replace(lower(derivation, reserved=RESERVED), name=robot.name)
    if derivation.whole is None or robot.plain:
        return Story(robot, derivation, solver, None)
    from dhgen.nominal.nominal import nominal_arm  # noqa: PLC0415  of few arms

    return Story(robot, derivation, solver, nominal_arm(chain, RESERVED))
