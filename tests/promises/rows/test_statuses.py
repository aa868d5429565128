"""What a row holds is what its status says: every status, every way to it, in both languages."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.poses import random_joints
from tests.oracle.sets import out_of_form, out_of_reach
from tests.structures import ODD, first_of
from tests.targets.calling import (
    FREE_JOINT,
    HELD,
    INVALID_POSE,
    LANGUAGES,
    OK,
    OUT_OF_LIMITS,
    UNREACHABLE,
    Solver,
)
from tests.targets.made import (
    NAMES,
    entries,
    given,
    in_c,
    in_python,
    made,
    poses_of,
    residual,
    robot,
)

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

BAD_NUMBERS = (np.nan, np.inf, -np.inf)


def test_the_numbers_are_those_that_callers_know() -> None:
    numbers = {
        "OK": 0,
        "UNREACHABLE": 1,
        "FREE_JOINT": 2,
        "OUT_OF_LIMITS": 3,
        "INVALID_POSE": 4,
    }
    module, files = in_python("puma560"), made("puma560").files
    for name, number in numbers.items():
        assert getattr(module, name) == number
        assert f"PUMA560_{name} = {number}" in files["puma560.h"]


def pose(name: str, seed: int = 1) -> FloatArray:
    return poses_of(name, random_joints(robot(name), 1, seed=seed)[0])


def spoiled() -> dict[str, FloatArray]:
    """Poses of the PUMA that are none."""
    poses = {}
    for row in range(3):
        for column in range(4):
            for number in BAD_NUMBERS:
                T = pose("puma560")
                T[row, column] = number
                poses[f"{number} at {row}, {column}"] = T
    for column in range(4):
        for number in (*BAD_NUMBERS, 0.5):
            T = pose("puma560")
            T[3, column] = number
            poses[f"last row {number} at {column}"] = T
    T = pose("puma560")
    for column in range(3):
        mirrored = T.copy()
        mirrored[:3, column] *= -1
        poses[f"mirrored {column}"] = mirrored
    for name, change in {
        "longer": np.diag([1.001, 1.001, 1.001]),
        "sheared": np.eye(3) + 1e-3 * np.eye(3, k=1),
        "flat": np.diag([1.0, 1.0, 0.0]),
        "nothing": np.zeros((3, 3)),
    }.items():
        bad = T.copy()
        bad[:3, :3] = T[:3, :3] @ change
        poses[name] = bad
    return poses


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize(("what", "T"), spoiled().items(), ids=spoiled())
def test_what_is_no_pose_is_invalid(what: str, T: FloatArray, language: str) -> None:
    del what
    q, status = Solver("puma560", language).all(T)
    assert status.tolist() == [INVALID_POSE] * 8
    assert np.isnan(q).all()
    result, nearest = Solver("puma560", language).nearest(T, np.zeros(6))
    assert result == -INVALID_POSE
    assert np.isnan(nearest).all()


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("length", [1.001, 0.0, np.nan])
def test_pointing_needs_a_unit_axis(language: str, length: float) -> None:
    T = pose("pointer")
    T[:3, 2] *= length
    assert (Solver("pointer", language).all(T)[1] == INVALID_POSE).all()


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", ["planar_rr", "arm_3r", "pointer", "wrist_zyz"])
def test_entries_that_the_task_does_not_name_may_be_anything(name: str, language: str) -> None:
    q = random_joints(robot(name), 5, seed=2)
    for T in poses_of(name, q):
        other = T.copy()
        other[:3][~entries(name)] = np.nan
        other[3] = np.inf
        rows, status = Solver(name, language).all(T)
        others, other_status = Solver(name, language).all(other)
        assert status.tolist() == other_status.tolist()
        np.testing.assert_array_equal(rows, others)
        assert (status != INVALID_POSE).all()


EVERY = [*NAMES, *ODD]
TURNING = [  # a slide reaches everything on its line; its limits say otherwise
    name for name in EVERY if all(joint.kind.name == "REVOLUTE" for joint in robot(name).joints)
]
BOUND = [name for name in EVERY if len(out_of_form(robot(name), 1))]


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", first_of(TURNING, count=9))
def test_far_away_is_unreachable(name: str, language: str) -> None:
    q = np.zeros(len(robot(name).joints))
    for T in out_of_reach(robot(name), 4):
        rows, status = Solver(name, language).all(T, None, *given(name, q))
        assert (status == UNREACHABLE).all()
        assert np.isnan(rows).all()
        assert Solver(name, language).nearest(T, q, *given(name, q))[0] == -UNREACHABLE


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", BOUND)
def test_poses_that_the_arm_can_not_take_are_unreachable(name: str, language: str) -> None:
    q = np.zeros(len(robot(name).joints))
    for T in out_of_form(robot(name), 4):
        status = Solver(name, language).all(T, None, *given(name, q))[1]
        assert (status == UNREACHABLE).all()


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("seed_value", [0.0, 0.7, -2.0])
def test_a_singular_wrist_takes_the_seed(language: str, seed_value: float) -> None:
    """PUMA 560 with q5 = 0: only q4 + q6 is fixed, q4 is the seed's, q6 follows."""
    q = random_joints(robot("puma560"), 30, seed=3) * 0.5
    q[:, 4] = 0.0
    seed = np.full(6, 0.1)
    seed[3] = seed_value
    for T, generating in zip(poses_of("puma560", q), q, strict=True):
        rows, status = Solver("puma560", language).all(T, seed)
        free = status == FREE_JOINT
        assert free.any()
        assert np.abs(rows[free, 3] - seed_value).max() < 1e-15
        np.testing.assert_allclose(poses_of("puma560", rows[free]), [T] * free.sum(), atol=1e-13)
        sums = rows[free, 3] + rows[free, 5] - generating[3] - generating[5]
        assert np.abs(np.angle(np.exp(1j * sums))).min() < 1e-7


@pytest.mark.parametrize("language", LANGUAGES)
def test_without_a_seed_it_is_zero(language: str) -> None:
    q = random_joints(robot("puma560"), 1, seed=4) * 0.5
    q[:, 4] = 0.0
    rows, status = Solver("puma560", language).all(poses_of("puma560", q)[0])
    assert (rows[status == FREE_JOINT, 3] == 0.0).all()


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_seed_is_only_used_where_a_joint_is_free(language: str) -> None:
    q = random_joints(robot("puma560"), 10, seed=5)
    for T in poses_of("puma560", q):
        without, _ = Solver("puma560", language).all(T)
        seeded, status = Solver("puma560", language).all(T, np.full(6, 0.5))
        assert FREE_JOINT not in status
        np.testing.assert_array_equal(without, seeded)


@pytest.mark.parametrize("language", LANGUAGES)
def test_beyond_the_limits_the_row_is_held(language: str) -> None:
    """Joint 3 of the SCARA slides between -0.2 and 0."""
    q = np.array([0.3, 0.8, -0.1, 1.0])
    for stroke, wanted in (
        (-0.1, OK),
        (-0.2, OK),
        (0.0, OK),
        (0.05, OUT_OF_LIMITS),
        (-0.21, OUT_OF_LIMITS),
    ):
        q[2] = stroke
        T = poses_of("scara", q)
        rows, status = Solver("scara", language).all(T)
        assert status.tolist() == [wanted] * 2
        np.testing.assert_allclose(rows[:, 2], stroke, rtol=0, atol=1e-15)
        result, nearest = Solver("scara", language).nearest(T, q)
        assert result == (OK if wanted == OK else -OUT_OF_LIMITS)
        assert np.isfinite(nearest).all() == (wanted == OK)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("degrees", [-349.0, -200.0, 0.0, 181.0, 349.9])
def test_nearest_uses_whole_turns_inside_the_limits(language: str, degrees: float) -> None:
    """Joints of +-350 degrees: a seed beyond half a turn is met there."""
    q = np.full(6, 0.4)
    q[0] = np.radians(degrees)
    T = poses_of("named_badly", q)
    result, nearest = Solver("named_badly", language).nearest(T, q)
    assert result == OK
    np.testing.assert_allclose(nearest, q, rtol=0, atol=1e-12)
    rows, status = Solver("named_badly", language).all(T)
    held = rows[np.isin(status, HELD)]
    assert (np.abs(held) <= np.pi).all()


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("far", [1e9, 1e16, -1e300])
def test_a_seed_of_many_turns_costs_no_digits(language: str, far: float) -> None:
    q = np.array([0.3, -0.9, -1.1, 0.4, 0.7, 0.2])
    T = poses_of("ur5", q)
    with np.errstate(over="ignore"):  # of the distance, in Python without numba
        result, nearest = Solver("ur5", language).nearest(T, np.full(6, far))
    assert result == OK
    assert residual("ur5", nearest[None], T) < 1e-12


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize(
    ("degrees", "seed", "wanted"),
    [(5.0, 300.0, 5.0), (20.0, 345.0, 20.0), (-15.0, 345.0, 345.0), (-5.0, 345.0, -5.0)],
)
def test_nearest_never_leaves_the_limits(
    language: str, degrees: float, seed: float, wanted: float
) -> None:
    """355 degrees would be nearer to the seed, but the limit is 350."""
    q = np.full(6, 0.4)
    q[0] = np.radians(degrees)
    near = q.copy()
    near[0] = np.radians(seed)
    result, nearest = Solver("named_badly", language).nearest(poses_of("named_badly", q), near)
    assert result == OK
    others = {"near": np.degrees(nearest[0])}
    if abs(nearest[1] - q[1]) < 1e-9:  # else another branch was nearer
        assert others["near"] == pytest.approx(wanted, abs=1e-9)
    assert abs(nearest[0]) <= np.radians(350) + 1e-9


@pytest.mark.parametrize("far", [1e80, 1e120, 1e155, 1e200, 1e300])
@pytest.mark.parametrize("name", ["cylindrical_wrist", "rrprrr"])
def test_no_slide_follows_poses_whose_squares_are_infinite(name: str, far: float) -> None:
    """Rows were OK with NaN in them; the tiles of a batch say the same as one pose."""
    (T,) = poses_of(name, np.array([[0.3, 0.2, 0.4, -0.5, 0.6, 0.7]]))
    T[:3, 3] *= far
    rows, status = Solver(name, "C").all(T)
    assert np.isfinite(rows[np.isin(status, HELD)]).all()
    assert (status == INVALID_POSE).all() == (far > 1e100)
    _, statuses = in_c(name).batch(np.repeat(T[None], 17, axis=0))
    assert (statuses == status).all()
    with np.errstate(over="ignore"):
        assert (Solver(name, "Python").all(T)[1] == status).all()
