"""The nearest arm with a structure: of an arm whose axes miss it by little."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.neighbours import EXACT
from dhgen.kinematics.numeric import numeric_arm
from dhgen.kinematics.rigid import inverse, orthonormal
from dhgen.nominal.deviation import most_deviation
from dhgen.nominal.fit import DIGITS, Fit, fitted
from dhgen.nominal.lines import neighbours
from dhgen.nominal.table import NONE_KEPT, lengths_of, rounded_table, small_lengths
from dhgen.robot.angles import twelfths

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.rigid import Matrix, Vector
    from dhgen.nominal.deviation import Deviation
    from dhgen.nominal.lines import Neighbours
    from dhgen.nominal.table import Table

# An arm that keeps a small length is tried if it is nearer than this part of the distance of the
# arm that keeps none. Where all numbers of a table have errors, keeping one length gains little.
NEARER = 0.6


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

    @property
    def links(self) -> FloatArray:
        """C0 ... Cn of its pose C0 Rz(angle 1) C1 ... Rz(angle n) Cn at angles of the arm's."""
        links = self.table.links(self.table.lengths, np.array(self.offsets[1:-1]))
        return np.array([np.eye(4), *links, np.eye(4)])


def nearest_arms(chain: Chain) -> list[Nearest]:
    """Arms that may have a structure, the nearest first; none where nothing is missed by little.

    All small lengths are zero in the last one. A structure may not need all of these zeros: before
    it come arms that are much nearer by keeping one of the lengths.

    Args:
        chain: An arm of joints that turn.
    """
    arm, drives = numeric_arm(chain), chain.drives
    still = np.array(drives.back(list(np.zeros(chain.dof))))
    directions, points = arm.axes(still)
    found = neighbours(directions, points)
    if found is None:
        return []
    kept = [frozenset({place}) for place in small_lengths(found, chain.size)]
    tables = [rounded_table(found, chain.size, each) for each in (NONE_KEPT, *kept)]
    frames, tool = _frames(found, directions), arm.pose(still)
    wanted = np.linalg.inv(np.array([np.eye(4), *frames])) @ np.array([*frames, tool])
    fits = [
        _nearest(chain, fitted(_start(table, found, frames, tool), wanted, chain.size), wanted)
        for table in tables
        if _is_missed(table, found)
    ]
    if not fits:
        return []
    most = NEARER * _apart(fits[0], chain)
    nearer = sorted(
        (each for each in fits[1:] if _apart(each, chain) < most),
        key=lambda each: _apart(each, chain),
    )
    return [*nearer, fits[0]]


def _apart(nearest: Nearest, chain: Chain) -> float:
    """How far the tools are apart at most, in arm sizes and rad."""
    return nearest.deviation.angle + nearest.deviation.length / chain.size


def _nearest(chain: Chain, fit: Fit, wanted: FloatArray) -> Nearest:
    """The arm of a fit, whose given joints' offsets are as a robot file has them."""
    fit = replace(fit, offsets=np.array(_as_read(chain, fit.offsets)))
    a, d = fit.table.filled(fit.lengths)
    return Nearest(
        replace(fit.table, a=tuple(a), d=tuple(d)),
        inverse(_rigid(fit.base)),
        inverse(_rigid(fit.tool)),
        (0.0, *map(float, fit.offsets), 0.0),
        most_deviation(wanted, fit.constants, chain.size),
    )


def _as_read(chain: Chain, offsets: FloatArray) -> list[float]:
    """The offsets of angles 2 to n - 1, of given joints as a robot file is read.

    Their values go into the closed form as they are, so that its robot file has the offsets; and
    nearly exact angles are taken as exact there.
    """
    inner = chain.joints[1:-1]
    return [
        _exact(joint.offset + more) - joint.offset if joint.number in chain.free else more
        for joint, more in zip(inner, map(float, offsets), strict=True)
    ]


def _exact(angle: float) -> float:
    k = twelfths(angle)
    return angle if k is None else k * math.pi / 12


def _is_missed(table: Table, found: tuple[Neighbours, ...]) -> bool:
    """Whether anything was rounded by more than rounding."""
    own = *(each.alpha for each in found), *lengths_of(found)
    pairs = zip((*table.alpha, *table.a, *table.d), own, strict=True)
    return any(abs(rounded - number) > EXACT for rounded, number in pairs)


def _frames(found: tuple[Neighbours, ...], directions: FloatArray) -> FloatArray:
    """A frame on each axis, all angles zero: z along it, x along a common normal, (n, 4, 4)."""
    normals = [found[0].normal, *(each.normal for each in found)]
    feet = [found[0].foot - found[0].a * found[0].normal, *(each.foot for each in found)]
    frames = np.zeros((len(feet), 4, 4))
    for frame, z, normal, foot in zip(frames, directions, normals, feet, strict=True):
        x = normal - (normal @ z) * z
        x /= np.linalg.norm(x)
        frame[:3, 0], frame[:3, 1], frame[:3, 2], frame[:3, 3] = x, np.cross(z, x), z, foot
        frame[3, 3] = 1.0
    return frames


def _start(
    table: Table, found: tuple[Neighbours, ...], frames: FloatArray, tool: FloatArray
) -> Fit:
    """The base, the tool and the offsets with which the axes lie nearly where the arm has them."""
    normals = [each.normal for each in found]
    offsets = np.array(
        [
            float(np.arctan2(np.cross(one, other) @ frame[:3, 2], one @ other))
            for one, other, frame in zip(normals, normals[1:], frames[1:], strict=False)
        ]
    )
    last = base = frames[0]
    for link in table.links(table.lengths, offsets):
        last = last @ link
    still = np.zeros(table.joints)
    return Fit(table, base, np.linalg.inv(last) @ tool, table.lengths, offsets, still, still)


def _rigid(frame: FloatArray) -> Matrix:
    return orthonormal(tuple(map(tuple, np.round(frame, DIGITS).tolist())))
