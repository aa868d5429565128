"""The mixed forms of T: (A_1 ... A_m)^-1 U_0 (A_{k+1} ... A_n)^-1 = A_{m+1} ... A_k.

With k = n these are Paul's U_m; the others are needed where a wrist has no common centre (UR5).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.kinematics.transform import compose

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

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
