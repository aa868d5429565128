"""The oracle's forward kinematics against itself: batches, derivatives, and changes of units."""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.oracle.arm import arm
from dhgen.oracle.forward import forward, forward_with_derivatives, jacobian
from dhgen.oracle.poses import random_joints
from tests.robots.cases import NAMES, assert_close, robot

STEP = 1e-30  # an imaginary step has no cancellation, however small


@pytest.mark.parametrize("name", NAMES)
def test_a_batch_is_its_rows(name: str) -> None:
    q = random_joints(robot(name), 6)
    T = forward(robot(name), q.reshape(2, 3, -1)).reshape(6, 4, 4)
    for row, expected in zip(q, T, strict=True):
        assert_close(forward(robot(name), row), expected, 1e3)


@pytest.mark.parametrize("name", NAMES)
def test_derivatives_are_those_of_an_imaginary_step(name: str) -> None:
    q = random_joints(robot(name), 3)
    T, dT = forward_with_derivatives(arm(robot(name)), q)
    assert_close(T, forward(robot(name), q), 1e3)
    for joint in range(q.shape[1]):
        stepped = q.astype(complex)
        stepped[:, joint] += 1j * STEP
        assert_close(dT[:, joint], forward(robot(name), stepped).imag / STEP, 1e4)


def test_jacobian_of_a_planar_arm() -> None:
    q1, q12 = 0.3, 1.5
    J = jacobian(robot("planar_rr"), [q1, q12 - q1])
    x, y = -0.4 * np.sin(q1) - 0.3 * np.sin(q12), 0.4 * np.cos(q1) + 0.3 * np.cos(q12)
    expected = [[x, -0.3 * np.sin(q12)], [y, 0.3 * np.cos(q12)], [0, 0], [0, 0], [0, 0], [1, 1]]
    assert_close(J, expected)


def test_jacobian_stands_in_the_base_frame() -> None:
    # the Adept's vertical axis is the world's x axis, and its slide moves against it
    J = jacobian(robot("adept"), [0.1, 0.2, 30.0])
    assert_close(J[3:], [[1, 1, 0], [0, 0, 0], [0, 0, 0]])
    assert_close(J[:3, 2], [-1, 0, 0])


@pytest.mark.parametrize("name", NAMES)
def test_lengths_divide_out(name: str) -> None:
    model = arm(robot(name))
    q = random_joints(robot(name), 3)
    T = forward(model, q)
    T[:, :3, 3] /= 7
    assert_close(forward(model.divided_by(7), np.where(model.revolute, q, q / 7)), T, 1e3)
