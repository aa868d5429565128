"""Whatever a robot file and its title are called, generated files stay what they are."""

from __future__ import annotations

import ast
import subprocess
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from dhgen.atomic_write import write_files
from dhgen.check import compare
from dhgen.compiler import compile_loaded
from dhgen.robot_files import RobotFile, RobotFiles
from dhgen.verify.native import c_compiler
from tests.structures import first_of

if TYPE_CHECKING:
    from collections.abc import Mapping

ROBOT = RobotFile.read(Path(__file__).resolve().parents[2] / "robots" / "planar_rr.yaml")
STRICT = ("-std=c99", "-Wall", "-Wextra", "-Wtrigraphs", "-pedantic", "-Werror", "-fsyntax-only")
PATHS = [
    'my """arm""" old*/new/*arm.yaml',
    r"back\slash\N{x}\u12.yaml",
    "ends\\",
    'ends"',
    "two\nlines\r\f\u2028.yaml",
    "\x1b[31mred\x7f.yaml",
    "Gelenkarm größer 機器人.yaml",
    "trigraph*??//arm??/.yaml",
    "closed --> *bold* <script> `code` [a](b).yaml",
    "not utf-8 \udcff.yaml",
    "{{ name }} {% raw %} it's $HOME & 'more'.yaml",
    "/".join(("x" * 200, "y" * 200)),
]


@cache
def made(path: str = "robots/planar_rr.yaml", title: str = "an arm") -> Mapping[str, str]:
    return compile_loaded(RobotFile(Path(path), replace(ROBOT.robot, title=title))).files


def code(python: str) -> str:
    """All but the docstring of the module, and a digest of the whole text."""
    tree = ast.parse(python)
    return ast.dump(ast.Module(tree.body[1:], []))


def stays_what_it_is(files: Mapping[str, str], folder: Path) -> None:
    usual = made()
    assert code(files["planar_rr.py"]) == code(usual["planar_rr.py"])
    for name, text in files.items():
        assert text.replace("\n", "").isprintable(), name
    write_files(folder, files)
    for name in ("planar_rr.c", "planar_rr.h"):
        # the comment ends where it should: what follows is the same
        assert files[name].partition("*/\n")[2] == usual[name].partition("*/\n")[2]
    compiler = c_compiler()
    if compiler:
        command = [compiler, *STRICT, str(folder / "planar_rr.c")]
        assert subprocess.run(command, capture_output=True, check=False).stderr == b""


@pytest.mark.parametrize("path", first_of(PATHS, count=4))
def test_any_path(path: str, tmp_path: Path) -> None:
    files = made(path)
    stays_what_it_is(files, tmp_path)
    usual, written = made()["planar_rr.md"], files["planar_rr.md"]
    assert written.partition("-->")[2] == usual.partition("-->")[2]


@pytest.mark.parametrize("title", [r'""" and /* and \\', r"\* begins */ and *\ ends", "*??/"])
def test_any_title(title: str, tmp_path: Path) -> None:
    stays_what_it_is(made(title=title), tmp_path)


def test_a_command_is_told_that_can_be_typed() -> None:
    def told(path: str) -> str:
        return made(path)["planar_rr.c"].partition("Do not edit: ")[2].partition(". The")[0]

    assert told("robots/arm.yaml") == "run dhgen robots/arm.yaml"
    assert told("my arms/größer.yaml") == "run dhgen 'my arms/größer.yaml'"
    assert told("old*/arm.yaml") == "run dhgen on that file"


@pytest.mark.parametrize("folder", first_of(["old*", "a  b", 'my "arms"', "größer"], count=2))
def test_check_knows_the_folder_again(folder: str, tmp_path: Path) -> None:
    """Files that say they are made from another folder are not looked at."""
    (tmp_path / folder).mkdir()
    path, out = tmp_path / folder / "arm.yaml", tmp_path / "generated"
    path.write_text("name: planar_rr\n")
    out.mkdir()
    file = RobotFile(path, ROBOT.robot)
    files = compile_loaded(file, out=out).files
    for name, text in files.items():
        write_files(out, {name: text, name.replace("planar_rr", "left_over"): text})
    problems = compare(RobotFiles((path,), (file,), ()), out).problems
    own = sorted(name for name in files if "planar_rr" in name)
    assert {f".{name.rpartition('.')[2]}" for name in own} == {".py", ".c", ".h", ".md", ".svg"}
    for name, problem in zip(own, sorted(problems), strict=True):
        assert problem.startswith(f"{out / name.replace('planar_rr', 'left_over')}: extra file")
