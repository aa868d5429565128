"""The driven joints alone, in C: values and statuses are those that all joints have."""

from __future__ import annotations

import shutil
import tempfile
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.parallel.compile import ParallelCompilation, compile_file
from dhgen.parallel.driven import driven
from dhgen.parallel.native import Native, compiled
from dhgen.parallel.worked import turn_about
from dhgen.robot_files import read_file
from dhgen.runtime.python.platform import driven_of_rows
from tests.serial import PARALLEL, ROBOTS
from tests.structures import first_of

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

OWN = Path(__file__).with_name("robots")
FILES = (
    *(OWN / f"{name}.yaml" for name in ("limited_passive", "mixed_legs")),
    *(ROBOTS / f"{name}.yaml" for name in PARALLEL),
)
BUILDS = (("-O1",), ("-O1", "-march=x86-64-v3"))
OK, UNREACHABLE, FREE, OUT, INVALID = range(5)
NEAR = 3e-14  # what two orders of the same operations may make of an angle
_KEPT: list[tempfile.TemporaryDirectory[str]] = []

needs_avx2 = pytest.mark.skipif(
    not Path("/proc/cpuinfo").exists() or " avx2" not in Path("/proc/cpuinfo").read_text(),
    reason="no AVX2",
)


@cache
def made(path: Path) -> tuple[ParallelCompilation, Path]:
    """What the compiler makes of a robot file, and where it is written."""
    compilation = compile_file(read_file(path))
    assert isinstance(compilation, ParallelCompilation)
    kept = tempfile.TemporaryDirectory(prefix="dhgen-drives-")
    _KEPT.append(kept)
    write_files(Path(kept.name), compilation.files)
    return compilation, Path(kept.name)


def library(path: Path, flags: tuple[str, ...]) -> Native:
    """Its C, compiled."""
    compilation, folder = made(path)
    native = compiled(compilation.module, folder, flags)
    assert native is not None
    return native


def drawn(path: Path, count: int, seed: int) -> FloatArray:
    """Poses of the platform, in reach or not."""
    module = made(path)[0].module
    source = np.random.default_rng(seed)
    T = np.tile(np.eye(4), (count, 1, 1))
    T[:, :3, 3] = source.uniform(-1.0, 1.0, (count, 3)) * module.size
    for k, angle in enumerate(source.uniform(-0.5, 0.5, count)):
        if 5 in module.freedoms:
            T[k, :3, :3] = turn_about(2, angle)
        if 3 in module.freedoms:
            T[k, :3, :3] = T[k, :3, :3] @ turn_about(0, 0.5 * angle)
    return T


@pytest.mark.skipif(not shutil.which("gcc"), reason="no gcc")
@pytest.mark.parametrize(
    "flags", [BUILDS[0], pytest.param(BUILDS[1], marks=needs_avx2)], ids=["lanes of one", "AVX2"]
)
@pytest.mark.parametrize("path", first_of(FILES, count=2), ids=lambda path: path.stem)
def test_rows_and_statuses_are_those_of_all_joints(path: Path, flags: tuple[str, ...]) -> None:
    native, module = library(path, flags), made(path)[0].module
    poses = drawn(path, 4003, 1)
    poses[5, 0, 3] = np.nan
    poses[6, 1, 3] = np.inf
    poses[7] *= 1.0 + 1e-7  # rounded
    poses[8, 0] *= -1.0  # mirrored
    poses[9, :3, 3] = 0.0  # often singular
    poses[10, :3, 3] *= 1e6
    poses[11, :3, 3] = 1e200
    q, status = native.batch(poses)
    found, told = native.drives_batch(poses)
    np.testing.assert_array_equal(told, status)
    np.testing.assert_allclose(found, driven_of_rows(module.driven_joints, q), rtol=0, atol=NEAR)
    seen = set(status.ravel().tolist())
    assert {OK, INVALID} < seen
    assert seen & {UNREACHABLE, OUT}
    assert (status == OK).any(axis=2).all(axis=1).sum() > 10
    for k in range(400):
        modes, own, told = native.ik_drives(poses[k])
        np.testing.assert_array_equal(told, status[k])
        np.testing.assert_allclose(
            own, driven_of_rows(module.driven_joints, q[k]), rtol=0, atol=NEAR
        )
        assert modes == native.ik(poses[k])[0]


@pytest.mark.skipif(not shutil.which("gcc"), reason="no gcc")
def test_limits_of_passive_joints_take_no_angle() -> None:
    """Half the poses that one leg of them reaches are beyond them, some by next to nothing."""
    path = FILES[0]
    module, native = made(path)[0].module, library(path, BUILDS[0])
    leg = module.legs[0]
    body = "\n".join(driven(module).chains[0].lines)
    assert body.count("dhgen_atan2_wide(") == 2  # of joint 1 in two branches
    source, edges = np.random.default_rng(3), 0
    places = np.array(leg.leg.base).reshape(3, 4)
    for _ in range(600):
        joint = source.integers(1, 3)
        own = np.array([0.3, -1.2, 3.4]) + source.uniform(-0.4, 0.4, 3)
        own[joint] = (np.deg2rad([-170, 20]), np.deg2rad([150, 380]))[joint - 1][source.integers(2)]
        own[joint] += source.choice([-1, 1]) * 10.0 ** source.uniform(-11, -1)
        c, s = np.cos(own[:2]), np.sin(own[:2])
        c12, s12 = c[0] * c[1] - s[0] * s[1], s[0] * c[1] + c[0] * s[1]
        out, up = 0.7 * np.cos(own[2]), 0.7 * np.sin(own[2])
        end = np.array([0.3 * c[0] + c12 * out, 0.3 * s[0] + s12 * out, up])
        T = np.eye(4)
        T[:3, 3] = places[:, :3] @ end + places[:, 3] - np.array([0.05, 0.0, 0.0])
        _, rows, status = native.ik(T)
        _, found, told = native.ik_drives(T)
        np.testing.assert_array_equal(told, status)
        np.testing.assert_allclose(
            found, driven_of_rows(module.driven_joints, rows), rtol=0, atol=NEAR
        )
        edges += {OK, OUT} <= set(status[0].tolist())
    assert edges > 100


def test_cylinders_take_roots_and_no_arctangent() -> None:
    """Of a leg with two turning joints below it, the length alone."""
    body = "\n".join(driven(made(ROBOTS / "stewart.yaml")[0].module).chains[0].lines)
    assert "dhgen_sqrt_wide" in body
    assert "atan2" not in body


def test_slides_without_limits_leave_a_robot_as_large_as_its_feet_are_apart() -> None:
    """In millimetres: steps of the direct model are shares of its size."""
    path = OWN / "without_limits.yaml"
    module = made(path)[0].module
    assert module.size == pytest.approx(np.hypot(700.0, 1100.0), rel=1e-3)
    native = library(path, BUILDS[0])
    T = np.eye(4)
    T[:2, 3] = 400.0, 300.0
    feet = np.array([[0, 0], [1200, 0], [500, 1100]])
    points = np.array([[-200, -100], [250, -100], [0, 250]])
    lengths = np.linalg.norm(T[:2, 3] + points - feet, axis=1)
    seed = T.copy()
    seed[:2, 3] += 60.0, -80.0
    told, found, _ = native.fk(lengths, seed)
    assert told == OK
    np.testing.assert_allclose(found, T, rtol=0.0, atol=1e-9 * module.size)
