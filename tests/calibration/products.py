"""Calibrated arms as products of matrices, each as its file's documentation has it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.robot.expression import evaluate
from dhgen.robot.robot import Convention, DhTable

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dhgen.arrays import FloatArray
    from dhgen.robot.robot import Robot


def turn(axis: int, angle: float) -> FloatArray:
    i, j = (axis + 1) % 3, (axis + 2) % 3
    T = np.eye(4)
    T[i, i] = T[j, j] = np.cos(angle)
    T[j, i] = np.sin(angle)
    T[i, j] = -T[j, i]
    return T


def shift(x: float, y: float, z: float) -> FloatArray:
    T = np.eye(4)
    T[:3, 3] = x, y, z
    return T


def of_origins(rows: Mapping[str, Any], q: FloatArray) -> FloatArray:
    """Every joint turns about the z axis of its frame, which is given in the one before."""
    T = np.eye(4)
    for row, value in zip((r for r in rows.values() if isinstance(r, dict)), q, strict=True):
        rotation = turn(2, row["yaw"]) @ turn(1, row["pitch"]) @ turn(0, row["roll"])
        T = T @ shift(row["x"], row["y"], row["z"]) @ rotation @ turn(2, value)
    return T


def of_deltas(robot: Robot, rows: Sequence[Mapping[str, float]], q: FloatArray) -> FloatArray:
    """Rz(theta) Tz(d) Tx(a) Rx(alpha) Ry(beta), or modified Rx Tx Ry Rz Tz."""
    assert isinstance(robot.geometry, DhTable)
    values = {each.name: each.value for each in robot.parameters}
    T = np.eye(4)
    for row, deltas, value in zip(robot.geometry.rows, rows, q, strict=True):
        names = {"theta": row.theta, "d": row.d, "a": row.a, "alpha": row.alpha}
        cells = {n: evaluate(e, values) + float(deltas.get(n, 0.0)) for n, e in names.items()}
        along_z = turn(2, cells["theta"] + value) @ shift(0.0, 0.0, cells["d"])
        along_x = turn(0, cells["alpha"]) @ shift(cells["a"], 0.0, 0.0)
        along_x = along_x @ turn(1, float(deltas.get("beta", 0.0)))
        modified = robot.geometry.convention is Convention.MODIFIED
        T = T @ (along_x @ along_z if modified else along_z @ along_x)
    return T
