"""The matrices of a derivation: A_i, T_i^0, and both sides of every mixed form of U_0.

A mixed form is (A_1 ... A_m)^-1 U_0 (A_{k+1} ... A_n)^-1 = A_{m+1} ... A_k; with k = n it is Paul's
U_m. An inverted form is (A_{k+1} ... A_n) U_0^-1 (A_1 ... A_m) = (A_{m+1} ... A_k)^-1; only its
column 4 is used.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import (
    inverse,
    link,
    product_of,
    shoulder_target,
    single,
    target,
)
from dhgen.derivation.text.formula import Element, Formula, Symbol, times
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import LATEX, PLAIN
from dhgen.kinematics.product import product
from dhgen.kinematics.ring import substitute
from dhgen.kinematics.transform import Transform, compose, translation
from dhgen.paul.arm_plane import SHOULDER
from dhgen.paul.equation import MOMENT
from dhgen.paul.further_forms import inverted_column, shoulder_side
from dhgen.paul.mixed_forms import right_inverse

if TYPE_CHECKING:
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.algebra import Algebra, AngleSum
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.equation import Matrix, Origin
    from dhgen.paul.pool import Pool


@dataclass(frozen=True, slots=True)
class Form:
    """One mixed form.

    Attributes:
        place: Which form. Of an inverted one only the translations are filled in, of the
            shoulder's only the rotations.
        left: The side with U_0; its origin by name when it is a named point.
        right: A_{m+1} ... A_k.
    """

    place: Matrix
    left: Transform
    right: Transform


def form_of(pool: Pool, place: Matrix) -> Form:
    """Both sides of a mixed form."""
    m, k, inverse, shoulder = place
    problem = pool.problem
    algebra = problem.algebra
    if inverse:
        left_column, right_column = inverted_column(pool, m, k)
        ring = algebra.ring
        return Form(place, translation(ring, left_column), translation(ring, right_column))
    joints = problem.spans.product(m, k)
    if shoulder:
        return Form(place, shoulder_side(problem, m, k), joints)
    moved = compose(problem.spans.inverse(0, m), _moved_right(pool, k), algebra.normal)
    return Form(place, moved, joints)


def _moved_right(pool: Pool, k: int) -> Transform:
    """U_0 (A_{k+1} ... A_n)^-1, its origin by name where the pool has one."""
    problem = pool.problem
    algebra = problem.algebra
    step = right_inverse(problem, k)
    moved = compose(problem.target, step, algebra.normal)
    for point in pool.points:
        if point.in_tool == step.translation:
            origin = tuple(
                algebra.generator(name) if len(entry) > 1 else entry
                for name, entry in zip(point.names, moved.translation, strict=True)
            )
            return Transform(moved.rotation, origin)
    return moved


def link_matrix(algebra: Algebra, number: int) -> Transform:
    """A_i of the chain, from 1."""
    return product(algebra.lifted(algebra.chain.links[number - 1]), algebra)


def forward_of(algebra: Algebra, number: int) -> Transform:
    """T_i^0 = A_1 ... A_i, without base and tool."""
    elements = [e for link in algebra.chain.links[:number] for e in algebra.lifted(link)]
    return product(elements, algebra)


def left_name(place: Matrix, dof: int) -> Formula:
    """U_m, U_m A_n^-1 ... A_{k+1}^-1, or A_{k+1} ... A_n U_0^-1 A_1 ... A_m; B_m for a shoulder."""
    m, k, inverted, shoulder = place
    if inverted:
        after, before = (map(link, numbers) for numbers in (range(k + 1, dof + 1), range(1, m + 1)))
        return times(*after, inverse(target(0)), *before)
    last = SHOULDER if shoulder else dof
    back = [inverse(link(number)) for number in range(last, k, -1)]
    return times(shoulder_target(m) if shoulder else target(m), *back)


def known_matrix(place: Matrix) -> Formula:
    """U_0, or B_0 for a shoulder."""
    return shoulder_target(0) if place[3] else target(0)


def middle_name(place: Matrix) -> Formula:
    """A_{m+1} ... A_k, or its inverse."""
    m, k, inverted, _ = place
    if inverted:
        return times(*(inverse(link(number)) for number in range(k, m, -1)))
    return product_of(range(m + 1, k + 1))


def sides(form: Form, row: int, column: int) -> tuple[Polynomial, Polynomial]:
    """An element of both sides, row and column from 1: the side with U_0, then the joints'."""
    return form.left.entry(row - 1, column - 1), form.right.entry(row - 1, column - 1)


def element_of(origin: Origin, matrix: Formula | None = None) -> Formula:
    """U_1[2,4], the squared length of a column 4, or an element of column 3 x column 4."""
    name = left_name(origin.matrix, origin.dof) if matrix is None else matrix
    latex, plain = show(name, LATEX), show(name, PLAIN)
    if origin.row == 0:
        return Symbol(rf"\lVert {latex}[\cdot,4] \rVert^2", f"‖{plain}[·,4]‖²")
    if origin.column == MOMENT:
        return Symbol(
            rf"({latex}[\cdot,3] \times {latex}[\cdot,4])[{origin.row}]",
            f"({plain}[·,3] × {plain}[·,4])[{origin.row}]",
        )
    return Element(name, origin.row, origin.column)


def expanded(algebra: Algebra, polynomial: Polynomial) -> Polynomial:
    """The polynomial with cosines and sines of single joints only."""
    change: dict[int, Polynomial] = {}
    for angle in algebra.angles:
        if len(angle.terms) > 1:
            cosine, sine = of_single(algebra, angle)
            change[algebra.index[angle.cosine]] = cosine
            change[algebra.index[angle.sine]] = sine
    return algebra.normal(substitute(polynomial, change)) if change else polynomial


def of_single(algebra: Algebra, angle: AngleSum) -> tuple[Polynomial, Polynomial]:
    """Cosine and sine of an angle sum by its joints' cosines and sines."""
    cosine, sine = algebra.ring.one, algebra.ring.zero
    for joint, sign in angle.terms:
        c = algebra.generator(single(joint).cosine)
        s = sign * algebra.generator(single(joint).sine)
        cosine, sine = cosine * c - sine * s, sine * c + cosine * s
    return cosine, sine
