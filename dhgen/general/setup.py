"""Once for each robot: all formulations on trial, and the choice of the best two.

An arm whose other joints are held has more structure at some of their values, where formulations
vanish that work at all others: with the third joint of an xArm 7 at zero, three axes are parallel.
Formulations that never vanish are preferred, and at every such value two of the chosen ones work.
"""

from __future__ import annotations

from math import log10, sqrt
from random import Random
from typing import TYPE_CHECKING

import numpy as np

from dhgen.general.circle import trigonometric
from dhgen.general.determined import middle_determined
from dhgen.general.formulation import OTHERS, formulations, hiding
from dhgen.general.four_turns import turns_to_hide
from dhgen.general.hidden_slide import nearness, stand_in
from dhgen.general.kernel import SLIDES_OF_FOUR_TURNS, GeneralKernel, Score
from dhgen.general.links import Held, Value
from dhgen.general.loop import JOINTS, QUARTERS, close_loop
from dhgen.general.offset_wrist import offset_wrist
from dhgen.general.vanishing import Vanishing
from dhgen.kinematics.rigid import multiply
from dhgen.runtime.python.general.tables import COSINES, SINES

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.arrays import FloatArray
    from dhgen.general.formulation import Formulation
    from dhgen.general.links import Link
    from dhgen.general.loop import Loop
    from dhgen.kinematics.rigid import Matrix


WITNESSES = 120
FEW_WITNESSES = 40  # for each special value of a held joint
SOME_WITNESSES = 5  # for what doesn't need a statistic
SEED = 6

# A median displacement above this comes from roots that are double for every pose: the square
# root of rounding. Such a formulation is used when there is no other.
DOUBLE_ROOTS = 1e-8
DOUBLE_PENALTY = 6.0  # in powers of ten
# Of a formulation that vanishes at some value of a held joint, in steps.
VANISHING_PENALTY = 3
# Scores are compared in steps of a third of a power of ten; within a step the first one wins.
STEPS = 3


def setup(constants: Sequence[Link], slides: tuple[int, ...] = ()) -> GeneralKernel | None:
    """Prepare the general algorithm for an arm with six joints to be solved for.

    Args:
        constants: C0 ... C6 of T = C0 J1(θ1) C1 ... J6(θ6) C6, rigid transforms [file's unit].
        slides: Which of the six joints slide, from 0, two at most; the others turn.

    Returns:
        The kernel, or None when all formulations fail.

    Raises:
        ValueError: The constants are not those of an arm with six joints and with lengths.
    """
    loop = close_loop(constants, slides)
    if len(slides) == SLIDES_OF_FOUR_TURNS:
        return _chosen(loop, turns_to_hide(slides))
    kernels = (_chosen(loop, every) for every in _trials(slides))
    return next((kernel for kernel in kernels if kernel), None)


def _trials(slides: tuple[int, ...]) -> Iterator[tuple[Formulation, ...]]:
    """The formulations from which two are to be chosen, first the ones that work for most arms."""
    yield formulations(slides)
    for slide in slides:
        yield formulations(slides, OTHERS)
        yield from hiding(slide)


def _chosen(loop: Loop, every: Sequence[Formulation]) -> GeneralKernel | None:
    """The kernel with the best of these formulations; None when all of them fail."""
    scores = _scores(loop, every, WITNESSES)
    special = [_scores(loop, every, FEW_WITNESSES, held) for held in _special(loop)]
    vanishing = [any(some[i].fails for some in special) for i in range(len(every))]
    ranked = sorted(
        (_rank(score) + (VANISHING_PENALTY if vanishing[i] else 0), i)
        for i, score in enumerate(scores)
        if not score.fails
    )
    if not ranked:
        return None
    first = ranked[0][1]
    others = [i for _, i in ranked if every[i].joints[0] != every[first].joints[0]]
    chosen = [first, *others[:1]]
    for some in special:
        serving = sorted((_rank(score), i) for i, score in enumerate(some) if not score.fails)
        left = [i for _, i in serving if i not in chosen]
        chosen += left[: max(0, 2 - sum(i in chosen for _, i in serving))]
    fails = [[some[i].fails for i in chosen] for some in special]
    return GeneralKernel(
        loop,
        tuple(every[i] for i in chosen),
        tuple(scores[i] for i in chosen),
        _vanishing(loop, fails),
        offset_wrist(loop),
    )


def _vanishing(loop: Loop, fails: Sequence[Sequence[bool]]) -> tuple[Vanishing, ...]:
    """Where some formulations fail, but not all, at the special values of the held joints."""
    slides = _slides(loop)
    return tuple(
        Vanishing(place, value, slides[place], tuple(i for i, fail in enumerate(some) if fail))
        for (place, value), some in zip(_special(loop), fails, strict=True)
        if any(some) and not all(some)
    )


def _rank(score: Score) -> int:
    penalty = DOUBLE_PENALTY if score.typical > DOUBLE_ROOTS else 0.0
    return round(STEPS * (log10(max(score.worst, 1e-17)) + penalty))


def _special(loop: Loop) -> list[tuple[int, Value]]:
    """Every joint that is held, at values at which the arm may have more structure."""
    slides = _slides(loop)
    return [
        (place, value)
        for place in range(loop.given)
        for value in (QUARTERS[:1] if slides[place] else QUARTERS)
    ]


def _slides(loop: Loop) -> dict[int, bool]:
    """Which of the joints that are held slide."""
    links = (*loop.links, loop.left, loop.right)
    return {held.place: held.slides for link in links for held, _ in link.rest}


def _scores(
    loop: Loop,
    every: Sequence[Formulation],
    count: int,
    special: tuple[int, Value] | None = None,
) -> list[Score]:
    """The score of each formulation, with one of the held joints at a value if that is given."""
    from dhgen.general.trial import polynomials  # noqa: PLC0415  takes time

    q, links, poses = _witnesses(loop, count, special)
    of_four_turns = len(loop.slides) == SLIDES_OF_FOUR_TURNS
    result = []
    for formulation in every:
        around, slides = formulation.links(links, poses), formulation.slides(loop.slides)
        angles = [_hidden(values[formulation.joints[0]], formulation.sign, slides) for values in q]
        if of_four_turns:
            samples = polynomials(formulation, around, loop.slides)
            result.append(_score(samples, angles, None))
        else:
            samples = _determinants(formulation, around, loop.slides)
            result.append(_score(samples, angles, _determined(around, slides)))
    return result


def _hidden(theta: Value, sign: int, slides: Sequence[bool]) -> tuple[float, float]:
    """Cosine and sine of the angle that is hidden, or that represents a length."""
    return stand_in(sign * theta.value) if slides[0] else (theta.cosine, sign * theta.sine)


def _determined(links: Sequence[FloatArray], slides: Sequence[bool]) -> float:
    """How well φ5 follows from φ1 to φ3, at the best of some witnesses; links are (N, 4, 4) each.

    What the arm's structure leaves open is open at all of them.
    """
    some = zip(links[3][:SOME_WITNESSES], links[4][:SOME_WITNESSES], strict=True)
    return max(middle_determined(K, M, slides) for K, M in some)


def _witnesses(
    loop: Loop, count: int, special: tuple[int, Value] | None
) -> tuple[list[list[Value]], list[FloatArray], FloatArray]:
    """Random joints, the links (N, 4, 4) each, which depend on the given ones, and the poses.

    Without a library's trigonometry.
    """
    random = Random(SEED)  # noqa: S311  nothing secret
    q, links, poses = [], [], []
    for _ in range(count):
        joints = [_joint(random) for _ in range(JOINTS + loop.given)]
        if special is not None:
            joints[JOINTS + special[0]] = special[1]
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
    P = Held(0, 0 in loop.slides, 1.0).motion(q)
    for i, link in enumerate(links, start=1):
        P = multiply(multiply(P, link), Held(i, i in loop.slides, 1.0).motion(q))
    return P


def _determinants(
    formulation: Formulation, links: Sequence[FloatArray], slides: tuple[int, ...]
) -> FloatArray:
    """The determinants (N, 24), without their zero where a hidden length is infinite."""
    from dhgen.general.trial import determinants  # noqa: PLC0415  takes time

    found = determinants(formulation, links, slides)
    near = nearness(np.array(COSINES), np.array(SINES))
    return np.asarray(found / near**formulation.order) if formulation.order else found


def _score(
    samples: FloatArray, angles: Sequence[tuple[float, float]], determined: float | None
) -> Score:
    """The score from the witnesses' samples and their hidden angles' cosines and sines."""
    noise, displacement = [], []
    for angle, row, f in zip(angles, samples, trigonometric(samples), strict=True):
        noise.append(f.noise if row.any() else 1.0)  # a determinant of nothing but zeros
        value, first, second = f.at(*angle)
        root = sqrt(abs(first * first - 2.0 * value * second))
        displacement.append(2.0 * abs(value) / (abs(first) + root + 1e-300))
    count = len(angles)
    noise.sort()
    displacement.sort()
    return Score(
        noise=noise[count // 2],
        typical=displacement[count // 2],
        worst=displacement[(99 * count) // 100],
        determined=determined,
    )
