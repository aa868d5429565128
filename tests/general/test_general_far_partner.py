"""Singular poses where x3 = tan(φ3/2) of a partner is nearly infinite.

The columns that are cleared first depend on each other there, and what is left of the matrix does
not show that roots meet: a determinant's double root was taken for none, with a certificate.
"""

from __future__ import annotations

import numpy as np
import pytest

from tests.general.arms import TABLES, compiled, forward, gap, kernel
from tests.general.solved import solve

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

NAME = "general"
POSES = 40


def jacobian_determinant(q: np.ndarray) -> float:
    """By central differences."""
    steps = 1e-6 * np.eye(6)
    T, *moved = forward(TABLES[NAME], np.concatenate([[q], q + steps, q - steps]))
    columns = []
    for after, before in zip(moved[:6], moved[6:], strict=True):
        change = (after - before) / 2e-6
        turning = change[:3, :3] @ T[:3, :3].T
        columns.append([turning[2, 1], turning[0, 2], turning[1, 0], *change[:3, 3]])
    return float(np.linalg.det(np.array(columns)))


def singular(source: np.random.Generator, held: int, value: float) -> np.ndarray:
    """Joint values at which the arm is singular, one of them given."""
    while True:
        q = source.uniform(-np.pi, np.pi, 6)
        q[held] = value
        turned = int(source.choice([joint for joint in range(1, 5) if joint != held]))

        def at(x: float, q: np.ndarray = q, turned: int = turned) -> float:
            q[turned] = x
            return jacobian_determinant(q)

        low, high = source.uniform(-np.pi, 0.0), source.uniform(0.0, np.pi)
        before = at(low)
        if before * at(high) > 0.0:
            continue
        for _ in range(50):
            middle = (low + high) / 2
            low, high = (middle, high) if at(middle) * before > 0.0 else (low, middle)
        at(low)
        return q


@pytest.fixture(scope="module")
def known() -> list[tuple[np.ndarray, np.ndarray]]:
    """Joint values and their poses; x3 is infinite up to 1e-8 to 1e-4 rad of φ3."""
    form = kernel(NAME).formulations[0]
    partner = form.joints[2]
    cosine, sine = kernel(NAME).loop.advances[partner]
    half_a_turn = form.sign * np.pi + np.arctan2(sine, cosine)
    source = np.random.default_rng(7)
    made = []
    for _ in range(POSES):
        off = source.choice([-1.0, 1.0]) * 10.0 ** source.uniform(-8.0, -4.0)
        q = singular(source, partner, half_a_turn + off)
        made.append((q, forward(TABLES[NAME], q)))
    return made


@pytest.mark.breadth
def test_in_python(known: list[tuple[np.ndarray, np.ndarray]]) -> None:
    for q, T in known[:6]:
        assert gap(solve(T, kernel(NAME)).q, q).min() < 1e-3


def test_in_c(known: list[tuple[np.ndarray, np.ndarray]]) -> None:
    for q, T in known:
        rows, _, _ = compiled(NAME)(T)
        assert gap(rows, q).min() < 1e-3
