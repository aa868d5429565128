"""The tolerances of the algorithm."""

from __future__ import annotations

from dataclasses import dataclass

from dhgen.general import circle, lens, polish, recover, reference, roots
from dhgen.general.determinant import TINY
from dhgen.general.four_turns import (
    ALIGNED,
    ALONG,
    FARTHEST,
    MOVED,
    NEARLY_FLAT,
    NO_ANGLE,
    PARALLEL,
)
from dhgen.kinematics.order import TIE
from dhgen.tolerances import TOLERANCES


@dataclass(frozen=True, slots=True)
class Tolerances:
    """Every tolerance; what they mean stands where they come from."""

    tiny: float = TINY
    huge: float = 1.0 / TINY
    settled: float = circle.SETTLED
    settled_extremum: float = circle.SETTLED_EXTREMUM
    quintic: float = circle.QUINTIC
    cubic: float = circle.CUBIC
    rounding: float = circle.ROUNDING
    noise_factor: float = circle.NOISE_FACTOR
    fourfold: float = circle.FOURFOLD
    lifted: float = 0.5 * circle.LIFTED**2  # the value of a parabola over its bend
    lifted_closer: float = 0.5 * (circle.LIFTED / roots.NEAR) ** 2
    beside: float = reference.BESIDE
    near: float = roots.COSINE
    strength: float = roots.STRENGTH
    regular: float = 1.0 / reference.REGULAR**2  # all over the smallest, squared
    alone: float = 1.0 / reference.ALONE**2  # all over the second smallest, squared
    independent: float = reference.INDEPENDENT**2  # the least singular value over all, squared
    crowded: float = lens.CROWDED**2  # its square
    strongest: float = lens.STRONGEST
    mean_per_harmonic: float = lens.MEAN_PER_HARMONIC
    vanishing: float = lens.VANISHING
    noise: float = roots.NOISE
    clear: float = roots.CLEAR
    residual: float = TOLERANCES.polished
    exact: float = TOLERANCES.exact
    same: float = reference.SAME
    together: float = reference.TOGETHER
    close: float = 4.0 - reference.CLOSE**2  # the square of the sum of two such unit vectors
    tie: float = TIE  # of joint values, when rows are sorted
    rank: float = polish.RANK
    singular: float = polish.SINGULAR
    nearly_singular: float = polish.NEARLY_SINGULAR
    good_enough: float = polish.GOOD_ENOUGH
    nearly_flat: float = NEARLY_FLAT
    along: float = ALONG
    no_angle: float = NO_ANGLE
    aligned: float = ALIGNED
    moved: float = MOVED
    farthest: float = FARTHEST
    parallel: float = PARALLEL
    smallest: float = recover.SMALLEST
    smallest_square: float = polish.SMALLEST_SQUARE
    damping: float = polish.DAMPING
    plane: float = recover.PLANE
