# SPDX-License-Identifier: MIT
"""The public functions of arms of one kind, whose tables come at run time.

`of_kind` makes the compiled ones anew for a kind, with the names that are declared below. They get
an arm as the array of its numbers.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .arguments import BYTE, FLOAT, array_of, demand_array, numbers
from .arm import SOLVES, descents_of
from .arrays import NONE_GIVEN
from .calibrate import JOINTS, ORIGINS_SHAPE, TABLE_SHAPE, TAKEN, calibrate
from .calibrated import blank_numbers, kind_numbers, near_angles, nominal_pose
from .calibrated_arm import CalibratedArm
from .calibration import LEFT, MARGIN, MOVED, RIGHT, TURNED, calibration_of
from .careful import careful_ik
from .entry import Choice, again, demand_filled
from .functions import compilers_of, unreachable
from .general.compiled import compile_apart as compile_general
from .general.near import fill_corrected, filled_of, near_pose
from .general.postures import place_rows, posture_of
from .general.rows import all_joints
from .jit import COMPILED, overload
from .pose import read_pose
from .refused_numbers import Refused, refusal
from .serial import OWN as SERIAL
from .serial import serial_jacobian, serial_pose
from .status import INVALID_POSE, UNREACHABLE
from .velocities import find_velocities
from .words import no_pose, no_row

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping

    from numpy.typing import ArrayLike

    from .arm import Pose, Robot
    from .arrays import Bytes, Floats, Ints
    from .calibrated import Kind
    from .functions import Formulas
    from .jit import Compiling

SIX_ORIGINS = (JOINTS, ORIGINS_SHAPE[1])  # without the frame behind the last joint

# Of the kind:
ROWS: int
places: Ints  # of the joints' values of each row, (rows, joints)
filled_at: Callable[[Floats, Floats, float, float], tuple[Floats, bool]]
robot: Callable[[], Robot]  # its functions, by their addresses
shapes: str  # the message for arrays of another shape
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
    """Fills the rows of a pose if all its solutions lie next to the nominal arm's rows.

    Returns whether they do. That no other branch has a solution is certain, that none has a second
    one is not proven.
    """
    of = calibration_of(arm)
    own = near_pose(pose, of[LEFT : LEFT + 12], of[RIGHT : RIGHT + 12])
    margin = of[MARGIN]
    filled, ends = filled_at(own, NONE_GIVEN, margin * of[TURNED], margin * of[MOVED])
    if ends:
        return False
    rows, angles = near_angles(of, filled, places)
    return fill_corrected(descents_of(arm), pose, np.empty(0), rows, angles, q, status)


def to_nominal_rows(arm: Floats, q: Floats, status: Bytes) -> None:
    """Moves solutions, which ascend, to the rows of their postures."""
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
        if q.dtype != FLOAT or status.dtype != BYTE:  # numba would compile for these, too
            raise TypeError  # noqa: TRY301  what it is is said below
        return seeded(arm, T, q, status, np.zeros(JOINTS) if q_seed is None else q_seed)
    except Exception:
        # Types and shapes are checked in there: only after an error is the array named.
        demand_array("numbers", arm, (ALL_NUMBERS,), FLOAT)
        demand_array("T", T, (4, 4), FLOAT)
        demand_filled(q, status, q_seed, (ROWS, JOINTS))
        raise


def seven_origins(origins: ArrayLike) -> Floats:
    """A copy of origins (7, 6), with zeros for the frame behind the last joint if it is left out.

    Raises:
        ValueError: They are no real numbers, or have another shape.
    """
    given = numbers(origins, ORIGINS_SHAPE, "origins")
    if given.shape == SIX_ORIGINS:
        given = np.concatenate([given, np.zeros((1, SIX_ORIGINS[1]))])
    if given.shape != ORIGINS_SHAPE:
        shapes_taken = f"{ORIGINS_SHAPE} or {SIX_ORIGINS}"
        raise ValueError(f"origins must have shape {shapes_taken}, not {given.shape}")
    return given.copy()


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
    kind, blank = kind_numbers(own.kind), blank_numbers(own.kind)
    names = _names(module, own, len(blank))
    _add_compiled(names, how, own)
    names["Unreachable"] = unreachable(module)
    messages = no_pose(module, "pose"), no_row(module, "pose", (True,) * 3), names["Unreachable"]
    names["choice"] = lambda arm: Choice(arm, module["BRANCHES"], *messages)
    names["worked_out"] = _worked_out(kind, blank)
    for each in _constructors(names, kind, blank):
        each.__module__ = module["__name__"]
        each.__qualname__ = each.__name__  # by which arms are pickled
        names[each.__name__] = each
    compilers = (
        how.compile_apart, SERIAL.compile_apart, compile_general, *compilers_of(blank),
    )  # fmt: skip
    names["warm_up"] = _warm_up(names, own, compilers)
    return names


def _names(module: Mapping[str, Any], own: OwnKind, size: int) -> dict[str, Any]:
    """What the functions of a kind name, but for each other.

    Args:
        module: The names of the module.
        own: What is its own.
        size: How many numbers an arm has.
    """
    rows = module["MAX_SOLUTIONS"]
    return {
        **globals(),
        "places": own.formulas.table,
        "ROWS": rows,
        "ALL_NUMBERS": size,
        "shapes": f"T, q and status must have shapes (4, 4), ({rows}, {JOINTS}), ({rows},)",
        "unit": own.unit,
        "__name__": module["__name__"],
    }


def _add_compiled(names: dict[str, Any], how: Compiling, own: OwnKind) -> None:
    """Makes the compiled functions of a kind anew; each finds in `names` what it calls."""

    def add(name: str, compiled: Callable[[Any], Any]) -> None:
        names[name] = compiled(again(names[name], names))

    names["filled_at"] = filled_of(how, own.formulas, 0)
    add("solve_from_nominal", how.merged)
    add("to_nominal_rows", how.merged)
    add("solve", how.apart(SOLVES))
    names["robot"] = how.addresses("solve", None, None, None, None)
    for name in ("seeded", "pose_at", "jacobian_at", "velocities_at"):
        add(name, how.jit)
    add("many", how.njit(nogil=True))
    add("compiled_into", how.owned)
    add("ik_into", lambda function: function)
    overload(names["ik_into"], strict=False)(lambda *_, **__: names["compiled_into"])


def _worked_out(kind: Floats, blank: Floats) -> Callable[[Floats], tuple[Floats, int]]:
    """A function of a table, or origins: the numbers of that arm, and what `calibrate` returns."""

    def worked_out(given: Floats) -> tuple[Floats, int]:
        arm = blank.copy()
        with np.errstate(all="ignore"):  # in plain Python overflows would be warned of
            return arm, calibrate(kind, given.ravel(), arm)

    return worked_out


def _constructors(
    names: Mapping[str, Any], kind: Floats, blank: Floats
) -> tuple[Callable[[ArrayLike], CalibratedArm], ...]:
    """The functions that make arms of a kind, with the texts that users read."""

    def taken(given: Floats) -> CalibratedArm:
        arm, fault = names["worked_out"](given)
        if fault != TAKEN:
            raise ValueError(refusal(Refused(kind, blank, given, names["unit"]), fault))
        return CalibratedArm(given, arm, names)

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
        return taken(array_of(table, TABLE_SHAPE, "table").copy())

    def calibrated_by_origins(origins: ArrayLike) -> CalibratedArm:
        """An arm of this kind whose joints' frames are given, as in URDFs and drivers.

        Args:
            origins: x, y, z [the unit of NOMINAL] and roll, pitch, yaw [rad] of each joint's frame
                in the one before, all joint values zero, from base to tool, and of a frame behind
                the last joint, which is the same where that is left out: (7, 6), or (6, 6). The
                base of the robot file comes before them, its tool behind them. Joints turn about z,
                in the sense of the robot file.

        Raises:
            ValueError: As of `calibrated`.
        """
        return taken(seven_origins(origins))

    return calibrated, calibrated_by_origins


def _warm_up(
    names: Mapping[str, Any], own: OwnKind, compilers: Iterable[Callable[[], None]]
) -> Callable[[], None]:
    """The function that compiles what an arm of a kind needs, and the files of the runtime."""

    def warm_up() -> None:
        """Compiles everything, or gets it from numba's cache: no call waits for it later."""
        table, zero = np.array(own.kind.table), np.zeros(JOINTS)
        arm, _ = names["worked_out"](table)
        warm = CalibratedArm(table, arm, names)
        T = warm.fk(zero)
        warm.jacobian(zero)
        warm.joint_velocities(zero, zero)
        q, status = warm.ik_all(T)
        names["choice"](arm).nearest_row(q, status, zero, True, np.empty(JOINTS))
        warm.ik_batch(T[np.newaxis])
        for compile_all in compilers:
            compile_all()

    return warm_up
