"""What a program does besides its formulas does not depend on the unit of lengths."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from dhgen.kinematics.build import build_chain
from dhgen.paul.derive import derive
from dhgen.program.lowering.lower import lower
from dhgen.robot.load import load

if TYPE_CHECKING:
    from pathlib import Path

CYLINDRICAL = """\
name: cylindrical
joints:
  - {{theta: q, d: {0}, a: 0, alpha: 0}}
  - {{theta: 0, d: q, a: 0, alpha: -pi/2}}
  - {{theta: 0, d: q, a: 0, alpha: 0}}
"""


@pytest.mark.parametrize("length", [3e-4, 0.3, 300.0, 3e5])
def test_slides_are_tried_as_far_as_the_arm_is_long(tmp_path: Path, length: float) -> None:
    """Hundreds of arm sizes away a direction is good to few digits, and rows were refined."""
    path = tmp_path / "arm.yaml"
    path.write_text(CYLINDRICAL.format(length), encoding="utf-8")
    assert lower(derive(build_chain(load(path)))).completion is None
