"""The C as compilers and sanitizers see it: no warning, and nothing undefined on any pose."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.oracle.poses import random_joints, right_angles
from dhgen.targets.c.files import c_files
from dhgen.verify.native import Build
from tests.compiling import shared
from tests.headers import VECTORS, read_before
from tests.oracle.sets import one_joint_at, out_of_reach
from tests.structures import GENERAL, ODD, STRUCTURES, first_of, one_of_each
from tests.targets.made import MADE_UP_NAMES, NAMES, ROBOTS, folder, made, poses_of, robot

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

EVERY = [*NAMES, *MADE_UP_NAMES]
SOME = [*NAMES, *ODD]
WARNINGS = (
    "-pedantic-errors",
    "-Wall",
    "-Wextra",
    "-Wconversion",
    "-Wshadow",
    "-Wdouble-promotion",
    "-Werror",
)
SHARED = "-DDHGEN_SHARED"
# Of other arms, what is the same for all was seen; general arms at -O1 in tests of the runtime.
WHOLE = {"scara": ("-O0", "-O1", "-O2", "-O3"), "fanuc_crx10ia": ("-O2",)}
MORE = ("-Wcast-qual", "-Wstrict-prototypes", "-Wmissing-prototypes", "-Wold-style-definition")
COMPILERS = [name for name in ("gcc", "clang") if shutil.which(name)]
CPP = [name for name in ("g++", "clang++") if shutil.which(name)]
GENERATED = ROBOTS.parent / "generated"
WRITTEN = sorted(path.stem for path in GENERATED.glob("*.c") if path.stem != "dhgen_native")
DRIVER = Path(__file__).with_name("sanitized.c.txt")


def compiled(*command: str) -> str:
    """What a compiler says."""
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=folder())
    return f"{done.returncode or ''}{done.stderr}"


def test_there_is_a_compiler() -> None:
    assert COMPILERS


@pytest.mark.parametrize("name", one_of_each(EVERY))
def test_no_warnings(name: str) -> None:
    assert_no_warnings(name, COMPILERS[0])


@pytest.mark.parametrize("compiler", COMPILERS[1:])
@pytest.mark.parametrize("name", one_of_each(SOME))
def test_no_warnings_of_other_compilers(name: str, compiler: str) -> None:
    assert_no_warnings(name, compiler)


def assert_no_warnings(name: str, compiler: str) -> None:
    made(name)
    levels: list[tuple[str, ...]]
    if compiler == "gcc":
        levels = [(level,) for level in WHOLE.get(name, ())] or [("-O2", SHARED)]
    else:  # what clang warns of, it sees before it optimises
        whole = name in WHOLE and name not in GENERAL  # of which one is asked below
        levels = [("-O2",)] if whole else [("-fsyntax-only",)]
    for level in levels:
        flags = ("-std=c99", *level, *WARNINGS, *MORE, "-c", f"{name}.c", "-o", f"{name}.o")
        assert compiled(compiler, *flags) == ""


@pytest.mark.parametrize("name", one_of_each(SOME))
def test_no_warnings_in_lanes(name: str) -> None:
    """What only this machine's vectors are for is read too."""
    made(name)
    flags = ("-std=c99", "-march=native", *WARNINGS, *MORE)
    vectors = read_before(COMPILERS[0], VECTORS, *flags)
    assert compiled(COMPILERS[0], *flags, *vectors, "-fsyntax-only", f"{name}.c") == ""


@pytest.mark.slow
@pytest.mark.parametrize("name", ["scara", "fanuc_crx10ia"])
@pytest.mark.parametrize("compiler", [*COMPILERS[:1], *CPP[:1]])
def test_no_warnings_in_wide_lanes(name: str, compiler: str) -> None:
    """What compilers see once they have unrolled and inlined, their own headers among it."""
    made(name)
    language = ("-x", "c++", "-std=c++14") if compiler in CPP else ("-std=c99",)
    wide = ("-mavx512f", "-mavx512dq", "-mavx512vl", "-mfma")
    flags = ("-O3", *wide, *WARNINGS, "-c", f"{name}.c", "-o", f"{name}_wide.o")
    assert compiled(compiler, *language, *flags) == ""


@pytest.mark.parametrize("name", one_of_each(SOME))
def test_no_warnings_without_the_fast_path(name: str) -> None:
    made(name)
    switch = f"-D{name.upper()}_PLAIN"
    flags = ("-std=c99", switch, "-fsyntax-only", *WARNINGS, *MORE, f"{name}.c")
    assert compiled(COMPILERS[-1], *flags) == ""


@pytest.mark.skipif("clang" not in COMPILERS, reason="no clang")
def test_no_warnings_of_all_in_one_file_without_series() -> None:
    """What a file has in itself, and not from a header, clang wants to be used."""
    module = made("scara").module
    alone = folder() / "one_file"
    write_files(alone, c_files(module, single_file=True))
    files = {"SCARA": alone / "scara.c", "SCARA_F32": GENERATED / "scara_f32.c"}
    for name, path in files.items():
        flags = ("-std=c99", f"-D{name}_LIBM", *WARNINGS, *MORE, f"-I{path.parent}")
        assert compiled("clang", *flags, "-fsyntax-only", str(path)) == ""


@pytest.mark.slow
@pytest.mark.skipif("clang" not in COMPILERS, reason="no clang")
@pytest.mark.parametrize("level", first_of(["-Oz", "-O2"]))
def test_no_warnings_where_loops_are_unrolled(level: str) -> None:
    """That a loop is not unrolled is told while optimising."""
    made("general_6r")
    flags = ("-std=c99", "-march=native", level, *WARNINGS, *MORE, "-c", "general_6r.c")
    assert compiled("clang", *flags, "-o", "general_6r.o") == ""


# What a robot's file includes stands outside, then the file may stand in a namespace.
OUTSIDE = f"""\
#include <math.h>
#include <stddef.h>
{VECTORS}"""
INSIDE = """\
namespace inside {{
#include "{}.c"
}}
"""


def in_a_namespace(compiler: str, name: str, directory: Path) -> str:
    """What a C++ compiler says of a source in a namespace, in lanes."""
    own = folder() / f"{name}_inside.cpp"
    own.write_text(INSIDE.format(name), encoding="utf-8")
    flags = ("-std=c++14", "-march=native", *WARNINGS)
    outside = read_before(compiler, OUTSIDE, *flags)
    return compiled(compiler, *flags, *outside, f"-I{directory}", "-fsyntax-only", str(own))


@pytest.mark.skipif(not CPP, reason="no C++ compiler")
@pytest.mark.parametrize("name", first_of(ODD, count=4))
def test_sources_are_cpp_also_in_a_namespace(name: str) -> None:
    """By one of the compilers each."""
    made(name)
    compiler = CPP[ODD.index(name) % len(CPP)]
    assert in_a_namespace(compiler, name, folder()) == ""


@pytest.mark.skipif(not CPP, reason="no C++ compiler")
@pytest.mark.parametrize("name", one_of_each(WRITTEN))
def test_all_written_sources_are_cpp(name: str) -> None:
    compiler = CPP[WRITTEN.index(name) % len(CPP)]
    assert in_a_namespace(compiler, name, GENERATED) == ""


def in_cpp(compiler: str, names: list[str]) -> str:
    """What a C++ compiler says of headers."""
    calls = [f"auto f_{n} = &{n}_ik; int n_{n} = {n.upper()}_ROWS;" for n in names]
    includes = [f'#include "{name}.h"' for name in names]
    main = "int main() { return 0; }"
    (folder() / f"{names[0]}.cpp").write_text("\n".join([*includes, *calls, main]))
    flags = ("-std=c++11", *WARNINGS, "-I", str(GENERATED), "-fsyntax-only", f"{names[0]}.cpp")
    return compiled(compiler, *flags)


@pytest.mark.parametrize("compiler", CPP)
def test_all_headers_together_are_read_by_cpp(compiler: str) -> None:
    assert in_cpp(compiler, sorted(path.stem for path in ROBOTS.glob("*.yaml"))) == ""


@pytest.mark.skipif(not CPP, reason="no C++ compiler")
@pytest.mark.parametrize("name", first_of(ODD, count=4))
def test_headers_are_read_by_cpp(name: str) -> None:
    """By the other compiler than their sources."""
    made(name)
    compiler = CPP[(ODD.index(name) + 1) % len(CPP)]
    assert in_cpp(compiler, [name]) == ""


def test_names_are_c_names_for_cpp() -> None:
    """Linked to C++, the C is found: extern "C" holds."""
    if not shutil.which("g++"):
        pytest.skip("no C++ compiler")
    made("scara")
    (folder() / "use.cpp").write_text(
        '#include "scara.h"\nint main() { double q[4] = {0}, T[16], all[2][4];\n'
        "unsigned char s[2]; scara_fk(q, T); return scara_ik(T, q, all, s) > 0 ? 0 : 1; }"
    )
    assert compiled("gcc", "-std=c99", "-c", "scara.c", "-o", "scara_c.o") == ""
    assert compiled("g++", "use.cpp", "scara_c.o", "-o", "use", "-lm") == ""
    assert subprocess.run([folder() / "use"], check=False).returncode == 0


def test_names_of_joints_in_c() -> None:
    """UR5's macro goes over several lines, SCARA has names of its own making: both are arrays."""
    program = """#include <stdio.h>
#include "ur5.h"
#include "scara.h"
int main(void) {
    const char *const names[UR5_DOF + SCARA_DOF] = { UR5_JOINT_NAMES, SCARA_JOINT_NAMES };
    for (int i = 0; i < UR5_DOF + SCARA_DOF; i++) puts(names[i]);
    return 0;
}
"""
    (folder() / "joint_names.c").write_text(program)
    built = ("-std=c99", *WARNINGS, "-I", str(GENERATED), "joint_names.c", "-o", "joint_names")
    assert compiled("gcc", *built) == ""
    shown = subprocess.run([folder() / "joint_names"], capture_output=True, text=True, check=True)
    assert shown.stdout.split() == [
        *("shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint"),
        *("wrist_1_joint", "wrist_2_joint", "wrist_3_joint"),
        *("joint1", "joint2", "joint3", "joint4"),
    ]


def poses(name: str) -> FloatArray:
    """Ordinary poses, singular ones, poses out of reach, and none at all; fewer of general arms."""
    arm = robot(name)
    most = 150 if made(name).module.solver.rows == 16 else 600
    source = np.random.default_rng(51)
    q = np.concatenate(
        [random_joints(arm, 200), right_angles(arm, 200), one_joint_at(arm, (0.0, np.pi), 10)]
    )
    good = source.permutation(poses_of(name, q))[:most]
    bad = good[:100].copy()
    bad.reshape(100, 16)[np.arange(100), source.integers(0, 16, 100)] = source.choice(
        [np.nan, np.inf, -np.inf, 1e300, -1e-300], 100
    )
    noise = source.normal(0.0, 1.0, (100, 4, 4)) * 10.0 ** source.integers(-300, 300, (100, 1, 1))
    far = out_of_reach(arm, 20)
    return np.concatenate([good, bad, noise, far, np.zeros((1, 4, 4)), np.eye(4)[None]])


# One of each way to be solved, and one in lanes. Of the two general arms one: sanitizers take as
# long with it as with ten others.
AT_LEAST = (
    *("scara", "cuspidal_3r", "fanuc_crx10ia", "given_shoulder", "kuka_iiwa14_arm_angle"),
    *("puma560", "scorbot_pointing"),
)
WATCHED = [name for name in SOME if name not in GENERAL or name in STRUCTURES]
FURTHER = [name for name in WATCHED if name not in AT_LEAST]
LANES = ["ur5", "scara", "kuka_iiwa14", "cartesian"]
SANITIZED = [
    *((name, "scalar") for name in AT_LEAST),
    *first_of((name, "lanes") for name in LANES),
    *first_of(((name, "scalar") for name in FURTHER), count=0),
]


@pytest.mark.slow
@pytest.mark.parametrize(("name", "form"), SANITIZED)
def test_sanitizers_find_nothing(name: str, form: str) -> None:
    module = made(name).module
    sizes = {"ROWS": module.solver.rows, "DOF": module.chain.dof, "GIVEN_COUNT": module.chain.given}
    text = DRIVER.read_text().replace('"NAME.h"', f'"{name}.h"')
    (folder() / f"{name}_driver.c").write_text(text)
    poses(name).tofile(folder() / f"{name}.poses")
    defines = [f"-D{key}={value}" for key, value in sizes.items()] + [f"-DNAME={name}"]
    # a singular pose may divide by zero before it is found to be one: IEEE arithmetic defines that
    sanitizers = "-fsanitize=address,undefined,float-cast-overflow"
    machine = ("-march=native",) if form == "lanes" else ()
    level = "-O1" if module.solver.rows == 16 else "-O0"  # general arms run longer than compilers
    flags = (level, "-g1", sanitizers, "-fno-sanitize-recover=all", *machine)
    program = f"{name}_sanitized_{form}"
    build = Build(program, flags, COMPILERS[0])
    if name in MADE_UP_NAMES:  # arrays of the runtime are as long as the arm needs in the others
        build = shared(folder() / f"{name}.c", build)
    files = (f"{name}_driver.c", f"{name}.c", "-o", program)
    assert compiled(COMPILERS[0], "-std=c99", *defines, *files, *build.flags, "-lm") == ""
    done = subprocess.run(
        [folder() / program, folder() / f"{name}.poses"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert int(done.stdout) > 100
