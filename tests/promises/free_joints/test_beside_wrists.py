"""Beside a straight wrist every row is right: in vectors, without them, with libm, in Python."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from dhgen.oracle.forward import forward_with_derivatives
from dhgen.oracle.poses import NEAR, random_joints
from dhgen.status import HELD
from dhgen.verify.native import NATIVE, PORTABLE, Build
from tests.structures import BREADTH
from tests.targets.made import apart, in_c, in_python, model, poses_of, residual, robot, size

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

# Joint 5 is straight where its value is this.
STRAIGHT = {"kuka_kr6_r900": 0.0, "puma560": 0.0, "stanford": 0.0, "ur5": 0.0}
POSES = 3
# Without vectors, and with libm's arctangent, the formulas are the same of all arms.
CASES = [(name, build) for name in STRAIGHT for build in ("vectors", "portable", "Python")]
CASES += [("puma560", build) for build in ("scalar", "libm")]
QUICK = ("portable", "Python")
NEARLY = 1e-3  # [rad or arm sizes]
WRIST = 4  # joint 5, from 0
SIGNIFICANT = 1e-13  # singular values below it say nothing


@cache
def solver(name: str, build: str) -> Any:
    """What solves one pose: T and a seed to rows and statuses."""
    if build == "Python":
        return in_python(name).ik_all
    macro = (f"-D{name.upper()}_{build.upper()}",)
    builds = {"vectors": NATIVE, "portable": PORTABLE}
    return in_c(name, builds.get(build) or Build(build, ("-O1", *macro))).ik


def steps_to_solutions(name: str, rows: FloatArray, T: FloatArray) -> FloatArray:
    """Newton's steps from rows (N, n) of joint values, by a model that is not the solver's."""
    own = model(name).divided_by(size(name))
    scale = np.where(own.revolute, 1.0, size(name))
    wanted = T.copy()
    wanted[:3, 3] /= size(name)
    reached, rates = forward_with_derivatives(own, rows / scale)
    J = np.swapaxes(rates[:, :, :3].reshape(*rows.shape, 12), 1, 2)
    missed = (wanted - reached)[:, :3].reshape(len(rows), 12, 1)
    return np.asarray((np.linalg.pinv(J, rcond=SIGNIFICANT) @ missed)[..., 0])


@pytest.mark.parametrize(
    ("name", "build"),
    [pytest.param(*case, marks=() if case[1] in QUICK else BREADTH) for case in CASES],
)
def test_every_branch(name: str, build: str) -> None:
    solve = solver(name, build)
    for near in NEAR:
        q = random_joints(robot(name), POSES, seed=91)
        q[:, WRIST] = STRAIGHT[name] + near
        for joints, T in zip(q, poses_of(name, q), strict=True):
            for seed in (joints, np.zeros(len(joints))):
                rows, status = solve(T, seed)
                rows = rows[np.isin(status, HELD)]
                assert len(rows) >= 2
                assert residual(name, rows, T) < 1e-9
                assert apart(name, rows, joints).max(axis=1).min() < NEARLY
                assert np.abs(steps_to_solutions(name, rows, T)).max() < NEARLY, (rows, joints)
