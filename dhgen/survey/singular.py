"""Joint values where an arm is singular, found without knowing why it is.

Of each kind that the arm has: the joint that is turned (or moved) until the Jacobian of the task
loses rank, the others anywhere. So wrists come out straight, elbows stretched and folded, wrist
centres on the first axis, whatever the offsets are.
"""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from dhgen.robot.robot import Robot, TaskKind
from dhgen.survey.oracle.arm import arm, arm_size
from dhgen.survey.oracle.arm_angle import elbow_rates, given_values
from dhgen.survey.oracle.forward import forward, jacobian
from dhgen.survey.oracle.poses import NEAR, boundary, random_joints, ranges, right_angles
from dhgen.survey.oracle.problem import state

if TYPE_CHECKING:
    from dhgen.survey.oracle.arm import Arm, FloatArray

TRIED = 3  # random arms for each that is wanted: some have no singular place along the joint
PLACES = 49  # along the joint, to see where the determinant changes its sign
BEYOND = 0.37  # [rad]
HALVINGS = 60
SINGULAR = 1e-9  # least singular value, lengths in arm sizes
STEP, CORRECTIONS = 1e-2, 20


def singular_sets(robot: Robot, count: int, *, seed: int = 0) -> dict[str, FloatArray]:
    """Joint values (at most `count`, n) of every kind, by the kind's name; the same every time."""
    random = np.random.default_rng(seed)
    right = right_angles(robot, count, seed=seed)
    mixed = random_joints(robot, count, seed=seed + 1)
    right = right[random.permutation(len(right))[:count]]
    chosen = random.random(mixed.shape) < 0.5
    rows = random.integers(0, len(right), count)
    some = np.where(chosen, right[rows], mixed)
    off = random.choice(NEAR, mixed.shape) * random.choice([-1.0, 1.0], mixed.shape)
    sets = {
        "right angles": right,
        "some right angles": some,
        "nearly some right angles": np.clip(some + off, *ranges(robot)),
        "limits": _sample(boundary(robot, count, seed=seed), count, random),
    }
    for joint in range(len(robot.joints)):
        if joint + 1 in robot.free:
            continue
        q = _singular_along(robot, joint, count, random)
        sets[f"singular by joint {joint + 1}"] = q
        beside = q.copy()
        beside[:, joint] += random.choice(NEAR, len(q)) * random.choice([-1.0, 1.0], len(q))
        sets[f"nearly singular by joint {joint + 1}"] = beside
    return {kind: q for kind, q in sets.items() if len(q)}


def is_redundant(robot: Robot) -> bool:
    """Whether more joints move than the task has numbers, so that every pose has a family."""
    q = np.zeros(len(robot.joints))
    rows, columns = task_jacobian(arm(robot), robot, q).shape
    return bool(columns > rows)


def in_a_family(robot: Robot, q: FloatArray) -> bool:
    """Whether the arm can move and keep its pose: joint values (n,) that are not a double root.

    A step where the Jacobian sees no motion is taken, and corrected by Newton's method: from
    beside a double root that leads back, along a family it leads to another member.
    """
    problem = state(robot, forward(robot, q), tuple(given_values(robot, q)))
    start = (q / problem.units)[None]
    if problem.elbow is not None:  # where it is, which a stretched arm's arm angle says coarsely
        upper, _ = problem.elbow
        place = forward(upper, start[0, : len(upper.before)])[:3, 3]
        problem = replace(problem, elbow=(upper, place))
    there = start.copy()
    there[:, problem.moving] += STEP * np.linalg.svd(problem.residual(start)[1][0])[2][-1]
    for _ in range(CORRECTIONS):
        (miss,), (J,) = problem.residual(there)
        there[:, problem.moving] -= np.linalg.pinv(J, rcond=SINGULAR) @ miss
    miss = problem.residual(there)[0]
    return bool(np.abs(miss).max() < SINGULAR and np.abs(there - start).max() > STEP / 4)


def _sample(q: FloatArray, count: int, random: np.random.Generator) -> FloatArray:
    return q[random.permutation(len(q))[:count]]


def _singular_along(
    robot: Robot, joint: int, count: int, random: np.random.Generator
) -> FloatArray:
    """Joint values whose task loses rank by one joint's value, (at most count, n)."""
    model = arm(robot).divided_by(arm_size(robot))
    scale = np.where(model.revolute, 1.0, arm_size(robot))
    low, high = ranges(robot)[:, joint] / scale[joint]
    q = random_joints(robot, TRIED * count, seed=int(random.integers(2**31))) / scale
    # whole turns are closed: zero and pi, where arms are straight, are to lie inside
    beyond = BEYOND if model.revolute[joint] else 0.0
    places = np.linspace(low + beyond, high + beyond, PLACES)
    line = np.repeat(q[:, None], PLACES, axis=1)
    line[:, :, joint] = places
    sign = np.sign(_determinant(model, robot, line))
    changes = sign[:, :-1] * sign[:, 1:] < 0
    found, first = np.flatnonzero(changes.any(axis=1)), random.random(changes.shape)
    # any of the changes, not always the first
    cell = np.where(changes, first, -1.0).argmax(axis=1)[found]
    q = q[found]
    left, right = places[cell], places[cell + 1]
    sign_left = sign[found, cell]
    for _ in range(HALVINGS):
        q[:, joint] = (left + right) / 2
        same = np.sign(_determinant(model, robot, q)) == sign_left
        left, right = np.where(same, q[:, joint], left), np.where(same, right, q[:, joint])
    values = np.linalg.svd(task_jacobian(model, robot, q), compute_uv=False)[:, -1:]
    q = q[(values < SINGULAR).all(axis=1)]
    return np.asarray(q[:count] * scale)


def _determinant(model: Arm, robot: Robot, q: FloatArray) -> FloatArray:
    """Of the task's Jacobian; positive where that is not square, so that no sign changes."""
    J = task_jacobian(model, robot, q)
    if J.shape[-2] != J.shape[-1]:
        return np.ones(q.shape[:-1])
    return np.asarray(np.linalg.det(J))


def task_jacobian(model: Arm, robot: Robot, q: FloatArray) -> FloatArray:
    """What the task says of the tool's velocity, (..., m, joints that are not free).

    Where an arm angle is given, also how fast the elbow leaves the plane of the arm.
    """
    moving = [joint for joint in range(len(robot.joints)) if joint + 1 not in robot.free]
    J = jacobian(model, q)[..., moving]
    if robot.arm_angle:
        return np.concatenate([J, elbow_rates(model, q)[..., None, :]], axis=-2)
    match robot.task.kind:
        case TaskKind.POSE:
            return J
        case TaskKind.POSITION:
            return J[..., :3, :]
        case TaskKind.ORIENTATION:
            return J[..., 3:, :]
        case TaskKind.COORDINATES:
            return J[..., ["xyz".index(name) for name in robot.task.coordinates], :]
        case TaskKind.POINTING:
            across = np.swapaxes(forward(model, q)[..., :3, :2], -1, -2)
            return np.concatenate([J[..., :3, :], across @ J[..., 3:, :]], axis=-2)
