"""The modules of parallel robots beside their C, and what callers get wrong."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.parallel.made import NAMES
from tests.serial import ROBOTS
from tests.structures import first_of

# All that verification asks of both languages, of few poses, since nothing is compiled for numba.
VERIFIED = """
import sys, tempfile
from pathlib import Path

import numpy as np

import dhgen.parallel.verify as verify
import dhgen.parallel.worked as worked
from dhgen.atomic_write import write_files
from dhgen.parallel.compile import compile_file
from dhgen.robot_files import read_file
from dhgen.verify.native import import_module

verify.POSES, worked.DRAWN = 5, 150
# A leg of the 3-PRR is nearly stretched there: drives bend, and a pose beside is out of reach.
NEAR = {
    "planar_3prr": [
        [0.9017052775702932, 0.432351237308141, 0.0, -0.029789811838600244],
        [-0.432351237308141, 0.9017052775702932, 0.0, -0.05776610823046206],
        [0.0, 0.0, 1.0, 0.0],
        [0.0, 0.0, 0.0, 1.0],
    ]
}
drawn = verify.reachable


def chosen(module, *others):
    poses = list(drawn(module, *others))
    if module.name in NEAR:
        poses[0] = np.array(NEAR[module.name])
    return np.array(poses)


verify.reachable = chosen
for path in sys.argv[1:]:
    made = compile_file(read_file(Path(path)))
    with tempfile.TemporaryDirectory() as folder:
        write_files(Path(folder), made.files)
        report = verify.verify_parallel(made.module, Path(folder), [])
        robot = import_module(Path(folder) / f"{made.robot.name}.py")
    assert report.poses == 5 and report.compiled, path
    legs, joints = robot.LEGS, robot.JOINTS
    far = np.eye(4)
    far[:3, 3] = 1e3
    for wrong, told in (
        (lambda: robot.ik(far), "leg 1: "),
        (lambda: robot.ik(np.full((4, 4), np.nan)), "T is not a valid pose of the platform"),
        (lambda: robot.ik_all(np.eye(3)), "T must have shape (4, 4)"),
        (lambda: robot.ik_all(np.eye(4), [0.0]), f"q_seed must have shape ({legs}, {joints})"),
        (lambda: robot.fk([0.0], np.eye(4)), "drives must have shape"),
        (lambda: robot.ik(np.eye(4), branch=[0]), f"branch names a row of each of the {legs} legs"),
        (lambda: robot.ik(np.eye(4), branch=3), f"branch names a row of each of the {legs} legs"),
        (lambda: robot.ik(np.eye(4), branch="a" * legs), "branch names a row of each of the"),
        (lambda: robot.ik(np.eye(4), branch=["no"] * legs), "leg 1: no branch 'no'"),
        (lambda: robot.ik_all(np.eye(4) * 1j), "T must hold real numbers"),
        (lambda: robot.ik_batch(np.eye(4)), "T must have shape (N, 4, 4)"),
        (lambda: robot.ik(np.eye(4), np.full((legs, joints), np.nan)), "q_seed of leg 1 is not fi"),
        (lambda: robot.velocities(np.eye(4), np.zeros(joints)), "q must have shape"),
    ):
        try:
            wrong()
        except ValueError as error:
            assert told in str(error), (path, str(error))
        else:
            raise AssertionError(told)
    drives = np.full(len(robot.DRIVES), 0.3)
    with np.errstate(all="raise", under="ignore"):
        assert robot.fk(drives * np.nan, np.eye(4))[2] == robot.INVALID_POSE
        assert robot.fk(drives * np.inf, np.eye(4))[2] == robot.INVALID_POSE
        assert robot.fk(drives, np.full((4, 4), np.nan))[2] == robot.INVALID_POSE
        assert robot.fk(drives, far)[2] == robot.UNREACHABLE
        told = robot.fk(drives * 1e300, np.eye(4))[2]  # an angle may be that large, no length
        assert told == robot.UNREACHABLE or set("".join(robot.JOINT_TYPES)) == {"R"}
    none, told = robot.ik_batch(np.empty((0, 4, 4)))
    assert none.shape == (0, legs, robot.MAX_SOLUTIONS, joints) and told.shape == none.shape[:3]
    turned = np.asfortranarray(np.tile(np.eye(4, dtype=np.float32), (3, 1, 1)))
    q, told = robot.ik_batch(turned)
    taken, status = robot.ik_drives_batch(turned)
    assert (told == status).all()
    mode = np.nan_to_num(q[0, :, 0])
    order = [int(place) for place in np.searchsorted([leg for leg, _ in robot.DRIVES], range(legs))]
    first = np.nan_to_num(taken[0, :, 0, 0])
    assert (first == robot.drives(mode)[order]).all()
    assert (robot.ik_drives(np.eye(4))[1] == robot.ik_all(np.eye(4))[1]).all()
"""


OWN = [
    Path(__file__).with_name("robots") / f"{name}.yaml"
    for name in ("mixed_legs", "linear_delta", "planar_3prr", "limited_passive")
]
FILES = [OWN[0], *(ROBOTS / f"{name}.yaml" for name in ["parallel_3rpr", *NAMES]), *OWN[1:]]


@pytest.mark.parametrize(
    "path", first_of(dict.fromkeys(FILES), count=2), ids=lambda path: path.stem
)
def test_both_languages_in_plain_python(path: Path) -> None:
    """Also of legs of several kinds, which have different numbers of joints."""
    plain = {**os.environ, "NUMBA_DISABLE_JIT": "1"}
    command = [sys.executable, "-c", VERIFIED, str(path)]
    done = subprocess.run(command, capture_output=True, text=True, check=False, env=plain)
    assert done.returncode == 0, done.stderr[-2000:]
