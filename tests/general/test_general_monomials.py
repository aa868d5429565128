"""The monomials are a representation of the rigid motions, and the equations hold at solutions."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.general.formulation import OTHERS, formulations
from dhgen.general.links import Link
from dhgen.general.loop import close_loop
from dhgen.general.trial import _as_arrays
from dhgen.kinematics.rigid import along_z, inverse, multiply
from dhgen.kinematics.rigid import turn as rotation
from dhgen.numerical.runtime_arm import twelve
from dhgen.runtime.python.general.places import LAST, LEFT_SLIDE, SLIDES
from dhgen.runtime.python.general.tables import GRID_C, GRID_S, SAMPLES
from tests.general.arms import TABLES, constants, forward, gap, kernel
from tests.runtime.plain import part

if TYPE_CHECKING:
    from dhgen.kinematics.rigid import Matrix


MONOMIALS = 15


def act(K: Matrix, x: np.ndarray) -> np.ndarray:
    """Monomials (15, n) moved by a rigid motion, as the runtime moves them."""
    moved = x.copy()
    part("plain", "general.equations").act(np.array(twelve(K)), moved)
    return moved


def behind(x: np.ndarray, *, slides: bool) -> np.ndarray:
    """The coefficients of what a joint makes of them, one part after the other."""
    arm = np.zeros(LAST)
    arm[SLIDES], arm[LEFT_SLIDE] = slides, 0.0
    still = np.eye(4)[:3].ravel()
    parts = part("plain", "general.equations").pass_link(arm, still, x.copy(), 0, powers=False)
    return np.asarray(np.split(parts, 3, axis=1))


def motion(value: float, *, slides: bool) -> np.ndarray:
    """The transform of a joint, (4, 4)."""
    return np.array(along_z(value) if slides else rotation(np.cos(value), np.sin(value)))


def some_monomials(seed: int) -> np.ndarray:
    """(15, 1), of a point and a direction."""
    p, z = np.random.default_rng(seed).uniform(-1, 1, (2, 3))
    scalars = [p @ p, p @ z]
    last = p @ p * z - 2.0 * (p @ z) * p
    return np.array([1.0, *z, *p, *scalars, *np.cross(p, z), *last])[:, None]


def test_monomials_compose() -> None:
    A, B = (constants(TABLES["general"])[i] for i in (2, 4))
    x = some_monomials(0)
    once = act(multiply(A, B), x)
    np.testing.assert_allclose(act(A, act(B, x)), once, atol=1e-14)
    np.testing.assert_allclose(act(inverse(A), act(A, x)), x, atol=1e-14)


def test_a_turn_is_a_rigid_motion() -> None:
    c, s = 0.6, 0.8
    x = some_monomials(1)
    one, cosine, sine = behind(x, slides=False)
    np.testing.assert_allclose(one + c * cosine + s * sine, act(rotation(c, s), x), atol=1e-15)


def test_a_slide_is_a_rigid_motion() -> None:
    d = 0.7
    x = some_monomials(2)
    one, first, square = behind(x, slides=True)
    np.testing.assert_allclose(one + d * first + d * d * square, act(along_z(d), x), atol=1e-15)


@pytest.mark.parametrize("slides", [(), (0,), (1,), (2,), (3,), (4,), (5,)])
def test_every_formulation_vanishes_at_solutions(slides: tuple[int, ...]) -> None:
    random, runtime = np.random.default_rng(3), part("plain", "general.equations")
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
        arm, joints, every_link = _as_arrays(formulation, around, slides)
        E = runtime.equations(arm, joints, every_link[0])
        angles = np.resize([0.0, 1e-6, 0.5], SAMPLES) + formulation.sign * q[joints[0]]
        determinants = np.empty(SAMPLES)
        runtime.fold(E, np.cos(angles), np.sin(angles), determinants)
        at_root, beside, elsewhere = np.abs(determinants[:3])
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
