"""The monomials are a representation of the rigid motions, and the equations hold at solutions."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.general.determinant import equations, fold
from dhgen.general.formulation import OTHERS, formulations
from dhgen.general.links import Link
from dhgen.general.loop import close_loop
from dhgen.general.monomials import MONOMIALS, act, slide, turn
from dhgen.kinematics.rigid import along_z, inverse, multiply
from dhgen.kinematics.rigid import turn as rotation
from dhgen.runtime.python.general.tables import GRID_C, GRID_S
from tests.general.arms import TABLES, constants, forward, gap, kernel

if TYPE_CHECKING:
    from dhgen.kinematics.rigid import Matrix


def lanes(*matrices: Matrix) -> np.ndarray:
    """Transforms (4, 4, N)."""
    return np.moveaxis(np.array(matrices), 0, -1)


def motion(value: float, *, slides: bool) -> np.ndarray:
    """The transform of a joint, (4, 4)."""
    return np.array(along_z(value) if slides else rotation(np.cos(value), np.sin(value)))


def some_features(seed: int) -> np.ndarray:
    """(15, 1, 1), the first of them 1."""
    x = np.random.default_rng(seed).uniform(-1, 1, (MONOMIALS, 1, 1))
    x[0] = 1.0
    return x


def test_features_compose() -> None:
    A, B = (constants(TABLES["general"])[i] for i in (2, 4))
    x = some_features(0)
    once = act(lanes(multiply(A, B)), x)
    np.testing.assert_allclose(act(lanes(A), act(lanes(B), x)), once, atol=1e-14)
    np.testing.assert_allclose(act(lanes(inverse(A)), act(lanes(A), x)), x, atol=1e-14)


def test_a_turn_is_a_rigid_motion() -> None:
    c, s = 0.6, 0.8
    x = some_features(1)
    one, cosine, sine = turn(x)
    Rz = ((c, -s, 0.0, 0.0), (s, c, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0), (0.0, 0.0, 0.0, 1.0))
    np.testing.assert_allclose(one + c * cosine + s * sine, act(lanes(Rz), x), atol=1e-15)


def test_a_slide_is_a_rigid_motion() -> None:
    d = 0.7
    x = some_features(2)
    one, first, square = slide(x)
    Tz = lanes(along_z(d))
    np.testing.assert_allclose(one + d * first + d * d * square, act(Tz, x), atol=1e-15)


@pytest.mark.parametrize("slides", [(), (0,), (1,), (2,), (3,), (4,), (5,)])
def test_every_formulation_vanishes_at_solutions(slides: tuple[int, ...]) -> None:
    random = np.random.default_rng(3)
    q = random.uniform(-1, 1, 6)
    loop = close_loop([Link(C) for C in constants(TABLES["general"])], slides)
    links = [np.array(K.first) for K in loop.links]
    P = np.eye(4)
    for i, value in enumerate(q):
        P = P @ (links[i - 1] if i else np.eye(4)) @ motion(value, slides=i in slides)
    every = (*formulations(slides), *(formulations(slides, OTHERS) if slides else ()))
    assert len(every) == (8 if slides else 12)
    for formulation in every:
        around = [link[None] for link in formulation.links(links, P)]
        E = equations(around, formulation.slides(slides))
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
    once, again = (close_loop([Link(C) for C in each]) for each in (constants(table), moved))
    for K, L in zip(once.links, again.links, strict=True):
        np.testing.assert_allclose(K.first, L.first, atol=1e-8)


def test_an_arm_without_lengths_is_refused() -> None:
    wrist = tuple((0, 0.0, 0.0, 1) for _ in range(6))
    with pytest.raises(ValueError, match="meet in one point"):
        close_loop([Link(C) for C in constants(wrist)])
    with pytest.raises(ValueError, match="seven"):
        close_loop([Link(C) for C in constants(wrist)[:5]])


def test_digits() -> None:
    angles = np.outer(np.arange(1, 9), np.arange(128)) * 2 * np.pi / 256
    np.testing.assert_allclose(GRID_C, np.cos(angles), atol=1e-14)
    np.testing.assert_allclose(GRID_S, np.sin(angles), atol=1e-14)


def test_gap_wraps() -> None:
    assert gap(np.array([[np.pi, 0.0]]), np.array([-np.pi, 1e-3]))[0] == pytest.approx(1e-3)
    assert forward(TABLES["general"], [0.0] * 6).shape == (4, 4)
