"""Python of the nearest arm with a structure: its regular poses, and its numbers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.targets.layout import INDENT
from dhgen.targets.python.formulas import Formulas, formulas_of
from dhgen.targets.python.literal import fields_of
from dhgen.targets.solver.nearest import APART, nearest_angles

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.kinematics.rigid import Matrix
    from dhgen.program.regular.flatten import Flat
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class PythonNearest:
    """The nearest arm with a structure.

    Attributes:
        formulas: Its regular poses.
        fields: Its numbers by their names, as lines.
    """

    formulas: Formulas
    fields: Sequence[str]


def python_nearest(module: SolverModule, flat: Flat) -> PythonNearest:
    """What the templates name of it."""
    assert module.nominal is not None
    nearest, chain = module.nominal.nearest, module.nominal.chain
    solved = chain.solved_places
    turned, moved = nearest.deviation.ball
    numbers: dict[str, object] = {
        "turned": turned,
        "moved": moved,
        "left": _twelve(nearest.left),
        "right": _twelve(nearest.right),
        "offsets": tuple(nearest.offsets[place] for place in solved),
        "solved": solved,
        "links": tuple(_twelve(link) for link in nearest.links.tolist()),
        "angles": tuple(map(tuple, nearest_angles(module.chain))),
    }
    return PythonNearest(
        formulas=formulas_of(flat, chain.given + APART),
        fields=fields_of(numbers.items(), {}, INDENT * 2),
    )


def _twelve(frame: Matrix) -> tuple[float, ...]:
    """The upper three rows, one after another."""
    return tuple(x for each in frame[:3] for x in each)
