"""Small words: numbers, plurals, enumerations."""

from __future__ import annotations

_NUMBERS = (
    "no",
    "one",
    "two",
    "three",
    "four",
    "five",
    "six",
    "seven",
    "eight",
    "nine",
    "ten",
    "eleven",
    "twelve",
)


def numeral(count: int) -> str:
    """A number in words as far as people write it so."""
    return _NUMBERS[count] if count < len(_NUMBERS) else str(count)


def counted(count: int, noun: str) -> str:
    """two joints, one joint."""
    return f"{numeral(count)} {noun}{'' if count == 1 else 's'}"


def joined(items: list[str]) -> str:
    """1; 1 and 2; 1, 2 and 4."""
    return " and ".join([*([", ".join(items[:-1])] if items[1:] else []), items[-1]])


def many(noun: str, items: list[str]) -> str:
    """joint 3; joints 1 and 2; joints 1, 2 and 4."""
    return f"{noun}{'s' if items[1:] else ''} {joined(items)}"
