"""Equations beyond the mixed forms: seen from the tool, and of the shoulder.

Column 4 of inverted mixed forms looks from the tool back to the base,
(A_{k+1} ... A_n) U_0^-1 (A_1 ... A_m) = (A_{m+1} ... A_k)^-1. Rotations hold nothing new, but this
column holds the place of frame m seen from frame k. An arm whose first axes meet in one point, or
are parallel, is an arm with a wrist seen from the other end (D. L. Pieper, 1968): these equations
are to it what the others are to a wrist.

Where the caller gives the arm angle the shoulder is a wrist of its own. Once the elbow's angle is
known A_1 A_2 A_3 = B is known in its nine rotation entries, with B_m = (A_1 ... A_m)^-1 B for
Paul's U_m: B_m (A_{k+1} ... A_3)^-1 = A_{m+1} ... A_k.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import POSE_NAMES, SHOULDER_NAMES
from dhgen.kinematics.transform import Transform, compose, dot
from dhgen.paul.arm_plane import SHOULDER, arm_plane
from dhgen.paul.equation import Equation, Origin, merged
from dhgen.paul.mixed_forms import may_help, moving_parts, right_inverse
from dhgen.paul.pool import BasePoint, Pool

if TYPE_CHECKING:
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.pool import Vector
    from dhgen.paul.problem import Problem


MOST_JOINTS = 2  # on the side of U_0, or else nothing can be eliminated


def inverted_column(pool: Pool, m: int, k: int) -> tuple[Vector, Vector]:
    """Both sides of column 4 of an inverted form, points by their names."""
    view = _View(pool)
    view.points.extend(pool.base_points)
    return view.column(m, k)


def with_inverse_forms(pool: Pool) -> Pool:
    """The pool and the inverted forms; the pool alone where the task does not give a whole pose."""
    problem = pool.problem
    names = {s.name for s in problem.algebra.ring.symbols[: len(POSE_NAMES)]}
    used = {name for name in names if _holds(problem, name)}
    if not used <= problem.known:
        return pool
    view = _View(pool)
    equations = [*pool.equations, *view.equations()]
    return Pool(problem, merged(equations), pool.points, tuple(view.points), pool.plane)


def _holds(problem: Problem, name: str) -> bool:
    """Whether U_0 holds an entry of the pose."""
    place = problem.algebra.index[name]
    entries = [entry for row in problem.target.rotation for entry in row]
    return any(m[place] for entry in (*entries, *problem.target.translation) for m in entry)


class _View:
    """The base as the tool sees it."""

    def __init__(self, pool: Pool) -> None:
        self._problem = pool.problem
        self._algebra = pool.problem.algebra
        self._dof = len(pool.problem.links)
        self._taken = len(pool.points)
        self.points: list[BasePoint] = []

    def equations(self) -> list[Equation]:
        """Column 4 of every inverted form that holds few enough joints, and squared lengths."""
        found: list[Equation] = []
        for m in range(self._dof):
            moving = moving_parts(self._algebra, self._reached(m))
            if len(moving) > 1:
                continue
            for k in range(self._dof, m, -1):
                left, right = self.column(m, k)
                for row, (a, b) in enumerate(zip(left, right, strict=True), start=1):
                    origin = Origin(m, k, self._dof, row, 4, inverse=True)
                    found.append(Equation.at(origin, a, b))
                if not moving:
                    found += self._squared_length(m, k, right)
        return [e for e in found if e.difference and self._is_short(e.left)]

    def column(self, m: int, k: int) -> tuple[Vector, Vector]:
        """Frame m as seen from frame k: through U_0, and through the links between."""
        spans = self._problem.spans
        seen = self._seen_from_tool(self._reached(m))
        back, right = spans.product(k, self._dof), spans.inverse(m, k).translation
        return _applied(back, seen, self._algebra), right

    def _reached(self, m: int) -> Vector:
        """The origin of frame m in the base."""
        return self._problem.spans.product(0, m).translation

    def _seen_from_tool(self, point: Vector) -> Vector:
        """R' (b - t), by names where b is fixed in the base and for b = 0."""
        algebra, target = self._algebra, self._problem.target
        turned = _transposed(target, point, algebra)
        home = self._named(tuple(algebra.ring.zero for _ in range(3)))
        if not any(point):
            return home
        if not moving_parts(algebra, point):
            return self._named(point)
        x, y, z = (a + b for a, b in zip(turned, home, strict=True))
        return x, y, z

    def _named(self, point: tuple[Polynomial, ...]) -> Vector:
        algebra, target = self._algebra, self._problem.target
        x, y, z = point
        offset = tuple(b - t for b, t in zip(point, target.translation, strict=True))
        seen = _transposed(target, offset, algebra)
        known = next((p for p in self.points if p.in_base == (x, y, z)), None)
        if known is None:
            known = BasePoint(algebra.points[self._taken + len(self.points)], (x, y, z))
            self.points.append(known)
        u, v, w = (
            algebra.generator(name) if len(entry) > 1 else entry
            for name, entry in zip(known.names, seen, strict=True)
        )
        return u, v, w

    def _squared_length(self, m: int, k: int, right: Vector) -> list[Equation]:
        """|v - o|^2 with o the origin of frame k in the tool."""
        if not may_help(self._problem, m, k):
            return []
        origin = Origin(m, k, self._dof, 0, 4, inverse=True)
        normal = self._algebra.normal
        seen = self._seen_from_tool(self._reached(m))
        o = right_inverse(self._problem, k).translation
        first = dot(seen, seen, normal) + dot(o, o, normal) - 2 * dot(seen, o, normal)
        second = dot(right, right, normal)
        return [Equation.at(origin, first, second)]

    def _is_short(self, left: Polynomial) -> bool:
        return len(moving_parts(self._algebra, (left,))) <= MOST_JOINTS


def _transposed(target: Transform, vector: tuple[Polynomial, ...], algebra: Algebra) -> Vector:
    """R' v."""
    x, y, z = (dot(target.column(place), vector, algebra.normal) for place in range(3))
    return x, y, z


def _applied(transform: Transform, point: Vector, algebra: Algebra) -> Vector:
    """A point transformed."""
    x, y, z = (
        algebra.normal(dot(row, point, algebra.normal) + start)
        for row, start in zip(transform.rotation, transform.translation, strict=True)
    )
    return x, y, z


def with_arm_plane(pool: Pool) -> Pool:
    """The pool with the equations of the shoulder.

    Raises:
        UnsolvedError: No frame has its origin in the shoulder, or in the wrist.
    """
    problem = pool.problem
    plane = arm_plane(problem)
    equations = list(pool.equations)
    for k in range(SHOULDER, 0, -1):
        for m in range(k):
            left = shoulder_side(problem, m, k)
            right = problem.spans.product(m, k)
            for row in range(3):
                for column in range(3):
                    origin = Origin(m, k, SHOULDER, row + 1, column + 1, shoulder=True)
                    a, b = left.entry(row, column), right.entry(row, column)
                    equations.append(Equation.at(origin, a, b))
    usable = (equation for equation in equations if equation.difference)
    return replace(pool, equations=merged(usable), plane=plane)


def shoulder_side(problem: Problem, m: int, k: int) -> Transform:
    """(A_1 ... A_m)^-1 B (A_{k+1} ... A_3)^-1, without a translation."""
    algebra = problem.algebra
    nowhere = (algebra.ring.zero,) * 3
    total = Transform(
        tuple(tuple(algebra.generator(name) for name in row) for row in SHOULDER_NAMES), nowhere
    )
    before, after = (problem.spans.inverse(*ends).rotation for ends in ((0, m), (k, SHOULDER)))
    total = compose(Transform(before, nowhere), total, algebra.normal)
    return compose(total, Transform(after, nowhere), algebra.normal)
