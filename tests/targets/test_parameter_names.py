"""Parameters may be called like the emitted code's own things: their constants get other names."""

from __future__ import annotations

import ast
import subprocess
from typing import TYPE_CHECKING

import pytest

from dhgen.compiler import verified
from dhgen.program.regular.flatten import flatten
from dhgen.targets.c.regular import best_lanes
from dhgen.targets.module import regular_solver
from dhgen.verify.native import C_FLAGS, c_compiler
from tests.compiling import compile_file, verify_little
from tests.compiling import written as written_file
from tests.headers import VECTORS, read_before
from tests.structures import first_of

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.compiler import Compilation

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
AHEAD = """\
name: arm
parameters: {{{values}}}
joints:
  - {{theta: q, d: {0}, a: 0.4, limits: [-100 deg, 400 deg]}}
  - {{theta: q, a: {1}, limits: [-100 deg, 100 deg]}}
task: [x, y]
"""
MOUNTING = """\
base: {{xyz: [{2}, {3}, {4}]}}
tool: {{xyz: [{5}, {6}, {7}]}}
"""
WRIST = """\
name: arm
parameters: {{{values}}}
joints:
  - {{theta: q, d: 0.5, a: {0}, alpha: -90 deg, limits: [-170 deg, 190 deg]}}
  - {{theta: q, a: {1}, limits: [-130 deg, 60 deg]}}
  - {{theta: q, a: 0.05, alpha: -90 deg, limits: [-60 deg, 200 deg]}}
  - {{theta: q, d: {4}, alpha: 90 deg}}
  - {{theta: q, alpha: -90 deg}}
  - {{theta: q, d: 0.1}}
base: {{xyz: [{5}, {6}, {7}]}}
tool: {{xyz: [{2}, 0, {3}]}}
"""
# What values, constants of programs, and locals are called: a letter or word, and a number.
NUMBERED = (
    "v1 v2 v3 v4 k1 k2 k3 k4",
    "m1 m2 h1 h2 p1 x1 d1 z2",
    "h1 h2 m1 m2 packed1 ratio1 kind1 given1",
    "f1 g1 n1 f2 e1 e2 e3 x1",
    "w1 w2 w3 wx low1 high1 low2 high2",
    "high3 low3 high2 low2 angle1 angle2 angle3 z1",
    "free_limit1 doubt_limit_squared2 free_limit_squared2 doubt_limit1 none1 outside1 i1 z0",
    "doubt_limit1 doubt_limit_squared2 free_limit doubt_limit outside doubt1 doubt2 y2_x",
    "longest2 shortest2 longest3 longest3_reach half_turn turn turn1 offset1",
    "exact_slack1 pose_slack1 doubtful_slack1 near_limit boundary3 least_root1 arm_size1 boundary2",
    "nested farther own nearest inverse1 divisor1 factor1 root1",
    "sqrt2 unit r1 w2x chosen1 free1 near5 held5",
)
NAMES = (
    ("wide", "four", "HELPER", "LANES", "kind", "solve_wide", "odd", "kind_of", "pick_four"),
    ("work", "w", "v", "x0", "x1", "x2", "y2", "rest", "exact"),
    ("rest", "other", "bend", "slope", "inside", "along", "steps", "tried", "held"),
    ("given1", "given2", "kind1", "packed1", "METHOD", "ValueError", "os", "wide_at", "all_four"),
)


SOME = 8  # poses of each sort: a number that is taken for another is wrong at most of them


def robot_file(arm: str, names: tuple[str, ...], folder: Path) -> Path:
    values = ", ".join(f"{name}: 0.{place + 31}" for place, name in enumerate(names))
    path = folder / "arm.yaml"
    path.write_text(arm.format(*names, values=values), encoding="utf-8")
    return path


def written(arm: str, names: tuple[str, ...], folder: Path) -> Compilation:
    return written_file(robot_file(arm, names, folder), folder)


def stored(tree: ast.AST) -> set[str]:
    """The names that get values."""
    nodes = [node for node in ast.walk(tree) if isinstance(node, ast.Name)]
    return {node.id for node in nodes if isinstance(node.ctx, ast.Store)}


@pytest.mark.parametrize("names", NAMES, ids=lambda names: names[0])
def test_formulas_read_the_constants(names: tuple[str, ...], tmp_path: Path) -> None:
    written(SCARA, names, tmp_path)
    check_names(tmp_path)


@pytest.mark.slow
@pytest.mark.parametrize("arm", [AHEAD + MOUNTING, WRIST], ids=["ahead", "wrist"])
@pytest.mark.parametrize("words", first_of(NUMBERED))
def test_numbered_names(arm: str, words: str, tmp_path: Path) -> None:
    """Names that the programs of an arm give in passing, each to a number of the arm."""
    made = written(arm, tuple(words.split()), tmp_path)
    check_names(tmp_path)
    solver = regular_solver(made.module)
    assert solver is not None
    flats = (flatten(solver).program, best_lanes(solver).program)
    values: dict[str, set[float]] = {}
    for program in (*made.module.programs, *flats):
        for constant in program.constants:
            values.setdefault(constant.name, set()).add(constant.value)
    assert {name for name, found in values.items() if len(found) > 1} == set()


def check_names(folder: Path) -> None:
    """Python: no function hides a constant of the arm behind a local; C: it compiles."""
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
    compiler, flags = str(c_compiler()), (*C_FLAGS, "-Wshadow")
    native = *flags, "-march=native"
    for own in (flags, (*native, *read_before(compiler, VECTORS, *native))):
        command = (compiler, *own, "-fsyntax-only", "arm.c")
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
        assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.slow
@pytest.mark.parametrize(
    "names", first_of([(("low2", "high1"),), (("doubt_limit_squared2", "free_limit"),)])
)
def test_a_name_does_not_say_what_a_constant_is(
    names: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Neither the end of a limit nor a tolerance, though the files have those under such names."""
    verify_little(monkeypatch)
    monkeypatch.setattr("dhgen.verify.verify.COUNT", SOME)
    verified(compile_file(robot_file(PLANAR, names, tmp_path)))


def test_the_derivation_calls_parameters_as_the_file_does(tmp_path: Path) -> None:
    """Also those that the ring has another generator for, or that look like numbers it names."""
    names = ("wx", "r1", "u1x", "p3y")
    others = ("m1", "x0", "h2", "v3")
    text = compile_file(robot_file(WRIST, (*names, *others), tmp_path)).files["arm.md"]
    listed = [rf"$\mathit{{{name}}} = 0.{place + 31}$ m" for place, name in enumerate(names)]
    assert f"Parameters: {', '.join(listed)}, " in text
    assert all(rf"\mathit{{{name}}} " in text for name in names)
    assert not any(other in text for other in (r"wx\_", r"r1\_", "u_{1x}", "p_{3y}"))


@pytest.mark.breadth
def test_a_prime_tells_parameters_from_letters_of_the_formulas(tmp_path: Path) -> None:
    names = ("X", "Y", "Z", "K", "POS", "E", "J", "D")
    text = compile_file(robot_file(WRIST, names, tmp_path)).files["arm.md"]
    listed = [rf"$\mathit{{{name}}}' = 0.{place + 31}$ m" for place, name in enumerate(names)]
    assert f"Parameters: {', '.join(listed[:2])}, " in text
    assert "A prime distinguishes a parameter from the other meaning of its name." in text
    assert "with $X = w_x$, $Y = -w_y$" in text
    plain = compile_file(robot_file(WRIST, ("X1", *"abgmnop"), tmp_path)).files["arm.md"]
    assert "A prime" not in plain
    assert r"\mathit{X1}" in plain
