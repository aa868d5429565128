"""What the arm angle fixes: the rotation of the shoulder, once the elbow's angle is known.

The line from shoulder to wrist and the side of it on which the elbow lies are known from the pose
and the arm angle; from frame 3, which the shoulder turns, both are seen by the elbow's angle alone.
So A_1 A_2 A_3 is known in its nine rotation entries.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.errors import UnsolvedError
from dhgen.kinematics.algebra import AngleSum
from dhgen.kinematics.arm_angle import is_planar, reference_axis, triangle
from dhgen.kinematics.chain import Turn
from dhgen.kinematics.neighbours import EXACT
from dhgen.kinematics.numeric import numeric_arm
from dhgen.kinematics.product import product
from dhgen.kinematics.ring import constant_value
from dhgen.kinematics.transform import dot
from dhgen.paul.mixed_forms import moving_parts, right_inverse

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Element
    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.transform import Transform
    from dhgen.paul.problem import Problem

    Vector = tuple[Polynomial, ...]

SHOULDER = 3  # joints before the elbow


@dataclass(frozen=True, slots=True)
class ArmPlane:
    """Shoulder, elbow and wrist, as the base, the tool and frame 3 see them.

    Attributes:
        shoulder_frame: The frame whose origin is the shoulder.
        wrist_frame: The frame whose origin is the wrist.
        shoulder: The shoulder in the base frame (constants).
        wrist_in_tool: The wrist in the frame of U_0 (constants).
        first: Direction of axis 1 in the base frame.
        reference: The axis of the base frame, from 0, that replaces the arm's line in the plane
            that angles count from where that line is on axis 1.
        fourth: Direction of axis 4 in frame 3.
        elbow: From the shoulder to the elbow in frame 3 (constants).
        wrist: From the shoulder to the wrist in frame 3; it depends on the elbow's angle.
        normal: wrist x elbow in frame 3.
        planar: Whether that is along axis 4 always, so that the arm can be straight.
        folds: Whether the wrist can come to the shoulder.
        area: Upper arm times forearm, both from the elbow.
        rotation: The rotation of A_1 A_2 A_3.
    """

    shoulder_frame: int
    wrist_frame: int
    shoulder: Vector
    wrist_in_tool: Vector
    first: Vector
    reference: int
    fourth: Vector
    elbow: Vector
    wrist: Vector
    normal: Vector
    planar: bool
    folds: bool
    area: float
    rotation: tuple[Vector, ...]

    @property
    def elbow_angle(self) -> AngleSum:
        """The angle of joint 4."""
        return AngleSum(((SHOULDER + 1, 1),))


def arm_plane(problem: Problem) -> ArmPlane:
    """What is seen of the arm's plane.

    Raises:
        UnsolvedError: No frame has its origin in the shoulder, or in the wrist.
    """
    return _Builder(problem).plane()


class _Builder:
    """Finds the frames with origins in shoulder and wrist, and what is seen from them."""

    def __init__(self, problem: Problem) -> None:
        self._problem = problem
        self._algebra = problem.algebra
        self._arm = numeric_arm(problem.algebra.chain)
        self._near = EXACT * problem.algebra.chain.size
        self._triangle = triangle(self._arm, np.zeros(problem.algebra.chain.dof))

    def plane(self) -> ArmPlane:
        algebra = self._algebra
        m, shoulder = self._shoulder()
        k, wrist_in_tool = self._wrist()
        home = self._seen_from_three(m)
        axis = self._before(self._problem.links[SHOULDER])
        before = self._before(self._problem.links[0])
        fourth = axis.column(2)
        there = self._problem.spans.product(SHOULDER, k).translation
        wrist = self._minus(there, home)
        start = self._minus(axis.translation, home)
        along = dot(fourth, start, algebra.normal)
        elbow = self._minus(start, tuple(algebra.normal(along * entry) for entry in fourth))
        return ArmPlane(
            shoulder_frame=m,
            wrist_frame=k,
            shoulder=shoulder,
            wrist_in_tool=wrist_in_tool,
            first=before.column(2),
            reference=reference_axis(self._arm),
            fourth=fourth,
            elbow=elbow,
            wrist=wrist,
            normal=tuple(
                algebra.normal(
                    wrist[(i + 1) % 3] * elbow[(i + 2) % 3]
                    - wrist[(i + 2) % 3] * elbow[(i + 1) % 3]
                )
                for i in range(3)
            ),
            planar=is_planar(self._arm),
            folds=self._folds(),
            area=self._length(elbow) * self._length(self._minus(wrist, elbow)),
            rotation=self._problem.spans.product(0, SHOULDER).rotation,
        )

    def _folds(self) -> bool:
        found = self._triangle
        arms = [np.linalg.norm(end - found.elbow) for end in (found.shoulder, found.wrist)]
        return is_planar(self._arm) and bool(abs(arms[0] - arms[1]) <= self._near)

    def _length(self, vector: Vector) -> float:
        return math.sqrt(constant_value(self._algebra, dot(vector, vector, self._algebra.normal)))

    def _shoulder(self) -> tuple[int, Vector]:
        """The frame whose origin is the shoulder, and where that is in the base."""
        back = np.linalg.inv(self._arm.base)
        wanted = back[:3, :3] @ self._triangle.shoulder + back[:3, 3]
        for m in range(SHOULDER + 1):
            origin = self._problem.spans.product(0, m).translation
            if self._is(origin, wanted) and self._are_constant(self._seen_from_three(m)):
                return m, origin
        raise UnsolvedError("no frame of the table has its origin where axes 1, 2 and 3 meet")

    def _wrist(self) -> tuple[int, Vector]:
        """The frame whose origin is the wrist, and where that is in the last frame."""
        tool = self._arm.pose(np.zeros(self._arm.chain.dof)) @ np.linalg.inv(self._arm.tool)
        back = np.linalg.inv(tool)
        wanted = back[:3, :3] @ self._triangle.wrist + back[:3, 3]
        for k in range(SHOULDER + 1, len(self._problem.links) + 1):
            origin = right_inverse(self._problem, k).translation
            there = self._problem.spans.product(SHOULDER, k).translation
            if self._is(origin, wanted) and moving_parts(self._algebra, there) == {"4"}:
                return k, origin
        raise UnsolvedError("no frame of the table has its origin where axes 5, 6 and 7 meet")

    def _seen_from_three(self, m: int) -> Vector:
        """The origin of frame m in frame 3."""
        return self._problem.spans.inverse(m, SHOULDER).translation

    def _before(self, link: tuple[Element, ...]) -> Transform:
        """The elements of a link before its joint."""
        fixed = []
        for element in link:
            if isinstance(element, Turn):
                break
            fixed.append(element)
        return product(fixed, self._algebra)

    def _is(self, origin: Vector, wanted: FloatArray) -> bool:
        if not self._are_constant(origin):
            return False
        place = np.array([constant_value(self._algebra, entry) for entry in origin])
        return bool(np.abs(place - wanted).max() <= self._near)

    def _are_constant(self, vector: Iterable[Polynomial]) -> bool:
        return all(self._algebra.is_constant(entry) for entry in vector)

    def _minus(self, left: Vector, right: Vector) -> Vector:
        pairs = zip(left, right, strict=True)
        return tuple(self._algebra.normal(a - b) for a, b in pairs)
