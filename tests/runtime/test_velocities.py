"""Joint velocities of a twist by their functions, against numpy's singular values."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from dhgen.runtime.python.arm import arm_numbers
from tests.runtime.arms import ENDLESS, arm_of, called, planar, tilting
from tests.runtime.plain import KINDS

pytestmark = pytest.mark.parametrize("kind", KINDS)
FREE = arm_numbers(arm_of("RR", (ENDLESS, ENDLESS)))
BEGINS = 0.01  # the singular value at which damping begins


def filtered(J: np.ndarray, twist: np.ndarray) -> np.ndarray:
    """Least squares in which 1 / s of a singular value s below BEGINS is s / BEGINS^2."""
    U, s, V = np.linalg.svd(J, full_matrices=False)
    return np.asarray(V.T @ (s / np.maximum(s, BEGINS) ** 2 * (U.T @ twist)))


@pytest.mark.parametrize("dof", [2, 3, 6, 9])
@pytest.mark.parametrize("rank", [1, 3, 6])
def test_rows_become_orthogonal_and_keep_their_singular_values(
    kind: str, dof: int, rank: int
) -> None:
    random = np.random.default_rng(dof + 10 * rank)
    A = random.normal(size=(6, rank)) @ random.normal(size=(rank, dof))
    b = random.normal(size=6)
    rows = np.column_stack([A, b])
    called(kind, "velocities", "make_orthogonal")(rows, dof)
    lengths = np.linalg.norm(rows[:, :dof], axis=1)
    least = min(6, dof)
    expected = np.linalg.svd(A, compute_uv=False)
    np.testing.assert_allclose(np.sort(lengths)[::-1][:least], expected, atol=1e-14)
    products = rows[:, :dof] @ rows[:, :dof].T
    np.testing.assert_allclose(products, np.diag(lengths**2), atol=1e-13)
    np.testing.assert_allclose(rows[:, :dof].T @ rows[:, dof], A.T @ b, atol=1e-12)


def planar_rates(q: np.ndarray) -> np.ndarray:
    """The Jacobian of the arm in the plane, lengths in its size of 1/2."""
    c, s = np.cos(q.sum()), np.sin(q.sum())
    return 2.0 * np.array(
        [[-0.5 * np.sin(q[0]) - 0.4 * s, -0.4 * s], [0.5 * np.cos(q[0]) + 0.4 * c, 0.4 * c]]
    )


def velocities(kind: str, arm: Any, robot: Any, q: Any, twist: Any) -> np.ndarray:
    found = np.empty(len(q))
    values = np.array(q, float), np.array(twist, float)
    called(kind, "velocities", "find_velocities")(arm, robot, *values, found)
    return found


@pytest.mark.parametrize("elbow", [0.8, -2.0, 0.06])
def test_regular_postures_are_exact(kind: str, elbow: float) -> None:
    q, twist = np.array([0.3, elbow]), np.array([0.3, -0.2, 9.0, 9.0, 9.0, 9.0])
    J = planar_rates(q)
    assert np.linalg.svd(J, compute_uv=False)[-1] > BEGINS
    found = velocities(kind, FREE, planar(kind), q, twist)
    np.testing.assert_allclose(J @ found, 2.0 * twist[:2], atol=1e-14)


@pytest.mark.parametrize("elbow", [1e-2, 1e-3, 1e-9, 0.0])
def test_singular_postures_are_damped_within_the_bound(kind: str, elbow: float) -> None:
    q = np.array([0.3, elbow])
    for angle in np.linspace(0.0, math.pi, 7):
        twist = np.array([math.cos(angle), math.sin(angle), 0.0, 0.0, 0.0, 0.0])
        found = velocities(kind, FREE, planar(kind), q, twist)
        np.testing.assert_allclose(
            found, filtered(planar_rates(q), 2.0 * twist[:2]), rtol=1e-9, atol=1e-11
        )
        assert np.linalg.norm(found) <= np.linalg.norm(2.0 * twist[:2]) / BEGINS
        along = np.array([-math.sin(0.3 + elbow / 2), math.cos(0.3 + elbow / 2)])
        missed = planar_rates(q) @ found - 2.0 * twist[:2]
        assert abs(missed @ along) < 0.03  # what the stretched arm can do it does


def test_velocities_do_not_jump_where_damping_begins(kind: str) -> None:
    twist, elbows = np.array([1.0, 0.5, 0, 0, 0, 0]), np.linspace(0.0, 0.1, 2001)
    found = [velocities(kind, FREE, planar(kind), (0.3, elbow), twist) for elbow in elbows]
    speeds = np.linalg.norm(np.diff(found, axis=0), axis=1)
    assert speeds.max() < 1.5 * np.linalg.norm(found, axis=1).max() * 0.1 / 2000 / BEGINS


@pytest.mark.parametrize(
    ("directions", "weights", "turned"),
    [
        ("pitch", (1.0, 0.0, 0.0), lambda q: -math.sin(q[0])),
        ("tilt", (1.0, 1.0, 0.0), None),
        ("rotation", (1.0, 1.0, 1.0), None),
    ],
)
def test_what_the_task_names_of_a_spin_counts(
    kind: str, directions: str, weights: tuple[float, ...], turned: Any
) -> None:
    """Of an arm that turns about the base's y, then about its own x."""
    numbers = arm_of("RR", (ENDLESS,) * 2, directions=directions, miss_weights=(0, 0, 0, *weights))
    q = np.array([0.4, -0.7])
    J = np.array([[0.0, math.cos(0.4)], [1.0, 0.0], [0.0, -math.sin(0.4)]])
    rates = np.array([0.7, -0.3])
    twist = np.array([0.0, 0.0, 0.0, *(J @ rates)])
    found = velocities(kind, arm_numbers(numbers), tilting(kind), q, twist)
    if turned is None:
        np.testing.assert_allclose(found, rates, atol=1e-14)
    else:  # the roll is not asked for
        np.testing.assert_allclose(found, [0.7, 0.0], atol=1e-14)
        step = 1e-6
        change = (turned(q + step * found) - turned(q - step * found)) / (2.0 * step)
        both = (turned(q + step * rates) - turned(q - step * rates)) / (2.0 * step)
        assert change == pytest.approx(both, rel=1e-8)


def test_nan_ends_in_nan(kind: str) -> None:
    twist = np.array([np.nan, 0.0, 0.0, 0.0, 0.0, 0.0])
    assert np.isnan(velocities(kind, FREE, planar(kind), (0.3, 0.8), twist)).all()
