"""Every kernel against its equations: all roots by brute force, and nothing else."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.paul.kind import Kind
from tests.program.kernel_programs import kernel_program, run

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.arrays import FloatArray
    from dhgen.program.interpret import Rows

COUNT = 40
GRID = np.linspace(-np.pi, np.pi, 1441)


def numbers(letters: int, seed: int, count: int = COUNT) -> FloatArray:
    return np.random.default_rng(seed).uniform(-1.0, 1.0, (count, letters))


def zeros_of(function: Callable[[FloatArray], FloatArray]) -> FloatArray:
    """Simple roots in a turn, by sign changes on a grid and bisection."""
    values = function(GRID)
    places = np.flatnonzero(values[:-1] * values[1:] < 0)
    low, high = GRID[places], GRID[places + 1]
    for _ in range(60):
        middle = 0.5 * (low + high)
        left = function(low) * function(middle) <= 0
        low, high = np.where(left, low, middle), np.where(left, middle, high)
    return np.sort(0.5 * (low + high))


def linear(x: float, y: float, z: float, t: FloatArray) -> FloatArray:
    return np.asarray(x * np.sin(t) + y * np.cos(t) - z)


def beyond(reach: float, t: FloatArray) -> FloatArray:
    """How much longer than `reach` links 3 and 2 are at an elbow."""
    return np.asarray(np.hypot(3 + 2 * np.cos(t), 2 * np.sin(t)) - reach)


def angles(rows: FloatArray) -> FloatArray:
    """The angles of rows that end in cosine and sine, checked to be those of an angle."""
    rows = rows[np.isfinite(rows).all(axis=1)]
    np.testing.assert_allclose(np.hypot(rows[:, -2], rows[:, -1]), 1.0, rtol=0, atol=1e-9)
    return np.sort(np.arctan2(rows[:, -1], rows[:, -2]))


def test_type_1_is_a_quotient() -> None:
    given = numbers(2, 1)
    found = run(kernel_program(Kind.LENGTH, {"Y": None, "X": None}, slides=True), given)
    np.testing.assert_allclose(found.q[:, 0, 0], given[:, 0] / given[:, 1], rtol=1e-14)


def test_type_1_without_a_factor_takes_the_seed_or_has_no_solution() -> None:
    program = kernel_program(Kind.LENGTH, {"Y": None, "X": None}, slides=True)
    found = run(program, np.array([[0.0, 0.0], [1e-3, 0.0], [1.0, 1e-9]]), seed=0.7)
    assert found.solved[:, 0].tolist() == [True, False, False]
    assert found.free[:, 0].tolist() == [True, False, False]
    assert found.q[0, 0, 0] == 0.7


def test_type_2_finds_every_root_and_no_other() -> None:
    given = numbers(3, 2)
    found = run(kernel_program(Kind.ANGLE, {"X": None, "Y": None, "Z": None}), given)
    counts = set()
    for (x, y, z), rows in zip(given, found.q, strict=True):
        roots = zeros_of(partial(linear, x, y, z))
        np.testing.assert_allclose(angles(rows), roots, rtol=0, atol=1e-8)
        counts.add(len(roots))
    assert counts == {0, 2}


def test_type_2_without_a_right_side() -> None:
    given = numbers(2, 3)
    found = run(kernel_program(Kind.ANGLE, {"X": None, "Y": None, "Z": 0}), given)
    for (x, y), rows in zip(given, found.q, strict=True):
        roots = zeros_of(partial(linear, x, y, 0.0))
        np.testing.assert_allclose(angles(rows), roots, rtol=0, atol=1e-12)
        assert len(roots) == 2


@pytest.mark.parametrize("angle", [0.3, -2.0, 3.0])
@pytest.mark.parametrize("facing", [1.0, -1.0])
def test_type_2_double_root_stands_once(angle: float, facing: float) -> None:
    x, y = np.sin(angle), np.cos(angle)
    program = kernel_program(Kind.ANGLE, {"X": None, "Y": None, "Z": None})
    found = run(program, np.array([[x, y, facing * np.hypot(x, y)]]))
    assert found.solved.tolist() == [[True, False]]
    wanted = [np.cos(angle) * facing, np.sin(angle) * facing]
    np.testing.assert_allclose(found.q[0, 0], wanted, rtol=0, atol=1e-12)


@pytest.mark.parametrize("seed", [0.0, 2.5, -4.0])
def test_type_2_takes_the_seed_where_nothing_is_fixed(seed: float) -> None:
    program = kernel_program(Kind.ANGLE, {"X": None, "Y": None, "Z": None})
    found = run(program, np.zeros((1, 3)), seed)
    assert (found.solved.tolist(), found.free.tolist()) == ([[True, False]], [[True, False]])
    assert found.q[0, 0].tolist() == [np.cos(seed), np.sin(seed)]


def test_type_2_is_unreachable_where_nothing_is_equal() -> None:
    program = kernel_program(Kind.ANGLE, {"X": None, "Y": None, "Z": None})
    assert not run(program, np.array([[0.0, 0.0, 0.1], [0.3, 0.4, 0.5001]])).solved.any()


@pytest.mark.parametrize("seed", [0.0, 2.5])
def test_type_2_without_a_right_side_free(seed: float) -> None:
    program = kernel_program(Kind.ANGLE, {"X": None, "Y": None, "Z": 0})
    found = run(program, np.zeros((1, 2)), seed)
    assert found.free.tolist() == [[True, False]]
    assert found.q[0, 0].tolist() == [np.cos(seed), np.sin(seed)]


TURNED: dict[int, dict[str, int | str | None]] = {
    1: {"X1": None, "Y1": None, "Z1": None, "X2": "-Y1", "Y2": "X1", "Z2": None},
    -1: {"X1": None, "Y1": None, "Z1": None, "X2": "Y1", "Y2": "-X1", "Z2": None},
}


@pytest.mark.parametrize("facing", [1, -1])
def test_type_3_turned_rows(facing: int) -> None:
    """Factors (X, Y) and (-Y, X) or (Y, -X): right sides of any length give the direction."""
    given = numbers(4, 4)
    found = run(kernel_program(Kind.ANGLE_PAIR, TURNED[facing]), given)
    theta = angles_of_rows(found.q[:, 0])
    for (x, y, z1, z2), t in zip(given, theta, strict=True):
        ratio = np.hypot(x, y) / np.hypot(z1, z2)
        first = x * np.sin(t) + y * np.cos(t)
        second = facing * (-y * np.sin(t) + x * np.cos(t))
        np.testing.assert_allclose([first, second], [z1 * ratio, z2 * ratio], rtol=0, atol=1e-12)


def angles_of_rows(rows: FloatArray) -> FloatArray:
    np.testing.assert_allclose(np.hypot(rows[:, 0], rows[:, 1]), 1.0, rtol=0, atol=1e-12)
    return np.arctan2(rows[:, 1], rows[:, 0])


def test_type_3_is_free_where_both_rows_vanish() -> None:
    program = kernel_program(Kind.ANGLE_PAIR, TURNED[1])
    found = run(program, np.zeros((1, 4)), seed=1.25)
    assert found.free.tolist() == [[True]]
    assert found.q[0, 0].tolist() == [np.cos(1.25), np.sin(1.25)]


@pytest.mark.parametrize("factors", [(1, 0, 0, 1), (0, 2, 3, 0), (1, 2, -3, 1), (2, 1, 1, -1)])
def test_type_3_whole_factors(factors: tuple[int, int, int, int]) -> None:
    """With constant factors it is Cramer's rule, for determinants of both signs."""
    x1, y1, x2, y2 = factors
    letters = {"X1": x1, "Y1": y1, "Z1": None, "X2": x2, "Y2": y2, "Z2": None}
    theta = np.random.default_rng(5).uniform(-np.pi, np.pi, COUNT)
    sides = np.stack(
        [x1 * np.sin(theta) + y1 * np.cos(theta), x2 * np.sin(theta) + y2 * np.cos(theta)]
    )
    found = run(kernel_program(Kind.ANGLE_PAIR, letters), sides.T)
    np.testing.assert_allclose(angles_of_rows(found.q[:, 0]), theta, rtol=0, atol=1e-12)


def test_type_4_is_polar() -> None:
    given = numbers(4, 6)
    letters = {"X1": None, "Y1": None, "X2": None, "Y2": None}
    found = run(kernel_program(Kind.POLAR, letters, slides=True), given)
    x1, y1, x2, y2 = given.T[:, :, None]
    r, c, s = np.moveaxis(found.q, 2, 0)
    np.testing.assert_allclose(x1 * r * s, np.broadcast_to(y1, r.shape), rtol=0, atol=1e-12)
    np.testing.assert_allclose(x2 * r * c, np.broadcast_to(y2, r.shape), rtol=0, atol=1e-12)
    np.testing.assert_allclose(c * c + s * s, 1.0, rtol=0, atol=1e-12)
    assert (r[:, 0] > 0).all()
    assert (r[:, 1] < 0).all()


def test_type_4_at_the_centre_is_one_free_angle() -> None:
    letters = {"X1": None, "Y1": None, "X2": None, "Y2": None}
    program = kernel_program(Kind.POLAR, letters, slides=True)
    found = run(program, np.array([[0.5, 0.0, -2.0, 0.0]]), seed=0.75)
    assert (found.solved.tolist(), found.free.tolist()) == ([[True, False]], [[True, False]])
    assert found.q[0, 0].tolist() == [0.0, np.cos(0.75), np.sin(0.75)]


def test_type_5_finds_every_root_and_no_other() -> None:
    given = numbers(6, 7)
    letters = dict.fromkeys(("X1", "Y1", "Z1", "X2", "Y2", "Z2"))
    found = run(kernel_program(Kind.ANGLE_AND_LENGTH, letters, slides=True), given)
    counts = set()
    for (x1, y1, z1, x2, y2, z2), rows in zip(given, found.q, strict=True):
        # |(Y1 + Z1 r) / X1, (Y2 + Z2 r) / X2| = 1
        squares = np.polyadd(
            np.polymul([z1 / x1, y1 / x1], [z1 / x1, y1 / x1]),
            np.polymul([z2 / x2, y2 / x2], [z2 / x2, y2 / x2]),
        )
        roots = np.roots(np.polysub(squares, [1.0]))
        real = np.sort(roots[np.abs(roots.imag) < 1e-12].real)
        solved = rows[np.isfinite(rows).all(axis=1)]
        np.testing.assert_allclose(np.sort(solved[:, 0]), real, rtol=1e-7, atol=1e-7)
        for r, c, s in solved:
            np.testing.assert_allclose([x1 * s, x2 * c], [y1 + z1 * r, y2 + z2 * r], atol=1e-9)
        counts.add(len(real))
    assert counts == {0, 2}


def test_type_5_touching_stands_once() -> None:
    """s = r, c = 1: the line touches the circle at r = 0."""
    letters = dict.fromkeys(("X1", "Y1", "Z1", "X2", "Y2", "Z2"))
    program = kernel_program(Kind.ANGLE_AND_LENGTH, letters, slides=True)
    found = run(program, np.array([[1.0, 0.0, 1.0, 1.0, 1.0, 0.0]]))
    assert found.solved.tolist() == [[True, False]]
    np.testing.assert_allclose(found.q[0, 0], [0.0, 1.0, 0.0], rtol=0, atol=1e-12)


def test_type_5_beside_the_circle_is_unreachable() -> None:
    letters = dict.fromkeys(("X1", "Y1", "Z1", "X2", "Y2", "Z2"))
    program = kernel_program(Kind.ANGLE_AND_LENGTH, letters, slides=True)
    assert not run(program, np.array([[1.0, 0.0, 1.0, 1.0, 1.001, 0.0]])).solved.any()


def test_type_10_finds_every_root_and_no_other() -> None:
    given = numbers(3, 10)
    program = kernel_program(Kind.SQUARED_LENGTH, dict.fromkeys("XYZ"), slides=True)
    found = run(program, given)
    counts = set()
    for (x, y, z), rows in zip(given, found.q[..., 0], strict=True):
        roots = np.roots([x, y, -z])
        real = np.sort(roots[np.abs(roots.imag) < 1e-12].real)
        np.testing.assert_allclose(np.sort(rows[np.isfinite(rows)]), real, rtol=1e-9, atol=1e-9)
        counts.add(len(real))
    assert counts == {0, 2}


def test_type_10_touching_stands_once() -> None:
    """2 r^2 - 4 r = -2 has the double root 1."""
    program = kernel_program(Kind.SQUARED_LENGTH, dict.fromkeys("XYZ"), slides=True)
    found = run(program, np.array([[2.0, -4.0, -2.0]]))
    assert found.solved.tolist() == [[True, False]]
    assert found.q[0, 0].tolist() == [1.0]


LINKS = {"V1": 3, "V2": 0, "W1": 2, "W2": 0}  # lengths 3 and 2
TWO = {**LINKS, "X": 0, "Y": 12, "N": 13, "Z1": None, "Z2": None}


def two_angles(points: FloatArray) -> Rows:
    """Law of cosines for links 3 and 2: 12 c = |Z|^2 - 13; letters in the pose in their order."""
    return run(kernel_program(Kind.ANGLE_AND_SUM, TWO), points)


def test_types_6_to_8_by_the_law_of_cosines() -> None:
    points = np.random.default_rng(8).uniform(-5.0, 5.0, (COUNT, 2))
    found = two_angles(points)
    counts = set()
    for point, rows in zip(points, found.q, strict=True):
        reach = np.hypot(*point)
        elbow = zeros_of(partial(beyond, reach))
        np.testing.assert_allclose(angles(rows), elbow, rtol=0, atol=1e-9)
        counts.add(len(elbow))
    assert counts == {0, 2}


@pytest.mark.parametrize(("reach", "cosine"), [(5.0, 1.0), (1.0, -1.0)])
def test_stretched_and_folded_stand_once(reach: float, cosine: float) -> None:
    turns = np.random.default_rng(9).uniform(-np.pi, np.pi, 50)
    found = two_angles(reach * np.stack([np.cos(turns), np.sin(turns)], axis=1))
    assert found.solved.tolist() == [[True, False]] * 50
    np.testing.assert_allclose(found.q[:, 0, 0], cosine, rtol=0, atol=1e-12)


def test_a_little_out_of_reach_is_out_of_reach() -> None:
    assert not two_angles(np.array([[5.0 + 1e-9, 0.0], [0.0, 1.0 - 1e-9]])).solved.any()
