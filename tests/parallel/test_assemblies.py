"""All assemblies against searches from many starts, on the closure equations alone."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from tests.parallel.made import drives, mode, native, poses

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray

    Array = NDArray[Any]

STARTS = 100


def searched(miss: Callable[[Array], Array], starts: FloatArray) -> FloatArray:
    """The distinct zeros that Newton's method finds, derivatives by complex steps."""
    x = starts.copy()
    for _ in range(60):
        columns = [miss(x + 1e-30j * e).imag / 1e-30 for e in np.eye(x.shape[1])]
        step = (np.linalg.pinv(np.stack(columns, axis=-1)) @ miss(x)[..., None])[..., 0]
        longest = np.abs(step).max(axis=1, keepdims=True)
        x = x - step * np.minimum(1.0, 0.5 / np.maximum(longest, 1e-300))
    found: list[FloatArray] = []
    for one in x[np.abs(miss(x)).max(axis=1) < 1e-12]:
        if all(np.abs(one - other).max() > 1e-6 for other in found):
            found.append(one)
    return np.array(found)


def test_a_platform_on_three_cylinders() -> None:
    """At most six; the number and the poses are those of the search."""
    feet = np.array([[0, 0], [1.2, 0], [0.5, 1.1]])
    points = np.array([[-0.2, -0.1], [0.25, -0.1], [0, 0.25]])
    source = np.random.default_rng(2)
    counts = []
    for T in poses("parallel_3rpr")[:6]:
        lengths = drives("parallel_3rpr", mode("parallel_3rpr", T))

        def miss(x: Array, lengths: FloatArray = lengths) -> Array:
            c, s = x[:, 2, None], x[:, 3, None]
            along = x[:, 0, None] + c * points[:, 0] - s * points[:, 1] - feet[:, 0]
            across = x[:, 1, None] + s * points[:, 0] + c * points[:, 1] - feet[:, 1]
            return np.hstack([along**2 + across**2 - lengths**2, c * c + s * s - 1])

        angles = source.uniform(-np.pi, np.pi, STARTS)
        places = source.uniform(-2, 3, (STARTS, 2))
        starts = np.column_stack([places, np.cos(angles), np.sin(angles)])
        wanted = searched(miss, starts)
        found = native("parallel_3rpr").assemblies(lengths)
        have = np.array([[P[0, 3], P[1, 3], P[0, 0], P[1, 0]] for P in found])
        counts.append(len(have))
        assert len(have) == len(wanted)
        assert all(np.abs(have - x).max(axis=1).min() < 1e-8 for x in wanted)
    assert max(counts) >= 4


@pytest.mark.parametrize("name", ["five_bar", "delta"])
def test_circles_and_spheres(name: str) -> None:
    """Two poses of a five-bar and of a Delta, from where their cranks end."""
    size = 2 if name == "five_bar" else 3
    source = np.random.default_rng(3)
    for T in poses(name)[:8]:
        angles = drives(name, mode(name, T))
        if name == "five_bar":
            centers = [[-0.1, 0], [0.1, 0]] + 0.2 * np.column_stack(
                [np.cos(angles), np.sin(angles)]
            )
            radius = 0.3
        else:
            out = 0.164 + 0.524 * np.cos(angles) - 0.044
            around = np.radians([0, 120, 240])
            centers = np.column_stack(
                [out * np.cos(around), out * np.sin(around), -0.524 * np.sin(angles)]
            )
            radius = 1.244

        def miss(x: Array, centers: FloatArray = centers, radius: float = radius) -> Array:
            off: Array = ((x[:, None] - centers) ** 2).sum(axis=2) - radius**2
            return off

        wanted = searched(miss, source.uniform(-2, 2, (12, size)))
        found = native(name).assemblies(angles)[:, :size, 3]
        assert len(found) == len(wanted) == 2
        assert all(np.abs(found - x).max(axis=1).min() < 1e-9 for x in wanted)
