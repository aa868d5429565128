"""A second equation for an angle whose own degenerates at some places: over-determined tasks.

X s + Y c = 0 loses its digits where X and Y are small. Where a task asks for more than the arm can
choose there may be another such equation that keeps them: a point may lie on axis 1 while the tool
still leans to the side where the arm is. Where the pool has none, the moment of an axis may be one:
with z and p, columns 3 and 4 of a form of T, z x p is the moment of the line along z about the
frame's origin (J. Pluecker), and a slide along z is not in it.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import POSE_PLACES
from dhgen.kinematics.ring import substitute
from dhgen.kinematics.transform import compose
from dhgen.paul.common_zeros import outlasts
from dhgen.paul.equation import MOMENT, Equation, Origin, merged
from dhgen.paul.form_reader import FormReader
from dhgen.paul.kind import Kind
from dhgen.paul.knowledge import initial_knowledge
from dhgen.paul.mixed_forms import mixed_forms, right_inverse
from dhgen.paul.problem import Withheld
from dhgen.paul.step import View, learn, steps_of
from dhgen.paul.types.angle import Angle
from dhgen.paul.witness import build_witnesses

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.transform import Transform
    from dhgen.paul.pool import Pool, Vector
    from dhgen.paul.problem import Problem
    from dhgen.paul.step import Step


def with_fallback_equations(pool: Pool, steps: tuple[Step, ...]) -> tuple[Step, ...]:
    """The steps, with a second equation where the task has one and the first may degenerate.

    Only an over-determined task has any: else all equations for an angle vanish together.
    """
    if not pool.problem.overdetermined or not any(map(_is_homogeneous, steps)):
        return steps
    witnesses = build_witnesses(pool)
    equations = merged([*pool.equations, *_moments(pool.problem)])
    reader = FormReader(replace(pool, equations=equations))
    knowledge = initial_knowledge(pool.problem.algebra)
    found = []
    for step in steps:
        if _is_homogeneous(step):
            offers = _offers(reader, View(knowledge, witnesses))
            found.append(_completed(step, offers, pool))
        else:
            found.append(step)
        knowledge = learn(knowledge, step)
    return tuple(found)


def across(pool: Pool, step: Step) -> Polynomial:
    """Y s - X c in joint angles: with X s + Y c = 0 it vanishes where X and Y do."""
    angle = step.angle
    algebra = pool.problem.algebra
    s, c = algebra.generator(angle.sine), algebra.generator(angle.cosine)
    return _in_joints(pool, step.coefficient("Y") * s - step.coefficient("X") * c)


def _in_joints(pool: Pool, polynomial: Polynomial) -> Polynomial:
    """What a polynomial in entries of the pose is on solutions."""
    problem = pool.problem
    index = problem.algebra.index
    forward = {name: problem.forward.entry(*POSE_PLACES[name]) for name in sorted(problem.known)}
    for point in pool.points:
        forward |= zip(point.names, _place_of(problem, point.in_tool), strict=True)
    change = {index[name]: value for name, value in forward.items()}
    return problem.algebra.normal(substitute(polynomial, change))


def _place_of(problem: Problem, point: tuple[Polynomial, ...]) -> list[Polynomial]:
    """A point of the tool in the base."""
    forward = problem.forward
    return [
        sum((a * b for a, b in zip(row, point, strict=True)), start)
        for row, start in zip(forward.rotation, forward.translation, strict=True)
    ]


def _is_homogeneous(step: Step) -> bool:
    return step.kind is Kind.ANGLE and not step.coefficient("Z")


def _completed(step: Step, offers: Sequence[Step], pool: Pool) -> Step:
    """The step with the shortest of these that differs from zero where its own vanishes."""
    first = across(pool, step)
    alike = (offer for offer in offers if offer.unknowns == step.unknowns)
    for offer in alike:
        if outlasts(pool.problem.algebra, across(pool, offer), first):
            return replace(step, fallback=offer)
    return step


def _offers(reader: FormReader, view: View) -> list[Step]:
    """The equations that are of type 2 with Z = 0 in a state, shortest first."""
    angle = Angle()
    groups = [(form,) for form in reader.every(view.knowledge, 1)]
    steps = steps_of(angle.steps(group, view) for group in groups)
    return sorted(filter(_is_homogeneous, steps), key=lambda step: step.penalty)


def _moments(problem: Problem) -> Iterator[Equation]:
    """The elements of column 3 x column 4 of every form that the task gives."""
    algebra, dof = problem.algebra, len(problem.links)
    withheld = Withheld(problem)
    rights = [
        compose(problem.target, right_inverse(problem, k), algebra.normal) for k in range(dof + 1)
    ]
    for form in mixed_forms(problem, rights):
        sides = moment(form.known, algebra), moment(form.joints, algebra)
        for row, (left, right) in enumerate(zip(*sides, strict=True), start=1):
            origin = Origin(form.m, form.k, dof, row, MOMENT)
            if left != right and not withheld(right - left):
                yield Equation.at(origin, left, right)


def moment(frame: Transform, algebra: Algebra) -> Vector:
    """z x p of a frame."""
    (zx, zy, zz), (px, py, pz) = frame.column(2), frame.column(3)
    products = algebra.normal.products
    return (
        products(((1, zy, pz), (-1, zz, py))),
        products(((1, zz, px), (-1, zx, pz))),
        products(((1, zx, py), (-1, zy, px))),
    )
