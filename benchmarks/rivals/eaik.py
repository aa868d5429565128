"""EAIK (Ostermeier et al.): geometric subproblems in C++, for arms of revolute joints."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from benchmarks.contestant import AbsentError, Contestant, imported, timed, versioned
from benchmarks.screws import screws

if TYPE_CHECKING:
    from pathlib import Path

    from benchmarks.arms import Arm
    from benchmarks.contestant import Run
    from dhgen.arrays import FloatArray


def contestants(arm: Arm, _: Path) -> list[Contestant]:
    """One call, and the batch on one thread."""
    frame = screws(arm)
    robot = imported("eaik.IK_HP").HPRobot(frame.directions, frame.offsets)
    if not robot.hasKnownDecomposition():
        raise AbsentError(f"knows no decomposition ({robot.getKinematicFamily()})")

    def solve(T: FloatArray) -> list[FloatArray]:
        return [_rows(robot.IK(pose)) for pose in frame.without_home_rotation(T)]

    def one(T: FloatArray) -> Run:
        poses = list(frame.without_home_rotation(T))

        def work() -> None:
            for pose in poses:
                robot.IK(pose)

        return timed(work)

    def batch(T: FloatArray) -> Run:
        poses = list(frame.without_home_rotation(T))
        return timed(lambda: robot.IK_batched(poses, 1))

    tool = versioned("EAIK")
    return [
        Contestant(tool, "one call from Python", solve, one),
        Contestant(tool, "batch from Python", solve, batch),
    ]


def _rows(answer: Any) -> FloatArray:  # noqa: ANN401 - EAIK's own type
    """The rows that it does not call least-squares approximations."""
    q = np.array(answer.Q, np.float64)
    exact = ~np.array(answer.is_LS, bool)
    return q[exact] if q.size else np.empty((0, 0))
