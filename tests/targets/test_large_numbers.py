"""The same arm with its lengths in micrometres: what is next to nothing is so in arm sizes."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import numpy as np
import pytest

from tests.compiling import library, written
from tests.targets.calling import HELD, gap
from tests.targets.made import ROBOTS

if TYPE_CHECKING:
    from pathlib import Path

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files


@pytest.mark.breadth
def test_a_stretched_arm_beside_a_straight_wrist_is_not_out_of_reach(tmp_path: Path) -> None:
    text = (ROBOTS / "ur5.yaml").read_text(encoding="utf-8").replace("name: ur5", "name: ur5um")
    large = re.sub(r"(\b[ad]\d: -?)([\d.]+)", lambda m: f"{m[1]}{round(float(m[2]) * 1e6)}", text)
    assert "a2: -425000," in large
    path = tmp_path / "ur5um.yaml"
    path.write_text(f"{large}units: {{length: um}}\n", encoding="utf-8")
    solver = library(written(path, tmp_path).module, tmp_path)
    for q in np.random.default_rng(4).uniform(-1.5, 1.5, (300, 6)):
        q[2], q[4] = 0.0, 3e-4
        rows, status = solver.ik(solver.fk(q), q)
        assert gap(rows[np.isin(status, HELD)], q).min() < 1e-3
