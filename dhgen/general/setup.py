"""Once for each robot: the twelve formulations on trial, and the choice of the best two."""

from __future__ import annotations

from math import log10, sqrt
from random import Random
from typing import TYPE_CHECKING

import numpy as np

from dhgen.general.circle import SAMPLES, sample_cosines, trigonometric
from dhgen.general.determinant import equations, fold
from dhgen.general.formulation import formulations
from dhgen.general.kernel import GeneralKernel, Score
from dhgen.general.links import Held, Value
from dhgen.general.loop import JOINTS, close_loop
from dhgen.general.offset_wrist import offset_wrist
from dhgen.general.rigid import multiply

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from dhgen.general.links import Link
    from dhgen.general.loop import Loop
    from dhgen.general.rigid import Matrix

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


def setup(constants: Sequence[Link], slide: int | None = None) -> GeneralKernel | None:
    """Prepare the general algorithm for an arm with six joints to be solved for.

    Args:
        constants: C0 ... C6 of T = C0 J1(θ1) C1 ... J6(θ6) C6, rigid transforms [file's unit].
        slide: Which of the six joints slides, from 0; the others turn.

    Returns:
        The kernel, or None when all formulations vanish identically.

    Raises:
        ValueError: The constants are not those of an arm with six joints and with lengths.
    """
    loop = close_loop(constants, slide)
    q, links, poses = _witnesses(loop)
    ranked = []
    for index, formulation in enumerate(formulations(slide)):
        around = formulation.links(links, poses)
        E = equations(around, formulation.slides(slide))
        hidden = [values[formulation.joints[0]] for values in q]
        score = _score(E, [(x.cosine, formulation.sign * x.sine) for x in hidden])
        if score.noise < NOISE_LIMIT:
            ranked.append((_rank(score), index, formulation, score))
    ranked.sort(key=lambda entry: entry[:2])
    if not ranked:
        return None
    _, _, first, score = ranked[0]
    wrist = offset_wrist(loop)
    for _, _, second, other in ranked[1:]:
        if second.joints[0] != first.joints[0]:
            return GeneralKernel(loop, first, second, (score, other), wrist)
    return GeneralKernel(loop, first, None, (score,), wrist)


def _rank(score: Score) -> int:
    penalty = DOUBLE_PENALTY if score.typical > DOUBLE_ROOTS else 0.0
    return round(STEPS * (log10(max(score.worst, 1e-17)) + penalty))


def _witnesses(loop: Loop) -> tuple[list[list[Value]], list[FloatArray], FloatArray]:
    """Random joints, the links (N, 4, 4) each, which depend on those that are held, and the poses.

    Without a library's trigonometry.
    """
    random = Random(SEED)  # noqa: S311  nothing secret
    q, links, poses = [], [], []
    for _ in range(WITNESSES):
        joints = [_joint(random) for _ in range(JOINTS + loop.given)]
        # lengths of held slides are in the file's unit
        held = [Value(loop.size * x.value, x.cosine, x.sine) for x in joints[JOINTS:]]
        fixed = [K.at(held) for K in loop.links]
        q.append(joints[:JOINTS])
        links.append(fixed)
        poses.append(_pose(loop, fixed, joints))
    return q, [np.array(each) for each in zip(*links, strict=True)], np.array(poses)


def _joint(random: Random) -> Value:
    """A random angle, or a length up to the arm's size."""
    while True:  # a point of the unit disc; its direction is uniform
        x, y = 2.0 * random.random() - 1.0, 2.0 * random.random() - 1.0
        if 1e-2 < x * x + y * y <= 1.0:
            break
    length = sqrt(x * x + y * y)
    return Value(x, x / length, y / length)


def _pose(loop: Loop, links: Sequence[Matrix], q: Sequence[Value]) -> Matrix:
    """P = J1(θ1) K0 ... K4 J6(θ6)."""
    P = Held(0, loop.slide == 0, 1.0).motion(q)
    for i, link in enumerate(links, start=1):
        P = multiply(multiply(P, link), Held(i, loop.slide == i, 1.0).motion(q))
    return P


def _score(E: FloatArray, angles: Sequence[tuple[float, float]]) -> Score:
    """The score from the equations of the witnesses and their hidden angles' cosines and sines."""
    cosines, sines = sample_cosines()
    count = len(angles)
    lanes = np.repeat(E, SAMPLES, axis=-1)
    determinant, _ = fold(lanes, np.tile(cosines, count), np.tile(sines, count))
    noise, displacement = [], []
    for angle, samples in zip(angles, determinant.reshape(count, SAMPLES), strict=True):
        f = trigonometric(samples)
        noise.append(f.noise if samples.any() else 1.0)  # a determinant of nothing but zeros
        value, first, second = f.at(*angle)
        root = sqrt(abs(first * first - 2.0 * value * second))
        displacement.append(2.0 * abs(value) / (abs(first) + root + 1e-300))
    noise.sort()
    displacement.sort()
    return Score(noise[count // 2], displacement[count // 2], displacement[(99 * count) // 100])
