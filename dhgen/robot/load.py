"""A robot file to a Robot: the first stage of the compiler."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from dhgen.errors import Diagnostic, RobotFileError
from dhgen.robot.assemble import assemble
from dhgen.robot.reader import MAX_CHARACTERS, read_document
from dhgen.robot.report import Report

if TYPE_CHECKING:
    from dhgen.robot.robot import Robot


def load(path: str | os.PathLike[str]) -> Robot:
    """Read a robot file.

    Args:
        path: Where it is; messages show it as given.

    Raises:
        RobotFileError: The file can't be read, or describes no robot: all its mistakes at once.
    """
    name = os.fspath(path)
    try:
        with Path(path).open("rb") as file:
            content = file.read(4 * MAX_CHARACTERS + 1)
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        message = f"line {line} is not UTF-8: save the file in that encoding"
        raise RobotFileError((Diagnostic(name, 0, 0, message),)) from None
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        message = f"the file can't be read: {reason}"
        raise RobotFileError((Diagnostic(name, 0, 0, message),)) from None
    return load_text(text, name)


def load_text(text: str, file_name: str) -> Robot:
    """Read a robot file's text.

    Args:
        text: The YAML.
        file_name: What messages call it.

    Raises:
        RobotFileError: The text describes no robot: all its mistakes at once.
    """
    report = Report(read_document(text, file_name))
    robot = assemble(report)
    if report.errors or robot is None:
        raise RobotFileError(report.errors)
    return robot
