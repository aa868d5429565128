"""The polynomials of formulations at the sample angles, by the functions that solve poses.

At run time a formulation works, or it does not, by its digits: so it is tried with the runtime's
own equations and reflections, compiled once for all arms.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.runtime.python.general.equations import act, equations, fold, pass_link
from dhgen.runtime.python.general.four_turns import four_turns_polynomial, split_links
from dhgen.runtime.python.general.places import HIDDEN_SLIDE, LAST, LEFT_SLIDE, SLIDES
from dhgen.runtime.python.general.tables import SAMPLE_C, SAMPLE_S, SAMPLES
from dhgen.runtime.python.jit import of_file

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.arrays import FloatArray
    from dhgen.general.formulation import Formulation

OWN = of_file(__file__)


def determinants(
    formulation: Formulation, links: Sequence[FloatArray], slides: tuple[int, ...]
) -> FloatArray:
    """The determinant of the hidden joint at the sample angles, (N, 24).

    Args:
        formulation: The formulation.
        links: Its L0 ... L5 at N poses, (N, 4, 4) each, in arm sizes.
        slides: Which of the six joints slide, from 0.
    """
    return _determinants(*_as_arrays(formulation, links, slides))


def polynomials(
    formulation: Formulation, links: Sequence[FloatArray], slides: tuple[int, ...]
) -> FloatArray:
    """The polynomial of the hidden turn of an arm with four turns, in the same way."""
    return _polynomials(*_as_arrays(formulation, links, slides))


def left_side(
    formulation: Formulation, links: Sequence[FloatArray], slides: tuple[int, ...]
) -> FloatArray:
    """The monomials of the left side at one pose, as `equations` has its columns: (15, 27)."""
    arm, joints, every = _as_arrays(formulation, links, slides)
    return _left_side(arm, joints, every[0])


def _as_arrays(
    formulation: Formulation, links: Sequence[FloatArray], slides: tuple[int, ...]
) -> tuple[FloatArray, np.ndarray, FloatArray]:
    """What the runtime reads of an arm, the joints, and the links as rows of twelve numbers."""
    arm, at = np.zeros(LAST), formulation.slides(slides)
    arm[[SLIDES + joint for joint in slides]] = 1.0
    arm[HIDDEN_SLIDE], arm[LEFT_SLIDE] = at[0], at[1] or at[2]
    every = np.stack([link[:, :3].reshape(-1, 12) for link in links], axis=1)
    return arm, np.array(formulation.joints), np.ascontiguousarray(every)


@OWN.jit
def _determinants(arm: FloatArray, joints: np.ndarray, links: FloatArray) -> FloatArray:
    found = np.empty((len(links), SAMPLES))
    for k in range(len(links)):
        fold(equations(arm, joints, links[k]), SAMPLE_C, SAMPLE_S, found[k])
    return found


@OWN.jit
def _polynomials(arm: FloatArray, joints: np.ndarray, links: FloatArray) -> FloatArray:
    found, between = np.empty((len(links), SAMPLES)), np.zeros((4, 12))
    for k in range(len(links)):
        split_links(arm, joints, links[k], between)
        for i in range(SAMPLES):
            c, s = SAMPLE_C[i], SAMPLE_S[i]
            found[k, i] = four_turns_polynomial(arm, joints, links[k], between, c, s)
    return found


@OWN.jit
def _left_side(arm: FloatArray, joints: np.ndarray, links: FloatArray) -> FloatArray:
    left = np.zeros((15, 1))
    left[0, 0] = left[3, 0] = 1.0  # the origin and z
    for i in (2, 1, 0):
        left = pass_link(arm, links[i], left, joints[i], i > 0)
    act(links[5], left)
    return left
