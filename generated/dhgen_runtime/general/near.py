# SPDX-License-Identifier: MIT
"""The nearest arm with a structure: joint values next to all solutions, and postures.

`of_nearest` makes the compiled functions anew for a robot, with the names that are declared below.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np

from ..entry import again
from ..jit import COMPILED, of_file
from ..numerical.descent import wrap_angles
from ..numerical.goal import given_joints, take_units
from ..numerical.places import DOF
from ..rigid import follow, pose_of_links, take
from ..status import OK, UNREACHABLE
from ..tiles import ENTRIES
from .postures import place_rows, posture_of, rows_filled
from .rows import loop_in_units
from .search import corrected

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from ..arm import Pose
    from ..arrays import Bytes, Floats, Ints
    from ..functions import Formulas
    from ..jit import Compiling

OWN = of_file(__file__)
inner = OWN.inner

APART = 2  # numbers that formulas get last: by how much two arms' tools are turned and apart

# Of a robot, or of a kind of arms:
KEPT: int  # the sizes of the formulas' arrays
TURNS: int
FILLED: int
DOUBT: int  # the place of a number that is not zero where a row may end so near to the pose
formulas: Callable[[Floats, Floats, Floats, int], None]
# Of a robot:
arm: Floats  # its numbers
nearest: Floats  # the places below
places: Ints  # of the values of the loop's joints in each row, (rows, 6)
filled_at: Callable[[Floats, Floats, float, float], tuple[Floats, bool]]

# The places of a nearest arm's numbers in its array.
TURNED, MOVED = 0, 1  # how far its tool may be from that of the arm [rad, length]
LEFT, RIGHT = 2, 14  # the nearest arm's pose is left T right
OFFSETS = 26  # six: its angles minus the loop's
SOLVED = 32  # six: the places of the joints that are solved for
LINKS = 38  # C0 ... Cn of its pose C0 Rz(angle 1) C1 ... Rz(angle n) Cn; then its angles


@dataclass(frozen=True, slots=True)
class Nearest:
    """The nearest arm with a structure.

    Attributes:
        turned: By how much its tool and that of the arm are turned at most [rad].
        moved: By how much they are apart.
        left: The left factor that makes a pose this arm's, twelve numbers.
        right: The right factor.
        offsets: Its angles minus the loop's.
        solved: The places of the joints that are solved for.
        links: C0 ... Cn of its pose C0 Rz(angle 1) C1 ... Rz(angle n) Cn.
        angles: Each as the factors of all joint values, and what is added.
    """

    turned: float
    moved: float
    left: Sequence[float]
    right: Sequence[float]
    offsets: Sequence[float]
    solved: Sequence[int]
    links: Sequence[Sequence[float]]
    angles: Sequence[Sequence[float]]

    @property
    def numbers(self) -> Floats:
        """All of them as an array."""
        first = [self.turned, self.moved, *self.left, *self.right, *self.offsets, *self.solved]
        return np.concatenate([first, np.ravel(self.links), np.ravel(self.angles)])


@inner
def near_pose(pose: Pose, left: Floats, right: Floats) -> Floats:
    """Returns left T right, the pose of the nearest arm."""
    T, P = np.empty(12), np.empty(12)
    for i in range(12):
        T[i], P[i] = pose[i], left[i]
    follow(P, T)
    follow(P, right)
    return P


@inner
def fill_corrected(
    arm: Floats,
    pose: Pose,
    q_free: Floats,
    rows: Ints,
    angles: Floats,
    q: Floats,
    status: Bytes,
) -> bool:
    """Fills the rows with the solutions that angles of the loop are refined to, and no others.

    Returns whether all are exact, and no two of them near one another; if not, no row is filled.
    """
    T, u = np.empty(12), np.empty(6)
    for i in range(12):
        T[i] = pose[i]
    if not corrected(arm, T, q_free, angles):
        return False
    joints = given_joints(arm, q_free)
    for k in range(len(rows)):
        loop_in_units(arm, joints, angles[k], u)
        wrap_angles(arm, u)
        take_units(arm, u, joints)
        take(q[rows[k]], joints)
        status[rows[k]] = OK
    return True


def formulas_at(pose: Floats, given: Floats, turned: float, moved: float) -> tuple[Floats, bool]:
    """Returns what the formulas fill in at a pose of the nearest arm, and whether a row may end.

    Args:
        pose: Twelve numbers.
        given: The values of given joints.
        turned: By how much the pose may be turned for that [rad].
        moved: By how much it may be moved.
    """
    kept, turns, filled = np.zeros(KEPT), np.zeros(TURNS), np.zeros(FILLED)
    for i in range(12):
        kept[i] = pose[i]
    for i in range(DOUBT - APART - ENTRIES):
        kept[ENTRIES + i] = given[i]
    kept[DOUBT - 2], kept[DOUBT - 1] = turned, moved
    formulas(kept, turns, filled, len(kept) // KEPT)  # a literal would be a type of its own
    return filled, kept[DOUBT] != 0.0


def solve_from_nearest(pose: Pose, q_free: Floats, q: Floats, status: Bytes) -> bool:
    """Fills the rows of a pose if all its solutions lie next to the nearest arm's rows.

    Returns whether they do. That no other branch has a solution is certain, that none has a second
    one is not proven.
    """
    if not COMPILED:  # plain Python is not about time, and shows what the algorithm finds
        return False
    own = near_pose(pose, nearest[LEFT : LEFT + 12], nearest[RIGHT : RIGHT + 12])
    filled, ends = filled_at(own, q_free, nearest[TURNED], nearest[MOVED])
    if ends:
        return False
    rows = rows_filled(filled, len(places))
    angles = np.empty((len(rows), 6))
    for k in range(len(rows)):
        for i in range(6):
            angles[k, i] = filled[places[rows[k], i]] - nearest[OFFSETS + i]
    return fill_corrected(arm, pose, q_free, rows, angles, q, status)


def to_nearest_rows(q_free: Floats, q: Floats, status: Bytes) -> None:
    """Moves solutions, which ascend, to the rows of their postures."""
    dof = int(arm[DOF])
    angles, values, postures = np.empty(dof), np.empty(6), np.full(len(status), -1)
    for row in range(len(status)):
        if status[row] == UNREACHABLE:
            continue
        for i in range(dof):
            of = LINKS + 12 * (dof + 1) + (dof + 1) * i
            angles[i] = nearest[of + dof]
            for j in range(dof):
                angles[i] += nearest[of + j] * q[row, j]
        for i in range(6):
            values[i] = angles[int(nearest[SOLVED + i])] + nearest[OFFSETS + i]
        filled, ends = filled_at(pose_of_links(nearest, LINKS, angles), q_free, 0.0, 0.0)
        if not ends:
            postures[row] = posture_of(filled, places, values)
    place_rows(postures, len(places), q, status)


def _with_nan(run: Any) -> Callable[..., None]:  # noqa: ANN401  a function with its globals
    """Formulas whose values are NaN in plain Python where compiled ones are, and no exception."""
    as_compiled = SimpleNamespace(**{**vars(math), "sqrt": np.sqrt})
    formulas = again(run, {**run.__globals__, "math": as_compiled})

    def silent(*arrays: Floats) -> None:
        with np.errstate(all="ignore"):
            formulas(*arrays)

    return silent


def filled_of(how: Compiling, own: Formulas, given: int) -> Callable[..., tuple[Floats, bool]]:
    """`formulas_at` of a closed form.

    Args:
        how: How the functions of its file are compiled.
        own: The closed form.
        given: How many values the caller gives.
    """
    names: dict[str, Any] = {**globals(), **own.names(given + APART)}
    if not COMPILED:
        names["formulas"] = _with_nan(own.run)
    made: Callable[..., tuple[Floats, bool]] = how.merged(again(formulas_at, names))
    return made


def of_nearest(
    how: Compiling, numbers: Floats, own: Formulas, nearest_arm: Nearest, given: int
) -> tuple[Callable[..., bool], Callable[..., None]]:
    """`solve_from_nearest` and `to_nearest_rows` of a robot.

    Args:
        how: How the functions of its file are compiled.
        numbers: The arm's, as the general algorithm takes it.
        own: The closed form of the nearest arm.
        nearest_arm: Its numbers.
        given: How many values the caller gives.
    """
    names: dict[str, Any] = {
        **globals(),
        "filled_at": filled_of(how, own, given),
        "arm": numbers,
        "nearest": nearest_arm.numbers,
        "places": np.ascontiguousarray(own.table[:, nearest_arm.solved]),
    }
    made = (how.merged(again(each, names)) for each in (solve_from_nearest, to_nearest_rows))
    solve, place = made
    return solve, place
