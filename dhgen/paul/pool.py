"""The pool of equations: every mixed form of T, entry by entry, and squared distances of origins.

Each equation is kept with the elements that it comes from.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.kinematics.transform import Transform, compose, dot
from dhgen.paul.equation import Equation, Origin, merged
from dhgen.paul.mixed_forms import may_help, mixed_forms, right_inverse, right_joints
from dhgen.paul.problem import Withheld

if TYPE_CHECKING:
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.arm_plane import ArmPlane
    from dhgen.paul.mixed_forms import MixedForm
    from dhgen.paul.problem import Problem

Vector = tuple["Polynomial", "Polynomial", "Polynomial"]


@dataclass(frozen=True, slots=True)
class Point:
    """A point of the last links whose place is known from the pose alone, e.g. the wrist centre.

    Attributes:
        names: Generators of its coordinates in the base frame.
        in_tool: Its coordinates in the frame of U_0 (constants).
    """

    names: tuple[str, str, str]
    in_tool: Vector


@dataclass(frozen=True, slots=True)
class BasePoint:
    """A point of the base whose place in the tool is known from the pose, e.g. a shoulder.

    Attributes:
        names: Generators of its coordinates in the frame of U_0.
        in_base: Its coordinates in the base frame (constants).
    """

    names: tuple[str, str, str]
    in_base: Vector


@dataclass(frozen=True, slots=True)
class Pool:
    """All equations of a problem.

    Attributes:
        problem: What is asked.
        equations: In the order m, k descending, column 4 first.
        points: Points with names of their own.
        base_points: The same for points of the base seen from the tool.
        plane: Where the caller gives the arm angle: what it fixes.
    """

    problem: Problem
    equations: tuple[Equation, ...]
    points: tuple[Point, ...]
    base_points: tuple[BasePoint, ...] = ()
    plane: ArmPlane | None = None


def build_pool(problem: Problem) -> Pool:
    """Every usable equation of the problem."""
    dof = len(problem.links)
    points: list[Point] = []
    steps = [right_inverse(problem, k) for k in range(dof + 1)]
    rights = [_moved_right(problem, step, points) for step in steps]
    equations: list[Equation] = []
    for form in mixed_forms(problem, rights):
        equations += _entries(form, dof)
        origin = Origin(form.m, form.k, dof, 0, 4)
        factors = form.moved, rights[form.k]
        equations += _squared_length(problem, origin, factors, steps[form.k], form.joints)
    withheld = Withheld(problem)
    usable = (e for e in equations if e.difference and not withheld(e.difference))
    return Pool(problem, merged(usable), tuple(points))


def _moved_right(problem: Problem, step: Transform, points: list[Point]) -> Transform:
    """U_0 (A_{k+1} ... A_n)^-1, its origin by name when it is a known point."""
    algebra = problem.algebra
    moved = compose(problem.target, step, algebra.normal)
    in_tool = step.translation
    hidden = any(map(Withheld(problem), moved.translation))
    if hidden or not any(in_tool) or not all(map(algebra.is_constant, in_tool)):
        return moved
    for point in points:
        if point.in_tool == in_tool:
            break
    else:
        point = Point(algebra.points[len(points)], in_tool)
        points.append(point)
    origin = tuple(
        algebra.generator(name) if len(entry) > 1 else entry
        for name, entry in zip(point.names, moved.translation, strict=True)
    )
    return Transform(moved.rotation, origin)


def _entries(form: MixedForm, dof: int) -> list[Equation]:
    return [
        Equation.at(
            Origin(form.m, form.k, dof, row + 1, column + 1),
            form.known.entry(row, column),
            form.joints.entry(row, column),
        )
        for column in (3, 2, 1, 0)
        for row in range(3)
    ]


def _squared_length(
    problem: Problem,
    origin: Origin,
    factors: tuple[Transform, Transform],
    step: Transform,
    right: Transform,
) -> list[Equation]:
    """The squared distance between the origins of frames m and k.

    The side with U_0 is [R | t] [S | u], where u is a known point: |t|^2 + |u|^2 + 2 (R' t).u, with
    fewer products than the square of the whole. With v the origin of frame k in the tool, which may
    depend on one joint, the known side of the form m = 0 is |v|^2 + |t|^2 + 2 v.(R' t), where
    U_0 = [R | t]: the rows of R are unit vectors, and products of its entries would not show that.
    """
    normal = problem.algebra.normal
    joints = right_joints(problem, origin.k, step.translation)
    if len(joints) > 1 or (joints and origin.m > 0):
        return []
    if not may_help(problem, origin.m, origin.k):
        return []
    second = dot(right.translation, right.translation, normal)
    before, point = (problem.target, step) if joints else factors
    t, v = before.translation, point.translation
    turned = [dot(column, t, normal) for column in zip(*before.rotation, strict=True)]
    first = dot(t, t, normal) + dot(v, v, normal) + 2 * dot(turned, v, normal)
    return [Equation.at(origin, first, second)]
