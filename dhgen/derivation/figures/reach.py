"""Which point of an arm its workspace is drawn of, in which plane, and which joints move it there.

The point is the tool's, or one where axes meet if fewer joints move that. In a plane at most three
joints may move it: more make no picture that a grid can fill.
"""

from __future__ import annotations

import math
import random
from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.figures.plane import UP, are_parallel
from dhgen.kinematics.numeric import numeric_arm

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from dhgen.arrays import FloatArray
    from dhgen.derivation.story import Story
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.numeric import NumericArm

SAMPLES = 5  # joint vectors at which is looked what moves a point
STILL = 1e-7  # of the arm's size: a point that a joint doesn't move
STEP = 0.1  # of a joint, for that [rad, arm sizes]
MOST = 3  # joints that move a point in its plane


class Section(Enum):
    """What is drawn of the workspace."""

    HALF_PLANE = "the half-plane through axis {}"  # r and z
    ABOVE = "the plane across the axes"  # x and y


@dataclass(frozen=True, slots=True)
class Reach:
    """A point that an arm moves in a plane.

    Attributes:
        arm: The arm.
        section: Which plane.
        axis: The joint, from 1, whose axis r is counted from, or 0.
        joint: The joint, from 1, whose frame's origin is the point; 0 is the tool.
        name: The point in a sentence.
        movers: The joints, from 1, that move it there.
    """

    arm: NumericArm
    section: Section
    axis: int
    joint: int
    name: str
    movers: tuple[int, ...]

    def points(self, q: FloatArray) -> FloatArray:
        """The point in space at joint values (..., n), from the axis where r counts, (..., 3)."""
        at = _point(self.arm, q, self.joint)
        if self.section is Section.ABOVE:
            return at
        still = np.zeros(self.arm.chain.dof)  # the axis does not move
        return np.asarray(at - self.arm.axes(still)[1][self.axis - 1] * (1.0, 1.0, 0.0))

    def coordinates(self, q: FloatArray) -> FloatArray:
        """Its coordinates in the plane at joint values (..., n), (..., 2)."""
        at = self.points(q)
        if self.section is Section.ABOVE:
            return np.asarray(at[..., :2])
        return np.stack([np.hypot(at[..., 0], at[..., 1]), at[..., 2]], axis=-1)

    def swept(self, one: int, other: int) -> float:
        """How much of the plane two joints, from 1, sweep together, [arm sizes squared]."""
        chain = self.arm.chain
        q = samples(chain)
        before = self.coordinates(q)
        (a, b), (c, d) = ((self.coordinates(moved(chain, q, j)) - before).T for j in (one, other))
        return float(np.abs(a * d - b * c).mean()) / chain.size**2


def find_reach(story: Story) -> Reach | None:
    """What is drawn of an arm; None where no plane shows it."""
    chain = story.algebra.chain
    arm = numeric_arm(chain)
    for joint, name in _candidates(story, arm):
        for section, axis in _sections(arm, joint):
            reach = Reach(arm, section, axis, joint, name, ())
            movers = _movers(reach)
            if 2 <= len(movers) <= MOST:
                if not _are_bounded(chain, movers):
                    return None
                return Reach(arm, section, axis, joint, name, movers)
    return None


def _are_bounded(chain: Chain, movers: tuple[int, ...]) -> bool:
    """Whether what joints may do is a box of their values: no sum of them has limits of its own."""
    joints = [chain.joints[number - 1] for number in movers]
    boxed = all(chain.turning[joint.number - 1] or joint.limits for joint in joints)
    return boxed and not any(total.factors[j - 1] for total in chain.sums for j in movers)


def _candidates(story: Story, arm: NumericArm) -> Iterable[tuple[int, str]]:
    """The tool, then the points where axes meet, from the tool to the base."""
    yield 0, "the tool"
    q = samples(arm.chain)
    z, at = arm.axes(q)
    for joint in range(arm.chain.dof, 1, -1):
        for other in (joint - 1, joint + 1):
            if other > arm.chain.dof:
                continue
            between = at[:, joint - 1] - at[:, other - 1]
            crossing = np.abs(np.cross(z[:, joint - 1], z[:, other - 1])).max()
            off = np.abs(np.cross(between, z[:, other - 1])).max()
            if off < STILL * arm.chain.size and crossing > STILL:
                low, high = sorted((joint, other))
                wrist = story.wrist is not None and low in story.wrist and high in story.wrist
                meet = f"the point where axes {low} and {high} meet"
                yield joint, "the wrist centre" if wrist else meet


def _sections(arm: NumericArm, joint: int) -> Iterable[tuple[Section, int]]:
    """The planes in which a point of an arm may be looked at."""
    q = samples(arm.chain)
    moving = [j for j in _moving(arm, joint) if arm.chain.turning[j - 1]]
    if not moving:
        return
    z = arm.axes(q)[0]
    upright = [are_parallel([*z[:, j - 1], UP]) for j in moving]
    if upright[0] and _is_fixed(arm, q, moving[0]) and (len(moving) == 1 or not all(upright)):
        yield Section.HALF_PLANE, moving[0]
    if all(upright):
        yield Section.ABOVE, 0


def _is_fixed(arm: NumericArm, q: FloatArray, joint: int) -> bool:
    """Whether an axis is always on one upright line."""
    at = arm.axes(q)[1][:, joint - 1, :2]
    return bool(np.abs(at - at[0]).max() < STILL * arm.chain.size)


def _moving(arm: NumericArm, joint: int) -> list[int]:
    """The joints, from 1, that move a point in space."""
    return _changing(arm, lambda q: _point(arm, q, joint))


def _movers(reach: Reach) -> tuple[int, ...]:
    return tuple(_changing(reach.arm, reach.coordinates))


def _changing(arm: NumericArm, of: Callable[[FloatArray], FloatArray]) -> list[int]:
    """The joints, from 1, on whose values something depends."""
    chain = arm.chain
    q = samples(chain)
    before = of(q)
    least = STILL * chain.size
    joints = range(1, chain.dof + 1)
    return [j for j in joints if np.abs(of(moved(chain, q, j)) - before).max() > least]


def moved(chain: Chain, q: FloatArray, joint: int) -> FloatArray:
    """Joint values (..., n) with one joint elsewhere."""
    there = q.copy()
    there[..., joint - 1] += STEP * (1.0 if chain.turning[joint - 1] else chain.size)
    return there


def _point(arm: NumericArm, q: FloatArray, joint: int) -> FloatArray:
    """The tool, or the origin of the frame that a joint moves in, at joint values (..., n)."""
    elements: list[FloatArray | int] = []
    for element in (*arm.elements, arm.tool):
        if isinstance(element, int) and element == joint:
            break
        elements.append(element)
    values = np.moveaxis(arm.values(q), -1, 0)
    x, y, z = np.zeros((3, *q.shape[:-1]))
    for element in reversed((arm.base, *elements)):
        if not isinstance(element, int):
            x, y, z = (row[0] * x + row[1] * y + row[2] * z + row[3] for row in element[:3])
        elif arm.turning[element - 1]:
            c, s = np.cos(values[element - 1]), np.sin(values[element - 1])
            x, y = c * x - s * y, s * x + c * y
        else:
            z = z + values[element - 1]
    return np.stack([x, y, z], axis=-1)


def samples(chain: Chain) -> FloatArray:
    """Some joint values, of which nothing is special, (SAMPLES, n)."""
    source = random.Random(2)  # noqa: S311 - for a picture, no secret
    scale = [math.pi if turns else chain.size for turns in chain.turning]
    return np.array([[source.uniform(-s, s) for s in scale] for _ in range(SAMPLES)])
