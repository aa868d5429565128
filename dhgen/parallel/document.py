"""The derivation of a parallel robot: blocks that are printed as those of serial arms are."""

from __future__ import annotations

from collections import Counter
from math import prod
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.notation.expressions import number_symbol
from dhgen.derivation.notation.names import letter
from dhgen.derivation.story import COURSE_TEXT
from dhgen.derivation.text.blocks import Given, Table, display, joined, paragraph, say
from dhgen.derivation.text.formula import Matrix, Symbol, equal
from dhgen.derivation.text.template import blocks_of
from dhgen.derivation.text.words import numeral
from dhgen.derivation.values import degrees
from dhgen.legs.mobility import Count, counted
from dhgen.legs.robot import ORIGIN
from dhgen.parallel.figure import example_figure
from dhgen.parallel.module import Elimination
from dhgen.parallel.worked import example_of, square
from dhgen.runtime.python.platform import LENGTHS

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dhgen.arrays import FloatArray
    from dhgen.derivation.figures.figure import Figure
    from dhgen.derivation.text.blocks import Block
    from dhgen.derivation.text.formula import Formula
    from dhgen.parallel.module import ParallelModule
    from dhgen.parallel.worked import Example

FEW_DIGITS = 1e-3  # that a size is rounded to
DIGITS = 4  # decimals of examples
WORDS = {
    (3, 4, 5): "The platform moves in all six ways.",
    (5,): "The platform moves in the plane of x and y, and turns there.",
}
NO_TURNS = {
    True: "A point of the platform moves in the plane of x and y.",
    False: "The platform moves in three directions and keeps its orientation.",
}


def parallel_blocks(
    module: ParallelModule, documents: Mapping[str, str] = MappingProxyType({})
) -> tuple[list[Block], list[Figure]]:
    """The document and its figures.

    Args:
        module: The robot.
        documents: Of kinds of legs, by their names, the paths of their documents.
    """
    example = example_of(module)
    figures = [] if example is None else [example_figure(module, example)]
    values = {
        "title": Given(module.robot.title),
        "legs": numeral(len(module.legs)),
        "freedoms": _freedoms_text(module),
        "of_a_course": COURSE_TEXT.search(module.robot.source) is not None,
        "unit": module.robot.length_unit,
        "cited": Given(module.robot.source.removesuffix(".")) if module.robot.source else "",
        "table": [_table(module)],
        "is_turned": any(leg.leg.base[:3] != (1.0, 0.0, 0.0) for leg in module.legs),
        "bases": [display(*_bases(module))],
        "picture": [figure.picture for figure in figures],
        "count": _count_symbol(count_of(module)),
        "solved": [paragraph(text, *parts) for text, parts in _solved(module, documents)],
        "two_circles": module.elimination is Elimination.TWO_CIRCLES,
        "three_circles": module.elimination is Elimination.THREE_CIRCLES,
        "three_spheres": module.elimination is Elimination.THREE_SPHERES,
        "turns": module.freedoms[-1] >= LENGTHS,
        "carries_frame": any(leg.leg.carries_frame for leg in module.legs),
        "pose": [] if example is None else [display(_matrix(r"X", "X", example.T))],
        "example": [] if example is None else [_rows(module, example)],
        "smallest": [] if example is None else [_smallest(example)],
        "assemblies": [] if example is None else _assemblies(module, example),
        "many": "" if example is None else _assembly_count(example),
        "compared": [_compared(module)],
        "size": number_symbol(module.size),
        "made_of": _size_in_words(module),
    }
    return blocks_of("parallel", **values), figures


def _size_in_words(module: ParallelModule) -> str:
    """Where the robot's size comes from."""
    if module.size > max(leg.solver.chain.size for leg in module.legs) * (1.0 + FEW_DIGITS):
        return "the largest distance of two bases, or of two origins in the table"
    return "that of its largest leg, the sum of all lengths or the farthest limit of a slide"


def _freedoms_text(module: ParallelModule) -> str:
    """How the platform moves."""
    turns = tuple(each for each in module.freedoms if each >= LENGTHS)
    return WORDS[turns] if turns else NO_TURNS[module.is_planar]


def count_of(module: ParallelModule) -> Count:
    """The platform's freedoms."""
    joints = [leg.solver.chain.dof for leg in module.legs]
    points = [not leg.leg.carries_frame for leg in module.legs]
    return counted(module.robot.task, joints, points, module.robot.drives)


def _count_symbol(count: Count) -> Symbol:
    text = count.text
    return Symbol(text.replace("*", r" \cdot "), text.replace("*", "·"))


def _short(value: float) -> Symbol:
    return number_symbol(round(float(value), DIGITS) + 0.0)


def _place(name: str, index: int) -> Symbol:
    return letter(name, name, str(index))


def _matrix(latex: str, text: str, T: FloatArray) -> Formula:
    return equal(Symbol(latex, text), _numbers(T))


def _bases(module: ParallelModule) -> list[Formula]:
    return [
        equal(_place("G", number), _numbers(square(leg.leg.base)))
        for number, leg in enumerate(module.legs, start=1)
    ]


def _numbers(T: FloatArray) -> Matrix:
    return Matrix(tuple(tuple(_short(entry) for entry in row) for row in T))


def _table(module: ParallelModule) -> Table:
    """Of every leg its chain, its driven joints and what it carries."""
    header = ("leg", "chain", "driven", "carries")
    rows = [
        (
            say(f"{number}"),
            say("{}", _name(leg.solver.name)),
            joined([say("{}", _place("q", joint + 1)) for joint in leg.driven]),
            say("{}", _carried(leg.leg.end)),
        )
        for number, leg in enumerate(module.legs, start=1)
    ]
    return Table(tuple(map(say, header)), tuple(rows))


def _carried(end: Sequence[float]) -> Symbol:
    parts = [_short(end[place]) for place in ORIGIN]
    latex, text = (", ".join(each) for each in ([p.latex for p in parts], [p.text for p in parts]))
    return Symbol(f"({latex})", f"({text})")


def _solved(
    module: ParallelModule, documents: Mapping[str, str]
) -> list[tuple[str, tuple[Formula | Given, ...]]]:
    """How each kind of leg is solved, and what its rows are called."""
    kinds = {leg.solver.name: leg.solver for leg in module.legs}
    found: list[tuple[str, tuple[Formula | Given, ...]]] = []
    for name, solver in kinds.items():
        rows = numeral(solver.solver.rows)
        text = "The derivation of {} is in a document of its own. It has at most"
        names = ", ".join(f"{row} {branch}" for row, branch in enumerate(solver.branches))
        leg = Given(name, documents.get(name, ""))
        found.append((f"{text} {rows} rows: {{}}.", (leg, Given(names))))
    return found


def _name(name: str) -> Symbol:
    """The name of a chain, equal in all languages."""
    return Symbol(rf"\mathtt{{{name}}}".replace("_", r"\_"), name)


def _rows(module: ParallelModule, example: Example) -> Table:
    """All rows of all legs at the example."""
    header = [say("leg"), say("row")]
    header += [say("{}", _place("q", joint + 1)) for joint in range(module.joints)]
    header.append(say("within limits"))
    rows = []
    for number, leg in enumerate(module.legs):
        for row in range(leg.solver.solver.rows):
            values = example.rows[number, row]
            if np.isnan(values[: leg.solver.chain.dof]).any():
                continue
            turning = leg.solver.chain.turning
            cells = [say("{}", _value(*each)) for each in zip(values, turning, strict=False)]
            cells += [say("")] * (len(values) - len(turning))
            held = say("yes" if example.inside[number, row] else "no")
            rows.append((say(f"{number + 1}"), say(f"{row}"), *cells, held))
    return Table(tuple(header), tuple(rows))


def _value(value: float, turns: bool) -> Symbol:  # noqa: FBT001  of a joint
    return degrees(value) if turns else _short(value)


def _smallest(example: Example) -> Block:
    text = (
        "With the first rows within limits the smallest singular value of {} is {}, that of {} is "
        "{} (lengths divided by the robot's size): the pose is regular."
    )
    B, A = example.least
    return paragraph(text, Symbol("B", "B"), _short(B), Symbol("A", "A"), _short(A))


def _assembly_count(example: Example) -> str:
    count = len(example.assemblies)
    return "one pose" if count == 1 else f"{numeral(count)} poses"


def _assemblies(module: ParallelModule, example: Example) -> list[Block]:
    """All poses that the drives of the example allow."""
    if not len(example.assemblies):
        return []
    letters = [("x", "x"), ("y", "y"), ("z", "z")][: 2 if module.is_planar else 3]
    turns = module.freedoms[-1] == 5
    header = [say("{}", Symbol(*letter)) for letter in letters]
    header += [say("{}", Symbol(r"\varphi", "φ"))] if turns else []
    rows = []
    for T in example.assemblies:
        cells = [_short(T[i, 3]) for i in range(len(letters))]
        cells += [degrees(np.arctan2(T[1, 0], T[0, 0]))] if turns else []
        rows.append(tuple(say("{}", cell) for cell in cells))
    return [Table(tuple(header), tuple(rows))]


def _compared(module: ParallelModule) -> Block:
    """The comparison with the serial case that document 001 makes."""
    modes = prod(leg.solver.solver.rows for leg in module.legs)
    direct = "is solved near a pose"
    if module.elimination is not None:
        direct = f"has {numeral(module.elimination.most)} answers at most"
    return paragraph(
        "Of a serial arm the forward model has one answer, a product of matrices, and the inverse "
        "model several. Here the inverse model falls apart into the legs, whose rows make {} "
        "working modes at most before limits are looked at; rows that differ in passive "
        "joints alone have the same drives. The direct model has to close all loops at once, and "
        f"{direct}.",
        Symbol(str(modes), str(modes)),
    )


def parallel_summary(module: ParallelModule) -> str:
    """The summary for a terminal: the robot, and how it is solved."""
    kinds = Counter(leg.solver.name for leg in module.legs)
    of = {leg.solver.name: leg.solver for leg in module.legs}
    legs = ", ".join(f"{n} {of[name].chain.joint_types} ({name})" for name, n in kinds.items())
    rows = " x ".join(str(leg.solver.solver.rows) for leg in module.legs)
    direct = (
        f"all assemblies by {module.elimination}, or refined from a seed"
        if module.elimination
        else "refined from a seed; how many assemblies there are is not promised"
    )
    return "\n".join(
        [
            f"  legs     {legs}",
            f"  task     {module.robot.task.text}; mobility {count_of(module).text}",
            f"  inverse  that of the legs: rows {rows}",
            f"  direct   {direct}",
        ]
    )
