"""py-opw-kinematics: the hand-written solver for ortho-parallel arms with a spherical wrist.

M. Brandstoetter, A. Angerer, M. Hofbaur, An analytical solution of the inverse kinematics problem
of industrial serial manipulators with an ortho-parallel basis and a spherical wrist, 2014.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from benchmarks.contestant import AbsentError, Contestant, imported, timed, versioned
from benchmarks.screws import screws

if TYPE_CHECKING:
    from pathlib import Path

    from benchmarks.arms import Arm
    from benchmarks.contestant import Run
    from benchmarks.screws import Screws
    from dhgen.arrays import FloatArray

AXES = np.array([[0, 0, 1], [0, 1, 0], [0, 1, 0], [0, 0, 1], [0, 1, 0], [0, 0, 1]])  # upright


def contestants(arm: Arm, _: Path) -> list[Contestant]:
    """One call, and `reach`, which gives all branches of many poses with their margins."""
    if arm.case.upright is None:
        raise AbsentError("takes ortho-parallel arms with a spherical wrist only")
    frame = screws(arm, arm.case.upright)
    robot = _robot(frame)
    signs = np.sum(frame.directions * AXES, axis=1).round()
    pose_type = imported("scipy.spatial.transform").RigidTransform

    def poses(T: FloatArray) -> Any:  # noqa: ANN401 - a type of SciPy
        return pose_type.from_matrix(frame.without_home_rotation(T))

    def solve(T: FloatArray) -> list[FloatArray]:
        rows = (np.array(robot.inverse(pose)).reshape(-1, 6) for pose in poses(T))
        return [signs * each + np.array(arm.case.upright) for each in rows]

    def one(T: FloatArray) -> Run:
        prepared = list(poses(T))

        def work() -> None:
            for pose in prepared:
                robot.inverse(pose)

        return timed(work)

    def batch(T: FloatArray) -> Run:
        prepared = poses(T)
        return timed(lambda: robot.reach(prepared))

    tool = versioned("py-opw-kinematics")
    return [
        Contestant(tool, "one call from Python", solve, one),
        Contestant(tool, "batch from Python", solve, batch),
    ]


def _robot(frame: Screws) -> Any:  # noqa: ANN401 - a type of the package
    """The arm by the parameters of the paper, read off where it stands upright."""
    package = imported("py_opw_kinematics")
    _, shoulder, elbow, _, wrist, _ = frame.points
    tool = frame.home[:3, 3]
    model = package.KinematicModel(
        a1=shoulder[0],
        a2=wrist[0] - elbow[0],
        b=wrist[1],
        c1=shoulder[2],
        c2=elbow[2] - shoulder[2],
        c3=wrist[2] - elbow[2],
        c4=tool[2] - wrist[2],
    )
    return package.Robot(model, degrees=False)
