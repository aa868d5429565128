"""The general algorithm's C under every compiler that is here, as C and C++, alone and inside."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

import dhgen.runtime
from tests.structures import first_of

FOLDER = Path(dhgen.runtime.__file__).parent / "c"
STRICT = (
    *("-pedantic-errors", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Wdouble-promotion"),
    "-Werror",
)
LANGUAGES = {
    "gcc": ("-std=c99",),
    "clang": ("-std=c99",),
    "g++": ("-x", "c++", "-std=c++14"),
    "clang++": ("-x", "c++", "-std=c++14"),
}
IN_WIDTHS = {"gcc": (4, 1, 2, 8), "clang": (2, 1, 4, 8), "g++": (2,), "clang++": (4,)}
COMPILERS = [name for name in LANGUAGES if shutil.which(name)]
QUICKEST = "clang" if "clang" in COMPILERS else COMPILERS[0]
HEADERS = sorted(path.relative_to(FOLDER).as_posix() for path in FOLDER.glob("dhgen/*/*.h"))
INSIDE = """\
#include <math.h>
#include <stddef.h>
#if defined(__SSE2__)
#include <immintrin.h>
#endif
namespace inside {
#include "dhgen/general.h"
}
"""


def said(compiler: str, text: str, *flags: str, folder: Path) -> str:
    """What a compiler says of a source."""
    (folder / "own.c").write_text(text, encoding="utf-8")
    own = (*LANGUAGES[compiler], "-O2", *STRICT, f"-I{FOLDER}", *flags)
    command = [compiler, *own, "-fsyntax-only", "own.c"]
    return subprocess.run(
        command, cwd=folder, capture_output=True, text=True, check=False
    ).stderr.strip()


# C is read in every width, C++ in one each: what it minds is the same in all.
WIDTHS = [
    case for name in COMPILERS for case in first_of((name, lanes) for lanes in IN_WIDTHS[name])
]


@pytest.mark.parametrize(("compiler", "lanes"), WIDTHS)
def test_nothing_is_said_of_it(compiler: str, lanes: int, tmp_path: Path) -> None:
    text = '#define DHGEN_SHARED\n#include "dhgen/general.c"\n'
    wide = (f"-DDHGEN_GENERAL_LANES={lanes}", "-Wno-psabi")  # vectors wider than the machine's
    assert said(compiler, text, *wide, folder=tmp_path) == ""


# By one compiler in every way, by the others as it is on this machine.
IN_A_FILE = [(COMPILERS[0], flags) for flags in ("-Os", "-DDHGEN_TRAITS=0x200u")]
IN_A_FILE += [(name, "-march=native") for name in COMPILERS]


@pytest.mark.slow
@pytest.mark.parametrize(("compiler", "flags"), first_of(IN_A_FILE, count=3))
def test_nothing_is_said_of_it_in_a_robots_file(compiler: str, flags: str, tmp_path: Path) -> None:
    assert said(compiler, '#include "dhgen/general.h"\n', flags, folder=tmp_path) == ""


@pytest.mark.parametrize("compiler", [name for name in COMPILERS if name.endswith("++")])
def test_it_may_stand_in_a_namespace(compiler: str, tmp_path: Path) -> None:
    assert said(compiler, INSIDE, folder=tmp_path) == ""


@pytest.mark.breadth
@pytest.mark.parametrize("header", HEADERS)
def test_a_header_includes_what_it_needs(header: str, tmp_path: Path) -> None:
    assert said(QUICKEST, f'#include "{header}"\n', folder=tmp_path) == ""


@pytest.mark.parametrize("flag", first_of(["-ffinite-math-only", "-ffast-math"]))
@pytest.mark.parametrize("compiler", COMPILERS)
def test_it_refuses_to_do_without_nan(compiler: str, flag: str, tmp_path: Path) -> None:
    first = (flag, "-Wfatal-errors")  # what follows the first mistake is of no interest
    told = said(compiler, '#include "dhgen/general.h"\n', *first, folder=tmp_path)
    assert "needs NaN and infinity: compile without -ffast-math" in told


def test_it_refuses_a_robots_file_of_another_version(tmp_path: Path) -> None:
    """As a robot's file expects it: its first lines, with the number of another interface."""
    text = (FOLDER.parents[2] / "generated" / "scara.c").read_text("utf-8")
    expected = "#define DHGEN_EXPECTS 1 "
    assert text.index(expected) < text.index('#include "dhgen/')
    other = text.replace(expected, "#define DHGEN_EXPECTS 2 ")
    beside = (f"-I{FOLDER.parents[2] / 'generated'}", "-Wfatal-errors")
    told = said(QUICKEST, other, *beside, folder=tmp_path)
    assert "the folder dhgen/ is of another version: run dhgen on the robot file again" in told


def test_it_is_formatted() -> None:
    formatter = shutil.which("clang-format")
    if formatter is None:
        pytest.skip("no clang-format")
    files = [str(path) for path in sorted(FOLDER.rglob("*")) if path.suffix in {".c", ".h"}]
    done = subprocess.run(
        [formatter, "--dry-run", "-Werror", *files],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stderr == ""


# All of the runtime: compiled once for all robots, and what only robots' files include.
TIDY = {
    "dhgen/general.c": ("-DDHGEN_SHARED",),
    "dhgen/dhgen.c": ("-DDHGEN_SHARED",),
    "dhgen_pose.c": (),
    "own.c": ("-march=native",),
}
IN_LANES = """\
#define DHGEN_DOF 6
#define DHGEN_ROWS 8
#include "dhgen/circle_roots.h"
#include "dhgen/tile.h"
"""


@pytest.mark.slow
@pytest.mark.parametrize("source", TIDY)
def test_clang_tidy_finds_nothing(source: str, tmp_path: Path) -> None:
    if shutil.which("clang-tidy") is None:
        pytest.skip("no clang-tidy")
    path = FOLDER / source
    if not path.exists():
        path = tmp_path / source
        path.write_text(IN_LANES, encoding="utf-8")
    config = f"--config-file={FOLDER.parents[2] / '.clang-tidy'}"
    command = ["clang-tidy", "--quiet", config, str(path), "--"]
    flags = ["-std=c99", f"-I{FOLDER}", *TIDY[source]]
    done = subprocess.run([*command, *flags], capture_output=True, text=True, check=False)
    assert done.stdout == ""
    assert done.returncode == 0
