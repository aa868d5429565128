"""Regular poses in Python, many at a time, in tiles that vectorise.

A tile holds the values of many poses side by side, one value after another: `work[place + k]` is a
value of pose k. Loops over k that hold nothing but arithmetic become vector instructions; sines,
cosines and arctangents have loops of their own.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.program.ir import Joint, Let, Pose, Variable
from dhgen.program.walk import parts
from dhgen.robot.task import TaskKind
from dhgen.targets.dialect import expression_text
from dhgen.targets.layout import INDENT
from dhgen.targets.module import has_to_be_finite
from dhgen.targets.python.language import Python
from dhgen.targets.python.one_pose import assigned, single, status_text
from dhgen.targets.stages import staged

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.program.ir import Expression
    from dhgen.program.regular.flatten import Flat
    from dhgen.targets.module import SolverModule
    from dhgen.targets.python.one_pose import Single
    from dhgen.targets.stages import Call, Stage

LOOP = INDENT * 3  # inside a loop over the poses of a tile
TILE = 16  # poses: two of the widest vectors; what a tile needs stays in the first cache


def regular_values(module: SolverModule, flat: Flat) -> PythonRegular:
    """What serves a robot's regular poses."""
    tiled = tile(flat, module.chain.given)
    return PythonRegular(
        one=single(flat),
        tile=tiled,
        exact=[line.removeprefix(LOOP) for line in _exact(module)],
        places=_rows(tiled.places),
    )


class _Lanes(Python):
    """Python where the values of free joints have names."""

    def joint(self, number: int, role: str) -> str:
        """The value that the caller gives."""
        del role
        return f"given{number}"


@dataclass(frozen=True, slots=True)
class Loop:
    """A loop over values that stand side by side.

    Attributes:
        first: Where the first begins.
        last: Where the last ends.
        lines: What is done for `k`.
    """

    first: int
    last: int
    lines: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class PythonRegular:
    """What serves regular poses.

    Attributes:
        one: What solves one of them.
        tile: What solves many.
        exact: Statements that say of pose k of a tile whether it needs no straightening.
        places: Where the joints' values of each row begin, as lines of a table.
    """

    one: Single
    tile: Tile
    exact: Sequence[str]
    places: Sequence[str]


@dataclass(frozen=True, slots=True)
class Tile:
    """What a tile does.

    Attributes:
        size: Of its memory, in numbers.
        doubt: Where it says that a pose is none of its.
        loops: The loops over all of its poses.
        places: Where the joints' values of each row begin.
        kinds: Where the rows' statuses begin, as a list in Python.
    """

    size: int
    doubt: int
    loops: tuple[Loop, ...]
    places: tuple[tuple[int, ...], ...]
    kinds: str


def tile(flat: Flat, free: int) -> Tile:
    """The program of regular poses over a tile.

    It begins with the sixteen entries of the poses and the values of the free joints.

    Args:
        flat: The program, all branches unrolled.
        free: Number of free joints.
    """
    entries = [f"T{row}{column}" for row in (1, 2, 3, 4) for column in (1, 2, 3, 4)]
    return _Tiling(flat, [*entries, *(f"given{place + 1}" for place in range(free))]).run()


class _Tiling:
    def __init__(self, flat: Flat, inputs: list[str]) -> None:
        self._flat = flat
        self._language = _Lanes()
        self._stages = staged(flat.program)
        self._places = {name: place for place, name in enumerate(inputs)}
        self._known: dict[str, int] = dict.fromkeys(inputs, -1)  # by which stage
        self._truths = {s.name for s in flat.program.body if isinstance(s, Let) and s.truth}
        for number, stage in enumerate(self._stages.stages):
            self._known |= {let.name: number for let in stage.lets}
            self._known |= {call.name: number for call in stage.calls}
        self._needed = [self._needs(stage) for stage in self._stages.stages]
        self._needed[-1] |= {name for output in self._stages.outputs for name in _names(output)}

    def run(self) -> Tile:
        doubt = self._place("left over")
        loops: list[Loop] = []
        for number, stage in enumerate(self._stages.stages):
            loops += self._loops(number, stage)
        rows, dof = len(self._flat.choices), self._flat.joints
        places, lines = self._values(self._stages.outputs[: rows * dof])
        kinds, more = self._kinds(places)
        last = loops.pop()
        loops.append(Loop(0, TILE, (*last.lines, *lines, *more)))
        table = tuple(tuple(places[row * dof : (row + 1) * dof]) for row in range(rows))
        return Tile(TILE * len(self._places), doubt, tuple(loops), table, str(kinds))

    def _place(self, name: str) -> int:
        """Where the values of a name begin."""
        return TILE * self._places.setdefault(name, len(self._places))

    def _needs(self, stage: Stage) -> set[str]:
        used = [let.expression for let in stage.lets]
        used += [operand for call in stage.calls for operand in call.operands]
        return {name for expression in used for name in _names(expression)}

    def _loops(self, number: int, stage: Stage) -> list[Loop]:
        """The arithmetic of a stage, and the loops of its functions."""
        lines = []
        needed = self._needed[number]
        for name in (each for each in self._known if each in needed):  # in the order of their birth
            if self._known[name] < number:
                truth = " != 0.0" if name in self._truths else ""
                lines.append(f"{LOOP}{name} = work[{self._place(name)} + k]{truth}")
        later = set().union(*self._needed[number + 1 :])
        for let in stage.lets:
            lines += assigned(let.name, expression_text(let.expression, self._language), LOOP)
        for let in stage.lets:
            if let.name in later:
                lines.append(f"{LOOP}work[{self._place(let.name)} + k] = {let.name}")
        calls: dict[str, list[Call]] = {}
        for call in stage.calls:
            calls.setdefault(call.operator, []).append(call)
        loops = [self._called(operator, each, lines) for operator, each in calls.items()]
        return [Loop(0, TILE, tuple(lines)), *loops]

    def _called(self, operator: str, calls: list[Call], lines: list[str]) -> Loop:
        """One loop for all calls of a function; `lines` takes the arguments to their places."""
        places = [self._place(call.name) for call in calls]
        others = [
            [self._place(f"{call.name} {number}") for call in calls]
            for number in range(1, len(calls[0].operands))
        ]
        for column, taken in enumerate([places, *others]):
            for call, place in zip(calls, taken, strict=True):
                text = expression_text(call.operands[column], self._language)
                lines += assigned(f"work[{place} + k]", text, LOOP)
        arguments = ["work[k]", *(f"work[k + {taken[0] - places[0]}]" for taken in others)]
        value = f"{self._language.function(operator)}({', '.join(arguments)})"
        return Loop(places[0], places[-1] + TILE, (f"{LOOP}work[k] = {value}",))

    def _values(self, outputs: tuple[Expression, ...]) -> tuple[list[int], list[str]]:
        """Where the joints' values begin, equal ones at one place, and what takes them there."""
        lines: list[str] = []
        places: dict[Expression, int] = {}
        for number, value in enumerate(outputs):
            if value not in places:
                places[value] = place = self._place(f"q {number}")
                lines += assigned(f"_{place}", expression_text(value, self._language), LOOP)
                lines.append(f"{LOOP}work[{place} + k] = _{place}")
        return [places[value] for value in outputs], lines

    def _kinds(self, places: list[int]) -> tuple[list[int], list[str]]:
        """Where the statuses begin, and what takes them and the doubt there."""
        rows, language = len(self._flat.choices), self._language
        rest = self._stages.outputs[len(places) :]
        kinds = [self._place(f"status {row}") for row in range(rows)]
        lines: list[str] = []
        for row, place in enumerate(kinds):
            beyond = expression_text(rest[row], language) if self._flat.limited else ""
            kind = status_text(f"_{places[row * self._flat.joints]}", beyond)
            lines += assigned(f"work[{place} + k]", kind, LOOP)
        place = self._place("left over")
        for doubt in rest[len(rest) - len(self._flat.doubts) :]:
            text = expression_text(doubt, language)
            lines += assigned(f"work[{place} + k]", f"1.0 if {text} else work[{place} + k]", LOOP)
        return kinds, lines


def _names(expression: Expression) -> Iterable[str]:
    for part in parts(expression):
        match part:
            case Variable(name):
                yield name
            case Pose(row, column):
                yield f"T{row}{column}"
            case Joint(number):
                yield f"given{number}"


def _rows(table: tuple[tuple[int, ...], ...]) -> list[str]:
    """A table of whole numbers, row by row."""
    return [f"{INDENT}{list(row)}," for row in table]


def _exact(module: SolverModule) -> list[str]:
    """The statements that say of pose k of a tile whether it needs no straightening."""
    task = module.chain.task
    lines: list[str] = []
    terms = []
    if task.names_rotation:
        for row, letter in enumerate("xyz"):
            entries = [f"work[{TILE * (4 * row + column)} + k]" for column in range(3)]
            lines.append(f"{letter}0, {letter}1, {letter}2 = {', '.join(entries)}")
        lines += [
            "xx = x0 * x0 + x1 * x1 + x2 * x2 - 1.0",
            "yy = y0 * y0 + y1 * y1 + y2 * y2 - 1.0",
            "xy = x0 * y0 + x1 * y1 + x2 * y2",
            "u, v, w = x1 * y2 - x2 * y1 - z0, x2 * y0 - x0 * y2 - z1, x0 * y1 - x1 * y0 - z2",
        ]
        terms.append("xx * xx + yy * yy + 2.0 * xy * xy + u * u + v * v + w * w")
    elif task.kind is TaskKind.POINTING:
        tool = [f"work[{TILE * (4 * row + 2)} + k]" for row in range(3)]
        lines = [
            f"x, y, z = {', '.join(tool)}",
            "square = x * x + y * y + z * z - 1.0",
        ]
        terms.append("square * square")
    if task.kind is TaskKind.POSE:
        last = [f"work[{TILE * (12 + column)} + k]" for column in range(4)]
        lines.append(f"rest = abs({last[0]}) + abs({last[1]}) + abs({last[2]})")
        terms.append(f"rest + abs({last[3]} - 1.0)")
    given = [TILE * (4 * row + 3) for row in module.chain.task.position_rows]
    given += [TILE * (16 + place) for place in range(module.chain.given)]
    finite = has_to_be_finite(module, (f"work[{place} + k]" for place in given))
    terms += [f"0.0 * ({' + '.join(finite)})"] if finite else []  # NaN where one is not finite
    exact = f"exact = miss <= {module.precision.tolerances.orthonormal!r}"
    return [*lines, *assigned("miss", " + ".join(terms) or "0.0", LOOP), exact]
