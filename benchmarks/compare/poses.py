"""The joint values and poses that two solvers are asked for, the same every time."""

from __future__ import annotations

from dataclasses import dataclass
from math import log, pi
from typing import TYPE_CHECKING

import numpy as np

from dhgen.robot.robot import JointKind
from dhgen.survey.singular import singular_sets

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.robot.robot import Robot

SEED = 20260101
QUARTERS = 4096  # joint values at multiples of a quarter turn: all of six joints
SLIDE = (0.2, 1.2)  # of a slide without limits
NEAR = (1e-13, 1e-7)  # how far one joint is beside a singular place [rad or length]
FAR = 1.7  # what positions are multiplied by to be out of reach
DIGITS = 6

# How poses are changed once the joint values have become poses.
MOVED, ROUNDED, SPOILT = "out of reach", "rounded to six digits", "invalid"


@dataclass(frozen=True, slots=True)
class Joints:
    """Joint values of one kind.

    Attributes:
        kind: What they have in common.
        q: The values, shape (N, n).
        seeds: Random seeds, shape (N, n).
    """

    kind: str
    q: FloatArray
    seeds: FloatArray


def joint_values(robot: Robot, count: int) -> list[Joints]:
    """Joint values of every kind, about `count` of most kinds."""
    draw = np.random.default_rng(SEED)
    slides = np.array([joint.kind is JointKind.PRISMATIC for joint in robot.joints])
    spans = [_span(joint.kind, joint.limits) for joint in robot.joints]
    low, high = np.array(spans).T
    size = (count, len(slides))

    def anywhere() -> FloatArray:
        return np.asarray(draw.uniform(low, high, size))

    def quarters(number: int) -> FloatArray:
        steps = _all_steps(len(slides)) if 4 ** len(slides) <= number else None
        if steps is None:
            steps = draw.integers(-1, 3, (number, len(slides)))
        ends = np.array([low, (low + high) / 2, high, high])
        return np.where(slides, ends[steps + 1, np.arange(len(slides))], steps * (pi / 2))

    def mixed() -> FloatArray:
        straight = quarters(QUARTERS)
        chosen = straight[draw.integers(0, len(straight), count)]
        return np.where(draw.random(size) < 0.5, chosen, anywhere())

    beside = mixed()
    off = np.exp(draw.uniform(log(NEAR[0]), log(NEAR[1]), count)) * draw.choice([-1.0, 1.0], count)
    beside[np.arange(count), draw.integers(0, len(slides), count)] += off
    kinds = {
        "random": anywhere(),
        "quarter turns": quarters(QUARTERS),
        "some quarter turns": mixed(),
        "beside quarter turns": beside,
        **_singular(robot, count),
        MOVED: anywhere(),
        ROUNDED: np.concatenate([anywhere(), mixed()]),
        SPOILT: anywhere()[:40],
    }
    wide = np.where(slides, 1.0, 2.0)
    return [
        Joints(
            kind,
            np.ascontiguousarray(q),
            np.asarray(draw.uniform(low * wide, high * wide, q.shape)),
        )
        for kind, q in kinds.items()
    ]


def changed(kind: str, T: FloatArray) -> FloatArray:
    """Poses (N, 4, 4) as their kind wants them."""
    T = T.copy()
    if kind == MOVED:
        T[:, :3, 3] *= FAR
    elif kind == ROUNDED:
        T = np.round(T, DIGITS)
    elif kind == SPOILT:
        T[0::4, 0, 0] = np.nan
        T[1::4, :3, :3] = T[1::4, :3, :3].transpose(0, 2, 1)
        T[2::4, :3, :3] *= 1.1
        T[3::4, :3, 0] *= -1.0
    return T


def _span(kind: JointKind, limits: tuple[float, float] | None) -> tuple[float, float]:
    """Where a joint's values are drawn from: a whole turn, or a slide's limits."""
    if kind is JointKind.REVOLUTE:
        return (-pi, pi)
    return limits or SLIDE


def _all_steps(count: int) -> np.ndarray[tuple[int, ...], np.dtype[np.int64]]:
    grid = np.indices((4,) * count).reshape(count, -1).T
    return np.asarray(grid - 1, np.int64)


def _singular(robot: Robot, count: int) -> dict[str, FloatArray]:
    """Where the Jacobian loses rank, and nearly, as the survey finds it."""
    few = max(count // 20, 5)
    sets = singular_sets(robot, few, seed=1)
    exact = [q for kind, q in sets.items() if kind.startswith("singular")]
    nearly = [q for kind, q in sets.items() if kind.startswith("nearly singular")]
    found = {
        "singular": exact,
        "nearly singular": nearly,
        "limits": [sets.get("limits", np.empty((0, 1)))],
    }
    return {kind: np.concatenate(each) for kind, each in found.items() if each and each[0].size}
