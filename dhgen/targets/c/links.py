"""The table of a robot's links in C, and what the frames of these are computed from."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.runtime.python.frames import IDENTITY
from dhgen.targets.layout import INDENT, c_array
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
        links: What the runtime's `struct dhgen_links` holds, and what that names, as lines.
        moved: The rows' angles and lengths, where drives move more rows than there are drives.
    """

    about: str
    rows: Sequence[str]
    width: int
    links: Sequence[str]
    moved: Sequence[str]

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
        c_array(f"DHGEN_TABLE double {name}[{len(numbers)}]", map(repr, numbers))
        for name, numbers in named.items()
        if numbers
    ]
    others += [_kinds(table)] if has_passive else []
    pointers = [name if numbers else "NULL" for name, numbers in named.items()]
    kind, joints = f"DHGEN_{table.convention.upper()}", "row_kinds" if has_passive else "joints"
    held = ", ".join([str(len(table.rows)), kind, joints, "&table[0][0]", *pointers])
    return CLinks(
        about=about_table(module, " * "),
        rows=[f"{{ {', '.join(map(repr, row))} }}," for row in table.rows],
        width=len(table.rows[0]),
        links=[*others, f"DHGEN_TABLE struct dhgen_links links = {{ {held} }};"],
        moved=_moved(table) if has_passive else (),
    )


def _kinds(table: LinkTable) -> str:
    """How rows move, passive ones among them."""
    kinds = [f"{{ 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, {int(kind == 'R')} }}" for kind in table.types]
    return c_array(f"DHGEN_TABLE struct dhgen_joint row_kinds[{len(kinds)}]", kinds)


def _moved(table: LinkTable) -> list[str]:
    """The rows' angles and lengths."""
    text = c_array(f"const double moved[{len(table.rows)}]", map(_sum, table.drives))
    return [f"{INDENT}{line}" for line in text.splitlines()]


def _sum(factors: Sequence[float]) -> str:
    """What a row has of the drives: q[2] - q[1]."""
    text = ""
    for place, factor in enumerate(factors):
        if factor:
            times = "" if abs(factor) == 1.0 else f"{abs(factor)!r} * "
            sign = (" - " if factor < 0.0 else " + ") if text else "-" * (factor < 0.0)
            text += f"{sign}{times}q[{place}]"
    return text
