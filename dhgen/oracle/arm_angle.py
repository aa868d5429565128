"""The arm angle by plain geometry, and where an arm angle puts the elbow.

Shoulder, elbow and wrist are found from the axes alone; nothing of the compiler's is used.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.oracle.arm import Arm, arm, arm_size, base_frame
from dhgen.oracle.forward import forward, motions

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.robot.robot import Robot

ELBOW = 3  # the joint of the elbow, from 0
UPRIGHT = 1e-12  # sine between axis 1 and the arm, below which the plane between them is lost
STRAIGHT = np.sqrt(3.0) * 1e-7  # root of an area, in arm sizes, below which the elbow is on no side


def given_values(robot: Robot, q: FloatArray) -> FloatArray:
    """What the caller gives besides the pose to get q (..., n) again, shape (..., k)."""
    q = np.asarray(q, dtype=float)
    if robot.arm_angle:
        return arm_angle(robot, q)[..., None]
    return np.ascontiguousarray(q[..., [joint - 1 for joint in robot.free]])


def arm_angle(robot: Robot, q: FloatArray) -> FloatArray:
    """Of joint values (..., 7), in (-pi, pi]."""
    places = _places(arm(robot), q)
    frame = _reference(robot, places.first, places.wrist - places.shoulder)
    line, lean, aside = frame
    e = places.elbow - places.shoulder
    off = e - _dot(e, line) * line
    side = _dot(np.cross(places.wrist - places.shoulder, e), places.fourth)
    along = np.abs(_dot(places.wrist - places.elbow, places.fourth)) > UPRIGHT * arm_size(robot)
    sides = np.linalg.norm([e, places.wrist - places.elbow], axis=-1)
    least = STRAIGHT * arm_size(robot) * np.sqrt(sides[0] * sides[1])[..., None]
    straight = (np.abs(side) <= least) & ~along
    off = np.where(straight, np.cross(places.fourth, line), off)
    angle = np.arctan2(_dot(off, aside), _dot(off, lean))
    return np.asarray(angle[..., 0])


def elbow_of(robot: Robot, T: FloatArray, angle: float) -> FloatArray:
    """Where the elbow (3,) is at a pose T (4, 4); NaN where the pose is out of reach."""
    model = arm(robot)
    rest = _places(model, np.zeros(len(model.before)))
    tool = forward(model, np.zeros(len(model.before)))
    wrist = (T @ np.linalg.solve(tool, np.append(rest.wrist, 1.0)))[:3]
    w = wrist - rest.shoulder
    upper = float(np.linalg.norm(rest.elbow - rest.shoulder))
    lower = float(np.linalg.norm(rest.wrist - rest.elbow))
    reach = float(np.linalg.norm(w))
    along = (upper**2 + reach**2 - lower**2) / (2 * reach)
    line, lean, aside = _reference(robot, rest.first, w)
    off = np.cos(angle) * lean + np.sin(angle) * aside
    height = np.sqrt(max(upper**2 - along**2, 0.0))
    return np.asarray(rest.shoulder + along * line + height * off)


def elbow_rates(model: Arm, q: FloatArray) -> FloatArray:
    """How fast the elbow leaves the plane of the arm with every joint, (..., 7)."""
    places, axes = _places(model, q), _axes(model, q)
    normal = np.cross(places.wrist - places.shoulder, places.elbow - places.shoulder)
    size = np.linalg.norm(normal, axis=-1, keepdims=True)
    normal = np.where(size > 0.0, normal / np.where(size > 0.0, size, 1.0), places.fourth)
    rates = [_dot(np.cross(z, places.elbow - p), normal) for z, p in axes[:ELBOW]]
    none = np.zeros_like(rates[0])
    return np.concatenate([*rates, *([none] * (len(axes) - ELBOW))], axis=-1)


def elbow_in_link(robot: Robot) -> Arm:
    """The first three joints, with the elbow as the tool."""
    model = arm(robot)
    none = np.zeros(len(model.before))
    end = np.eye(4)
    first = slice(ELBOW)
    own = np.eye(ELBOW)
    turns = model.turns[first]
    upper = Arm(model.before[first], model.twist[first], end, turns, turns, own)
    place = np.append(_places(model, none).elbow, 1.0)
    end[:3, 3] = np.linalg.solve(forward(upper, none[:ELBOW]), place)[:3]
    return upper


@dataclass(frozen=True, slots=True)
class _Places:
    """Points and directions (..., 3) in the caller's frame."""

    shoulder: FloatArray
    elbow: FloatArray
    wrist: FloatArray
    first: FloatArray
    fourth: FloatArray


def _places(model: Arm, q: FloatArray) -> _Places:
    axes = _axes(model, q)
    shoulder, wrist = _meeting(axes[0], axes[1]), _meeting(axes[4], axes[5])
    z, p = axes[ELBOW]
    return _Places(shoulder, p + _dot(shoulder - p, z) * z, wrist, axes[0][0], z)


def _axes(model: Arm, q: FloatArray) -> list[tuple[FloatArray, FloatArray]]:
    """Direction and a point of every axis."""
    moved = motions(model, q)
    T = np.broadcast_to(np.eye(4), (*moved.shape[:-3], 4, 4))
    found = []
    for joint, (before, xi) in enumerate(zip(model.before, model.twist, strict=True)):
        T = T @ before
        omega = np.array([xi[2, 1], xi[0, 2], xi[1, 0]])
        point = np.cross(omega, xi[:3, 3])
        found.append((T[..., :3, :3] @ omega, T[..., :3, :3] @ point + T[..., :3, 3]))
        T = T @ moved[..., joint, :, :]
    return found


def _meeting(
    one: tuple[FloatArray, FloatArray], other: tuple[FloatArray, FloatArray]
) -> FloatArray:
    """Where two axes meet."""
    (u, p), (v, r) = one, other
    mixed = _dot(u, v)
    away = r - p
    along = (_dot(away, u) - mixed * _dot(away, v)) / (1.0 - mixed**2)
    return np.asarray(p + along * u)


def _reference(
    robot: Robot, first: FloatArray, w: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Along the arm; towards axis 1; and across both."""
    line = w / np.linalg.norm(w, axis=-1, keepdims=True)
    base = base_frame(robot)[:3, :3]
    normal = np.cross(line, first)
    size = np.linalg.norm(normal, axis=-1, keepdims=True)
    usual = np.cross(first, base[:, 0])
    if np.linalg.norm(usual, axis=-1).max() < STRAIGHT:
        usual = np.cross(first, base[:, 1])
    usual = usual / np.linalg.norm(usual, axis=-1, keepdims=True)
    across = np.where(size <= UPRIGHT, usual, normal / np.where(size > 0, size, 1.0))
    return line, np.cross(across, line), across


def _dot(u: FloatArray, v: FloatArray) -> FloatArray:
    return np.asarray(np.sum(u * v, axis=-1, keepdims=True))
