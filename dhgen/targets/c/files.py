"""The header and the source of a robot: what their templates name in C only."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.kinematics.turns import coupled_turns
from dhgen.printing.templates import named, render
from dhgen.program.walk import finds_roots, general_kernel, reads, whole_arm
from dhgen.targets.c.calls import Prototypes, c_prototypes
from dhgen.targets.c.descents import c_descents
from dhgen.targets.c.fitting import fitted
from dhgen.targets.c.general import general_sizes, general_source
from dhgen.targets.c.language import C, entry_lines
from dhgen.targets.c.links import CLinks, c_links
from dhgen.targets.c.motion import Motion, motion_of
from dhgen.targets.c.nearest import CNearest, c_nearest, nearest_flats
from dhgen.targets.c.regular import CRegular, flats_of, regular_values
from dhgen.targets.c.runtime import in_one_file
from dhgen.targets.c.single_precision import in_single_precision
from dhgen.targets.c.table import CTable, c_table
from dhgen.targets.c.texts import CComments, CTables, c_comments, c_tables
from dhgen.targets.coupled import CCoupling, c_coupling
from dhgen.targets.layout import INDENT, packed
from dhgen.targets.module import regular_solver
from dhgen.targets.solver.bodies import Bodies, bodies_of
from dhgen.targets.solver.common import common_of
from dhgen.tolerances import SINGLE

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.targets.module import SolverModule


# Of the functions for regular poses with all branches written out [bytes].
LONGEST = 19_000
INTERFACE = 1  # of the runtime: DHGEN_INTERFACE


@dataclass(frozen=True, slots=True)
class CRuntime:
    """How a robot's file brings the runtime along: lines before it, and its interface's number."""

    lines: Sequence[str]
    interface: int = INTERFACE


@dataclass(frozen=True, slots=True)
class CSolver:
    """What the templates of a solver name in C only.

    Attributes:
        comments: The files' comments.
        tables: Definitions of constants.
        links: The table of its links; not in single precision, which is for small controllers.
        table: Of the arm, for the runtime.
        entries: What gives the pose's entries their names, as lines.
        unused: Parameters of the solver that it does not need.
        prototypes: Functions without their bodies.
        motion: Defines what forward kinematics and the Jacobian begin with, where that is apart.
        bodies: The programs.
        whole: The call that finds all joints at once, where that is done.
        general: The table of the general algorithm, where that solves the arm.
        descents: The table of least squares, where these do or may complete rows.
        coupling: Of drives whose whole turns hang together, where some do.
        regular: The code of regular poses, where there is a program for them.
        nearest: The nearest arm with a structure, where its rows are tried first.
        suffices: Whether these may solve a pose alone: what several drives do together, or drives
            to several joints, is done around the general algorithm.
        runtime: How it is brought along.
    """

    comments: CComments
    tables: CTables
    links: CLinks | None
    table: CTable
    entries: Sequence[str]
    unused: Sequence[str]
    prototypes: Prototypes
    motion: Sequence[str]
    bodies: Bodies
    whole: str
    general: str
    descents: str
    coupling: CCoupling | None
    regular: CRegular | None
    nearest: CNearest | None
    suffices: bool
    runtime: CRuntime


def c_files(module: SolverModule, *, single_file: bool = False) -> dict[str, str]:
    """The header and the source by their names; the source may hold what it needs of the runtime.

    Branches written out are fast. Where that is long, branches in lanes of poses are in loops, and
    what they have in common with branches in lanes is written once.
    """
    regular = regular_solver(module)
    if regular is None:
        return c_texts(module, in_loops=False, single_file=single_file)
    written_out = regular_values(module, flats_of(regular, in_loops=False))
    lines = (*written_out.wide, *written_out.one)
    in_loops = sum(map(len, lines)) > LONGEST
    return c_texts(module, in_loops=in_loops, single_file=single_file)


def c_texts(module: SolverModule, *, in_loops: bool, single_file: bool = False) -> dict[str, str]:
    """The files' texts, with branches written out or in loops."""
    common = common_of(module)
    solver = c_solver(module, in_loops=in_loops)
    texts = {
        f"{module.name}.h": fitted(render("c/solver.h.jinja", **named(common), **named(solver))),
        f"{module.name}.c": fitted(render("c/solver.c.jinja", **named(common), **named(solver))),
    }
    if module.precision is SINGLE:
        pasted = {name: in_one_file(text, vectors=False) for name, text in texts.items()}
        return {name: fitted(in_single_precision(text)) for name, text in pasted.items()}
    if single_file:
        return {name: in_one_file(text, vectors=True) for name, text in texts.items()}
    return texts


def c_solver(module: SolverModule, *, in_loops: bool) -> CSolver:
    """What the templates name of a robot.

    Args:
        module: The robot.
        in_loops: Whether its regular poses go through branches in loops, and what functions have
            in common is written once: that is shorter.
    """
    regular = regular_solver(module)
    flats = None if regular is None else flats_of(regular, in_loops=in_loops)
    near = nearest_flats(module, LONGEST)
    used = flats or near
    programs = () if used is None else used.programs
    descents, kernel = c_descents(module), general_kernel(module.solver)
    motion = motion_of(module) if in_loops else Motion((), module)
    coupling = c_coupling(module)
    is_alone = coupling is None and not module.chain.drives.are_coupled
    return CSolver(
        comments=c_comments(module),
        tables=c_tables(module, programs),
        links=None if module.precision is SINGLE else c_links(module),
        table=c_table(module),
        entries=entry_lines(module.solver),
        unused=_unused(module),
        prototypes=c_prototypes(module),
        motion=motion.macro,
        bodies=bodies_of(motion.module, C(), _assignments, entry_lines),
        whole=_whole(module),
        general="" if kernel is None else general_source(kernel),
        descents="" if descents is None else render("c/descents.c.jinja", descents=descents),
        coupling=coupling,
        regular=regular_values(module, flats) if flats else None,
        nearest=c_nearest(module, near),
        suffices=near is not None and is_alone,
        runtime=CRuntime(brought_along(module, regular=used is not None)),
    )


def brought_along(
    module: SolverModule, *, regular: bool, first: Sequence[str] = (), last: Sequence[str] = ()
) -> list[str]:
    """The lines that choose which parts of the runtime are needed, and in what sizes.

    Args:
        module: The robot.
        regular: Whether it has a program for regular poses.
        first: Headers before those that its solver needs.
        last: Headers behind them.
    """
    upper, solver = module.name.upper(), module.solver
    single = ["SINGLE_PRECISION", "SCALAR"] if module.precision is SINGLE else []
    switches = ["LIBM"] if single else ["SCALAR", "LIBM"]
    headers = [*first, "ik", "velocities", *(["circle_roots"] if finds_roots(solver) else [])]
    headers += [] if single else ["frames"]
    headers += ["complete"] if solver.completion is not None else []
    headers += ["coupled"] if coupled_turns(module.chain) is not None else []
    kernel = general_kernel(solver)
    if whole_arm(solver) is not None:
        headers += ["numerical" if kernel is None else "general"]
    headers += ["general/near"] if module.nominal is not None else []
    headers += last
    return [
        *(f"#define DHGEN_{each}" for each in single),
        *(line for each in switches if regular for line in switch(upper, each)),
        f"#define DHGEN_DOF {module.chain.dof}",
        f"#define DHGEN_ROWS {solver.rows}",
        *([] if kernel is None else general_sizes(upper, kernel)),
        *(f'#include "dhgen/{each}.h"' for each in headers),
        *([f"#ifndef {upper}_PLAIN", '#include "dhgen/tile.h"', "#endif"] if regular else []),
    ]


def switch(upper: str, name: str) -> list[str]:
    """A switch of the robot's own sets the runtime's switch."""
    head = f"#if defined({upper}_{name}) && !defined(DHGEN_{name})"
    return [head, f"#define DHGEN_{name}", "#endif"]


def _unused(module: SolverModule) -> list[str]:
    """A line that names the parameters of the solver that its program does not read."""
    solver = module.solver
    whole = whole_arm(solver)
    given = reads(solver, "free") or (whole is not None and whole.given)
    used = {"free_joints": given, "seed": reads(solver, "seed"), "moved": finds_roots(solver)}
    names = [name for name, needed in used.items() if not needed]
    return [" ".join(f"(void){name};" for name in names)] if names else []


def _whole(module: SolverModule) -> str:
    """The call that finds all joints at once; empty where a program does."""
    whole = whole_arm(module.solver)
    if whole is None:
        return ""
    given = "free_joints" if whole.given else "NULL"
    arms = "numerical_rows(" if whole.general is None else "general_rows(&general, "
    return f"dhgen_{arms}&descents, T, {given}, seed, rows, status);"


def _assignments(array: str, entries: list[str], columns: int) -> list[str]:
    """A matrix, one of its rows after another."""
    lines: list[str] = []
    for start in range(0, len(entries), columns):
        row = entries[start : start + columns]
        pieces = [f"{array}[{start + place}] = {entry};" for place, entry in enumerate(row)]
        lines += packed(pieces, INDENT)
    return lines
