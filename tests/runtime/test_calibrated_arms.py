"""What a table that comes at run time makes of an arm, against products of matrices by numpy."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from dhgen.runtime.python.calibration import (
    LEFT,
    LOOP,
    MORE,
    MOVED,
    NUMBERS,
    RIGHT,
    SIZE,
    TURNED,
)
from dhgen.runtime.python.general.arm import Formulation
from tests.runtime.arms import ENDLESS, arm_of, called
from tests.runtime.plain import KINDS, part

pytestmark = pytest.mark.parametrize("kind", KINDS)
# Axes 2, 3 and 4 are parallel, 4, 5 and 6 meet; joints 2 and 5 count backwards.
NOMINAL = (
    (0.1, 0.3, 0.0, math.pi / 2),
    (0.0, 0.05, 0.4, 0.0),
    (-0.2, 0.0, 0.35, 0.0),
    (0.0, 0.0, 0.0, -math.pi / 2),
    (0.3, 0.0, 0.0, math.pi / 2),
    (0.0, 0.1, 0.0, 0.0),
)
FACING = (1.0, -1.0, 1.0, 1.0, -1.0, 1.0)
BASE = (0.0, -1.0, 0.0, 0.2, 1.0, 0.0, 0.0, -0.1, 0.0, 0.0, 1.0, 0.4)
TOOL = (0.6, 0.0, 0.8, 0.02, 0.0, 1.0, 0.0, 0.03, -0.8, 0.0, 0.6, 0.1)
ADVANCES = ((0.6, 0.8), (0.8, 0.6), (0.28, 0.96), (0.8, -0.6), (0.6, -0.8), (0.96, 0.28))
CONVENTIONS = ["standard", "modified"]


def model(kind: str, convention: str) -> tuple[Any, Any]:
    """The numbers of a kind of arms, and of one without a table."""
    calibrated = part(kind, "calibrated")
    arm = arm_of(
        "RRRRRR", (ENDLESS,) * 6, rows=16, directions="rotation", size=1.2, weights=(1.0,) * 6
    )
    own = calibrated.Kind(
        arm=arm,
        table=NOMINAL,
        convention=convention,
        facing=FACING,
        reach=4.0,
        advances=ADVANCES,
        formulations=(Formulation((0, 1, 2, 3, 4, 5), 1.0),),
        base=BASE,
        tool=TOOL,
        # Of the modified convention these are other axes: those of the rows before.
        parallel=(1,) if convention == "standard" else (),
        meeting=(3,) if convention == "standard" else (),
    )
    return calibrated.kind_numbers(own), calibrated.blank_numbers(own)


def table_with_errors(noise: float) -> np.ndarray:
    return np.array(NOMINAL) + np.random.default_rng(3).normal(0.0, noise, (6, 4))


def worked_out(kind: str, convention: str, table: np.ndarray) -> tuple[Any, int]:
    """The numbers of an arm, and what is said of its table."""
    numbers, arm = model(kind, convention)
    said = part(kind, "calibrate").calibrate(numbers, np.ravel(table).copy(), arm)
    return arm, said


def whole(rows: Any) -> np.ndarray:
    return np.vstack([np.reshape(rows, (3, 4)), [0.0, 0.0, 0.0, 1.0]])


def screw(axis: int, angle: float, along: float) -> np.ndarray:
    """A turn about an axis and a move along it."""
    T, (i, j) = np.eye(4), ((axis + 1) % 3, (axis + 2) % 3)
    T[i, i] = T[j, j] = math.cos(angle)
    T[j, i] = math.sin(angle)
    T[i, j] = -T[j, i]
    T[axis, 3] = along
    return T


def pose(convention: str, table: Any, q: np.ndarray) -> np.ndarray:
    """Forward kinematics factor by factor."""
    T = whole(BASE)
    for (theta, d, a, alpha), facing, value in zip(table, FACING, q, strict=True):
        z, x = screw(2, theta + facing * value, d), screw(0, alpha, a)
        T = T @ z @ x if convention == "standard" else T @ x @ z
    return np.asarray(T @ whole(TOOL))


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_poses_and_rates_are_those_of_the_table(kind: str, convention: str) -> None:
    table, step = table_with_errors(1e-3), 1e-6
    arm, _ = worked_out(kind, convention, table)
    of, serial = arm[-NUMBERS:], "serial"
    for q in np.random.default_rng(5).uniform(-3.0, 3.0, (5, 6)):
        T = called(kind, serial, "serial_pose")(of, q)
        np.testing.assert_allclose(T, pose(convention, table, q), atol=1e-14)
        J = called(kind, serial, "serial_jacobian")(of, q)
        for joint in range(6):
            ahead, back = (pose(convention, table, q + s * np.eye(6)[joint]) for s in (step, -step))
            rate = (ahead - back) / (2.0 * step)
            spin = rate[:3, :3] @ T[:3, :3].T
            expected = [*rate[:3, 3], spin[2, 1], spin[0, 2], spin[1, 0]]
            np.testing.assert_allclose(J[:, joint], expected, atol=1e-9)
        # as the runtime asks arms, which have no functions of their own then
        robot = part(kind, "jit").of_file(__file__).addresses(*[None] * 5)
        asked = called(kind, serial, "forward"), called(kind, serial, "rates")
        if kind == "plain":
            np.testing.assert_array_equal(asked[0](arm, robot(), q), T)
            np.testing.assert_array_equal(asked[1](arm, robot(), q), J)


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_the_loop_closes_with_short_links(kind: str, convention: str) -> None:
    """J(q1) K0 J(q2) ... K4 J(q6) = L T R, with the sum of links twice the length that is one."""
    table = table_with_errors(1e-3)
    arm, _ = worked_out(kind, convention, table)
    of = arm[-NUMBERS:]
    K = [whole(rows) for rows in of[LOOP : LOOP + 84].reshape(7, 12)]
    links = [np.linalg.norm(each[:3, 3]) for each in K[:5]]
    assert sum(links) == pytest.approx(2.0, rel=1e-12)
    for link in K[:5]:
        link[:3, 3] *= of[SIZE]
    q = np.random.default_rng(6).uniform(-3.0, 3.0, 6)
    closed = np.eye(4)
    for joint, (cosine, sine) in enumerate(ADVANCES):
        angle = FACING[joint] * q[joint] - math.atan2(sine, cosine)
        closed = closed @ screw(2, angle, 0.0) @ (K[joint] if joint < 5 else np.eye(4))
    np.testing.assert_allclose(closed, K[5] @ pose(convention, table, q) @ K[6], atol=1e-13)


@pytest.mark.parametrize("convention", CONVENTIONS)
def test_the_nearest_nominal_arm_is_at_most_so_far(kind: str, convention: str) -> None:
    table = table_with_errors(1e-4)
    arm, _ = worked_out(kind, convention, table)
    of, q = arm[-NUMBERS:], np.random.default_rng(7).uniform(-3.0, 3.0, (200, 6))
    left, right = whole(of[LEFT : LEFT + 12]), whole(of[RIGHT : RIGHT + 12])
    most = np.zeros(2)
    for values in q:
        T = left @ pose(convention, table, values) @ right
        N = pose(convention, NOMINAL, values + np.array(FACING) * of[MORE : MORE + 6])
        chord = np.linalg.norm(T[:3, :3] - N[:3, :3]) / math.sqrt(8.0)
        off = [2.0 * math.asin(chord), float(np.linalg.norm(T[:3, 3] - N[:3, 3]))]
        most = np.maximum(most, off)
    told = of[90:92]
    assert (most <= told).all()
    assert (most > 0.2 * told).all()


def test_tables_are_taken_or_not(kind: str) -> None:
    calibrate = part(kind, "calibrate")
    assert worked_out(kind, "standard", table_with_errors(1e-4))[1] == calibrate.TAKEN
    assert worked_out(kind, "standard", np.array(NOMINAL))[1] == calibrate.NO_MISS
    for row, column, by in ((1, 2, 0.2), (4, 3, 0.1), (2, 3, -0.1)):
        table = table_with_errors(1e-4)
        table[row, column] += by
        assert worked_out(kind, "standard", table)[1] == calibrate.ANOTHER_ARM
    zeros = table_with_errors(1e-4)
    zeros[:, 0] += [1.0, -2.0, 0.5, 3.0, -1.0, 2.0]  # other zeros are no deviation
    zeros[0, 1] += 5.0  # nor is a base that is elsewhere
    zeros[5] += [0.0, 3.0, 2.0, 0.7]  # or another tool
    assert worked_out(kind, "standard", zeros)[1] == calibrate.TAKEN


def turned_by(roll: float, pitch: float, yaw: float) -> np.ndarray:
    return np.asarray(screw(2, yaw, 0.0) @ screw(1, pitch, 0.0) @ screw(0, roll, 0.0))


def test_origins_stand_between_base_and_tool(kind: str) -> None:
    """Seven frames whose own turns and moves are products of matrices."""
    source = np.random.default_rng(11)
    origins = np.concatenate(
        [source.uniform(-0.4, 0.4, (7, 3)), source.uniform(-3.0, 3.0, (7, 3))], axis=1
    )
    numbers, arm = model(kind, "standard")
    part(kind, "calibrate").calibrate(numbers, np.ravel(origins).copy(), arm)
    for q in source.uniform(-3.0, 3.0, (5, 6)):
        T = whole(BASE)
        for (*place, roll, pitch, yaw), angle in zip(origins, [*(FACING * q), 0.0], strict=True):
            moved = np.eye(4)
            moved[:3, 3] = place
            T = T @ moved @ turned_by(roll, pitch, yaw) @ screw(2, angle, 0.0)
        found = called(kind, "serial", "serial_pose")(arm[-NUMBERS:], q)
        np.testing.assert_allclose(found, T @ whole(TOOL), atol=1e-14)


@pytest.mark.parametrize("place", [(0, 1), (1, 1), (2, 2), (4, 0), (5, 1), (5, 3)])
@pytest.mark.parametrize("value", [1e6, -1e200, 1e308])
def test_numbers_that_no_calibration_has(kind: str, place: tuple[int, int], value: float) -> None:
    calibrate, table = part(kind, "calibrate"), table_with_errors(1e-4)
    table[place] = value
    with np.errstate(all="ignore"):
        assert worked_out(kind, "standard", table)[1] == calibrate.ANOTHER_ARM


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_what_is_not_finite_leaves_nothing(kind: str, value: float) -> None:
    table = table_with_errors(1e-4)
    table[3, 2] = value
    arm, said = worked_out(kind, "standard", table)
    assert said == part(kind, "calibrate").NOT_FINITE
    assert np.isnan(arm[-NUMBERS:]).all()
    T = called(kind, "serial", "serial_pose")(arm[-NUMBERS:], np.zeros(6))
    assert np.isnan(T[:3]).all()


def test_links_stand_where_the_general_algorithm_reads_them(kind: str) -> None:
    """Its loop and its forward model are those of the table."""
    table, q = table_with_errors(1e-3), np.random.default_rng(8).uniform(-3.0, 3.0, 6)
    arm, _ = worked_out(kind, "standard", table)
    general = part(kind, "arm").descents_of
    numbers = general(arm) if kind == "plain" else arm[int(arm[26]) :]
    P, J = np.empty(12), np.empty((6, 6))
    called(kind, "numerical.forward", "forward")(numbers, q, P, J)
    np.testing.assert_allclose(whole(P), pose("standard", table, q), atol=1e-14)
    of = arm[-NUMBERS:]
    np.testing.assert_allclose(
        J, called(kind, "serial", "serial_jacobian")(of, q), rtol=0.0, atol=1e-14
    )
    T = pose("standard", table, q)[:3].ravel().copy()
    links = called(kind, "general.loop", "close")(numbers, T, np.empty(0))
    np.testing.assert_array_equal(links[:5], of[LOOP : LOOP + 60].reshape(5, 12))
    P = whole(of[LOOP + 60 : LOOP + 72]) @ whole(T) @ whole(of[LOOP + 72 :][:12])
    P[:3, 3] /= of[SIZE]
    np.testing.assert_allclose(whole(links[5]), P, atol=1e-14)


def test_normal_equations(kind: str) -> None:
    random = np.random.default_rng(9)
    A = random.normal(size=(8, 6))
    normal, b = A.T @ A, random.normal(size=6)
    found = b.copy()
    called(kind, "calibrate", "solve_normal")(normal.copy(), found)
    np.testing.assert_allclose(found, np.linalg.solve(normal, b), rtol=1e-9)


@pytest.mark.parametrize("twist", [math.pi / 2, math.pi / 3, 0.7, 0.25, 0.05])
@pytest.mark.parametrize("row", [0, 3])
def test_frames_may_be_anywhere_on_their_axes(kind: str, row: int, twist: float) -> None:
    """Frames slid along axes and turned about them are of an arm that differs by no more."""
    source, nominal = np.random.default_rng(12), np.array(NOMINAL)
    nominal[row, 3] = twist
    table = nominal + source.normal(0.0, 1e-4, (6, 4))
    origins, behind = [], np.eye(4)
    for theta, d, a, alpha in table:
        free = screw(2, source.uniform(-3.0, 3.0), source.uniform(-0.3, 0.3))
        origins.append(behind @ screw(2, theta, d) @ free)
        behind = np.linalg.inv(free) @ screw(0, alpha, a)
    numbers, blank = model(kind, "standard")
    numbers[part(kind, "calibrate").TABLE :] = nominal.ravel()
    arms = [blank.copy(), blank.copy()]
    places = np.array([place_of(each) for each in (*origins, behind)])
    for given, arm in ((table, arms[0]), (places, arms[1])):
        part(kind, "calibrate").calibrate(numbers, given.ravel().copy(), arm)
    own, other = (arm[TURNED - NUMBERS : MOVED - NUMBERS + 1] for arm in arms)
    np.testing.assert_allclose(other, own, rtol=0.1)
    assert (own < 0.01).all()


def place_of(T: np.ndarray) -> list[float]:
    """x, y, z, roll, pitch, yaw."""
    R = T[:3, :3]
    pitch = math.atan2(-R[2, 0], math.hypot(R[2, 1], R[2, 2]))
    return [*T[:3, 3], math.atan2(R[2, 1], R[2, 2]), pitch, math.atan2(R[1, 0], R[0, 0])]
