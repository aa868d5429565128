"""Once for each robot: the tables of the twelve formulations, and the choice of the best two."""

from __future__ import annotations

from math import log10, sqrt
from random import Random
from typing import TYPE_CHECKING

import numpy as np

from dhgen.general.circle import SAMPLES, sample_cosines, trigonometric
from dhgen.general.determinant import equations, fold
from dhgen.general.formulation import formulations
from dhgen.general.kernel import GeneralKernel, Score
from dhgen.general.loop import close_loop
from dhgen.general.offset_wrist import offset_wrist
from dhgen.general.rigid import Matrix, multiply

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from dhgen.general.formulation import Formulation
    from dhgen.general.loop import Loop

    FloatArray = NDArray[np.float64]

WITNESSES = 120
SEED = 6

# Harmonics beyond the eighth that are not rounding: the determinant vanishes identically, or the
# formulation has another degree.
NOISE_LIMIT = 1e-9
# A median displacement above this comes from roots that are double for every pose: the square
# root of rounding. Such a formulation is used when there is no other.
DOUBLE_ROOTS = 1e-8
DOUBLE_PENALTY = 6.0  # in powers of ten
# Scores are compared in steps of a third of a power of ten; within a step the first one wins.
STEPS = 3


def setup(constants: Sequence[Matrix]) -> GeneralKernel | None:
    """Prepare the general algorithm for an arm of six revolute joints.

    Args:
        constants: C0 ... C6 of T = C0 Rz(θ1) C1 ... Rz(θ6) C6, 4x4 [file's unit].

    Returns:
        The kernel, or None when all twelve formulations vanish identically.

    Raises:
        ValueError: The constants are not those of an arm with six joints and with lengths.
    """
    loop = close_loop(constants)
    cosines, sines = _witnesses()
    poses = np.array([_pose(loop, c, s) for c, s in zip(cosines, sines, strict=True)])
    ranked = []
    for index, formulation in enumerate(formulations(loop.links)):
        joint = formulation.joints[0]
        sine = [formulation.sign * s[joint] for s in sines]
        score = _score(formulation, poses, [c[joint] for c in cosines], sine)
        if score.noise < NOISE_LIMIT:
            ranked.append((_rank(score), index, formulation, score))
    ranked.sort(key=lambda entry: entry[:2])
    if not ranked:
        return None
    _, _, first, score = ranked[0]
    for _, _, second, other in ranked[1:]:
        if second.joints[0] != first.joints[0]:
            return GeneralKernel(loop, first, second, (score, other), offset_wrist(loop))
    return GeneralKernel(loop, first, None, (score,), offset_wrist(loop))


def _rank(score: Score) -> int:
    penalty = DOUBLE_PENALTY if score.typical > DOUBLE_ROOTS else 0.0
    return round(STEPS * (log10(max(score.worst, 1e-17)) + penalty))


def _witnesses() -> tuple[list[list[float]], list[list[float]]]:
    """Cosines and sines of random joint angles, without a library's trigonometry."""
    random = Random(SEED)  # noqa: S311  nothing secret
    cosines, sines = [], []
    for _ in range(WITNESSES):
        c, s = [], []
        for _ in range(6):
            while True:  # a point of the unit disc; its direction is uniform
                x, y = 2.0 * random.random() - 1.0, 2.0 * random.random() - 1.0
                if 1e-2 < x * x + y * y <= 1.0:
                    break
            length = sqrt(x * x + y * y)
            c.append(x / length)
            s.append(y / length)
        cosines.append(c)
        sines.append(s)
    return cosines, sines


def _pose(loop: Loop, cosine: Sequence[float], sine: Sequence[float]) -> Matrix:
    """P = Rz(θ1) K0 ... K4 Rz(θ6)."""
    P: Matrix | None = None
    for i, (c, s) in enumerate(zip(cosine, sine, strict=True)):
        turn = ((c, -s, 0.0, 0.0), (s, c, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0), (0.0, 0.0, 0.0, 1.0))
        P = turn if P is None else multiply(multiply(P, loop.links[i - 1]), turn)
    assert P is not None
    return P


def _score(
    formulation: Formulation, P: FloatArray, cosine: Sequence[float], sine: Sequence[float]
) -> Score:
    E = equations(formulation, P)
    cosines, sines = sample_cosines()
    count = len(P)
    lanes = np.repeat(E, SAMPLES, axis=-1)
    determinant, _ = fold(lanes, np.tile(cosines, count), np.tile(sines, count))
    noise, displacement = [], []
    for i, samples in enumerate(determinant.reshape(count, SAMPLES)):
        f = trigonometric(samples)
        noise.append(f.noise if samples.any() else 1.0)  # a determinant of nothing but zeros
        value, first, second = f.at(cosine[i], sine[i])
        root = sqrt(abs(first * first - 2.0 * value * second))
        displacement.append(2.0 * abs(value) / (abs(first) + root + 1e-300))
    noise.sort()
    displacement.sort()
    return Score(noise[count // 2], displacement[count // 2], displacement[(99 * count) // 100])
