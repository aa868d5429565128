"""The C behind the functions of the Python: the same answers, built once, or clear why not."""

from __future__ import annotations

import inspect
import multiprocessing
import os
import pickle
import subprocess
import sys
from functools import cache
from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from dhgen.oracle.arm import arm
from dhgen.oracle.forward import forward
from dhgen.oracle.poses import random_joints
from tests.generated.solvers import GENERATED, folder, given, module, robot, short_module
from tests.structures import first_of

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from dhgen.arrays import FloatArray


ARMS = first_of(["scara", "kuka_iiwa14_arm_angle", "scorbot_pointing", "fanuc_crx10ia"], count=2)


@cache
def native(name: str) -> Any:
    """The robot with its C."""
    module(name)  # where it lies is known then
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("DHGEN_CACHE_DIR", str(folder() / "native"))
        return module("dhgen_native").native(module(name))


def poses(name: str, count: int) -> tuple[FloatArray, FloatArray]:
    """Joint values and their poses."""
    q = random_joints(robot(name), count, seed=81)
    return q, np.ascontiguousarray(forward(arm(robot(name)), q), dtype=float)


@pytest.mark.parametrize("name", ARMS)
def test_answers_are_those_of_python(name: str) -> None:
    python = short_module(name)
    q, T = poses(name, 12)
    T[3, 0, 3] += 50.0
    T[4] *= 2.0
    for k, (joints, pose) in enumerate(zip(q, T, strict=True)):
        free = [each[k] for each in given(name, q)]
        rows, status = native(name).ik_all(pose, *free, joints)
        expected, kinds = python.ik_all(pose, *free, joints)
        np.testing.assert_array_equal(status, kinds)
        np.testing.assert_allclose(rows, expected, atol=1e-7)
        for function in ("fk", "jacobian"):
            found, wanted = (getattr(each, function)(joints) for each in (native(name), python))
            np.testing.assert_allclose(found, wanted, atol=1e-14)
    rows, status = native(name).ik_batch(T, *given(name, q))
    expected, kinds = python.ik_batch(T, *given(name, q))
    np.testing.assert_array_equal(status, kinds)
    np.testing.assert_allclose(rows, expected, atol=1e-7)


@pytest.mark.parametrize("name", ARMS)
def test_into_any_arrays_and_the_nearest(name: str) -> None:
    q, T = poses(name, 4)
    free = [each[0] for each in given(name, q)]
    python, c = module(name), native(name)
    rows, status = c.ik_all(T[0], *free)
    count = c.ik_into(T[0], *free, rows, status)
    assert count == np.isin(status, (python.OK, python.FREE_JOINT)).sum() > 0
    other, kinds = np.empty(rows.shape[::-1], np.float32).T, np.empty(len(rows), np.int64)
    spread = np.zeros((8, 8))[::2, ::2]
    spread[:] = T[0]
    assert c.ik_into(spread, *free, other, kinds, q_seed=np.zeros(python.DOF)) == count
    np.testing.assert_allclose(other, rows, rtol=1e-6)
    np.testing.assert_array_equal(kinds, status)
    np.testing.assert_allclose(c.ik(T[0], *free, q[0], limits=False), q[0], atol=1e-6)
    far = T[0].copy()
    far[0, 3] += 50.0
    with pytest.raises(python.Unreachable, match="out of reach"):
        c.ik(far, *free, q[0])
    with pytest.raises(ValueError, match="T is not a valid pose"):
        c.ik(2.0 * T[0], *free)
    mistakes: list[Callable[[], Any]] = [
        lambda: c.ik_into(T[0][:3], *free, rows, status),
        lambda: c.ik_into(T[0], *free, rows[1:], status),
        lambda: c.ik_into(T[0], *free, rows, status, np.zeros(python.DOF + 1)),
        lambda: c.ik_into(T[0], *free, rows, status, np.full(python.DOF, np.nan)),
        lambda: c.fk(np.zeros(python.DOF - 1)),
        lambda: c.fk("home"),
        lambda: c.fk(np.zeros(python.DOF) * 1j),
        lambda: c.jacobian(np.zeros((python.DOF, 1))),
        lambda: c.ik_into(T[0], *free, np.zeros(rows.shape, int), status),
        lambda: c.ik_into(T[0], *free, rows, status.astype(bool)),
    ]
    for mistake in mistakes:
        with pytest.raises(ValueError, match=r"must (be|hold|have)"):
            mistake()


def test_what_numba_compiles_apart_stays_the_module_s_own() -> None:
    """The text that got the C has no fk that numba could compile."""
    python = module("scorbot_pointing")
    native("scorbot_pointing")
    apart = vars(sys.modules[vars(python)["_HOW"].key])["apart"]
    assert apart
    for function, _ in apart.values():
        assert function.py_func.__globals__ is vars(python)


def test_constants_names_and_the_arm_angle() -> None:
    q, _ = poses("kuka_iiwa14_arm_angle", 3)
    python, c = module("kuka_iiwa14_arm_angle"), native("kuka_iiwa14_arm_angle")
    for joints in q:
        assert c.arm_angle(joints) == pytest.approx(python.arm_angle(joints), abs=1e-9)
    public = {name for name in vars(python) if not name.startswith("_")}
    assert public == {name for name in vars(c) if not name.startswith("_")}
    poses_of, angles = np.array([python.fk(joints) for joints in q]), [c.arm_angle(v) for v in q]
    np.testing.assert_array_equal(
        c.ik_batch(poses_of, angles)[0], c.ik_batch(poses_of, np.array(angles)[:, None])[0]
    )
    with pytest.raises(ValueError, match=r"q must hold real numbers, with shape \(7,\)"):
        c.fk(["0.1"] * 7)
    assert c.Unreachable is python.Unreachable
    assert c.__name__ == python.__name__
    c.warm_up()


def pickled(value: Any) -> Any:
    """What another process gets."""
    return pickle.loads(pickle.dumps(value))  # noqa: S301


@pytest.mark.parametrize("name", ["scara", "kuka_iiwa14_arm_angle"])
def test_a_robot_and_its_functions_are_pickled_by_how_they_were_asked_for(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DHGEN_CACHE_DIR", str(folder() / "native"))
    robot_of = module("dhgen_native").native(module(name), compiler="cc", flags="-std=c99 -O1")
    again = pickled(robot_of)
    assert again._asked == robot_of._asked == (name, "cc", ("-std=c99", "-O1"))
    q, T = poses(name, 1)
    free = [each[0] for each in given(name, q)]
    for function in ("fk", "jacobian", "ik_into", "ik_all", "ik", "ik_batch", "warm_up"):
        own = getattr(robot_of, function)
        back = pickled(own)
        assert back == getattr(again, function)
        taken = inspect.signature(getattr(module(name), function)).parameters
        assert list(inspect.signature(own).parameters) == list(taken)
        assert own.__doc__
    rows, status = pickled(robot_of.ik_all)(T[0], *free)
    expected, kinds = robot_of.ik_all(T[0], *free)
    np.testing.assert_array_equal(rows, expected)
    np.testing.assert_array_equal(status, kinds)


@pytest.mark.parametrize("way", ["fork", "spawn"])
def test_other_processes_solve(way: str) -> None:
    _, T = poses("scara", 4)
    solve = native("scara").ik_all
    with multiprocessing.get_context(way).Pool(1) as pool:
        found = pool.map(solve, T)
    for (rows, status), pose in zip(found, T, strict=True):
        np.testing.assert_array_equal(rows, solve(pose)[0])
        np.testing.assert_array_equal(status, solve(pose)[1])


ELSEWHERE = """
import sys
sys.path.append(sys.argv[1])
import dhgen_native, planar_rr
robot = dhgen_native.native(planar_rr)
print(robot.ik_all(robot.fk([0.3, 0.5]))[1].tolist())
"""


def start(place: Path, **variables: str) -> subprocess.Popen[str]:
    """A clean process in another directory."""
    return subprocess.Popen(
        [sys.executable, "-c", ELSEWHERE, str(GENERATED)],
        cwd=place,
        env=os.environ | {"DHGEN_CACHE_DIR": str(place / "kept")} | variables,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


@pytest.mark.breadth
def test_processes_build_at_once(tmp_path: Path) -> None:
    answers = [process.communicate() for process in [start(tmp_path) for _ in range(3)]]
    assert answers == [("[0, 0]\n", "")] * 3
    (library,) = (tmp_path / "kept").iterdir()
    built = library.stat().st_mtime_ns
    assert start(tmp_path).communicate() == ("[0, 0]\n", "")
    assert [each.stat().st_mtime_ns for each in (tmp_path / "kept").iterdir()] == [built]


@pytest.mark.breadth
def test_a_damaged_library_is_built_again(tmp_path: Path) -> None:
    """A power cut may leave nothing, a head, or half: to open that is fatal."""
    assert start(tmp_path).communicate() == ("[0, 0]\n", "")
    (library,) = (tmp_path / "kept").iterdir()
    whole = library.read_bytes()
    for left in (0, 100, len(whole) // 2):
        library.write_bytes(whole[:left])
        assert start(tmp_path).communicate() == ("[0, 0]\n", "")
        assert list((tmp_path / "kept").iterdir()) == [library]
        assert library.read_bytes() == whole


def test_without_a_compiler(tmp_path: Path) -> None:
    _, told = start(tmp_path, PATH=str(tmp_path), CC="").communicate()
    assert "NoCompiler: no C compiler: none of $CC, cc, gcc and clang found" in told
    module("scara")
    with pytest.raises(RuntimeError, match="no C compiler: tcc-0 not found"):
        module("dhgen_native").native(module("scara"), compiler="tcc-0")


def test_without_a_path(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The compiler is found where the system has it, and is to find its linker there."""
    monkeypatch.setenv("DHGEN_CACHE_DIR", str(tmp_path))
    monkeypatch.delenv("PATH")
    solved = module("dhgen_native").native(module("scara"))
    np.testing.assert_array_equal(solved.fk(np.zeros(4)), module("scara").fk(np.zeros(4)))


def test_what_is_no_robot_is_told_what_is_wanted(tmp_path: Path) -> None:
    helper = module("dhgen_native")
    for given_in_its_place in ("scara", np, SimpleNamespace(ik_all=None)):
        with pytest.raises(TypeError, match="native takes a robot's module, as in 'import scara;"):
            helper.native(given_in_its_place)
    with pytest.raises(TypeError, match="the table of ur5e_fleet comes at run time; solve in"):
        helper.native(module("ur5e_fleet"))
    with pytest.raises(TypeError, match=r"delta stands on legs; .*: native\(delta_leg\)"):
        helper.native(module("delta"))
    path = str(tmp_path / "alone.py")
    alone = SimpleNamespace(MAX_SOLUTIONS=2, ik_all=print, __file__=path)
    with pytest.raises(FileNotFoundError, match=r"alone\.c not found: native needs it"):
        helper.native(alone)


def test_arguments_of_another_type_are_refused() -> None:
    native_of = module("dhgen_native").native
    for flags in (3, None, b"-O2", ["-O2", 3]):
        with pytest.raises(TypeError, match="flags must be a list of strings, or one string, not"):
            native_of(module("scara"), flags=flags)
    with pytest.raises(TypeError, match="compiler must be a name or a path, not 3"):
        native_of(module("scara"), compiler=3)
    with pytest.raises(TypeError, match=r"'-m64'\]: its options belong in flags"):
        native_of(module("scara"), compiler=["gcc", "-m64"])
    with pytest.raises(RuntimeError, match="its options belong in flags"):
        native_of(module("scara"), compiler="gcc -m32")
    with pytest.raises(
        ValueError, match=r"q and status must have shapes \(4, 4\), \(2, 4\), \(2,\)"
    ):
        native("scara").ik_into(np.eye(4), [[0.0] * 4] * 2, np.zeros(2, np.uint8))


def test_a_folder_where_nothing_can_be_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DHGEN_CACHE_DIR", str(tmp_path / "file"))
    (tmp_path / "file").touch()
    remedy = r"libraries can't be written there \(.+\): set DHGEN_CACHE_DIR to a writable folder"
    with pytest.raises(OSError, match=f"{remedy}: '{tmp_path}/file'"):
        module("dhgen_native").native(module("scara"))


def test_flags_that_make_nothing_of_nan_are_refused() -> None:
    with pytest.raises(ValueError, match="flags must not include -Ofast or -ffast-math: NaN"):
        module("dhgen_native").native(module("scara"), flags="-ffast-math -Ofast")


def test_what_the_compiler_refuses(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DHGEN_CACHE_DIR", str(tmp_path))
    helper = module("dhgen_native")
    with pytest.raises(helper.BuildError, match="-fno-such-flag"):
        helper.native(module("scara"), flags=("-fno-such-flag",))
    with pytest.raises(helper.BuildError, match="cc -fno-such-flag '-DA=b c' -dM"):
        helper.native(module("scara"), compiler="cc", flags="-fno-such-flag '-DA=b c'")
    assert not list(tmp_path.iterdir())
