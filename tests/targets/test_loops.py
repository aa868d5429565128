"""Long sources: lanes of poses go through branches in loops, in words shared with other lanes."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.oracle.poses import random_joints
from dhgen.runtime import c_runtime_files
from dhgen.status import HELD
from dhgen.targets.c.files import c_texts
from dhgen.verify.native import FAST_FLAGS, PORTABLE, Build
from tests.compiling import library
from tests.structures import first_of
from tests.targets.made import apart, given, made, poses_of, robot

if TYPE_CHECKING:
    from pathlib import Path

COUNT = 203  # no multiple of the lanes
IN_LANES = Build("lanes", ("-O1", "-march=native", *FAST_FLAGS))
# Long sources have lanes in loops; the others are short.
CASES = [(name, PORTABLE) for name in ("scara", "ur5", "kuka_iiwa14", "wrist_oblique")]
CASES += [(name, IN_LANES) for name in ("ur5", "kuka_iiwa14")]


def function(name: str) -> str:
    """What solves a pose in each lane."""
    text = made(name).files[f"{name}.c"]
    return text[
        text.index("dhgen_wide_mask solve_wide") : text.index("\n}", text.index("solve_wide"))
    ]


def test_only_long_sources_have_loops() -> None:
    for name in ("puma560", "kuka_kr6_r900"):
        assert "for (int i1" not in function(name)
    for name, loop in (
        ("kuka_iiwa14", "DHGEN_UNROLLED for (int i1"),
        ("rounded_twists", "    for (int i1"),
    ):
        assert loop in function(name)
        assert "    KNOWN(wide);\n" in function(name)
        assert "    KNOWN(double);\n" in made(name).files[f"{name}.c"]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "build"), first_of(CASES, count=2), ids=lambda each: getattr(each, "name", each)
)
def test_loops_give_the_rows_of_branches_written_out(
    name: str, build: Build, tmp_path: Path
) -> None:
    q = random_joints(robot(name), COUNT, seed=61)
    T = poses_of(name, q)
    T[::5, :3, 3] *= 1.3  # some of them out of reach
    found = []
    for in_loops in (False, True):
        folder = tmp_path / str(in_loops)
        folder.mkdir()
        write_files(folder, {**c_runtime_files(), **c_texts(made(name).module, in_loops=in_loops)})
        solver = library(made(name).module, folder, build)
        free = given(name, q)
        found.append(solver.batch(T, *free))
        one = [solver.ik(T[k], np.zeros(solver.dof), *given(name, q[k])) for k in range(COUNT)]
        found.append((np.stack([rows for rows, _ in one]), np.stack([kind for _, kind in one])))
    (rows, kinds), *others = found
    held = np.isin(kinds, HELD)
    assert held.sum() > COUNT
    for again, kinds_again in others:
        assert np.array_equal(kinds_again, kinds)
        assert apart(name, again[held], rows[held]).max() < 1e-9


def test_loops_in_single_precision(tmp_path: Path) -> None:
    """Nothing is promoted on the way: a conversion would be a warning, and that an error."""
    module = made("ur5").single
    assert module is not None
    write_files(tmp_path, c_texts(module, in_loops=True))
    assert "for (int i1" in (tmp_path / "ur5_f32.c").read_text(encoding="utf-8")
    library(module, tmp_path)
