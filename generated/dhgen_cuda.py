# SPDX-License-Identifier: MIT
"""A robot's C on a GPU: arrays that live there are solved there.

Part of dhgen, which puts a copy of this file beside the robots that it generates.

    import dhgen_cuda, scara
    robot = dhgen_cuda.cuda(scara)  # scara.c and scara.h are next to scara.py
    q, status = robot.ik_batch(T)  # T: (n, 4, 4) or (n, 3, 4), of PyTorch, CuPy, JAX or Warp

Results are arrays of the library that the poses are of, float64 or float32 as these. Kernels go to
the stream that is current in PyTorch, CuPy or Warp, or to `stream=`; JAX's wait for them by DLPack,
as do those of any library with `__dlpack__` and the array standard's `__array_namespace__`. Others,
whose arrays have `__cuda_array_interface__`, give those that are written to, `out=`. Nothing waits
on this side.

It needs NVIDIA's driver, and NVRTC, which comes with PyTorch and CuPy or by `pip install
nvidia-cuda-nvrtc`. What that compiles is kept in $DHGEN_CACHE_DIR, or dhgen/ in the user's cache
folder, under the digest of all that it is made of: the first call of a robot takes a second for
regular poses, and ten to sixty more for the careful functions, if these are wanted.
"""

from __future__ import annotations

import ctypes
import hashlib
import os
import sys
import tempfile
from collections import deque
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING or __package__:
    from .dhgen_arrays import KINDS, Array, Call
else:
    from dhgen_arrays import KINDS, Array, Call

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence
    from types import ModuleType

    from .dhgen_arrays import GPUArray

Pointer = ctypes.c_void_p
DRIVER = "libcuda.so.1"
WRITABLE = "set DHGEN_CACHE_DIR to a writable folder"
SKIPPED = 5  # NaN: the pose needs the careful functions, and these were not asked for
ARRAYS = ("T", "free_joints", "values", "q", "status", "left")  # of a batch
OPTIONS = ("-std=c++17",)
MOST = 2**31 - 1  # poses of a batch
# Threads that solve one pose of the general algorithm together, 8, 16 or 32: it has up to 16
# solutions.
GROUP = 16
WARP = 32
_MULTIPROCESSORS, _MAJOR, _MINOR = 16, 75, 76  # attributes of a device
_ORDINAL = 9  # attribute of a pointer: its device
_NO_TIMING = 2  # flag of an event
_NOT_READY = 600  # error: work before an event has not come to its end


class NoDriver(RuntimeError):  # noqa: N818
    """There is no driver for NVIDIA's GPUs."""


class NoCompiler(RuntimeError):  # noqa: N818
    """There is no NVRTC, which compiles for the GPU."""


class BuildError(RuntimeError):
    """NVRTC rejects the source; the message is its output."""


class DeviceError(RuntimeError):
    """The driver rejects a call; the message is its own."""


def cuda(module: ModuleType) -> Solver:
    """A robot's solver for arrays on a GPU.

    Args:
        module: The robot's Python; its C and header are looked for in the same folder.

    Raises:
        TypeError: The argument is not a serial arm's module, or its table comes at run time.
        FileNotFoundError: The C or its header is missing.
        NoDriver: There is no driver.
        NoCompiler: There is no NVRTC.
    """
    if hasattr(module, "calibrated"):
        problem = f"cuda takes the module of one arm: the table of {module.NAME} comes at run time"
        raise TypeError(f"{problem}; its C is CUDA, too: call that from a kernel of your own")
    is_module = hasattr(module, "ik_all") and hasattr(module, "__file__")  # no arm of a fleet
    if not is_module or hasattr(module, "LEGS"):
        wanted = "a serial arm's module, as in 'import scara; dhgen_cuda.cuda(scara)'"
        raise TypeError(f"cuda takes {wanted}, not {module!r}")
    source = Path(str(module.__file__)).with_suffix(".c")
    for path in (source, source.with_suffix(".h"), source.with_name("dhgen_kernels.cuh")):
        if not path.exists():
            raise FileNotFoundError(f"{path} not found: cuda needs it next to {source.stem}.py")
    nvrtc()
    return Solver(Program.of(module, source), driver())


@dataclass(frozen=True, slots=True)
class Program:
    """What kernels of a robot are compiled from, and how many values the caller gives."""

    name: str
    source: Path
    text: str
    dof: int
    rows: int
    given: int
    regular: bool  # whether regular poses have a kernel of their own
    group: int  # threads that solve a pose together; 1 but for the general algorithm

    @staticmethod
    def of(module: ModuleType, source: Path, group: int = GROUP) -> Program:
        """The program of a robot, that of the general algorithm for such groups of threads."""
        content = source.read_text(encoding="utf-8")
        given = 1 if hasattr(module, "arm_angle") else len(getattr(module, "FREE_JOINTS", ()))
        regular = "#define DHGEN_SOLVE_WIDE " in content
        group = group if "#define DHGEN_TRAITS " in content and not regular else 1
        defined = f"#define DHGEN_ROBOT {module.NAME}\n#define DHGEN_GIVEN {given}\n"
        defined += f"#define DHGEN_GROUP {group}\n" if group > 1 else ""
        text = f'{defined}#include "{source.name}"\n#include "dhgen_kernels.cuh"\n'
        rows = len(module.BRANCHES)
        return Program(module.NAME, source, text, module.DOF, rows, given, regular, group)

    def kernel(self, name: str, architecture: str) -> tuple[bytes, bytes]:
        """A kernel compiled for an architecture, unless it is kept already: its name, its code."""
        beside = [self.source, self.source.with_suffix(".h")]
        beside += [self.source.with_name("dhgen_kernels.cuh")]
        beside += sorted(self.source.with_name("dhgen").rglob("*.h"))
        options = [*OPTIONS, f"-arch={architecture}", f"-I{self.source.parent}"]
        compiler = nvrtc()
        asked = "\n".join([self.text, name, *options, str(_version(compiler))])
        made_of = b"\0".join([asked.encode(), *(path.read_bytes() for path in beside)])
        folder = cache_folder()
        start = f"{self.source.stem}-{_digest(made_of)}-"
        for kept in folder.glob(f"{start}*.cubin"):
            content = kept.read_bytes()
            if kept.stem.endswith(_digest(content)):
                lowered, _, code = content.partition(b"\n")
                return lowered, code
        lowered, code = compiled(compiler, self.text, name, options)
        content = lowered + b"\n" + code
        with _room(folder) as room:
            made = Path(room) / "made.cubin"
            made.write_bytes(content)
            made.replace(folder / f"{start}{_digest(content)}.cubin")  # nobody sees half of it
        return lowered, code


class Batch(ctypes.Structure):
    """The arrays of a batch, as kernels take them."""

    _fields_ = (("n", ctypes.c_ulonglong), *((name, Pointer) for name in ARRAYS))


class Solver:
    """A robot's functions for arrays on a GPU: see `cuda`."""

    def __init__(self, program: Program, cu: ctypes.CDLL) -> None:
        self.program, self._cu = program, cu
        self._contexts: dict[int, Pointer] = {}
        self._loaded: dict[tuple[str, int], Pointer] = {}
        self._running: deque[tuple[Pointer, list[GPUArray]]] = deque()  # what kernels read or write

    def ik_batch(
        self,
        T: GPUArray,
        *q_free: GPUArray,
        nearest: GPUArray = None,
        careful: bool = True,
        out: tuple[GPUArray, GPUArray] | None = None,
        stream: int | None = None,
    ) -> tuple[GPUArray, GPUArray]:
        """All solutions of poses, or the solutions nearest to seeds.

        Args:
            T: Poses (n, 4, 4) or (n, 3, 4).
            q_free: Where the caller gives values besides: (n, how many).
            nearest: Seeds (n, dof): one solution a pose is wanted, the nearest.
            careful: Whether poses that are not regular are solved; else their status is SKIPPED.
            out: The arrays that are written to, joint values and statuses.
            stream: The address of a CUDA stream, by default the one that is current in the library.

        Returns:
            Joint values (n, rows, dof) and statuses (n, rows); with seeds (n, dof) and (n,).
        """
        call, one = Call(T, stream), nearest is not None
        poses = call.read(T, "T")
        n, kind = _poses(poses)
        rows = () if one else (self.program.rows,)
        wanted = ("q", (n, *rows, self.program.dof), kind), ("status", (n, *rows), "|u1")
        made, results = call.results(out, *wanted)
        arrays = {"T": poses, **results, **self._given(call, q_free, n, kind)}
        if one:
            arrays["values"] = call.read(nearest, "nearest")
            arrays["values"].demand(kind, n, self.program.dof)
        names = ("nearest_to_seeds", "careful_nearest") if one else ("all_rows", "careful_rows")
        q, status = self._solve(names, call, arrays, made, careful=careful)
        return q, status

    def count(
        self,
        T: GPUArray,
        *q_free: GPUArray,
        careful: bool = True,
        out: GPUArray = None,
        stream: int | None = None,
    ) -> GPUArray:
        """How many solutions inside limits poses have, (n,): 255 where careful=False skips one."""
        call = Call(T, stream)
        poses = call.read(T, "T")
        n, kind = _poses(poses)
        made, results = call.results(None if out is None else (out,), ("out", (n,), "|u1"))
        given = self._given(call, q_free, n, kind)
        arrays = {"T": poses, "status": results["out"], **given}
        names = ("count_rows", "careful_count")
        (counts,) = self._solve(names, call, arrays, made, careful=careful)
        return counts

    def fk(self, q: GPUArray, *, out: GPUArray = None, stream: int | None = None) -> GPUArray:
        """The poses (n, 4, 4) of joint values (n, dof)."""
        return self._motion("poses", q, (4, 4), out, stream)

    def jacobian(self, q: GPUArray, *, out: GPUArray = None, stream: int | None = None) -> GPUArray:
        """The Jacobians (n, 6, dof) of joint values (n, dof)."""
        return self._motion("jacobians", q, (6, self.program.dof), out, stream)

    def _motion(
        self,
        name: str,
        q: GPUArray,
        shape: tuple[int, int],
        out: GPUArray,
        stream: int | None,
    ) -> GPUArray:
        call = Call(q, stream)
        values = call.read(q, "q")
        kind = values.number()
        n = values.shape[0] if values.shape else 0
        values.demand(kind, n, self.program.dof)
        made, results = call.results(None if out is None else (out,), ("out", (n, *shape), kind))
        arrays = {"values": values, "q": results["out"]}
        if not n:
            return made[0]
        with self.at(arrays) as device:
            kernel = self.kernel(_instance(name, kind, 16), device)
            self.launch(kernel, (_over(n, 128), 128), _batch(n, arrays), Pointer(call.stream))
            return self._handed(call, made)[0]

    def _given(self, call: Call, q_free: Sequence[GPUArray], n: int, kind: str) -> dict[str, Array]:
        """What the caller gives besides poses."""
        given = self.program.given
        if len(q_free) != (given > 0):
            takes = f"(n, {given}), besides T" if given else "nothing besides T"
            raise TypeError(f"{self.program.name} takes {takes}")
        if not given:
            return {}
        values = call.read(q_free[0], "q_free")
        values.demand(kind, n, given)
        return {"free_joints": values}

    def _solve(
        self,
        names: tuple[str, str],
        call: Call,
        arrays: dict[str, Array],
        made: tuple[GPUArray, ...],
        *,
        careful: bool,
    ) -> tuple[GPUArray, ...]:
        """Both kernels, on one stream, and the results."""
        if not careful and not self.program.regular:
            raise ValueError(f"{self.program.name} has no regular poses: all need careful=True")
        poses = arrays["T"]
        n = poses.shape[0]
        if n == 0:
            return made
        asked = [_instance(name, poses.kind, 4 * poses.shape[1]) for name in names]
        at, batch = Pointer(call.stream), _batch(n, arrays)
        with self.at(arrays) as device:
            processors = self._attribute(_MULTIPROCESSORS, device)
            last = self.kernel(asked[1], device) if careful else Pointer()
            if self.program.group > 1:  # as many blocks as there are poses: these take long or not
                self.launch(last, (_over(n * self.program.group, WARP), WARP), batch, at)
                return self._handed(call, made)
            if not self.program.regular:
                self.launch(last, (min(_over(n, 128), 2 * processors), 128), batch, at)
                return self._handed(call, made)
            first, left = self.kernel(asked[0], device), Pointer()
            if careful:
                self._call("cuMemAllocAsync", ctypes.byref(left), ctypes.c_size_t(4 * n + 4), at)
                self._call("cuMemsetD32Async", left, 0, ctypes.c_size_t(1), at)
                batch.left = left
            try:
                size = ctypes.c_int()  # of a block: as many threads as it may have
                self._call("cuFuncGetAttribute", ctypes.byref(size), 0, first)
                self.launch(first, (_over(n, size.value), size.value), batch, at)
                if careful:
                    self.launch(last, (min(n, 16 * processors), 32), batch, at)
            finally:
                if careful:
                    self._call("cuMemFreeAsync", left, at)
            return self._handed(call, made)

    def _handed(self, call: Call, made: tuple[GPUArray, ...]) -> tuple[GPUArray, ...]:
        """The results of what was launched, as the library may read them at any time from now on.

        Where it waits by DLPack, an event follows the kernels: streams that read the results wait
        for it, and what kernels read and write lives until it has come.
        """
        if not call.handed_over:
            return made
        for _ in range(len(self._running)):
            before, kept = self._running.popleft()
            if self._cu.cuEventQuery(before) == _NOT_READY:
                self._running.append((before, kept))
            else:
                self._call("cuEventDestroy_v2", before)
        event = Pointer()
        self._call("cuEventCreate", ctypes.byref(event), _NO_TIMING)
        self._call("cuEventRecord", event, Pointer(call.stream))
        self._running.append((event, call.kept))

        def order(stream: int) -> None:
            self._call("cuStreamWaitEvent", Pointer(stream), event, 0)

        return tuple(call.taken_over(each, order) for each in made)

    @contextmanager
    def at(self, arrays: dict[str, Array]) -> Iterator[int]:
        """The device of arrays, with its context current."""
        devices = {array.name: self._device(array) for array in arrays.values()}
        first, *others = devices.items()
        for name, device in others:
            if device != first[1]:
                problem = f"{first[0]} is on GPU {first[1]}, and {name} on GPU {device}"
                raise ValueError(f"{problem}: all arrays must be on one")
        if first[1] not in self._contexts:
            context = Pointer()
            self._call("cuDevicePrimaryCtxRetain", ctypes.byref(context), first[1])
            self._contexts[first[1]] = context  # for good: what is loaded belongs to it
        self._call("cuCtxPushCurrent_v2", self._contexts[first[1]])
        try:
            yield first[1]
        finally:
            self._call("cuCtxPopCurrent_v2", ctypes.byref(Pointer()))

    def _device(self, array: Array) -> int:
        found = ctypes.c_int()
        place = Pointer(array.pointer)
        if self._cu.cuPointerGetAttribute(ctypes.byref(found), _ORDINAL, place):
            raise ValueError(f"{array.name} is not in the memory of a GPU")
        return found.value

    def kernel(self, asked: str, device: int) -> Pointer:
        """An instance of a kernel's template, compiled and loaded once."""
        if (asked, device) not in self._loaded:
            major, minor = (self._attribute(each, device) for each in (_MAJOR, _MINOR))
            lowered, code = self.program.kernel(asked, f"sm_{major}{minor}")
            module, function = Pointer(), Pointer()
            self._call("cuModuleLoadData", ctypes.byref(module), code)
            self._call("cuModuleGetFunction", ctypes.byref(function), module, lowered)
            self._loaded[asked, device] = function
        return self._loaded[asked, device]

    def _attribute(self, number: int, device: int) -> int:
        found = ctypes.c_int()
        self._call("cuDeviceGetAttribute", ctypes.byref(found), number, device)
        return found.value

    def launch(self, kernel: Pointer, size: tuple[int, int], batch: Batch, at: Pointer) -> None:
        """Puts a kernel of so many blocks of threads on a stream."""
        (blocks, threads), given = size, (Pointer * 1)(ctypes.addressof(batch))
        self._call("cuLaunchKernel", kernel, blocks, 1, 1, threads, 1, 1, 0, at, given, None)

    def _call(self, name: str, *arguments: object) -> None:
        error = self._cu[name](*arguments)
        if error:
            text = ctypes.c_char_p()
            self._cu.cuGetErrorString(error, ctypes.byref(text))
            raise DeviceError(f"{name}: {(text.value or b'unknown error').decode()}")


def _instance(name: str, kind: str, entries: int) -> str:
    return f"dhgen_{name}<{KINDS[kind][1]}, {entries}>"


def _batch(n: int, arrays: dict[str, Array]) -> Batch:
    return Batch(n, **{name: array.pointer for name, array in arrays.items()})


def _over(n: int, size: int) -> int:
    return -(-n // size)


def _poses(poses: Array) -> tuple[int, str]:
    """How many there are, and the type of their numbers."""
    kind, shape = poses.number(), poses.shape
    if len(shape) != 3 or shape[1:] not in ((4, 4), (3, 4)):
        raise ValueError(f"T must be of shape (n, 4, 4) or (n, 3, 4), not {shape}")
    if shape[0] > MOST:
        raise ValueError(f"T has more than {MOST} poses: give them in parts")
    poses.demand(kind, *shape)
    return shape[0], kind


@cache
def driver() -> ctypes.CDLL:
    """NVIDIA's driver, ready."""
    try:
        found = ctypes.CDLL(DRIVER)
    except OSError:
        raise NoDriver(f"NVIDIA's driver is not installed: {DRIVER} not found") from None
    if error := found.cuInit(0):
        raise NoDriver(f"NVIDIA's driver finds no GPU that it can use (error {error} of cuInit)")
    return found


@cache
def nvrtc() -> ctypes.CDLL:
    """NVRTC, as PyTorch, CuPy or its own wheel brings it, or as the system has it."""
    parts = ("nvidia/cu13/lib", "nvidia/cuda_nvrtc/lib")
    wheels = (Path(folder, part) for folder in sys.path for part in parts)
    found = [path for folder in wheels for path in sorted(folder.glob("libnvrtc.so.*"))]
    others = ("libnvrtc.so.13", "libnvrtc.so.12", "/usr/local/cuda/lib64/libnvrtc.so")
    for name in [*map(str, found), *others]:
        beside = Path(name).parent.glob("libnvrtc-builtins.so.*") if "/" in name else ()
        try:
            for part in beside:
                ctypes.CDLL(str(part))  # NVRTC opens it by name alone, and may not find it
            return ctypes.CDLL(name)
        except OSError:
            continue
    raise NoCompiler("NVRTC is not installed: pip install nvidia-cuda-nvrtc")


def compiled(
    compiler: ctypes.CDLL, text: str, kernel: str, options: Sequence[str]
) -> tuple[bytes, bytes]:
    """A kernel's name in its code, and the code."""
    program, lowered = Pointer(), ctypes.c_char_p()
    listed = (ctypes.c_char_p * len(options))(*map(str.encode, options))
    compiler.nvrtcCreateProgram(ctypes.byref(program), text.encode(), b"dhgen.cu", 0, None, None)
    try:
        compiler.nvrtcAddNameExpression(program, kernel.encode())
        failed = compiler.nvrtcCompileProgram(program, len(options), listed)
        log = _output(compiler, program, "ProgramLog").rstrip(b"\0").decode()
        if failed:
            raise BuildError(f"{kernel}\n{log}")
        compiler.nvrtcGetLoweredName(program, kernel.encode(), ctypes.byref(lowered))
        code = _output(compiler, program, "CUBIN")
        return lowered.value or b"", code
    finally:
        compiler.nvrtcDestroyProgram(ctypes.byref(program))


def _output(compiler: ctypes.CDLL, program: Pointer, what: str) -> bytes:
    size = ctypes.c_size_t()
    compiler[f"nvrtcGet{what}Size"](program, ctypes.byref(size))
    content = ctypes.create_string_buffer(size.value)
    compiler[f"nvrtcGet{what}"](program, content)
    return content.raw


def _version(compiler: ctypes.CDLL) -> tuple[int, int]:
    major, minor = ctypes.c_int(), ctypes.c_int()
    compiler.nvrtcVersion(ctypes.byref(major), ctypes.byref(minor))
    return major.value, minor.value


def _digest(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()[:24]


def _room(folder: Path) -> tempfile.TemporaryDirectory[str]:
    """A passing folder in the one where kernels are kept."""
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        return tempfile.TemporaryDirectory(dir=folder)
    except OSError as error:
        problem = f"kernels can't be written there ({error.strerror}): {WRITABLE}"
        raise OSError(error.errno, problem, str(folder)) from None


def cache_folder() -> Path:
    """Where kernels are kept, wherever the process goes; it need not be there yet."""
    if chosen := os.environ.get("DHGEN_CACHE_DIR"):
        return Path(chosen).absolute()
    user = os.environ.get("XDG_CACHE_HOME") or os.environ.get("LOCALAPPDATA")
    try:
        return (Path(user).absolute() if user else Path.home() / ".cache") / "dhgen"
    except RuntimeError:
        raise RuntimeError(f"the user has no home folder: {WRITABLE}") from None
