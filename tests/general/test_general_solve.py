"""All solutions, in C, by numba and in plain Python: random poses, special ones, alike in all."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.general.arms import TABLES, compiled, forward, gap, kernel, poses
from tests.general.solved import solve, solve_slowly
from tests.structures import first_of

TIE = 1e-6  # what is known of an angle where solutions meet, with some room [rad]
# The pose of Manseur and Doty at which all sixteen solutions are real.
SIXTEEN = [
    [-0.760117, -0.641689, 0.102262, -1.140175],
    [0.133333, 0.0, 0.991071, 0.0],
    [-0.635959, 0.766965, 0.085558, 0.0],
    [0.0, 0.0, 0.0, 1.0],
]


def check(name: str, T: np.ndarray, q: np.ndarray, residual: np.ndarray, groups: int = 1) -> None:
    """Every row is a solution, no two are the same, and they are in order.

    Singular ones begin again behind all others, and those that lie together with one: three groups.
    """
    assert (residual < 1e-9).all()
    assert np.abs(forward(TABLES[name], q) - T).max(initial=0.0) < 1e-9
    for i, row in enumerate(q):
        assert (gap(q[:i], row) > 1e-7).all()
    # angles that agree to rounding don't decide, and -pi comes where pi does
    first = np.where(q[:, 0] < TIE - np.pi, q[:, 0] + 2.0 * np.pi, q[:, 0])
    assert (np.diff(first) < -TIE).sum() < groups
    assert ((q > -np.pi) & (q <= np.pi)).all()


@pytest.mark.slow
@pytest.mark.parametrize("name", TABLES)
def test_reference(name: str) -> None:
    for q, T in poses(name, 5):
        found = solve(T, kernel(name))
        check(name, T, found.q, found.residual)
        assert found.certain
        assert gap(found.q, q).min() < 1e-6
        assert len(found.q) % 2 == 0


@pytest.mark.parametrize("name", TABLES)
def test_c(name: str) -> None:
    doubtful = 0
    for q, T in poses(name, 300, seed=1):
        found, residual, certain = compiled(name)(T)
        check(name, T, found, residual)
        doubtful += not certain
        assert gap(found, q).min() < 1e-6
        assert len(found) % 2 == 0
    assert doubtful <= 6  # where roots nearly meet it is not certain that there are no others


@pytest.mark.slow
@pytest.mark.parametrize("lanes", first_of([2, 1, 4]))
def test_c_with_other_lanes(lanes: int) -> None:
    name = "manseur_doty"
    unsure = "-Wno-maybe-uninitialized"  # of gcc's -O1, where a loop is of one number
    other = compiled(name, f"-D{name.upper()}_LANES={lanes}", unsure)
    for _, T in poses(name, 20, seed=2):
        np.testing.assert_allclose(other(T)[0], compiled(name)(T)[0], atol=1e-8)


@pytest.mark.slow
@pytest.mark.parametrize("name", ["general", "jaco2"])
def test_all_agree(name: str) -> None:
    for _, T in poses(name, 3, seed=3):
        found, _, _ = compiled(name)(T)
        for other in (solve(T, kernel(name)), solve_slowly(T, kernel(name))):
            np.testing.assert_allclose(other.q, found, atol=1e-8)


def test_the_closed_form_of_an_offset_wrist() -> None:
    assert kernel("xarm6").wrist is not None
    assert kernel("jaco2").wrist is None
    assert kernel("general").wrist is None


@pytest.mark.slow
def test_without_the_closed_form() -> None:
    plain = replace(kernel("xarm6"), wrist=None)
    for _, T in poses("xarm6", 3, seed=5):
        np.testing.assert_allclose(solve(T, plain).q, compiled("xarm6")(T)[0], atol=1e-8)


def test_sixteen_solutions() -> None:
    T = np.array(SIXTEEN)
    U, _, V = np.linalg.svd(T[:3, :3])  # printed to six digits only
    T[:3, :3] = U @ V
    q, residual, certain = compiled("manseur_doty")(T)
    assert certain
    assert len(q) == 16
    check("manseur_doty", T, q, residual)


@pytest.mark.parametrize("name", TABLES)
def test_right_angles(name: str) -> None:
    random = np.random.default_rng(4)
    for q in [np.zeros(6), *random.choice([0.0, np.pi / 2, np.pi, -np.pi / 2], (40, 6))]:
        T = forward(TABLES[name], q)
        found, residual, _ = compiled(name)(T)
        check(name, T, found, residual, groups=3)
        assert len(found) > 0


def test_out_of_reach() -> None:
    T = np.eye(4)
    T[:3, 3] = 20.0
    for name in TABLES:
        q, _, certain = compiled(name)(T)
        assert len(q) == 0
        assert certain


@pytest.mark.breadth
def test_silent_c() -> None:
    compiled("general", "-O3")
    compiled("general", "-O3", "-DGENERAL_LANES=1")
