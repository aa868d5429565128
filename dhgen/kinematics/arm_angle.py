"""The arm angle: where the elbow of an arm of seven joints is on its circle.

Axes 1, 2, 3 meet in the shoulder S, axes 5, 6, 7 in the wrist W. With the hand held, the elbow E,
the point of axis 4 nearest to S, can still move on a circle about the line from S to W. Its angle
is counted from the plane of that line and axis 1: zero where the elbow leans towards z of axis 1
(M. Shimizu, H. Kakuya, W.-K. Yoon, K. Kitagaki, K. Kosuge, Analytical inverse kinematic computation
for 7-DOF redundant manipulators with joint limits, IEEE Transactions on Robotics 24, 2008).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.errors import UnsolvedError
from dhgen.kinematics.neighbours import EXACT, axis_triples, missed_point
from dhgen.kinematics.numeric import numeric_arm
from dhgen.robot.robot import JointKind
from dhgen.robot.task import ARM_ANGLE_JOINTS, TaskKind

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.numeric import NumericArm


ELBOW = 4  # its axis


@dataclass(frozen=True, slots=True)
class Triangle:
    """Shoulder, elbow and wrist in the caller's frame.

    Attributes:
        shoulder: Where axes 1, 2 and 3 meet, (..., 3).
        elbow: The point of axis 4 nearest to it, (..., 3).
        wrist: Where axes 5, 6 and 7 meet, (..., 3).
        first: Direction of axis 1, (..., 3).
        fourth: Direction of axis 4, (..., 3).
    """

    shoulder: FloatArray
    elbow: FloatArray
    wrist: FloatArray
    first: FloatArray
    fourth: FloatArray

    @property
    def side(self) -> FloatArray:
        """On which side of the arm the elbow is, as axis 4 sees it: zero for a stretched arm."""
        across = np.cross(self.wrist - self.shoulder, self.elbow - self.shoulder)
        return np.asarray(np.sum(across * self.fourth, axis=-1))

    @property
    def lean(self) -> FloatArray:
        """Wrist from elbow along axis 4: zero where a stretched arm is straight."""
        return np.asarray(np.sum((self.wrist - self.elbow) * self.fourth, axis=-1))


def triangle(arm: NumericArm, q: FloatArray) -> Triangle:
    """Shoulder, elbow and wrist at joint values (..., 7)."""
    z, p = arm.axes(q)
    shoulder = _meeting(z, p, 0, 1)
    along = np.sum((shoulder - p[..., 3, :]) * z[..., 3, :], axis=-1, keepdims=True)
    elbow = p[..., 3, :] + along * z[..., 3, :]
    return Triangle(shoulder, elbow, _meeting(z, p, 4, 5), z[..., 0, :], z[..., 3, :])


def _meeting(z: FloatArray, p: FloatArray, one: int, other: int) -> FloatArray:
    """The point of an axis nearest to another that is not parallel to it."""
    normal = np.cross(z[..., one, :], z[..., other, :])
    reach = np.cross(p[..., other, :] - p[..., one, :], z[..., other, :])
    along = np.sum(reach * normal, axis=-1) / np.sum(normal * normal, axis=-1)
    return np.asarray(p[..., one, :] + along[..., None] * z[..., one, :])


def arm_angles(arm: NumericArm, q: FloatArray, *, aside: float, merge: float) -> FloatArray:
    """The arm angle of joint values (..., 7), in (-pi, pi].

    Args:
        arm: The arm.
        q: Joint values.
        aside: Sine of the angle between the arm's line and axis 1 up to which the plane that
            angles count from is the one of axis 1 and x of the base frame.
        merge: What merges the two angles of an elbow: an arm that is as good as stretched.
    """
    found = triangle(arm, np.asarray(q, np.float64))
    w, e = found.wrist - found.shoulder, found.elbow - found.shoulder
    a, b = _base_plane(arm, w, found.first, aside)
    normal = np.cross(w, e)
    if is_planar(arm):
        area = _norm(e) * _norm(found.wrist - found.elbow)
        straight = straight_side(arm.chain.size, 1.0, merge) * np.sqrt(area[..., 0])
        behind = found.side < -straight
        normal = np.where(behind[..., None], -found.fourth, found.fourth)
    u = np.cross(normal, w)
    sine, cosine = _norm(w)[..., 0] * np.sum(u * b, axis=-1), np.sum(u * a, axis=-1)
    return np.asarray(np.arctan2(sine, cosine))


def straight_side(size: float, area: float, merge: float) -> float:
    """The side of an elbow below which its two angles may be merged: the arm is straight there.

    They are merged nearer than d = merge * size to the longest reach L: for sides below the root of
    2 L d A, where A is upper arm times forearm. L is the size at most. A half more in the square is
    beyond what rounding adds to a pose.
    """
    return math.sqrt(3.0 * merge * area) * size


def elbow_rates(arm: NumericArm, q: FloatArray) -> FloatArray:
    """How fast the elbow leaves the arm's plane with every joint [arm sizes], (..., 7)."""
    found = triangle(arm, q)
    normal = np.cross(found.wrist - found.shoulder, found.elbow - found.shoulder)
    length = _norm(normal)
    normal = np.where(length > 0.0, normal / np.where(length > 0.0, length, 1.0), found.fourth)
    z, p = arm.axes(q)
    reach = found.elbow[..., None, :] - p
    rates = np.sum(np.cross(z, reach) * normal[..., None, :], axis=-1) / arm.chain.size
    signs = [joint.sign * (joint.number < ELBOW) for joint in arm.chain.joints]
    return np.asarray(rates * signs)


def plane_miss(
    arm: NumericArm, T: FloatArray, psi: float, q: FloatArray, aside: float
) -> tuple[FloatArray, FloatArray]:
    """By how much the elbow's plane misses an arm angle, and how fast the joints turn it.

    The plane is turned about the line from the shoulder to the wrist of a pose, by joints before
    the elbow. Of a planar arm both sides of the line are taken for one.

    Args:
        arm: The arm.
        T: Pose (4, 4).
        psi: The arm angle [rad].
        q: Joint values (..., 7).
        aside: As for `arm_angles`.

    Returns:
        The miss (...), in (-pi, pi], or (-pi/2, pi/2] of a planar arm, and the rates (..., 7).
    """
    found, planar = triangle(arm, q), is_planar(arm)
    wrist = T[:3, :3] @ wrist_in_tool(arm) + T[:3, 3]
    w, e = wrist - found.shoulder, found.elbow - found.shoulder
    normal = found.fourth if planar else np.cross(w, e)
    a, b = _base_plane(arm, w, found.first, aside)
    reach, u = _norm(w), np.cross(normal, w)
    sine, cosine = reach[..., 0] * np.sum(u * b, axis=-1), np.sum(u * a, axis=-1)
    times = 2.0 if planar else 1.0
    off = times * (psi - np.arctan2(sine, cosine))
    miss = (off - 2 * np.pi * np.ceil(off / (2 * np.pi) - 0.5)) / times
    about = w / np.where(reach > 0.0, reach, 1.0)
    if not planar:
        along, square = (np.sum(e * x, axis=-1, keepdims=True) for x in (about, e))
        about = (about * square - e * along) / (square - along * along)
    z, _ = arm.axes(q)
    signs = [joint.sign * (joint.number < ELBOW) for joint in arm.chain.joints]
    rates = np.sum(z * about[..., None, :], axis=-1) * signs
    return np.where(reach[..., 0] > aside * arm.chain.size, miss, 0.0), rates


def wrist_in_tool(arm: NumericArm) -> FloatArray:
    """Where the tool's frame sees the wrist, (3,)."""
    home = np.zeros(arm.chain.dof)
    return np.asarray(np.linalg.solve(arm.pose(home), [*triangle(arm, home).wrist, 1.0])[:3])


def _base_plane(
    arm: NumericArm, w: FloatArray, first: FloatArray, aside: float
) -> tuple[FloatArray, FloatArray]:
    """Where the plane of axis 1 and the arm's line points to, times the line, and across it."""
    reference = np.cross(w, first)
    length = _norm(reference)
    y = np.cross(first, arm.base[:3, reference_axis(arm)])
    unit = reference / np.where(length > 0.0, length, 1.0)
    b = np.where(length <= aside * _norm(w), y, unit)
    return np.cross(b, w), b


def reference_axis(arm: NumericArm) -> int:
    """The axis of the base frame that replaces the arm's line where that is on axis 1.

    It is x (0), or y (1) where axis 1 points along x.
    """
    found = triangle(arm, np.zeros(arm.chain.dof))
    return int(_norm(np.cross(found.first, arm.base[:3, 0]))[0] <= EXACT)


def is_planar(arm: NumericArm) -> bool:
    """Whether shoulder, elbow and wrist lie in a plane across axis 4, so that they can align."""
    lean = triangle(arm, np.zeros(arm.chain.dof)).lean
    return bool(abs(lean) <= EXACT * arm.chain.size)


def _norm(vector: FloatArray) -> FloatArray:
    return np.asarray(np.linalg.norm(vector, axis=-1, keepdims=True))


TRIPLES = {(1, 2, 3): "shoulder", (5, 6, 7): "wrist"}


def demand_arm_angle(chain: Chain) -> None:
    """Refuses arms without an arm angle.

    Raises:
        UnsolvedError: The arm has none; the text names what it lacks.
    """
    reasons = why_no_arm_angle(chain)
    if reasons:
        head = "free: arm_angle is for arms of seven joints with a shoulder, a wrist and an elbow:"
        raise UnsolvedError("\n".join([head, *(f"  {reason}" for reason in reasons)]))


def why_no_arm_angle(chain: Chain) -> list[str]:
    """What an arm lacks for an arm angle; nothing if it has one."""
    return _whole(chain) or _geometry(chain)


def _whole(chain: Chain) -> list[str]:
    """What the arm lacks before its geometry is looked at."""
    kinds = {joint.kind for joint in chain.joints}
    if chain.dof != ARM_ANGLE_JOINTS:
        return [f"this one has {chain.dof} joint{'s' if chain.dof > 1 else ''}"]
    if kinds != {JointKind.REVOLUTE}:
        return ["not all of its joints are revolute"]
    if chain.task.kind is not TaskKind.POSE:
        return ["the task must be a whole pose"]
    return []


def _geometry(chain: Chain) -> list[str]:
    triples = {triple.joints: triple for triple in axis_triples(chain)}
    reasons = []
    for joints, name in TRIPLES.items():
        triple = triples[joints]
        if np.isinf(triple.miss):
            axes = ", ".join(map(str, joints))
            reasons.append(f"two of axes {axes} are parallel: there is no {name}")
        elif triple.miss > EXACT * chain.size:
            reasons.append(f"{missed_point(triple)}: there is no {name}")
    return reasons or _elbow(chain)


def _elbow(chain: Chain) -> list[str]:
    """What is wrong with axis 4 between a shoulder and a wrist."""
    found = triangle(numeric_arm(chain), np.zeros(chain.dof))
    least = EXACT * chain.size
    across = np.cross(found.wrist - found.elbow, found.fourth)
    ends = {
        "shoulder": np.linalg.norm(found.elbow - found.shoulder),
        "wrist": np.linalg.norm(across),
    }
    return [
        f"axis 4 passes through the {name}: there is no elbow"
        for name, length in ends.items()
        if length <= least
    ]
