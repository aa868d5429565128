"""Beside a singular pose a joint on its limit is known to few digits, and is not beyond for that.

Rounding of the pose, over what is left of the singular value, puts such a joint up to 1e-3 rad
beyond; that it may stand on the limit, and the others follow, the pose itself tells to all digits.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from tests.compiling import library, written
from tests.structures import first_of
from tests.targets.calling import (
    FREE_JOINT,
    HELD,
    LANGUAGES,
    OK,
    OUT_OF_LIMITS,
    Solver,
    gap,
    in_single,
    in_single_by,
    nearest_in_single,
)
from tests.targets.made import (
    apart,
    folder,
    made_up,
    poses_of,
    residual,
    robot,
    robot_path,
    solving,
    without_numba,
)

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.arrays import FloatArray

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files


# Of arms: the joint, from 0, that makes them singular, and its value there.
SINGULAR = {"hard_wrist": (4, 0.0), "hard_stops": (4, 0.0), "puma560": (4, 0.0), "scara": (1, 0.0)}
BESIDE = tuple(10.0**-power for power in range(3, 12))
COUNT = 6  # poses at each distance
SLACK = 1.001e-9
BEYOND = 1e-6  # a limit, by a joint that is known to all digits


def limits(name: str) -> FloatArray:
    """Lowest and highest value of each joint, (2, n)."""
    none = (-np.inf, np.inf)
    return np.array([joint.limits or none for joint in robot(name).joints], dtype=float).T


def beside(name: str, near: float, held: tuple[int, ...] = ()) -> FloatArray:
    """Joint values inside the limits, so near to a singular pose; one stands on a limit (N, n)."""
    source = np.random.default_rng(12)
    low, high = (np.where(np.isfinite(each), each, 1.0) for each in limits(name))
    joint, place = SINGULAR[name]
    limited = np.flatnonzero([bool(each.limits) for each in robot(name).joints])
    others = held or [each for each in limited if each != joint]
    q = source.uniform(low, high, (COUNT, len(low)))
    q[:, joint] = place + near * source.uniform(0.5, 2.0, COUNT)
    for row in q:
        on = source.choice(others)
        row[on] = (low, high)[source.integers(2)][on]
    return np.asarray(q)


def inside(name: str, rows: FloatArray, slack: float) -> bool:
    low, high = limits(name)
    return bool(((low - slack <= rows) & (rows <= high + slack)).all())


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", SINGULAR)
def test_an_arm_that_stands_inside_its_limits_is_there(name: str, language: str) -> None:
    solver = Solver(name, language)
    for near in BESIDE:
        q = beside(name, near)
        for values, T in zip(q, poses_of(name, q), strict=True):
            rows, status = solver.all(T)
            held = rows[np.isin(status, (OK, FREE_JOINT))]
            assert len(held), (near, values.tolist(), status.tolist())
            assert inside(name, held, SLACK)
            assert residual(name, held, T) < 1e-12
            assert solver.nearest(T, values)[0] in {OK, FREE_JOINT}


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_cannot_be_rounding_is_beyond(language: str) -> None:
    """The wrist is nearly straight, and its joints hardly known; the gantry's slides are."""
    name, solver = "hard_stops", Solver("hard_stops", language)
    low, _ = limits(name)
    q = beside(name, 1e-5, (0,))
    q[:, 0] = low[0] - BEYOND
    q[:, (3, 5)] *= 0.9
    for values, T in zip(q, poses_of(name, q), strict=True):
        rows, status = solver.all(T, values)
        (row,) = rows[np.isin(status, HELD) & (np.abs(rows - values)[:, 4] < 1e-3)][:1]
        assert not np.isin(status, (OK, FREE_JOINT)).any()
        assert OUT_OF_LIMITS in status
        assert row[0] == pytest.approx(low[0] - BEYOND, abs=1e-12)


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_turn_beyond_its_limit_stays_there_too(language: str) -> None:
    name, solver = "puma560", Solver("puma560", language)
    _, high = limits(name)
    q = beside(name, 1e-4, (0,))
    q[:, 0] = high[0] + BEYOND
    for values, T in zip(q, poses_of(name, q), strict=True):
        rows, status = solver.all(T, values)
        same = np.array([apart(name, row[None], values).max() < 1e-6 for row in rows])
        assert (status[same] == OUT_OF_LIMITS).all()
        assert same.any()


@pytest.mark.parametrize("name", ["hard_wrist", "scara"])
def test_single_precision(name: str) -> None:
    """There a joint on its limit may come out beyond anywhere, not only beside singular poses."""
    for near in (0.3, 1e-3):
        q = beside(name, near)
        for values, T in zip(q, poses_of(name, q), strict=True):
            found, status = in_single(name, T, np.zeros(len(values)))
            held = found[np.isin(status, (OK, FREE_JOINT))].astype(float)
            assert len(held), (near, values.tolist(), status.tolist())
            assert inside(name, held, 3e-6)
            assert residual(name, held, T) < 5e-6


def test_single_precision_where_a_joint_could_be_turned() -> None:
    """With limits of two turns rounding turned such a joint, or the other wrist was nearer then."""
    source = np.random.default_rng(5)
    q = source.uniform(-2.5, 2.5, (100, 6))
    q[:, 4] = source.choice([-1.0, 1.0], 100) * 10.0 ** source.uniform(-3.0, -1.5, 100)
    q[:, 5] = source.choice(limits("ur5")[:, 5], 100)
    q = q.astype(np.float32).astype(float)
    for values, T in zip(q, poses_of("ur5", q), strict=True):
        status, found = nearest_in_single("ur5", T, values)
        assert status >= OK
        assert np.abs(found - values).max() < 0.2, values.tolist()


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_joint_that_is_beyond_its_end_is_turned(language: str) -> None:
    """It is looked at with care, as rounding might have put it there, and keeps its limits."""
    q = np.array([0.4, -1.1, 0.8, 0.7, 0.9, limits("ur5")[1, 5] + 3e-3])
    seed = q - [0.0, 0.0, 0.0, 0.0, 0.0, 4e-3]
    T = poses_of("ur5", q[None])[0]
    status, found = Solver("ur5", language).nearest(T, seed)
    assert status == OK
    assert inside("ur5", found[None], SLACK)
    assert residual("ur5", found[None], T) < 1e-12


# An elbow beside stretched, and a straight wrist whose joints are far from 0 by their limits.
STRAIGHT = [
    "theta: q, d: 0.4, alpha: pi/2, limits: [-170 deg, 170 deg]",
    "theta: q, a: 0.4, limits: [-170 deg, 170 deg]",
    "theta: q, alpha: pi/2, limits: [-170 deg, 170 deg]",
    "theta: q, d: 0.4, alpha: -pi/2, limits: [20 deg, 150 deg]",
    "theta: q, alpha: pi/2, limits: [-120 deg, 120 deg]",
    "theta: q, d: 0.1, limits: [20 deg, 150 deg]",
]


@pytest.mark.parametrize("language", LANGUAGES)
def test_of_a_continuum_that_rounding_hides_a_row_is_inside_all_limits(language: str) -> None:
    """The wrist came out bent by as much as the elbow: nothing was free, and no row was inside."""
    compiled = made_up("straight", STRAIGHT, "")
    solve = solving(compiled, language)
    low, high = np.array([joint.limits for joint in compiled.robot.joints], dtype=float).T
    source = np.random.default_rng(1)
    for elbow in (1e-4, 1e-5, 1e-8):
        q = source.uniform(low, high, (5, 6))
        q[:, 2], q[:, 4] = np.pi / 2 + elbow, 0.0
        for T in np.asarray(forward(compiled.robot, q), dtype=float):
            rows, status = solve(T, np.zeros(6))
            held = rows[np.isin(status, (OK, FREE_JOINT))]
            assert len(held), elbow
            assert ((low - SLACK <= held) & (held <= high + SLACK)).all()
            assert np.abs(forward(compiled.robot, held) - T).max() < 1e-11


GIVEN = [
    "theta: q, d: 0.3, alpha: -pi/2, limits: [-360 deg, 360 deg]",
    "theta: q, alpha: pi/2, limits: [-120 deg, 120 deg]",
    "theta: q, d: 0.4, alpha: pi/2, limits: [-30 deg, 60 deg]",
    "theta: q, alpha: -pi/2, limits: [-160 deg, 10 deg]",
    "theta: q, d: 0.4, alpha: -pi/2, limits: [-150 deg, 150 deg]",
    "theta: q, alpha: pi/2, limits: [-100 deg, 100 deg]",
    "theta: q, d: 0.1, limits: [-360 deg, 360 deg]",
]


@pytest.mark.parametrize("language", first_of(LANGUAGES))
def test_a_joint_that_is_given_beyond_its_limit_stays_there(language: str) -> None:
    """No row can be inside then, and none is: seven joints could move through, and it with them."""
    compiled = made_up("given_beyond", GIVEN, "free: [3]\n")
    solve = solving(compiled, language)
    low, high = np.array([joint.limits for joint in compiled.robot.joints], dtype=float).T
    q = np.random.default_rng(3).uniform(low, high, (20, 7))
    q[:, 2] = high[2] + 0.1
    q[::2, 1] = 0.0
    for values, T in zip(q, np.asarray(forward(compiled.robot, q), dtype=float), strict=True):
        given, seed = values[2:3], np.zeros(7)
        rows, status = solve(T, given, seed) if language == "Python" else solve(T, seed, given)
        assert not np.isin(status, (OK, FREE_JOINT)).any()
        assert (rows[status == OUT_OF_LIMITS, 2] == given).all()


# Joint 6 is turned down where it is above: (q - turn) + turn may round to what is inside.
TURNED_DOWN = [
    *STRAIGHT[:3],
    "theta: q, d: 0.4, alpha: -pi/2",
    STRAIGHT[4],
    "theta: q, d: 0.1, limits: [-215 deg, 4 deg]",
]


@pytest.mark.breadth
def test_single_precision_turns_no_joint_past_its_other_end() -> None:
    compiled = made_up("turned_down", TURNED_DOWN, "float32: true\n")
    assert compiled.single is not None
    solver = library(compiled.single, folder())
    source = np.random.default_rng(3)
    q = source.uniform(-1.5, 1.5, (400, 6))
    q[:, 4] = source.choice([-1.0, 1.0], 400) * source.uniform(0.5, 1.8, 400)
    q[:, 5] = np.radians(4.0) + source.uniform(0.0, 8e-6, 400)
    for T in np.asarray(forward(compiled.robot, q), dtype=float):
        rows, status = in_single_by(solver, T, np.zeros(6))
        held = rows[np.isin(status, (OK, FREE_JOINT))].astype(float)
        assert (held[:, 5] >= np.radians(-215.0) - 1e-5).all()


# A torch whose arm lies in a plane; turned to a right angle, many roots of its polynomial meet.
WELDING = """
name: welding
task: pointing
joints:
  - {theta: q, d: 0.4, a: 0.15, alpha: pi/2, limits: [-170 deg, 170 deg]}
  - {theta: q, a: 0.6, limits: [-30 deg, 150 deg]}
  - {theta: q, a: 0.5, limits: [-150 deg, 90 deg]}
  - {theta: q + pi/2, alpha: pi/2, limits: [-120 deg, 120 deg]}
  - {theta: q, d: 0.2, limits: [-200 deg, 200 deg]}
tool: {xyz: [0.05, 0, 0.3], rpy: [0, 40 deg, 0]}
"""
IN_PYTHON = (1, 6, 9)  # of the seeds: a beginning that would lead beyond the limit
FOLDED = np.array([np.pi / 2, 0.0, -5 * np.pi / 6, np.pi / 2, -np.pi / 2])


@pytest.mark.breadth
def test_where_many_roots_meet_a_joint_stands_on_its_limit(tmp_path: Path) -> None:
    """Joint values beside the solution miss the pose by next to nothing, some beyond the limit."""
    path = tmp_path / "welding.yaml"
    path.write_text(WELDING, encoding="utf-8")
    compilation = written(path, tmp_path)
    solver = library(compilation.module, tmp_path)
    python = without_numba(compilation.files["welding.py"], "welding")
    T, source = solver.fk(FOLDED), np.random.default_rng(0)
    low, high = np.array([joint.limits for joint in compilation.module.chain.joints]).T
    for k in range(40):
        seed = FOLDED + 3e-3 * source.standard_normal(5)
        nearest = solver.nearest(T, seed)
        assert ((low - SLACK <= nearest) & (nearest <= high + SLACK)).all()
        np.testing.assert_allclose(solver.fk(nearest)[:3, 2:], T[:3, 2:], atol=1e-10)
        if k in IN_PYTHON:
            assert nearest == pytest.approx(python.ik(T, seed), abs=1e-4)


# Joint 4, and joint 5, on a limit; the neighbour is 0.05 rad away and less than 0.01 beyond.
PAIRS = (
    (2.964361747661, -0.653272339, 1.576689153997, -3.05432619099, 0.259248386970, 2.537758300),
    (0.414626909283, -2.496362182, -0.840350768202, 2.726142525809, -3.05432619099, -0.794635542),
)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("joints", PAIRS)
def test_a_solution_beyond_a_limit_is_not_led_to_its_neighbour(
    joints: tuple[float, ...], language: str
) -> None:
    """At a regular pose it is known to all digits, and stays where it is."""
    q = np.array(joints)
    T = poses_of("close_pair", q[None])[0]
    rows, status = Solver("close_pair", language).all(T)
    held = np.isin(status, HELD)
    rows, status = rows[held], status[held]
    near = gap(rows, q) < 0.1
    assert sorted(status[near]) == [OK, OUT_OF_LIMITS]
    assert gap(rows[near & (status == OK)], q).max() < 1e-9
    assert gap(rows[near & (status == OUT_OF_LIMITS)], q).min() > 0.01
    assert residual("close_pair", rows, T) < 1e-9


# Of an arm without a closed form: joint values beside a singular pose, and a seed, both inside the
# limits, a joint next to the end of a whole turn; the pose has solutions just beyond that, too.
NEXT_TO_AN_END = (
    (
        (-3.1415919592, -3.1415873285, -3.1415918249, 1.5707985130, -0.1710473692, 1.5707962793),
        (-3.1415926535, -3.1402580106, -3.1422616272, 1.5747907961, -0.1711619284, 1.5719403325),
    ),
    (
        (0.7853996232, 3.1415778299, -1.5707847908, 2.30421778, -5.3938e-06, 2.2257976658),
        (0.7865, 3.1371, -1.5723, 2.3051, -0.0004, 2.2263),
    ),
    (  # of two solutions that are taken for one the other is 1e-5 beyond
        (1.5707899672, 3.1415756787, -1.570782234, 1.8237289351, 3.141592653, -1.5707777326),
        (1.5712, 3.141592653, -1.5707, 1.8263, 3.141592653, -1.5711),
    ),
)


@pytest.mark.breadth
@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize(("joints", "near"), NEXT_TO_AN_END)
def test_a_general_arm_does_not_turn_to_the_other_end(
    joints: tuple[float, ...], near: tuple[float, ...], language: str
) -> None:
    q, seed = np.array(joints), np.array(near)
    T = poses_of("abb_gofa_5", q[None])[0]
    status, nearest = Solver("abb_gofa_5", language).nearest(T, seed)
    assert status in {OK, FREE_JOINT}
    assert inside("abb_gofa_5", nearest[None], SLACK)
    assert residual("abb_gofa_5", nearest[None], T) < 1e-11
    assert np.abs(nearest - seed).max() < 0.01


# The largest angle, and the number of a generator whose joint values rounding puts beyond it.
@pytest.mark.breadth
@pytest.mark.parametrize(("most", "number"), [(270, 20), (90, 31)])
def test_the_seed_is_a_solution_with_several_joints_on_limits(
    most: int, number: int, tmp_path: Path
) -> None:
    """Two singular places at once: which of a row's joints are beyond limits rounding decides."""
    path = tmp_path / "walker.yaml"
    text = robot_path("walker").read_text(encoding="utf-8")
    path.write_text(text.replace("270 deg", f"{most} deg"), encoding="utf-8")
    compilation = written(path, tmp_path)
    solver = library(compilation.module, tmp_path)
    python = without_numba(compilation.files["walker.py"], "walker")
    source, high = np.random.default_rng(number), np.deg2rad(most)
    right = source.integers(-3, 4, (40, 7)) * (np.pi / 2)
    off = 10.0 ** source.uniform(-10.0, -6.0, right.shape) * source.choice((-1.0, 1.0), right.shape)
    right = np.where(source.random(right.shape) < 0.6, right + off, right)
    for q in np.clip(right, -high, high):
        T = poses_of("walker", q[None])[0]
        for nearest in (solver.nearest(T, q, q[:1]), python.ik(T, q[:1], q)):
            assert np.abs(nearest - q).max() < 1e-2, q.tolist()


def asked_near(name: str, near: FloatArray) -> list[tuple[FloatArray, FloatArray, FloatArray]]:
    """Joint values of 40 poses, some next to these; their poses; and a seed next to each."""
    source = np.random.default_rng(21)
    q = np.where(np.isnan(near), source.uniform(-2.0, 2.0, (40, len(near))), near)
    q += np.where(np.isnan(near), 0.0, source.uniform(-0.95e-9, 0.95e-9, q.shape))
    low, high = limits(name)
    seeds = np.clip(q + source.uniform(-1e-3, 1e-3, q.shape), low, high)
    return list(zip(q, poses_of(name, q), seeds, strict=True))


@pytest.mark.parametrize("name", ["kawasaki_rs007n", "staubli_tx2_90"])
def test_what_rounding_leaves_beyond_a_limit_is_stayed_at(name: str) -> None:
    """The arm is level, its elbow and its wrist are straight, and joint 1 is on the end at pi."""
    solver = Solver(name, "C")
    near = np.array([np.pi, -np.pi / 2, 0.0, np.nan, 0.0, np.nan])
    for q, T, seed in asked_near(name, near):
        row = solver.nearest(T, seed)[1]
        assert np.abs(row - seed).max() < 0.02, (q, row)


def test_two_joints_beyond_their_ends_are_led_inside() -> None:
    """Axes 1 and 5 are parallel there, and with both joints on their ends the pose is missed."""
    solver, name = Solver("yaskawa_hc10", "C"), "yaskawa_hc10"
    near = np.array([np.pi - 1e-9, np.nan, 0.0, -np.pi / 2, np.pi - 1e-9, np.nan])
    for q, T, seed in asked_near(name, near):
        row = solver.nearest(T, seed)[1]
        assert np.abs(row - seed).max() < 0.02, (q, row)


LONG_ARM = (  # of the Canadarm2, with joint 1 given
    "theta: q + 90 deg, d: 0.635, alpha: 90 deg, limits: [-270 deg, 270 deg]",
    "theta: q + 90 deg, d: 0.51, alpha: 90 deg, limits: [-270 deg, 270 deg]",
    "theta: q, d: 0.504, a: 6.85, limits: [-270 deg, 270 deg]",
    "theta: q, d: 0.504, a: 6.85, limits: [-270 deg, 270 deg]",
    "theta: q + 180 deg, d: 0.504, alpha: 90 deg, limits: [-270 deg, 270 deg]",
    "theta: q - 90 deg, d: 0.51, alpha: 90 deg, limits: [-270 deg, 270 deg]",
    "theta: q + 180 deg, d: 0.635, alpha: 90 deg, limits: [-270 deg, 270 deg]",
)
END = 1.5 * np.pi
ON_ENDS = (  # several joints on the ends of their ranges, or nearly so, where the arm is singular
    (1.5707968, -END, END - 1.05e-7, -END, 0.0, -np.pi / 2, -np.pi / 2),
    (-8.6e-7, -np.pi, -END + 2.3e-10, -END, np.pi / 2, -np.pi / 2, -END),
    (np.pi / 2, END - 1.4e-8, -END, -np.pi / 2, -np.pi, -END, -np.pi),
    (-END, END - 1.1e-9, -1.8e-9, END, np.pi, END, np.pi),
)


@pytest.mark.breadth
def test_joints_are_put_on_their_ends_one_by_one() -> None:
    """The farthest first: with it the others come inside, and could not if they were held, too."""
    compilation = made_up("long_arm", LONG_ARM, "task: pose\nfree: [1]\n")
    solver = library(compilation.module, folder())
    source = np.random.default_rng(5)
    for joints in np.array(ON_ENDS):
        T = np.asarray(forward(compilation.robot, joints[None]), dtype=float)[0]
        for _ in range(40):
            seed = np.clip(joints + source.uniform(-5e-3, 5e-3, 7), -END, END)
            row = solver.nearest(T, seed, joints[:1])
            assert np.abs(row - seed).max() < 0.05, (joints, seed)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("near", [1e-3, 1e-4, 4e-5, 1e-5, 1e-6])
def test_a_row_just_beyond_a_limit_is_not_put_onto_another_row(near: float, language: str) -> None:
    """A nearly straight elbow, joint 1 on its limit: the other branch has it a little beyond."""
    end, solver = limits("scara")[1, 0], Solver("scara", language)
    for part in (1.0, 0.7, 0.4):
        joints = np.array([end, part * near, -0.1, 0.3])
        rows, status = solver.all(poses_of("scara", joints[None])[0])
        other = gap(rows, joints) > 0.5 * part * near
        assert status.tolist() == [OUT_OF_LIMITS if each else OK for each in other]
        assert other.sum() == 1
