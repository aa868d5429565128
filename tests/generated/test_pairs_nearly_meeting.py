"""Where two solutions nearly meet both are rows: joint values just beside singular places.

Random poses meet such places once in a million times. Here they are looked for: from where the
Jacobian of the task loses rank a small step leads to least singular values of 1e-7 to 1e-5.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.survey.singular import singular_sets, task_jacobian
from tests.generated.asking import trial
from tests.generated.solvers import module
from tests.structures import first_of

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.survey.trial import Trial

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

# Six turns, a slide, two of them, five joints that point, a given joint; axes that nearly meet.
ARMS = [
    "general_6r",
    "general_5r1p",
    "general_rpprrr",
    "general_5r_pointing",
    "kinova_gen3_7",
    "abb_gofa_5",
]
SAME = 1e-5  # rounding of the pose over the least singular value leaves 1e-8
APART = 1e-7  # [rad, arm sizes]: far below what is one solution, which arms' sizes blur
# Least singular value 3.5e-5.
ALONG = [-0.36393, 1.57179, 1.32512, -1.65330, 3.14130, 2.19515]
SINGULAR, NEARLY = 1e-7, 1e-5  # least singular values, lengths in arm sizes


def beside_singular_places(asked: Trial, count: int) -> FloatArray:
    """Joint values (N, n) with least singular values between SINGULAR and NEARLY."""
    robot, random = asked.robot, np.random.default_rng(3)
    kinds = singular_sets(robot, count, seed=2)
    q = np.concatenate([each for kind, each in kinds.items() if kind.startswith("singular by")])
    units = np.where(asked.model.revolute, 1.0, asked.size)
    steps = random.normal(size=q.shape) * 10 ** random.uniform(-6.0, -4.0, (len(q), 1))
    q = q + units * steps
    J = task_jacobian(asked.model.divided_by(asked.size), robot, q / units)
    least = np.linalg.svd(J, compute_uv=False).min(axis=-1)
    return np.asarray(q[(least > SINGULAR) & (least < NEARLY)])


def nearest(asked: Trial, rows: FloatArray, q: FloatArray) -> FloatArray:
    """How far the nearest row (N, k, n) is from joint values (N, n)."""
    apart = asked.apart(rows, q[:, None])
    return np.asarray(np.where(np.isnan(apart), np.inf, apart).min(axis=1))


@pytest.mark.parametrize("name", first_of(ARMS, count=2))
def test_own_joint_values_are_among_the_rows(name: str) -> None:
    asked = trial(name)
    q = beside_singular_places(asked, 60)
    assert len(q) > 80
    T, given = asked.poses(q), asked.given(q)
    rows, _ = asked.solver.batch(T, given)
    assert nearest(asked, rows, q).max() < SAME
    for pose, several in zip(T, rows, strict=True):
        held = several[np.isfinite(several).all(axis=-1)]
        assert asked.residuals(held, pose).max() < 1e-9
        for k, row in enumerate(held):
            assert asked.apart(held[:k], row).min(initial=np.inf) > APART


def test_the_other_end_of_what_is_nearly_a_continuum() -> None:
    """No start leads to the sixth solution: it lies 0.3 rad from another, nearly a family away.

    Solutions come in pairs, as roots of a real polynomial of even degree do.
    """
    asked, q = trial("general_5r1p_pair"), np.array([ALONG])
    (rows,), _ = asked.solver.batch(asked.poses(q), asked.given(q))
    assert nearest(asked, rows[None], q).max() < SAME
    assert np.isfinite(rows).all(axis=-1).sum() % 2 == 0


# numba takes seconds for each, and the Python of general arms is one for all but for how the
# polynomials come about: turns alone, a slide, two of them.
@pytest.mark.parametrize("name", first_of(ARMS[:3], count=0))
def test_python_has_the_rows_of_c(name: str) -> None:
    asked = trial(name)
    q = beside_singular_places(asked, 20)
    T, given = asked.poses(q), asked.given(q)
    rows, _ = asked.solver.batch(T, given)
    others, _ = module(name).ik_batch(T, *([] if given is None else [given]))
    assert nearest(asked, others, q).max() < SAME
    for ours, theirs in ((rows, others), (others, rows)):
        for k in range(ours.shape[1]):
            held = np.isfinite(ours[:, k]).all(axis=-1)
            assert nearest(asked, theirs[held], ours[held, k]).max(initial=0.0) < SAME
