"""A solver for a GPU that is not there.

In place of NVIDIA's driver there is one that writes down how it is called, driver.c.txt.
"""

from __future__ import annotations

import ctypes
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace
from typing import TYPE_CHECKING

import pytest

from dhgen.runtime.helpers import dhgen_cuda
from dhgen.verify.native import c_compiler
from tests.gpu.solvers import ON_GPU, STREAM, TYPES, Tensor, robot

if TYPE_CHECKING:
    from collections.abc import Iterator

DRIVER = Path(__file__).with_name("driver.c.txt")


@pytest.fixture(scope="module")
def driver_library(tmp_path_factory: pytest.TempPathFactory) -> Path:
    found = tmp_path_factory.mktemp("driver") / "driver.so"
    command = [str(c_compiler()), "-shared", "-fPIC", "-x", "c", str(DRIVER), "-o", str(found)]
    subprocess.run(command, check=True)
    return found


@pytest.fixture
def driver(driver_library: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[ctypes.CDLL]:
    """The driver, and a library torch whose arrays lie one after another."""
    monkeypatch.setattr(dhgen_cuda, "DRIVER", str(driver_library))
    dhgen_cuda.driver.cache_clear()
    made: list[Tensor] = []

    def empty(shape: tuple[int, ...], *, dtype: str, device: str) -> Tensor:
        assert device == "cuda:0"
        made.append(Tensor(ON_GPU + 0x1000 * (16 + len(made)), shape, TYPES[dtype]))
        return made[-1]

    stream = SimpleNamespace(current_stream=lambda _: SimpleNamespace(cuda_stream=STREAM))
    torch = SimpleNamespace(empty=empty, cuda=stream, **{name: name for name in TYPES})
    monkeypatch.setitem(sys.modules, "torch", torch)
    monkeypatch.setattr(Tensor, "__module__", "torch")
    found = ctypes.CDLL(str(driver_library))
    found.calls_so_far.restype = ctypes.c_char_p
    found.forget_calls()
    yield found
    dhgen_cuda.driver.cache_clear()


@pytest.fixture
def solver(driver: ctypes.CDLL, monkeypatch: pytest.MonkeyPatch) -> dhgen_cuda.Solver:
    """One whose kernels are their names."""
    assert driver
    code = b"\x7fELF"
    monkeypatch.setattr(dhgen_cuda, "nvrtc", lambda: None)
    kernel = lambda _, name, architecture: (f"{name} {architecture}".encode(), code)  # noqa: E731
    monkeypatch.setattr(dhgen_cuda.Program, "kernel", kernel)
    return dhgen_cuda.cuda(robot())
