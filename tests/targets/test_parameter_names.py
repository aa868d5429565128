"""Parameters may be called like the emitted code's own things: their constants get other names."""

from __future__ import annotations

import ast
import subprocess
from typing import TYPE_CHECKING

import pytest

from dhgen.compiler import compile_robot, verified
from dhgen.verify.native import C_FLAGS, c_compiler

if TYPE_CHECKING:
    from pathlib import Path

SCARA = """\
name: arm
convention: standard
parameters: {{{values}}}
joints:
  - {{theta: q, d: {0}, a: {1}, limits: [-2, 2]}}
  - {{theta: q, d: {2}, a: {3}, limits: [-2, 2]}}
  - {{theta: 0, d: q, a: {4}, limits: [-0.2, 0]}}
  - {{theta: q}}
base: {{xyz: [{5}, {6}, {7}]}}
tool: {{xyz: [{8}, 0, 0]}}
"""
PLANAR = """\
name: arm
parameters: {{{values}}}
joints:
  - {{theta: q, a: {0}, limits: [-100 deg, 400 deg]}}
  - {{theta: q, a: {1}}}
task: [x, y]
"""
NAMES = (
    ("wide", "four", "HELPER", "LANES", "kind", "solve_wide", "odd", "kind_of", "pick_four"),
    ("work", "w", "v", "x0", "x1", "x2", "y2", "rest", "exact"),
    ("rest", "other", "bend", "slope", "inside", "along", "steps", "tried", "held"),
    ("given1", "given2", "kind1", "packed1", "METHOD", "ValueError", "os", "wide_at", "all_four"),
)


def robot_file(arm: str, names: tuple[str, ...], folder: Path) -> Path:
    values = ", ".join(f"{name}: 0.{place + 31}" for place, name in enumerate(names))
    path = folder / "arm.yaml"
    path.write_text(arm.format(*names, values=values), encoding="utf-8")
    return path


def written(names: tuple[str, ...], folder: Path) -> Path:
    path = robot_file(SCARA, names, folder)
    for file, text in compile_robot(path).files.items():
        (folder / file).write_text(text, encoding="utf-8")
    return folder


def stored(tree: ast.AST) -> set[str]:
    """The names that get values."""
    nodes = [node for node in ast.walk(tree) if isinstance(node, ast.Name)]
    return {node.id for node in nodes if isinstance(node.ctx, ast.Store)}


@pytest.mark.parametrize("names", NAMES, ids=lambda names: names[0])
def test_formulas_read_the_constants(names: tuple[str, ...], tmp_path: Path) -> None:
    """Python: no function hides a constant of the arm behind a local; C: it compiles."""
    folder = written(names, tmp_path)
    module = ast.parse((folder / "arm.py").read_text(encoding="utf-8"))
    assigned = [node for node in module.body if isinstance(node, ast.Assign)]
    tops = [each for node in assigned for target in node.targets for each in stored(target)]
    assert len(tops) == len(set(tops))
    numbers = {
        each
        for node in assigned
        if isinstance(node.value, ast.Constant)
        for target in node.targets
        for each in stored(target)
    }
    for node in module.body:
        if isinstance(node, ast.FunctionDef):
            assert not (stored(node) | {each.arg for each in node.args.args}) & numbers, node.name
    for machine in ((), ("-march=native",)):
        command = (str(c_compiler()), *C_FLAGS, "-Wshadow", *machine, "-fsyntax-only", "arm.c")
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("names", [("low2", "high1"), ("doubt_limit_squared2", "free_limit")])
def test_a_name_does_not_say_what_a_constant_is(names: tuple[str, ...], tmp_path: Path) -> None:
    """Neither the end of a limit nor a tolerance, though the files have those under such names."""
    verified(compile_robot(robot_file(PLANAR, names, tmp_path)))
