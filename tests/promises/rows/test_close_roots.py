"""Roots of a quartic that nearly meet: a joint is nearly free, and two solutions differ in it.

An arm's third link reaches axis 2 where cos theta_3 = -a2 / a3; beside that place theta_1 and
theta_3 of two solutions are nearly the same, and theta_2 is anything. Another one's axes 3, 4 and 5
meet in a point that reaches axis 1 where cos theta_2 = -a1 / a2: theta_1 is anything there, and
theta_3, theta_4 and theta_5 follow it. A third one's slide is a quotient that has no digits where
its polynomial is a square, at right angles of theta_3 with theta_5 zero. Of a fourth one's
polynomial little is left where axis 6 is nearly parallel to axes 3, 4 and 5: rounding of what
cancels moves it. A fifth one's root has two solutions, which nearly meet where theta_3 is nearly
half a turn: where the root nearly is a double one, too, both are next to each other.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from dhgen.program.interpret import interpret
from tests.compiling import library
from tests.targets.calling import HELD, gap
from tests.targets.made import folder, made_up, without_numba

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.compiler import Compilation
    from dhgen.verify.native import CompiledSolver

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

TOUCHING = "touching"
MEETING = "meeting"
SLIDING = "sliding"
CANCELLING = "cancelling"
FOLDING = "folded_wrist"
JOINTS = {
    TOUCHING: (
        "theta: q, d: 0, a: 0.3, alpha: pi/2",
        "theta: q, d: 0.1, a: 0.15, alpha: -pi/2",
        "theta: q, d: 0, a: 0.5, alpha: 0",
    ),
    MEETING: (
        "theta: q, d: 0, a: 0.136, alpha: pi/2",
        "theta: q, d: 0, a: 0.23, alpha: pi/2",
        "theta: q, d: 0, a: 0, alpha: -pi/2",
        "theta: q, d: 0, a: 0, alpha: -pi/2",
        "theta: q, d: 0, a: 0.15, alpha: 120 deg",
        "theta: q, d: 0, a: 0, alpha: 0",
    ),
    SLIDING: (
        "theta: 0, d: q, a: 0.2, alpha: 0",
        "theta: q, d: 0, a: 0, alpha: -pi/2",
        "theta: q, d: 0, a: 0, alpha: pi/2",
        "theta: q, d: 0.2, a: 0.2, alpha: pi/2",
        "theta: q, d: 0, a: 0.2, alpha: -pi/2",
        "theta: q, d: 0.05, a: 0, alpha: 0",
    ),
    CANCELLING: (
        "theta: q, d: 0.161, a: 0.158, alpha: pi/2",
        "theta: q, d: 0.402, a: 0, alpha: -pi/2",
        "theta: q, d: 0, a: -0.091, alpha: 0",
        "theta: q, d: 0, a: 0.2, alpha: 0",
        "theta: q, d: 0, a: 0.241, alpha: pi/2",
        "theta: q, d: 0.523, a: 0, alpha: pi/2",
    ),
    FOLDING: (
        "theta: 1.106, d: q, a: 0.365, alpha: -0.367",
        "theta: q, d: 0.115, a: 0, alpha: 0.349",
        "theta: q, d: 0, a: 0, alpha: pi/2",
        "theta: q, d: 0.162, a: 0.112, alpha: -0.69",
        "theta: q, d: 0.179, a: 0.323, alpha: -0.903",
        "theta: q, d: 0.211, a: 0.381, alpha: 0.59",
    ),
}
TASK = dict.fromkeys(JOINTS, "pose") | {TOUCHING: "position"}
# The joint, from 0, whose angle makes another one free, and that angle.
PLACE = {TOUCHING: (2, np.arccos(-0.15 / 0.5)), MEETING: (1, np.arccos(-0.136 / 0.23))}
# Where the last one is singular, but for joint 5, of which the turn of its parallel axes is left.
CROSSED = (
    (2.658336633434206, 0.0679653168861698, 2.142340057783474, -2.5149838566263867, 0.0, -0.7),
    (-1.9338444854281134, 0.6531097010672857, -2.2347635569128865, 2.656822074775003, 0.0, -2.2),
    (-2.355170460784311, -0.6468665178202802, -2.157951058603331, 2.5058544889959187, 0.0, -2.5),
    (1.988839001970632, 2.9252527777501287, -2.7023638528886194, 2.008352878035245, 0.0, 1.5),
)
# Where the least singular value of the fifth one is from 3e-6 to 3e-5.
FOLDED = (
    (
        0.38994633513272836,
        -0.943019322758297,
        -3.1414830570699914,
        -1.3685963801423477,
        0.12329846771661179,
        1.4964263878661743,
    ),
    (
        -0.8149008968860767,
        1.2762087538318596,
        -3.141268177871312,
        -0.2211846867666476,
        2.9232277248685854,
        0.23529071343199615,
    ),
    (
        -0.9654379222404224,
        1.8023839201296665,
        -3.1412557327322084,
        2.8786132105038433,
        -1.9162559429912576,
        3.047958239806481,
    ),
    (
        0.7203317443454071,
        1.375523333403799,
        -3.1413576094150115,
        -0.040943631849079676,
        2.8348584742419565,
        1.0061119995553023,
    ),
    (
        -0.5509530056037208,
        0.41282659622914375,
        -3.1413380337191152,
        2.7477087859349316,
        2.5373086003622864,
        -2.136185330968002,
    ),
)
DISTANCES = (1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5)
COUNT = 20
EXACT = 1e-11
APART = 1e-3  # of two solutions, and of one from what rounding of the pose leaves of it [rad]


@cache
def compiled(name: str) -> Compilation:
    return made_up(name, JOINTS[name], f"task: {TASK[name]}\n")


@cache
def in_c(name: str) -> CompiledSolver:
    return library(compiled(name).module, folder())


def beside(name: str, distance: float, count: int) -> FloatArray:
    """Joint vectors at a distance from where a joint is free."""
    source = np.random.default_rng(5)
    q: FloatArray = source.uniform(-3.0, 3.0, (count, len(JOINTS[name])))
    joint, angle = PLACE[name]
    q[:, joint] = source.choice([-1.0, 1.0], count) * angle + distance * source.uniform(0.5, 1.0)
    return q


def poses_of(name: str, q: FloatArray) -> FloatArray:
    return np.asarray(forward(compiled(name).robot, q), dtype=float)


@pytest.mark.parametrize("distance", DISTANCES)
def test_both_solutions_are_found(distance: float) -> None:
    q = beside(TOUCHING, distance, COUNT)
    for joints, T in zip(q, poses_of(TOUCHING, q), strict=True):
        rows, status = in_c(TOUCHING).ik(T, np.zeros(3))
        held = rows[np.isin(status, HELD)]
        assert gap(held, joints).min() < APART, joints
        assert np.abs(poses_of(TOUCHING, held)[:, :3, 3] - T[:3, 3]).max() < EXACT
        # the other solution: the same place from the other side of axis 2
        close = held[gap(held[:, [0, 2]], joints[[0, 2]]) < 10 * distance + 1e-9]
        assert len(close) == 2, (joints, held)
        assert gap(close[0], close[1]) > APART


@pytest.mark.parametrize("distance", DISTANCES[1:])
def test_both_solutions_are_found_where_other_joints_follow(distance: float) -> None:
    """Steps to them are long, and leave far more than they mend; each has its turned wrist."""
    q = beside(MEETING, distance, COUNT)
    for joints, T in zip(q, poses_of(MEETING, q), strict=True):
        rows, status = in_c(MEETING).ik(T, np.zeros(6))
        held = rows[np.isin(status, HELD)]
        assert gap(held, joints).min() < APART, joints
        assert np.abs(poses_of(MEETING, held) - T).max() < EXACT
        close = held[gap(held[:, [1, 5]], joints[[1, 5]]) < 100 * distance + 1e-9]
        assert len(close) == 4, (joints, held)


@pytest.mark.parametrize("distance", [1e-8, 1e-6])
def test_rows_that_miss_the_pose_by_far_lead_to_it(distance: float) -> None:
    q = beside(MEETING, 0.0, COUNT)
    q[:, 2], q[:, 4] = distance - np.pi / 2, distance
    for joints, T in zip(q, poses_of(SLIDING, q), strict=True):
        rows, status = in_c(SLIDING).ik(T, np.zeros(6))
        held = rows[np.isin(status, HELD)]
        assert gap(held, joints).min() < APART, joints
        assert np.abs(poses_of(SLIDING, held) - T).max() < EXACT


@pytest.mark.breadth
def test_a_double_root_of_what_cancelling_leaves_is_found() -> None:
    """The polynomial touches zero there, up to the rounding of what it is a difference of."""
    q = np.array(CROSSED)
    q[:, 4] = np.pi - 0.01 - q[:, 2] - q[:, 3]
    rows = interpret(compiled(CANCELLING).module.solver, poses_of(CANCELLING, q))
    for joints, found, solved in zip(q, rows.q, rows.solved, strict=True):
        assert solved.any(), joints
        assert gap(found[solved], joints).min() < APART


@pytest.mark.parametrize("joints", FOLDED)
def test_two_solutions_of_a_double_root_are_not_one(joints: tuple[float, ...]) -> None:
    """They are less than APART from each other; half way between them the pose is missed."""
    q = np.array(joints)
    (T,) = poses_of(FOLDING, q[None])
    rows, status = in_c(FOLDING).ik(T, np.zeros(6))
    held = rows[np.isin(status, HELD)]
    assert gap(held, q).min() < 1e-8
    assert np.abs(poses_of(FOLDING, held) - T).max() < EXACT
    close = held[gap(held, q) < APART]
    assert len(close) == 2
    assert gap(close[0], close[1]) > 1e-4
    between = poses_of(
        FOLDING,
        close[0] + 0.5 * (np.remainder(close[1] - close[0] + np.pi, 2 * np.pi) - np.pi)[None],
    )
    assert np.abs(between - T).max() > EXACT


@pytest.mark.parametrize("name", [TOUCHING, MEETING])
def test_a_free_joint_stays_free(name: str) -> None:
    q = beside(name, 0.0, COUNT)
    for joints, T in zip(q, poses_of(name, q), strict=True):
        rows, status = in_c(name).ik(T, joints)
        assert gap(rows[np.isin(status, HELD)], joints).min() < APART


@pytest.mark.parametrize("name", [TOUCHING, MEETING])
@pytest.mark.parametrize("distance", [1e-9, 1e-6])
def test_python_and_the_meaning_have_the_same_rows(name: str, distance: float) -> None:
    module = without_numba(compiled(name).files[f"{name}.py"], name)
    q = beside(name, distance, 3)
    zeros = np.zeros(q.shape[1])
    for joints, T in zip(q, poses_of(name, q), strict=True):
        rows, status = in_c(name).ik(T, zeros)
        others, kinds = module.ik_all(T, zeros)
        meant = interpret(compiled(name).module.solver, T[None], zeros).q[0]
        held = np.isin(status, HELD)
        assert (kinds == status).all()
        for found in (others, meant):
            assert (held == np.isfinite(found).all(axis=1)).all(), joints
            assert gap(found[held], rows[held]).max() < APART, joints


def test_python_tells_two_solutions_of_a_double_root_apart_as_well() -> None:
    module = without_numba(compiled(FOLDING).files[f"{FOLDING}.py"], FOLDING)
    for T in poses_of(FOLDING, np.array(FOLDED[:2])):
        rows, status = in_c(FOLDING).ik(T, np.zeros(6))
        others, kinds = module.ik_all(T, np.zeros(6))
        assert (kinds == status).all()
        held = np.isin(status, HELD)
        assert gap(others[held], rows[held]).max() < 1e-8
