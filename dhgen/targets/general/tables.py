"""The arrays of numbers: of the arm, and of the algorithm."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.general import circle, reference
from dhgen.general.digits import grid, harmonics
from dhgen.targets.general.left import constant_left
from dhgen.targets.general.numbers import rigid, row, rows

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel

# Anything that no null vector is orthogonal to.
STARTS = ((0.61, -0.37, 0.53, 0.29, 0.71, -0.43), (-0.31, 0.47, 0.59, 0.67, -0.23, 0.41))


@dataclass(frozen=True, slots=True)
class FormulationText:
    """A formulation.

    Attributes:
        joints: Its joints from 0.
        sign: With which it reads the loop.
        left: The features of its left side, if they are constant.
        left_name: What C calls them.
    """

    joints: str
    sign: str
    left: tuple[str, ...]
    left_name: str


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
        with_left: Those in which the left side's features are constant.
        every_left: Whether they are in all.
        lengths: Whether what a slide makes of features is still to be computed.
        on_circle: And of one that is hidden.
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
    with_left: tuple[FormulationText, ...]
    every_left: bool
    lengths: bool
    on_circle: bool
    nudges: tuple[str, ...]
    nudge_count: int
    sample_c: str
    sample_s: str
    harmonics: tuple[str, ...]
    grid_c: tuple[str, ...]
    grid_s: tuple[str, ...]
    start: str
    starts: tuple[str, ...]


def tables(kernel: GeneralKernel, name: str) -> Tables:
    """The arrays of an arm."""
    formulations = tuple(
        _formulation(kernel, name, number) for number in range(len(kernel.formulations))
    )
    every_left = all(each.left for each in formulations)
    constants = tuple(rigid(K) for link in kernel.links for K in link.constants)
    nudges = tuple(map(rigid, reference.nudges()))
    sample_c, sample_s = map(row, circle.sample_cosines())
    grid_c, grid_s = map(rows, grid())
    return Tables(
        constants=constants,
        constant_count=len(constants),
        advance_c=row(c for c, _ in kernel.loop.advances),
        advance_s=row(s for _, s in kernel.loop.advances),
        formulations=formulations,
        formulation_count=len(kernel.formulations),
        with_left=tuple(each for each in formulations if each.left),
        every_left=every_left,
        lengths=bool(kernel.loop.slides) and (kernel.slides_on_the_right or not every_left),
        on_circle=kernel.hides_a_slide and not every_left,
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


def _formulation(kernel: GeneralKernel, name: str, number: int) -> FormulationText:
    formulation = kernel.formulations[number]
    left = constant_left(kernel, formulation)
    return FormulationText(
        joints=row(formulation.joints),
        sign=repr(float(formulation.sign)),
        left=left,
        left_name=f"{name}_left_{number}" if left else "0",
    )
