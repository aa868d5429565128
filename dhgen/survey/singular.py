"""Joint values where an arm is singular, found without knowing why it is.

Of each kind that the arm has: the joint that is turned (or moved) until the Jacobian of the task
loses rank, the others anywhere. So wrists come out straight, elbows stretched and folded, wrist
centres on the first axis, whatever the offsets are.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from dhgen.oracle.arm import arm, arm_size
from dhgen.oracle.arm_angle import elbow_rates, given_values
from dhgen.oracle.forward import forward, jacobian
from dhgen.oracle.poses import NEAR, boundary, random_joints, ranges, right_angles
from dhgen.oracle.problem import state
from dhgen.robot.task import Directions
from dhgen.verify.singular import SINGULAR, TRIED, singular_places, whole_turns

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.oracle.arm import Arm
    from dhgen.robot.robot import Robot

RIGHT_ANGLES = "right angles"  # in what kinds of poses are called
STEP, CORRECTIONS = 1e-2, 20


def singular_sets(robot: Robot, count: int, *, seed: int = 0) -> dict[str, FloatArray]:
    """Joint values (at most `count`, n) of every kind, by the kind's name; equal every time."""
    random = np.random.default_rng(seed)
    right = right_angles(robot, count, seed=seed)
    mixed = random_joints(robot, count, seed=seed + 1)
    right = right[random.permutation(len(right))[:count]]
    chosen = random.random(mixed.shape) < 0.5
    rows = random.integers(0, len(right), count)
    some = np.where(chosen, right[rows], mixed)
    off = random.choice(NEAR, mixed.shape) * random.choice([-1.0, 1.0], mixed.shape)
    sets = {
        RIGHT_ANGLES: right,
        f"some {RIGHT_ANGLES}": some,
        f"nearly some {RIGHT_ANGLES}": np.clip(some + off, *ranges(robot)),
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

    A step where the Jacobian sees no motion is taken, and corrected by Newton's method: near a
    double root that returns to it, along a family it reaches another member.
    """
    problem = state(robot, forward(robot, q), tuple(given_values(robot, q)))
    start = problem.numbers_of(q)[None]
    if problem.elbow is not None:  # where it is, which a stretched arm's arm angle gives coarsely
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
    low, high = ranges(robot) / scale
    low, high = whole_turns(low, high, model.revolute)
    q = random_joints(robot, TRIED * count, seed=int(random.integers(2**31))) / scale
    joints = np.full(len(q), joint)
    rates = partial(task_jacobian, model, robot)
    _, found = singular_places(rates, q, joints, (low[joints], high[joints]), random)
    return np.asarray(found[:count] * scale)


def task_jacobian(model: Arm, robot: Robot, q: FloatArray) -> FloatArray:
    """The Jacobian of what the task names, (..., m, joints that are not free).

    Where an arm angle is given, also how fast the elbow leaves the plane of the arm.
    """
    moving = [joint for joint in range(len(robot.joints)) if joint + 1 not in robot.free]
    J = jacobian(model, q)[..., moving]
    if robot.arm_angle:
        return np.concatenate([J, elbow_rates(model, q)[..., None, :]], axis=-2)
    T, task = forward(model, q), robot.task
    directions = _direction_rates(task.directions, T[..., :3, :3], J[..., 3:, :])
    return np.concatenate([J[..., list(task.position_rows), :], directions], axis=-2)


def _direction_rates(directions: Directions, R: FloatArray, spins: FloatArray) -> FloatArray:
    """What spins (..., 3, k) do to the part of a rotation R (..., 3, 3) that is asked for."""
    match directions:
        case Directions.NONE:
            return spins[..., :0, :]
        case Directions.ROTATION:
            return spins
        case Directions.POINTING:
            return np.asarray(np.swapaxes(R[..., :2], -1, -2) @ spins)
        case Directions.YAW:  # the tool's x axis is level
            return spins[..., 2:, :]
        case Directions.TILT:
            return spins[..., :2, :]
        case Directions.PITCH:
            moved = np.cross(spins, R[..., :, :1], axis=-2)
            return np.asarray(moved[..., 2:, :])
