# SPDX-License-Identifier: MIT
"""The public functions of arms of one kind, whose tables come at run time.

`of_kind` makes the compiled ones anew for a kind, with the names that are declared below. They get
an arm as the array of its numbers.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from .arguments import BYTE, FLOAT, array_of, demand_array, of_each, results
from .arm import SOLVES, descents_of
from .arrays import NONE_GIVEN
from .calibrated import (
    JOINTS,
    TAKEN,
    blank_numbers,
    calibrate,
    kind_numbers,
    near_angles,
    nominal_pose,
)
from .calibration import LEFT, MOVED, NUMBERS, RIGHT, TURNED, calibration_of
from .careful import careful_ik
from .entry import Choice, again, demand_filled, poses_of, share
from .functions import compilers_of, unreachable
from .general.compiled import compile_apart as compile_general
from .general.near import fill_corrected, filled_of, near_pose
from .general.postures import place_rows, posture_of
from .general.rows import all_joints
from .jit import COMPILED, overload
from .pose import read_pose
from .refused_tables import refusal
from .serial import OWN as SERIAL
from .serial import serial_jacobian, serial_pose
from .status import INVALID_POSE, UNREACHABLE
from .velocities import find_velocities
from .words import no_pose, no_row

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from numpy.typing import ArrayLike

    from .arm import Pose, Robot
    from .arrays import Bytes, Floats, Ints
    from .calibrated import Kind
    from .functions import Formulas
    from .jit import Compiling

# Of the kind:
ROWS: int
places: Ints  # of the joints' values of each row, (rows, joints)
filled_at: Callable[[Floats, Floats, float, float], tuple[Floats, bool]]
robot: Callable[[], Robot]  # its functions, by their addresses
shapes: str  # what is said of arrays with another shape
ALL_NUMBERS: int  # how many an arm has


def solve(
    pose: Pose,
    q_free: Floats,
    seed: Floats,
    moved: float,  # noqa: ARG001
    q: Floats,
    status: Bytes,
) -> None:
    """Fills the rows that have a solution, and no others.

    The runtime hands what callers give, the values of given joints, to the solver as it is. Arms of
    a kind have no such joint: in their place the solver gets the arm.
    """
    if COMPILED and solve_from_nominal(q_free, pose, q, status):
        return
    all_joints(descents_of(q_free), pose, np.empty(0), seed, q, status)
    to_nominal_rows(q_free, q, status)


def solve_from_nominal(arm: Floats, pose: Pose, q: Floats, status: Bytes) -> bool:
    """Fills the rows of solutions where the nominal arm's rows lead to all.

    Returns whether they do. That no other branch has a solution is certain, that none has a second
    one is not proven.
    """
    of = calibration_of(arm)
    own = near_pose(pose, of[LEFT : LEFT + 12], of[RIGHT : RIGHT + 12])
    filled, ends = filled_at(own, NONE_GIVEN, of[TURNED], of[MOVED])
    if ends:
        return False
    rows, angles = near_angles(of, filled, places)
    return fill_corrected(descents_of(arm), pose, np.empty(0), rows, angles, q, status)


def to_nominal_rows(arm: Floats, q: Floats, status: Bytes) -> None:
    """Moves rows that ascend to those of their postures."""
    of, values, postures = calibration_of(arm), np.empty(JOINTS), np.full(ROWS, -1)
    for row in range(ROWS):
        if status[row] != UNREACHABLE:
            filled, ends = filled_at(nominal_pose(of, q[row], values), NONE_GIVEN, 0.0, 0.0)
            if not ends:
                postures[row] = posture_of(filled, places, values)
    place_rows(postures, len(places), q, status)


def seeded(arm: Floats, T: Floats, q: Floats, status: Bytes, seed: Floats) -> int:
    """All solutions of a pose, into arrays of any layout; how many are OK or FREE_JOINT."""
    if T.shape != (4, 4) or q.shape != (ROWS, JOINTS) or status.shape != (ROWS,):
        raise ValueError(shapes)
    if seed.shape != (JOINTS,):
        raise ValueError("q_seed must have as many values as the arm has joints")
    if arm.shape != (ALL_NUMBERS,):
        raise ValueError("the first argument must be the numbers of an arm of this kind")
    valid, pose = read_pose(T)
    for row in range(3):
        valid = valid and math.isfinite(pose[4 * row + 3])
    values, rows, kinds = np.empty(JOINTS), np.empty((ROWS, JOINTS)), np.empty(ROWS, np.uint8)
    for i in range(JOINTS):
        values[i] = seed[i]
        if not math.isfinite(values[i]):
            raise ValueError("q_seed must be finite")
    if not valid:
        status[:] = INVALID_POSE
        q[:] = math.nan
        return 0
    count = careful_ik(arm, robot(), pose, arm, values, rows, kinds)
    for row in range(ROWS):
        status[row] = kinds[row]
        for i in range(JOINTS):
            q[row, i] = rows[row, i]
    return count


def many(arm: Floats, T: Floats, q: Floats, status: Bytes) -> None:
    """All solutions of many poses, one after another."""
    seed = np.zeros(JOINTS)
    for k in range(len(T)):
        seeded(arm, T[k], q[k], status[k], seed)


def pose_at(arm: Floats, q: Floats) -> Floats:
    """The pose of joint values."""
    return serial_pose(calibration_of(arm), q)


def jacobian_at(arm: Floats, q: Floats) -> Floats:
    """The Jacobian at joint values."""
    return serial_jacobian(calibration_of(arm), q)


def velocities_at(arm: Floats, q: Floats, twist: Floats) -> Floats:
    """The joint velocities of a twist."""
    found = np.empty(JOINTS)
    find_velocities(arm, robot(), q, twist, found)
    return found


def compiled_into(
    arm: Floats, T: Floats, q: Floats, status: Bytes, q_seed: Floats | None = None
) -> int:
    """What `ik_into` is to other numba functions."""
    if q_seed is None:
        return seeded(arm, T, q, status, np.zeros(JOINTS))
    return seeded(arm, T, q, status, q_seed)


def ik_into(arm: Floats, T: Floats, q: Floats, status: Bytes, q_seed: Floats | None = None) -> int:
    """All solutions into the caller's arrays, for control loops and for other numba functions.

    Memory is allocated at every pose. numba compiles once more for arrays of another layout.

    Args:
        arm: What `numbers` of a calibrated arm is, float64.
        T: Pose (4, 4), float64.
        q: Filled with joint values (16, 6), NaN where there is no solution; float64.
        status: Filled with what each row holds (16,); uint8.
        q_seed: Values for joints that are indeterminate (6,), float64; zeros without it.

    Returns:
        How many rows are OK or FREE_JOINT.

    Raises:
        ValueError: An array has the wrong shape or type, or the seed is not finite.
    """
    try:
        return seeded(arm, T, q, status, np.zeros(JOINTS) if q_seed is None else q_seed)
    except Exception:
        # Types and shapes are looked at in there: only who fails is told which array it is.
        demand_array("numbers", arm, (ALL_NUMBERS,), FLOAT)
        demand_array("T", T, (4, 4), FLOAT)
        demand_filled(q, status, q_seed, (ROWS, JOINTS))
        raise


class CalibratedArm:
    """An arm with the table that it was given: only read, by any number of threads.

    Attributes:
        table: theta, d, a, alpha of each row at q = 0, (6, 4); can't be written to.
        numbers: What the table makes of the arm, as `ik_into` of the module takes it; not to be
            changed.
        turned: By how much its tool is turned to that of the nominal arm at most, once that has
            other zeros, base and tool [rad].
        moved: By how much it is away at most [length].
    """

    __slots__ = ("_calls", "_choice", "moved", "numbers", "table", "turned")

    def __init__(self, table: Floats, arm: Floats, calls: Mapping[str, Any]) -> None:
        """Takes what `calibrated` of the module worked out."""
        self.table, self.numbers, self._calls = table.view(), arm, calls
        self.table.flags.writeable = False  # the numbers would not follow
        self._choice: Choice = calls["choice"](arm)
        self.turned, self.moved = (float(arm[at - NUMBERS]) for at in (TURNED, MOVED))

    def __repr__(self) -> str:
        """The module, and by how much the arm differs."""
        module, unit = self._calls["__name__"], self._calls["unit"]
        differs = f"{self.turned:.2g} rad, {self.moved:.2g} {unit}"
        return f"<arm of {module}, from the nominal one at most {differs}>"

    def __reduce__(self) -> tuple[Any, tuple[Floats]]:
        """Another process works the table out again."""
        return self._calls["calibrated"], (self.table,)

    def fk(self, q: ArrayLike) -> Any:  # noqa: ANN401  numbers in the shape of the stack
        """The pose (4, 4) of joint values (6,), or of each in a stack of them."""
        return of_each(partial(self._calls["pose_at"], self.numbers), q, JOINTS)

    def jacobian(self, q: ArrayLike) -> Any:  # noqa: ANN401
        """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
        return of_each(partial(self._calls["jacobian_at"], self.numbers), q, JOINTS)

    def joint_velocities(self, q: ArrayLike, twist: ArrayLike) -> Floats:
        """The joint velocities (6,) with which the tool moves by a twist.

        They are those of least squares, of these the least, and exact where the arm is regular.
        Near a singular pose what the arm hardly can do is damped: no joint velocity exceeds a
        hundred times the twist, lengths in arm sizes.

        Args:
            q: Joint values (6,).
            twist: Velocity of the tool's origin, then angular velocity, in the base's frame (6,).

        Raises:
            ValueError: An argument has the wrong shape.
        """
        values = array_of(q, (JOINTS,), "q"), array_of(twist, (6,), "twist")
        found: Floats = self._calls["velocities_at"](self.numbers, *values)
        return found

    def ik_all(self, T: ArrayLike, q_seed: ArrayLike | None = None) -> tuple[Floats, Bytes]:
        """All solutions: q (16, 6) and status (16,), in rows by posture (BRANCHES).

        Args:
            T: Pose (4, 4).
            q_seed: Values for joints that are indeterminate at this pose (6,); zeros without it.

        Raises:
            ValueError: An argument has the wrong shape, or the seed is not finite.
        """
        seed = np.zeros(JOINTS) if q_seed is None else array_of(q_seed, (JOINTS,), "q_seed")
        rows = self._calls["ROWS"]
        q, status = np.empty((rows, JOINTS)), np.empty(rows, BYTE)
        self._calls["seeded"](self.numbers, array_of(T, (4, 4), "T"), q, status, seed)
        return q, status

    def ik(
        self,
        T: ArrayLike,
        q_seed: ArrayLike | None = None,
        *,
        branch: str | int | None = None,
        limits: bool = True,
    ) -> Floats:
        """One solution (6,): the nearest to the seed.

        Angles are moved by whole turns into their limits.

        Args:
            T: Pose (4, 4).
            q_seed: Where the arm is (6,); zeros without it.
            branch: Only this row: a name from BRANCHES, or its number.
            limits: Whether joint limits count: True or False.

        Raises:
            Unreachable: There is no such solution; the message says why.
            ValueError: T is not a valid pose, branch does not exist, or limits is not True or
                False.
        """
        rows = self._choice.rows(branch, limits)
        return self._choice.nearest(self.ik_all(T, q_seed), q_seed, rows, limits)

    def ik_batch(
        self,
        T: ArrayLike,
        *,
        cores: int | None = None,
        out: tuple[Floats, Bytes] | None = None,
    ) -> tuple[Floats, Bytes]:
        """ik_all for N poses (N, 4, 4), shared among `cores` cores, by default all of them.

        Args:
            T: Poses (N, 4, 4).
            cores: How many threads share the poses.
            out: The arrays q and status to write to, from an earlier call or like those.

        Returns:
            q (N, 16, 6) and status (N, 16).

        Raises:
            ValueError: An argument has the wrong shape, or cores is not a whole number from 1.
        """
        poses = poses_of(T, cores)
        q, status = results(out, (len(poses), self._calls["ROWS"], JOINTS))
        share(partial(self._calls["many"], self.numbers), cores, poses, q, status)
        return q, status

    def ik_into(self, T: Floats, q: Floats, status: Bytes, q_seed: Floats | None = None) -> int:
        """All solutions into the caller's arrays: `ik_into` of the module for this arm."""
        count: int = self._calls["ik_into"](self.numbers, T, q, status, q_seed)
        return count


@dataclass(frozen=True, slots=True)
class OwnKind:
    """What a generated module has of its own.

    Attributes:
        kind: What its arms have in common.
        formulas: The nominal arm at regular poses.
        unit: Of lengths.
    """

    kind: Kind
    formulas: Formulas
    unit: str


def of_kind(module: Mapping[str, Any], how: Compiling, own: OwnKind) -> dict[str, Any]:
    """The functions of a kind's module, and what they name, by their names.

    Args:
        module: The names of the module.
        how: How the functions of its file are compiled.
        own: What is its own.
    """
    rows, texts = module["MAX_SOLUTIONS"], globals()
    said = no_pose(module, "pose"), no_row(module, "pose", (True,) * 3), unreachable(module)
    kind, blank = kind_numbers(own.kind), blank_numbers(own.kind)
    names = {
        **texts,
        "places": own.formulas.table,
        "ROWS": rows,
        "ALL_NUMBERS": len(blank),
        "shapes": f"T, q and status must have shapes (4, 4), ({rows}, {JOINTS}), ({rows},)",
        "unit": own.unit,
        "__name__": module["__name__"],
    }

    def choice(arm: Floats) -> Choice:
        return Choice(arm, module["BRANCHES"], *said)

    def worked_out(table: Floats) -> tuple[Floats, int]:
        arm = blank.copy()
        with np.errstate(all="ignore"):  # in plain Python overflows would be warned of
            return arm, calibrate(kind, table.ravel(), arm)

    def calibrated(table: ArrayLike) -> CalibratedArm:
        """An arm of this kind.

        Args:
            table: Its table, theta, d, a, alpha of each row at q = 0, (6, 4): of the convention and
                in the units of NOMINAL.

        Raises:
            ValueError: The table has the wrong shape; it holds a number that is not finite, or is
                that of another arm; or three of its axes are parallel or meet as those of the
                nominal arm do, which has a closed form of its own. The message says where.
        """
        own_table = array_of(table, (JOINTS, 4), "table").copy()
        arm, fault = worked_out(own_table)
        if fault != TAKEN:
            raise ValueError(refusal(kind, blank, own_table, fault, own.unit))
        return CalibratedArm(own_table, arm, names)

    def warm_up() -> None:
        """Compiles everything, or gets it from numba's cache: no call waits for it later."""
        arm, _ = worked_out(np.array(own.kind.table))
        warm = CalibratedArm(np.array(own.kind.table), arm, names)
        zero = np.zeros(JOINTS)
        T = warm.fk(zero)
        warm.jacobian(zero)
        warm.joint_velocities(zero, zero)
        q, status = warm.ik_all(T)
        choice(arm).nearest_row(q, status, zero, True, np.empty(JOINTS))
        warm.ik_batch(T[np.newaxis])
        for compile_all in (
            how.compile_apart, SERIAL.compile_apart, compile_general, *compilers_of(blank),
        ):  # fmt: skip
            compile_all()

    def add(name: str, compiled: Callable[[Any], Any]) -> None:
        names[name] = compiled(again(texts[name], names))

    names["filled_at"] = filled_of(how, own.formulas, 0)
    add("solve_from_nominal", how.merged)
    add("to_nominal_rows", how.merged)
    add("solve", how.apart(SOLVES))
    names["robot"] = how.addresses("solve", None, None, None, None)
    for name in ("seeded", "pose_at", "jacobian_at", "velocities_at"):
        add(name, how.jit)
    add("many", how.njit(nogil=True))
    add("compiled_into", how.owned)
    names["ik_into"] = again(ik_into, names)
    overload(names["ik_into"], strict=False)(lambda *_, **__: names["compiled_into"])
    calibrated.__module__ = module["__name__"]
    calibrated.__qualname__ = "calibrated"  # by which arms are pickled
    names.update(
        choice=choice,
        Unreachable=said[-1],
        worked_out=worked_out,
        calibrated=calibrated,
        warm_up=warm_up,
    )
    return names
