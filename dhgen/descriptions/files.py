"""Files of robot descriptions: which of them are, and what is in them."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from dhgen.descriptions.convert import convert
from dhgen.descriptions.expand import argument_notes, expanded, has_expressions, has_macros
from dhgen.descriptions.markup import MAX_BYTES, read_xml
from dhgen.descriptions.mjcf import read_mjcf
from dhgen.descriptions.urdf import read_urdf
from dhgen.errors import Diagnostic, RobotFileError, refused
from dhgen.robot.load import kind_of_xml

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.descriptions.convert import Import
    from dhgen.descriptions.expand import Outside
    from dhgen.descriptions.model import Description
    from dhgen.descriptions.wishes import Wishes
    from dhgen.robot.robot import Robot


def read_description(path: Path, outside: Outside) -> Description:
    """The robot of a description file.

    Args:
        path: URDF, or what becomes one: xacro, MJCF.
        outside: What a xacro needs.

    Raises:
        RobotFileError: The file can't be read, or has mistakes.
    """
    try:
        with path.open("rb") as file:
            content = file.read(MAX_BYTES + 1)
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise refused(path, f"the file can't be read: {reason}") from None
    kind = kind_of_xml(content)
    if kind == "an SDF":
        raise refused(path, "this is an SDF, which is not read: convert it to URDF first")
    if kind is None:
        raise refused(path, "this is no robot description: a URDF begins with <robot>")
    notes = argument_notes(outside.arguments)
    if kind == "an MJCF":
        return replace(read_mjcf(path), notes=notes)
    read_xml(content, str(path))  # what could harm is refused before anything else looks at it
    if not has_macros(content):
        try:
            return replace(read_urdf(content, str(path)), notes=notes)
        except RobotFileError:
            if not has_expressions(content):
                raise
    content, notes = expanded(path, outside)
    return replace(read_urdf(content, f"{path} (expanded)", "xacro"), notes=notes)


def import_file(path: Path, wishes: Wishes, outside: Outside) -> Import:
    """The robot file of a description file.

    Raises:
        RobotFileError: The file can't be read, has mistakes, or leaves the choice of an arm.
    """
    return convert(read_description(path, outside), wishes)


def read_as_robot_file(path: Path, wishes: Wishes, outside: Outside) -> tuple[str, Robot]:
    """The robot file that an import would write, and its robot; notes are about the description.

    Raises:
        RobotFileError: The file can't be read, has mistakes, or leaves the choice of an arm.
    """
    imported = import_file(path, wishes, outside)
    notices = tuple(Diagnostic(str(path), 0, 0, note) for note in imported.notes)
    return imported.text, replace(imported.robot, notices=notices)
