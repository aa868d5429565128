"""Robot files of arms as delivered: the table of a data sheet with errors in every number."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from dhgen.kinematics.link_table import link_table
from dhgen.robot.load import load

ROBOTS = Path(__file__).resolve().parents[2] / "robots"


# An iiwa 14 whose axes 1, 2 and 3, or 5, 6 and 7, miss one point; joint 3, which counts backwards
# from an odd angle, is given.
SEVEN = """\
name: {name}
title: seven joints
source: made up
joints:
  - {{theta: q, d: 0.36, a: {shoulder}, alpha: -pi/2}}
  - {{theta: q, d: 0, a: 0, alpha: pi/2}}
  - {{theta: -q + 0.3, d: 0.42, a: {shoulder}, alpha: pi/2}}
  - {{theta: q, d: 0, a: 0, alpha: -pi/2}}
  - {{theta: q, d: 0.4, a: {wrist}, alpha: -pi/2}}
  - {{theta: q, d: 0, a: 0, alpha: pi/2}}
  - {{theta: q, d: 0.126, a: 0, alpha: 0}}
free: [3]
task: pose
"""
MISSED = {"shoulder_missed": (0.00044, 0.0), "wrist_missed": (0.0, 0.0003)}


def seven(name: str) -> str:
    """The robot file of an arm of seven joints that misses a structure."""
    shoulder, wrist = MISSED[name]
    return SEVEN.format(name=name, shoulder=shoulder, wrist=wrist)


# An arm whose wrist misses one point; that its axes 2 and 3 stand beside axis 1 is no miss.
SIX = """\
name: six
source: made up
joints:
  - {theta: -q, d: 0.28, a: 0, alpha: -pi/2}
  - {theta: q - pi/2, d: 0, a: 0.41, alpha: 0}
  - {theta: -q + pi/2, d: 0.001, a: 0, alpha: -pi/2}
  - {theta: q, d: -0.31, a: 0, alpha: -pi/2}
  - {theta: q, d: -0.0003, a: 0, alpha: pi/2}
  - {theta: q, d: -0.1, a: 0, alpha: 0}
"""


def twin(name: str, noise: float, seed: int = 1) -> str:
    """The robot file of an arm whose table has normal errors [rad, file's unit]."""
    table = link_table(load(ROBOTS / f"{name}.yaml"))
    assert not table.drives
    errors = np.random.default_rng(seed).normal(0.0, noise, (len(table.rows), 4))
    rows = []
    for row, error in zip(table.rows, errors.tolist(), strict=True):
        theta, d, a, alpha = (each + off for each, off in zip(row, error, strict=True))
        sign = "-" if theta < 0.0 else "+"
        rows.append(f"{{theta: q {sign} {abs(theta)!r}, d: {d!r}, a: {a!r}, alpha: {alpha!r}}}")
    head = f"name: twin_{name}\ntitle: {name}\nsource: random\nconvention: {table.convention}\n"
    return "\n".join([head + "joints:", *(f"  - {row}" for row in rows), "task: pose", ""])


def geared(text: str) -> str:
    """The same with a drive that moves two joints, the second one by twice as much."""
    *before, third, after = text.split("theta: q", 3)
    return "theta: q".join([*before, third]) + f"theta: q + 2*q2{after}"


def coupled(text: str) -> str:
    """The same with a drive that moves two joints, and a limit of what the two do together."""
    *before, third, after = text.split("theta: q", 3)
    head = "theta: q".join([*before, third])
    return f"{head}theta: q + q2{after}limits: [{{of: q2 + q3, from: -1.2, to: 3.5}}]\n"
