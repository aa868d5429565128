"""The files in `generated/`, as a user gets them, against the oracle's forward model."""

from __future__ import annotations

import ctypes
import os
import re
import shutil
import subprocess
import sys
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from numba import njit
from numba.core.runtime import _nrt_python as _nrt  # type: ignore[attr-defined]

from dhgen.oracle.arm import arm, arm_size
from dhgen.oracle.forward import forward
from dhgen.oracle.poses import random_joints
from dhgen.oracle.problem import task_entries
from dhgen.robot.load import load
from dhgen.robot.robot import JointKind
from dhgen.robot.task import TaskKind
from dhgen.status import HELD, Status
from dhgen.survey.singular import is_redundant
from tests.generated.solvers import GENERATED, NAMES, ROBOTS, given, library, module, robot
from tests.oracle.sets import joint_sets
from tests.serial import PARALLEL
from tests.structures import BREADTH, COMPILED, COMPILED_SLOWLY, STRUCTURES, first_of, says
from tests.targets.made import MADE_UP

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray


COUNT = 600  # the survey asks for more
GENERAL = {"C": 150, "Python": 60}  # for arms with 16 rows
# numba takes seconds for each; the modules of all arms run without it in clean processes
ASKED = [
    *((name, "C") for name in STRUCTURES),
    *(pytest.param(name, "C", marks=BREADTH) for name in NAMES if name not in STRUCTURES),
    *((name, "Python") for name in COMPILED),
    *(pytest.param(name, "Python", marks=pytest.mark.slow) for name in COMPILED_SLOWLY),
    *first_of([("ur5", "Python")], count=0),  # as long as all others together
]


RESIDUAL = 1e-11  # of the arm's size
POLISHED = 1e-9  # the same for the general arms
POINTER = ctypes.c_void_p


def in_c(name: str, T: FloatArray, q: FloatArray) -> tuple[FloatArray, NDArray[np.uint8]]:
    """The batch function of the C."""
    solver = library(name)
    rows = np.empty((len(T), solver.rows, solver.dof))
    status = np.empty(rows.shape[:2], np.uint8)
    arrays = [np.ascontiguousarray(T), *given(name, q), rows, status]
    pointers = [array.ctypes.data_as(POINTER) for array in arrays]
    solver.library[f"{name}_ik_batch"](ctypes.c_size_t(len(T)), *pointers)
    return rows, status


def in_python(name: str, T: FloatArray, q: FloatArray) -> tuple[FloatArray, NDArray[np.uint8]]:
    """The batch function of the module."""
    rows, status = module(name).ik_batch(T, *given(name, q))
    return rows, status


def one_by_one(name: str, T: FloatArray, q: FloatArray) -> tuple[FloatArray, NDArray[np.uint8]]:
    """The function for control loops, pose by pose."""
    python = module(name)
    rows = np.empty((len(T), python.MAX_SOLUTIONS, python.DOF))
    status = np.empty(rows.shape[:2], np.uint8)
    free = given(name, q)
    for k in range(len(T)):
        python.ik_into(T[k], *(each[k] for each in free), rows[k], status[k], np.zeros(python.DOF))
    return rows, status


def misses(name: str, rows: FloatArray, T: FloatArray) -> FloatArray:
    """The largest miss of the named entries, lengths in arm sizes, for rows (N, n), T (N, 4, 4)."""
    miss = np.abs(forward(arm(robot(name)), rows) - T)[:, :3]
    away = np.maximum(arm_size(robot(name)), np.abs(T[:, :3, 3]).max(axis=1))
    miss[..., 3] /= away[:, None]
    return np.asarray(miss.reshape(len(rows), 12)[:, task_entries(robot(name).task)].max(axis=1))


def apart(name: str, rows: FloatArray, q: FloatArray) -> FloatArray:
    """The largest difference of joint values, whole turns aside, lengths in arm sizes."""
    turns = np.array([joint.kind is JointKind.REVOLUTE for joint in robot(name).joints])
    miss = np.abs(rows - q)
    turned = np.abs(miss - 2 * np.pi * np.round(miss / (2 * np.pi)))
    return np.asarray(np.where(turns, turned, miss / arm_size(robot(name))).max(axis=-1))


def accuracy(name: str) -> float:
    """What a row may miss: what Newton steps end with, or what closed forms leave."""
    return POLISHED if module(name).METHOD.startswith("general") else RESIDUAL


def most(name: str, language: str) -> int:
    """How many poses are asked for."""
    return GENERAL[language] if module(name).MAX_SOLUTIONS == 16 else COUNT


def test_every_robot_has_its_files() -> None:
    wanted = {f"{name}.{end}" for name in NAMES for end in ("py", "c", "h", "md")}
    single = [name for name in NAMES if robot(name).float32]
    wanted |= {f"{name}_f32.{end}" for name in single for end in ("c", "h")}
    fleets = [name for name in NAMES if robot(name).calibration]
    wanted |= {f"{name}_fleet.{end}" for name in fleets for end in ("py", "c", "h")}
    parts = [each for name in PARALLEL for each in (name, f"{name}_leg")]
    wanted |= {f"{each}.{end}" for each in parts for end in ("py", "c", "h", "md")}
    wanted |= {f"dhgen_pose.{end}" for end in ("py", "c", "h")}
    wanted |= {f"dhgen_native.{end}" for end in ("py", "c")}
    wanted |= {f"dhgen_{name}.py" for name in ("arrays", "cuda", "grad")} | {"dhgen_kernels.cuh"}
    assert {path.name for path in GENERATED.iterdir() if path.is_file()} == wanted


def test_lines_by_which_tests_choose_arms_are_what_dhgen_reads() -> None:
    for path in [*(ROBOTS / f"{name}.yaml" for name in NAMES), *MADE_UP.glob("*.yaml")]:
        read = load(path)
        assert says(path, "free: arm_angle") == read.arm_angle, path
        assert says(path, "float32: true") == read.float32, path
        assert says(path, "numerical: true") == read.numerical, path
        assert says(path, "task: (?!pose$)") == (read.task.kind is not TaskKind.POSE), path


@pytest.mark.parametrize(("name", "language"), ASKED)
def test_random_poses(name: str, language: str) -> None:
    """The generating joints are found on each, and every row gives its pose again."""
    rows = module(name).MAX_SOLUTIONS
    q = random_joints(robot(name), most(name, language), seed=71)
    T = np.ascontiguousarray(forward(arm(robot(name)), q), dtype=float)
    found, status = (in_c if language == "C" else in_python)(name, T, q)
    held = np.isin(status, HELD)
    assert held.any(axis=1).all()
    poses = np.repeat(T[:, None], rows, axis=1)
    assert misses(name, found[held], poses[held]).max() < accuracy(name)
    assert np.isnan(found[~held]).all()
    if is_redundant(robot(name)):
        return  # one member of a family stands for all
    nearest = np.where(held, apart(name, np.where(held[..., None], found, 0.0), q[:, None]), np.inf)
    assert nearest.min(axis=1).max() < 1e-5


@pytest.mark.parametrize(("name", "language"), ASKED)
def test_singular_poses(name: str, language: str) -> None:
    """An exact answer on every one: wrists, shoulders, stretched, folded, right angles, limits."""
    sets = joint_sets(robot(name), count=3, seed=72)
    rows = module(name).MAX_SOLUTIONS
    for kind, q in sets.items():
        q = q[:: 1 + len(q) // most(name, language)]  # noqa: PLW2901
        T = np.ascontiguousarray(forward(arm(robot(name)), q), dtype=float)
        found, status = (in_c if language == "C" else in_python)(name, T, q)
        held = np.isin(status, HELD)
        assert held.any(axis=1).all(), (kind, q[~held.any(axis=1)][:3])
        poses = np.repeat(T[:, None], rows, axis=1)
        enough = accuracy(name)
        if held.any():
            assert misses(name, found[held], poses[held]).max() < enough, kind


CLEAN = """
import importlib
import sys
import numpy as np
sys.path.insert(0, ".")
for name in sys.argv[1:]:
    robot = importlib.import_module(name)
    q = np.full(robot.DOF, 0.3)
    free = [q[[joint - 1 for joint in robot.FREE_JOINTS]]] if hasattr(robot, "FREE_JOINTS") else []
    free = [np.array([robot.arm_angle(q)])] if hasattr(robot, "arm_angle") else free
    rows, status = robot.ik_all(robot.fk(q), *free)
    held = rows[~np.isnan(rows).any(axis=1)]
    assert len(held) and len(robot.jacobian(q)) == 6, (name, status)
others = [name for name in sys.modules if name.split(".")[0] in ("dhgen", "sympy", "jinja2")]
assert not others, others
"""


def test_a_clean_process_needs_numpy_and_numba_only() -> None:
    done = subprocess.run(
        [sys.executable, "-c", CLEAN, *NAMES],
        cwd=GENERATED,
        env={key: value for key, value in os.environ.items() if key != "PYTHONPATH"}
        | {"NUMBA_DISABLE_JIT": "1"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")


def test_that_nothing_can_be_kept_is_told_once(tmp_path: Path) -> None:
    """Of all files of the runtime, at the line that imports the arm."""
    shutil.copy(GENERATED / "scara.py", tmp_path)
    runtime = tmp_path / "dhgen_runtime"
    hidden = shutil.ignore_patterns("__pycache__")
    shutil.copytree(GENERATED / runtime.name, runtime, ignore=hidden)
    for folder in (tmp_path, *(file.parent for file in runtime.rglob("__init__.py"))):
        (folder / "__pycache__").touch()  # no folder can be made in its place
    done = subprocess.run(
        [sys.executable, "-c", "import scara"],
        cwd=tmp_path,
        env=dict.fromkeys(("HOME", "XDG_CACHE_HOME", "LOCALAPPDATA"), os.devnull),
        capture_output=True,
        text=True,
        check=False,
    )
    (warned,) = [line for line in done.stderr.splitlines() if "Warning" in line]
    assert not done.returncode
    assert warned.startswith("<string>:1: UserWarning: numba can't cache what it compiles of ")
    assert warned.endswith(
        f"set NUMBA_CACHE_DIR to a writable folder (the same holds for all files in {tmp_path})"
    )


WITHOUT_DOCSTRINGS = """
import scara, franka_panda, ur5e_fleet

print(scara.ik_all.__doc__)
q, free = [0.3] * 7, [0.3] * len(franka_panda.FREE_JOINTS)
rows = enumerate(ur5e_fleet.NOMINAL)
fleet = ur5e_fleet.calibrated([[cell + 1e-4 * k for cell in row] for k, row in rows])
for robot, dof, given in ((scara, 4, []), (franka_panda, 7, [free]), (fleet, 6, [])):
    rows, _ = robot.ik_all(robot.fk(q[:dof]), *given)
    print(min(abs(row - q[:dof]).max() for row in rows if row[0] == row[0]) < 1e-9)
"""


def test_python_without_docstrings_has_the_solvers_all_the_same() -> None:
    done = subprocess.run(
        [sys.executable, "-OO", "-c", WITHOUT_DOCSTRINGS],
        cwd=GENERATED,
        env=os.environ | {"NUMBA_DISABLE_JIT": "1"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.stdout.split(), done.stderr) == (["None", "True", "True", "True"], "")


@pytest.mark.parametrize("name", first_of(["scara", "ur5", "scorbot_pointing"]))
def test_every_way_to_call_gives_the_same(name: str) -> None:
    """Batches, tables and arrays of the caller; singular, spoiled, rounded and far poses too."""
    arms = robot(name)
    sets = [random_joints(arms, 4400, seed=73), *joint_sets(arms, count=4, seed=75).values()]
    q = np.concatenate(sets)
    T = np.ascontiguousarray(forward(arm(arms), q), dtype=float)
    T[:200] = T[:200].astype(np.float32)
    T[200:400, :3, 3] *= 1.7
    T[400:410, :3] = np.nan
    T[410:420, 0, 3] = np.inf
    T[420:430, :3, 0] *= -1.0
    rows, status = module(name).ik_batch(T, *given(name, q))
    for cores in (1, 3):
        held = np.full_like(rows, 9.0), np.full_like(status, 9)
        again = module(name).ik_batch(T, *given(name, q), cores=cores, out=held)
        assert again[0] is held[0]
        assert again[1] is held[1]
        np.testing.assert_array_equal(again[0], rows)
        np.testing.assert_array_equal(again[1], status)
    others, other_status = one_by_one(name, T, q)
    np.testing.assert_array_equal(status, other_status)
    np.testing.assert_array_equal(np.isnan(rows), np.isnan(others))
    assert np.nanmax(np.abs(rows - others)) < 1e-9
    assert {Status.OK, Status.UNREACHABLE, Status.INVALID_POSE} <= set(np.unique(status).tolist())
    for k in range(0, len(T), 97):
        table, kinds = module(name).ik_all(T[k], *(each[k] for each in given(name, q)))
        np.testing.assert_array_equal(table, others[k])
        np.testing.assert_array_equal(kinds, other_status[k])


def test_python_takes_any_numbers_and_tells_what_it_wants() -> None:
    """Lists that mix whole numbers with others; and every argument that has another shape."""
    scara = module("scara")
    np.testing.assert_array_equal(scara.fk([0, 0.5, -1, 0]), scara.fk(np.array([0, 0.5, -1, 0])))
    np.testing.assert_array_equal(scara.jacobian((0, 0, 0, 0)), scara.jacobian(np.zeros(4)))
    poses = np.eye(4)[np.newaxis]
    q, status = scara.ik_batch(poses)
    wrong: list[tuple[Callable[[], Any], str]] = [
        (lambda: scara.fk([0, 0.5]), r"q must have shape \(4,\), not \(2,\)"),
        (lambda: scara.jacobian("home"), r"q must hold real numbers, with shape \(4,\)"),
        (lambda: scara.fk(np.zeros(4) * 1j), r"q must hold real numbers, with shape \(4,\)"),
        (lambda: scara.ik("home"), r"T must hold real numbers, with shape \(4, 4\)"),
        (lambda: scara.ik(poses[0] + 0j), r"T must hold real numbers, with shape \(4, 4\)"),
        (lambda: scara.ik(poses[0], [0, 0, 0, 1j]), "q_seed must hold real numbers"),
        (lambda: scara.ik_batch("home"), r"T must hold real numbers, with shape \(N, 4, 4\)"),
        (lambda: scara.ik_batch([[1], [1, 2]]), "T must hold real numbers"),
        (lambda: scara.ik_batch(poses * 1j), r"T must hold real numbers, with shape \(N, 4, 4\)"),
        (lambda: scara.ik_all(np.eye(3)), r"T must have shape \(4, 4\), not \(3, 3\)"),
        (lambda: scara.ik_all(poses), r"T must have shape \(4, 4\), not \(1, 4, 4\)"),
        (lambda: scara.ik_batch(poses[0]), r"T must have shape \(N, 4, 4\), not \(4, 4\)"),
        (lambda: scara.ik_batch(3), r"T must have shape \(N, 4, 4\)"),
        (lambda: scara.ik_batch(poses, cores=0), "cores must be at least 1, or None for all"),
        (lambda: scara.ik_batch(poses, cores=-2), "cores must be at least 1, .*, not -2"),
        (lambda: scara.ik_batch(poses, cores="all"), "cores must be at least 1, .*, not 'all'"),
        (lambda: scara.ik(poses[0], limits=[1, 2]), r"limits must be True or False, not \[1, 2\]"),
        (lambda: scara.ik_batch(poses, out=3), r"out must be \(q, status\), two arrays"),
        (lambda: scara.ik_batch(poses, out=(q, status, q)), r"out must be \(q, status\), two"),
        (lambda: scara.ik_batch(poses, out=(q[0], status)), "q in out .* float64, .1, 2, 4."),
        (lambda: scara.ik_batch(poses, out=(q, status * 1.0)), "status in out .* of uint8"),
        (lambda: scara.ik_batch(poses, out=(q[..., ::-1], status)), "q in out .* contiguous"),
        (lambda: scara.ik_batch(poses, out=(q.tolist(), status)), "q in out .* contiguous"),
    ]
    for call, message in wrong:
        with pytest.raises(ValueError, match=message):
            call()


def allocations(python: Any, T: FloatArray) -> tuple[int, int]:
    """How often memory is allocated where `ik_into` solves one pose, and where it solves all."""
    _nrt.memsys_enable_stats()
    rows = np.empty((python.MAX_SOLUTIONS, python.DOF))
    status = np.empty(python.MAX_SOLUTIONS, np.uint8)
    solve, seed = python.ik_into, np.zeros(python.DOF)

    @njit  # from Python, the call itself makes a record for each array
    def loop(T, rows, status):  # type: ignore[no-untyped-def]
        for k in range(len(T)):
            solve(T[k], rows, status, seed)

    def counted(poses: FloatArray) -> int:
        before = _nrt.memsys_get_stats_alloc()
        loop(poses, rows, status)
        return int(_nrt.memsys_get_stats_alloc() - before)

    loop(T, rows, status)
    return counted(T[:1]), counted(T)


@pytest.mark.parametrize("name", first_of(["scara", "ur5"]))
def test_control_loops_allocate_nothing(name: str) -> None:
    """Also where a pose is only rounded, and made a rotation first."""
    q = random_joints(robot(name), 50, seed=74)
    exact = np.ascontiguousarray(forward(arm(robot(name)), q), dtype=float)
    T = np.concatenate([exact, exact.astype(np.float32)]).astype(float)
    one, all_poses = allocations(module(name), T)
    assert all_poses == one < 10
    assert "allocated only where a pose is singular" in str(module(name).ik_into.__doc__)


def test_nobody_counts_holders_of_arrays_while_solving() -> None:
    """Each count is an atomic instruction: ten of them took longer than solving the pose."""
    solve = module("scara").ik_into

    @njit
    def loop(T, rows, status):  # type: ignore[no-untyped-def]
        for k in range(len(T)):
            solve(T[k], rows, status)

    loop(np.tile(np.eye(4), (2, 1, 1)), np.empty((2, 4)), np.empty(2, np.uint8))
    functions = loop.inspect_llvm(loop.signatures[0]).split("\ndefine ")[1:]
    inner = re.compile(r"@_ZN\d+scara\w+?(unseeded|ik_into)")
    (solver,) = (each for each in functions if inner.search(each.split("\n")[0]))
    assert "fsub" in solver
    assert "NRT_incref" not in solver.split("\n}")[0]


@pytest.mark.breadth
def test_polynomials_allocate_and_say_so() -> None:
    name = "cuspidal_3r"
    q = random_joints(robot(name), 50, seed=74)
    T = np.ascontiguousarray(forward(arm(robot(name)), q), dtype=float)
    one, all_poses = allocations(module(name), T)
    assert all_poses > one + 50
    assert "allocated at every pose" in str(module(name).ik_into.__doc__)
