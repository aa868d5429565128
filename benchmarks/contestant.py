"""What is compared: a solver, called in one of the ways it offers."""

from __future__ import annotations

import importlib
import time
from dataclasses import dataclass
from importlib import metadata
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.arrays import FloatArray

    # how often poses are solved -> CPU seconds it took
    Run = Callable[[int], float]
    # poses (N, 4, 4) -> joint values (rows, n) for each, in the conventions of the robot file
    Solve = Callable[[FloatArray], list[FloatArray]]


class AbsentError(Exception):
    """A solver takes no part; the text says why."""


@dataclass(frozen=True, slots=True)
class Contestant:
    """A solver of one arm.

    Attributes:
        tool: What people call it, with its version.
        way: How it is called.
        solve: All solutions of poses, whatever that costs: for checking.
        prepare: Takes poses to what solves them and tells the time; conversions of conventions
            and copies happen here, unmeasured.
        ours: Whether dhgen made it.
    """

    tool: str
    way: str
    solve: Solve
    prepare: Callable[[FloatArray], Run]
    ours: bool = False

    @property
    def label(self) -> str:
        """Tool and way."""
        return f"{self.tool}, {self.way}"


@dataclass(frozen=True, slots=True)
class Absentee:
    """A solver that takes no part with an arm.

    Attributes:
        tool: What people call it.
        why: The reason.
    """

    tool: str
    why: str


def timed(work: Callable[[], object]) -> Run:
    """Tells how much CPU time of this process some Python takes, done over and over."""

    def run(repeats: int) -> float:
        start = time.process_time()
        for _ in range(repeats):
            work()
        return time.process_time() - start

    return run


def imported(module: str) -> Any:  # noqa: ANN401 - a module of somebody else
    """A module that may not be installed.

    Raises:
        AbsentError: It can't be imported.
    """
    try:
        return importlib.import_module(module)
    except Exception as error:
        raise AbsentError(f"{type(error).__name__}: {error}") from error


def versioned(distribution: str) -> str:
    """A distribution's name with its version, if it is installed."""
    try:
        return f"{distribution} {metadata.version(distribution)}"
    except metadata.PackageNotFoundError:
        return distribution
