"""C that holds what it needs of the runtime: the same machine code, in one file."""

from __future__ import annotations

import re
import subprocess
from typing import TYPE_CHECKING

import pytest

from dhgen.atomic_write import write_files
from dhgen.cli import main
from dhgen.runtime import runtime_files
from dhgen.targets.c.files import c_files
from dhgen.verify.native import c_compiler
from tests.targets.made import ROBOTS, folder, made

if TYPE_CHECKING:
    from pathlib import Path

# Between them all that files include: lanes, circles, descents, and each way of general arms.
ARMS = ("cuspidal_3r", "fanuc_crx10ia", "general_4r2p", "general_6r", "planar_rrrr", "scara")


def assembler(name: str, directory: Path, *flags: str) -> str:
    """What a compiler makes of a source."""
    command = [str(c_compiler()), "-std=c99", *flags, "-S", f"{name}.c", "-o", "-"]
    done = subprocess.run(command, cwd=directory, capture_output=True, text=True, check=True)
    return done.stdout


@pytest.mark.parametrize("name", ARMS)
def test_it_is_the_same_machine_code(name: str) -> None:
    alone = folder() / "alone"
    files = c_files(made(name).module, single_file=True)
    write_files(alone, files)
    assert re.findall(r'#include "(.*?)"', files[f"{name}.c"]) == [f"{name}.h"]
    for flags in (("-O1",), ("-O1", "-march=native")):
        assert assembler(name, alone, *flags) == assembler(name, folder(), *flags)


@pytest.mark.parametrize("name", ["general_6r", "scara"])
def test_among_robots_that_share_the_runtime_it_keeps_its_own(name: str) -> None:
    alone = folder() / "alone"
    write_files(alone, c_files(made(name).module, single_file=True))
    assert assembler(name, alone, "-O0", "-DDHGEN_SHARED") == assembler(name, folder(), "-O0")


def test_single_precision_among_robots_that_share_the_runtime() -> None:
    made("scara")
    same = assembler("scara_f32", folder(), "-O0")
    assert assembler("scara_f32", folder(), "-O0", "-DDHGEN_SHARED") == same


def test_the_command_writes_and_compares_it(tmp_path: Path) -> None:
    """Verified like the others, and beside no folder of the runtime's C."""
    words = [str(ROBOTS / "planar_rr.yaml"), "--single-file", "--out", str(tmp_path)]
    assert main(words) == 0
    assert main(["--check", *words]) == 0
    names = {path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*.[ch]")}
    assert not names & set(runtime_files())
    assert main(["--check", *words[:1], *words[2:]]) == 1  # without the option others are expected
