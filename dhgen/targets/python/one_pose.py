"""Regular poses in Python, one at a time: straight-line code, its arctangents side by side.

What is taken of many values at once is a loop over room on the stack, eight values a vector.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.program.ir import Heading, Let
from dhgen.program.walk import names_in
from dhgen.targets.dialect import expression_text
from dhgen.targets.layout import INDENT, WIDTH
from dhgen.targets.python.language import Python
from dhgen.targets.stages import staged

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.program.ir import Expression, Program
    from dhgen.program.regular.flatten import Flat
    from dhgen.targets.stages import Call, Stage

LANES = 8  # of the widest vectors: what is left over after whole ones is taken one by one
SIDE_BY_SIDE = ("atan2",)  # sine and cosine are libm's, which has no vectors


@dataclass(frozen=True, slots=True)
class Single:
    """What solves one pose.

    Attributes:
        lines: The statements that fill q and status, or return that this pose is none of theirs.
        room: How many numbers they need on the stack.
    """

    lines: tuple[str, ...]
    room: int


def single(flat: Flat) -> Single:
    """The program of regular poses for one of them.

    Args:
        flat: The program, all branches unrolled.
    """
    stages = staged(flat.program)
    titles = _titles(flat.program)
    together = [_together(stage) for stage in stages.stages]
    values = stages.outputs[: flat.joints * len(flat.choices)]
    rest = stages.outputs[len(values) :]
    doubts = list(rest[len(rest) - len(flat.doubts) :])
    known = {constant.name for constant in flat.program.constants}
    lines: list[str] = []
    for stage, calls in zip(stages.stages, together, strict=True):
        lines += _arithmetic(stage, titles)
        known |= {let.name for let in stage.lets}
        while doubts and names_in(doubts[0]) <= known:
            lines += _leaving(doubts.pop(0), limited=flat.limited)
        lines += _called(stage, calls)
        known |= {call.name for call in stage.calls}
    late = (line for doubt in doubts for line in _leaving(doubt, limited=flat.limited))
    lines += [*late, ""]
    lines += _results(flat, values, rest)
    while lines and not lines[0]:
        lines = lines[1:]
    return Single(tuple(lines), max((2 * _padded(len(calls)) for calls in together), default=0))


def assigned(target: str, value: str, indent: str) -> list[str]:
    """An assignment, in as many lines as it takes."""
    line = f"{indent}{target} = {value}"
    return [line] if len(line) <= WIDTH else Python().broken(line, indent)


def status_text(first: str, beyond: str) -> str:
    """What a row holds, from its first value and whether one is beyond its limits."""
    held = f"(OUT_OF_LIMITS if {beyond} else OK)" if beyond else "OK"
    return f"UNREACHABLE if {first} != {first} else {held}"


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


def _together(stage: Stage) -> tuple[Call, ...]:
    """The calls that are taken side by side: those of a function that has vectors, if many."""
    calls = tuple(call for call in stage.calls if call.operator in SIDE_BY_SIDE)
    return calls if len(calls) > 1 else ()


def _padded(count: int) -> int:
    return -(-count // LANES) * LANES


def _arithmetic(stage: Stage, titles: dict[str, str]) -> list[str]:
    language = Python()
    lines: list[str] = []
    title = ""
    for let in stage.lets:
        if titles[let.name] != title:
            title = titles[let.name]
            lines += ["", f"{INDENT}# {title}"]
        lines += assigned(let.name, expression_text(let.expression, language), INDENT)
    return lines


def _called(stage: Stage, together: tuple[Call, ...]) -> list[str]:
    language = Python()
    lines: list[str] = []
    for call in stage.calls:
        if call not in together:
            operands = ", ".join(expression_text(each, language) for each in call.operands)
            value = f"{language.function(call.operator)}({operands})"
            lines += assigned(call.name, value, INDENT)
    return [*lines, *_side_by_side(together)] if together else lines


def _side_by_side(calls: tuple[Call, ...]) -> list[str]:
    """One loop for all: the first arguments, then the second; the values where the first were."""
    language = Python()
    function = language.function(calls[0].operator)
    count, size = len(calls), _padded(len(calls))
    lines = ["", f"{INDENT}# angles, side by side"]
    for column in range(2):
        for place, call in enumerate(calls):
            text = expression_text(call.operands[column], language)
            lines += assigned(f"room[{column * size + place}]", text, INDENT)
    if count < size:
        lines += [  # any numbers would do, but some are slow
            f"{INDENT}for k in range({count}, {size}):",
            f"{INDENT * 2}room[k] = room[k + {size}] = 1.0",
        ]
    lines += [
        f"{INDENT}for k in range({size}):",
        f"{INDENT * 2}room[k] = {function}(room[k], room[k + {size}])",
    ]
    return lines + [f"{INDENT}{call.name} = room[{place}]" for place, call in enumerate(calls)]


def _leaving(doubt: Expression, *, limited: bool) -> list[str]:
    """Leaves a pose that is none of these rows', as soon as that is known."""
    language = Python()
    leave = language.leave(expression_text(doubt, language), "", 0, [])
    why = "a joint is free, branches meet" if limited else "a joint is free, or branches meet"
    reason = f"{INDENT}# {why}{', or rounding tells what is beyond a limit' if limited else ''}"
    return ["", reason, *(INDENT + line for line in leave[:-1]), f"{INDENT * 2}return False"]


def _results(flat: Flat, values: Sequence[Expression], rest: Sequence[Expression]) -> list[str]:
    """The rows; `rest` begins with what is beyond limits."""
    language = Python()
    lines: list[str] = []
    for row in range(len(flat.choices)):
        for joint in range(flat.joints):
            text = expression_text(values[row * flat.joints + joint], language)
            lines += assigned(f"q[{row}, {joint}]", text, INDENT)
        beyond = expression_text(rest[row], language) if flat.limited else ""
        lines += assigned(f"status[{row}]", status_text(f"q[{row}, 0]", beyond), INDENT)
    return [*lines, f"{INDENT}return True"]
