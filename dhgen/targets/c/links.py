"""The table of a robot's links in C, and what the frames of these are computed from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.runtime.python.frames import IDENTITY
from dhgen.targets.layout import INDENT, c_array, wrapped
from dhgen.targets.solver.links import about_table

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.kinematics.link_table import LinkTable
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class CLinks:
    """The links of a robot.

    Attributes:
        about: What the rows of the table are.
        rows: Its rows.
        width: How many numbers a row has.
        others: Definitions beside it, indented.
        links: What the runtime's `struct dhgen_links` holds, as lines.
        values: The array that the rows' angles and lengths are in, or made of by their drives.
    """

    about: str
    rows: Sequence[str]
    width: int
    others: Sequence[str]
    links: Sequence[str]
    values: str

    @property
    def count(self) -> int:
        """How many rows there are."""
        return len(self.rows)


def c_links(module: SolverModule) -> CLinks:
    """The links of a robot."""
    table = module.links
    has_passive = len(table.rows) > module.chain.dof
    drives = () if has_passive else tuple(factor for row in table.drives for factor in row)
    base, tool = ((() if frame == IDENTITY else frame) for frame in (table.base, table.tool))
    named = {"drives": drives, "base": base, "tool": tool}
    others = [
        line
        for name, numbers in named.items()
        if numbers
        for line in _array(name, numbers).splitlines()
    ]
    joints, values = "joints", "q"
    if has_passive:
        others = [*_rows(table), *others]
        joints, values = "rows", "moved"
    pointers = [name if numbers else "NULL" for name, numbers in named.items()]
    kind = f"DHGEN_{table.convention.upper()}"
    held = ", ".join([str(len(table.rows)), kind, joints, "&table[0][0]", *pointers])
    return CLinks(
        about=about_table(module, " * "),
        rows=[f"{{ {', '.join(map(repr, row))} }}," for row in table.rows],
        width=len(table.rows[0]),
        others=others,
        links=wrapped(f"{INDENT}static const struct dhgen_links links = {{ {held} }};", INDENT),
        values=values,
    )


def _rows(table: LinkTable) -> list[str]:
    """How rows move, passive ones among them, and their values."""
    count = len(table.rows)
    kinds = [f"{{ 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, {int(kind == 'R')} }}" for kind in table.types]
    moved = [_sum(row) for row in table.drives]
    texts = [
        c_array(f"static const struct dhgen_joint rows[{count}]", kinds),
        c_array(f"const double moved[{count}]", moved),
    ]
    return [f"{INDENT}{line}" for text in texts for line in text.splitlines()]


def _sum(factors: Sequence[float]) -> str:
    """What a row has of the drives: q[2] - q[1]."""
    text = ""
    for place, factor in enumerate(factors):
        if factor:
            times = "" if abs(factor) == 1.0 else f"{abs(factor)!r} * "
            sign = (" - " if factor < 0.0 else " + ") if text else "-" * (factor < 0.0)
            text += f"{sign}{times}q[{place}]"
    return text


def _array(name: str, numbers: Sequence[float]) -> str:
    text = c_array(f"static const double {name}[{len(numbers)}]", map(repr, numbers))
    return "\n".join(f"{INDENT}{line}" for line in text.splitlines())
