"""Five joints asked for a whole pose: the formula of the books stands before what protects it."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from tests.targets.made import poses_of, robot

GENERATED = Path(__file__).resolve().parents[3] / "generated"
ARMS = ("bartell_rprpr", "katana_400", "kuka_youbot", "scorbot_pointing", "xarm5")
SAID = re.compile(r"theta1, type 2: U1\[\d, \d\], so theta1 = atan2\((-?T\d\d), (-?T\d\d)\)")
EXACT = 1e-9


@pytest.mark.parametrize("ending", [".c", ".py"])
@pytest.mark.parametrize("name", ARMS)
def test_the_first_joint_by_the_first_equation_alone(name: str, ending: str) -> None:
    """Of poses that the arm takes theta_1 is the formula's, or half a turn from it."""
    text = (GENERATED / f"{name}{ending}").read_text(encoding="utf-8")
    said = SAID.search(text)
    assert said is not None
    assert said.start() < text.index("sigma1 = ")
    q = np.random.default_rng(3).uniform(-1.0, 1.0, (20, 5))
    poses = poses_of(name, q)
    y, x = (
        (-1.0 if each[0] == "-" else 1.0) * poses[:, int(each[-2]) - 1, int(each[-1]) - 1]
        for each in said.groups()
    )
    joint = build_chain(robot(name)).joints[0]
    theta = joint.sign * q[:, 0] + joint.offset
    assert np.abs(np.sin(np.arctan2(y, x) - theta)).max() < EXACT
