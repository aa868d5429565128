"""Files of parallel robots on their own: with the runtime in them, and beside those of others."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.cli import main
from dhgen.parallel.compile import compile_file
from dhgen.parallel.native import compiled
from dhgen.robot_files import read_file
from tests.parallel.made import compilation, native, poses
from tests.parallel.test_parallel_c import COMPILERS, WARNINGS, told
from tests.serial import ROBOTS

if TYPE_CHECKING:
    from collections.abc import Mapping

NAME = "five_bar"
WITHOUT_FOLDER = [each for each in WARNINGS if not each.startswith("-I")]
IN_PYTHON = """
import sys
import numpy as np
import five_bar
T = np.array(eval(sys.argv[1]))
q, status = five_bar.ik_all(T)
print(q.tobytes().hex(), status.tolist())
assert not [name for name in sys.modules if name.startswith("dhgen")]
"""
# A serial arm whose name is that of a leg.
SERIAL = "name: five_bar_leg\njoints:\n  - {theta: q, a: 1}\n  - {theta: q, a: 1}\ntask: [x, y]\n"


@cache
def alone() -> Mapping[str, str]:
    """A robot's files, each with what it needs of the runtime."""
    return compile_file(read_file(ROBOTS / f"{NAME}.yaml"), single_file=True).files


@pytest.mark.parametrize("compiler", COMPILERS)
def test_single_files_compile_alone(compiler: str, tmp_path: Path) -> None:
    write_files(
        tmp_path, {name: text for name, text in alone().items() if name[-2:] in {".c", ".h"}}
    )
    assert not (tmp_path / "dhgen").exists()
    standard = ("-x", "c++", "-std=c++14") if compiler.endswith("++") else ("-std=c99",)
    for name in (NAME, f"{NAME}_leg"):
        source = str(tmp_path / f"{name}.c")
        ours = set(re.findall(r'#include "(.*?)"', alone()[f"{name}.c"]))
        assert ours <= {f"{NAME}.h", f"{NAME}_leg.h"}
        assert told(compiler, *standard, *WITHOUT_FOLDER, "-fsyntax-only", source) == ""
        refused = told(compiler, *standard, "-ffast-math", "-fsyntax-only", source)
        assert "compile without -ffast-math" in refused


@pytest.mark.skipif(not COMPILERS, reason="no C compiler")
def test_single_files_give_the_same_answers(tmp_path: Path) -> None:
    write_files(tmp_path, alone())
    robot, pose = compiled(compilation(NAME).module, tmp_path), poses(NAME)[0]
    assert robot is not None
    for one, other in zip(robot.ik(pose), native(NAME).ik(pose), strict=True):
        np.testing.assert_array_equal(one, other)
    plain = {key: text for key, text in os.environ.items() if key != "PYTHONPATH"}
    command = [sys.executable, "-c", IN_PYTHON, str(pose.tolist())]
    said = []
    for folder in (tmp_path, ROBOTS.parent / "generated"):
        done = subprocess.run(
            command,
            cwd=folder,
            env=plain | {"NUMBA_DISABLE_JIT": "1"},
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.stderr == ""
        said.append(done.stdout)
    assert said[0] == said[1]


@pytest.mark.parametrize("first", ["serial", "parallel"])
def test_a_leg_and_an_arm_of_its_name_do_not_overwrite_each_other(
    first: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Neither way round; the message names the robot whose leg it is, and its file."""
    monkeypatch.chdir(tmp_path)
    Path("arm.yaml").write_text(SERIAL, encoding="utf-8")
    Path("robot.yaml").write_text(
        (ROBOTS / f"{NAME}.yaml").read_text(encoding="utf-8"), encoding="utf-8"
    )
    files, out = {"serial": "arm.yaml", "parallel": "robot.yaml"}, Path("x")
    owner = {"serial": "five_bar_leg", "parallel": "five_bar"}[first]
    write_files(out, compile_file(read_file(Path(files.pop(first))), out=out).files)
    before = {path: path.read_bytes() for path in out.iterdir() if path.is_file()}
    (second,) = files.values()
    assert main([second, "--out", "x"]) == 2
    made_of = "arm.yaml" if first == "serial" else "robot.yaml"
    assert capsys.readouterr().err == (
        f"{second}: x/five_bar_leg.* are files of the robot '{owner}', made of {made_of}: rename "
        "one of the robots, write to another folder (--out), or remove them if they are left over\n"
    )
    assert {path: path.read_bytes() for path in out.iterdir() if path.is_file()} == before
