"""Two equal links that are folded upon each other: a step that solves for a sum says nothing."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest

from dhgen.derivation import derivation_document
from dhgen.derivation.story import Story
from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.paul.derive import derive
from dhgen.program.interpret import interpret
from dhgen.program.lowering.lower import lower
from tests.kinematics.values import table

ROWS = (
    "theta: q, d: l, a: l/3, alpha: -pi/2",
    "theta: q, a: 2*l",
    "theta: q, a: 2*l",
    "theta: q, alpha: pi/2",
    "theta: q, d: l/4",
)


@cache
def folding() -> Story:
    """An arm that cannot take every pose; of its links, the sum of the angles is found first."""
    robot = table(*ROWS, parameters="{l: 0.3}")
    derivation = derive(build_chain(robot))
    return Story(robot, derivation, lower(derivation))


@pytest.mark.breadth
@pytest.mark.parametrize("seed", [(0.1, 0.2, 0.3, 0.4, 0.5), (0.1, -1.2, 0.9, 0.4, 0.5)])
def test_the_sum_takes_the_seed_s_value_and_not_the_joints(seed: tuple[float, ...]) -> None:
    pose = numeric_arm(build_chain(folding().robot)).pose(np.array([[0.3, 0.4, np.pi, 0.7, -0.5]]))
    rows = interpret(folding().program, pose, np.array([seed]))
    assert rows.solved.sum() == 3
    (q,) = rows.q[rows.free]
    more = q[1] + q[2] - seed[1] - seed[2]
    assert math.remainder(more, 2.0 * math.pi) == pytest.approx(0.0, abs=1e-9)
    assert abs(q[2]) == pytest.approx(np.pi)


def test_the_step_and_the_table_say_so() -> None:
    """The wrist's axis is the shoulder's then: theta_4 makes up for any theta_23."""
    story = folding()
    text = derivation_document(story, "robots/x.yaml")
    folded = "two links of equal length are folded upon each other, and every $\\theta_{23}$ works"
    takes = "\\theta_{23}$ takes the value that the seed's $q_2$ and $q_3$ give it (each 0 without"
    assert f"Degenerate when $X = Y = K = 0$: {folded}. Then ${takes}" in text
    assert f"| $X = Y = K = 0$ | no short form | {folded}; ${takes}" in text
    assert text.count("the joints themselves follow from it") == 2
