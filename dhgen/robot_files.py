"""The robot files and descriptions of a command, all of them read before any work is done.

What imports descriptions is loaded where there is one.
"""

from __future__ import annotations

import os
from dataclasses import dataclass, replace
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

from dhgen.descriptions.expand import Outside
from dhgen.descriptions.wishes import Wishes
from dhgen.errors import RobotFileError, refused
from dhgen.generated_header import SUFFIXES
from dhgen.legs.read import assemble_parallel
from dhgen.robot.assemble import assemble
from dhgen.robot.load import demand_right, is_description, load_text, read_text, source_of
from dhgen.robot.reader import read_document
from dhgen.robot.report import LEGS, Report
from dhgen.robot.robot import FLEET
from dhgen.tolerances import DOUBLE, SINGLE

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.legs.robot import ParallelRobot
    from dhgen.robot.robot import Robot


AS_USUAL, NOTHING_ELSE = Wishes(), Outside()
ENDINGS = (".yaml", ".yml")  # of the names of robot files in a folder


@dataclass(frozen=True, slots=True)
class RobotFile:
    """A robot and its robot file.

    Attributes:
        path: What was read.
        robot: What it describes.
        text: The robot file; of a description, the one that an import writes.
    """

    path: Path
    robot: Robot
    text: str = ""

    @classmethod
    def read(
        cls, path: Path, wishes: Wishes = AS_USUAL, outside: Outside = NOTHING_ELSE
    ) -> RobotFile:
        """Reads one, or imports a robot description.

        Args:
            path: The file.
            wishes: The options of an import.
            outside: What a xacro needs.

        Raises:
            RobotFileError: The file can't be read, or has mistakes.
        """
        if is_description(path):
            from dhgen.descriptions.files import read_as_robot_file  # noqa: PLC0415

            text, robot = read_as_robot_file(path, wishes, outside)
        else:
            text = read_text(path)
            robot = load_text(text, str(path))
        return cls(path, robot, text)

    @property
    def digest(self) -> str:
        """Of the text, however its lines end."""
        return _digest(self.text)

    def with_numerical(self) -> RobotFile:
        """The robot as if the file had `numerical: true`."""
        return replace(self, robot=replace(self.robot, numerical=True))

    @property
    def stems(self) -> tuple[str, ...]:
        """What the files are called that are made of it, without what follows the point."""
        precisions = (DOUBLE, SINGLE) if self.robot.float32 else (DOUBLE,)
        fleet = [FLEET] if self.robot.calibration else []
        suffixes = [*(precision.suffix for precision in precisions), *fleet]
        return tuple(self.robot.name + suffix for suffix in suffixes)

    @property
    def names(self) -> tuple[str, ...]:
        """What files are called that are made of it, but for figures and what robots share."""
        name = self.robot.name
        single = [f"{name}{SINGLE.suffix}{end}" for end in (".c", ".h")]
        fleet = [f"{name}{FLEET}{end}" for end in (".py", ".c", ".h")]
        return (
            *(name + end for end in SUFFIXES),
            *(single if self.robot.float32 else ()),
            *(fleet if self.robot.calibration else ()),
        )


@dataclass(frozen=True, slots=True)
class ParallelFile:
    """A parallel robot and its robot file.

    Attributes:
        path: What was read.
        robot: What it describes.
        text: The robot file.
    """

    path: Path
    robot: ParallelRobot
    text: str

    @property
    def digest(self) -> str:
        """Of the text, however its lines end."""
        return _digest(self.text)

    @property
    def chains(self) -> tuple[RobotFile, ...]:
        """A robot file of each kind of leg, as if it were a robot; they have the whole's text."""
        return tuple(RobotFile(self.path, chain, self.text) for chain in self.robot.chains)

    def with_numerical(self) -> ParallelFile:
        """The robot with legs that the numerical solver may take."""
        return replace(self, robot=self.robot.with_numerical())

    @property
    def stems(self) -> tuple[str, ...]:
        """What the files are called that are made of it, without what follows the point."""
        return (self.robot.name, *(chain.name for chain in self.robot.chains))

    @property
    def names(self) -> tuple[str, ...]:
        """What files are called that are made of it, but for figures and what robots share."""
        return tuple(stem + end for stem in self.stems for end in SUFFIXES)


AnyFile: TypeAlias = RobotFile | ParallelFile


def read_file(path: Path, wishes: Wishes = AS_USUAL, outside: Outside = NOTHING_ELSE) -> AnyFile:
    """A robot file, serial or parallel, or a description.

    Args:
        path: The file.
        wishes: The options of an import.
        outside: What a xacro needs.

    Raises:
        RobotFileError: The file can't be read, or has mistakes.
    """
    if is_description(path):
        return RobotFile.read(path, wishes, outside)
    text = read_text(path)
    report = Report(read_document(source_of(text, str(path))))
    if report.document.has(LEGS):
        return ParallelFile(path, demand_right(report, assemble_parallel(report)), text)
    return RobotFile(path, demand_right(report, assemble(report)), text)


def _digest(text: str) -> str:
    """The first digits of what `sha256sum` says of the file, whatever its lines end with."""
    lines = text.encode().splitlines()
    return sha256(b"".join(line + b"\n" for line in lines)).hexdigest()[:16]


@dataclass(frozen=True, slots=True)
class RobotFiles:
    """The robot files of a command.

    Attributes:
        paths: Every file once, as it was first called.
        loaded: Those that are what they should be.
        refusals: Why the others are not: mistakes, or a name that one above has.
    """

    paths: tuple[Path, ...]
    loaded: tuple[AnyFile, ...]
    refusals: tuple[RobotFileError, ...]


def load_all(paths: Iterable[Path]) -> RobotFiles:
    """Reads all files of a command.

    Names that differ in capitals only are the same to some file systems, and to the guards of the
    headers.
    """
    once = _each_once(paths)
    makers: dict[str, tuple[Path, str]] = {}
    loaded: list[AnyFile] = []
    refusals = []
    for path in once:
        try:
            file = read_file(path)
        except RobotFileError as refusal:
            refusals.append(refusal)
            continue
        taken = next((stem for stem in file.stems if stem.lower() in makers), None)
        if taken is None:
            makers |= {stem.lower(): (path, stem) for stem in file.stems}
            loaded.append(file)
        else:
            refusals.append(_name_taken(path, taken, *makers[taken.lower()]))
    return RobotFiles(once, tuple(loaded), tuple(refusals))


def led_to(path: Path) -> Path:
    """The target of a path, links followed; Path.resolve stops at circles of links."""
    return Path(os.path.realpath(path))


def _each_once(paths: Iterable[Path]) -> tuple[Path, ...]:
    first: dict[Path, Path] = {}
    for path in paths:
        first.setdefault(led_to(path), path)
    return tuple(first.values())


def _name_taken(path: Path, stem: str, other: Path, its: str) -> RobotFileError:
    """The refusal of a file whose robot would be written over another's."""
    capitals = "" if stem == its else ", which differ in capitals only"
    message = f"{other} also generates files named '{its}'{capitals}: rename one of the robots"
    return refused(path, message)
