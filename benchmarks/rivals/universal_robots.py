"""ur-analytic-ik: hand-written C++ for the arms of Universal Robots."""

from __future__ import annotations

import os
import sys
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from benchmarks.contestant import AbsentError, Contestant, imported, timed, versioned

if TYPE_CHECKING:
    from collections.abc import Iterator

    from benchmarks.arms import Arm
    from benchmarks.contestant import Run
    from dhgen.arrays import FloatArray


def contestants(arm: Arm, _: Path) -> list[Contestant]:
    """One call."""
    if not arm.case.universal_robot:
        raise AbsentError("takes arms of Universal Robots only")
    robot = getattr(imported("ur_analytic_ik"), arm.case.universal_robot)

    def solve(T: FloatArray) -> list[FloatArray]:
        with _quiet():
            return [np.array(robot.inverse_kinematics(pose)).reshape(-1, 6) for pose in T]

    def one(T: FloatArray) -> Run:
        poses = list(T)

        def work() -> None:
            for pose in poses:
                robot.inverse_kinematics(pose)

        return timed(work)

    return [Contestant(versioned("ur-analytic-ik"), "one call from Python", solve, one)]


@contextmanager
def _quiet() -> Iterator[None]:
    """Keeps what its C++ says about solutions that it drops from the terminal."""
    sys.stdout.flush()
    kept = os.dup(1)
    with Path(os.devnull).open("w", encoding="utf-8") as nowhere:
        os.dup2(nowhere.fileno(), 1)
    try:
        yield
    finally:
        os.dup2(kept, 1)
        os.close(kept)
