"""Joint values where an arm is singular, found without knowing why it is.

One joint is turned (or moved) until the task's Jacobian loses rank, the others are anywhere. So
wrists come out straight, elbows stretched and folded, wrist centres on the first axis, whatever the
offsets are.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray

    Found = tuple[NDArray[np.intp], FloatArray]

TRIED = 3  # random arms for each that is wanted: some have no singular place along the joint
PLACES = 49  # along the joint, to see where the determinant changes its sign
BEYOND = 0.37  # [rad]
HALVINGS = 60
SECTIONS = 80
GOLDEN = 0.3819660112501051
SINGULAR = 1e-9  # least singular value, lengths in arm sizes


def whole_turns(
    low: FloatArray, high: FloatArray, turns: NDArray[np.bool_]
) -> tuple[FloatArray, FloatArray]:
    """The ranges to look along: zero and pi, where arms are straight, are to lie inside."""
    beyond = np.where(turns, BEYOND, 0.0)
    return low + beyond, high + beyond


def singular_places(
    rates: Callable[[FloatArray], FloatArray],
    q: FloatArray,
    joints: NDArray[np.intp],
    ends: tuple[FloatArray, FloatArray],
    chance: np.random.Generator,
) -> Found:
    """Arms of which one joint is moved to where the task's Jacobian loses rank.

    Args:
        rates: The task's Jacobian (..., m, k), lengths in arm sizes, at joint values (..., n).
        q: Joint values (N, n).
        joints: The joint that is moved in each of them (N,), from 0.
        ends: Where it starts and where it ends (N,), each.
        chance: Decides between several such places.

    Returns:
        The numbers of the arms that have one (M,), and their joint values (M, n).
    """
    line = _Line(q, joints, np.linspace(*ends, PLACES, axis=1))
    J = rates(line.everywhere())
    rows, columns = J.shape[-2:]
    if rows < columns:
        return np.empty(0, np.intp), q[:0]
    if rows == columns:
        found, reached = line.crossed(lambda q: _sign(rates(q)), _sign(J), chance)
    else:
        found, reached = line.touched(lambda q: _least(rates(q)), _least(J), chance)
    lost = _least(rates(reached)) < SINGULAR
    return found[lost], reached[lost]


@dataclass(frozen=True, slots=True)
class _Line:
    """Arms (N, n) whose joint (N,) is moved to places (N, PLACES)."""

    q: FloatArray
    joints: NDArray[np.intp]
    places: FloatArray

    def everywhere(self) -> FloatArray:
        """Joint values (N, PLACES, n)."""
        line = np.repeat(self.q[:, None], PLACES, axis=1)
        np.put_along_axis(line, self.joints[:, None, None], self.places[..., None], axis=2)
        return line

    def crossed(
        self,
        sign: Callable[[FloatArray], FloatArray],
        signs: FloatArray,
        chance: np.random.Generator,
    ) -> Found:
        """Where a sign changes, by bisection."""
        changes = signs[:, :-1] * signs[:, 1:] < 0
        found, cell = _any_of(changes, chance)
        left, right = self.places[found, cell], self.places[found, cell + 1]
        sign_left = signs[found, cell]
        for _ in range(HALVINGS):
            middle = (left + right) / 2
            same = sign(self._at(found, middle)) == sign_left
            left, right = np.where(same, middle, left), np.where(same, right, middle)
        return found, self._at(found, middle)

    def touched(
        self,
        value: Callable[[FloatArray], FloatArray],
        values: FloatArray,
        chance: np.random.Generator,
    ) -> Found:
        """Where what can't be negative is least, by golden section."""
        dips = (values[:, 1:-1] < values[:, :-2]) & (values[:, 1:-1] <= values[:, 2:])
        found, cell = _any_of(dips, chance)
        left, right = self.places[found, cell], self.places[found, cell + 2]
        for _ in range(SECTIONS):
            third = GOLDEN * (right - left)
            lower = value(self._at(found, left + third)) < value(self._at(found, right - third))
            left, right = np.where(lower, left, left + third), np.where(lower, right - third, right)
        return found, self._at(found, (left + right) / 2)

    def _at(self, numbers: NDArray[np.intp], values: FloatArray) -> FloatArray:
        q = self.q[numbers]
        q[np.arange(len(q)), self.joints[numbers]] = values
        return q


def _any_of(
    marks: NDArray[np.bool_], chance: np.random.Generator
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Rows that have a mark, and where one of each row's marks is, not always the first."""
    found, first = np.flatnonzero(marks.any(axis=1)), chance.random(marks.shape)
    return found, np.where(marks, first, -1.0).argmax(axis=1)[found]


def _sign(J: FloatArray) -> FloatArray:
    return np.asarray(np.sign(np.linalg.det(J)))


def _least(J: FloatArray) -> FloatArray:
    """The least singular value."""
    return np.asarray(np.linalg.svd(J, compute_uv=False)[..., -1])
