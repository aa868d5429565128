"""All assemblies against searches from many starts, on the closure equations alone."""

from __future__ import annotations

import ctypes
import shutil
import subprocess
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from tests.parallel.made import GENERATED, drives, mode, native, poses, python

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

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


def on_three_cylinders(feet: Array, points: Array, lengths: FloatArray) -> FloatArray:
    """Poses x, y, cos, sin of a platform whose points are so far from their feet."""
    source = np.random.default_rng(2)

    def miss(x: Array) -> Array:
        c, s = x[:, 2, None], x[:, 3, None]
        along = x[:, 0, None] + c * points[:, 0] - s * points[:, 1] - feet[:, 0]
        across = x[:, 1, None] + s * points[:, 0] + c * points[:, 1] - feet[:, 1]
        return np.hstack([along**2 + across**2 - lengths**2, c * c + s * s - 1])

    angles = source.uniform(-np.pi, np.pi, STARTS)
    places = source.uniform(-2, 3, (STARTS, 2))
    return searched(miss, np.column_stack([places, np.cos(angles), np.sin(angles)]))


def in_the_plane(poses: Any) -> FloatArray:
    """The same of matrices."""
    return np.array([[P[0, 3], P[1, 3], P[0, 0], P[1, 0]] for P in poses])


def test_a_platform_on_three_cylinders() -> None:
    """At most six; the number and the poses are those of the search."""
    feet = np.array([[0, 0], [1.2, 0], [0.5, 1.1]])
    points = np.array([[-0.2, -0.1], [0.25, -0.1], [0, 0.25]])
    counts = []
    for T in poses("parallel_3rpr")[:6]:
        lengths = drives("parallel_3rpr", mode("parallel_3rpr", T))
        wanted = on_three_cylinders(feet, points, lengths)
        have = in_the_plane(native("parallel_3rpr").assemblies(lengths))
        counts.append(len(have))
        assert len(have) == len(wanted)
        assert all(np.abs(have - x).max(axis=1).min() < 1e-8 for x in wanted)
    assert max(counts) >= 4


FEET = np.array([[0, 0], [-1.43, -0.14], [-0.77, -1.42]])
POINTS = np.array([[0, 0], [1.16, 0.79], [0.84, 0.08]])
# Lengths at which two of the six poses have nearly merged.
MERGING = (1.3486819263486154, 1.1977335182027558, 1.7947198335229593)


def test_two_of_six_poses_that_nearly_merge_hide_no_other() -> None:
    wanted = on_three_cylinders(FEET, POINTS, np.array(MERGING))
    assert len(wanted) == 6
    robots = native("six_assemblies"), python("six_assemblies")
    for found in (robot.assemblies(np.array(MERGING)) for robot in robots):
        have = in_the_plane(found)
        assert len(have) == 6
        assert all(np.abs(have - x).max(axis=1).min() < 1e-6 for x in wanted)


ROOTS = """
#define DHGEN_SCALAR
#define DHGEN_LIBM
#include "dhgen/triangle.h"
int roots(const double *p, int degree, double *found);
int roots(const double *p, int degree, double *found) { return dhgen_real_roots(p, degree, found); }
"""


@pytest.mark.skipif(not shutil.which("gcc"), reason="no gcc")
def test_roots_of_polynomials(tmp_path: Path) -> None:
    """Four simple roots and a pair at any distance, which may be none, or complex by rounding."""
    (tmp_path / "roots.c").write_text(ROOTS, encoding="utf-8")
    built = ("-std=c99", "-shared", "-fPIC", f"-I{GENERATED}", "-o", "roots.so", "roots.c", "-lm")
    compiler = shutil.which("gcc")
    assert compiler is not None
    subprocess.run([compiler, *built], cwd=tmp_path, check=True)
    roots = ctypes.CDLL(str(tmp_path / "roots.so")).roots
    roots.argtypes = (ctypes.c_void_p, ctypes.c_int, ctypes.c_void_p)
    source = np.random.default_rng(5)
    pairs = 0
    for gap in [0.0, *10.0 ** -np.arange(2.0, 13.0)] * 40:
        simple = np.sort(source.uniform(-2.0, 2.0, 5))
        if np.diff(simple).min() < 0.1:
            continue
        place = int(source.integers(5))
        p = np.ascontiguousarray(np.poly([*simple, simple[place] + gap])[::-1])
        found = np.zeros(6)
        count = roots(p.ctypes.data, 6, found.ctypes.data)
        assert (np.diff(found[:count]) >= 0.0).all()
        near = np.abs(found[:count, None] - simple)
        assert near.min(axis=0)[np.arange(5) != place].max() < 1e-6
        assert near[:, place].min() < 1e-4  # the square root of rounding
        pairs += count == 6
    assert pairs > 50


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
