"""The driver in C calls what it should, as often as it should."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from benchmarks.arms import CASES, read_arm
from benchmarks.contestant import AbsentError
from benchmarks.native import NATIVE, Interface, compiled
from benchmarks.solvers import solvers
from dhgen.verify.native import c_compiler

if TYPE_CHECKING:
    from pathlib import Path

pytestmark = pytest.mark.skipif(c_compiler() is None, reason="there is no C compiler")

COUNTING = """
double calls = 0;
static int solve(const double *T, double *q)
{
    calls += 1;
    q[0] = T[0];
    q[1] = T[15];
    return 1;
}
double bench_calls(void);
double bench_calls(void) { return calls; }
"""


@pytest.fixture
def empty(tmp_path: Path) -> Path:
    source = tmp_path / "empty.c"
    source.write_text("typedef int nothing;\n", encoding="utf-8")
    return source


def test_every_pose_is_solved_each_time(empty: Path, tmp_path: Path) -> None:
    native = compiled(empty, Interface(COUNTING, rows=2, dof=2), NATIVE, tmp_path)
    T = np.arange(48.0).reshape(3, 4, 4)
    rows = native.solve(T)
    assert [each.tolist() for each in rows] == [[[0, 15]], [[16, 31]], [[32, 47]]]
    assert native.prepare(T)(5) >= 0.0
    native.library.bench_calls.restype = type(native.library.bench_time.restype(0))
    assert native.library.bench_calls() == 3 + 5 * 3


def test_what_does_not_compile_is_told(tmp_path: Path) -> None:
    source = tmp_path / "broken.c"
    source.write_text("int broken(void) { return nothing; }\n", encoding="utf-8")
    with pytest.raises(AbsentError, match="nothing"):
        compiled(source, Interface(COUNTING, rows=1, dof=2), NATIVE, tmp_path)


@pytest.mark.breadth
def test_our_solvers_give_back_the_joints(tmp_path: Path) -> None:
    arm = read_arm(next(case for case in CASES if case.name == "scara"))
    T = arm.random_poses(5)
    present, _ = solvers(arm, tmp_path)
    assert {"C, one pose", "C, batch", "Python, ik_into"} <= {each.way for each in present}
    for contestant in present:
        for rows, target in zip(contestant.solve(T), T, strict=True):
            assert len(rows) == 2, contestant.way
            np.testing.assert_allclose(arm.model.pose(rows), [target] * 2, atol=1e-12)
