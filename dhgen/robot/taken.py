"""Cells that are taken as an exact value next to their own, of which the derivation tells."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import takewhile
from typing import TYPE_CHECKING

from dhgen.robot.expression import ZERO, Expression, to_text

if TYPE_CHECKING:
    from dhgen.robot.reader import Path

LISTS = ("joints", "axes")


@dataclass(frozen=True, slots=True)
class Taken:
    """Such a cell.

    Attributes:
        place: What it is: "a of joint 2".
        text: What it says.
        exact: What it might have said.
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
    """Where a cell stands: "a of joint 2", "entry 3 of xyz of tool", "entry 1,4 of tool"."""
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
