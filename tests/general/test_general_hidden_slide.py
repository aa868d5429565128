"""Arms with one slide whose determinants vanish identically wherever a turn is hidden."""

from __future__ import annotations

from dataclasses import replace
from math import hypot
from typing import TYPE_CHECKING

import pytest

from dhgen.general.hidden_slide import stand_in
from dhgen.kinematics.build import build_chain
from dhgen.runtime.plain import plain
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

# Their polynomials in the length are of degree 16, 12 and 8.
ARMS = (
    (
        "{theta: q, d: 0.3, a: 0.1, alpha: -90 deg}",
        "{theta: 0.2, d: q, a: 0.15, alpha: 90 deg}",
        "{theta: q, d: 0.1, a: 0.08, alpha: -90 deg}",
        "{theta: q, d: 0.43, a: 0, alpha: 90 deg}",
        "{theta: q, d: 0.05, a: 0, alpha: -90 deg}",
        "{theta: q, d: 0.08, a: 0, alpha: 0}",
    ),
    (
        "{theta: q, d: 0.16, a: 0.119, alpha: 0}",
        "{theta: q, d: 0.182, a: 0, alpha: -90 deg}",
        "{theta: q, d: 0.202, a: 0, alpha: -90 deg}",
        "{theta: q, d: 0.258, a: 0, alpha: -90 deg}",
        "{theta: 0.2, d: q, a: 0.216, alpha: -90 deg}",
        "{theta: q, d: 0.463, a: 0.154, alpha: -90 deg}",
    ),
    (
        "{theta: q - pi/2, d: -0.36, a: 0, alpha: 90 deg}",
        "{theta: q - pi/2, d: 0, a: 0.355, alpha: 180 deg}",
        "{theta: q + pi/2, d: 0, a: 0, alpha: 90 deg}",
        "{theta: q + pi, d: 0.375, a: 0, alpha: 90 deg}",
        "{theta: 90 deg, d: q, a: 0, alpha: 90 deg}",
        "{theta: q + pi/2, d: 0.078, a: 0, alpha: 0}",
    ),
)


def known(chain: Chain) -> GeneralKernel:
    kernel = kernel_by(chain, "general 5R1P")
    assert kernel.hides_a_slide
    return kernel


@pytest.mark.parametrize("rows", first_of((rows,) for rows in ARMS[::-1]))
def test_all_solutions(tmp_path: Path, rows: tuple[str, ...]) -> None:
    robot = written(tmp_path, rows)
    chain = build_chain(robot)
    assert_all_solutions(robot, known(chain), poses(chain, 1, seed=1))


@pytest.mark.parametrize(("rows", "most"), first_of([(ARMS[0], 3), (ARMS[2], 60)]))
def test_c_and_python_agree(tmp_path: Path, rows: tuple[str, ...], most: int) -> None:
    """Far out the determinant loses digits, and roots of the other arm are double at every pose."""
    chain = build_chain(written(tmp_path, rows))
    kernel = known(chain)
    assert doubtful_in_all_languages(kernel, poses(chain, 60, seed=5)) <= most  # of 60


@pytest.mark.parametrize("d", [-3.0, 0.0, 0.4, 25.0])
def test_a_length_and_its_angle(d: float) -> None:
    cosine, sine = stand_in(d)
    assert hypot(cosine, sine) == pytest.approx(1.0)
    length = plain("general.equations").hidden_length(cosine, sine)
    assert length == pytest.approx(d, rel=1e-12)


def test_too_low_an_order_leaves_a_root_at_infinity(tmp_path: Path) -> None:
    chain = build_chain(written(tmp_path, ARMS[1]))
    kernel = known(chain)
    low = replace(kernel, formulations=(replace(kernel.first, order=kernel.first.order - 1),))
    (T,) = poses(chain, 1, seed=1)
    assert solve(T, kernel).certain
    assert not solve(T, low).certain
