"""Calibration files: origins of joints as in drivers of Universal Robots, or deltas of a table.

kinematics:                                   deltas:
  shoulder: {x: 0, y: 0, z: 0.1625,             - {theta: 1e-4, d: 0, a: 2e-5, alpha: -3e-4}
             roll: 0, pitch: 0, yaw: 0}         - {theta: 0.01 deg, alpha: 2e-4, beta: 1e-4}
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ruamel.yaml.nodes import MappingNode, ScalarNode, SequenceNode

from dhgen.errors import RobotFileError
from dhgen.robot.arithmetic import nearest, parse
from dhgen.robot.expression import DEGREE, evaluate, parts
from dhgen.robot.load import read_text, source_of
from dhgen.robot.nodes import span_of
from dhgen.robot.reader import read_document
from dhgen.robot.source import quoted
from dhgen.robot.tokens import CellError

if TYPE_CHECKING:
    from pathlib import Path

    from ruamel.yaml.nodes import Node

    from dhgen.robot.reader import Document

ORIGINS, DELTAS = "kinematics", "deltas"
PLACES = ("x", "y", "z", "roll", "pitch", "yaw")
CELLS = ("theta", "d", "a", "alpha", "beta")
ANGLES = frozenset({"roll", "pitch", "yaw", "theta", "alpha", "beta"})
OTHERS = ("hash",)  # keys besides the origins
# Universal Robots' names of the links whose origins these are, from base to tool.
LINKS = ("shoulder", "upper_arm", "forearm", "wrist_1", "wrist_2", "wrist_3")


@dataclass(frozen=True, slots=True)
class Calibration:
    """What was measured of an arm.

    Attributes:
        file: Where it is from.
        is_deltas: Whether rows are added to those of the robot file; else they are origins.
        rows: Of each joint, x, y, z [m] and roll, pitch, yaw [rad] of its frame in the one before;
            or what is added to theta, d, a, alpha of its row, and beta, a turn about y (S. Hayati
            and M. Mirmirani, 1985): behind all four, but between a and theta where the convention
            is modified, Rx(alpha) Tx(a) Ry(beta) Rz(theta) Tz(d).
        words: What the file calls itself; empty where it doesn't.
    """

    file: str
    is_deltas: bool
    rows: tuple[tuple[float, ...], ...]
    words: str = ""


def read_calibration(path: Path) -> Calibration:
    """Reads a calibration file.

    Raises:
        RobotFileError: It can't be read, or is none: all mistakes at once.
    """
    return _Reader(read_document(source_of(read_text(path), str(path)))).run()


class _Reader:
    """One file, its mistakes gathered."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self._mistakes = list(document.mistakes)

    def run(self) -> Calibration:
        document = self._document
        if document.has(ORIGINS) == document.has(DELTAS):
            if document.has(DELTAS):
                message = f"a calibration holds {ORIGINS} or {DELTAS}, not both"
                raise document.source.refused(span_of(document.root), message)
            wanted = f"a calibration holds {ORIGINS}: (of each joint x, y, z, roll, pitch, yaw) or "
            message = f"{wanted}{DELTAS}: (a list, of each row {', '.join(CELLS)})"
            raise document.source.refused(span_of(document.root), message)
        for name, (key, _) in document.pairs[id(document.root)].items():
            if name not in (ORIGINS, DELTAS):
                message = f"no key of a calibration is called {quoted(name)}: convention and units"
                self._complain(key, f"{message} are those of the robot file; {ORIGINS} are in m")
        is_deltas = document.has(DELTAS)
        node = document.find((DELTAS if is_deltas else ORIGINS,))[1]
        rows = self._deltas(node) if is_deltas else self._origins(node)
        words = self._words(node)
        if self._mistakes:
            raise RobotFileError(tuple(sorted(self._mistakes, key=lambda m: (m.line, m.column))))
        return Calibration(document.source.file, is_deltas, tuple(rows), words)

    def _words(self, node: Node) -> str:
        if not isinstance(node, MappingNode) or "hash" not in self._document.pairs[id(node)]:
            return ""
        value = self._document.pairs[id(node)]["hash"][1]
        return str(value.value) if isinstance(value, ScalarNode) else ""

    def _origins(self, node: Node) -> list[tuple[float, ...]]:
        if not isinstance(node, MappingNode):
            self._complain(node, f"{ORIGINS} holds a line for each joint, from base to tool")
            return []
        pairs = self._document.pairs[id(node)]
        names = [name for name in pairs if name not in OTHERS]
        if any(name in LINKS for name in names):
            for name in names:
                if name not in LINKS:
                    message = f"no link is called {quoted(name)}{nearest(name, LINKS)}"
                    self._complain(pairs[name][0], message)
            if missing := [name for name in LINKS if name not in names]:
                self._complain(node, f"{', '.join(missing)} missing")
            names = [name for name in LINKS if name in names]
        return [self._row(pairs[name][1], PLACES, PLACES) for name in names]

    def _deltas(self, node: Node) -> list[tuple[float, ...]]:
        if not isinstance(node, SequenceNode):
            self._complain(node, f"{DELTAS} is a list with a row for each joint")
            return []
        return [self._row(row, CELLS, ()) for row in node.value]

    def _row(
        self, node: Node, names: tuple[str, ...], needed: tuple[str, ...]
    ) -> tuple[float, ...]:
        """The numbers of a row; numbers left out are zero."""
        if not isinstance(node, MappingNode):
            self._complain(node, f"expected {{{', '.join(f'{name}: 0' for name in names)}}}")
            return ()
        pairs = self._document.pairs[id(node)]
        for name, (key, _) in pairs.items():
            if name not in names:
                hint = nearest(name, names) or f": there are {', '.join(names)}"
                self._complain(key, f"no key is called {quoted(name)}{hint}")
        missing = [name for name in needed if name not in pairs]
        if missing:
            self._complain(node, f"{', '.join(missing)} missing")
        return tuple(
            self._number(pairs[name][1], is_angle=name in ANGLES) if name in pairs else 0.0
            for name in names
        )

    def _number(self, node: Node, *, is_angle: bool) -> float:
        """A cell's value, as robot files have them: arithmetic, angles in rad or with deg."""
        if not isinstance(node, ScalarNode):
            self._complain(node, "expected a number")
            return math.nan
        try:
            expression = parse(str(node.value), {})
        except CellError as error:
            self._complain(node, f"expected a number: {error.message}")
            return math.nan
        if not is_angle and DEGREE in parts(expression):
            self._complain(node, "is an angle, but a length belongs here: leave out deg")
        return evaluate(expression, {})

    def _complain(self, node: Node, message: str) -> None:
        self._mistakes.append(self._document.source.point(span_of(node), message))
