"""Regular poses in Python: one text for one pose and for many side by side.

Values of w poses lie side by side: `kept[place * w + k]` is a value of pose k. Loops over k that
hold nothing but arithmetic become vector instructions; sines, cosines and arctangents have loops of
their own over `turns`, which for a single pose go over all that a stage takes. With w = 1 what is
kept remains in registers.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import groupby
from typing import TYPE_CHECKING

from dhgen.program.ir import Heading, Joint, Let, Pose, Variable
from dhgen.program.walk import names_in, parts
from dhgen.targets.dialect import expression_text
from dhgen.targets.layout import INDENT, listed, paragraph
from dhgen.targets.python.assignments import Assignment, alike, side_by_side
from dhgen.targets.python.language import Python
from dhgen.targets.stages import staged

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.program.ir import Expression, Program
    from dhgen.program.regular.flatten import Flat
    from dhgen.targets.stages import Call, Stage

LANES = 8  # of the widest vectors: what is left over after whole ones is taken one by one
LOOP = INDENT * 2  # inside a loop over the poses
SIDE_BY_SIDE = "atan2"  # sine and cosine are libm's, which has no vectors
ENTRIES = tuple(f"T{row}{column}" for row in (1, 2, 3, 4) for column in (1, 2, 3, 4))


@dataclass(frozen=True, slots=True)
class Formulas:
    """The formulas of regular poses.

    Attributes:
        lines: The statements.
        kept: How many values of a pose are kept: its entries, what the caller gives, whether it is
            left to the whole program, and what stages leave to later ones.
        turns: How many arguments of functions it has, or one, as no array is empty.
        places: The places among `rows` of the joints' values of each row, as lines of a table; the
            rows' statuses come after all of them.
    """

    lines: Sequence[str]
    kept: int
    turns: int
    places: Sequence[str]


def formulas_of(flat: Flat, given: int) -> Formulas:
    """The program of regular poses.

    Args:
        flat: The program, all branches unrolled.
        given: How many values the caller gives.
    """
    return _Printing(flat, given).run()


class _Given(Python):
    """Python where the values that the caller gives have names."""

    def joint(self, number: int, role: str) -> str:
        """The value that the caller gives."""
        del role
        return f"given{number}"


class _Printing:
    def __init__(self, flat: Flat, given: int) -> None:
        inputs = [*ENTRIES, *(f"given{place + 1}" for place in range(given))]
        self._flat = flat
        self._language = _Given()
        self._titles = _titles(flat.program)
        self._staged = staged(flat.program)
        self._doubt = f"kept[{len(inputs)} * w + k]"
        self._kept = {name: place for place, name in enumerate([*inputs, "in doubt"])}
        self._turns: dict[str, int] = {}  # the places of calls' first arguments, and values
        self._size = 0  # of all arguments
        self._known: dict[str, int] = dict.fromkeys(inputs, -1)  # by which stage
        self._truths = {s.name for s in flat.program.body if isinstance(s, Let) and s.truth}
        for number, stage in enumerate(self._staged.stages):
            self._known |= {let.name: number for let in stage.lets}
            self._known |= {call.name: number for call in stage.calls}
        values = flat.joints * len(flat.choices)
        self._values, self._rest = self._staged.outputs[:values], self._staged.outputs[values:]
        self._doubts = self._placed_doubts()
        self._needed = [
            _needs(stage, doubts)
            for stage, doubts in zip(self._staged.stages, self._doubts, strict=True)
        ]
        self._needed[-1] |= {name for output in self._outputs() for name in _names(output)}

    def _outputs(self) -> tuple[Expression, ...]:
        """The joints' values, and what is beyond limits."""
        return (*self._values, *self._rest[: len(self._rest) - len(self._flat.doubts)])

    def _placed_doubts(self) -> list[list[Expression]]:
        """For every stage what leaves a pose to the whole program as soon as that is known."""
        stages: list[list[Expression]] = [[] for _ in self._staged.stages]
        last = len(stages) - 1
        calls = {call.name for stage in self._staged.stages for call in stage.calls}
        for doubt in self._rest[len(self._rest) - len(self._flat.doubts) :]:
            names = [name for name in names_in(doubt) if name in self._known]
            births = [self._known[name] + (name in calls) for name in names]
            stages[max(births, default=last)].append(doubt)
        return stages

    def run(self) -> Formulas:
        lines: list[str] = []
        for number, stage in enumerate(self._staged.stages):
            lines += self._stage(number, stage)
        places, filling = self._filled()
        rows, dof = len(self._flat.choices), self._flat.joints
        table = listed([str(places[row * dof : (row + 1) * dof]) for row in range(rows)], INDENT)
        return Formulas([*lines, *filling], len(self._kept), max(self._size, 1), table)

    def _stage(self, number: int, stage: Stage) -> list[str]:
        """The arithmetic of a stage, and the loops of its functions."""
        needed, later = self._needed[number], set[str]().union(*self._needed[number + 1 :])
        early = [name for name in self._known if name in needed and self._known[name] < number]
        lines = [f"{INDENT}for k in range(w):", *side_by_side(map(self._read, early), LOOP)]
        for title, lets in groupby(stage.lets, lambda let: self._titles[let.name]):
            lines += ["", f"{LOOP}# {paragraph(title, f'{LOOP}# ')}"] if title else []
            lines += side_by_side(map(self._named, lets), LOOP)
        if self._doubts[number]:
            lines += ["", f"{LOOP}# {self._reason()}"]
        for doubt in self._doubts[number]:
            text = expression_text(doubt, self._language)
            lines += side_by_side([(self._doubt, f"1.0 if {text} else {self._doubt}")], LOOP)
        kept = [(self._keep(let.name), let.name) for let in stage.lets if let.name in later]
        loops, arguments = self._functions(stage)
        leave = self._leave() if self._doubts[number] and loops else []
        return [*lines, *side_by_side([*kept, *arguments], LOOP), *leave, *loops]

    def _named(self, let: Let) -> Assignment:
        """A value, computed."""
        return let.name, expression_text(let.expression, self._language)

    def _leave(self) -> list[str]:
        """Ends where one pose is left to the whole program, before functions take their time."""
        doubt = self._doubt.replace(" * w + k", "")
        return [f"{INDENT}if w == 1 and {doubt} != 0.0:", f"{LOOP}return"]

    def _reason(self) -> str:
        """Why a pose is left to the whole program."""
        if self._flat.limited:
            return "a joint is free, branches meet, or rounding decides what is beyond a limit"
        return "a joint is free, or branches meet"

    def _keep(self, name: str) -> str:
        """Where a value is kept."""
        return f"kept[{self._kept.setdefault(name, len(self._kept))} * w + k]"

    def _read(self, name: str) -> Assignment:
        """A value of an earlier stage."""
        if name in self._turns:
            return name, f"turns[{self._turns[name]} * w + k]"
        return name, self._keep(name) + (" != 0.0" if name in self._truths else "")

    def _functions(self, stage: Stage) -> tuple[list[str], list[Assignment]]:
        """One loop for each function of a stage, and what takes its arguments to their places."""
        calls: dict[str, list[Call]] = {}
        for call in stage.calls:
            calls.setdefault(call.operator, []).append(call)
        loops: list[str] = []
        arguments: list[Assignment] = []
        for operator, each in calls.items():
            loops += self._called(operator, each, arguments)
        return loops, arguments

    def _called(self, operator: str, calls: list[Call], arguments: list[Assignment]) -> list[str]:
        """The loop of a function; values take the places of first arguments."""
        first, count, columns = self._size, len(calls), len(calls[0].operands)
        filled_up = operator == SIDE_BY_SIDE and count > 1
        size = -(-count // LANES) * LANES if filled_up else count
        for column in range(columns):
            for place, call in enumerate(calls, first + column * size):
                text = expression_text(call.operands[column], self._language)
                arguments.append((f"turns[{place} * w + k]", text))
        self._turns |= {call.name: place for place, call in enumerate(calls, first)}
        self._size = first + columns * size
        beside = [f"turns[k + {column * size} * w]" for column in range(1, columns)]
        value = f"{self._language.function(operator)}({', '.join(['turns[k]', *beside])})"
        if size == count:
            return [*_loop(f"{first} * w", f"{first + count} * w"), f"{LOOP}turns[k] = {value}"]
        return [
            f"{INDENT}end = {first + size} if w == 1 else {first + count} * w",
            f"{INDENT}# one pose's vectors are filled up: any numbers would do, but some are slow",
            *_loop(f"{first + count} * w", "end"),
            f"{LOOP}{' = '.join(['turns[k]', *beside])} = 1.0",
            *_loop(f"{first} * w", "end"),
            f"{LOOP}turns[k] = {value}",
        ]

    def _filled(self) -> tuple[list[int], list[str]]:
        """The places of the joints' values, equal ones at one place, and what fills `rows`."""
        places: dict[Expression, int] = {}
        values: list[Assignment] = []
        firsts: list[str] = []  # the name of the first value of each row
        named: list[Assignment] = []
        for number, value in enumerate(self._values):
            place = places.setdefault(value, len(places))
            text = expression_text(value, self._language)
            if number % self._flat.joints == 0 and not isinstance(value, Variable):
                named.append((f"_{place}", text))
                text = f"_{place}"
            if number % self._flat.joints == 0:
                firsts.append(text)
            if place == len(values):
                values.append((f"rows[{place} * w + k]", text))
        statuses: list[Assignment] = []
        for row, first in enumerate(firsts):
            beyond = expression_text(self._rest[row], self._language) if self._flat.limited else ""
            held = f"(OUT_OF_LIMITS if {beyond} else OK)" if beyond else "OK"
            target = f"rows[{len(places) + row} * w + k]"
            statuses.append((target, f"UNREACHABLE if {first} != {first} else {held}"))
        lines = [
            "",
            *side_by_side(named, LOOP),
            *side_by_side([*values, *alike(statuses, LOOP)], LOOP),
        ]
        return [places[value] for value in self._values], lines


def _loop(first: str, end: str) -> list[str]:
    return [f"{INDENT}for k in range({first}, {end}):"]


def _titles(program: Program) -> dict[str, str]:
    """The step of the derivation that each value belongs to."""
    titles: dict[str, str] = {}
    title = ""
    for statement in program.body:
        match statement:
            case Heading(text, detail):
                title = f"{text}, {detail}" if detail else text
            case Let(name):
                titles[name] = title
    return titles


def _needs(stage: Stage, doubts: Sequence[Expression]) -> set[str]:
    """What a stage names."""
    used = [let.expression for let in stage.lets]
    used += [operand for call in stage.calls for operand in call.operands]
    return {name for expression in (*used, *doubts) for name in _names(expression)}


def _names(expression: Expression) -> Iterable[str]:
    for part in parts(expression):
        match part:
            case Variable(name):
                yield name
            case Pose(row, column):
                yield f"T{row}{column}"
            case Joint(number):
                yield f"given{number}"
