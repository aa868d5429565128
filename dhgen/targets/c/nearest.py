"""C of the nearest arm with a structure: its regular poses, and its numbers."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from dhgen.targets.c.regular import CRegular, Flats, flats_of, regular_values
from dhgen.targets.general.numbers import rigid, row, rows
from dhgen.targets.solver.given import given_of
from dhgen.targets.solver.nearest import APART, nearest_angles

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.program.regular.unguarded import Regular
    from dhgen.targets.module import SolverModule
    from dhgen.targets.solver.given import Given


@dataclass(frozen=True, slots=True)
class CNearest:
    """The nearest arm with a structure.

    Attributes:
        regular: Its regular poses.
        given: What its closed form is given besides the pose: what the caller gives, and by how
            much the two arms' tools differ at most.
        rows: How many rows it has.
        turned: By how much the tools are turned at most [rad].
        moved: By how much they are apart.
        left: The left factor that makes a pose this arm's.
        right: The right factor.
        offsets: Its angles minus the loop's.
        places: Of the joints that are solved for among all.
        link_count: How many links it has.
        links: C0 ... Cn of its pose C0 Rz(angle 1) C1 ... Rz(angle n) Cn.
        angles: Each as the factors of all joint values, and what is added.
    """

    regular: CRegular
    given: Given
    rows: int
    turned: float
    moved: float
    left: str
    right: str
    offsets: str
    places: str
    link_count: int
    links: Sequence[str]
    angles: Sequence[str]


def nearest_module(module: SolverModule) -> SolverModule | None:
    """The nearest arm as a module of its own."""
    nominal = module.nominal
    if nominal is None:
        return None
    return replace(module, chain=nominal.chain, solver=nominal.solver, nominal=None)


def nearest_flats(module: SolverModule, longest: int) -> Flats | None:
    """What its regular poses compute: branches written out, or in loops where that is longer."""
    own, nominal = nearest_module(module), module.nominal
    return None if own is None or nominal is None else flats_within(nominal.regular, own, longest)


def flats_within(regular: Regular, own: SolverModule, longest: int) -> Flats:
    """What regular poses of an arm compute: branches in loops where written out they are longer."""
    out = flats_of(regular, in_loops=False)
    written = regular_values(own, out)
    is_long = sum(map(len, (*written.wide, *written.one))) > longest
    return flats_of(regular, in_loops=True) if is_long else out


def c_nearest(module: SolverModule, flats: Flats | None) -> CNearest | None:
    """What the templates name of it."""
    own, nominal = nearest_module(module), module.nominal
    if own is None or nominal is None or flats is None:
        return None
    nearest = nominal.nearest
    turned, moved = nearest.deviation.ball
    return CNearest(
        regular=replace(
            regular_values(own, flats),
            rows=own.solver.rows,
        ),
        given=replace(given_of(own.chain), count=own.chain.given + APART),
        rows=own.solver.rows,
        turned=turned,
        moved=moved,
        left=rigid(nearest.left),
        right=rigid(nearest.right),
        offsets=row([nearest.offsets[place] for place in own.chain.solved_places]),
        places=", ".join(map(str, own.chain.solved_places)),
        link_count=len(nearest.links),
        links=[rigid(link) for link in nearest.links.tolist()],
        angles=rows(nearest_angles(module.chain)),
    )
