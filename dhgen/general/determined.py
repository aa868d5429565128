"""Whether φ5 follows from φ1, φ2 and φ3: where it does not a root belongs to two solutions.

B = J(φ4) L3 J(φ5) L4 J(φ6) is known then, and what does not depend on φ4 and φ6 is linear in cos φ5
and sin φ5: the invariants of axis 4 and axis 6 in B. Where φ5 is a length, some of these are linear
in it; where φ6 is one, directions give φ4 and φ5.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.general.formulation import OTHERS

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.arrays import FloatArray


TINY = 1e-300  # keeps a quotient of zeros finite
EZ = np.array([0.0, 0.0, 1.0])


def middle_determined(K: FloatArray, M: FloatArray, slides: Sequence[bool]) -> float:
    """How well φ5 follows from B = J(φ4) K J(φ5) M J(φ6): 0 where B leaves two values, or any.

    Where axes 4 to 6 are parallel, or meet in a point, all invariants have one and the same
    combination of cos φ5 and sin φ5, which gives φ5 but for a sign.

    Args:
        K: The link between φ4 and φ5, (4, 4), in arm sizes.
        M: The link between φ5 and φ6.
        slides: Which of φ1 ... φ6 is a length.

    Returns:
        The least singular value of what φ5 is solved from; of an angle over the largest one.
    """
    inner, outer = (slides[place] for place in OTHERS)
    if outer:
        return float(np.linalg.norm(K[2, :2]))
    if inner:
        return float(np.linalg.norm(_middle_slope(K, M)))
    largest, least = np.linalg.svd(_middle_equations(K, M), compute_uv=False)
    return float(least / (largest + TINY))


def _middle_equations(K: FloatArray, M: FloatArray) -> FloatArray:
    """Five invariants' coefficients of cos φ5 and sin φ5, (5, 2)."""
    R, t, e, u = K[:3, :3], K[:3, 3], M[:3, 2], M[:3, 3]
    axis, foot, side = R.T @ EZ, R.T @ t, R.T @ np.cross(EZ, t)
    terms = (
        [(axis, e)],
        [(axis, u)],
        [(foot, e)],
        [(foot, u)],
        [(axis, np.cross(u, e)), (side, e)],
    )
    cosine = [sum(a[:2] @ b[:2] for a, b in sides) for sides in terms]
    sine = [sum(a[1] * b[0] - a[0] * b[1] for a, b in sides) for sides in terms]
    return np.array([cosine, sine]).T


def _middle_slope(K: FloatArray, M: FloatArray) -> FloatArray:
    """The coefficients of a length φ5 in three invariants, (3,)."""
    axis, e = K[2, :3], M[:3, 2]
    return np.array([axis @ EZ, EZ @ e, axis @ np.cross(EZ, e)])
