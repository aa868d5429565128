"""The kernels on the CPU, thread beside thread, against the robots' C: see host.cpp.txt."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from dhgen.verify.native import c_compiler
from tests.gpu.nvrtc import GENERATED, defined, is_regular
from tests.structures import BREADTH, those_in

DRIVER = Path(__file__).with_name("host.cpp.txt")
COUNT = 320  # poses: five blocks, of which the last is not full for one of the sizes
# One row, an odd number of results, sixteen rows, given values, an arm angle, drives that are
# coupled, slides, other tasks, a quartic, five joints, and the general algorithm.
KINDS = (
    *("scara", "cartesian", "planar_rrr", "franka_panda", "kuka_iiwa14_arm_angle"),
    *("scara_ball_screw", "stanford", "spherical_wrist_general_arm", "scorbot_pointing"),
    *("cuspidal_3r", "ur5", "puma560", "xarm6"),
)
# Arms of the general algorithm, and how many threads solve a pose together: an offset wrist; all
# joints turn; a slide is a partner, or on the right side; two slides and four turns; a value is
# given; the arm is beside one with a structure.
GROUPS = {
    "xarm6": 16,
    "general_6r": 8,
    "general_5r": 16,
    "general_5r1p": 8,
    "general_5r1p_pair": 32,
    "general_rpprrr": 16,
    "general_4r2p": 32,
    "xarm7": 8,
    "puma560_calibrated": 16,
    "kinova_gen3_7": 32,
}
FEW = 48  # poses: three of a kind that is singular, rounded or out of reach
ALWAYS_REGULAR = {"cartesian"}
# In single precision an arm of five joints can't take a whole pose exactly: all are left.
LEAVING = {f"{mode}-double-16" for mode in ("rows", "count", "skipping")}
EXACT, SINGLE = 1e-9, 4e-6  # by how much values may differ; a float holds angles to 2.4e-7


def built(name: str, folder: Path, *options: str, generated: Path = GENERATED) -> Path:
    """The program that compares a robot's kernels."""
    compiler = shutil.which("g++")
    if compiler is None:
        pytest.skip("no g++")
    made = folder / f"{name}.o"
    flags = ["-std=c++17", "-O1", "-Wall", "-Wextra", "-Werror", "-Wno-unknown-pragmas", *options]
    flags += ["-U_FORTIFY_SOURCE"]  # it takes jumps from one stack to another for mistakes
    given = [*defined(name), f'-DDHGEN_SOURCE="{name}.c"', f"-I{generated}"]
    command = [compiler, *flags, *given, "-x", "c++", "-c", str(DRIVER), "-o", str(made)]
    subprocess.run(command, check=True)
    subprocess.run([compiler, str(made), "-o", str(folder / name), "-ldl"], check=True)
    return folder / name


def built_for_groups(name: str, group: int, folder: Path, generated: Path = GENERATED) -> Path:
    """The same for groups of threads, one of which may go on before each access to their room."""
    flags = [f"-DDHGEN_GROUP={group}", "-fsanitize=thread"]
    return built(name, folder, *flags, generated=generated)


def library(name: str, folder: Path) -> Path:
    """The robot's C."""
    made, source = folder / f"{name}.so", GENERATED / f"{name}.c"
    command = [str(c_compiler()), "-O1", "-shared", "-fPIC", str(source), "-o", str(made), "-lm"]
    subprocess.run(command, check=True)
    return made


def compared(*command: Path | str) -> dict[str, tuple[int, float, int]]:
    """Of each mode: statuses that differ, the most by which values do, and poses that were left."""
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    lines = (line.split() for line in done.stdout.splitlines())
    return {mode: (int(off), float(by), int(left)) for mode, off, by, left in lines}


def check(found: dict[str, tuple[int, float, int]]) -> None:
    """Statuses are the same, and values but for rounding."""
    assert {f"{mode}-double-16" for mode in ("rows", "nearest", "count", "motion")} <= found.keys()
    for mode, (off, by, _) in found.items():
        assert off == 0, mode
        assert by <= (SINGLE if "float" in mode else EXACT), mode


@pytest.mark.parametrize("name", those_in(("scara",), KINDS))
def test_kernels_answer_as_the_c_does(name: str, tmp_path: Path) -> None:
    """Poses are regular, singular, rounded, out of reach and none."""
    found = compared(built(name, tmp_path), str(COUNT - 5))
    check(found)
    for mode, (_, _, left) in found.items():
        if mode in LEAVING and is_regular(name) and name not in ALWAYS_REGULAR:
            assert 0 < left < COUNT // 2, mode


@pytest.mark.parametrize("name", those_in(("xarm6", "general_6r"), GROUPS))
def test_threads_that_solve_a_pose_together_answer_as_the_c_does(name: str, tmp_path: Path) -> None:
    """However far each of them runs ahead of the others."""
    program = built_for_groups(name, GROUPS[name], tmp_path)
    check(compared(program, str(FEW), library(name, tmp_path)))


@BREADTH
@pytest.mark.parametrize(
    "around",
    [
        ("int count)\n{\n", "    if (dhgen_thread() < count) {\n"),  # before lanes are stored
        ("        to[dhgen_thread()] = x;\n    }\n", "}\n"),  # and behind
        ("[DHGEN_ROOM_SIZE];\n", "    return rooms"),  # where an array begins
    ],
)
def test_a_meeting_that_is_left_out_is_noticed(around: tuple[str, str], tmp_path: Path) -> None:
    copied = tmp_path / "generated"
    shutil.copytree(GENERATED / "dhgen", copied / "dhgen")
    for end in ("xarm6.c", "xarm6.h", "dhgen_kernels.cuh"):
        shutil.copy(GENERATED / end, copied)
    header = copied / "dhgen" / "general" / "threads.h"
    text = header.read_text("utf-8")
    assert text.count("    dhgen_meet();\n".join(around)) == 1
    header.write_text(text.replace("    dhgen_meet();\n".join(around), "".join(around)), "utf-8")
    program = built_for_groups("xarm6", 16, tmp_path, copied)
    with pytest.raises(subprocess.CalledProcessError) as told:
        compared(program, str(FEW), library("xarm6", tmp_path))
    assert "since they met" in told.value.stderr
