"""The example of a derivation: rows and limits are as the C gives them, whole turns and all."""

from __future__ import annotations

import math
import shutil
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.parallel.compile import ParallelCompilation, compile_file
from dhgen.parallel.native import compiled
from dhgen.parallel.printing import parallel_derivation_as
from dhgen.parallel.worked import example_of
from dhgen.robot_files import read_file
from dhgen.status import Status

if TYPE_CHECKING:
    from pathlib import Path

THREE_LEGS = """\
name: three_legs
legs:
- base: {xyz: [0.5, 0.1, 0]}
  joints: [{theta: q + 15 deg, a: 0.3, limits: [100 deg, 400 deg]}, {theta: q, a: 0.36}]
  actuated: [1]
  point: [0.12, 0.03, 0]
- base: {xyz: [-0.2, 0.45, 0]}
  joints: [{theta: -q, a: 0.33}, {theta: q, a: 0.31}]
  actuated: [1]
  point: [-0.1, 0.09, 0]
- base: {xyz: [-0.25, -0.4, 0]}
  joints: [{theta: q, a: 0.28}, {theta: -q, a: 0.4, limits: [-170 deg, -10 deg]}]
  actuated: [2]
  point: [-0.04, -0.11, 0]
task: [x, y, yaw]
"""
BEYOND_HALF_A_TURN = """\
name: beyond
legs:
- joints: [{theta: q, a: 0.3, limits: [200 deg, 500 deg]}, {theta: q, a: 0.3}]
  base: {xyz: [0, 0, 0]}
  actuated: [1]
  point: [0, 0, 0]
- joints: [{theta: q, a: 0.3}, {theta: q, a: 0.3}]
  base: {xyz: [0.3, 0, 0]}
  actuated: [1]
  point: [0, 0, 0]
task: [x, y]
"""


@pytest.mark.skipif(not shutil.which("gcc"), reason="no gcc")
@pytest.mark.parametrize("text", [THREE_LEGS, BEYOND_HALF_A_TURN], ids=["three legs", "beyond"])
def test_rows_are_turned_and_judged_as_the_c_does(text: str, tmp_path: Path) -> None:
    """Of both robots some row of leg 1 is within limits by a whole turn alone."""
    path = tmp_path / "robot.yaml"
    path.write_text(text, encoding="utf-8")
    compilation = compile_file(read_file(path))
    assert isinstance(compilation, ParallelCompilation)
    write_files(tmp_path, compilation.files)
    native = compiled(compilation.module, tmp_path, ("-O1",))
    example = example_of(compilation.module)
    assert native is not None
    assert example is not None
    _, q, status = native.ik(example.T)
    np.testing.assert_allclose(example.rows, q, rtol=0, atol=1e-9)
    np.testing.assert_array_equal(example.inside, status == Status.OK)
    assert example.rows[0, example.inside[0], 0].max() > math.pi
    assert len(example.assemblies)
    document, figures = parallel_derivation_as("markdown", compilation.module)
    assert "\n## An example\n" in document
    assert "\nThese drives allow " in document
    assert len(figures) == 1
