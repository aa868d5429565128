"""Short robot files for tests, and what loading them says."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from dhgen.errors import RobotFileError
from dhgen.robot.load import load_text
from dhgen.robot.robot import DhRow

if TYPE_CHECKING:
    from dhgen.errors import Diagnostic
    from dhgen.robot.robot import Robot

JOINTS = "joints:\n  - {theta: q}\n"
MINIMAL = f"name: r\n{JOINTS}"


def table(*rows: str, **sections: str) -> str:
    """A file with these rows (what stands between the braces) and further sections."""
    head = "".join(f"{key}: {value}\n" for key, value in sections.items())
    return f"name: r\n{head}joints:\n" + "".join(f"  - {{{row}}}\n" for row in rows)


def axes(*entries: str, **sections: str) -> str:
    """A file with these axes and further sections."""
    head = "".join(f"{key}: {value}\n" for key, value in sections.items())
    return f"name: r\n{head}axes:\n" + "".join(f"  - {{{entry}}}\n" for entry in entries)


def robot(text: str) -> Robot:
    return load_text(text, "r.yaml")


def row(text: str, **sections: str) -> DhRow:
    """The only row of a robot that has this one."""
    (joint,) = robot(table(text, **sections)).joints
    assert isinstance(joint, DhRow)
    return joint


def mistakes(text: str) -> tuple[Diagnostic, ...]:
    """What the file is refused for."""
    with pytest.raises(RobotFileError) as info:
        load_text(text, "r.yaml")
    return info.value.diagnostics


def mistake(text: str) -> str:
    """The only mistake's message."""
    (diagnostic,) = mistakes(text)
    return diagnostic.message


def marked(diagnostic: Diagnostic) -> str:
    """The text above the caret."""
    start = diagnostic.column - 1
    return diagnostic.source[start : start + diagnostic.width]


def told_of_cells(text: str) -> list[str]:
    """The messages about a file, in which not every cell that is tried uses the parameters."""
    messages = [notice.message for notice in robot(text).notices]
    return [message for message in messages if not message.startswith("no cell uses")]
