"""Other people's solvers, called as their authors recommend, from what pip installs."""

from __future__ import annotations

from typing import TYPE_CHECKING

from benchmarks.contestant import Absentee, AbsentError
from benchmarks.rivals import eaik, opw, ssik, toolbox, universal_robots

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from benchmarks.arms import Arm
    from benchmarks.contestant import Contestant

RIVALS: dict[str, Callable[[Arm, Path], list[Contestant]]] = {
    "EAIK": eaik.contestants,
    "ssik": ssik.contestants,
    "Robotics Toolbox": toolbox.contestants,
    "py-opw-kinematics": opw.contestants,
    "ur-analytic-ik": universal_robots.contestants,
}


def rivals(arm: Arm, folder: Path) -> tuple[list[Contestant], list[Absentee]]:
    """All who can solve an arm, and why the others can't.

    Args:
        arm: The arm.
        folder: Where they may write.
    """
    present, absent = [], []
    for tool, enter in RIVALS.items():
        try:
            present += enter(arm, folder)
        except AbsentError as error:
            absent.append(Absentee(tool, str(error)))
        except Exception as error:  # noqa: BLE001 - whatever it is, the run goes on and says so
            absent.append(Absentee(tool, f"{type(error).__name__}: {error}"))
    return present, absent
