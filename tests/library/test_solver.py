"""A solver that was built: its functions, what is behind them, how it travels."""

from __future__ import annotations

import pickle
from typing import TYPE_CHECKING

import numpy as np
import pytest

import dhgen
from dhgen.compiler import compile_loaded
from dhgen.robot_files import RobotFile

if TYPE_CHECKING:
    from pathlib import Path

Q = np.array([0.3, 1.1])


def test_it_solves_what_the_arm_reaches(solver: dhgen.Solver, arm: dhgen.Arm) -> None:
    T = arm.fk(Q)
    np.testing.assert_allclose(solver.fk(Q), T, atol=1e-15)
    np.testing.assert_allclose(solver.jacobian(Q), arm.jacobian(Q), atol=1e-15)
    q, status = solver.ik_all(T)
    assert (status == solver.OK).all()
    np.testing.assert_allclose(arm.fk(q)[:, :2, 3], [T[:2, 3]] * 2, atol=1e-15)
    assert np.abs(q - Q).max(axis=1).min() < 1e-14
    np.testing.assert_allclose(solver.ik(T, q_seed=Q), Q, atol=1e-14)
    rows, statuses = solver.ik_batch(np.array([T, T]))
    np.testing.assert_allclose(rows, [q, q], atol=1e-14)
    assert statuses.shape == (2, 2)


def test_its_constants_are_those_of_the_module(solver: dhgen.Solver) -> None:
    assert solver.NAME == "two_links"
    assert solver.METHOD == "closed form"
    assert (solver.DOF, solver.JOINT_TYPES, solver.MAX_SOLUTIONS) == (2, "RR", 2)
    assert solver.arm.joint_names == solver.JOINT_NAMES
    assert pytest.approx(np.array(solver.arm.joint_limits)) == solver.JOINT_LIMITS
    assert len(solver.BRANCHES) == 2
    assert solver.arm_angle is None
    assert repr(solver) == "<dhgen.Solver of two_links: RR, closed form, 2 rows, by C>"


def test_c_is_behind_it_unless_python_is_asked_for(solver: dhgen.Solver, arm: dhgen.Arm) -> None:
    plain = arm.build(native=False)
    assert (solver.backend, plain.backend) == ("C", "plain Python")  # numba is off in these tests
    T = arm.fk(Q)
    np.testing.assert_allclose(plain.ik_all(T)[0], solver.ik_all(T)[0], atol=1e-14)


def test_without_a_compiler_it_is_python(
    solver: dhgen.Solver, arm: dhgen.Arm, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    assert solver.backend == "C"
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("CC", raising=False)
    assert arm.build().backend == "plain Python"


def test_a_broken_compiler_is_told_with_a_way_out(
    solver: dhgen.Solver, arm: dhgen.Arm, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert solver.folder.is_dir()
    monkeypatch.setenv("CC", "false")
    with pytest.raises(dhgen.CompilerError, match=r"without C: build\(native=False\)"):
        arm.build()


def test_progress_is_told_once_and_by_default_to_nobody_who_does_not_wait(
    solver: dhgen.Solver, arm: dhgen.Arm, told: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert solver.folder.is_dir()
    assert told == ["building the solver of two_links, once; deriving", "verifying"]
    arm.build(progress=told.append)
    assert len(told) == 2
    assert capsys.readouterr() == ("", "")


def test_out_of_reach_is_an_exception_with_the_reason(solver: dhgen.Solver) -> None:
    far = np.eye(4)
    far[0, 3] = 9.0
    with pytest.raises(solver.Unreachable, match="out of reach") as error:
        solver.ik(far)
    assert isinstance(error.value, ValueError)
    assert type(pickle.loads(pickle.dumps(error.value))) is solver.Unreachable  # noqa: S301


def test_it_can_be_pickled(solver: dhgen.Solver, arm: dhgen.Arm) -> None:
    again = pickle.loads(pickle.dumps(solver))  # noqa: S301
    assert (again.folder, again.backend, again.arm) == (solver.folder, solver.backend, arm)
    ik_all = pickle.loads(pickle.dumps(again.ik_all))  # noqa: S301
    np.testing.assert_array_equal(ik_all(arm.fk(Q))[0], solver.ik_all(arm.fk(Q))[0])


def test_its_files_are_those_that_the_command_writes(
    solver: dhgen.Solver, arm: dhgen.Arm, tmp_path: Path
) -> None:
    (tmp_path / "two_links.yaml").write_text(arm.text, encoding="utf-8")
    file = RobotFile.read(tmp_path / "two_links.yaml")
    files = compile_loaded(file, out=tmp_path / "generated").files
    for name, text in files.items():
        assert (solver.folder / name).read_text("utf-8") == text, name
    assert arm.derivation() == files["two_links.md"]
    assert arm.derivation().figures.items() <= files.items()
    assert len(arm.derivation().figures) == 3
