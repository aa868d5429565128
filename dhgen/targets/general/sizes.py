"""How much room the algorithm takes, and how often it repeats what it does."""

from __future__ import annotations

from dataclasses import dataclass

from dhgen.general import circle, reference
from dhgen.general.digits import HALF_CELLS
from dhgen.general.roots import LOOKS, REACH

ROOTS = 24  # more than 16 come from rounding
WAITING = 16  # twice as many as there are lanes at most
QUINTIC_STEPS = 4  # from a start that is nearly right; the function itself corrects the rest
BATCHES = 16  # of starts where everything else fails


@dataclass(frozen=True, slots=True)
class Sizes:
    """Lengths of arrays and ends of loops.

    Attributes:
        samples: Angles at which the determinant is sampled.
        harmonics: Coefficients of a polynomial of its degree; others are noise.
        cells: Parts of the circle.
        half_cells: Of half the circle.
        edges_in_lanes: The same with room for a vector that begins at the last one.
        width: Of a cell [rad].
        deepest: How often a cell is halved.
        open_cells: Parts of a cell that wait at most to be halved.
        waiting: Parts of the circle that wait at most to be solved together.
        parts: Those with the two halves of as many others.
        halvings: Of all cells together.
        quintic_steps: On a polynomial that stands for the function.
        careful_steps: On the function itself.
        roots: Of each kind that are kept.
        looks: How often places are looked at again.
        reach: Cells that a closer look has on both sides.
        parabolas: That tell two roots where they nearly meet.
        candidates: For joint angles.
        places: For what candidates lead to: near a singular solution, many.
        steps: Of the polish from a candidate.
        steps_from_afar: Of the polish from anywhere.
        batches: Of starts, in lanes.
    """

    samples: int = circle.SAMPLES
    harmonics: int = 2 * circle.DEGREE + 1
    cells: int = circle.CELLS
    half_cells: int = HALF_CELLS
    edges_in_lanes: int = circle.CELLS + 8
    width: float = circle.WIDTH
    deepest: int = circle.DEEPEST
    open_cells: int = circle.DEEPEST + 2
    waiting: int = WAITING
    parts: int = 3 * WAITING
    halvings: int = circle.HALVINGS
    quintic_steps: int = QUINTIC_STEPS
    careful_steps: int = 4 * circle.NEWTON_STEPS
    roots: int = ROOTS
    looks: int = LOOKS
    reach: int = REACH
    parabolas: int = reference.PARABOLAS
    candidates: int = 6 * ROOTS
    places: int = reference.PLACES
    steps: int = reference.STEPS
    steps_from_afar: int = reference.STEPS_FROM_AFAR
    batches: int = BATCHES
