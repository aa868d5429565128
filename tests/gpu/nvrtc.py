"""NVRTC by its wheel, without a GPU: what it says of a robot's kernels, and what ptxas does."""

from __future__ import annotations

import ctypes
import re
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest

GENERATED = Path(__file__).resolve().parents[2] / "generated"
FIRST = ("all_rows", "count_rows", "nearest_to_seeds")
CAREFUL = ("careful_rows", "careful_count", "careful_nearest")
MOTION = ("poses", "jacobians")
_STACK = re.compile(r"(\d+) bytes stack frame")
_DEEPEST = re.compile(r"(\d+) bytes cumulative stack size")
_SHARED = re.compile(r"(\d+) bytes smem")


@dataclass(frozen=True, slots=True)
class Used:
    """What a kernel uses, functions that it calls among it.

    Attributes:
        registers: Of a thread.
        stack: Bytes of a thread's own memory, for arrays or for want of registers.
        shared: Bytes of a block's shared memory.
    """

    registers: int
    stack: int
    shared: int


def defined(name: str) -> list[str]:
    """What the kernels have to know of a robot, as options of a compiler."""
    header = (GENERATED / f"{name}.h").read_text("utf-8")
    given = re.search(r"_FREE = (\d+)", header)
    return [f"-DDHGEN_ROBOT={name}", f"-DDHGEN_GIVEN={given[1] if given else 0}"]


def is_regular(name: str) -> bool:
    """Whether regular poses have kernels of their own."""
    return "#define DHGEN_SOLVE_WIDE " in (GENERATED / f"{name}.c").read_text("utf-8")


def compiled(text: str, options: list[str], kernels: list[str] | None = None) -> str:
    """The compiler's log of a source, from which these instances of templates are made.

    Every warning is an error.
    """
    library = _library()
    program = ctypes.c_void_p()
    asked = ["-std=c++17", "-Werror", "all-warnings", f"-I{GENERATED}", *options]
    listed = (ctypes.c_char_p * len(asked))(*map(str.encode, asked))
    source = text.encode()
    library.nvrtcCreateProgram(ctypes.byref(program), source, b"test.cu", 0, None, None)
    for kernel in kernels or []:
        library.nvrtcAddNameExpression(program, kernel.encode())
    failed = library.nvrtcCompileProgram(program, len(asked), listed)
    size = ctypes.c_size_t()
    library.nvrtcGetProgramLogSize(program, ctypes.byref(size))
    log = ctypes.create_string_buffer(size.value)
    library.nvrtcGetProgramLog(program, log)
    library.nvrtcDestroyProgram(ctypes.byref(program))
    assert not failed, log.value.decode()
    return log.value.decode()


def kernels_of(name: str, kernels: list[str], options: list[str], more: str = "") -> str:
    """The compiler's log of kernels of a robot, and of more behind them."""
    text = f'#include "{name}.c"\n#include "dhgen_kernels.cuh"\n{more}'
    return compiled(text, [*defined(name), *options], kernels)


def used(name: str, kernel: str, architecture: str, *options: str) -> Used:
    """What ptxas says of one kernel on an architecture."""
    log = kernels_of(name, [kernel], [f"-arch={architecture}", "--ptxas-options=-v", *options])
    found = re.findall(r"Used (\d+) registers", log)
    assert len(found) == 1, log
    stack = _DEEPEST.findall(log) or [sum(map(int, _STACK.findall(log)))]
    return Used(int(found[0]), int(stack[0]), sum(map(int, _SHARED.findall(log))))


def _library() -> ctypes.CDLL:
    for folder in map(Path, sys.path):
        for part in ("nvidia/cu13/lib", "nvidia/cuda_nvrtc/lib"):
            for path in sorted((folder / part).glob("libnvrtc.so.??")):
                return ctypes.CDLL(str(path))
    pytest.skip("no NVRTC: pip install nvidia-cuda-nvrtc")
