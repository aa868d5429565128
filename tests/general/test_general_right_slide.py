"""Arms with one slide whose formulations vanish wherever it is a partner of the hidden joint."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.general.formulation import OTHERS
from dhgen.kinematics.build import build_chain
from tests.general.arms import doubtful_in_all_languages
from tests.general.files import assert_all_solutions, kernel_by, poses, written
from tests.general.solved import solve
from tests.structures import first_of

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

POSES = 3

# Axes side by side are parallel, or meet, at several places. One determinant of the last one
# with the slide as a partner does not vanish, but has other roots than its solutions.
ARMS = (
    (
        "{theta: 0 deg, d: q, a: 0.472, alpha: 90 deg}",
        "{theta: -q, d: -0.069, a: 0, alpha: 30 deg}",
        "{theta: q, d: -0.261, a: 0.234, alpha: 180 deg}",
        "{theta: q, d: 0.525, a: 0, alpha: -90 deg}",
        "{theta: q, d: 0.119, a: 0, alpha: 90 deg}",
        "{theta: q, d: 0, a: 0.123, alpha: 45 deg}",
    ),
    (
        "{theta: q + pi/2, d: 0.522, a: 0, alpha: 30 deg}",
        "{theta: q + pi/2, d: 0.454, a: 0, alpha: -90 deg}",
        "{theta: -q, d: 0, a: 0.548, alpha: 90 deg}",
        "{theta: q, d: 0, a: 0, alpha: 45 deg}",
        "{theta: 45 deg, d: q, a: 0.379, alpha: 45 deg}",
        "{theta: q, d: -0.082, a: 0, alpha: 90 deg}",
    ),
    (
        "{theta: q, d: 0, a: 0, alpha: 30 deg}",
        "{theta: q + pi/2, d: 0.14, a: 0, alpha: -90 deg}",
        "{theta: q, d: 0, a: 0.542, alpha: 0 deg}",
        "{theta: q, d: 0, a: 0.452, alpha: 45 deg}",
        "{theta: 45 deg, d: q, a: 0.187, alpha: 0 deg}",
        "{theta: -q, d: 0, a: 0.118, alpha: 45 deg}",
    ),
    (
        "{theta: -q, d: 0, a: 0, alpha: 45 deg}",
        "{theta: -q, d: 0.367, a: 0.285, alpha: 180 deg}",
        "{theta: q, d: 0, a: 0, alpha: 90 deg}",
        "{theta: q + pi/2, d: 0, a: 0.407, alpha: -90 deg}",
        "{theta: q + pi/2, d: 0.058, a: 0.358, alpha: 90 deg}",
        "{theta: 90 deg, d: q, a: 0.217, alpha: 90 deg}",
    ),
    (
        "{theta: q, d: 0.523, a: 0.071, alpha: 90 deg}",
        "{theta: 0 deg, d: q, a: 0.152, alpha: 45 deg}",
        "{theta: q + pi/2, d: 0, a: 0.351, alpha: 0 deg}",
        "{theta: q + pi/2, d: 0, a: 0, alpha: -60 deg}",
        "{theta: q + pi/2, d: 0, a: 0, alpha: -90 deg}",
        "{theta: q, d: 0, a: 0.362, alpha: 0 deg}",
    ),
)


def known(chain: Chain) -> GeneralKernel:
    kernel = kernel_by(chain, "general 5R1P")
    assert kernel.slides_on_the_right
    return kernel


@pytest.mark.parametrize("rows", first_of(((rows,) for rows in ARMS), count=2))
def test_all_solutions(tmp_path: Path, rows: tuple[str, ...]) -> None:
    robot = written(tmp_path, rows)
    chain = build_chain(robot)
    assert_all_solutions(robot, known(chain), poses(chain, POSES, seed=1))


@pytest.mark.parametrize("rows", first_of(((rows,) for rows in ARMS[:1]), count=0))
def test_c_and_python_agree(tmp_path: Path, rows: tuple[str, ...]) -> None:
    chain = build_chain(written(tmp_path, rows))
    kernel = known(chain)
    assert doubtful_in_all_languages(kernel, poses(chain, 60, seed=5)) == 0


def test_either_formulation_serves(tmp_path: Path) -> None:
    chain = build_chain(written(tmp_path, ARMS[0]))
    kernel = known(chain)
    slides = kernel.loop.slides
    first, second = kernel.formulations
    assert first.joints[0] != second.joints[0]
    assert {place for place in OTHERS for f in kernel.formulations if f.slides(slides)[place]} == {
        4,
        5,
    }
    other = replace(kernel, formulations=(second,))
    for T in poses(chain, POSES, seed=2):
        np.testing.assert_allclose(solve(T, kernel).q, solve(T, other).q, atol=1e-8)
