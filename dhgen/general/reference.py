"""All solutions of a general arm, in NumPy: the algorithm in its clearest form.

M. Raghavan and B. Roth, Inverse kinematics of the general 6R manipulator and related linkages
(1993), with the determinant sampled on the circle instead of a characteristic polynomial.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.general.circle import SAMPLES, Roots, roots, sample_cosines, trigonometric
from dhgen.general.determinant import equations, fold
from dhgen.general.polish import polish
from dhgen.general.recover import null_vectors, partner_angles, remaining_angles

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from dhgen.general.formulation import Formulation
    from dhgen.general.kernel import GeneralKernel

    FloatArray = NDArray[np.float64]

MOST = 16
STEPS = 4  # Newton steps for a candidate; two are enough unless a root is nearly double
STEPS_FROM_AFAR = 30
RESIDUAL = 1e-10  # what counts as a solution [arm sizes, rad]
SAME = 1e-6  # solutions closer than this are one [rad]
NOISE = 1e-6  # harmonics beyond the eighth above this: f vanishes identically at this pose
CLOSE = 1e-3  # roots closer than this are also tried as a double root [rad]
# How far, and where to, the pose is moved when both formulations fail: where roots crowd, they
# come apart only at some distance.
NUDGES = (1e-3, 3e-3, 1e-2, 3e-2, 3e-2)
NUDGE_DIRECTIONS = (
    (0.41, -0.37, 0.29, 0.53, 0.71, -0.47),
    (-0.23, 0.43, 0.31, -0.61, 0.29, 0.67),
    (0.39, 0.33, -0.45, 0.59, -0.43, 0.31),
    (-0.47, 0.27, -0.35, 0.37, 0.61, 0.57),
    (0.33, 0.49, 0.23, -0.51, -0.67, 0.41),
)
STARTS = 60


@dataclass(frozen=True, slots=True)
class Solved:
    """The solutions of one pose.

    Attributes:
        q: (k, 6), sorted by θ1, then θ2 ... [rad, in (−π, π]].
        residual: (k,), by how much the loop stays open [arm sizes, rad].
        complete: Whether a certificate says that there are no others.
    """

    q: FloatArray
    residual: FloatArray
    complete: bool


def solve(T: ArrayLike, kernel: GeneralKernel) -> Solved:
    """All solutions of T = C0 Rz(θ1) C1 ... Rz(θ6) C6 for a rigid T (4, 4)."""
    loop = kernel.loop
    P = np.array(loop.left) @ np.asarray(T, dtype=float) @ np.array(loop.right)
    P[:3, 3] /= loop.size
    search = _Search([np.array(K) for K in loop.links], P)
    complete = any(_certified(formulation, search, P) for formulation in kernel.formulations)
    if not complete:
        complete = _from_nearby(kernel, search)
    if not complete:
        random = np.random.default_rng(0)
        for theta in random.uniform(-np.pi, np.pi, (STARTS, 6)):
            search.offer(theta, STEPS_FROM_AFAR)
    return search.result(complete=complete)


class _Search:
    """The solutions found so far."""

    def __init__(self, links: list[FloatArray], P: FloatArray) -> None:
        self.links, self.P = links, P
        self.found: list[FloatArray] = []
        self.residuals: list[float] = []

    def offer(self, theta: FloatArray, steps: int = STEPS) -> int | None:
        """Polish a candidate; its place among the solutions, or None when it is not one."""
        theta, residual = polish(self.links, self.P, theta, steps)
        if residual > RESIDUAL:
            return None
        theta = np.pi - np.remainder(np.pi - theta, 2 * np.pi)
        for i, known in enumerate(self.found):
            gap = np.abs(np.remainder(theta - known + np.pi, 2 * np.pi) - np.pi)
            if gap.max() < SAME:
                if residual < self.residuals[i]:
                    self.found[i], self.residuals[i] = theta, residual
                return i
        if len(self.found) == MOST:
            return None
        self.found.append(theta)
        self.residuals.append(residual)
        return len(self.found) - 1

    def result(self, *, complete: bool) -> Solved:
        order = sorted(range(len(self.found)), key=lambda i: tuple(self.found[i]))
        q = np.array([self.found[i] for i in order]).reshape(-1, 6)
        return Solved(q, np.array([self.residuals[i] for i in order]), complete)


def _certified(formulation: Formulation, search: _Search, P: FloatArray) -> bool:
    """Offer what a formulation finds for the pose P; whether that is certainly everything."""
    E = equations(formulation, P[None])
    cosines, sines = sample_cosines()
    f = trigonometric(fold(E, np.array(cosines), np.array(sines))[0])
    if f.noise > NOISE or f.scale == 0.0:
        return False
    found = roots(f)
    owners: set[int] = set()
    complete = found.complete
    for angle, dimension in _grouped(found):
        places = {
            place
            for theta in _candidates(formulation, E, P, angle, dimension)
            if (place := search.offer(theta)) is not None
        }
        complete = complete and (dimension == 2 or bool(places))
        owners |= places
    return complete and len(owners) >= len(found.simple)


def _grouped(found: Roots) -> list[tuple[float, int]]:
    """Every root with the dimension of its null space, roots that nearly meet twice."""
    groups = [(angle, 1) for angle in found.simple] + [(angle, 2) for angle in found.double]
    ordered = sorted(found.simple)
    for low, high in zip(ordered, ordered[1:], strict=False):
        if high - low < CLOSE:
            groups.append(((low + high) / 2, 2))
    return groups


def _candidates(
    formulation: Formulation, E: FloatArray, P: FloatArray, angle: float, dimension: int
) -> list[FloatArray]:
    """Joint angles θ (6,) near solutions whose hidden angle is a root."""
    inverse = np.linalg.inv(P)
    links = [
        np.array(K) if K is not None else (inverse if formulation.sign > 0 else P)
        for K in formulation.links
    ]
    _, factor = fold(E, np.array([np.cos(angle)]), np.array([np.sin(angle)]))
    result = []
    for vector in null_vectors(factor[..., 0], dimension):
        phi = remaining_angles(links, (angle, *partner_angles(vector)))
        theta = np.empty(6)
        theta[list(formulation.joints)] = formulation.sign * np.array(phi)
        result.append(theta)
    return result


def _from_nearby(kernel: GeneralKernel, search: _Search) -> bool:
    """Solve a pose close by, and follow its solutions back."""
    random = np.random.default_rng(1)
    for _ in range(2):
        nearby = search.P @ _nudge(random)
        other = _Search(search.links, nearby)
        complete = any(_certified(f, other, nearby) for f in kernel.formulations)
        places = {search.offer(theta, STEPS_FROM_AFAR) for theta in other.found}
        if complete and None not in places and len(places) == len(other.found):
            return True
    return False


def _nudge(random: np.random.Generator) -> FloatArray:
    x, y, z = random.uniform(-NUDGE, NUDGE, 3)
    rotation, _ = np.linalg.qr(np.array([[1.0, -z, y], [z, 1.0, -x], [-y, x, 1.0]]))
    T = np.eye(4)
    T[:3, :3] = rotation * np.sign(np.diag(rotation))
    T[:3, 3] = random.uniform(-NUDGE, NUDGE, 3)
    return T
