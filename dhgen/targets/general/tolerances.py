"""The tolerances of the algorithm."""

from __future__ import annotations

from dataclasses import dataclass

from dhgen.general import circle, lens, polish, recover, reference, roots
from dhgen.general.determinant import TINY
from dhgen.general.four_turns import ALONG, FARTHEST, MOVED, NEARLY_FLAT, NO_ANGLE, PARALLEL
from dhgen.kinematics.order import TIE
from dhgen.tolerances import TOLERANCES


@dataclass(frozen=True, slots=True)
class Tolerances:
    """Every tolerance as text; what they mean stands where they come from."""

    tiny: str = repr(TINY)
    huge: str = repr(1.0 / TINY)
    settled: str = repr(circle.SETTLED)
    settled_extremum: str = repr(circle.SETTLED_EXTREMUM)
    quintic: str = repr(circle.QUINTIC)
    cubic: str = repr(circle.CUBIC)
    rounding: str = repr(circle.ROUNDING)
    noise_factor: str = repr(circle.NOISE_FACTOR)
    fourfold: str = repr(circle.FOURFOLD)
    lifted: str = repr(0.5 * circle.LIFTED**2)  # the value of a parabola over its bend
    lifted_closer: str = repr(0.5 * (circle.LIFTED / roots.NEAR) ** 2)
    near: str = repr(roots.COSINE)
    strength: str = repr(roots.STRENGTH)
    regular: str = repr(1.0 / reference.REGULAR**2)  # all over the smallest, squared
    alone: str = repr(1.0 / reference.ALONE**2)  # all over the second smallest, squared
    crowded: str = repr(lens.CROWDED**2)  # its square
    strongest: str = repr(lens.STRONGEST)
    mean_per_harmonic: str = repr(lens.MEAN_PER_HARMONIC)
    vanishing: str = repr(lens.VANISHING)
    noise: str = repr(roots.NOISE)
    clear: str = repr(roots.CLEAR)
    residual: str = repr(TOLERANCES.polished)
    exact: str = repr(TOLERANCES.exact)
    together: str = repr(reference.TOGETHER)
    same: str = repr(reference.SAME)
    close: str = repr(4.0 - reference.CLOSE**2)  # the square of the sum of two such unit vectors
    tie: str = repr(TIE)  # of joint values, when rows are sorted
    rank: str = repr(polish.RANK)
    singular: str = repr(polish.SINGULAR)
    good_enough: str = repr(polish.GOOD_ENOUGH)
    nearly_flat: str = repr(NEARLY_FLAT)
    along: str = repr(ALONG)
    no_angle: str = repr(NO_ANGLE)
    moved: str = repr(MOVED)
    farthest: str = repr(FARTHEST)
    parallel: str = repr(PARALLEL)
    smallest: str = repr(recover.SMALLEST)
    smallest_square: str = repr(polish.SMALLEST_SQUARE)
    damping: str = repr(polish.DAMPING)
    plane: str = repr(recover.PLANE)
