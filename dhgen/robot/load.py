"""A robot file to a Robot: the first stage of the compiler."""

from __future__ import annotations

import codecs
import os
import re
import shlex
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from dhgen.errors import RobotFileError, refused
from dhgen.robot.assemble import assemble
from dhgen.robot.reader import MAX_BYTES, read_document
from dhgen.robot.report import Report
from dhgen.robot.source import SourceText, Span

if TYPE_CHECKING:
    from dhgen.robot.robot import Robot

AnyRobot = TypeVar("AnyRobot")

DESCRIPTIONS = (".urdf", ".xacro", ".mjcf")  # of names; any other file is looked into
HEAD = 4096  # bytes in which a file shows what it is
_XML = re.compile(r"\ufeff?\s*<[?!A-Za-z]")
_KINDS_OF_XML = {
    "<xacro:": "a xacro",
    "<robot": "a URDF",
    "<sdf": "an SDF",
    "<mujoco": "an MJCF",
}
_UTF_16 = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
_BINARY = re.compile(rb"[\x00-\x08\x0e-\x1f]")  # what no text in any 8-bit encoding has


def load(path: str | os.PathLike[str]) -> Robot:
    """Read a robot file.

    Args:
        path: Where it is; messages show it as given.

    Raises:
        RobotFileError: The file can't be read, or describes no robot: all its mistakes at once.
    """
    return load_text(read_text(path), os.fspath(path))


def read_text(path: str | os.PathLike[str]) -> str:
    """The text of a file that may be a robot file.

    Raises:
        RobotFileError: The file can't be read, or is no text.
    """
    name = os.fspath(path)
    try:
        with Path(path).open("rb") as file:
            content = file.read(MAX_BYTES + 1)
    except IsADirectoryError:
        files = f"{shlex.quote(str(Path(path)))}/*.yaml"
        raise refused(name, f"this is a folder; name the files in it: {files}") from None
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise refused(name, f"the file can't be read: {reason}") from None
    if what := kind_of_xml(content):
        raise refused(name, f"this is {what}; a robot file is YAML")
    if len(content) > MAX_BYTES:
        raise refused(name, f"a robot file has at most {MAX_BYTES // 1024} KiB")
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError as error:
        raise _no_utf8(content, name, error.start) from None


def load_text(text: str, file_name: str) -> Robot:
    """Read a robot file's text.

    Args:
        text: The YAML.
        file_name: What messages call it.

    Raises:
        RobotFileError: The text describes no robot: all its mistakes at once.
    """
    return load_source(source_of(text, file_name))


def source_of(text: str, file_name: str) -> SourceText:
    """A file's text, without the mark that some editors begin it with."""
    return SourceText.of(text.removeprefix("\ufeff"), file_name)


def load_source(source: SourceText) -> Robot:
    """Read a robot file from a text with the names of its places.

    Raises:
        RobotFileError: The text describes no robot: all its mistakes at once.
    """
    report = Report(read_document(source))
    return demand_right(report, assemble(report))


def demand_right(report: Report, robot: AnyRobot | None) -> AnyRobot:
    """A robot that was read.

    Raises:
        RobotFileError: There were mistakes: all of them.
    """
    if report.errors or robot is None:
        raise RobotFileError(report.errors, report.notes_on_errors)
    return robot


def kind_of_xml(content: bytes) -> str | None:
    """What a file is that begins like XML; None of any other."""
    text = content.decode("utf-16" if content.startswith(_UTF_16) else "utf-8", "replace")
    if not _XML.match(text):
        return None
    return next((kind for mark, kind in _KINDS_OF_XML.items() if mark in text), "XML")


def is_description(path: Path) -> bool:
    """Whether a file is a robot description rather than a robot file; False of none."""
    if path.suffix.lower() in DESCRIPTIONS:
        return True
    try:
        with path.open("rb") as file:
            return kind_of_xml(file.read(HEAD)) is not None
    except (OSError, ValueError):  # what no file can be called is a ValueError
        return False


def _no_utf8(content: bytes, name: str, start: int) -> RobotFileError:
    """What is raised for a file that is not UTF-8 from some byte on; a text shows the place."""
    if content.startswith(_UTF_16):
        return refused(name, "the file is UTF-16: save it as UTF-8")
    if _BINARY.search(content):
        return refused(name, "this is not text; a robot file is YAML")
    source = SourceText.of(content.decode("utf-8", "replace"), name)
    place = Span(len(content[:start].decode("utf-8")))
    return source.refused(place, "the file is not UTF-8: save it as UTF-8")
