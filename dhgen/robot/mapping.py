"""A dict with the keys of a robot file: the robot file of it, whose remarks name keys."""

from __future__ import annotations

import bisect
import json
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from dhgen.errors import Diagnostic, RobotFileError
from dhgen.robot.load import load_source
from dhgen.robot.names import YAML_WORDS
from dhgen.robot.reader import MAX_DEPTH
from dhgen.robot.source import SourceText, Span, quoted, shortened

if TYPE_CHECKING:
    from dhgen.robot.robot import Robot

NAME = "dict"  # what remarks call the dict as a whole
_PLAIN = re.compile(r"-?[A-Za-z0-9(](?:[\w .+*/()-]*[\w)])?", re.ASCII)


@dataclass(frozen=True, slots=True)
class KeyedText(SourceText):
    """The text of a robot file that was a dict: remarks have keys in the place of lines.

    Attributes:
        places: Where values start in the text, ascending, and what their keys are called.
    """

    places: tuple[tuple[int, str], ...] = ()

    def point(self, span: Span, message: str) -> Diagnostic:
        """A remark with the keys that lead to a place."""
        if span == Span(0):  # the whole begins where its first key does, which is longer
            return Diagnostic(self.file, 0, 0, message)
        last = bisect.bisect_right(self.places, span.start, key=lambda place: place[0])
        return Diagnostic(self.places[last - 1][1], 0, 0, message)


def load_mapping(mapping: Mapping[str, Any]) -> tuple[str, Robot]:
    """The robot file of a dict with its keys, and the robot that it describes.

    Args:
        mapping: Texts, numbers, True, False and None, in lists and dicts; NumPy's, too.

    Raises:
        RobotFileError: The dict describes no robot: all its mistakes at once, each at its keys.
    """
    source = keyed_text(mapping)
    return source.text, load_source(source)


def keyed_text(mapping: Mapping[str, Any]) -> KeyedText:
    """The robot file of a dict.

    Raises:
        RobotFileError: It holds what no robot file can.
    """
    writer = _Writer()
    writer.document(mapping)
    if writer.mistakes:
        raise RobotFileError(tuple(writer.mistakes))
    source = SourceText.of("".join(writer.parts), NAME)
    return KeyedText(NAME, source.text, source.lines, source.starts, tuple(writer.places))


class _Writer:
    """Writes values as YAML, joints and axes a line each, and notes where each one starts."""

    def __init__(self) -> None:
        self.parts: list[str] = []
        self.places: list[tuple[int, str]] = []
        self.mistakes: list[Diagnostic] = []
        self._length = 0

    def document(self, mapping: Mapping[str, Any]) -> None:
        if not mapping:
            self._write("{}\n")
        for key, value in mapping.items():
            self._at((key,))
            self._write(self._key(key, ()) + ":")
            plain = _plain(value)
            if key in {"joints", "axes"} and isinstance(plain, list) and plain:
                for number, row in enumerate(plain):
                    self._write("\n  - ")
                    self._value(row, (key, number))
            else:
                self._write(" ")
                self._value(plain, (key,))
            self._write("\n")

    def _value(self, value: object, path: tuple[object, ...]) -> None:
        self._at(path)
        plain = _plain(value)
        if len(path) > MAX_DEPTH:
            self._mistake(path[:1], f"nested more than {MAX_DEPTH} deep")
        elif isinstance(plain, Mapping):
            self._write("{")
            finite = {key: each for key, each in plain.items() if not _is_endless(key, each)}
            for count, (key, each) in enumerate(finite.items()):
                self._write(", " if count else "")
                self._at((*path, key))
                self._write(f"{self._key(key, path)}: ")
                self._value(each, (*path, key))
            self._write("}")
        elif isinstance(plain, list):
            self._write("[")
            for number, each in enumerate(plain):
                self._write(", " if number else "")
                self._value(each, (*path, number))
            self._write("]")
        else:
            self._write(self._scalar(plain, path))

    def _key(self, key: object, path: tuple[object, ...]) -> str:
        if isinstance(key, str):
            return _text(key)
        self._mistake(path, f"a key is a text, not {_shown(key)}")
        return "key"

    def _scalar(self, value: object, path: tuple[object, ...]) -> str:
        match value:
            case None:
                return "null"
            case bool():
                return "true" if value else "false"
            case int() | float():
                return repr(value)
            case str():
                return _text(value)
        message = f"expected a number, a text, a list or a dict, not {_shown(value)}"
        self._mistake(path, message)
        return "null"

    def _at(self, path: tuple[object, ...]) -> None:
        self.places.append((self._length, _label(path)))

    def _write(self, text: str) -> None:
        self.parts.append(text)
        self._length += len(text)

    def _mistake(self, path: tuple[object, ...], message: str) -> None:
        remark = Diagnostic(_label(path), 0, 0, message)
        if remark not in self.mistakes:
            self.mistakes.append(remark)


def _plain(value: object) -> object:
    """A value without what NumPy puts around it; a tuple as a list."""
    if isinstance(value, str):  # NumPy's texts are texts
        return str(value)
    inner = value.tolist() if hasattr(value, "tolist") else value
    return list(inner) if isinstance(inner, tuple) else inner


def _is_endless(key: object, value: object) -> bool:
    """Whether a joint's limits are both infinite, as `joint_limits` gives missing ones."""
    ends = _plain(value)
    return key == "limits" and ends in ([-math.inf, math.inf], (-math.inf, math.inf))


def _text(text: str) -> str:
    if _PLAIN.fullmatch(text) and text.lower() not in YAML_WORDS:
        return text
    return json.dumps(text, ensure_ascii=False)


def _shown(value: object) -> str:
    return f"{type(value).__name__} {quoted(repr(value))}"


def _label(path: tuple[object, ...]) -> str:
    """How a remark calls a place: joints[0].theta, counted from 0 as Python does."""
    steps = (f"[{step}]" if isinstance(step, int) else f".{shortened(str(step))}" for step in path)
    return "".join(steps).removeprefix(".") or NAME
