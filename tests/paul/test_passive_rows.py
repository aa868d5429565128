"""Arms with passive rows that are not solved, and why."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from dhgen.compiler import compile_loaded
from dhgen.errors import UnsolvedError
from dhgen.kinematics.build import build_chain
from dhgen.paul.derive import derive
from dhgen.robot.load import load_text
from dhgen.robot_files import RobotFile

if TYPE_CHECKING:
    from pathlib import Path

ARM = """\
name: arm
joints:
  - {{theta: q, d: 0.3, alpha: pi/2}}
  - {{theta: q, a: 0.5}}
  - {{theta: q, a: 0.5}}
  - {{theta: {passive}, a: 0.2, alpha: {twist}}}
  - {{theta: q, d: 0.1}}
task: {task}
"""


def refused(passive: str, task: str, twist: str = "pi/2", *, numerical: bool = False) -> str:
    chain = build_chain(load_text(ARM.format(passive=passive, task=task, twist=twist), "arm.yaml"))
    with pytest.raises(UnsolvedError) as stopped:
        derive(chain, numerical=numerical)
    return str(stopped.value)


def test_angles_that_are_no_sums_of_neighbours_are_named() -> None:
    told = refused("-q2", "pose")
    assert told.startswith("the passive rows leave the angle -theta2 + theta3 in the equations")


def test_a_hand_that_turns_back_leaves_a_plain_arm(tmp_path: Path) -> None:
    """Whose rows least squares would have to refine where poses are checked."""
    path = tmp_path / "arm.yaml"
    path.write_text(ARM.format(passive="-q2 - q3", task="pose", twist="pi/2"), encoding="utf-8")
    file = RobotFile.read(path)
    assert derive(build_chain(file.robot)).branches == 4
    with pytest.raises(UnsolvedError, match="refined by least squares, which do not take passive"):
        compile_loaded(file)


@pytest.mark.parametrize("numerical", [False, True])
def test_nothing_is_advised_that_such_arms_can_not_have(numerical: bool) -> None:  # noqa: FBT001
    told = refused("-q2 - q3", "position", numerical=numerical)
    assert "under `free`" not in told
    assert "--numerical" not in told
    if numerical:
        assert told == "the numerical solver does not take passive rows (those without q)"
    else:
        assert "joint 4 can move without changing what the task names" in told
