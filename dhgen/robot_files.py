"""The robot files of a command, all of them read before any work is done."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.errors import Diagnostic, RobotFileError
from dhgen.robot.load import load

if TYPE_CHECKING:
    from collections.abc import Iterable
    from pathlib import Path

    from dhgen.robot.robot import Robot


@dataclass(frozen=True, slots=True)
class RobotFile:
    """A robot and where it was read."""

    path: Path
    robot: Robot

    @classmethod
    def read(cls, path: Path) -> RobotFile:
        """Reads one; RobotFileError where it has mistakes."""
        return cls(path, load(path))


def load_all(paths: Iterable[Path]) -> tuple[tuple[RobotFile, ...], tuple[RobotFileError, ...]]:
    """The robots of files, and why others are refused: mistakes, or a name that one above has."""
    loaded: dict[str, RobotFile] = {}
    refusals = []
    for path in each_once(paths):
        try:
            file = RobotFile.read(path)
        except RobotFileError as refusal:
            refusals.append(refusal)
            continue
        first = loaded.setdefault(file.robot.name, file)
        if first is not file:
            refusals.append(same_name(path, first.path))
    return tuple(loaded.values()), tuple(refusals)


def each_once(paths: Iterable[Path]) -> tuple[Path, ...]:
    """Every file once, as it was first called."""
    first: dict[Path, Path] = {}
    for path in paths:
        first.setdefault(path.resolve(), path)
    return tuple(first.values())


def same_name(path: Path, other: Path) -> RobotFileError:
    """The refusal of a file whose robot would be written over another's."""
    message = f"{other} has a robot of the same name: give one of them another"
    return RobotFileError((Diagnostic(str(path), 0, 0, message),))
