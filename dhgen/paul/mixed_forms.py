"""The mixed forms of T: (A_1 ... A_m)^-1 U_0 (A_{k+1} ... A_n)^-1 = A_{m+1} ... A_k.

With k = n these are Paul's U_m; the others are needed where a wrist has no common centre (UR5).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.kinematics.ring import used_places
from dhgen.kinematics.transform import compose

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.transform import Transform
    from dhgen.paul.problem import Problem


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


def right_inverse(problem: Problem, k: int) -> Transform:
    """(A_{k+1} ... A_n)^-1: frame k seen from the last one."""
    return problem.spans.inverse(k, len(problem.links))


MOST_SQUARED = 4  # angles and lengths in a squared distance: with more it comes too late to help


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
    return {names[place] for place in _used(vector) if place in names}


def right_joints(problem: Problem, k: int, vector: tuple[Polynomial, ...]) -> set[int]:
    """The joints after k on which a vector depends."""
    algebra = problem.algebra
    places = {
        algebra.index[name]: angle.terms[-1][0]
        for angle in algebra.angles
        for name in (angle.cosine, angle.sine)
    } | {algebra.index[name]: joint for joint, name in algebra.slides.items()}
    used = _used(vector)
    return {joint for place, joint in places.items() if joint > k and place in used}


def may_help(problem: Problem, m: int, k: int) -> bool:
    """Whether the squared distance of frames m and k holds few angles and lengths.

    It does not depend on what turns the whole about either of its ends.
    """
    spans = problem.spans

    def parts(transform: Transform) -> set[str]:
        return moving_parts(problem.algebra, transform.translation)

    held = parts(spans.product(m, k)) & parts(spans.inverse(m, k))
    held |= parts(spans.product(0, m)) | parts(right_inverse(problem, k))
    return len(held) <= MOST_SQUARED


def _used(vector: tuple[Polynomial, ...]) -> set[int]:
    """The generators that occur in some entry."""
    return {place for entry in vector for place in used_places(entry)}
