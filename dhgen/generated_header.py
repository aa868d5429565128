"""What files that dhgen writes hold about themselves, in their first lines."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path


SUFFIXES = (".py", ".c", ".h", ".md")
HEAD = 1000  # characters of a file that hold its origin
_SOURCE = re.compile(
    r"generated from (?:([^/]+)/)?[^/]+\.(?:ya?ml|urdf|xacro|xml|mjcf) and templates/",
    re.IGNORECASE,
)
_FILE = re.compile(r"generated from (.+?) and templates/")
_COPIED = "Part of dhgen, which puts a copy of this file beside the robots"  # helpers
_RUNTIME = ("dhgen", "dhgen_runtime")  # the folders of the runtime
_LICENCE = "SPDX-License-Identifier: MIT"  # what files of the runtime have in common
_MADE = re.compile(r"generated from .*templates/.*\. Do not edit", re.IGNORECASE)
_ROBOT = re.compile(
    r"The formulas and where they come from: (\w+)\.md(?:, of a leg of (\w+))?", re.ASCII
)


def is_generated(path: Path) -> bool:
    """Whether a file's header marks it as generated."""
    return _MADE.search(_head(path)) is not None


def is_of_dhgen(folder: Path, name: str) -> bool:
    """Whether a file of the output folder is one that dhgen wrote, in this version or an older one.

    Args:
        folder: The output folder.
        name: The path of the file in the folder.
    """
    head = _head(folder / name)
    if name.partition("/")[0] in _RUNTIME:
        return _LICENCE in head
    return _COPIED in head or _MADE.search(head) is not None


def source_folder(path: Path) -> str | None:
    """The folder of the robot file that a generated file names, if it does; None without any."""
    found = _SOURCE.search(_head(path))
    return found.group(1) or "" if found else None


def robot_of(path: Path) -> str | None:
    """The name of the robot that a solver is for, in any precision; None of other files.

    Of a leg it is that of the parallel robot.
    """
    found = _ROBOT.search(_head(path))
    return found.group(2) or found.group(1) if found else None


def source_of(path: Path) -> str | None:
    """The robot file that a generated file names, if it does."""
    found = _FILE.search(_head(path))
    return found.group(1) if found else None


def _head(path: Path) -> str:
    """The part of a generated file that names its origin, in one line."""
    head = path.read_text(encoding="utf-8", errors="replace")[:HEAD]
    return " ".join(word for word in head.split() if word != "*")
