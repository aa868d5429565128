"""Robots that hold what they need of the runtime: the same machine code, in one file."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from typing import TYPE_CHECKING

import numba
import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.cli import main
from dhgen.runtime import runtime_files
from dhgen.targets.c.files import c_files
from dhgen.targets.python.files import python_files
from dhgen.verify.native import c_compiler
from tests.compiling import FEW, verify_little
from tests.structures import first_of
from tests.targets.made import ROBOTS, folder, made, without_numba

if TYPE_CHECKING:
    from pathlib import Path

# Between them all that files include: lanes, circles, descents, and each way of general arms.
ARMS = ("cuspidal_3r", "fanuc_crx10ia", "general_4r2p", "general_6r", "planar_rrrr", "scara")


def code(name: str, directory: Path, *flags: str) -> list[str]:
    """What a compiler sees of a source, its system's headers aside, token by token.

    Of equal tokens it makes equal machine code.
    """
    command = [str(c_compiler()), "-std=c99", *flags, "-E", f"{name}.c"]
    done = subprocess.run(command, cwd=directory, capture_output=True, text=True, check=True)
    seen: list[str] = []
    ours = False
    for line in done.stdout.splitlines():
        if line.startswith("# "):
            ours = not line.split('"')[1].startswith(("/", "<"))
        elif ours:
            seen += line.split()
    return seen


@pytest.mark.parametrize("name", ARMS)
def test_it_is_the_same_machine_code(name: str) -> None:
    alone = folder() / "alone"
    files = c_files(made(name).module, single_file=True)
    write_files(alone, files)
    assert re.findall(r'#include "(.*?)"', files[f"{name}.c"]) == [f"{name}.h"]
    for flags in (("-O1",), ("-O1", "-march=native")):
        seen = code(name, folder(), *flags)
        assert len(seen) > 1000
        assert code(name, alone, *flags) == seen


@pytest.mark.parametrize("name", ["general_6r", "scara"])
def test_among_robots_that_share_the_runtime_it_keeps_its_own(name: str) -> None:
    alone = folder() / "alone"
    write_files(alone, c_files(made(name).module, single_file=True))
    assert code(name, alone, "-DDHGEN_SHARED") == code(name, folder())


def test_single_precision_among_robots_that_share_the_runtime() -> None:
    made("scara")
    assert code("scara_f32", folder(), "-DDHGEN_SHARED") == code("scara_f32", folder())


# Run with an empty folder in the path: every function stands in the file where it says, and a
# second process finds all that numba compiled.
ALONE = """
import importlib
import sys
from types import CodeType
import numpy as np
from numba.core import event

with event.install_recorder("numba:compile") as compiled:
    robot = importlib.import_module(sys.argv[1])
    q = np.full(robot.DOF, 0.3)
    rows, status = robot.ik_all(robot.fk(q))
print(rows.tobytes().hex(), status.tolist(), len(compiled.buffer))
lines = open(robot.__file__).read().split("\\n")
checked = 0
for name, module in list(sys.modules.items()):
    for known in vars(module).values() if "dhgen_runtime." in name else ():
        code = getattr(getattr(known, "py_func", known), "__code__", None)
        here = isinstance(code, CodeType) and code.co_filename == robot.__file__
        if here and code.co_name != "<lambda>":
            begin = "".join(lines[code.co_firstlineno - 1 :][:9])
            assert f"def {code.co_name}(" in begin, (code, begin)
            checked += 1
assert checked > 20
assert not [name for name in sys.modules if name.startswith("dhgen")]
"""


def alone_in(directory: Path, name: str, **environment: str) -> str:
    """What a clean process says of a module that is alone in its folder."""
    done = subprocess.run(
        [sys.executable, "-c", ALONE, name],
        cwd=directory,
        env={key: value for key, value in os.environ.items() if key != "PYTHONPATH"} | environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.stderr == ""
    return done.stdout


@pytest.mark.parametrize(
    "name", first_of(["scara", "cuspidal_3r", "general_4r2p", "planar_rrrr"], count=2)
)
def test_a_module_alone_gives_the_same_answers(name: str, tmp_path: Path) -> None:
    """In plain Python, where nothing is rounded otherwise, in a folder with an awkward name."""
    directory = tmp_path / "a.b#c%2E"
    write_files(directory, python_files(made(name).module, single_file=True))
    robot = without_numba(made(name).files[f"{name}.py"], name)
    rows, status = robot.ik_all(robot.fk(np.full(robot.DOF, 0.3)))
    said = alone_in(directory, name, NUMBA_DISABLE_JIT="1")
    assert said == f"{rows.tobytes().hex()} {status.tolist()} 0\n"


@pytest.mark.breadth
def test_what_numba_makes_of_a_module_alone_is_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By the command, which verifies it: no process that imports it compiles anything."""
    monkeypatch.setattr(numba.config, "CACHE_DIR", "")
    monkeypatch.setattr("dhgen.verify.verify.COUNT", FEW)
    assert main([str(ROBOTS / "planar_rr.yaml"), "--single-file", "--out", str(tmp_path)]) == 0
    first, second = (alone_in(tmp_path, "planar_rr", NUMBA_CACHE_DIR="") for _ in range(2))
    assert first == second
    assert int(first.split()[-1]) == 0


def test_the_command_writes_and_compares_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Verified like the others, and beside no folder of the runtime."""
    verify_little(monkeypatch)  # with numba: above
    words = [str(ROBOTS / "planar_rr.yaml"), "--single-file", "--out", str(tmp_path)]
    assert main(words) == 0
    assert main(["--check", *words]) == 0
    names = {path.relative_to(tmp_path).as_posix() for path in tmp_path.rglob("*.*")}
    assert not names & set(runtime_files())
    assert main(["--check", *words[:1], *words[2:]]) == 1  # without the option others are expected
