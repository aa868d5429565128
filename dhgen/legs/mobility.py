"""How many freedoms legs leave a platform, by the count of Gruebler and Kutzbach.

Counted in the motions that the task names, of which there are n: n = 6 of a pose, 3 in a plane and
of a point. Every leg closes the loop once more and takes n freedoms, its joints bring their own
f, and a point that is carried adds the turns of the joint there that the task names: three of a
ball in space, one of a pin in the plane, none where no orientation counts. So

    M = f_1 + ... + f_L - n (L - 1).

What keeps a platform level without being a joint of a leg, like the parallelograms of a Delta, is
in the task: it names no orientation then. The count does not see special geometry: legs whose
constraints are dependent are found where the velocities are.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.robot.task import Task


@dataclass(frozen=True, slots=True)
class Count:
    """The count of a platform.

    Attributes:
        task: Freedoms that the task names, n.
        joints: Joints of every leg.
        ends: Turns of every leg's joint at the platform, as far as the task names them.
        driven: Joints that are driven, of all legs.
    """

    task: int
    joints: tuple[int, ...]
    ends: tuple[int, ...]
    driven: int

    @property
    def freedoms(self) -> tuple[int, ...]:
        """Of every leg, f."""
        return tuple(map(sum, zip(self.joints, self.ends, strict=True)))

    @property
    def mobility(self) -> int:
        """M."""
        return sum(self.freedoms) - self.task * (len(self.joints) - 1)

    @property
    def text(self) -> str:
        """The count, written out."""
        legs = " + ".join(map(str, self.freedoms))
        return f"M = {legs} - {self.task}*{len(self.joints) - 1} = {self.mobility}"


def counted(task: Task, joints: Sequence[int], points: Sequence[bool], driven: int) -> Count:
    """The count of a platform.

    Args:
        task: What of the platform's pose is moved.
        joints: How many joints each leg has.
        points: Whether each leg carries a point, by a joint that turns freely there.
        driven: How many joints are driven.
    """
    turns = task.directions.dimension
    return Count(task.dimension, tuple(joints), tuple(turns * each for each in points), driven)


def faults(count: Count) -> list[str]:
    """Why a platform can't be moved as its task needs; nothing where it can."""
    found = []
    kutzbach = f"by Gruebler and Kutzbach {count.text}"
    if count.mobility != count.task:
        more = "more than" if count.mobility > count.task else "less than"
        found.append(
            f"the platform has other freedoms than the task: {kutzbach}, {more} the {count.task} "
            "that the task names (joints of each leg, and the turns of its joint at the platform "
            "that the task names)"
        )
    elif any(each != count.task for each in count.freedoms):
        number = next(n for n, each in enumerate(count.freedoms, 1) if each != count.task)
        found.append(
            f"leg {number} has {count.freedoms[number - 1]} freedoms where the task names "
            f"{count.task}: {kutzbach} is right as a sum only"
        )
    if count.driven != count.mobility and count.mobility == count.task:
        found.append(
            f"{count.driven} joints are driven, and the platform has mobility {count.mobility}: "
            f"{kutzbach}; drive as many"
        )
    return found
