"""The nearest arm with a structure: what the template `nearest.md.jinja` names."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from dhgen.derivation.sections.robot import meanings_of_names
from dhgen.derivation.text.blocks import Given, Table, joined, paragraph, say
from dhgen.derivation.text.formula import Symbol
from dhgen.derivation.text.template import blocks_of
from dhgen.kinematics.neighbours import short_number
from dhgen.program.ir import Heading
from dhgen.runtime.plain import plain

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.nominal.nearest import Nearest
    from dhgen.nominal.nominal import Nominal

_TWISTS = {0: ("0", "0"), 1: (r"\frac{\pi}{2}", "π/2"), 2: (r"\pi", "π")}
_COLUMNS = (r"\theta", "θ"), ("d", "d"), ("a", "a"), (r"\alpha", "α")
DIGITS = 6


def nearest_blocks(story: Story) -> list[Block]:
    """How the nearest arm's rows are tried first; nothing where there is none."""
    nominal, unit = story.nominal, story.robot.length_unit
    if nominal is None:
        return []
    return blocks_of(
        "nearest",
        table=[_table(nominal.nearest)],
        length=f"{short_number(nominal.nearest.deviation.length, 2)} {unit}",
        angle=f"{short_number(nominal.nearest.deviation.angle, 2)} rad",
        given=", those that the caller gives among them," if nominal.chain.free else "",
        order=_order(nominal),
        rows=nominal.solver.rows,
        last=f"{plain('general.correct').LAST_CORRECTION:.0e}".replace("e-0", "e-"),
        left=round(100.0 * (1.0 - nominal.certain)),
        names=_names(story, nominal),
    )


def _names(story: Story, nominal: Nominal) -> list[Block]:
    """The name of every row, and what a person sees of the arm in rows of these names."""
    names, count = story.branch_names, nominal.solver.rows
    near = replace(story, derivation=nominal.derivation, program=nominal.solver, nominal=None)
    return [
        paragraph(
            f"The names of rows 0 to {count - 1} are {{}}. Rows {count} to {len(names) - 1}, "
            f"{names[count]} to {names[-1]}, are for further solutions.",
            Given(", ".join(names[:count])),
        ),
        *meanings_of_names(near),
    ]


def nearest_line(nominal: Nominal, unit: str) -> str:
    """By how much the structure is missed, for a terminal."""
    off = nominal.nearest.deviation
    within = f"{short_number(off.length, 2)} {unit} and {short_number(off.angle, 2)} rad"
    part = f"{round(100.0 * nominal.certain)} % of random poses"
    return f"first, for {part}: the closed form of an arm within {within}, and Newton steps"


def _order(nominal: Nominal) -> Prose:
    """The joints in the order in which steps give them."""
    found = [each.text for each in nominal.solver.body if isinstance(each, Heading)]
    numbers = dict.fromkeys(int(text[5]) for text in found if text[:5] == "theta")
    return joined([say("{}", _angle(number)) for number in numbers])


def _table(nearest: Nearest) -> Table:
    table = nearest.table
    rows = [
        (
            say(f"{place + 1}"),
            *_cells(place, table.d[place], table.a[place]),
            _twist(nearest, place),
        )
        for place in range(len(table.alpha))
    ]
    last = (
        say(f"{table.joints}"),
        *_cells(table.joints - 1, 0.0, 0.0),
        say("{}", Symbol("0", "0")),
    )
    header = (say("joint"), *(say("{}", Symbol(*column)) for column in _COLUMNS))
    return Table(header, (*rows, last))


def _cells(place: int, d: float, a: float) -> tuple[Prose, ...]:
    return say("{}", _angle(place + 1)), _number(d), _number(a)


def _angle(number: int) -> Symbol:
    return Symbol(rf"\theta_{number}", f"θ{number}")


def _twist(nearest: Nearest, place: int) -> Prose:
    quarter = nearest.table.quarters[place]
    if quarter is None:
        return _number(nearest.table.alpha[place])
    return say("{}", Symbol(*_TWISTS[quarter]))


def _number(value: float) -> Prose:
    text = short_number(value, DIGITS) if value else "0"
    return say("{}", Symbol(text, text.replace("-", "−")))
