"""How the C behind a module is called: from Python without a detour, from numba, and by ctypes."""

from __future__ import annotations

import gc
import importlib
import shutil
import sys
import types
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest
from numba import njit
from numba.core.errors import TypingError

from tests.generated.solvers import GENERATED, given, module
from tests.generated.test_native_c import native, poses

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

EXTENDS = module("dhgen_native").EXTENDS
extension = pytest.mark.skipif(not EXTENDS, reason="calls go through ctypes here")


def filled(name: str) -> tuple[Any, Any]:
    """Arrays to be filled."""
    size = module(name).MAX_SOLUTIONS, module(name).DOF
    return np.zeros(size), np.zeros(size[0], np.uint8)


@extension
def test_ik_into_is_no_function_of_python() -> None:
    assert isinstance(native("scara").ik_into, types.BuiltinFunctionType)
    assert native("scara").ik_into.__doc__ == module("scara").ik_into.__doc__


def test_two_robots_in_a_process_keep_apart() -> None:
    """Their libraries have functions of the same names."""
    answers: dict[str, list[Any]] = {}
    for name in ("scara", "planar_rr", "scara", "planar_rr"):
        q, T = poses(name, 1)
        rows, status = filled(name)
        assert native(name).ik_into(T[0], rows, status) == 2
        assert np.abs(rows - q[0]).sum(axis=1).min() < 1e-9
        answers.setdefault(name, []).append(rows.copy())
    for first, second in answers.values():
        np.testing.assert_array_equal(first, second)


@pytest.mark.parametrize("name", ["scara", "franka_panda"])
def test_arrays_of_any_kind_get_the_answers_of_plain_ones(name: str) -> None:
    """What the C can't take is converted, also a seed of whole numbers."""
    q, T = poses(name, 1)
    free, robot = [each[0] for each in given(name, q)], native(name)
    rows, status = filled(name)
    seed = np.zeros(robot.DOF)
    count = robot.ik_into(T[0], *free, rows, status, seed)
    room = np.zeros(128 + 1, np.uint8)[1:].view(np.float64).reshape(4, 4)
    room[:] = T[0]
    assert not room.flags.aligned
    ways: list[Callable[[Any, Any], int]] = [
        lambda a, b: robot.ik_into(T[0].tolist(), *free, a, b, seed),
        lambda a, b: robot.ik_into(room, *free, a, b, seed),
        lambda a, b: robot.ik_into(np.asfortranarray(T[0]), *free, a, b, seed),
        lambda a, b: robot.ik_into(T[0].astype(">f8"), *free, a, b, seed),
        lambda a, b: robot.ik_into(T[0], *free, a, b, seed.astype(int)),
        lambda a, b: robot.ik_into(T[0], *free, a, b, q_seed=seed),
        lambda a, b: robot.ik_into(T[0], *free, q=a, status=b, q_seed=seed),
    ]
    for way in ways:
        others, kinds = filled(name)
        assert way(others, kinds) == count
        np.testing.assert_array_equal(others, rows)
        np.testing.assert_array_equal(kinds, status)


@pytest.mark.parametrize("end", ["fk", "jacobian"])
@pytest.mark.parametrize("kind", [np.asarray, np.asfortranarray, np.ndarray.tolist])
def test_stacks_of_joint_values_give_stacks(
    end: str, kind: Callable[[Any], Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    """As the module's own functions have it, whether Python takes the C as its own or not."""
    robot = native("scara")
    q = np.random.default_rng(3).uniform(-1.0, 1.0, (2, 3, robot.DOF))
    function = getattr(robot, end)
    one_by_one = np.array([[function(values) for values in row] for row in q])
    np.testing.assert_array_equal(function(kind(q)), one_by_one)
    empty = function(np.zeros((0, robot.DOF)))
    assert empty.shape == (0, *one_by_one.shape[2:])
    solver = vars(robot)["_solver"]
    monkeypatch.setattr(solver, f"_{end}_into", getattr(solver, f"any_{end}"))
    np.testing.assert_array_equal(function(kind(q)), one_by_one)


@pytest.mark.parametrize("wrong", [0.1, [0.1] * 3, np.zeros((2, 5)), np.zeros((4, 2)), "four"])
def test_joint_values_of_another_shape_get_the_words_of_the_module(wrong: object) -> None:
    told = []
    for robot in (module("scara"), native("scara")):
        for function in (robot.fk, robot.jacobian):
            with pytest.raises(ValueError, match="q must") as caught:
                function(wrong)
            told.append(str(caught.value))
    assert len(set(told)) == 1


def test_mistakes_are_told_and_nothing_is_written() -> None:
    _, T = poses("scara", 1)
    robot, (rows, status) = native("scara"), filled("scara")
    still = rows.copy()
    still.setflags(write=False)
    mistakes: list[tuple[type[Exception], str, Callable[[], Any]]] = [
        (ValueError, "read-only", lambda: robot.ik_into(T[0], still, status)),
        (ValueError, "shapes", lambda: robot.ik_into(T[0], rows.T, status)),
        (ValueError, "shapes", lambda: robot.ik_into(T[0].ravel(), rows, status)),
        (ValueError, "shapes", lambda: robot.ik_into(T[0], rows, b"12")),
        (ValueError, "whole numbers", lambda: robot.ik_into(T[0], rows, status.astype("?"))),
        (ValueError, "finite", lambda: robot.ik_into(T[0], rows, status, np.full(4, np.inf))),
        (TypeError, "status", lambda: robot.ik_into(T[0], rows)),
        (TypeError, "too many", lambda: robot.ik_into(T[0], rows, status, None, None)),
        (TypeError, "seed", lambda: robot.ik_into(T[0], rows, status, seed=None)),
    ]
    for kind, told, mistake in mistakes:
        with pytest.raises(kind, match=told):
            mistake()
    assert not rows.any()
    assert not status.any()


@pytest.mark.slow
def test_nothing_is_held_when_a_call_is_over() -> None:
    """Neither after answers, nor after conversions, nor after mistakes.

    None is held by everybody: whatever the interpreter throws away meanwhile gives some back, so
    what counts is the calmest of three rounds. A call that kept one would keep 300 in each.
    """
    _, T = poses("scara", 1)
    robot, (rows, status), seed = native("scara"), filled("scara"), np.zeros(4)
    pose, longs = T[0].copy(), np.zeros(4, int)

    def calls() -> None:
        robot.ik_into(pose, rows, status)
        robot.ik_into(pose, rows, status, seed)
        robot.ik_into(pose, rows, status, None)
        robot.ik_into(pose, rows, status, q_seed=longs)
        robot.fk(seed)
        robot.jacobian(longs)
        for wrong in (seed, longs, None):
            with pytest.raises((ValueError, AttributeError)):
                robot.ik_into(wrong, rows, status)
            with pytest.raises((ValueError, AttributeError)):
                robot.ik_into(pose, rows, wrong)

    held = (pose, rows, status, seed, longs, robot.ik_into, vars(robot)["_solver"], None)
    for _ in range(100):
        calls()
    gc.collect()
    gc.freeze()  # what other tests keep is not looked through again and again
    nones, blocks = [], []
    for _ in range(3):
        gc.collect()
        before, allocated = [sys.getrefcount(each) for each in held], sys.getallocatedblocks()
        for _ in range(300):
            calls()
        gc.collect()
        after = [sys.getrefcount(each) for each in held]
        assert after[:-1] == before[:-1]
        nones.append(abs(after[-1] - before[-1]))
        blocks.append(sys.getallocatedblocks() - allocated)
    gc.unfreeze()
    assert min(nones) < 50
    assert min(blocks) < 150


@extension
@pytest.mark.parametrize("name", ["scara", "franka_panda"])
def test_functions_of_numba_call_it(name: str) -> None:
    q, T = poses(name, 20)
    free, solve = given(name, q), native(name).ik_into
    rows, status = filled(name)
    if free:

        @njit
        def both(T: Any, free: Any, q: Any, status: Any, seed: Any) -> Any:
            return solve(T, free, q, status), solve(T, free, q, status, seed)
    else:

        @njit
        def both(T: Any, q: Any, status: Any, seed: Any) -> Any:
            return solve(T, q, status), solve(T, q, status, seed)

    for k, pose in enumerate(T):
        values = [each[k] for each in free]
        counts = both(pose, *values, rows, status, q[k])
        others, kinds = filled(name)
        assert counts[0] == solve(pose, *values, others, kinds)
        assert counts[1] == solve(pose, *values, others, kinds, q[k])
        np.testing.assert_array_equal(others, rows)
        np.testing.assert_array_equal(kinds, status)
    with pytest.raises(ValueError, match="another shape"):
        both(T[0][:3], *(each[0] for each in free), rows, status, q[0])
    with pytest.raises(ValueError, match="as many values as the arm has joints"):
        both(T[0], *(each[0] for each in free), rows, status, q[0][1:])
    with pytest.raises(ValueError, match="finite"):
        both(T[0], *(each[0] for each in free), rows, status, q[0] * np.nan)
    with pytest.raises(TypingError, match="T must be a contiguous array of float64 with 2 axes"):
        both(T[0].astype(np.float32), *(each[0] for each in free), rows, status, q[0])


def test_by_ctypes_answers_are_the_same(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("DHGEN_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(module("dhgen_native"), "EXTENDS", False)
    robot = module("dhgen_native").native(module("scara"))
    assert not isinstance(robot.ik_into, types.BuiltinFunctionType)
    q, T = poses("scara", 5)
    for joints, pose in zip(q, T, strict=True):
        rows, status = filled("scara")
        others, kinds = filled("scara")
        count = native("scara").ik_into(pose, rows, status, joints)
        assert robot.ik_into(pose, others, kinds, joints) == count
        np.testing.assert_array_equal(others, rows)
        np.testing.assert_array_equal(kinds, status)
        np.testing.assert_array_equal(robot.fk(joints), native("scara").fk(joints))
        np.testing.assert_array_equal(robot.jacobian(joints), native("scara").jacobian(joints))


def test_a_changed_header_of_the_runtime_is_built_anew(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What a robot's C includes from the folder dhgen beside it counts like itself."""
    beside = tmp_path / "robots"
    beside.mkdir()
    for name in ("planar_rr.py", "planar_rr.c", "planar_rr.h", "dhgen_native.c"):
        shutil.copy(GENERATED / name, beside)
    for path in GENERATED.iterdir():
        if path.is_dir() and path.name.startswith("dhgen"):
            shutil.copytree(path, beside / path.name)
    header = beside / "dhgen" / "length.h"
    header.parent.mkdir(exist_ok=True)
    source = beside / "planar_rr.c"
    text = source.read_text(encoding="utf-8")
    source.write_text(f'#include "dhgen/length.h"\n{text}\n#undef DHGEN_LENGTH\n', encoding="utf-8")
    monkeypatch.setenv("DHGEN_CACHE_DIR", str(tmp_path / "kept"))
    monkeypatch.syspath_prepend(str(beside))
    monkeypatch.delitem(sys.modules, "planar_rr", raising=False)
    python = importlib.import_module("planar_rr")
    for length in ("1.0", "2.0"):
        header.write_text(f"#define DHGEN_LENGTH {length}\n", encoding="utf-8")
        module("dhgen_native").native(python)
    assert len(list((tmp_path / "kept").iterdir())) == 2
    module("dhgen_native").native(python)
    assert len(list((tmp_path / "kept").iterdir())) == 2
