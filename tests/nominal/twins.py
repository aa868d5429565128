"""Robot files of arms as delivered: the table of a data sheet with errors in every number."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from dhgen.kinematics.link_table import link_table
from dhgen.robot.load import load

ROBOTS = Path(__file__).resolve().parents[2] / "robots"


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
