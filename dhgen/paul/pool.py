"""The pool of equations: every mixed form of T, kept with the element it comes from.

(A_1 ... A_m)^-1 U_0 (A_{k+1} ... A_n)^-1 = A_{m+1} ... A_k, entry by entry, and the squared
distance of the origins. With k = n these are the rows of Paul's U_m; the other forms are needed
where a wrist has no common centre (UR5).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import product as product_of
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import POINT_NAMES, POSE_NAMES
from dhgen.kinematics.transform import Transform, compose, dot

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator, Sequence

    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.arm_plane import ArmPlane
    from dhgen.paul.problem import Problem

Vector = tuple["Polynomial", "Polynomial", "Polynomial"]
Matrix = tuple[int, int, bool, bool]  # m, k, inverse, shoulder: which form it is
Line = tuple[Matrix, str, int]  # of which matrix, "row" or "column", its number

MOMENT = 0  # in place of a column: column 3 x column 4
MOST_SQUARED = 4  # angles and lengths in a squared distance: with more it comes too late to help


@dataclass(frozen=True, slots=True, order=True)
class Origin:
    """Where an equation stands.

    Attributes:
        m: Joints moved from the left: (A_1 ... A_m)^-1.
        k: Joints moved from the right begin at k + 1: (A_{k+1} ... A_n)^-1.
        dof: n.
        row: From 1; 0 for the squared length of column 4.
        column: From 1 to 4; `MOMENT` for an element of column 3 x column 4.
        inverse: Whether it stands in the inverted form (A_{k+1} ... A_n) U_0^-1 (A_1 ... A_m).
        shoulder: Whether the rotation B of the joints before the elbow, which the arm angle gives,
            stands for U_0; then n is their number.
    """

    m: int
    k: int
    dof: int
    row: int
    column: int
    inverse: bool = False
    shoulder: bool = False

    @property
    def matrix(self) -> Matrix:
        """Which of the forms it stands in."""
        return self.m, self.k, self.inverse, self.shoulder

    @property
    def is_mixed(self) -> bool:
        """Whether it stands in none of Paul's U_m: joints were moved from the right too."""
        return self.inverse or self.k < self.dof

    @property
    def name(self) -> str:
        """How a message calls the place: U2[3, 4], or U1 (A5 A6)^-1 [3, 4] for a mixed form."""
        moved = " ".join(f"A{joint}" for joint in range(self.k + 1, self.dof + 1))
        matrix = f"B{self.m}" if self.shoulder else f"U{self.m}"
        if self.inverse:
            before = " ".join(f"A{joint}" for joint in range(1, self.m + 1))
            matrix = f"{moved} U0^-1 {before}".strip() + " "
        elif self.is_mixed:
            matrix += f" ({moved})^-1 " if self.k + 1 < self.dof else f" {moved}^-1 "
        if self.row == 0:
            return f"the squared length of column 4 of {matrix.rstrip()}"
        if self.column == MOMENT:
            return f"{matrix}[3] x {matrix}[4], element {self.row}"
        return f"{matrix}[{self.row}, {self.column}]"


@dataclass(frozen=True, slots=True)
class Equation:
    """left = right, with right - left in normal form.

    Attributes:
        origin: Which element of which form.
        origins: All elements that give the same equation, `origin` first.
        left: The side with U_0.
        right: The entry of A_{m+1} ... A_k.
        difference: right - left.
    """

    origin: Origin
    origins: tuple[Origin, ...]
    left: Polynomial
    right: Polynomial
    difference: Polynomial

    @property
    def lines(self) -> frozenset[Line]:
        """The columns and rows in which the equation stands."""
        places = [o for o in self.origins if o.row]
        columns = {(o.matrix, "column", o.column) for o in places}
        return frozenset(columns | {(o.matrix, "row", o.row) for o in places})


def common_origins(equations: Sequence[Equation]) -> tuple[Origin, ...]:
    """Where equations stand side by side: one element each, in one column or row of one form.

    Empty when there is no such line. Paul's U_m come before mixed forms, and among them those
    with the fewest joints moved.
    """
    places = product_of(*(equation.origins for equation in equations))
    return min(filter(_in_line, places), key=_readability, default=())


def _in_line(origins: tuple[Origin, ...]) -> bool:
    if len(origins) == 1:
        return True
    one_form = len({origin.matrix for origin in origins}) == 1
    one_column = len({origin.column for origin in origins}) == 1
    one_row = len({origin.row for origin in origins}) == 1
    return one_form and (one_column or one_row) and all(origin.row for origin in origins)


def _readability(origins: tuple[Origin, ...]) -> tuple[bool, bool, int, int]:
    first = origins[0]
    return first.inverse, first.is_mixed, first.m, -first.k


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


@dataclass(frozen=True, slots=True)
class MixedForm:
    """(A_1 ... A_m)^-1 U_0 (A_{k+1} ... A_n)^-1 = A_{m+1} ... A_k.

    Attributes:
        m: Joints moved from the left.
        k: Joints moved from the right begin at k + 1.
        moved: (A_1 ... A_m)^-1.
        known: The side with U_0.
        joints: The other side.
    """

    m: int
    k: int
    moved: Transform
    known: Transform
    joints: Transform


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


def mixed_forms(problem: Problem, rights: Sequence[Transform]) -> Iterator[MixedForm]:
    """Every mixed form, m ascending and k descending.

    Args:
        problem: What is asked.
        rights: U_0 (A_{k+1} ... A_n)^-1 for k = 0 ... n.
    """
    algebra, links, spans = problem.algebra, problem.links, problem.spans
    for m in range(len(links)):
        left = spans.inverse(0, m)
        for k in range(len(links), m, -1):
            known = compose(left, rights[k], algebra.normal)
            yield MixedForm(m, k, left, known, spans.product(m, k))


def merged(equations: Iterable[Equation]) -> tuple[Equation, ...]:
    """Each equation once, whatever its sign, with all places where it stands."""
    merged: dict[Polynomial, Equation] = {}
    for equation in equations:
        key = equation.difference if equation.difference in merged else -equation.difference
        if key in merged:
            first = merged[key]
            merged[key] = replace(first, origins=(*first.origins, equation.origin))
        else:
            merged[equation.difference] = equation
    return tuple(merged.values())


def right_inverse(problem: Problem, k: int) -> Transform:
    """(A_{k+1} ... A_n)^-1: frame k seen from the last one."""
    return problem.spans.inverse(k, len(problem.links))


def _moved_right(problem: Problem, step: Transform, points: list[Point]) -> Transform:
    """U_0 (A_{k+1} ... A_n)^-1, its origin by name when it is a known point."""
    algebra = problem.algebra
    moved = compose(problem.target, step, algebra.normal)
    in_tool = step.translation
    hidden = any(map(Withheld(problem), moved.translation))
    if hidden or not any(in_tool) or any(_uses_joints(problem, entry) for entry in in_tool):
        return moved
    for point in points:
        if point.in_tool == in_tool:
            break
    else:
        names = POINT_NAMES[3 * len(points) : 3 * len(points) + 3]
        point = Point((names[0], names[1], names[2]), in_tool)
        points.append(point)
    origin = tuple(
        algebra.generator(name) if len(entry) > 1 else entry
        for name, entry in zip(point.names, moved.translation, strict=True)
    )
    return Transform(moved.rotation, origin)


def _uses_joints(problem: Problem, entry: Polynomial) -> bool:
    algebra = problem.algebra
    joint = [algebra.index[name] for a in algebra.angles for name in (a.cosine, a.sine)]
    joint += [algebra.index[name] for name in algebra.slides.values()]
    return any(monomial[place] for monomial in entry for place in joint)


def _entries(form: MixedForm, dof: int) -> list[Equation]:
    return [
        _equation(
            Origin(form.m, form.k, dof, row + 1, column + 1),
            form.known.entry(row, column),
            form.joints.entry(row, column),
        )
        for column in (3, 2, 1, 0)
        for row in range(3)
    ]


def _equation(origin: Origin, left: Polynomial, right: Polynomial) -> Equation:
    return Equation(origin, (origin,), left, right, right - left)


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
    joints = _right_joints(problem, origin.k, step.translation)
    if len(joints) > 1 or (joints and origin.m > 0):
        return []
    if not may_help(problem, origin):
        return []
    second = dot(right.translation, right.translation, normal)
    before, point = (problem.target, step) if joints else factors
    t, v = before.translation, point.translation
    turned = [dot(column, t, normal) for column in zip(*before.rotation, strict=True)]
    first = dot(t, t, normal) + dot(v, v, normal) + 2 * dot(turned, v, normal)
    return [_equation(origin, first, second)]


def _right_joints(problem: Problem, k: int, vector: tuple[Polynomial, ...]) -> set[int]:
    """The joints after k on which a vector depends."""
    algebra = problem.algebra
    places = {
        algebra.index[name]: angle.terms[-1][0]
        for angle in algebra.angles
        for name in (angle.cosine, angle.sine)
    } | {algebra.index[name]: joint for joint, name in algebra.slides.items()}
    return {
        joint
        for place, joint in places.items()
        if joint > k and any(monomial[place] for entry in vector for monomial in entry)
    }


def may_help(problem: Problem, origin: Origin) -> bool:
    """Whether a squared distance holds few enough angles and lengths to be of use.

    It does not depend on what turns the whole about either of its ends.
    """
    spans, m, k = problem.spans, origin.m, origin.k

    def parts(transform: Transform) -> set[str]:
        return moving_parts(problem.algebra, transform.translation)

    held = parts(spans.product(m, k)) & parts(spans.inverse(m, k))
    held |= parts(spans.product(0, m)) | parts(right_inverse(problem, k))
    return len(held) <= MOST_SQUARED


def moving_parts(algebra: Algebra, vector: tuple[Polynomial, ...]) -> set[str]:
    """The angle sums and lengths that occur and that the caller does not give."""
    free = algebra.chain.free
    names = {
        place: angle.suffix
        for angle in algebra.angles
        if not all(joint in free for joint, _ in angle.terms)
        for place in (algebra.index[angle.cosine], algebra.index[angle.sine])
    }
    slides = {joint: name for joint, name in algebra.slides.items() if joint not in free}
    names |= {algebra.index[name]: name for name in slides.values()}
    used = {p for entry in vector for monomial in entry for p, e in enumerate(monomial) if e}
    return {names[place] for place in used if place in names}


class Withheld:
    """Which pose entries the task does not give."""

    def __init__(self, problem: Problem) -> None:
        index = problem.algebra.index
        self._places = [index[name] for name in POSE_NAMES if name not in problem.known]

    def __call__(self, polynomial: Polynomial) -> bool:
        """Whether a polynomial holds one of them."""
        return any(monomial[place] for monomial in polynomial for place in self._places)
