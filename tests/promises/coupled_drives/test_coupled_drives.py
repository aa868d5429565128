"""Arms whose drives are coupled, against all whole turns of all rows, one by one."""

from __future__ import annotations

import ctypes
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from dhgen.errors import UnsolvedError
from dhgen.kinematics.build import build_chain
from dhgen.method import Method
from dhgen.oracle.forward import forward
from dhgen.oracle.search import solve
from dhgen.paul.derive import derive
from dhgen.paul.refusal.unsolved import held_back
from dhgen.robot.load import load_text
from dhgen.robot.robot import DhTable
from tests.structures import BREADTH
from tests.targets.calling import HELD, LANGUAGES, OK, Solver
from tests.targets.made import (
    in_c,
    in_python,
    made,
    poses_of,
    robot,
    robot_path,
    turning,
)

if TYPE_CHECKING:
    from collections.abc import Iterable

    from _pytest.mark import ParameterSet
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray

NAMES = (
    "abb_irb2400",
    "abb_irb460",
    "dobot_magician",
    "fanuc_on_a_rail",
    "fanuc_lrmate200id_j23",
    "geared_3r",
    "given_forearm",
    "kuka_kr40pa_drives",
    "kuka_kr40pa_level",
    "level_modified",
    "level_palletizer",
    "level_pose",
    "scara_ball_screw",
    "screw_four_turns",
    "summed_prrr",
    "telescope_stages",
    "turned_back",
)
GIVEN_ONE = (
    "fanuc_on_a_rail",
    "given_forearm",
    "screw_four_turns",
)  # by the caller: a drive's value
GIVEN = (*GIVEN_ONE, "moved_rail")  # the last one two of them
PASSIVE = (
    "abb_irb460",
    "kuka_kr40pa_level",
    "level_modified",
    "level_palletizer",
    "telescope_stages",
    "turned_back",
)
# Solved by the general algorithm, which takes a second a pose where Python is not compiled.
GENERAL = ("geared_5r1p", "moved_rail", "near_structure", "railed_6r")
# One by links, by a screw and by gears, with a passive row, and one that is given.
FIRST = {"dobot_magician", "scara_ball_screw", "geared_3r", "level_palletizer", "given_forearm"}


def of_each_kind(cases: Iterable[Any]) -> list[ParameterSet]:
    """Names, or tuples that begin with them: but for one arm of each kind they are breadth."""
    tuples = [case if isinstance(case, tuple) else (case,) for case in cases]
    return [pytest.param(*each, marks=() if each[0] in FIRST else BREADTH) for each in tuples]


EVERY = of_each_kind([*NAMES, *GENERAL])
POSES, FEWER, AT_ONCE = 10_000, 200, 1_000
TURNS = (-2, -1, 0, 1, 2)
CLEAR = 1e-6  # [rad, length] what is as far inside limits is so whatever rounding does
SLACK = 1e-8  # what rounding may take a value beyond


def shares(name: str) -> FloatArray:
    """M, with M q the joints' angles and lengths but for constants."""
    geometry = robot(name).geometry
    assert isinstance(geometry, DhTable)
    M = np.diag([float(row.sign) for row in geometry.driven])
    for place, row in enumerate(geometry.driven):
        for coupling in row.couplings:
            M[place, coupling.joint - 1] = coupling.value
    return M


def bounds(name: str) -> FloatArray:
    """Lowest and highest value of each drive, (2, n)."""
    none = (-np.inf, np.inf)
    return np.array([joint.limits or none for joint in robot(name).joints]).T


def is_inside(name: str, q: FloatArray, margin: float) -> NDArray[np.bool_]:
    """Whether drives' values (..., n) keep all limits, those of sums too, by a margin."""
    low, high = bounds(name)
    inside: NDArray[np.bool_] = np.all((low + margin <= q) & (q <= high - margin), axis=-1)
    for each in robot(name).sums:
        total = np.sum([term.value * q[..., term.joint - 1] for term in each.of], axis=0)
        inside &= (each.limits[0] + margin <= total) & (total <= each.limits[1] - margin)
    return inside


def copies(name: str) -> FloatArray:
    """What whole turns of the joints that hang together add to the drives' values, (k, n)."""
    M, turns = shares(name), turning(name)
    others = M - np.diag(np.diag(M))
    together = np.any(others != 0.0, axis=0) | np.any(others != 0.0, axis=1)
    for each in robot(name).sums:
        together[[term.joint - 1 for term in each.of]] = True
    ways = [TURNS if both else (0,) for both in together & turns]
    return np.asarray(np.array(list(product(*ways))) @ (2 * np.pi * np.linalg.inv(M)).T)


def all_copies(name: str, rows: FloatArray) -> FloatArray:
    """Rows (..., n) with all whole turns that may matter (..., k, n).

    The turns of the other joints are their own: each has the turn of its value that is inside.
    """
    alone = np.ptp(copies(name), axis=0) == 0.0
    low, high = bounds(name)
    middle = np.nan_to_num(low, neginf=0.0) / 2 + np.nan_to_num(high, posinf=0.0) / 2
    turned = rows + 2 * np.pi * np.round((middle - rows) / (2 * np.pi))
    own = np.where(alone & turning(name), turned, rows)
    return np.asarray(own[..., None, :] + copies(name))


def drawn(name: str, count: int, seed: int = 3) -> FloatArray:
    """Drives' values inside all limits, (count, n)."""
    low, high = bounds(name)
    low, high = np.maximum(low, -np.pi * 2), np.minimum(high, np.pi * 2)
    q = np.random.default_rng(seed).uniform(low, high, (8 * count, len(low)))
    found = q[is_inside(name, q, CLEAR)][:count]
    assert len(found) == count
    return found


def given(name: str, q: FloatArray) -> tuple[FloatArray, ...]:
    """The values (..., k) of drives that the caller gives, where he gives any."""
    free = [joint - 1 for joint in robot(name).free]
    return (np.ascontiguousarray(q[..., free]),) if free else ()


def gaps(name: str, rows: FloatArray, q: FloatArray) -> FloatArray:
    """The largest difference of the joints' angles and lengths, whole turns aside, (...)."""
    off = (rows - q) @ shares(name).T
    turned = off - 2 * np.pi * np.round(off / (2 * np.pi))
    return np.asarray(np.abs(np.where(turning(name), turned, off)).max(axis=-1))


@pytest.mark.slow
@pytest.mark.parametrize("name", EVERY)
def test_own_values_are_found_and_rows_keep_limits_where_a_copy_does(name: str) -> None:
    q = drawn(name, FEWER if name in GENERAL else POSES)
    solver = in_c(name)
    for start in range(0, len(q), AT_ONCE):
        some = q[start : start + AT_ONCE]
        T = poses_of(name, some)
        rows, status = solver.batch(T, *given(name, some))
        held = np.isin(status, HELD)
        solved = held & (status != np.uint8(3))
        # what made the pose is among the rows that keep limits, to rounding over what fixes it
        own = np.where(solved, gaps(name, rows, some[:, None]), np.inf).min(axis=1)
        assert own.max() < 1e-5
        reached = forward(robot(name), rows[held])
        wanted = np.repeat(T[:, None], rows.shape[1], axis=1)[held]
        assert np.abs(reached - wanted)[:, :3, 3].max() < 1e-9
        assert is_inside(name, rows[solved], -SLACK).all()
        some_copy = is_inside(name, all_copies(name, rows), CLEAR).any(axis=-1)
        assert not (held & ~solved & some_copy).any()


@pytest.mark.parametrize("name", EVERY)
def test_some_rows_are_beyond_limits_and_some_need_turns(name: str) -> None:
    """The test above would say nothing otherwise."""
    q = drawn(name, 500)
    rows, status = in_c(name).batch(poses_of(name, q), *given(name, q))
    assert (status == OK).any()
    assert (status == np.uint8(3)).any()
    assert np.isfinite(rows).any()


@pytest.mark.parametrize("name", of_each_kind([*PASSIVE, *GIVEN, *GENERAL]))
def test_an_independent_search_finds_the_rows(name: str) -> None:
    """Of arms with passive rows it looks for the drives' values, not for the joints'."""
    q = drawn(name, 3)
    T, values = poses_of(name, q), given(name, q)
    rows, status = in_c(name).batch(T, *values)
    for k, pose in enumerate(T):
        held = rows[k][np.isin(status[k], HELD)]
        found = solve(robot(name), pose, *(each[k].tolist() for each in values)).regular
        assert len(found) == len(held) >= 2
        assert gaps(name, found[:, None], held).min(axis=1).max() < 1e-6


@pytest.mark.parametrize(
    ("name", "language"), of_each_kind([*product(NAMES, LANGUAGES), *product(GENERAL, ("C",))])
)
def test_the_nearest_row_is_the_nearest_of_all_copies(name: str, language: str) -> None:
    count = {"C": 40 if name in GENERAL else 150, "Python": 12}[language]
    size = made(name).module.chain.size
    weights = np.where(turning(name), 1.0, 1.0 / size**2)
    solver = Solver(name, language)
    seeds = drawn(name, count, seed=5)
    for q, seed in zip(drawn(name, count), seeds, strict=True):
        T = poses_of(name, q)
        values = given(name, q)
        result, found = solver.nearest(T, seed, *values)
        assert result == OK
        assert is_inside(name, found, -SLACK)
        rows, status = solver.all(T, None, *values)
        every = all_copies(name, rows[status == OK])
        inside = every[is_inside(name, every, CLEAR)]
        least = ((inside - seed) ** 2 @ weights).min()
        assert (found - seed) ** 2 @ weights <= least + 1e-9
        assert np.abs(solver.nearest(T, q, *values)[1] - q).max() < 1e-6


@pytest.mark.parametrize("name", of_each_kind(GIVEN_ONE))
def test_the_seed_gives_what_the_caller_leaves_out(name: str) -> None:
    """And where its value has no row inside the limits, of sums too, the nearest that has one."""
    for q, seed in zip(drawn(name, 6), drawn(name, 6, seed=5), strict=True):
        T, module = poses_of(name, q), in_python(name)
        np.testing.assert_allclose(module.ik(T, q_seed=q), q, atol=1e-6)
        found = module.ik(T, q_seed=seed)
        np.testing.assert_allclose(poses_of(name, found)[:3], T[:3], atol=1e-9)
        assert is_inside(name, found, -SLACK)


def test_two_given_joints_have_the_seeds_values() -> None:
    (q,) = drawn("moved_rail", 1)
    found = in_python("moved_rail").ik(poses_of("moved_rail", q), q_seed=q)
    np.testing.assert_allclose(found, q, atol=1e-6)


@pytest.mark.parametrize("name", EVERY)
def test_the_jacobian_is_the_derivative_by_the_drives(name: str) -> None:
    step = 1e-6
    for q in drawn(name, 20):
        T = poses_of(name, q)
        J = in_c(name).jacobian(q)
        np.testing.assert_allclose(in_python(name).jacobian(q), J, atol=1e-12)
        for drive in range(len(q)):
            moved = step * np.eye(len(q))[drive]
            rate = (poses_of(name, q + moved) - poses_of(name, q - moved)) / (2 * step)
            spin = rate[:3, :3] @ T[:3, :3].T
            turns = [spin[2, 1], spin[0, 2], spin[1, 0]]
            np.testing.assert_allclose(J[:, drive], [*rate[:3, 3], *turns], atol=1e-8)


@pytest.mark.parametrize("name", EVERY)
def test_frames_are_of_the_drives_values(name: str) -> None:
    for q in drawn(name, 5):
        frames = np.empty((len(made(name).module.links.rows) + 2, 16))  # of passive rows, too
        pointers = (a.ctypes.data_as(ctypes.c_void_p) for a in (q, frames))
        in_c(name).library[f"{name}_frames"](*pointers)
        T = poses_of(name, q)
        np.testing.assert_allclose(frames[-1].reshape(4, 4), T, atol=1e-12)
        np.testing.assert_allclose(in_python(name).frames(q)[-1], T, atol=1e-12)


@pytest.mark.parametrize("name", EVERY)
def test_c_and_python_are_alike(name: str) -> None:
    q = drawn(name, 1 if name in GENERAL else 40)
    T = poses_of(name, q)
    rows, status = in_c(name).batch(T, *given(name, q))
    others, other_status = in_python(name).ik_batch(T, *given(name, q))
    np.testing.assert_array_equal(status, other_status)
    np.testing.assert_allclose(rows, others, atol=1e-9)
    one, kinds = in_python(name).ik_all(T[0], *given(name, q[0]))
    np.testing.assert_array_equal(kinds, status[0])
    np.testing.assert_allclose(one, rows[0], atol=1e-9)


def test_names_of_rows_are_what_is_seen_of_an_arm_whose_tool_is_level() -> None:
    """The elbow is above or below the line from the shoulder to where the level hand hangs."""
    name = "kuka_kr40pa_level"
    rows, status = in_c(name).batch(poses_of(name, drawn(name, 400)))
    seen: set[str] = set()
    for places, kinds in zip(rows, status, strict=True):
        for word, q, kind in zip(made(name).module.branches, places, kinds, strict=True):
            upper = 0.85 * np.array([np.cos(q[1]), -np.sin(q[1])])  # out, and up
            fore = 0.85 * np.array([np.cos(q[1] + q[2]), -np.sin(q[1] + q[2])])
            line = upper + fore
            reach = 0.22 + line[0] + 0.2
            off = upper - (upper @ line) / (line @ line) * line
            if kind not in HELD or reach * line[0] < 1e-3 or abs(off[1]) < 1e-3:
                continue
            facing = "front" if reach > 0.0 else "back"
            assert word == f"{facing}-{'up' if off[1] > 0.0 else 'down'}"
            seen.add(word)
    assert seen == {"front-up", "front-down", "back-up", "back-down"}


@pytest.mark.parametrize("name", GENERAL)
def test_arms_without_a_closed_form_are_solved_by_the_general_algorithm(name: str) -> None:
    assert made(name).module.method in {Method.GENERAL_6R, Method.GENERAL_5R1P}
    assert (made(name).module.nominal is not None) == (name == "near_structure")


def test_a_passive_row_that_keeps_the_general_algorithm_from_an_arm_is_told() -> None:
    text = robot_path("railed_6r").read_text(encoding="utf-8")
    rows = [line for line in text.splitlines() if line.startswith("  - ")]
    text = text.replace(rows[3], f"  - {{theta: -q3, a: 0.05, alpha: pi/3}}\n{rows[3]}")
    (told,) = held_back(build_chain(load_text(text, "moved_rail")))
    assert told == "the general algorithm for six joints would solve the arm without passive row 3p"


def test_a_given_joint_that_a_solved_drive_moves_is_refused_with_what_to_do() -> None:
    text = robot_path("moved_rail").read_text(encoding="utf-8").replace("free: [1, 7]", "free: [1]")
    text = "\n".join(
        line for line in text.splitlines() if not line.startswith("  - {theta: q + 1/2*q7")
    )
    with pytest.raises(UnsolvedError, match="list under `free` a joint that its own drive moves"):
        derive(build_chain(load_text(text, "moved_rail")))
