"""benchmarks.gpu without a GPU: it says that there is none; and its way through all measurements.

The driver that stands in for NVIDIA's computes nothing, and every time is a millisecond: what is
printed is arithmetic.
"""

from __future__ import annotations

import importlib
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from benchmarks import gpu
from dhgen.verify.native import c_compiler
from tests.gpu.nvrtc import kernels_of
from tests.structures import BREADTH

if TYPE_CHECKING:
    import pytest

DRIVER = Path(__file__).parents[1] / "gpu" / "driver.c.txt"
COPIED = 2.147  # GB that copying one GiB reads and writes


def test_without_a_device_it_is_skipped(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "path", [str(gpu.GENERATED), *sys.path])
    cuda = importlib.import_module("dhgen_cuda")
    monkeypatch.setattr(cuda, "DRIVER", "libnothing.so.1")
    cuda.driver.cache_clear()
    gpu.main([])
    assert capsys.readouterr().out.startswith(
        "skipped: no device (NVIDIA's driver is not installed"
    )


@BREADTH
def test_what_is_measured(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    library = tmp_path / "driver.so"
    command = [str(c_compiler()), "-shared", "-fPIC", "-x", "c", str(DRIVER), "-o", str(library)]
    subprocess.run(command, check=True)
    monkeypatch.setattr(sys, "path", [str(gpu.GENERATED), *sys.path])
    cuda = importlib.import_module("dhgen_cuda")
    monkeypatch.setattr(cuda, "DRIVER", str(library))
    monkeypatch.setattr(cuda, "nvrtc", lambda: None)
    kernel = lambda _, name, __: (name.encode(), b"\x7fELF")  # noqa: E731
    monkeypatch.setattr(cuda.Program, "kernel", kernel)
    for name, value in {"SIZES": (1000, 2000), "FEW": 1000, "COMPARED": 10, "CALLS": 3}.items():
        monkeypatch.setattr(gpu, name, value)
    cuda.driver.cache_clear()
    gpu.main(["--arms", "scara", "cuspidal_3r", "xarm6", "--poses", "2000"])
    cuda.driver.cache_clear()
    printed = capsys.readouterr().out
    assert f"device 0: copying moves {COPIED / 1e3 * 1e3:.2f} TB/s" in printed
    lines = [line.split() for line in printed.splitlines() if " of copying" in line]
    # Of the others one size and one mode, of the general one for each size of a group.
    assert len(lines) == 2 * 2 * 4 + 2 * (1 + 4)
    assert sum(line[:2] == ["xarm6,", "16"] for line in lines) == 2
    for line in lines:
        assert tuple(line[line.index("µs") - 1 :][:2]) == ("1000.0", "µs")
    # n times 192 bytes and two statuses in a millisecond, beside 2.147 GB in one
    whole = next(line for line in lines if line[:4] == ["scara", "float64", "n", "2000"])
    assert "2.0" in whole
    assert f"{2000 * (24 * 8 + 2) / 2**31:.1%}" in whole
    assert "scara float64, 2000 poses: " in printed
    assert "beside the C on 10 poses: " in printed


def test_the_kernel_that_checks_compiles() -> None:
    text = gpu.CHECK.read_text("utf-8")
    kernels_of("scara", [f"gpu_check<{kind}, 16>" for kind in ("double", "float")], [], text)
