"""The arrays of numbers: of the arm, and of the algorithm."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.general import circle, reference
from dhgen.general.digits import grid, harmonics
from dhgen.targets.general.numbers import rigid, row, rows

if TYPE_CHECKING:
    from dhgen.general.formulation import Formulation
    from dhgen.general.kernel import GeneralKernel

# Anything that no null vector is orthogonal to.
STARTS = ((0.61, -0.37, 0.53, 0.29, 0.71, -0.43), (-0.31, 0.47, 0.59, 0.67, -0.23, 0.41))


@dataclass(frozen=True, slots=True)
class FormulationText:
    """A formulation: its joints from 0, and the sign with which it reads the loop."""

    joints: str
    sign: str


@dataclass(frozen=True, slots=True)
class Tables:
    """Rows of numbers between commas.

    Attributes:
        constants: What links consist of, three rows of four.
        constant_count: How many there are.
        advance_c: Cosines of what is added to the joints' angles in the loop.
        advance_s: Their sines.
        formulations: In the order in which they are tried.
        formulation_count: How many there are.
        nudges: From a pose to poses close by, three rows of four.
        nudge_count: How many there are.
        sample_c: Cosines of the sample angles.
        sample_s: Their sines.
        harmonics: From samples to coefficients.
        grid_c: Cosines of the multiples of the grid's angles.
        grid_s: Their sines.
        start: Where the iteration for a null vector starts.
        starts: Where it starts for two.
    """

    constants: tuple[str, ...]
    constant_count: int
    advance_c: str
    advance_s: str
    formulations: tuple[FormulationText, ...]
    formulation_count: int
    nudges: tuple[str, ...]
    nudge_count: int
    sample_c: str
    sample_s: str
    harmonics: tuple[str, ...]
    grid_c: tuple[str, ...]
    grid_s: tuple[str, ...]
    start: str
    starts: tuple[str, ...]


def tables(kernel: GeneralKernel) -> Tables:
    """The arrays of an arm."""
    constants = tuple(rigid(K) for link in kernel.links for K in link.constants)
    nudges = tuple(map(rigid, reference.nudges()))
    sample_c, sample_s = map(row, circle.sample_cosines())
    grid_c, grid_s = map(rows, grid())
    return Tables(
        constants=constants,
        constant_count=len(constants),
        advance_c=row(c for c, _ in kernel.loop.advances),
        advance_s=row(s for _, s in kernel.loop.advances),
        formulations=tuple(map(_formulation, kernel.formulations)),
        formulation_count=len(kernel.formulations),
        nudges=nudges,
        nudge_count=len(nudges),
        sample_c=sample_c,
        sample_s=sample_s,
        harmonics=rows(harmonics()),
        grid_c=grid_c,
        grid_s=grid_s,
        start=row(STARTS[0]),
        starts=rows(STARTS),
    )


def _formulation(formulation: Formulation) -> FormulationText:
    return FormulationText(row(formulation.joints), repr(float(formulation.sign)))
