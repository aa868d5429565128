"""What the code targets print of a parallel robot: its legs' solvers and their places."""

from __future__ import annotations

import math
from dataclasses import dataclass
from enum import StrEnum
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.numeric import numeric_arm
from dhgen.legs.robot import ORIGIN
from dhgen.robot.task import Directions, TaskKind
from dhgen.runtime.python import assemblies
from dhgen.runtime.python.platform import COORDINATES, POSE, YAW

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.legs.robot import Leg, ParallelRobot
    from dhgen.robot.task import Task
    from dhgen.targets.module import SolverModule

MEETS = 1e-9  # what passive axes may miss each other by [leg sizes], and the sine between parallels
SAMPLES = 3  # joint values at which they are looked at


class Elimination(StrEnum):
    """How all poses of a platform follow from its drives, where that is known and small."""

    TWO_CIRCLES = assemblies.TWO_CIRCLES
    THREE_CIRCLES = assemblies.THREE_CIRCLES
    THREE_SPHERES = assemblies.THREE_SPHERES

    @property
    def most(self) -> int:
        """How many poses there are at most."""
        return assemblies.MOST_ASSEMBLIES if self is Elimination.THREE_CIRCLES else 2


@dataclass(frozen=True, slots=True)
class LegModule:
    """A leg as it is printed.

    Attributes:
        leg: The leg.
        solver: The programs of its chain.
    """

    leg: Leg
    solver: SolverModule

    @property
    def driven(self) -> tuple[int, ...]:
        """Its driven joints, from 0."""
        return self.leg.driven

    @property
    def counted(self) -> tuple[int, ...]:
        """Which of the six velocities of its end the platform gives it."""
        return counted_velocities(self.leg.chain.task)


@dataclass(frozen=True, slots=True)
class ParallelModule:
    """A parallel robot as it is printed.

    Attributes:
        robot: Its file's contents.
        legs: Its legs with their solvers.
        source: How the robot file is called, relative.
        digest: Of the robot file.
        elimination: How all assemblies are found, if that is known.
    """

    robot: ParallelRobot
    legs: tuple[LegModule, ...]
    source: str
    digest: str
    elimination: Elimination | None

    @property
    def name(self) -> str:
        """The robot's identifier."""
        return self.robot.name

    @property
    def rows(self) -> int:
        """Of the leg with the most."""
        return max(leg.solver.solver.rows for leg in self.legs)

    @property
    def joints(self) -> int:
        """Of the leg with the most."""
        return max(leg.solver.chain.dof for leg in self.legs)

    @property
    def driven_joints(self) -> tuple[tuple[int, ...], ...]:
        """Of every leg its driven joints, from 0."""
        return tuple(leg.driven for leg in self.legs)

    @property
    def driven(self) -> int:
        """Joints of the leg with the most that are driven."""
        return max(map(len, self.driven_joints))

    @property
    def size(self) -> float:
        """The unit of tolerances, to few digits: the largest leg, or what feet or ends are apart.

        A leg of slides without limits has no size of its own.
        """
        largest = max(leg.solver.chain.size for leg in self.legs)
        frames = [(leg.leg.base, leg.leg.end) for leg in self.legs]
        apart = (
            math.dist([one[k] for k in ORIGIN], [other[k] for k in ORIGIN])
            for pair in combinations(frames, 2)
            for one, other in zip(*pair, strict=True)
        )
        return float(f"{max([largest, *apart]):.4g}")

    @property
    def freedoms(self) -> tuple[int, ...]:
        """Which of the six velocities the platform has."""
        return counted_velocities(self.robot.task)

    @property
    def counts(self) -> str:
        """What counts of the platform's orientation, in the runtime's words."""
        words = {Directions.ROTATION: POSE, Directions.YAW: YAW}
        return words.get(self.robot.task.directions, COORDINATES)

    @property
    def is_planar(self) -> bool:
        """Whether the platform moves in the plane of x and y."""
        return self.robot.task.position_rows == (0, 1)

    @property
    def is_alike(self) -> bool:
        """Whether all legs are of one chain."""
        return len({leg.solver.name for leg in self.legs}) == 1


def counted_velocities(task: Task) -> tuple[int, ...]:
    """Which of three velocities and three angular ones a task names, for tasks of platforms."""
    turns = {Directions.ROTATION: (3, 4, 5), Directions.YAW: (5,)}
    return (*task.position_rows, *turns.get(task.directions, ()))


def elimination_of(robot: ParallelRobot, solvers: Sequence[SolverModule]) -> Elimination | None:
    """How all poses of a platform follow from its drives.

    Every leg has to let what it carries go around a point while its one drive is held: on a circle
    about its passive joint in the plane, on a sphere about the point where two passive axes meet.
    """
    if not all(map(_goes_around, robot.legs, solvers)):
        return None
    legs, task = len(robot.legs), robot.task
    if task.kind is TaskKind.POSITION and legs == 3:
        return Elimination.THREE_SPHERES
    if task.position_rows == (0, 1):
        return Elimination.THREE_CIRCLES if task.angles else Elimination.TWO_CIRCLES
    return None


def _goes_around(leg: Leg, solver: SolverModule) -> bool:
    """Whether a leg lets what it carries go around a point."""
    chain = solver.chain
    passive = [joint for joint in range(chain.dof) if joint not in leg.driven]
    if leg.carries_frame or len(leg.driven) > 1 or not all(chain.turning[j] for j in passive):
        return False
    if len(passive) == 1:
        return True
    source, arm = np.random.default_rng(1), numeric_arm(chain)
    for q in source.uniform(-1.0, 1.0, (SAMPLES, chain.dof)):
        directions, points = arm.axes(q)
        (one, other), (a, b) = directions[passive], points[passive]
        across = np.cross(one, other)
        if np.linalg.norm(across) < MEETS or abs((b - a) @ across) > MEETS * chain.size:
            return False
    return True
