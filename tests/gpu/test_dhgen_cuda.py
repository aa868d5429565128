"""dhgen_cuda without a GPU: its sentences, what it compiles, and what it asks of the driver."""

from __future__ import annotations

import ctypes
import math
import sys
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from dhgen.runtime.helpers import dhgen_cuda
from tests.gpu.nvrtc import GENERATED
from tests.gpu.solvers import (
    ON_GPU,
    TYPES,
    Tensor,
    calls,
    launches,
    poses,
    robot,
)


def test_all_rows_are_two_kernels_on_the_library_s_stream(
    solver: dhgen_cuda.Solver, driver: ctypes.CDLL
) -> None:
    n = 1000
    q, status = solver.ik_batch(poses(n))
    assert (q.shape, q.kind, status.shape, status.kind) == ((n, 2, 4), "<f8", (n, 2), "|u1")
    arrays = f"3e8 10000001000 0 0 {q.place:x} {status.place:x} 10000000500"
    assert calls(driver) == [
        "push 40",
        "load ELF",
        "function 1100 dhgen_careful_rows<double, 16> sm_90",
        "load ELF",
        "function 1101 dhgen_all_rows<double, 16> sm_90",
        "allocate 4004 on 77",
        "set 10000000500 0 1 on 77",
        f"launch 1101 16,1,1 64,1,1 0 on 77: {arrays}",
        f"launch 1100 1000,1,1 32,1,1 0 on 77: {arrays}",
        "free 10000000500 on 77",
        "pop",
    ]
    solver.ik_batch(poses(n))
    assert not [call for call in calls(driver) if call.startswith(("load", "function"))]


def test_without_care_there_is_no_list(solver: dhgen_cuda.Solver, driver: ctypes.CDLL) -> None:
    q, status = solver.ik_batch(poses(64, "<f4", 3), careful=False, stream=5)
    arrays = f"40 10000001000 0 0 {q.place:x} {status.place:x} 0"
    assert launches(driver) == [f"dhgen_all_rows<float, 12> sm_90 1,1,1 64,1,1 0 on 5: {arrays}"]
    assert q.kind == "<f4"


def test_seeds_lead_to_one_row_a_pose(solver: dhgen_cuda.Solver, driver: ctypes.CDLL) -> None:
    seeds = Tensor(ON_GPU + 0x2000, (130, 4))
    q, status = solver.ik_batch(poses(130), nearest=seeds)
    assert (q.shape, status.shape) == ((130, 4), (130,))
    arrays = f"82 10000001000 0 10000002000 {q.place:x} {status.place:x} 10000000500"
    first, second = launches(driver)
    assert first == f"dhgen_nearest_to_seeds<double, 16> sm_90 3,1,1 64,1,1 0 on 77: {arrays}"
    assert second == f"dhgen_careful_nearest<double, 16> sm_90 130,1,1 32,1,1 0 on 77: {arrays}"


def test_counts_are_bytes(solver: dhgen_cuda.Solver, driver: ctypes.CDLL) -> None:
    out = Tensor(ON_GPU + 0x3000, (130,), "|u1")
    assert solver.count(poses(130), out=out) is out
    names = [launch.split(" ")[0] for launch in launches(driver)]
    assert names == ["dhgen_count_rows<double,", "dhgen_careful_count<double,"]


def test_motion(solver: dhgen_cuda.Solver, driver: ctypes.CDLL) -> None:
    q = Tensor(ON_GPU + 0x2000, (200, 4))
    T, J = solver.fk(q), solver.jacobian(q)
    assert (T.shape, J.shape) == ((200, 4, 4), (200, 6, 4))
    poses_of, jacobians_of = launches(driver)
    rest = "<double, 16> sm_90 2,1,1 128,1,1 0 on 77: c8 0 0 10000002000"
    assert poses_of == f"dhgen_poses{rest} {T.place:x} 0 0"
    assert jacobians_of == f"dhgen_jacobians{rest} {J.place:x} 0 0"


def test_arms_without_regular_poses_have_one_kernel(
    solver: dhgen_cuda.Solver, driver: ctypes.CDLL
) -> None:
    assert solver
    quartic = dhgen_cuda.cuda(robot("cuspidal_3r"))
    q, status = quartic.ik_batch(poses(10**6))
    arrays = f"f4240 10000001000 0 0 {q.place:x} {status.place:x} 0"
    name = "dhgen_careful_rows<double, 16> sm_90"
    assert launches(driver) == [f"{name} 264,1,1 128,1,1 0 on 77: {arrays}"]
    with pytest.raises(ValueError, match="cuspidal_3r has no regular poses: all need careful=True"):
        quartic.count(poses(2), careful=False)


@pytest.mark.parametrize(("group", "blocks"), [(1, 264), (8, 250001), (16, 500001), (32, 1000001)])
def test_groups_of_threads_solve_a_pose_of_the_general_algorithm(
    group: int, blocks: int, solver: dhgen_cuda.Solver, driver: ctypes.CDLL
) -> None:
    """Each in a warp of its own or a part of one, which are as many as there are poses."""
    assert solver.program.group == 1
    assert "DHGEN_GROUP" not in solver.program.text
    module = robot("xarm6")
    program = dhgen_cuda.Program.of(module, Path(str(module.__file__)).with_suffix(".c"), group)
    assert ("#define DHGEN_GROUP" in program.text) == (group > 1)
    general = dhgen_cuda.Solver(program, solver._cu)
    q, status = general.ik_batch(poses(10**6 + 1))
    arrays = f"f4241 10000001000 0 0 {q.place:x} {status.place:x} 0"
    size = f"{blocks},1,1 {32 if group > 1 else 128},1,1"
    name = "dhgen_careful_rows<double, 16> sm_90"
    assert launches(driver) == [f"{name} {size} 0 on 77: {arrays}"]
    assert dhgen_cuda.cuda(module).program.group == dhgen_cuda.GROUP


def test_given_values(solver: dhgen_cuda.Solver, driver: ctypes.CDLL) -> None:
    panda = dhgen_cuda.cuda(robot("franka_panda"))
    panda.ik_batch(poses(64), Tensor(ON_GPU + 0x2000, (64, 1)), careful=False)
    assert ": 40 10000001000 10000002000 0 " in launches(driver)[0]
    with pytest.raises(TypeError, match=r"franka_panda takes \(n, 1\), besides T"):
        panda.ik_batch(poses(64))
    with pytest.raises(TypeError, match="scara takes nothing besides T"):
        solver.ik_batch(poses(64), Tensor(ON_GPU + 0x2000, (64, 1)))


def test_no_poses_are_no_launch(solver: dhgen_cuda.Solver, driver: ctypes.CDLL) -> None:
    q, status = solver.ik_batch(poses(0))
    assert (q.shape, status.shape, calls(driver)) == ((0, 2, 4), (0, 2), [])
    assert solver.fk(Tensor(0, (0, 4))).shape == (0, 4, 4)


MISTAKES: tuple[tuple[type[Exception], str, Any, dict[str, Any]], ...] = (
    (TypeError, "T must be an array on a GPU, not numpy.ndarray", np.zeros((3, 4, 4)), {}),
    (TypeError, "T must be float32 or float64, not <i4", poses(3, "<i4"), {}),
    (
        ValueError,
        r"T must be of shape \(n, 4, 4\) or \(n, 3, 4\), not \(3, 2, 4\)",
        poses(3, rows=2),
        {},
    ),
    (ValueError, "T is not in the memory of a GPU", Tensor(0x1000, (3, 4, 4)), {}),
    (ValueError, "T must begin at a multiple of 16 bytes", Tensor(ON_GPU + 8, (3, 4, 4)), {}),
    (
        TypeError,
        "q must be float64, not <f4",
        poses(3),
        {"out": (Tensor(ON_GPU, (3, 2, 4), "<f4"), Tensor(ON_GPU, (3, 2), "|u1"))},
    ),
    (
        ValueError,
        r"status must be of shape \(3, 2\), not \(3, 4\)",
        poses(3),
        {"out": (Tensor(ON_GPU, (3, 2, 4)), Tensor(ON_GPU, (3, 4), "|u1"))},
    ),
    (
        ValueError,
        "T is on GPU 0, and nearest on GPU 1: all arrays must be on one",
        poses(3),
        {"nearest": Tensor(2 * ON_GPU, (3, 4))},
    ),
)


@pytest.mark.parametrize(("error", "told", "T", "named"), MISTAKES)
def test_mistakes(
    solver: dhgen_cuda.Solver, error: type[Exception], told: str, T: Any, named: dict[str, Any]
) -> None:
    with pytest.raises(error, match=told):
        solver.ik_batch(T, **named)


def test_only_contiguous_arrays(solver: dhgen_cuda.Solver) -> None:
    strided = Tensor(ON_GPU, (3, 4, 4))
    strided.strides = (128, 32, 8)
    solver.ik_batch(strided, careful=False)
    strided.strides = (128, 8, 32)
    with pytest.raises(TypeError, match="T must be contiguous"):
        solver.ik_batch(strided)


def test_warp_names_its_stream(
    solver: dhgen_cuda.Solver, driver: ctypes.CDLL, monkeypatch: pytest.MonkeyPatch
) -> None:
    made: list[Tensor] = []

    def empty(shape: tuple[int, ...], *, dtype: str, device: str) -> Tensor:
        assert device == "cuda:0"
        made.append(Tensor(ON_GPU + 0x4000 * len(made), shape, TYPES[dtype]))
        return made[-1]

    streams = {"cuda:0": SimpleNamespace(cuda_stream=5)}
    warp = SimpleNamespace(empty=empty, get_stream=streams.get, **{name: name for name in TYPES})
    monkeypatch.setitem(sys.modules, "warp", warp)
    monkeypatch.setattr(Tensor, "__module__", "warp._src.types")
    assert solver.ik_batch(poses(64), careful=False) == tuple(made)
    assert " on 5: " in launches(driver)[0]


def test_other_libraries_bring_the_arrays(
    solver: dhgen_cuda.Solver, driver: ctypes.CDLL, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Tensor, "__module__", "numba.cuda")
    with pytest.raises(TypeError, match=r"arrays of numba can't be made here: .*, out="):
        solver.ik_batch(poses(64))
    out = Tensor(ON_GPU, (64, 2, 4)), Tensor(ON_GPU, (64, 2), "|u1")
    solver.ik_batch(poses(64), out=out, careful=False)
    assert " on 1: " in launches(driver)[0]  # the stream that all others wait for
    told = poses(64)
    told.stream = 5
    solver.ik_batch(told, out=out, careful=False)
    assert " on 5: " in calls(driver)[-2]


def test_errors_of_the_driver_are_told(
    solver: dhgen_cuda.Solver, driver: ctypes.CDLL, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CUMEMALLOC_ERROR", "1")
    with pytest.raises(dhgen_cuda.DeviceError, match="cuMemAllocAsync: out of memory"):
        solver.ik_batch(poses(64))
    assert calls(driver)[-1:] == ["pop"]


def test_what_is_missing(
    driver: ctypes.CDLL, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    assert driver
    told = r"cuda takes a serial arm's module, .* not <module 'math'"
    with pytest.raises(TypeError, match=told):
        dhgen_cuda.cuda(math)
    fleet = ModuleType("ur5e_fleet")
    vars(fleet).update(NAME="ur5e_fleet", DOF=6, calibrated=None)
    with pytest.raises(TypeError, match="the table of ur5e_fleet comes at run time; its C is CUDA"):
        dhgen_cuda.cuda(fleet)
    arm_of_fleet = SimpleNamespace(ik_all=None)
    with pytest.raises(TypeError, match="cuda takes a serial arm's module, "):
        dhgen_cuda.cuda(cast("ModuleType", arm_of_fleet))
    parallel = ModuleType("delta")
    vars(parallel).update(NAME="delta", ik_all=None, DOF=3, LEGS=3)
    with pytest.raises(TypeError, match="cuda takes a serial arm's module"):
        dhgen_cuda.cuda(parallel)
    elsewhere = robot()
    elsewhere.__file__ = str(tmp_path / "scara.py")
    with pytest.raises(FileNotFoundError, match=r"scara.c not found: cuda needs it next to"):
        dhgen_cuda.cuda(elsewhere)
    dhgen_cuda.driver.cache_clear()
    monkeypatch.setenv("CUINIT_ERROR", "100")
    with pytest.raises(dhgen_cuda.NoDriver, match=r"finds no GPU .* \(error 100 of cuInit\)"):
        dhgen_cuda.driver()
    monkeypatch.setattr(dhgen_cuda, "DRIVER", "libnothing.so.1")
    with pytest.raises(dhgen_cuda.NoDriver, match=r"not installed: libnothing.so.1 not found"):
        dhgen_cuda.driver()


def test_no_compiler(monkeypatch: pytest.MonkeyPatch) -> None:
    def nothing(name: str) -> None:
        raise OSError(name)

    dhgen_cuda.nvrtc.cache_clear()
    monkeypatch.setattr(ctypes, "CDLL", nothing)
    told = "NVRTC is not installed: pip install nvidia-cuda-nvrtc"
    with pytest.raises(dhgen_cuda.NoCompiler, match=told):
        dhgen_cuda.nvrtc()


def test_what_the_compiler_opens_by_name_is_there(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """PyTorch's NVRTC 13.0 does not look beside itself."""
    folder = tmp_path / "nvidia/cu13/lib"
    folder.mkdir(parents=True)
    names = [folder / "libnvrtc-builtins.so.13.0", folder / "libnvrtc.so.13"]
    for name in names:
        name.touch()
    dhgen_cuda.nvrtc.cache_clear()
    monkeypatch.setattr(sys, "path", [str(tmp_path)])
    opened: list[str] = []
    monkeypatch.setattr(ctypes, "CDLL", opened.append)
    dhgen_cuda.nvrtc()
    dhgen_cuda.nvrtc.cache_clear()
    assert opened == [str(name) for name in names]


def test_kernels_are_kept(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """They are compiled once, and again where what is kept is damaged."""
    try:
        compiler = dhgen_cuda.nvrtc()
    except dhgen_cuda.NoCompiler as missing:
        pytest.skip(str(missing))
    monkeypatch.setenv("DHGEN_CACHE_DIR", str(tmp_path / "kept"))
    program = dhgen_cuda.Program.of(robot(), GENERATED / "scara.c")
    asked = "dhgen_all_rows<double, 16>"
    name, code = program.kernel(asked, "sm_90")
    assert b"dhgen_all_rows" in name
    assert code[:4] == b"\x7fELF"
    assert name in code
    (kept,) = (tmp_path / "kept").iterdir()
    monkeypatch.setattr(dhgen_cuda, "compiled", lambda *_: (b"again", b"code"))
    assert program.kernel(asked, "sm_90") == (name, code)
    kept.write_bytes(kept.read_bytes()[:-1])
    assert program.kernel(asked, "sm_90") == (b"again", b"code")
    assert program.kernel(asked, "sm_80") == (b"again", b"code")
    monkeypatch.undo()
    with pytest.raises(dhgen_cuda.BuildError, match="dhgen_nothing"):
        dhgen_cuda.compiled(compiler, "", "dhgen_nothing<double>", ["-arch=sm_90"])
