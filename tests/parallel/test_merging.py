"""All assemblies where two of them meet: row by row alike in both languages, and as many as are."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from tests.parallel.made import native, python
from tests.structures import quick_first

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.arrays import FloatArray

# Beyond the drives at which two assemblies meet, along the way that parts them: apart by the root.
BEYOND = (1e-3, 1e-5, 1e-7, 1e-9, 1e-10)
ROUNDED = (1e-14, 0.0, -1e-14)  # less than legs may miss the platform by
FEET = np.array([[0, 0], [-1.43, -0.14], [-0.77, -1.42]])
POINTS = np.array([[0, 0], [1.16, 0.79], [0.84, 0.08]])


def alike(name: str, drives: FloatArray) -> FloatArray:
    """The assemblies in C, which are those in Python."""
    found, others = native(name).assemblies(drives), python(name).assemblies(drives)
    assert len(found) == len(others), drives
    # two that merge lie in the root of rounding
    np.testing.assert_allclose(found, others, rtol=0, atol=1e-6)
    return found


def demand_a_merge(name: str, at: Callable[[float], FloatArray], others: int) -> None:
    """Two assemblies beyond the drives at which they meet, there one, before it none."""
    for step in BEYOND:
        found = alike(name, at(step))
        assert len(found) == others + 2, step
        exact = python(name).assemblies(at(step))
        np.testing.assert_allclose(found, exact, rtol=0, atol=1e-13 / np.sqrt(step))
        assert len(alike(name, at(-step))) == others, -step
    for step in ROUNDED:
        assert len(alike(name, at(step))) == others + 1, step


def test_two_circles_that_touch() -> None:
    """A five-bar with unequal legs: its cranks end as far apart as both rods reach."""
    feet, cranks, rods = (-0.1, 0.2), (0.3, 0.25), 0.2 + 0.35

    def reach(angles: FloatArray) -> float:
        ends = [
            np.array([x + crank * np.cos(q), crank * np.sin(q)])
            for x, crank, q in zip(feet, cranks, angles, strict=True)
        ]
        return rods - float(np.linalg.norm(ends[1] - ends[0]))

    for first in (1.9, 2.4, 3.0):
        low, high = 0.0, 2.5  # of the other crank: too far apart, and not
        assert reach(np.array([first, low])) < 0.0 < reach(np.array([first, high]))
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (low, middle) if reach(np.array([first, middle])) > 0.0 else (middle, high)

        def at(step: float, first: float = first, meet: float = low) -> FloatArray:
            return np.array([first, meet + step])

        demand_a_merge("unequal_five_bar", at, 0)


@pytest.mark.slow
def test_three_spheres_that_touch() -> None:
    """A linear Delta whose rods lie in a plane: the circle of their upper ends has their length."""
    corners = np.array([[np.cos(angle), np.sin(angle)] for angle in np.radians([0, 120, 240])])

    def reach(heights: FloatArray) -> float:
        points = np.column_stack([0.16 * corners, heights])
        a, b, c = (np.linalg.norm(points[i] - points[i - 1]) for i in range(3))
        area = np.linalg.norm(np.cross(points[1] - points[0], points[2] - points[0])) / 2
        return 0.3 - float(a * b * c / (4 * area))

    for way in np.array([[0, 0, 1], [0.2, 0, 1], [1, 0.3, 0]]):
        low, high = 0.0, 1.2
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if reach(middle * way) > 0.0 else (low, middle)

        def at(step: float, way: FloatArray = way, meet: float = low) -> FloatArray:
            return (meet - step) * way + 0.05

        demand_a_merge("linear_delta", at, 0)


def lengths(place: FloatArray) -> FloatArray:
    """Those of the cylinders of a platform at x, y, yaw."""
    return np.asarray(np.linalg.norm(rods(place), axis=1))


def rods(place: FloatArray) -> FloatArray:
    """From the feet to the platform's points."""
    c, s = np.cos(place[2]), np.sin(place[2])
    return np.asarray(POINTS @ np.array([[c, s], [-s, c]]) + place[:2] - FEET)


def rates(place: FloatArray) -> FloatArray:
    """How the lengths follow x, y, yaw."""
    units = rods(place) / lengths(place)[:, None]
    arms = rods(place) + FEET - place[:2]
    return np.column_stack([units, arms[:, 0] * units[:, 1] - arms[:, 1] * units[:, 0]])


def test_two_of_the_roots_of_a_platform_on_three_cylinders() -> None:
    """Places where A is singular, drives off them along what A misses; the other roots stay."""
    source = np.random.default_rng(1)
    counts: list[int] = []
    while len(counts) < 12:
        one, other = source.uniform([-1, -1, -np.pi], [1, 1, np.pi], (2, 3))
        sign = np.linalg.det(rates(one))
        if sign * np.linalg.det(rates(other)) > 0.0:
            continue
        low, high = 0.0, 1.0
        for _ in range(80):
            middle = 0.5 * (low + high)
            is_before = sign * np.linalg.det(rates(one + middle * (other - one))) > 0.0
            low, high = (middle, high) if is_before else (low, middle)
        meet = one + low * (other - one)
        left, values, right = np.linalg.svd(rates(meet))
        ahead, behind = (lengths(meet + step * right[-1]) for step in (1e-3, -1e-3))
        bend = float(left[:, -1] @ (ahead - 2.0 * lengths(meet) + behind)) / 1e-6
        if values[1] < 0.1 or abs(bend) < 0.3 or abs(bend) > 3.0:
            continue
        way = np.sign(bend) * left[:, -1]

        def at(step: float, way: FloatArray = way, meet: FloatArray = meet) -> FloatArray:
            return lengths(meet) + step * way

        others = len(alike("six_assemblies", at(1e-3))) - 2
        demand_a_merge("six_assemblies", at, others)
        counts.append(others)
    assert set(counts) >= {0, 2}


@pytest.mark.parametrize("name", quick_first(["six_assemblies", "parallel_3rpr"]))
def test_assemblies_of_three_circles_ascend(name: str) -> None:
    """By their yaw, so that a pose's row does not hang on where a search began."""
    source = np.random.default_rng(6)
    seen = 0
    for _ in range(60):
        drives = source.uniform(0.6, 2.2, 3)
        found = alike(name, drives)
        yaw = np.arctan2(found[:, 1, 0], found[:, 0, 0])
        assert (np.diff(yaw) > 0.0).all()
        seen += len(found)
    assert seen > 60
