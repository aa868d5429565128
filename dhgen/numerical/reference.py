"""The numerical solver in NumPy: its meaning, in the clearest form.

Damped least squares (C. W. Wampler, 1986; the damping after T. Sugihara, 2011: a part of the
squared miss) from starts that fill the joint space evenly. It finds what it finds: there is no
certificate that there are no other solutions.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.order import in_order
from dhgen.numerical import kernel as constants
from dhgen.numerical.miss import miss
from dhgen.runtime.python.numerical.arm import strides
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.numerical.kernel import NumericalKernel

    Limits = tuple[FloatArray, FloatArray]


@dataclass(frozen=True, slots=True)
class Found:
    """The solutions of one pose.

    Attributes:
        q: (k, n), sorted by the first joint, then the second ...; angles in (-pi, pi].
        chosen: Whether a joint was indeterminate and went towards the seed, (k,).
    """

    q: FloatArray
    chosen: NDArray[np.bool_]


def solve(T: FloatArray, seed: FloatArray, free: FloatArray, kernel: NumericalKernel) -> Found:
    """The solutions found for a pose.

    Args:
        T: Pose (4, 4); entries that the task does not name are ignored.
        seed: Joint values (n,): the first start, and where indeterminate joints go.
        free: Values of the free joints, in their order.
        kernel: The arm.
    """
    arm = Arm(kernel, T, seed, free)
    return arm.nearest() if kernel.redundant else arm.all()


@dataclass(frozen=True, slots=True)
class _Kept:
    """A solution in units, whether the arm is singular there, and whether it was pulled."""

    u: FloatArray
    singular: bool
    chosen: bool


class Arm:
    """An arm before a pose; u are the values of the joints solved for, in units.

    Args:
        kernel: The arm.
        T: Pose (4, 4); entries that the task does not name are ignored.
        seed: Joint values (n,): the first start, and where indeterminate joints go.
        free: Values of the free joints, in their order.
    """

    def __init__(
        self, kernel: NumericalKernel, T: FloatArray, seed: FloatArray, free: FloatArray
    ) -> None:
        self.kernel, self.T = kernel, T
        self.solved: list[int] = list(kernel.solved)
        self.units: FloatArray = np.array(kernel.units)
        self.turns = np.array(kernel.turns)
        self.q = np.array(seed, dtype=float)
        given = [j - 1 for j in kernel.arm.chain.free]
        self.q[given] = free
        self.seed = self.q[self.solved] / self.units
        spans: FloatArray = np.array(kernel.spans)
        self.limits: Limits = (np.array(kernel.lowest), np.array(kernel.highest))
        self.low, self.width = spans[:, 0], spans[:, 1] - spans[:, 0]
        self.directions = np.array(strides(len(self.solved)))

    def joints(self, u: FloatArray) -> FloatArray:
        """All joint values (N, n)."""
        q = np.repeat(self.q[None], len(u), axis=0)
        q[:, self.solved] = u * self.units
        return q

    def starts(self, first: int, count: int) -> FloatArray:
        """The starts numbered first, first + 1 ...; number 0 is the seed."""
        numbers = np.arange(first, first + count)[:, None]
        part: FloatArray = np.mod(0.5 + numbers * self.directions, 1.0)
        u = self.low + self.width * part
        return np.asarray(np.where(numbers == 0, self.seed, u))

    def miss(self, u: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """As `miss` in `dhgen.numerical.miss`, of joints (N, k)."""
        return miss(self.kernel, self.T, self.joints(u))

    def all(self) -> Found:
        """The distinct solutions, until a round of starts finds nothing new."""
        kept: list[_Kept] = []
        for number in range(constants.ROUNDS):
            u, length = self.descend(self.starts(number * constants.STARTS, constants.STARTS))
            known = len(kept)
            for row in u[length <= self.kernel.residual]:
                self._keep(row, kept)
            if len(kept) in {known, self.kernel.rows}:
                break
        return self._sorted(kept)

    def settle(self, rows: FloatArray, *, regular: bool) -> Found:
        """Solutions that another algorithm found (k, n), sorted; singular ones follow the seed.

        Args:
            rows: Values of the joints that are solved for.
            regular: Whether none of them is singular and all of them are known.
        """
        u = rows / self.units
        if self.kernel.checked:
            return self._checked(u, regular=regular)
        if regular:
            known = [_Kept(self.wrapped(row), singular=False, chosen=False) for row in u]
            return self._sorted(known)
        return self._beside_starts(u)

    def _checked(self, u: FloatArray, *, regular: bool) -> Found:
        """The same of a pose that the arm may be unable to take: what is near, and what fits."""
        nearest, _ = self.descend(u)
        kept: list[_Kept] = []
        if regular:
            self._keep_what_fits(nearest, kept)
        return self._sorted(kept) if kept else self._beside_starts(nearest)

    def _beside_starts(self, u: FloatArray) -> Found:
        """What the seed and a few starts lead to, beside solutions (k, n) that are known."""
        kept: list[_Kept] = []
        first, *others = self.starts(0, constants.FEW_STARTS)
        ends, _ = self.descend(np.array([first, *u, *others]))
        self._keep_what_fits(ends, kept)
        return self._sorted(kept)

    def _keep_what_fits(self, u: FloatArray, kept: list[_Kept]) -> None:
        for row, missing in zip(u, self.miss(u)[1], strict=True):
            if missing <= self.kernel.residual:
                self._keep(row, kept)

    def _sorted(self, kept: list[_Kept]) -> Found:
        q = self.joints(np.array([each.u for each in kept]).reshape(-1, len(self.solved)))
        rows = [(row, each.chosen) for row, each in zip(q, kept, strict=True)]
        rows.sort(key=lambda row: in_order(row[0]))
        chosen = np.array([each for _, each in rows], dtype=bool)
        return Found(np.array([row for row, _ in rows]).reshape(q.shape), chosen)

    def _keep(self, u: FloatArray, kept: list[_Kept]) -> None:
        """A solution joins those found before, unless it is one of them.

        Where one is exact the pose has not been rounded: then all have to be exact.
        """
        singular, chosen, enough = False, False, self._enough(u)
        before = self._enough(kept[0].u) if kept else enough
        if before < enough:
            return
        if before > enough:
            kept.clear()
        if self._known(u, kept, singular=False) is not None:
            return
        along, length = sideways(self.miss(u[None])[2])
        if length > constants.SINGULAR:
            singular = True
            chosen = self.continues(u, along, enough)
            if chosen:
                u = self.pulled(u, enough)
            u = self._inside(u, kept, enough, alone=not chosen)
        u = self.wrapped(u)
        known = self._known(u, kept, singular=singular)
        if known is None and len(kept) < self.kernel.rows:
            kept.append(_Kept(u, singular, chosen))
        elif known is not None and self._takes_place(u, kept[known].u):
            kept[known] = _Kept(u, singular, chosen)

    def _takes_place(self, u: FloatArray, known: FloatArray) -> bool:
        """Of two solutions that are taken for one that inside the limits is kept.

        If it is as exact as a row has to be.
        """
        inside = self._beyond(known) and not self._beyond(u)
        return bool(inside and self.miss(u[None])[1][0] <= TOLERANCES.promised)

    def _enough(self, u: FloatArray) -> float:
        """What others may miss beside a solution: an exact one is left for exact ones only."""
        exact = self.miss(u[None])[1][0] <= TOLERANCES.polished
        return TOLERANCES.polished if exact else self.kernel.residual

    def _beyond(self, u: FloatArray) -> bool:
        """Whether a joint is beyond a limit."""
        return self.kernel.limited and self._clamped(u)[1] > TOLERANCES.limit

    def _known(self, u: FloatArray, kept: list[_Kept], *, singular: bool) -> int | None:
        """Which of those kept a solution is."""
        for number, each in enumerate(kept):
            if self._taken_for(each.u, u, loose=singular and each.singular):
                return number
        return None

    def _taken_for(self, known: FloatArray, u: FloatArray, *, loose: bool) -> bool:
        """Whether a solution is taken for one that is known; loosely where both are singular."""
        way = self.wrapped(u - known)
        gap = float(np.abs(way).max())
        if gap < constants.SAME:
            return True
        return loose and gap < constants.NEIGHBOURS and self._solves_between(known, way)

    def _solves_between(self, u: FloatArray, way: FloatArray) -> bool:
        """Whether solutions lie all along the way from one to another.

        Where many roots meet, joint values beside the solution miss the pose by next to nothing.
        """
        starts, enough = u + np.array(constants.BETWEEN)[:, None] * way, self._enough(u)
        there = starts
        for _ in range(constants.STEPS_ASIDE):
            e, length, A = self.miss(there)
            step = damped_step(e, length, A, constants.FLOOR)
            there = there + np.where(length[:, None] <= enough, 0.0, step)
        moved = np.abs(there - starts).max(axis=1)
        stays = moved <= constants.STAYS * np.abs(way).max()
        return bool(((self.miss(there)[1] <= enough) & stays).all())

    def wrapped(self, u: FloatArray) -> FloatArray:
        """Angles moved by whole turns into (-pi, pi]."""
        return np.asarray(np.where(self.turns, u - 2 * np.pi * np.ceil(u / (2 * np.pi) - 0.5), u))

    def descend(self, u: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Where starts (N, k) lead, and by how much that misses the pose (N,).

        With little damping a step that is right may be long where many roots meet, and what it
        leaves, half of its square, far more than was missed.
        """
        best, least, last = u, np.full(len(u), np.inf), np.full(len(u), np.inf)
        left = np.zeros(len(u))
        floor = np.full(len(u), constants.FLOOR)
        running = np.ones(len(u), dtype=bool)
        for _ in range(constants.STEPS + 1):
            e, length, A = self.miss(u)
            slow = length >= np.maximum(0.5 * last, left)
            fine = floor < constants.FLOOR
            stalled = slow & (least <= np.where(fine, TOLERANCES.polished, TOLERANCES.exact))
            floor[slow & (least <= constants.NEARLY)] = constants.FINE
            better = running & (length < least)
            best, least = np.where(better[:, None], u, best), np.where(better, length, least)
            running &= ~stalled
            if not running.any():
                break
            step = shortened(damped_step(e, length, A, floor))
            u = np.where(running[:, None], u + step, u)
            way = np.where(floor < constants.FLOOR, np.abs(step).sum(axis=1), 0.0)
            last, left = length, 0.5 * way**2
        return best, least

    def continues(self, u: FloatArray, along: FloatArray, enough: float) -> bool:
        """Whether solutions, that miss by no more than `enough`, lie to both sides of u.

        Along a direction: u is one of a continuum then.
        """
        feelers = np.array([u + constants.FEELER * along, u - constants.FEELER * along])
        ends, length = self.descend(feelers)
        apart = np.abs([*(ends - u), ends[0] - ends[1]]).max(axis=1)
        return bool((length <= enough).all() and (apart > constants.FELT).all())

    def pulled(self, u: FloatArray, enough: float) -> FloatArray:
        """The solution of the same continuum that is near to the seed, limits aside."""
        unlimited = np.full(len(u), np.inf)
        end, _ = self._pull(u, (-unlimited, unlimited))
        ends, length = self.descend(end[None])
        return ends[0] if length[0] <= enough else u

    def _inside(
        self, u: FloatArray, kept: list[_Kept], enough: float, *, alone: bool
    ) -> FloatArray:
        """Instead of one that is beyond a limit a solution that keeps all of them.

        If the way to the seed inside the limits leads to one, from there or from the seed; where
        it stands alone to one that is taken for it and as exact as a row has to be.
        """
        if not self._beyond(u):
            return u
        for start in (u, self.seed):
            end, length = self._pull(self._clamped(start)[0], self.limits)
            if length > enough:
                continue
            ends = self._leads_inside(u, end) if alone else [end]
            for end in ends:
                new = self._known(end, kept, singular=True) is None
                if new and (not alone or self._taken_for(u, end, loose=True)):
                    return end
        return u

    def _leads_inside(self, u: FloatArray, start: FloatArray) -> list[FloatArray]:
        """Where joint values on a way from u lead, if that keeps all limits.

        It has to be as exact as a row has to be. Farther on if steps lead back.
        """
        way = self.wrapped(start - u)
        ends, lengths = self.descend(start + np.array(constants.FARTHER_ON)[:, None] * way)
        found = zip(ends, lengths, strict=True)
        good = (end for end, length in found if length <= TOLERANCES.promised)
        return [end for end in good if not self._beyond(end)][:1]

    def _clamped(self, u: FloatArray) -> tuple[FloatArray, float]:
        """The nearest values inside the limits, whole turns aside, and how far one was beyond.

        Values just beyond an end, next to the seed's, stay there.
        """
        with np.errstate(invalid="ignore"):  # joints without limits have no middle
            middle = np.mean(self.limits, axis=0)
        turns = self.turns & np.isfinite(middle)
        near = np.where(turns, u - 2 * np.pi * np.floor((u - self.seed) / (2 * np.pi) + 0.5), u)
        low, high = self.limits
        past = np.maximum(low - near, near - high)
        far = np.abs(near - self.seed) >= constants.BESIDE_SEED
        whole = 2 * np.pi * np.ceil((near - np.where(turns, middle, 0.0)) / (2 * np.pi) - 0.5)
        near = near - np.where(turns & ((past >= TOLERANCES.doubtful) | far), whole, 0.0)
        inside = np.clip(near, low, high)
        return inside, float(np.abs(inside - near).max())

    def nearest(self) -> Found:
        """Of infinitely many solutions one near to the seed, inside the limits if possible."""
        k = self.kernel
        unlimited = np.full(len(self.solved), np.inf)
        for limits in (self.limits, (-unlimited, unlimited)):
            best, least = None, np.inf
            for start in self.starts(0, constants.REDUNDANT_STARTS):
                u, length = self._pull(np.clip(start, *limits), limits)
                distance = float(np.sum((u - self.seed) ** 2))
                if length <= k.residual and distance < least:
                    best, least = u, distance
            if best is not None:
                return Found(self.joints(self.wrapped(best)[None]), np.zeros(1, dtype=bool))
        return Found(np.empty((0, len(self.q))), np.zeros(0, dtype=bool))

    def _pull(self, u: FloatArray, limits: Limits) -> tuple[FloatArray, float]:
        """A solution on the way from u to the seed: constrained Gauss-Newton, limits by locking."""
        pull, least, best, near = constants.PULL, np.inf, u, np.clip(self.seed, *limits)
        for number in range(constants.PULLED + constants.STEPS):
            e, length, A = self.miss(u[None])
            if pull == 0.0:
                if length[0] >= 0.5 * least and least <= TOLERANCES.polished:
                    break
                if length[0] < least:
                    best, least = u, float(length[0])
            step = self._limited(u, pull * (near - u), (e, length, A), limits)
            u = u + step
            if number + 1 >= constants.PULLED or np.abs(step).max() < constants.SETTLED:
                pull = 0.0
        return best, least

    def _limited(
        self,
        u: FloatArray,
        pull: FloatArray,
        missing: tuple[FloatArray, FloatArray, FloatArray],
        limits: Limits,
    ) -> FloatArray:
        """A step; joints that it would take beyond a limit are put there, and locked."""
        e, length, A = missing[0], missing[1], missing[2].copy()
        low, high = limits
        pull, fixed = pull.copy(), np.zeros(len(u))
        locked = np.zeros(len(u), dtype=bool)
        while True:
            towards = damped_step(e - A @ pull, length, A, constants.FLOOR)[0]
            step = shortened((pull + towards)[None])[0] + fixed
            beyond = ~locked & ((u + step < low) | (u + step > high))
            if not beyond.any():
                return np.asarray(step)
            fixed = np.where(beyond, np.clip(u + step, low, high) - u, fixed)
            e = e - (A @ np.where(beyond, fixed, 0.0))
            locked |= beyond
            A[:, :, beyond] = 0.0
            pull[beyond] = 0.0


def damped_step(
    e: FloatArray, length: FloatArray, A: FloatArray, floor: float | FloatArray
) -> FloatArray:
    """The damped least squares step, A' (A A' + damping)^-1 e, by singular values.

    `floor` is the least damping.
    """
    damping = constants.DAMPING * np.minimum(length**2, 1.0) + floor
    U, values, across = np.linalg.svd(A, full_matrices=False)
    parts = (np.swapaxes(U, 1, 2) @ e[..., None])[..., 0]
    parts *= values / (values**2 + damping[..., None])
    return np.asarray((parts[:, None, :] @ across)[:, 0])


def sideways(A: FloatArray) -> tuple[FloatArray, float]:
    """The part of a generic direction (k,) that leaves the tool where it is, to first order.

    It is made one long; the second is how long it was. `A` (1, m, k) tells how joints move the
    tool.
    """
    direction = np.array(strides(A.shape[-1]))
    step = damped_step(A @ direction, np.zeros(1), A, constants.FLOOR)[0]
    along = direction - step
    length = float(np.linalg.norm(along))
    return along / length if length else along, length


def shortened(steps: FloatArray) -> FloatArray:
    """Steps (..., k), no longer than they may be."""
    longest = np.abs(steps).max(axis=-1, initial=constants.LONGEST)
    return np.asarray(steps * (constants.LONGEST / longest)[..., None])
