"""The constants of an arm and its task for least squares."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, pi
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.numeric import numeric_arm
from dhgen.kinematics.turns import solved_alone, turns_together
from dhgen.method import Method
from dhgen.robot.robot import JointKind
from dhgen.runtime.python.numerical.arm import MISSES
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.numeric import NumericArm
    from dhgen.robot.task import Directions

MOST = 16  # rows of an arm with finitely many solutions: what a general arm has at most


@dataclass(frozen=True, slots=True)
class NumericalKernel:
    """An arm and its task in numbers.

    Attributes:
        arm: The forward model.
        solved: Places, from 0, of the joints that are not given.
        turns: Whether each of them turns.
        units: What a step of one means for each: 1 rad, or the arm's size.
        lowest: The lowest value of each, in units; minus infinity without limits.
        highest: The highest.
        position: Rows of the translation that the task names.
        directions: What counts of the orientation.
        redundant: Whether every pose has infinitely many solutions.
        checked: Whether the task names more than the joints can choose.
        most: Rows of an arm with finitely many solutions.
    """

    arm: NumericArm
    solved: tuple[int, ...]
    turns: tuple[bool, ...]
    units: tuple[float, ...]
    lowest: tuple[float, ...]
    highest: tuple[float, ...]
    position: tuple[int, ...]
    directions: Directions
    redundant: bool
    checked: bool
    most: int = MOST

    @property
    def method(self) -> Method:
        """How the arm is solved."""
        return Method.NUMERICAL

    @property
    def residual(self) -> float:
        """What counts as a solution [arm sizes, rad]: a pose that is checked may be rounded."""
        return TOLERANCES.consistent if self.checked else TOLERANCES.refined

    @property
    def elbow(self) -> bool:
        """Whether the arm angle is one of the things to be met."""
        return self.arm.chain.arm_angle

    @property
    def back(self) -> FloatArray | None:
        """What the drives that are solved for have of angles and lengths, and of given values.

        None where every drive moves its own joint alone, so that its sign is all. Joints whose
        values are given are moved by given drives alone.
        """
        chain = self.arm.chain
        if not chain.drives.are_coupled:
            return None
        given = [number - 1 for number in chain.free]
        own = chain.drives.inverse
        own[:, given] = own[:, given] @ chain.drives.matrix[np.ix_(given, given)]
        return np.asarray(own[list(self.solved)] + 0.0)  # no -0.0

    @property
    def turned(self) -> tuple[tuple[int, FloatArray], ...]:
        """What a whole turn of a drive moves, in units: its place among those solved for, and all.

        Empty where every drive's whole turns are its own.
        """
        solved = list(self.solved)
        return tuple(
            (solved.index(drive - 1), move[solved] / np.array(self.units))
            for drive, move in turns_together(self.arm.chain)
        )

    @property
    def limited(self) -> bool:
        """Whether a joint that is solved for has limits."""
        return max(self.lowest) > -inf or min(self.highest) < inf

    @property
    def bounded(self) -> bool:
        """Whether solutions are looked for between the lowest and highest values."""
        return self.limited or self.redundant

    @property
    def rows(self) -> int:
        """How many solutions are kept: of infinitely many the one nearest to the seed."""
        return 1 if self.redundant else self.most

    @property
    def entries(self) -> int:
        """How many numbers measure the miss of a pose."""
        return len(self.position) + MISSES[self.directions.value]

    @property
    def equations(self) -> int:
        """How many there are with the arm angle's."""
        return self.entries + int(self.elbow)

    @property
    def spans(self) -> tuple[tuple[float, float], ...]:
        """Where starts lie, for each joint that is solved for [units]: a turn, or the limits."""
        wide = [pi if turns else 1.0 for turns in self.turns]
        return tuple(
            (low if low > -inf else -w, high if high < inf else w)
            for low, high, w in zip(self.lowest, self.highest, wide, strict=True)
        )


def numerical_kernel(chain: Chain, *, redundant: bool) -> NumericalKernel:
    """The kernel of any arm and task."""
    joints = chain.solved
    turns = [joint.kind is JointKind.REVOLUTE for joint in joints]
    units = [1.0 if each else chain.size for each in turns]
    limits = [joint.limits or (-inf, inf) for joint in solved_alone(chain)]
    task = chain.task
    return NumericalKernel(
        arm=numeric_arm(chain),
        solved=tuple(joint.number - 1 for joint in joints),
        turns=tuple(turns),
        units=tuple(units),
        lowest=tuple(low / unit for (low, _), unit in zip(limits, units, strict=True)),
        highest=tuple(high / unit for (_, high), unit in zip(limits, units, strict=True)),
        position=task.position_rows,
        directions=task.directions,
        redundant=redundant,
        checked=chain.overdetermined,
    )
