"""C of the driven joints alone: a leg's program for regular poses without what no drive needs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.legs.robot import inverse
from dhgen.program.regular.flatten import flatten
from dhgen.targets.c.files import LONGEST
from dhgen.targets.c.language import entry_lines
from dhgen.targets.c.regular import best_lanes
from dhgen.targets.c.table import c_table
from dhgen.targets.c.texts import local_constants
from dhgen.targets.c.wide import wide_lines
from dhgen.targets.layout import INDENT, listed
from dhgen.targets.module import regular_solver

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.parallel.module import LegModule, ParallelModule
    from dhgen.program.regular.flatten import Flat

LANES = 8  # at most: tables by legs go on behind the last one, so that all can be read


@dataclass(frozen=True, slots=True)
class DrivenChain:
    """The function of a chain.

    Attributes:
        name: Of the chain.
        number: Of the chain, from 0.
        lines: The function's body; none where the chain has no program for regular poses.
    """

    name: str
    number: int
    lines: Sequence[str]


@dataclass(frozen=True, slots=True)
class Driven:
    """The driven joints of a robot.

    Attributes:
        drives: Of the leg with the most.
        chains: Of every chain its function.
        count: How many chains there are.
        ends: How many numbers `first` has: one more.
        first: The place of each chain's first leg among `legs`, and of none behind the last.
        legs: The legs, chain by chain, from 0, and the last one again for lanes behind it.
        base: The lines of a table: from the robot's base to those of the legs, an entry a line.
        end: The same of what they carry.
    """

    drives: int
    chains: Sequence[DrivenChain]
    count: int
    ends: int
    first: str
    legs: str
    base: Sequence[str]
    end: Sequence[str]


def driven(module: ParallelModule) -> Driven:
    """What the template names."""
    by_chain: dict[str, list[int]] = {}
    for number, leg in enumerate(module.legs):
        by_chain.setdefault(leg.solver.name, []).append(number)
    legs = [number for numbers in by_chain.values() for number in numbers]
    first = [0]
    for numbers in by_chain.values():
        first.append(first[-1] + len(numbers))
    in_lanes = [*legs, *legs[-1:] * (LANES - 1)]
    padded = [module.legs[number].leg for number in in_lanes]
    return Driven(
        drives=module.driven,
        chains=[
            DrivenChain(name, number, _body(module.legs[numbers[0]], module.driven))
            for number, (name, numbers) in enumerate(by_chain.items())
        ],
        count=len(by_chain),
        ends=len(first),
        first=", ".join(map(str, first)),
        legs=", ".join(map(str, in_lanes)),
        base=_columns(inverse(leg.base) for leg in padded),
        end=_columns(leg.end for leg in padded),
    )


def _body(leg: LegModule, drives: int) -> list[str]:
    """The values of the driven joints, as the leg's own solver takes them at regular poses.

    What may make a pose one that needs care is all of it, and limits are those of all joints: rows
    have the statuses that they have with passive joints.
    """
    sliced = regular_solver(leg.solver, leg.driven)
    if sliced is None:
        return []

    out = _written(leg, flatten(sliced), drives)
    return _written(leg, best_lanes(sliced), drives) if sum(map(len, out)) > LONGEST else out


def _written(leg: LegModule, flat: Flat, drives: int) -> list[str]:
    """A function's body with the constants that it needs."""
    entries = entry_lines(flat.program, "dhgen_wide")
    lines = wide_lines(leg.solver, flat, entries, stride=drives)
    tables = [*_limits(leg, lines), *local_constants(leg.solver, flat.program)]
    return [*(f"{INDENT}{line}" for line in tables), *lines]


def _limits(leg: LegModule, lines: Sequence[str]) -> list[str]:
    """The table of the joints, where limits are compared with."""
    if not any("joints" in line for line in lines):
        return []
    rows = [f"{INDENT}{row}" for row in c_table(leg.solver).joints]
    return [f"DHGEN_TABLE struct dhgen_joint joints[{len(rows)}] = {{", *rows, "};"]


def _columns(frames: Iterable[Sequence[float]]) -> list[str]:
    """Frames side by side, an entry a line."""
    lines: list[str] = []
    for entries in zip(*frames, strict=True):
        lines += [f"{INDENT}{{", *listed(list(map(repr, entries)), INDENT * 2), f"{INDENT}}},"]
    return lines
