"""All solutions of a general arm, in NumPy: the algorithm in its clearest form.

M. Raghavan and B. Roth, Inverse kinematics of the general 6R manipulator and related linkages
(1993), with the determinant sampled on the circle instead of a characteristic polynomial; with two
slides, and for offset wrists, the polynomial in closed form instead.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from dhgen.general.determinant import equations, fold, independence
from dhgen.general.hidden_slide import length
from dhgen.general.loop import out_of_reach
from dhgen.general.pointing import any_turn
from dhgen.general.polish import NEARLY_SINGULAR, SINGULAR, Target, polish, regularity
from dhgen.general.recover import least_values, null_vectors, partner_values, remaining_angles
from dhgen.general.roots import real_roots
from dhgen.kinematics.order import in_order
from dhgen.runtime.python.general.tables import NUDGE_DIRECTIONS, NUDGE_LENGTHS
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import ArrayLike

    from dhgen.arrays import FloatArray
    from dhgen.general.formulation import Formulation
    from dhgen.general.four_turns import FourTurns
    from dhgen.general.kernel import GeneralKernel
    from dhgen.general.loop import Loop
    from dhgen.general.offset_wrist import OffsetWrist
    from dhgen.kinematics.rigid import Matrix


STEPS = 4  # Newton steps for a candidate; two are enough unless a root is nearly double
STEPS_FROM_AFAR = 40
SAME = 1e-6  # solutions closer than this are one [rad]
PLACES = 64  # many candidates come near to a singular solution; the last are for regular ones
TOGETHER = 1e-3  # singular ones closer than this may be one, which their last digits tell [rad]
CLOSE = 1e-3  # roots closer than this are also tried as a double root [rad]
BESIDE = 1e-4  # as near to a double root two simple ones are looked for [rad]
PARABOLAS = 3  # one after the other that tell them
STARTS = 60
# A matrix is not singular when its smallest singular value is this part of all, and the one before
# that part: where two are small, so many roots crowd that the determinant, sampled, does not tell
# whether they are real.
REGULAR = 2e-7
ALONE = 1e-6
# Nor does it show whether the matrix is singular where the columns that are cleared first nearly
# depend on each other: where their least singular value is below this part of all.
INDEPENDENT = 3e-4


@dataclass(frozen=True, slots=True)
class Solved:
    """The solutions of one pose.

    Attributes:
        q: (k, 6), sorted by θ1, then θ2 ..., singular ones and nearly so last [rad, in (−π, π]; a
            slide's in the file's unit].
        residual: (k,), by how much the loop stays open [arm sizes, rad].
        complete: Whether a certificate says that there are no others.
        singular: Whether roots met, or the arm is singular at a solution, or more were found than
            there may be, or steps did not make one exact, as where it nearly is; or whether only
            poses close by tell that these are all: where every polynomial vanishes identically
            there may be a continuum besides.
    """

    q: FloatArray
    residual: FloatArray
    complete: bool
    singular: bool = False


def solve(T: ArrayLike, kernel: GeneralKernel, free: Sequence[float] = ()) -> Solved:
    """All solutions of T = C0 J1(θ1) C1 ... J6(θ6) C6.

    Args:
        T: A rigid transform (4, 4); of a tool that only points, position and z axis count.
        kernel: What is known of the arm.
        free: Values of the joints that the caller gives.
    """
    loop, held = kernel.loop, kernel.held(free)
    pose = np.asarray(T, dtype=float)
    if kernel.pointing:
        pose = any_turn(pose)
    P = np.array(loop.left.at(held)) @ pose @ np.array(loop.right.at(held))
    P[:3, 3] /= loop.size
    if P[:3, 3] @ P[:3, 3] > out_of_reach(loop):
        return Solved(np.empty((0, 6)), np.empty(0), complete=True)
    links = tuple(np.array(K.at(held)) for K in loop.links)
    search = _Search(Target(links, P, loop.slides), kernel.rows, kernel.tried(held))
    certified = _attempt(kernel, search)
    complete = certified or _from_nearby(kernel, search)
    if not complete:
        random = np.random.default_rng(0)
        for theta in random.uniform(-np.pi, np.pi, (STARTS, 6)):
            search.offer(theta, STEPS_FROM_AFAR, doubtful=True)
    found = search.result(loop, complete=complete)
    return found if certified else replace(found, singular=True)


class _Search:
    """The solutions found so far, a slide's length in arm sizes, and what is tried for them."""

    def __init__(self, target: Target, most: int, formulations: tuple[Formulation, ...]) -> None:
        self.target, self.most, self.formulations = target, most, formulations
        self.turns = np.array([place not in target.slides for place in range(6)])
        self.found: list[FloatArray] = []
        self.residuals: list[float] = []
        self.singular: set[int | None] = set()
        self.nearly_singular: set[int] = set()
        self.doubles = 0

    @property
    def paired(self) -> bool:
        """Whether the number of regular solutions is even."""
        return (len(self.found) - len(self.singular)) % 2 == 0

    def offer(self, theta: FloatArray, steps: int = STEPS, *, doubtful: bool = False) -> int | None:
        """Polish a candidate; its place among the solutions, or None when it is not one.

        A doubtful candidate, from a double root, may be a singular solution and is then marked.
        """
        theta, residual = polish(self.target, theta, steps, afar=steps > STEPS)
        if residual > TOLERANCES.polished:
            return None
        theta = np.where(self.turns, np.pi - np.remainder(np.pi - theta, 2 * np.pi), theta)
        place = self._place(theta)
        regular = regularity(self.target, theta) if doubtful else np.inf
        nearly = regular < NEARLY_SINGULAR
        if place == len(self.found):
            if place >= PLACES - nearly * self.most:
                return None
            self.found.append(theta)
            self.residuals.append(np.inf)
        if residual < self.residuals[place]:
            self.found[place] = theta
            self.residuals[place] = residual
        if regular < SINGULAR:
            self.singular.add(place)
        if nearly:
            self.nearly_singular.add(place)
        return place

    def _place(self, theta: FloatArray) -> int:
        """The place of the same solution, or the next free one."""
        for i, known in enumerate(self.found):
            if self._gap(theta, known) < SAME:
                return i
        return len(self.found)

    def _gap(self, a: FloatArray, b: FloatArray) -> float:
        """The largest difference of two joint vectors, modulo turns."""
        turned = np.remainder(a - b + np.pi, 2 * np.pi) - np.pi
        return float(np.abs(np.where(self.turns, turned, a - b)).max())

    def _ranks(self) -> list[int]:
        """What comes first where there are more than there are rows.

        0 for regular solutions, 1 for singular ones or nearly so, 2 for those that lie together
        with one of these and may be the same.
        """
        ranks: list[int] = []
        for i, theta in enumerate(self.found):
            others = [self.found[j] for j, rank in enumerate(ranks) if rank == 1]
            near = min((self._gap(theta, other) for other in others), default=np.inf) < TOGETHER
            ranks.append(int(i in self.nearly_singular) * (1 + near))
        return ranks

    def result(self, loop: Loop, *, complete: bool) -> Solved:
        """The solutions in joint values, no more than there are rows."""
        ranks = self._ranks()
        q = np.array(self.found).reshape(-1, 6)
        q += [np.arctan2(s, c) for c, s in loop.advances]
        q = np.where(self.turns, np.pi - np.remainder(np.pi - q, 2 * np.pi), loop.size * q)
        order = sorted(range(len(q)), key=lambda i: (ranks[i], in_order(q[i])))[: self.most]
        residual = np.array([self.residuals[i] for i in order])
        many = len(self.found) > self.most
        inexact = (residual > TOLERANCES.exact).any()
        singular = bool(self.singular or self.doubles or many or inexact)
        return Solved(q[order].reshape(-1, 6), residual, complete, singular)


def _attempt(kernel: GeneralKernel, search: _Search) -> bool:
    """Offer what the closed form and the formulations find, until that is certainly everything."""
    if any(_certified_closed(arm, search) for arm in kernel.closed):
        return True
    return any(_certified(formulation, search) for formulation in search.formulations)


def _certified_closed(arm: OffsetWrist | FourTurns, search: _Search) -> bool:
    """The same as `_certified` where the polynomial is known in closed form."""
    links, P = search.target.links, search.target.P
    found = real_roots(lambda cosines, sines: arm.values(links, P, cosines, sines))
    if found is None:
        return False
    search.doubles += len(found.double)
    met: set[int | None] = set()
    expected = 0
    every = *found.simple, *found.double
    complete = found.complete and arm.tells_all(links, P, every)
    for angle in every:
        double = angle in found.double
        starts = list(arm.candidates(links, P, angle))
        near = [theta for theta in starts if theta is not None]
        places = {search.offer(theta, doubtful=double) for theta in near} - {None}
        met |= places
        if len(near) < len(starts) and not places:
            continue
        own = arm.solutions_per_root
        expected += own if not double or places & search.singular else 2 * own
        expected -= len(starts) - len(near)
        complete = complete and len(places) >= own
    return complete and len(met) >= expected and search.paired


def _certified(formulation: Formulation, search: _Search) -> bool:
    """Offer what a formulation finds; whether that is certainly everything.

    The certificate: every simple root leads to a solution, there is another one for each of them
    and two more for each double root, or a singular one; and regular solutions come in pairs.
    Where f nearly vanishes all around, rounding of the equations may lift it off a double root, and
    f shows none: the equations themselves tell. What a formulation before took for
    double roots is none then; whether the arm is singular there is looked at.
    """
    target = search.target
    around = formulation.links(target.links, target.P)
    slides = formulation.slides(target.slides)
    E = equations([link[None] for link in around], slides)
    found = real_roots(partial(formulation.polynomial, E), partial(_may_vanish, E))
    if found is None:
        return False
    met: set[int | None] = set()
    expected, doubles, doubted = len(found.simple), 0, search.doubles > 0
    complete = found.complete
    for angle in found.simple:
        (phi,) = _candidates(E, around, slides, (angle, 1))
        place = search.offer(formulation.angles(phi), doubtful=doubted)
        complete = complete and place is not None
        met |= {place} - {None}
    touching = (*found.double, *found.unseen)
    beside = (angle for middle in touching for angle in _separated(E, middle))
    for angle in (*_nearly_double(found.simple), *beside, *touching):
        starts = [formulation.angles(phi) for phi in _candidates(E, around, slides, (angle, 2))]
        places = {search.offer(theta, doubtful=True) for theta in starts} - {None}
        if angle in touching and (places or _may_vanish(E, angle)):
            expected += 1 if places & search.singular else 2
            doubles += 1
        met |= places
    complete = complete and len(met) >= expected and search.paired
    search.doubles = doubles if complete else search.doubles + len(found.double)
    return complete


def _may_vanish(E: FloatArray, angle: float) -> bool:
    """Whether the determinant may be zero: where f only comes near to zero it is not."""
    cosine, sine = float(np.cos(angle)), float(np.sin(angle))
    if independence(E, cosine, sine) < INDEPENDENT:
        return True
    _, factor = fold(E, np.array([cosine]), np.array([sine]))
    second, smallest = least_values(factor[..., 0])
    return smallest < REGULAR or second < ALONE


def _separated(E: FloatArray, angle: float) -> list[float]:
    """Two simple roots beside an angle where roots may have met, if there are.

    The determinant itself has digits there that its fit lacks. Each parabola is as wide as the one
    before says that they are apart.
    """
    middle, apart = angle, BESIDE
    for _ in range(PARABOLAS):
        angles = middle + apart * np.array([-1.0, 0.0, 1.0])
        before, at, after = map(float, fold(E, np.cos(angles), np.sin(angles))[0])
        slope, bend = 0.5 * (after - before), 0.5 * (after + before) - at
        square = slope**2 - 4.0 * bend * at
        if not (square > 0.0 and bend):
            return []
        middle -= 0.5 * slope / bend * apart
        apart *= np.sqrt(square) / abs(bend)
        if abs(middle - angle) + apart >= BESIDE:
            return []  # so far apart that they are known
    return [middle - 0.5 * apart, middle + 0.5 * apart]


def _nearly_double(simple: tuple[float, ...]) -> list[float]:
    """The middles of roots that are so close that their null vectors may be mixed."""
    ordered = sorted(simple)
    return [(a + b) / 2 for a, b in pairwise(ordered) if b - a < CLOSE]


def _candidates(
    E: FloatArray,
    links: Sequence[FloatArray],
    slides: tuple[bool, ...],
    root: tuple[float, int],
) -> list[tuple[float, ...]]:
    """φ1 ... φ6 near solutions, for a root and the dimension of its null space."""
    angle, dimension = root
    _, factor = fold(E, np.array([np.cos(angle)]), np.array([np.sin(angle)]))
    hidden = length(angle) if slides[0] else angle
    return [
        remaining_angles(links, (hidden, *partner_values(vector, slides)), slides)
        for vector in null_vectors(factor[..., 0], dimension)
    ]


def _from_nearby(kernel: GeneralKernel, search: _Search) -> bool:
    """Solve poses close by, and follow their solutions back.

    Where two solutions meet they are on one side only: both sides have to have as many as are
    found. Around a singular pose none of them has to have all solutions: then all are looked at.
    """
    followed = False
    before = -1
    for number, motion in enumerate(nudges()):
        moved = search.target.P @ np.array(motion)
        nearby = _Search(replace(search.target, P=moved), search.most, search.formulations)
        complete = _attempt(kernel, nearby)
        places = {search.offer(theta, STEPS_FROM_AFAR, doubtful=True) for theta in nearby.found}
        count = -1
        if complete and places and None not in places:
            count = len(nearby.found) if len(places) == len(nearby.found) else -1
            followed = followed or bool(places & search.singular)
        agreed = number % 2 == 1 and before == count == len(search.found)
        if agreed and not search.singular and search.paired:
            return True
        before = count
    return followed and search.paired


def nudges() -> tuple[Matrix, ...]:
    """Small motions of growing size, there and back: the quaternion (1, v), and a translation."""
    return tuple(
        _motion((size * a, size * b, size * c), (size * x, size * y, size * z))
        for distance, (a, b, c, x, y, z) in zip(NUDGE_LENGTHS, NUDGE_DIRECTIONS, strict=True)
        for size in (distance, -distance)
    )


def _motion(v: tuple[float, float, float], t: tuple[float, float, float]) -> Matrix:
    x, y, z = v
    n = 1.0 + x * x + y * y + z * z
    return (
        (1 - 2 * (y * y + z * z) / n, 2 * (x * y - z) / n, 2 * (x * z + y) / n, t[0]),
        (2 * (x * y + z) / n, 1 - 2 * (x * x + z * z) / n, 2 * (y * z - x) / n, t[1]),
        (2 * (x * z - y) / n, 2 * (y * z + x) / n, 1 - 2 * (x * x + y * y) / n, t[2]),
        (0.0, 0.0, 0.0, 1.0),
    )
