"""Arms with passive rows: which are solved in closed form, and why others are not."""

from __future__ import annotations

import pytest

from dhgen.errors import UnsolvedError
from dhgen.kinematics.build import build_chain
from dhgen.method import Method
from dhgen.paul.derive import derive
from dhgen.robot.load import load_text

ARM = """\
name: arm
joints:
  - {{theta: q, d: 0.3, alpha: pi/2}}
  - {{theta: q, a: 0.5}}
  - {{theta: q, a: 0.5}}
  - {{{passive}, a: 0.2, alpha: pi/2}}
  - {{theta: q, d: 0.1}}
task: {task}
"""


def refused(passive: str, task: str) -> str:
    chain = build_chain(load_text(ARM.format(passive=passive, task=task), "arm.yaml"))
    with pytest.raises(UnsolvedError) as stopped:
        derive(chain)
    return str(stopped.value)


@pytest.mark.parametrize("passive", ["theta: -q2 - q3", "theta: -q2", "theta: q2"])
def test_a_row_may_follow_joints_that_are_not_its_neighbours(passive: str) -> None:
    """Sums of angles that no run of parallel axes has are written with those that it has."""
    chain = build_chain(load_text(ARM.format(passive=passive, task="pose"), "arm.yaml"))
    assert derive(chain).method is Method.CLOSED_FORM


@pytest.mark.parametrize(
    ("passive", "reason"),
    [
        ("theta: -2*q3", "the angle follows that of another joint -2 times, which makes the"),
        ("theta: -q5", "a row without q follows joints before it, and this one follows a joint"),
    ],
)
def test_rows_that_make_other_equations_are_left_to_least_squares(
    passive: str, reason: str
) -> None:
    told = refused(passive, "pose")
    assert told.startswith("the passive row 3p: ")
    assert reason in told
    assert "--numerical would give" in told
    chain = build_chain(load_text(ARM.format(passive=passive, task="pose"), "arm.yaml"))
    assert derive(chain, numerical=True).method is Method.NUMERICAL


@pytest.mark.parametrize(
    ("passive", "reason"),
    [
        ("theta: -q3/2", "the angle follows that of another joint -1/2 times, which makes the"),
        ("d: 0.1*q3", "a length that follows an angle makes the equations transcendental"),
    ],
)
def test_rows_that_whole_turns_move_are_refused_by_least_squares_too(
    passive: str, reason: str
) -> None:
    told = refused(passive, "pose")
    assert reason in told
    assert "--numerical" not in told
    chain = build_chain(load_text(ARM.format(passive=passive, task="pose"), "arm.yaml"))
    with pytest.raises(UnsolvedError, match="a whole turn of joint 3 would move the tool"):
        derive(chain, numerical=True)


def test_joints_that_may_be_given_are_advised() -> None:
    told = refused("theta: -q2 - q3", "position")
    assert "joint 4 can move without changing what the task names" in told
    assert "list it under `free`" in told
