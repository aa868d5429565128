# SPDX-License-Identifier: MIT
"""Where the links of an arm are: the frames of its table, or of its axes, from base to tool."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .arguments import numbers

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from .arrays import Floats

IDENTITY = (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0)


@dataclass(frozen=True)
class Links:
    """An arm as its robot file has it.

    Attributes:
        types: R or P for every row.
        table: Of each joint at q = 0 theta, d, a, alpha; of an axis the unit vector along it, and a
            point of it.
        convention: What rows are: `standard`, `modified` or `axes`.
        drives: What joint values are multiplied by for the angles and lengths of the rows, a row
            for each; may be left out where these are the same.
        base: The arm's base in the caller's frame, the upper three rows.
        tool: The tool in the last frame; with axes its pose at q = 0.
    """

    types: str
    table: Sequence[Sequence[float]]
    convention: str
    drives: Sequence[Sequence[float]] = ()
    base: Sequence[float] = IDENTITY
    tool: Sequence[float] = IDENTITY


def frames_of(**of_links: Any) -> Callable[[Any], Floats]:  # noqa: ANN401
    """The function `frames` of a robot, whose `Links` have these attributes."""
    links = Links(**of_links)
    rows, axes = np.array(links.table), links.convention == "axes"
    drives = np.array(links.drives or np.eye(len(rows)))
    dof = drives.shape[1]
    turns = np.array([kind == "R" for kind in links.types])

    def frames(q: Any) -> Floats:  # noqa: ANN401
        """The frames of the base, of every row's link and of the tool, (rows + 2, 4, 4).

        Those of the links are the table's own; of an arm that is given by axes they are at the
        points of the axes, parallel to the base's frame at q = 0.

        Args:
            q: Joint values (dof,), or a stack of them (..., dof) for a stack of results.

        Raises:
            ValueError: q holds no real numbers, or not one for each joint.
        """
        values = numbers(q, (dof,), "q")
        if values.ndim == 0 or values.shape[-1] != dof:
            raise ValueError(f"q must hold {dof} joint values")
        moved = values @ drives.T
        T = np.broadcast_to(_whole(links.base), (*values.shape[:-1], 4, 4))
        found = [T]
        for joint, row in enumerate(rows):
            x = moved[..., joint]
            if axes:
                T = T @ _moved_along(row, x, turns=turns[joint])
                found.append(T @ _shifted(row[3:]))
            else:
                T = T @ _of_row(row, x, turns=turns[joint], convention=links.convention)
                found.append(T)
        return np.stack([*found, T @ _whole(links.tool)], axis=-3)

    return frames


def _of_row(row: Floats, x: Floats, *, turns: bool, convention: str) -> Floats:
    """A_i of Denavit and Hartenberg: Rz(theta) Tz(d) Tx(a) Rx(alpha), or modified Rx Tx Rz Tz."""
    theta, d, a, alpha = row
    z, zero = np.array([0.0, 0.0, 1.0]), np.zeros_like(x)
    along_z = _turned(z, x * turns + theta) @ _shifted(z, x * (not turns) + d)
    along_x = _turned(z[[2, 0, 1]], zero + alpha) @ _shifted(z[[2, 0, 1]], zero + a)
    result: Floats = along_z @ along_x if convention == "standard" else along_x @ along_z
    return result


def _moved_along(axis: Floats, x: Floats, *, turns: bool) -> Floats:
    """The motion about an axis, or along it."""
    if not turns:
        return _shifted(axis[:3], x)
    result: Floats = _shifted(axis[3:]) @ _turned(axis[:3], x) @ _shifted(-axis[3:])
    return result


def _turned(axis: Floats, angle: Floats) -> Floats:
    """Rotations about a unit vector by the formula of Rodrigues."""
    x, y, z = axis
    K = np.array([[0.0, -z, y, 0.0], [z, 0.0, -x, 0.0], [-y, x, 0.0, 0.0], [0.0] * 4])
    sine, versine = np.sin(angle)[..., None, None], 2.0 * np.sin(0.5 * angle)[..., None, None] ** 2
    result: Floats = np.eye(4) + sine * K + versine * (K @ K)
    return result


def _shifted(along: Floats, by: Any = 1.0) -> Floats:  # noqa: ANN401
    """Translations along a vector."""
    T = np.tile(np.eye(4), (*np.shape(by), 1, 1))
    T[..., :3, 3] = np.multiply.outer(by, along)
    return T


def _whole(rows: Sequence[float]) -> Floats:
    return np.array([*rows, 0.0, 0.0, 0.0, 1.0]).reshape(4, 4)
