"""Python of the nearest arm with a structure: its regular poses, and its numbers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.targets.python.formulas import Formulas, formulas_of

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
        left: What stands before a pose to make it this arm's.
        right: What stands behind it.
        offsets: What its angles are more than those of the loop.
    """

    formulas: Formulas
    filled: int
    left: str
    right: str
    offsets: str


def python_nearest(module: SolverModule, flat: Flat) -> PythonNearest:
    """What the templates name of it."""
    assert module.nominal is not None
    nearest, formulas = module.nominal.nearest, formulas_of(flat, 0)
    values = {value for group in flat.groups for value in group}
    return PythonNearest(
        formulas=formulas,
        filled=len(values) + len(flat.choices),
        left=repr(_twelve(nearest.left)),
        right=repr(_twelve(nearest.right)),
        offsets=repr(nearest.offsets),
    )


def _twelve(frame: Matrix) -> tuple[float, ...]:
    """The upper three rows, one after another."""
    return tuple(x for each in frame[:3] for x in each)
