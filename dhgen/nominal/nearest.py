"""The nearest arm with a structure: of an arm whose axes miss it by little."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.neighbours import EXACT
from dhgen.kinematics.numeric import numeric_arm
from dhgen.kinematics.rigid import inverse, orthonormal
from dhgen.nominal.deviation import most_deviation
from dhgen.nominal.fit import DIGITS, JOINTS, fitted
from dhgen.nominal.lines import neighbours
from dhgen.nominal.table import rounded_table

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.rigid import Matrix, Vector
    from dhgen.nominal.deviation import Deviation
    from dhgen.nominal.fit import Fit
    from dhgen.nominal.lines import Neighbours
    from dhgen.nominal.table import Table


@dataclass(frozen=True, slots=True)
class Nearest:
    """An arm with a structure that lies near another one.

    Attributes:
        table: Its links.
        left: From a pose T of the arm to what the table's is, left T right.
        right: The same behind it.
        offsets: What the table's angles are more than the arm's [rad].
        deviation: How far the two arms' tools are apart at most.
    """

    table: Table
    left: Matrix
    right: Matrix
    offsets: Vector
    deviation: Deviation


def nearest_arm(chain: Chain) -> Nearest | None:
    """The nearest arm with a structure; None where nothing is missed by little.

    Args:
        chain: An arm of six joints that turn.
    """
    arm = numeric_arm(chain)

    def pose(angles: FloatArray) -> FloatArray:
        return arm.pose(np.stack(chain.drives.back(list(np.moveaxis(angles, -1, 0))), axis=-1))

    still = np.zeros(JOINTS)
    directions, points = arm.axes(np.array(chain.drives.back(list(still))))
    found = neighbours(directions, points)
    if found is None:
        return None
    table = rounded_table(found, chain.size)
    if not _is_missed(table, found):
        return None
    tool = pose(still)
    fit = fitted(table, _start(table, found, directions, tool), pose, chain.size)
    feet = np.array([points[0], *(each.foot for each in found)])
    ours, theirs = (directions, feet, tool), (*_axes(fit), fit.pose(still))
    a, d = table.filled(fit.lengths)
    return Nearest(
        replace(table, a=tuple(a), d=tuple(d)),
        inverse(_rigid(fit.base)),
        inverse(_rigid(fit.tool)),
        (0.0, *map(float, fit.offsets), 0.0),
        most_deviation(ours, theirs),
    )


def _is_missed(table: Table, found: tuple[Neighbours, ...]) -> bool:
    """Whether anything was rounded by more than rounding."""
    pairs = zip((*table.alpha, *table.a, *table.d), _numbers(found), strict=True)
    return any(abs(number - own) > EXACT for number, own in pairs)


def _numbers(found: tuple[Neighbours, ...]) -> list[float]:
    columns = [[each.alpha for each in found], [each.a for each in found]]
    return [number for column in (*columns, [each.d for each in found]) for number in column]


def _start(
    table: Table, found: tuple[Neighbours, ...], directions: FloatArray, tool: FloatArray
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """The base, the tool and the offsets with which the axes lie nearly where the arm has them."""
    normals = [each.normal for each in found]
    offsets = [
        float(np.arctan2(np.cross(one, other) @ z, one @ other))
        for one, other, z in zip(normals, normals[1:], directions[1:], strict=False)
    ]
    base = np.eye(4)
    x = normals[0] - (normals[0] @ directions[0]) * directions[0]
    base[:3, 0] = x / np.linalg.norm(x)
    base[:3, 2] = directions[0]
    base[:3, 1] = np.cross(base[:3, 2], base[:3, 0])
    base[:3, 3] = found[0].foot - found[0].a * normals[0]
    last = base
    for link in table.links(table.lengths, np.array(offsets)):
        last = last @ link
    return base, np.linalg.inv(last) @ tool, np.array(offsets)


def _axes(fit: Fit) -> tuple[FloatArray, FloatArray]:
    """Directions and points of the axes, all angles zero."""
    frames = [fit.base]
    for link in fit.links:
        frames.append(frames[-1] @ link)
    return np.array([each[:3, 2] for each in frames]), np.array([each[:3, 3] for each in frames])


def _rigid(frame: FloatArray) -> Matrix:
    return orthonormal(tuple(map(tuple, np.round(frame, DIGITS).tolist())))
