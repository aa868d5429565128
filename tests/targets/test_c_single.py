"""C in single precision: every token that means a double means a float."""

from __future__ import annotations

import ctypes
import re
import subprocess
from typing import TYPE_CHECKING

import numba
import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.check import compare
from dhgen.compiler import verified
from dhgen.errors import PrecisionError, VerificationError
from dhgen.kinematics.numeric import numeric_arm
from dhgen.robot_files import load_all
from dhgen.status import Status
from dhgen.targets.c.single_precision import in_single_precision
from dhgen.tolerances import SINGLE
from dhgen.verify.native import c_compiler
from dhgen.verify.single import RESIDUAL, verify_single
from tests.compiling import compile_file, library, solvers_of, written
from tests.structures import first_of
from tests.targets.made import ROBOTS, made, robot_path

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.targets.module import SolverModule

SCARA = "scara"


@pytest.mark.parametrize(
    ("double", "single"),
    [
        ("double a = 0.6718299999999999;", "float a = 0.67183f;"),
        ("x * 1e-12 + 2.0 - .5", "x * 1e-12f + 2.0f - 0.5f"),
        ("fabs(atan2(y, x)) <= sqrt(x)", "fabsf(atan2f(y, x)) <= sqrtf(x)"),
        ("q[0] + T[16 * k], 0x1f, 7u", "q[0] + T[16 * k], 0x1f, 7u"),
        ("/* double 1.0, sin */ 'x'", "/* double 1.0, sin */ 'x'"),
        ('"double 1.0"', '"double 1.0"'),
        ('#include "x_double_1.0.h"\ndouble', '#include "x_double_1.0.h"\nfloat'),
        ("-HUGE_VAL, NAN, INFINITY", "-HUGE_VALF, NAN, INFINITY"),
        ("sine, cos2, adouble, x1.y", "sine, cos2, adouble, x1.y"),
    ],
)
def test_tokens(double: str, single: str) -> None:
    assert in_single_precision(double) == single


@pytest.mark.parametrize("text", ["1e39", "1e-60"])
def test_what_a_float_cannot_hold_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match="single precision"):
        in_single_precision(f"double a = {text};")


def test_literals_are_the_nearest_floats() -> None:
    text = in_single_precision("3.141592653589793 0.1 16777217.0 1.1754943508222875e-38")
    values = [float(each) for each in re.findall(r"(\S+)f", text)]
    doubles = (np.pi, 0.1, 16777217.0, 1.1754943508222875e-38)
    assert [np.float32(each) for each in values] == [np.float32(each) for each in doubles]


def module_of(name: str) -> SolverModule:
    single = made(name).single
    assert single is not None
    return single


def test_nothing_is_left_of_double_precision() -> None:
    for name, text in made(SCARA).files.items():
        if name.startswith(f"{SCARA}{SINGLE.suffix}"):
            code = re.sub(r'/\*.*?\*/|"[^"]*"', "", text, flags=re.DOTALL)
            assert not re.search(r"\bdouble\b", code)
            assert not re.search(r"\b\d+\.\d+(e-?\d+)?\b(?!f)", code)


@pytest.mark.skipif(c_compiler() is None, reason="there is no C compiler")
@pytest.mark.parametrize("level", first_of(["-O0", "-O3"]))
def test_nothing_is_promoted_and_nothing_loses_digits(level: str, tmp_path: Path) -> None:
    flags = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"]
    more = ["-Wdouble-promotion", "-Wfloat-conversion"]
    for name in (SCARA, "puma560", "ur5"):
        write_files(tmp_path, made(name).files)
        source = tmp_path / f"{name}{SINGLE.suffix}.c"
        command = [str(c_compiler()), *flags, *more, level, "-c", str(source), "-o", "/dev/null"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.skipif(c_compiler() is None, reason="there is no C compiler")
@pytest.mark.parametrize(
    ("right", "wrong", "complaint"),
    [
        ("= 0.4f,", "= 0.4001f,", "fk is off"),
        ("    kind[0] = ", "    q[0] += 0.001f; kind[0] = ", "a row's pose is off"),
        ("fit(T);\n    if (!(miss <= DHGEN_ROUNDED))", "fit(T);\n    if (isnan(miss))", "accepted"),
    ],
)
def test_sabotage_is_seen(right: str, wrong: str, complaint: str, tmp_path: Path) -> None:
    write_files(tmp_path, made(SCARA).files)
    source = tmp_path / f"{SCARA}{SINGLE.suffix}.c"
    text = source.read_text(encoding="utf-8")
    assert right in text
    source.write_text(text.replace(right, wrong, 1), encoding="utf-8")
    with pytest.raises(VerificationError, match=complaint):
        verify_single(module_of(SCARA), tmp_path)


@pytest.mark.breadth
def test_verification_reports_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(numba.config, "DISABLE_JIT", True)
    monkeypatch.setattr("dhgen.verify.verify.COUNT", 20)
    report = verified(made(SCARA))
    assert report.single is None or 1e-9 < report.single < 1e-5


HOLLOW_WRIST = """
name: hollow_wrist
joints:
  - {theta: q, d: 0.8, a: 0.3, alpha: -pi/2}
  - {theta: q, a: 1.2}
  - {theta: q, a: 0.1, alpha: -pi/2}
  - {theta: q, d: 1.3, alpha: 60 deg}
  - {theta: q, alpha: -60 deg}
  - {theta: q, d: 0.13}
float32: true
"""


@pytest.mark.breadth
@pytest.mark.skipif(c_compiler() is None, reason="there is no C compiler")
def test_the_edge_of_a_hollow_wrist_is_reached(tmp_path: Path) -> None:
    """Where the wrist tilts the tool as far as it can, rounding puts poses out of its reach."""
    path = tmp_path / "hollow_wrist.yaml"
    path.write_text(HOLLOW_WRIST, encoding="utf-8")
    compilation = written(path, tmp_path)
    assert compilation.single is not None
    name, solver = compilation.single.name, library(compilation.single, tmp_path)
    q = np.random.default_rng(1).uniform(-1.4, 1.4, (20000, 6))
    q[:, 4] = np.pi
    arm = numeric_arm(compilation.module.chain)
    T = np.asarray(arm.pose(q), np.float32)
    rows, status = np.empty((len(q), 8, 6), np.float32), np.empty((len(q), 8), np.uint8)
    pointers = (ctypes.c_void_p(array.ctypes.data) for array in (T, rows, status))
    solver.library[f"{name}_ik_batch"](ctypes.c_size_t(len(q)), *pointers)
    held = np.isin(status, (Status.OK, Status.FREE_JOINT))
    assert held.any(axis=1).all()
    poses, _ = np.nonzero(held)
    assert np.abs(arm.pose(rows[held].astype(float)) - T[poses]).max() < RESIDUAL


@pytest.mark.parametrize("name", ["cuspidal_3r", "general_6r"])
def test_roots_of_polynomials_are_refused(name: str, tmp_path: Path) -> None:
    source = robot_path(name)
    path = tmp_path / f"{name}.yaml"
    path.write_text(source.read_text(encoding="utf-8") + "float32: true\n", encoding="utf-8")
    with pytest.raises(PrecisionError, match="closed form"):
        solvers_of(path)


def test_without_asking_there_is_none(tmp_path: Path) -> None:
    path = tmp_path / f"{SCARA}.yaml"
    text = (ROBOTS / path.name).read_text(encoding="utf-8")
    path.write_text(re.sub(r"float32:.*\n", "", text), encoding="utf-8")
    compilation = solvers_of(path)
    assert compilation.single is None
    assert [name for name in compilation.files if SINGLE.suffix in name] == []


@pytest.mark.breadth
def test_files_that_are_no_longer_asked_for_are_found(tmp_path: Path) -> None:
    """Checking one robot says nothing of its neighbours' files, but of its own."""
    own, other = ROBOTS / "scara.yaml", ROBOTS / "ur5.yaml"
    write_files(tmp_path, {**compile_file(own).files, **solvers_of(other).files})
    assert compare(load_all([own]), tmp_path).exit_code == 0
    copies = tmp_path / "robots"
    copies.mkdir()
    for path in (own, other):
        (copies / path.name).write_text(path.read_text(encoding="utf-8"), encoding="utf-8")
    copy = copies / "scara.yaml"
    copy.write_text(re.sub(r"float32:.*\n", "", copy.read_text(encoding="utf-8")), encoding="utf-8")
    extra = [line for line in compare(load_all([copy]), tmp_path).problems if "extra file" in line]
    assert len(extra) == 2
    assert all(SINGLE.suffix in line for line in extra)
