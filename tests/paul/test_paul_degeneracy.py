"""Steps that say nothing of an angle although it is not free: others are taken, or rows checked."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.given import given_values
from dhgen.kinematics.numeric import numeric_arm
from dhgen.oracle.search import solve
from dhgen.paul.degeneracy import OFTEN, degenerate_places, with_degeneracies
from dhgen.paul.derivation import Derivation
from dhgen.paul.derive import derive
from dhgen.paul.search import Search
from dhgen.paul.types import CLOSED, QUARTIC
from dhgen.program.interpret import interpret
from dhgen.program.lowering.lower import lower
from tests.derived import derived
from tests.kinematics.values import table
from tests.robots.cases import robot
from tests.structures import first_of

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain
    from dhgen.program.interpret import Rows
    from dhgen.program.ir import Program

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

# What a wrist's last angle is read from vanishes where its axis is parallel to axis 2.
ARMS = {
    "wrist": (
        "theta: q, d: 0.1, alpha: pi/6",
        "theta: q, d: 0.04, a: 0.03, alpha: pi/3",
        "theta: q, d: 0.25, a: 0.02, alpha: pi/2",
        "theta: q, d: 0.24, alpha: -pi/2",
        "theta: q, alpha: pi/2",
        "theta: q, d: 0.09",
    ),
    "five": (
        "theta: q, alpha: 50 deg",
        "theta: q, alpha: 75 deg",
        "theta: q, d: 0.29, alpha: pi/2",
        "theta: q, alpha: -pi/2",
        "theta: q, d: 0.25",
    ),
    "seven": (
        "theta: q, d: 0.12, alpha: pi/4",
        "theta: q, alpha: -pi/3",
        "theta: q, d: 0.28, a: 0.02, alpha: pi/2",
        "theta: q, a: -0.02, alpha: -pi/2",
        "theta: q, d: 0.25, alpha: pi/2",
        "theta: q, alpha: -pi/2",
        "theta: q, d: 0.1",
    ),
}
# At zero of joint 2 axis 4 is parallel to axis 1, and its direction does not tell the first angle.
SLIDE_ON_A_SHOULDER = (
    "theta: q + pi/2, a: 0.463, alpha: -pi/2",
    "theta: q, alpha: -pi/2",
    "theta: 0, d: q, a: 0.336, limits: [-0.52, 0.62]",
    "theta: q, d: 0.353, alpha: pi/2",
    "theta: -q, alpha: pi/2",
)
NAMES = [*ARMS, "spherical_wrist_general_arm"]
EXACT = 1e-9
CONSISTENT = 1e-5


def derivation(name: str) -> Derivation:
    return derived(chain_of(name))


@cache
def chain_of(name: str) -> Chain:
    if name not in ARMS:
        return build_chain(robot(name))
    tool = {"tool": "{xyz: [0.03, 0, 0.08]}"} if name == "five" else {}
    if name == "seven":
        tool = {"free": "arm_angle"}
    return build_chain(table(*ARMS[name], **tool))


@cache
def cheapest(name: str) -> Derivation:
    """What the search takes first, as it is found out to be."""
    made = derivation(name)
    for types in (CLOSED, QUARTIC):
        route = Search(made.pool, types).best()
        if route is not None:
            return Derivation(
                made.pool, with_degeneracies(made.pool, route.steps, {}), route.offers
            )
    raise AssertionError(name)


def rows_at(
    program: Program, chain: Chain, q: FloatArray, seed: FloatArray
) -> tuple[Rows, FloatArray]:
    """The rows for the poses of joint values, and by how much each misses its pose."""
    arm = numeric_arm(chain)
    rows = interpret(program, arm.pose(q), seed, given_values(arm, q))
    reached = arm.pose(np.where(rows.solved[..., None], rows.q, 0.0))
    return rows, np.abs(reached - arm.pose(q)[:, None]).max(axis=(2, 3))


@pytest.mark.parametrize("name", first_of(NAMES))
def test_an_order_is_taken_in_which_no_step_is_silent(name: str) -> None:
    q = degenerate_places(cheapest(name).pool, cheapest(name).steps)
    assert len(q)
    chosen = derivation(name)
    assert not any(step.degenerate for step in chosen.steps)
    assert chosen.branches == cheapest(name).branches
    rows, misses = rows_at(lower(chosen), chain_of(name), q, np.zeros_like(q))
    assert not rows.free.any()
    assert misses[rows.solved].max() < EXACT
    away = np.abs(np.remainder(rows.q - q[:, None] + np.pi, 2 * np.pi) - np.pi).max(axis=2)
    assert np.where(rows.solved, away, np.inf).min(axis=1).max() < EXACT


@pytest.mark.breadth
@pytest.mark.parametrize("name", NAMES)
def test_rows_of_a_step_that_is_silent_are_checked(name: str) -> None:
    made = cheapest(name)
    q = degenerate_places(made.pool, made.steps)
    program = lower(made)
    for seed in (q, np.zeros_like(q)):
        rows, misses = rows_at(program, chain_of(name), q, seed)
        assert misses[rows.solved].max(initial=0.0) < CONSISTENT
    assert program.completion is not None


def test_an_order_with_more_rows_is_taken_where_one_is_silent_at_a_right_angle() -> None:
    """Two lengths of the slide serve there, and a third solution has the other angle of axis 5."""
    arm = table(*SLIDE_ON_A_SHOULDER, convention="modified")
    chain = build_chain(arm)
    made = derive(chain)
    assert all(step.degenerate != OFTEN for step in made.steps)
    q = np.array([[np.pi, 0.0, -0.52, 0.0, 0.0]])
    rows, misses = rows_at(lower(made), chain, q, q)
    solutions = solve(arm, numeric_arm(chain).pose(q[0])).regular
    assert len(solutions) == 3
    assert misses[rows.solved].max() < EXACT
    found = rows.q[rows.solved]
    away = np.abs(np.remainder(found[:, None] - solutions + np.pi, 2 * np.pi) - np.pi).max(axis=2)
    assert away.min(axis=0).max() < EXACT
