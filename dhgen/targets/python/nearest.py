"""Python of the nearest arm with a structure: its regular poses, and its numbers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.targets.python.formulas import ENTRIES, Formulas, formulas_of

if TYPE_CHECKING:
    from dhgen.kinematics.rigid import Matrix
    from dhgen.program.regular.flatten import Flat
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class PythonNearest:
    """The nearest arm with a structure.

    Attributes:
        formulas: Its regular poses.
        filled: How many numbers these fill in: the joints' values, and a status for each row.
        given: How many values the caller gives.
        doubt: Where it is kept whether a pose is left to the general algorithm.
        left: What stands before a pose to make it this arm's.
        right: What stands behind it.
        offsets: What its angles are more than those of the loop.
        solved: The places of the joints that are solved for.
    """

    formulas: Formulas
    filled: int
    given: int
    doubt: int
    left: str
    right: str
    offsets: str
    solved: str


def python_nearest(module: SolverModule, flat: Flat) -> PythonNearest:
    """What the templates name of it."""
    assert module.nominal is not None
    nearest, chain = module.nominal.nearest, module.nominal.chain
    formulas, solved = formulas_of(flat, chain.given), chain.solved_places
    values = {value for group in flat.groups for value in group}
    return PythonNearest(
        formulas=formulas,
        filled=len(values) + len(flat.choices),
        given=chain.given,
        doubt=len(ENTRIES) + chain.given,
        left=repr(_twelve(nearest.left)),
        right=repr(_twelve(nearest.right)),
        offsets=repr(tuple(nearest.offsets[place] for place in solved)),
        solved=repr(solved),
    )


def _twelve(frame: Matrix) -> tuple[float, ...]:
    """The upper three rows, one after another."""
    return tuple(x for each in frame[:3] for x in each)
