"""Equations of the shoulder where the caller gives the arm angle: it is a wrist of its own.

Once the elbow's angle is known A_1 A_2 A_3 = B is known in its nine rotation entries, with
B_m = (A_1 ... A_m)^-1 B for Paul's U_m: B_m (A_{k+1} ... A_3)^-1 = A_{m+1} ... A_k.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import SHOULDER_NAMES
from dhgen.kinematics.transform import Transform, compose
from dhgen.paul.arm_plane import SHOULDER, arm_plane
from dhgen.paul.equation import Equation, Origin, merged

if TYPE_CHECKING:
    from dhgen.paul.pool import Pool
    from dhgen.paul.problem import Problem


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
