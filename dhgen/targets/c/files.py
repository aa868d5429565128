"""The header and the source of a robot: what their templates name in C only."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.printing.templates import named, render
from dhgen.targets.angles import Angles
from dhgen.targets.c.arctangent import CArctangent
from dhgen.targets.c.calls import CCalls, Prototypes, c_calls, c_prototypes
from dhgen.targets.c.entries import entry_lines, entry_texts
from dhgen.targets.c.fitting import fitted
from dhgen.targets.c.language import C
from dhgen.targets.c.motion import Motion, motion_of
from dhgen.targets.c.regular import CRegular, flats_of, regular_values
from dhgen.targets.c.single_precision import in_single_precision
from dhgen.targets.c.texts import CComments, CPose, CTables, c_comments, c_pose, c_tables
from dhgen.targets.layout import INDENT, packed
from dhgen.targets.module import regular_solver
from dhgen.targets.solver.bodies import Bodies, bodies_of
from dhgen.targets.solver.common import common_of
from dhgen.targets.solver.parts import Parts, parts_of
from dhgen.targets.writing import IN_C
from dhgen.tolerances import SINGLE

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.targets.module import SolverModule
    from dhgen.targets.solver.common import Common


LONGEST = 60_000  # of a source whose branches are all written out [bytes]


@dataclass(frozen=True, slots=True)
class CSolver:
    """What the templates of a solver name in C only.

    Attributes:
        comments: What the files say of themselves.
        tables: Definitions of constants.
        pose: How a pose is read.
        prototypes: Functions without their bodies.
        calls: How they are called.
        motion: Defines what forward kinematics and the Jacobian begin with, where that is apart.
        bodies: The programs.
        parts: Functions that have templates of their own.
        regular: What serves regular poses, where there is a program for them.
        angles: Parts of a turn.
        arctangent: What it is made of where regular poses need it.
    """

    comments: CComments
    tables: CTables
    pose: CPose
    prototypes: Prototypes
    calls: CCalls
    motion: Sequence[str]
    bodies: Bodies
    parts: Parts
    regular: CRegular | None
    angles: Angles
    arctangent: CArctangent


def c_files(module: SolverModule) -> dict[str, str]:
    """The header and the source by their names.

    Branches written out are fast. Where that is long, those in lanes of poses stand in loops, and
    what they have in common with branches in lanes is written once.
    """
    texts = c_texts(module, in_loops=False)
    long = len(texts[f"{module.name}.c"]) > LONGEST
    if long and regular_solver(module) is not None:
        return c_texts(module, in_loops=True)
    return texts


def c_texts(module: SolverModule, *, in_loops: bool) -> dict[str, str]:
    """The same by one of the two ways."""
    common = common_of(module)
    solver = c_solver(module, common, in_loops=in_loops)
    texts = {
        f"{module.name}.h": fitted(render("c/solver.h.jinja", **named(common), **named(solver))),
        f"{module.name}.c": fitted(render("c/solver.c.jinja", **named(common), **named(solver))),
    }
    if module.precision is SINGLE:
        return {name: fitted(in_single_precision(text)) for name, text in texts.items()}
    return texts


def c_solver(module: SolverModule, common: Common, *, in_loops: bool) -> CSolver:
    """What the templates name of a robot.

    Args:
        module: The robot.
        common: What every language says of it.
        in_loops: Whether its regular poses go through branches in loops, and what functions have
            in common is written once: that is shorter.
    """
    regular = regular_solver(module)
    flats = None if regular is None else flats_of(regular, in_loops=in_loops)
    programs = () if flats is None else flats.programs
    calls = c_calls(module)
    motion = motion_of(module) if in_loops else Motion((), module)
    return CSolver(
        comments=c_comments(module),
        tables=c_tables(module, programs),
        pose=c_pose(module, entry_texts(module, programs)),
        prototypes=c_prototypes(module),
        calls=calls,
        motion=motion.macro,
        bodies=bodies_of(motion.module, C(), _assignments, entry_lines),
        parts=parts_of(module, common, calls, IN_C),
        regular=regular_values(module, flats) if flats else None,
        angles=Angles(),
        arctangent=CArctangent(),
    )


def _assignments(array: str, entries: list[str], columns: int) -> list[str]:
    """A matrix, one of its rows after another."""
    lines: list[str] = []
    for start in range(0, len(entries), columns):
        row = entries[start : start + columns]
        pieces = [f"{array}[{start + place}] = {entry};" for place, entry in enumerate(row)]
        lines += packed(pieces, INDENT)
    return lines
