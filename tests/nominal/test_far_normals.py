"""Tables of arms whose nearly parallel axes have their common normals far away.

Where axes 2, 3 and 4 of a data sheet are parallel, those of an arm that was built cross somewhere:
offsets of hundreds and thousands of metres stand in its table, and angles between its normals and
the links.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.runtime import c_runtime_files
from dhgen.runtime.python.calibrate import TAKEN
from dhgen.runtime.python.calibration import MOVED, TURNED
from dhgen.verify.calibrated import FleetArm
from tests.nominal.fleets import compiled, kind, random_joints, screw, turned

if TYPE_CHECKING:
    from pathlib import Path

FAR = 100.0  # [m]
POSES = 200


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the kind's C is written, with the runtime beside it."""
    made = tmp_path_factory.mktemp("far")
    write_files(made, c_runtime_files())
    return made


def links(table: np.ndarray) -> list[np.ndarray]:
    return [screw(2, theta, d) @ screw(0, alpha, a) for theta, d, a, alpha in table]


def displaced(table: np.ndarray, noise: float, seed: int) -> np.ndarray:
    """The table of the same arm with each joint's frame moved and turned by errors.

    The foot of each common normal is where two lines are nearest, by linear equations.
    """
    source = np.random.default_rng(seed)
    frames = [np.eye(4)]
    for link in links(table):
        error = np.eye(4)
        for axis, (angle, length) in enumerate(source.normal(0.0, noise, (3, 2))):
            error = error @ screw(axis, angle, length)
        frames.append(frames[-1] @ link @ error)
    own, rows = np.eye(4), []
    for frame in frames[1:6]:
        seen = np.linalg.inv(own) @ frame
        point, z = seen[:3, 3], seen[:3, 2]
        normal = np.cross([0.0, 0.0, 1.0], z)
        normal /= np.linalg.norm(normal)
        d, _, a = np.linalg.solve(np.stack([[0.0, 0.0, 1.0], -z, normal], axis=1), point)
        theta = math.atan2(normal[1], normal[0])
        rows.append([theta, d, a, math.atan2(np.cross([0.0, 0.0, 1.0], z) @ normal, z[2])])
        own = own @ links(np.array(rows[-1:]))[0]
    last = (np.linalg.inv(own) @ frames[6])[2, 3]
    return np.array([*rows, [0.0, last, 0.0, 0.0]])


@pytest.mark.parametrize("noise", [1e-3, 1e-4, 1e-5])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_tables_with_far_normals_are_taken_by_what_links_differ(
    noise: float, seed: int, folder: Path
) -> None:
    table = displaced(np.array(kind("ur5e").table.rows), noise, seed)
    assert np.abs(table[:, 1]).max() > FAR
    arm = FleetArm(compiled(folder, "ur5e"), kind("ur5e"), table)
    assert arm.fault == TAKEN
    size = kind("ur5e").nominal.chain.size
    # five links, each moved by no more than five deviations in each of three directions, and turned
    assert arm.numbers[TURNED] < 5 * 5 * math.sqrt(3.0) * noise
    assert arm.numbers[MOVED] < 5 * 5 * math.sqrt(3.0) * noise * (1.0 + size)
    for q in random_joints(POSES):
        own = np.eye(4)
        for link, angle in zip(links(table), q, strict=True):
            own = own @ screw(2, angle, 0.0) @ link
        T = arm.fk(q)
        np.testing.assert_allclose(T, own, atol=1e-15 * np.abs(table).max() + 1e-14)
        rows, status = arm.ik(T, np.zeros(6))
        there = status == 0
        assert turned(rows[there], q).max(axis=1).min() < 1e-7
        for row in rows[there]:
            np.testing.assert_allclose(arm.fk(row), T, atol=1e-11)
