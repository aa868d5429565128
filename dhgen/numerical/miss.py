"""By how much joint values miss a pose, and how that changes with them: the analytic Jacobian.

Everything is batched: q (N, n), poses (N, 4, 4).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.arm_angle import plane_miss
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.numerical.kernel import NumericalKernel


ASIDE = 1e-9  # a sine below this gives no axis to turn about
ANY_AXIS = (0.48, 0.6, 0.64)  # is taken then, where half a turn is missing


def miss(
    kernel: NumericalKernel, T: FloatArray, q: FloatArray, psi: float = 0.0
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """The missing motion of the tool, and how each solved joint moves it, in units.

    Args:
        kernel: The arm.
        T: The pose wanted, (4, 4).
        q: Joint values, (N, n).
        psi: The arm angle, where the caller gives it.

    Returns:
        The miss (N, m) [arm sizes, rad], its length (N,), and the matrix A (N, m, k).
    """
    P, J = kernel.arm.moved(q)
    parts, matrices = [pose_miss(kernel, T, P)], [_rates(kernel, P, J[..., list(kernel.solved)])]
    if kernel.elbow:
        off, rates = plane_miss(kernel.arm, T, psi, q, TOLERANCES.free)
        parts.append(off[:, None])
        matrices.append(rates[:, None])
    e = np.concatenate(parts, axis=-1)
    return e, np.linalg.norm(e, axis=-1), np.concatenate(matrices, axis=-2)


def pose_miss(kernel: NumericalKernel, T: FloatArray, P: FloatArray) -> FloatArray:
    """The missing motion from poses P (N, 4, 4) to T (4, 4) or (N, 4, 4), in units, (N, m)."""
    off = (T[..., :3, 3] - P[:, :3, 3])[:, list(kernel.position)]
    parts = [off / kernel.arm.chain.size]
    if kernel.turning:
        R = T[..., :3, :3] @ np.swapaxes(P[:, :3, :3], 1, 2)
        skew = [R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]]
        parts.append(_turn(np.stack(skew, axis=-1) / 2, (np.trace(R, axis1=1, axis2=2) - 1) / 2))
    if kernel.pointing:
        z, wanted = P[:, :3, 2], T[..., :3, 2]
        parts.append(_turn(np.cross(z, wanted), (z * wanted).sum(axis=-1)))
    return np.concatenate(parts, axis=-1)


def _rates(kernel: NumericalKernel, P: FloatArray, J: FloatArray) -> FloatArray:
    """How the solved joints, in units, move the tool's entries of that miss, (N, m, k)."""
    size = kernel.arm.chain.size
    matrices = [J[:, list(kernel.position)] * (np.array(kernel.units) / size)]
    if kernel.turning:
        matrices.append(J[:, 3:])
    if kernel.pointing:
        z = P[:, :3, 2]
        # turning about z itself changes nothing
        matrices.append(J[:, 3:] - z[:, :, None] * (z[:, None, :] @ J[:, 3:]))
    return np.concatenate(matrices, axis=-2)


def _turn(axis: FloatArray, cosine: FloatArray) -> FloatArray:
    """The rotation vector of an axis times the sine, and the cosine."""
    sine = np.linalg.norm(axis, axis=-1)
    opposite = (sine < ASIDE) & (cosine < 0.0)
    safe = np.where(sine < ASIDE, 1.0, sine)
    turned = axis * np.where(sine < ASIDE, 1.0, np.arctan2(sine, cosine) / safe)[:, None]
    return np.where(opposite[:, None], np.pi * np.array(ANY_AXIS), turned)
