"""The kernels on the CPU, thread beside thread, against the robots' C: see host.cpp.txt."""

from __future__ import annotations

import shutil
import subprocess
from functools import cache
from pathlib import Path

import pytest

from tests.gpu.nvrtc import GENERATED, defined, is_regular
from tests.structures import those_in

DRIVER = Path(__file__).with_name("host.cpp.txt")
COUNT = 320  # poses: five blocks, of which the last is not full for one of the sizes
# One row, an odd number of results, sixteen rows, given values, an arm angle, drives that are
# coupled, slides, other tasks, a quartic, five joints, and the general algorithm.
KINDS = (
    *("scara", "cartesian", "planar_rrr", "franka_panda", "kuka_iiwa14_arm_angle"),
    *("scara_ball_screw", "stanford", "spherical_wrist_general_arm", "scorbot_pointing"),
    *("cuspidal_3r", "ur5", "puma560", "xarm6"),
)
ALWAYS_REGULAR = {"cartesian"}
# In single precision an arm of five joints can't take a whole pose exactly: all are left.
LEAVING = {f"{mode}-double-16" for mode in ("rows", "count", "skipping")}
EXACT, SINGLE = 1e-9, 4e-6  # by how much values may differ; a float holds angles to 2.4e-7


@cache
def compared(name: str, folder: Path) -> dict[str, tuple[int, float, int]]:
    """Of each mode: statuses that differ, the most by which values do, and poses that were left."""
    compiler = shutil.which("g++")
    if compiler is None:
        pytest.skip("no g++")
    program = folder / name
    flags = ["-std=c++17", "-O1", "-Wall", "-Wextra", "-Werror", "-Wno-unknown-pragmas", "-pthread"]
    given = [*defined(name), f'-DDHGEN_SOURCE="{name}.c"', f"-I{GENERATED}"]
    command = [compiler, *flags, *given, "-x", "c++", str(DRIVER), "-o", str(program)]
    subprocess.run(command, check=True)
    done = subprocess.run([program, str(COUNT - 5)], check=True, capture_output=True, text=True)
    lines = (line.split() for line in done.stdout.splitlines())
    return {mode: (int(off), float(by), int(left)) for mode, off, by, left in lines}


@pytest.mark.parametrize("name", those_in(("scara",), KINDS))
def test_kernels_answer_as_the_c_does(name: str, tmp_path: Path) -> None:
    """Statuses are the same, and values but for rounding; poses are regular, singular, rounded, out
    of reach and none.
    """
    found = compared(name, tmp_path)
    assert {f"{mode}-double-16" for mode in ("rows", "nearest", "count", "motion")} <= found.keys()
    for mode, (off, by, left) in found.items():
        assert off == 0, mode
        assert by <= (SINGLE if "float" in mode else EXACT), mode
        if mode in LEAVING and is_regular(name) and name not in ALWAYS_REGULAR:
            assert 0 < left < COUNT // 2, mode
