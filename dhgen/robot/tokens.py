"""The words of a cell: they are checked first, so that Python's parser sees nothing surprising."""

from __future__ import annotations

import difflib
import re
from typing import TYPE_CHECKING, get_args

from dhgen.robot.names import LengthUnit
from dhgen.robot.source import Span, quoted

if TYPE_CHECKING:
    from collections.abc import Container, Mapping

MAX_LENGTH = 200
MAX_DIGITS = 30
MAX_DECIMAL_EXPONENT = 30
ALLOWED = "numbers, pi, deg, parameters, sqrt, sin, cos, + - * / ** and parentheses"

_NUMBER = r"(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][+-]?\d+)?"
_TOKEN = re.compile(
    r"(?P<space>\ +)"
    rf"|(?P<number>{_NUMBER})(?P<glued>\w*)"
    r"|(?P<name>[A-Za-z_]\w*)"
    r"|(?P<operator>\*\*|[-+*/()])",
    re.ASCII,
)
_DEGREES = re.compile(rf"(?<![\w.])({_NUMBER}\ *)\ (?=deg\b)", re.ASCII)
# What other languages read as a number.
_NOT_DECIMAL = re.compile(
    r"0(?:x[\da-f_]+|o[0-7_]+|b[01_]+)|[\d.e]+_[\d_e]*", re.ASCII | re.IGNORECASE
)
_LENGTHS: tuple[str, ...] = get_args(LengthUnit)
_UNIT = re.compile(rf"({_NUMBER})\ *({'|'.join((*_LENGTHS, 'rad', 'degrees?'))})\b", re.ASCII)
_FOLLOWED = re.compile(rf"(?<![\w.])({_NUMBER})\ +([A-Za-z_]\w*)", re.ASCII)
_KNOWN = frozenset({"pi", "deg", "sqrt", "sin", "cos"})
_DECIMAL_COMMA = re.compile(r"(?<=\d),(?=\d)")
_NOT_FINITE = re.compile(r"\.(?:inf|nan)\b", re.ASCII | re.IGNORECASE)  # as YAML writes them
_LOOKALIKES = {"−": "-", "–": "-", "×": "*", "·": "*", "÷": "/", "°": " deg", "π": "pi", "^": "**"}


class CellError(Exception):
    """Why a cell can't be read, with the place in its text."""

    def __init__(self, message: str, span: Span) -> None:
        super().__init__(message)
        self.message = message
        self.span = span


class UnknownNameError(CellError):
    """A name that is no parameter so far."""

    def __init__(self, name: str, message: str, span: Span) -> None:
        super().__init__(message, span)
        self.name = name


def check_tokens(text: str, names: Container[str] = ()) -> None:
    """Refuse every text that is not made of numbers, names and operators.

    Args:
        text: A cell as written.
        names: The names that may occur; what is none of them may be meant as a unit.

    Raises:
        CellError: At the first place that is none of them, or a number out of all proportion.
    """
    if len(text) > MAX_LENGTH:
        raise CellError(f"a cell has at most {MAX_LENGTH} characters", Span(0, MAX_LENGTH))
    if not text.strip(" "):
        raise CellError("an empty cell: write 0", Span(0))
    position = 0
    while position < len(text):
        match = _TOKEN.match(text, position)
        if match is None:
            raise _stray(text, position)
        number, glued = match["number"], match["glued"]
        if (unit := _UNIT.match(text, position)) and unit[2] not in names:
            raise CellError(_unit_message(*unit.groups()), Span(position, len(unit[0])))
        if glued:
            raise _glued(number, glued, position)
        if number:
            _check_number(number, position)
        position = match.end()


def multiply_degrees(text: str) -> str:
    """`10 deg` as `10*deg`: the space becomes the sign, so that every column keeps its number."""
    return _DEGREES.sub(r"\1*", text)


def no_unit(text: str, names: Container[str]) -> CellError | None:
    """The mistake of a text in which a word follows a number as a unit does, and is none.

    Args:
        text: A cell as written.
        names: The names that may occur: before these an operator is missing.
    """
    for found in _FOLLOWED.finditer(text):
        number, word = found.groups()
        if word in names or word in _KNOWN:
            continue
        span = Span(found.start(2), len(word))
        close = difflib.get_close_matches(word.lower(), ("deg", "degree", "grad"), n=1, cutoff=0.5)
        meant = (
            f": degrees are written '{number} deg'"
            if close
            else ": a number stands alone, or before deg"
        )
        return CellError(f"{quoted(word)} is no unit{meant}", span)
    return None


def circle_through(own: str, name: str, texts: Mapping[str, str]) -> tuple[str, ...]:
    """The shortest way from a name through the texts that define names back to it.

    Args:
        own: The name that is defined.
        name: One in its text.
        texts: What every name is defined as.

    Returns:
        The names on the way, `own` and `name` first; none where there is no way back.
    """
    ways: list[tuple[str, ...]] = [(own, name)]
    seen = {name}
    for way in ways:
        words = _names(texts[way[-1]])
        if own in words:
            return way
        further = [word for word in dict.fromkeys(words) if word in texts and word not in seen]
        seen.update(further)
        ways += [(*way, word) for word in further]
    return ()


def _names(text: str) -> list[str]:
    """The names in a text, as far as a cell may go on."""
    return [match["name"] for match in _TOKEN.finditer(text[:MAX_LENGTH]) if match["name"]]


def _unit_message(number: str, unit: str) -> str:
    if unit.startswith("deg"):
        return f"the unit of degrees is deg: write '{number} deg'"
    write = f"a cell takes no unit: write '{number}', and for all"
    if unit == "rad":
        return f"{write} angles 'units: {{angle: rad}}', which is the default"
    return f"{write} lengths of the file 'units: {{length: {unit}}}'"


def _glued(number: str, glued: str, position: int) -> CellError:
    word = number + glued
    if glued == "deg":
        hint = f"write '{number} deg'"
    elif _NOT_DECIMAL.fullmatch(word):
        hint = "numbers are decimal, without underscores"
    else:
        hint = "write * between factors"
    return CellError(f"{quoted(word)} is not a number; {hint}", Span(position, len(word)))


def _stray(text: str, position: int) -> CellError:
    if endless := _NOT_FINITE.match(text, position):
        return CellError(f"{quoted(endless[0])} is not a finite number", Span(position, 4))
    character = text[position]
    meant = "." if _DECIMAL_COMMA.match(text, position) else _LOOKALIKES.get(character)
    hint = f"write '{meant}'" if meant else f"allowed are {ALLOWED}"
    message = f"{quoted(character)} (U+{ord(character):04X}) is not allowed in a cell: {hint}"
    return CellError(message, Span(position))


def _check_number(number: str, position: int) -> None:
    span = Span(position, len(number))
    mantissa, _, exponent = number.lower().partition("e")
    if len(mantissa) > MAX_DIGITS:
        raise CellError(f"a number has at most {MAX_DIGITS} digits", span)
    if len(exponent) > 4 or (exponent and abs(int(exponent)) > MAX_DECIMAL_EXPONENT):
        bounds = f"from -{MAX_DECIMAL_EXPONENT} to {MAX_DECIMAL_EXPONENT}"
        raise CellError(f"a decimal exponent must be a whole number {bounds}", span)
    if re.match(r"0\d", mantissa) and mantissa.isdigit() and not exponent:
        raise CellError("a number can't start with 0", span)
