"""Robots' C and the kernels around it, as NVRTC compiles them: there is no GPU here."""

from __future__ import annotations

import re
import shutil
import subprocess
from typing import TYPE_CHECKING

import pytest

from dhgen.runtime.helpers.dhgen_cuda import GROUP
from tests.gpu.nvrtc import (
    CAREFUL,
    FIRST,
    GENERATED,
    MOTION,
    compiled,
    is_regular,
    kernels_of,
    used,
)
from tests.structures import BREADTH, those_in

if TYPE_CHECKING:
    from pathlib import Path

FLEET, SINGLE = "_fleet", "_f32"
SHARED = {"dhgen_native", "dhgen_pose"}
MADE = sorted(path.stem for path in GENERATED.glob("*.c") if path.stem not in SHARED)
PARALLEL = [name for name in MADE if "_LEGS = " in (GENERATED / f"{name}.h").read_text("utf-8")]
ALL = [name for name in MADE if name not in PARALLEL]
ARMS = [name for name in ALL if not name.endswith((FLEET, SINGLE))]
OTHERS = [name for name in ALL if name.endswith((FLEET, SINGLE))]
CLOSED = [name for name in ARMS if is_regular(name)]
GENERAL = [
    name for name in ARMS if "#define DHGEN_TRAITS " in (GENERATED / f"{name}.c").read_text("utf-8")
]
# Closed forms in which nothing needs a sine of an angle that comes from outside: of a given joint
# it may be large, and taking its turns away needs forty bytes of memory.
WITHOUT_SINES = [
    name for name in CLOSED if "_FREE = " not in (GENERATED / f"{name}.h").read_text("utf-8")
]
MOST_REGISTERS = 184  # five blocks of 64 threads are on a multiprocessor then
# Bytes: cards of sm_120 have few units for doubles, and wait for these.
MOST_STACK = {"sm_120": 56}
ARCHITECTURES = ("sm_80", "sm_90", "sm_120")
USER = """
#include "scara.c"
__global__ void rows(const double *q, double *found, unsigned char *status)
{
    double T[16], J[24];
    scara_fk(q, T);
    scara_jacobian(q, J);
    scara_ik(T, nullptr, (double(*)[4])found, status);
    found[0] += J[0];
}
int main()
{
    const double q[4] = { 0.3, -0.8, -0.05, 1.0 };
    double T[16], found[2][4];
    unsigned char status[2];
    scara_fk(q, T);
    return scara_ik(T, nullptr, found, status) == 2 && scara_branches[0] ? 0 : 1;
}
"""

IN_GROUPS = """
#define DHGEN_GROUP 16
#define DHGEN_ROBOT xarm6
#define DHGEN_GIVEN 0
#include "xarm6.c"
#include "dhgen_kernels.cuh"
"""
ON_THE_HOST = """
int main()
{
    const double q[6] = { 0.3, -0.8, -0.5, 1.0, 0.7, 0.2 };
    double T[16], found[16][6];
    unsigned char status[16];
    xarm6_fk(q, T);
    return xarm6_ik(T, nullptr, found, status) > 1 ? 0 : 1;
}
"""


@pytest.mark.parametrize("name", those_in(("scara",), ARMS))
def test_every_kernel_of_an_arm_compiles_without_a_warning(name: str) -> None:
    """All of them in one source, to what no architecture is chosen for yet."""
    wanted = [*(FIRST if is_regular(name) else ()), *CAREFUL, *MOTION]
    kernels = [f"dhgen_{each}<double, 16>" for each in wanted]
    kernels_of(name, [*kernels, "dhgen_careful_rows<float, 12>"], ["-arch=compute_80"])


@pytest.mark.parametrize("name", those_in(("xarm6",), GENERAL))
def test_kernels_for_groups_of_threads_compile_without_a_warning(name: str) -> None:
    kernels = [f"dhgen_{each}<double, 16>" for each in CAREFUL]
    kernels_of(name, kernels, ["-arch=compute_80", f"-DDHGEN_GROUP={GROUP}"])


@BREADTH
def test_groups_of_threads_need_less_memory_of_their_own() -> None:
    """A thread that solves a pose alone takes 56 kilobytes."""
    option = f"-DDHGEN_GROUP={GROUP}"
    needed = used("xarm6", "dhgen_careful_rows<double, 16>", ARCHITECTURES[1], option)
    assert needed.stack <= 32 << 10
    assert needed.shared <= 48 << 10  # what a block has without asking for it


@pytest.mark.parametrize("name", those_in((), OTHERS))
def test_other_files_compile_without_a_warning(name: str) -> None:
    """Those whose table comes at run time, and in single precision."""
    compiled(f'#include "{name}.c"\n', ["-arch=compute_80"])


@pytest.mark.parametrize("name", those_in(("delta",), PARALLEL))
def test_parallel_robots_compile_without_a_warning(name: str) -> None:
    """Their legs are in files of their own: what they call there is linked."""
    compiled(f'#include "{name}.c"\n', ["-arch=compute_80", "-rdc=true"])


@pytest.mark.parametrize("architecture", those_in(ARCHITECTURES[1:2], ARCHITECTURES))
@pytest.mark.parametrize("name", those_in(("scara",), WITHOUT_SINES))
def test_regular_poses_need_no_memory_of_their_own(name: str, architecture: str) -> None:
    """Nor more registers than leave room for enough threads to keep its memory busy."""
    needed = used(name, "dhgen_all_rows<double, 16>", architecture)
    assert needed.registers <= MOST_REGISTERS
    assert needed.stack <= MOST_STACK.get(architecture, 0)


@pytest.mark.parametrize("kernel", ["count_rows<double, 16>", "all_rows<float, 12>"])
@pytest.mark.parametrize("name", those_in((), WITHOUT_SINES))
def test_other_kernels_of_regular_poses_need_little_either(name: str, kernel: str) -> None:
    needed = used(name, f"dhgen_{kernel}", ARCHITECTURES[1])
    assert needed.registers <= MOST_REGISTERS
    assert needed.stack == 0


def built(text: str, folder: Path, *flags: str) -> Path:
    """What nvcc makes of a source, without a warning."""
    compiler = shutil.which("nvcc")
    if compiler is None:
        pytest.skip("no nvcc")
    source, made = folder / "user.cu", folder / "made"
    source.write_text(text, encoding="utf-8")
    given = ["-Werror", "all-warnings", "-std=c++17", "-arch=sm_90", f"-I{GENERATED}", *flags]
    command = [compiler, *given, str(source), "-o", str(made)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return made


@BREADTH
def test_functions_are_for_both_sides_in_a_users_source(tmp_path: Path) -> None:
    assert subprocess.run([built(USER, tmp_path)], check=False).returncode == 0


@BREADTH
def test_the_source_in_docs_is_one(tmp_path: Path) -> None:
    page = (GENERATED.parent / "docs" / "gpu.md").read_text("utf-8")
    (text,) = re.findall(r"```c\n(#define DHGEN_ROBOT.*?)```", page, re.DOTALL)
    assert built(text, tmp_path, "-c").stat().st_size > 0


@BREADTH
def test_groups_of_threads_are_on_the_device_alone(tmp_path: Path) -> None:
    assert subprocess.run([built(IN_GROUPS + ON_THE_HOST, tmp_path)], check=False).returncode == 0


@BREADTH
def test_the_launch_of_groups_in_docs_is_one(tmp_path: Path) -> None:
    page = (GENERATED.parent / "docs" / "gpu.md").read_text("utf-8")
    (launch,) = re.findall(r"```c\n(dhgen_careful_rows.*?)```", page, re.DOTALL)
    arguments = "size_t n, const dhgen_batch<double> &batch, cudaStream_t stream"
    text = f"{IN_GROUPS}void solve({arguments})\n{{\n{launch}}}\n"
    assert built(text, tmp_path, "-ptx").stat().st_size > 0


@BREADTH
@pytest.mark.parametrize("name", ["ur5e_fleet", "delta"])
def test_tables_of_other_files_are_where_kernels_read_them(name: str, tmp_path: Path) -> None:
    """NVRTC, which makes nothing for the host, takes a table without its mark."""
    assert built(f'#include "{name}.c"\n', tmp_path, "-c", "-rdc=true").stat().st_size > 0
