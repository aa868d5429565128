"""The exceptions of dhgen, with one way to point into a file."""

from __future__ import annotations

from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One remark about one place of a robot file.

    Attributes:
        file: The path as the user gave it.
        line: Line number, from 1 (0 when the remark is about the whole file).
        column: Column number, from 1.
        message: What is wrong and, where there is a choice, what would be right.
        source: The text of the line, without its line end.
        width: How many characters the caret underlines.
    """

    file: str
    line: int
    column: int
    message: str
    source: str = ""
    width: int = 1

    def __str__(self) -> str:
        """`file:line:col: message`, then the line with a caret under the place."""
        if self.line == 0:
            return f"{self.file}: {self.message}"
        head = f"{self.file}:{self.line}:{self.column}: {self.message}"
        if not self.source.strip():
            return head
        caret = " " * (self.column - 1) + "^" * max(1, self.width)
        return f"{head}\n    {self.source}\n    {caret}"


class DhgenError(Exception):
    """Anything that dhgen refuses, with a text meant for its user.

    Attributes:
        exit_code: 2 for a mistake in a file, 1 for what dhgen cannot do.
    """

    exit_code = 1


class RobotFileError(DhgenError):
    """A robot file that can't be read: every mistake in it, in the order of the file.

    Attributes:
        diagnostics: The mistakes.
        notes: Remarks on the values that they are about.
    """

    exit_code = 2

    def __init__(
        self, diagnostics: tuple[Diagnostic, ...], notes: tuple[Diagnostic, ...] = ()
    ) -> None:
        self.diagnostics = diagnostics
        self.notes = notes
        super().__init__(diagnostics, notes)  # what it is made of again in another process

    def __str__(self) -> str:
        """All remarks, each with its place; notes after the mistakes."""
        notes = (f"note: {note}" for note in self.notes)
        return "\n".join((*map(str, self.diagnostics), *notes))


def refused(file: Path | str, message: str) -> RobotFileError:
    """What is raised for a file as a whole, without a place in it."""
    return RobotFileError((Diagnostic(str(file), 0, 0, message),))


class CommandError(DhgenError):
    """A mistake on the command line that only the file system shows."""

    exit_code = 2


class UnsolvedError(DhgenError):
    """No order of equations solves the robot; the message names which way failed where."""


class PrecisionError(DhgenError):
    """An arm that cannot be solved in the precision that its file asks for."""


class CompilerError(DhgenError):
    """The C compiler can't build anything: a fault of what is installed."""


class ImmobileError(DhgenError):
    """Legs that can't move their platform: a mistake in the file that no count of joints shows."""

    exit_code = 2


class VerificationError(DhgenError):
    """The written files do not do what they promise: a fault of the compiler, never the user's."""


@contextmanager
def about(file: Path) -> Iterator[None]:
    """Puts a file's name before a message on the arm in it."""
    try:
        yield
    except (UnsolvedError, PrecisionError, ImmobileError) as error:
        raise type(error)(f"{file}: {error}") from error
