"""Which parameters of a file its cells use, to tell of those that none does."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.robot.expression import Expression, Name, parts

if TYPE_CHECKING:
    from dhgen.robot.reader import Path


class UsedNames:
    """The names in the cells that have been read."""

    def __init__(self) -> None:
        self._arm: set[str] = set()
        self._of: dict[str, set[str]] = {}

    def note(self, path: Path, expression: Expression) -> None:
        """A cell has been read."""
        if path[0] == "parameters":
            self._of[str(path[1])] = names(expression)
        else:
            self._arm |= names(expression)

    def unused(self) -> tuple[str, ...]:
        """The parameters that no cell of the arm uses, not even by way of others."""
        used: set[str] = set()
        pending = sorted(self._arm)
        while pending:
            name = pending.pop()
            if name not in used:
                used.add(name)
                pending += self._of.get(name, ())
        return tuple(name for name in self._of if name not in used)


def names(expression: Expression) -> set[str]:
    """The names that occur."""
    return {part.name for part in parts(expression) if isinstance(part, Name)}
