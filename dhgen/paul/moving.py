"""What moves a vector: the angle sums and lengths that it holds, and the joints behind them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.ring import used_places
from dhgen.paul.mixed_forms import right_inverse

if TYPE_CHECKING:
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.transform import Transform
    from dhgen.paul.problem import Problem

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
    """Whether the squared distance of frames m and k holds few enough angles and lengths to serve.

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
