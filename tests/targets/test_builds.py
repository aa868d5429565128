"""Every build of the C gives the rows of the program: scalar and in lanes, one pose and many."""

from __future__ import annotations

import ctypes
import shutil
from functools import cache
from itertools import product
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.program.interpret import interpret
from dhgen.status import HELD, Status
from dhgen.targets.layout import WIDTH
from dhgen.verify.native import FAST_FLAGS, NATIVE, Build
from tests.structures import BREADTH
from tests.targets.made import ROBOTS, apart, given, in_c, made, poses_of, residual, robot, turning

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.program.interpret import Rows

EVERYWHERE = ["ur5"]
NATIVELY = [
    *("scara", "kuka_iiwa14", "kuka_youbot", "scorbot_pointing", "wrist_oblique"),
]
CLANG = shutil.which("clang")
BUILDS = [
    Build("plain", ("-O0",)),
    Build("scalar", ("-O3", *FAST_FLAGS)),
    NATIVE,
    Build("avx2-unoptimised", ("-O0", "-mavx2")),
    Build("avx2", ("-O3", "-mavx2", "-mfma", *FAST_FLAGS)),
]
if CLANG:
    BUILDS += [
        Build("clang", ("-O1",), CLANG),
        Build("clang-native", ("-O3", "-march=native", *FAST_FLAGS), CLANG),
    ]
CASES = [(name, build) for name in EVERYWHERE for build in BUILDS]
CASES += [(name, NATIVE) for name in NATIVELY]
QUICK = ("ur5-clang-native", "ur5-plain", "ur5-native", "scara-native", "scorbot_pointing-native")
BUILT = [
    pytest.param(name, build, id=case, marks=() if case in QUICK else BREADTH)
    for name, build in CASES
    for case in [f"{name}-{build.name}"]
]
RANDOM = 200


@cache
def cases(name: str) -> tuple[FloatArray, FloatArray, Rows]:
    """Joint vectors, poses, and their rows: random, out of reach, singular and nearly so."""
    rng = np.random.default_rng(4)
    dof = made(name).module.chain.dof
    q = rng.uniform(-3, 3, (RANDOM + 200, dof))
    corners = np.array(list(product((-np.pi / 2, 0.0, np.pi / 2, np.pi), repeat=min(dof, 4))))
    q[RANDOM:, : corners.shape[1]] = corners[rng.integers(len(corners), size=200)]
    q[RANDOM + 100 :] += rng.choice([1e-10, 1e-7, 1e-4], (100, 1))
    T = poses_of(name, q)
    T[: RANDOM // 4, :3, 3] *= rng.uniform(0.9, 1.5, (RANDOM // 4, 1))
    free = given(name, q)
    rows = interpret(made(name).module.solver, T, np.zeros_like(q), *free)
    return q, T, rows


def inside(name: str, q: FloatArray) -> NDArray[np.bool_]:
    """Which rows (..., n) keep the limits, whole turns aside."""
    none = (-np.inf, np.inf)
    low, high = np.array([joint.limits or none for joint in robot(name).joints], dtype=float).T
    with np.errstate(invalid="ignore"):
        copy = q - 2 * np.pi * np.floor((q - low) / (2 * np.pi))
    keeps = ((low <= q) & (q <= high)) | (turning(name) & (copy <= high))
    return np.asarray(keeps.all(axis=-1))


def assert_rows(name: str, q: FloatArray, status: NDArray[np.uint8]) -> None:
    """Rows (N, B, n) and their statuses (N, B) against the program's meaning."""
    joints, T, rows = cases(name)
    held = np.isin(status, HELD)
    assert (np.isnan(q).any(-1) == ~held).all()
    assert (held == rows.solved)[:RANDOM].all()
    assert np.mean(held == rows.solved) > 0.98  # rounding decides at the edge of a tolerance
    # the program's meaning knows no limits, for which a free joint may take another value
    both = held & rows.solved & ~(rows.free & ~inside(name, rows.q))
    assert apart(name, q[both], rows.q[both]).max(initial=0.0, where=~np.isnan(q[both])) < 1e-3
    regular = both[:RANDOM]
    assert apart(name, q[:RANDOM][regular], rows.q[:RANDOM][regular]).max(initial=0.0) < 1e-10
    for place, row in enumerate(held):
        if place % 5 == 0 and row.any():
            assert residual(name, q[place][row], T[place : place + 1]) < 1e-9
    assert joints.shape[0] == len(q)


@pytest.mark.parametrize(("name", "build"), BUILT)
def test_one_pose_and_many(name: str, build: Build) -> None:
    joints, T, _ = cases(name)
    solver = in_c(name, build)
    free = given(name, joints)
    seed = np.zeros(joints.shape[1])
    found = [
        solver.ik(pose, seed, *(values[place] for values in free)) for place, pose in enumerate(T)
    ]
    q = np.stack([rows for rows, _ in found])
    status = np.stack([each for _, each in found])
    assert_rows(name, q, status)

    spoiled = T.copy()
    spoiled[3] = np.nan
    spoiled[10, :3, :3] *= 1.01
    spoiled[11, 0, 3] = np.inf
    many, statuses = solver.batch(spoiled, *free)
    task = robot(name).task.kind.value
    bad = [3, 11] + ([10] if task in {"pose", "orientation", "pointing"} else [])
    assert (statuses[bad] == 4).all()
    assert np.isnan(many[bad]).all()
    many[bad], statuses[bad] = q[bad], status[bad]
    assert_rows(name, many, statuses)
    same = np.isin(status, HELD) & np.isin(statuses, HELD)
    assert apart(name, many[same], q[same]).max(initial=0.0) < 1e-3
    assert apart(name, many[:RANDOM][same[:RANDOM]], q[:RANDOM][same[:RANDOM]]).max() < 1e-11


def test_libm_stays_available() -> None:
    name = "ur5"
    build = Build("libm", ("-O2", "-march=native", f"-D{name.upper()}_LIBM"))
    joints, T, _ = cases(name)
    q, status = in_c(name, build).batch(T, *given(name, joints))
    assert_rows(name, q, status)


def test_a_seed_that_is_not_finite_is_refused() -> None:
    joints, T, _ = cases("ur5")
    solver = in_c("ur5")
    assert np.isfinite(solver.nearest(T[100], joints[100])).all()
    for wrong in (np.nan, np.inf):
        seed = joints[100].copy()
        seed[2] = wrong
        assert np.isnan(solver.nearest(T[100], seed)).all()


@pytest.mark.parametrize("suffix", [".c", ".h"])
def test_lines_fit_on_a_page(suffix: str) -> None:
    for path in (ROBOTS.parent / "generated").glob(f"*{suffix}"):
        long = [line for line in path.read_text().splitlines() if len(line) > WIDTH]
        assert not long, (path.name, long[0])


@pytest.mark.parametrize("name", ["ur5", "kuka_iiwa14"])
def test_the_nearest_row_may_take_the_place_of_the_seed(name: str) -> None:
    """As in a loop that follows a motion, `ik_nearest(T, q, q)`; what is given may stand there."""
    q = np.random.default_rng(9).uniform(-1.5, 1.5, made(name).module.chain.dof)
    free = [q[joint - 1 : joint] for joint in made(name).module.chain.free]
    arrays = [poses_of(name, q[None])[0], *free, q, q]
    expected = q.copy()
    function = in_c(name).library[f"{name}_ik_nearest"]
    assert function(*(each.ctypes.data_as(ctypes.c_void_p) for each in arrays)) == Status.OK
    np.testing.assert_allclose(q, expected, rtol=0, atol=1e-9)


@pytest.mark.parametrize("name", ["puma560", "scara", "ur5"])
def test_irregular_poses_leave_before_the_angles(name: str) -> None:
    """Arctangents are most of the work; and it is faster at regular poses, too."""
    files = made(name).files
    source = files[f"{name}.c"].partition("INLINE int solve_regular(")[2]
    assert source.index("dhgen_pose_misfit_four(T)") < source.index("dhgen_angle_four(")
    assert source.index("return -1;") < source.index("dhgen_angle_four(")
    module = files[f"{name}.py"].partition("def _formulas(")[2]
    assert module.index("        return\n") < module.index("_atan2(")
