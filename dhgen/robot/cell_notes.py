"""What is noted of cells: the parameters that they use, and exact values taken in their place."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import takewhile
from typing import TYPE_CHECKING

from dhgen.robot.expression import ZERO, Expression, Name, parts, to_text

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


LISTS = ("joints", "axes")


@dataclass(frozen=True, slots=True)
class Taken:
    """Such a cell.

    Attributes:
        place: What it is: "a of joint 2".
        text: Its text.
        exact: The exact value that was meant.
    """

    place: str
    text: str
    exact: str


def taken(path: Path, text: str, variable: str, exact: Expression) -> Taken:
    """A cell and what it is taken as; `variable` is the joint's with its sign if it holds one."""
    value = to_text(exact)
    if variable and exact == ZERO:
        value = variable
    elif variable:
        sign = "-" if value.startswith("-") else "+"
        value = f"{variable} {sign} {value.removeprefix('-')}"
    return Taken(_place(path), text, value)


def _place(path: Path) -> str:
    """The place of a cell: "a of joint 2", "entry 3 of xyz of tool", "entry 1,4 of tool"."""
    words: list[str] = []
    if path[0] in LISTS:
        words.append(f"joint {int(path[1]) + 1}")
        path = path[2:]
    while path:
        numbers = list(takewhile(lambda step: isinstance(step, int), path))
        if numbers:
            words.append(f"entry {','.join(str(int(number) + 1) for number in numbers)}")
        else:
            words.append(str(path[0]))
        path = path[len(numbers) or 1 :]
    return " of ".join(reversed(words))
