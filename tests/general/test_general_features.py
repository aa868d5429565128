"""The features are a representation of the rigid motions, and the equations hold at solutions."""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.general.determinant import equations, fold
from dhgen.general.digits import grid
from dhgen.general.features import FEATURES, act, monomials, turn
from dhgen.general.formulation import formulations
from dhgen.general.householder import left_null_space
from dhgen.general.loop import close_loop
from dhgen.general.rigid import inverse, multiply
from tests.general.arms import TABLES, constants, forward, gap, kernel, poses


def test_features_compose() -> None:
    A, B = (constants(TABLES["general"])[i] for i in (2, 4))
    x = [1.0, *np.random.default_rng(0).uniform(-1, 1, FEATURES - 1).tolist()]
    once = act(monomials(multiply(A, B)), x)
    np.testing.assert_allclose(act(monomials(A), act(monomials(B), x)), once, atol=1e-14)
    np.testing.assert_allclose(act(monomials(inverse(A)), act(monomials(A), x)), x, atol=1e-14)


def test_a_turn_is_a_rigid_motion() -> None:
    c, s = 0.6, 0.8
    x = [1.0, *np.random.default_rng(1).uniform(-1, 1, FEATURES - 1).tolist()]
    Rz = ((c, -s, 0.0, 0.0), (s, c, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0), (0.0, 0.0, 0.0, 1.0))
    one, cosine, sine = map(np.array, turn(x))
    np.testing.assert_allclose(one + c * cosine + s * sine, act(monomials(Rz), x), atol=1e-15)


def test_null_space_of_dependent_columns() -> None:
    columns = np.random.default_rng(2).uniform(-1, 1, (8, 14))
    columns[3] = columns[1] - 2 * columns[0]
    null = np.array(left_null_space(columns.tolist(), 6))
    np.testing.assert_allclose(null @ columns.T, 0, atol=1e-14)
    np.testing.assert_allclose(null @ null.T, np.eye(6), atol=1e-14)


def test_every_formulation_vanishes_at_solutions() -> None:
    loop = close_loop(constants(TABLES["general"]))
    q, T = poses("general", 1)[0]
    P = np.array(loop.left) @ T @ np.array(loop.right)
    P[:3, 3] /= loop.size
    for formulation in formulations(loop.links):
        E = equations(formulation, P[None])
        angles = formulation.sign * q[formulation.joints[0]] + np.array([0.0, 1e-6, 0.5])
        at_root, beside, elsewhere = np.abs(fold(E, np.cos(angles), np.sin(angles))[0])
        assert at_root < 1e-4 * beside < 1e-2 * elsewhere


@pytest.mark.parametrize(("name", "least"), [("general", 12), ("xarm6", 6), ("jaco2", 2)])
def test_hidden_joints_differ(name: str, least: int) -> None:
    first, second = kernel(name).formulations
    assert first.joints[0] != second.joints[0]
    assert all(score.noise < 1e-12 for score in kernel(name).scores), least


def test_frames_may_stand_anywhere_on_their_axes() -> None:
    table = TABLES["general"]
    moved = list(constants(table))
    slide = np.eye(4)
    slide[2, 3] = 3.7
    moved[2] = tuple(map(tuple, (np.array(moved[2]) @ slide).tolist()))
    moved[3] = tuple(map(tuple, (np.linalg.inv(slide) @ np.array(moved[3])).tolist()))
    for K, L in zip(close_loop(constants(table)).links, close_loop(moved).links, strict=True):
        np.testing.assert_allclose(K, L, atol=1e-8)


def test_an_arm_without_lengths_is_refused() -> None:
    wrist = tuple((0, 0.0, 0.0, 1) for _ in range(6))
    with pytest.raises(ValueError, match="meet in one point"):
        close_loop(constants(wrist))
    with pytest.raises(ValueError, match="seven"):
        close_loop(constants(wrist)[:5])


def test_digits() -> None:
    cosines, sines = grid()
    angles = np.outer(np.arange(1, 9), np.arange(128)) * 2 * np.pi / 256
    np.testing.assert_allclose(cosines, np.cos(angles), atol=1e-14)
    np.testing.assert_allclose(sines, np.sin(angles), atol=1e-14)


def test_gap_wraps() -> None:
    assert gap(np.array([[np.pi, 0.0]]), np.array([-np.pi, 1e-3]))[0] == pytest.approx(1e-3)
    assert forward(TABLES["general"], [0.0] * 6).shape == (4, 4)
