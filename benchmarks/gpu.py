"""Inverse kinematics on a GPU: is it right, and how much of the memory's speed is it?

    python -m benchmarks.gpu [--arms NAME ...] [--poses N]

Needs a GPU, NVIDIA's driver, NVRTC and numpy; without a device it says so and ends. Of every arm:
the worst residual of all rows of random poses, by its forward model on the GPU; statuses and joint
values beside those of its C on the CPU, for poses among which some are singular and some rounded;
then, for each mode and type of numbers, the median of nine runs after two, data being on the GPU,
as poses a second and as a share of what copying moves in the same process; and what the first call
of a robot takes with nothing kept, and a call for one pose. An arm of the general algorithm goes
through all of this with each size of the groups of threads that solve a pose together, and with one
thread a pose: `dhgen_cuda.GROUP` is to be the fastest of these.
"""

from __future__ import annotations

import argparse
import ctypes
import importlib
import os
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

GENERATED = Path(__file__).resolve().parents[1] / "generated"
ARMS = ("kuka_kr6_r900", "ur5", "scara", "xarm6")
CHECK = Path(__file__).with_name("gpu_check.cuh")
NUMBERS = {"float64": "<f8", "float32": "<f4"}
SIZES = (10**4, 10**6, 10**7)
COMPARED = 200_000  # poses that the CPU solves, too
FEW = 10**6  # poses at most of an arm without regular ones: each takes a thousand times as long
GROUPS = (1, 8, 16, 32)  # threads that solve a pose of the general algorithm
COPIED = 2**30  # bytes
WARM, ROUNDS = 2, 9
CALLS = 1000


def main(arguments: list[str]) -> None:
    """Prints what was found; "skipped" and the reason where there is no device."""
    options = argparse.ArgumentParser(prog="python -m benchmarks.gpu", description=__doc__)
    options.add_argument("--arms", nargs="+", default=ARMS, metavar="NAME")
    options.add_argument("--poses", type=int, default=SIZES[-1], help="at most")
    chosen = options.parse_args(arguments)
    sys.path[:0] = [str(GENERATED)]
    cuda = importlib.import_module("dhgen_cuda")
    try:
        gpu = GPU(cuda.driver())
        cuda.nvrtc()
    except (cuda.NoDriver, cuda.NoCompiler) as missing:
        print(f"skipped: no device ({missing})")
        return
    bandwidth = gpu.bandwidth()
    print(f"{gpu.name()}: copying moves {bandwidth / 1e12:.2f} TB/s", flush=True)
    robots = [each for name in chosen.arms for each in _robots(cuda, name)]
    _first_call(cuda, gpu, chosen.arms[0])
    begun = time.perf_counter()
    with ThreadPoolExecutor(os.cpu_count()) as pool:  # NVRTC lets go of Python's lock
        for done in [pool.submit(_prepare, gpu, robot) for robot in robots]:
            done.result()
    print(f"all kernels compiled in {time.perf_counter() - begun:.1f} s", flush=True)
    for robot in robots:
        arm = Arm(gpu, importlib.import_module(robot.program.name), robot)
        arm.check()
        for number, n in product(NUMBERS, SIZES):
            if n <= min(chosen.poses, arm.most):
                arm.time(number, n, bandwidth)


class Memory:
    """An array on the GPU."""

    def __init__(self, gpu: GPU, shape: tuple[int, ...], kind: str) -> None:
        self._gpu, self.shape, self.kind = gpu, shape, np.dtype(kind)
        self.size = max(1, int(np.prod(shape)) * self.kind.itemsize)
        self.pointer = ctypes.c_uint64()
        gpu.call("cuMemAlloc_v2", ctypes.byref(self.pointer), ctypes.c_size_t(self.size))

    def __del__(self) -> None:
        self._gpu.call("cuMemFree_v2", self.pointer)

    @property
    def __cuda_array_interface__(self) -> dict[str, Any]:
        data = (self.pointer.value, False)
        return {"shape": self.shape, "typestr": self.kind.str, "data": data, "version": 3}

    def put(self, values: NDArray[Any]) -> Memory:
        """Copies values to the GPU."""
        there = np.ascontiguousarray(values, self.kind)
        place = ctypes.c_void_p(there.ctypes.data)
        self._gpu.call("cuMemcpyHtoD_v2", self.pointer, place, ctypes.c_size_t(there.nbytes))
        return self

    def get(self) -> NDArray[Any]:
        """Its values."""
        values = np.empty(self.shape, self.kind)
        place = ctypes.c_void_p(values.ctypes.data)
        self._gpu.call("cuMemcpyDtoH_v2", place, self.pointer, ctypes.c_size_t(values.nbytes))
        return values


class GPU:
    """The first device: memory, and the time of what is on its stream."""

    def __init__(self, driver: ctypes.CDLL) -> None:
        self._driver = driver
        context, self.events = ctypes.c_void_p(), (ctypes.c_void_p(), ctypes.c_void_p())
        self.call("cuDevicePrimaryCtxRetain", ctypes.byref(context), 0)
        self.call("cuCtxSetCurrent", context)
        for event in self.events:
            self.call("cuEventCreate", ctypes.byref(event), 0)

    def call(self, name: str, *arguments: object) -> None:
        """Calls the driver."""
        if error := self._driver[name](*arguments):
            raise RuntimeError(f"{name}: error {error}")

    def name(self) -> str:
        """What the device is called."""
        text = ctypes.create_string_buffer(100)
        self.call("cuDeviceGetName", text, 100, 0)
        return text.value.decode()

    def new(self, *shape: int, kind: str = "<f8") -> Memory:
        """An array."""
        return Memory(self, shape, kind)

    def seconds(self, run: Callable[[], object], rounds: int = ROUNDS) -> float:
        """The median time of what a function puts on the legacy stream."""
        legacy, took, times = ctypes.c_void_p(1), ctypes.c_float(), []
        for k in range(WARM + rounds):
            self.call("cuEventRecord", self.events[0], legacy)
            run()
            self.call("cuEventRecord", self.events[1], legacy)
            self.call("cuEventSynchronize", self.events[1])
            self.call("cuEventElapsedTime", ctypes.byref(took), *self.events)
            times += [took.value * 1e-3] if k >= WARM else []
        return float(np.median(times))

    def bandwidth(self) -> float:
        """Bytes that copying reads and writes in a second."""
        room, size = self.new(2, COPIED, kind="|u1"), ctypes.c_size_t(COPIED)
        there = ctypes.c_uint64((room.pointer.value or 0) + COPIED)
        copy = ("cuMemcpyDtoDAsync_v2", there, room.pointer, size, ctypes.c_void_p(1))
        return 2 * COPIED / self.seconds(lambda: self.call(*copy))


class Arm:
    """A robot, and what is measured of it."""

    def __init__(self, gpu: GPU, module: Any, robot: Any) -> None:  # noqa: ANN401
        self._gpu, self._module, self._robot = gpu, module, robot
        self._rows, self._dof = len(module.BRANCHES), module.DOF
        group = robot.program.group
        self._name = f"{module.NAME}, {group} threads a pose" if group > 1 else module.NAME
        self.regular = robot.program.regular
        self.most = SIZES[-1] if self.regular else FEW

    def _poses(self, n: int, kind: str = "<f8", *, rounded: bool = False) -> tuple[Memory, Memory]:
        """Poses and joint values of them, of which some are singular, and some poses rounded."""
        rng = np.random.default_rng(n)
        q = rng.uniform(*_ranges(self._module), (n, self._dof))
        q[::50, 1:] *= rng.integers(0, 2, (len(q[::50]), self._dof - 1))
        values = self._gpu.new(n, self._dof).put(q)
        T = self._robot.fk(values, out=self._gpu.new(n, 4, 4))
        if rounded or kind != "<f8":
            found = T.get()
            found[25::50] = np.round(found[25::50], 6) if rounded else found[25::50]
            T = self._gpu.new(n, 4, 4, kind=kind).put(found)
        return T, self._gpu.new(n, self._dof, kind=kind).put(q)

    def _room(self, n: int, kind: str) -> tuple[Memory, Memory]:
        rows = self._gpu.new(n, self._rows, self._dof, kind=kind)
        return rows, self._gpu.new(n, self._rows, kind="|u1")

    def check(self) -> None:
        """Residuals of all rows, and the answers of the C."""
        n = self.most
        for number, kind in NUMBERS.items():
            T, _ = self._poses(n, kind)
            out = self._robot.ik_batch(T, out=self._room(n, kind))
            tally = self._gpu.new(9, kind="<u4").put(np.zeros(9))
            _run_check(self._robot, T, out, tally, kind, n)
            found = tally.get()
            worst = float(found[8:].view("<f4")[0])
            told = ", ".join(f"{count} of status {k}" for k, count in enumerate(found[:8]) if count)
            print(f"{self._name} {number}, {n} poses: {told}; worst residual {worst:.1e}")
        n = min(COMPARED, n)
        T, _ = self._poses(n, rounded=True)
        q, status = (each.get() for each in self._robot.ik_batch(T, out=self._room(n, "<f8")))
        native = importlib.import_module("dhgen_native").native(self._module)
        right, kinds = native.ik_batch(T.get())
        same = status == kinds
        off = np.abs(q - right)[same & (kinds == 0)]
        print(
            f"  beside the C on {n} poses: {np.count_nonzero(~same)} statuses differ, values of "
            f"status 0 by {np.minimum(off, np.abs(off - 2 * np.pi)).max(initial=0.0):.1e}",
            flush=True,
        )

    def time(self, number: str, n: int, bandwidth: float) -> None:
        """One line a mode."""
        kind = NUMBERS[number]
        size = np.dtype(kind).itemsize
        T, seeds = self._poses(n, kind)
        rows, one = self._room(n, kind), (self._gpu.new(n, self._dof, kind=kind), None)
        kinds, many = self._gpu.new(n, kind="|u1"), self._gpu.new(n, kind="|u1")
        all_bytes = (16 + self._rows * self._dof) * size + self._rows
        robot, first = self._robot, {"careful": False}
        modes: dict[str, tuple[int, Callable[[], object]]] = {
            "all rows, both kernels": (all_bytes, lambda: robot.ik_batch(T, out=rows))
        }
        if self.regular:
            near = {"nearest": seeds, "out": (one[0], kinds)}
            modes |= {
                "all rows": (all_bytes, lambda: robot.ik_batch(T, out=rows, **first)),
                "nearest": (
                    (16 + 2 * self._dof) * size + 1,
                    lambda: robot.ik_batch(T, **near, **first),
                ),
                "count": (16 * size + 1, lambda: robot.count(T, out=many, **first)),
            }
        for mode, (moved, run) in modes.items():
            took = self._gpu.seconds(run, ROUNDS if self.regular else 3)
            share = moved * n / took / bandwidth
            print(
                f"{self._name:14} {number} n {n:>8}  {mode:22} {took * 1e6:10.1f} µs "
                f"{n / took * 1e-6:9.1f} M/s  {share:6.1%} of copying",
                flush=True,
            )


def _robots(cuda: Any, name: str) -> list[Any]:  # noqa: ANN401
    """A robot's solver; where threads solve a pose together, for each size of their group."""
    module = importlib.import_module(name)
    robot = cuda.cuda(module)
    if robot.program.group == 1:
        return [robot]
    programs = [cuda.Program.of(module, robot.program.source, group) for group in GROUPS]
    return [cuda.Solver(program, cuda.driver()) for program in programs]


def _ranges(module: Any) -> tuple[NDArray[np.float64], NDArray[np.float64]]:  # noqa: ANN401
    """From where to where joint values are: their limits, and half a turn of what has none."""
    limits = np.array(module.JOINT_LIMITS)
    return np.maximum(limits[:, 0], -np.pi), np.minimum(limits[:, 1], np.pi)


def _prepare(gpu: GPU, robot: Any) -> None:  # noqa: ANN401
    """Compiles all kernels of a robot that are measured, side by side."""
    major, minor = ctypes.c_int(), ctypes.c_int()
    gpu.call("cuDeviceGetAttribute", ctypes.byref(major), 75, 0)
    gpu.call("cuDeviceGetAttribute", ctypes.byref(minor), 76, 0)
    program, architecture = robot.program, f"sm_{major.value}{minor.value}"
    first = ("all_rows", "nearest_to_seeds", "count_rows") if program.regular else ()
    names = ["dhgen_poses<double, 16>"]
    names += [f"dhgen_{each}<{kind}, 16>" for each in first for kind in ("double", "float")]
    names += [f"dhgen_careful_rows<{kind}, 16>" for kind in ("double", "float")]
    checks = _with_check(program)
    asked = [(program, name) for name in names]
    asked += [(checks, f"gpu_check<{kind}, 16>") for kind in ("double", "float")]
    with ThreadPoolExecutor(len(asked)) as pool:
        for done in [pool.submit(each.kernel, name, architecture) for each, name in asked]:
            done.result()


def _with_check(program: Any) -> Any:  # noqa: ANN401
    """A program with the kernel that checks."""
    return replace(program, text=program.text + CHECK.read_text(encoding="utf-8"))


def _run_check(robot: Any, T: Memory, out: Any, tally: Memory, kind: str, n: int) -> None:  # noqa: ANN401
    """Runs the kernel that checks, by what the solver launches kernels with."""
    cuda = importlib.import_module("dhgen_cuda")
    names = {"T": T, "q": out[0], "status": out[1], "left": tally}
    call = cuda.Call(T, None)
    arrays = {name: call.read(each, name) for name, each in names.items()}
    batch = cuda.Batch(n=n, **{name: array.pointer for name, array in arrays.items()})
    checks = cuda.Solver(_with_check(robot.program), cuda.driver())
    number = cuda.KINDS[kind][1]
    with checks.at(arrays) as device:
        kernel = checks.kernel(f"gpu_check<{number}, 16>", device)
        checks.launch(kernel, (-(-n // 128), 128), batch, ctypes.c_void_p(1))


def _first_call(cuda: Any, gpu: GPU, name: str) -> None:  # noqa: ANN401
    """Says what the first call takes with nothing kept, and one for a single pose."""
    module = importlib.import_module(name)
    rows, dof = len(module.BRANCHES), module.DOF
    T = gpu.new(1, 4, 4).put(np.eye(4))
    out = gpu.new(1, rows, dof), gpu.new(1, rows, kind="|u1")
    kept = os.environ.get("DHGEN_CACHE_DIR")
    with tempfile.TemporaryDirectory() as empty:
        os.environ["DHGEN_CACHE_DIR"] = empty
        begun = time.perf_counter()
        robot = cuda.cuda(module)
        robot.ik_batch(T, out=out, careful=False)
        out[1].get()
        took = time.perf_counter() - begun
        begun = time.perf_counter()
        for _ in range(CALLS):
            robot.ik_batch(T, out=out, careful=False)
        call = (time.perf_counter() - begun) / CALLS
        out[1].get()
    if kept is None:
        del os.environ["DHGEN_CACHE_DIR"]
    else:
        os.environ["DHGEN_CACHE_DIR"] = kept
    print(f"{name}: first call {took:.2f} s, then {call * 1e6:.0f} µs for one pose", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
