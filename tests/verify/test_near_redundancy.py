"""What is said of files that fail where the arm itself is at fault: it is singular everywhere."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from dhgen.errors import VerificationError
from dhgen.kinematics.build import build_chain
from dhgen.paul.refusal.redundancy import near_redundancy
from dhgen.robot.load import load
from dhgen.verify.verify import verify
from tests.general.files import without_derivation
from tests.robots.cases import robot

if TYPE_CHECKING:
    from pathlib import Path

# Both slides would be parallel.
SLIDES = """
name: arm
joints:
  - {theta: q, a: -0.25, alpha: -1.5708}
  - {theta: pi/2, d: q, a: 0.249, alpha: TWIST}
  - {theta: q, d: 0.18, a: -0.25, alpha: TWIST}
  - {theta: pi/2, d: q, a: -0.25, alpha: 1.5708}
  - {theta: q, a: 0.3}
  - {theta: q, d: -0.25, alpha: 1.571}
"""


def test_a_failure_says_that_joints_nearly_move_without_the_tool(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "arm.yaml").write_text(SLIDES.replace("TWIST", "3.1416"), encoding="utf-8")
    module = without_derivation(load(tmp_path / "arm.yaml"))

    def fails(*_: object) -> None:
        raise VerificationError("no row holds a solution")

    monkeypatch.setattr("dhgen.verify.verify._verify", fails)
    said = "no row holds a solution\nwherever the arm is, joints 2, 4 can move together"
    with pytest.raises(VerificationError, match=said):
        verify(module, tmp_path)


@pytest.mark.parametrize("twist", ["pi", "3.1"])
def test_it_is_not_said_of_arms_that_are_so_in_earnest_or_not_at_all(
    tmp_path: Path, twist: str
) -> None:
    (tmp_path / "arm.yaml").write_text(SLIDES.replace("TWIST", twist), encoding="utf-8")
    assert not near_redundancy(build_chain(load(tmp_path / "arm.yaml")))


@pytest.mark.parametrize("name", ["puma560_calibrated", "kinova_gen3_7", "scara"])
def test_it_is_not_said_of_robots(name: str) -> None:
    assert not near_redundancy(build_chain(robot(name)))
