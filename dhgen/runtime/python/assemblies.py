# SPDX-License-Identifier: MIT
"""All poses of a platform that drives' values allow.

For platforms whose legs, the drives being held, let what they carry go around a point: on circles
in the plane, or on spheres.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from .direct import TURN, direct
from .platform import LENGTHS, Leg, Platform
from .status import FREE_JOINT, OK

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

MOST_ASSEMBLIES = 6  # of a platform on three circles
# A pose is tried where squares of lengths leave so little below zero [squares of robot sizes], or a
# polynomial at an extremum, beside its largest coefficient. Rounding leaves 1e-15 of them, and more
# where coefficients cancel; what is tried and is none does not close when it is refined.
TOUCHES = 1e-9
# Centres that are no farther apart are one [robot sizes].
ONE_CENTER = 1e-9
# Two assemblies that are no farther apart are one [rad, robot sizes]: a root of what legs may miss.
ONE_ASSEMBLY = 1e-6
# Where both equations of a platform on three circles have rows no longer than this [robot sizes] it
# nearly goes around: up to four roots have nearly merged, none has more than a fourth of the
# digits, and so many places on the first point's circle are tried.
NEARLY_AROUND, PLACES_AROUND = 1e-3, 8
TWO_CIRCLES, THREE_CIRCLES, THREE_SPHERES = "two circles", "three circles", "three spheres"


class ContinuumError(ValueError):
    """The poses that drives' values allow are not single ones."""

    def __init__(self) -> None:
        super().__init__("the platform can move while its drives are held: no pose is one of few")


def assemblies(platform: Platform, elimination: str, drives: Floats, width: int) -> Floats:
    """All poses (k, 4, 4) that drives' values allow, refined.

    Raises:
        ContinuumError: The platform can move while its drives are held.
    """
    centers, radii = np.empty((len(platform.legs), 3)), np.empty(len(platform.legs))
    first = 0
    for number, leg in enumerate(platform.legs):
        own = drives[first : first + len(leg.driven)]
        centers[number], radii[number] = _center(leg, own)
        first += len(leg.driven)
    if elimination == THREE_CIRCLES:
        seeds = _on_three_circles(platform, centers, radii)
    else:
        centers -= [leg.end[:3, 3] for leg in platform.legs]
        meet = _circles if elimination == TWO_CIRCLES else _spheres
        seeds = [_placed(point, 0.0) for point in meet(centers, radii, platform.size)]
    found: list[Floats] = []
    units = np.array([1.0, 1.0, 1.0, platform.size])
    for seed in seeds:
        T, _, status = direct(platform, drives, seed, width)
        is_one = status in {OK, FREE_JOINT} and len(found) < MOST_ASSEMBLIES
        if is_one and all(np.abs((T - o)[:3] / units).max() > ONE_ASSEMBLY for o in found):
            found.append(T)
    if elimination == THREE_CIRCLES:
        found = _ascending(found, platform.size)
    return np.array(found).reshape(-1, 4, 4)


def _ascending(poses: Sequence[Floats], size: float) -> list[Floats]:
    """Poses in the order of their yaw, then of their place."""
    ordered: list[Floats] = []
    for T in poses:
        places = (i for i, other in enumerate(ordered) if _comes_before(T, other, size))
        ordered.insert(next(places, len(ordered)), T)
    return ordered


def _comes_before(one: Floats, other: Floats, size: float) -> bool:
    yaws = [math.atan2(T[1, 0], T[0, 0]) for T in (one, other)]
    low, high = (yaw if yaw > ONE_ASSEMBLY - np.pi else yaw + TURN for yaw in yaws)
    for apart in (high - low, (other - one)[0, 3] / size, (other - one)[1, 3] / size):
        if abs(apart) > ONE_ASSEMBLY:
            return bool(apart > 0.0)
    return False


def _center(leg: Leg, drives: Floats) -> tuple[Floats, float]:
    """Around which point of the robot's base a leg lets go what it carries, and how far from it."""
    q = np.zeros(leg.module.DOF)
    q[list(leg.driven)] = drives
    p, J = np.asarray(leg.module.fk(q))[:3, 3], np.asarray(leg.module.jacobian(q))
    passive = list(leg.passive)[:2]
    lines = J[LENGTHS:, passive].T
    points = p + np.cross(lines, J[:LENGTHS, passive].T)
    along = 0.0
    if len(lines) > 1:  # where the first axis is nearest to the second
        apart, both = points[1] - points[0], lines[0] @ lines[1]
        along = (apart @ lines[0] - both * (apart @ lines[1])) / (1.0 - both * both)
    own = points[0] + along * lines[0]
    center = leg.base[:3, :3].T @ (own - leg.base[:3, 3])
    return center, float(np.linalg.norm(p - own))


def _placed(point: Floats, angle: float) -> Floats:
    T = np.eye(4)
    c, s = np.cos(angle), np.sin(angle)
    T[:2, :2] = [[c, -s], [s, c]]
    T[: len(point), 3] = point
    return T


def _circles(centers: Floats, radii: Floats, size: float) -> list[Floats]:
    """Where two circles in the plane meet.

    Raises:
        ContinuumError: They are one circle.
    """
    one, apart = centers[0, :2], (centers[1] - centers[0])[:2]
    r, s = (radii**2).tolist()
    square, touches = float(apart @ apart), TOUCHES * size**2
    if not square > (ONE_CENTER * size) ** 2:
        if abs(r - s) <= touches:
            raise ContinuumError
        return []
    along = 0.5 * (square + r - s) / square
    beside = r / square - along**2
    if not beside >= -touches / square:
        return []
    across = math.sqrt(max(beside, 0.0)) * np.array([-apart[1], apart[0]])
    return [one + along * apart + sign * across for sign in (1.0, -1.0)]


def _spheres(centers: Floats, radii: Floats, size: float) -> list[Floats]:
    """Where three spheres meet (F. Thomas and L. Ros, Revisiting trilateration, 2005).

    Raises:
        ContinuumError: They have a circle in common, or are one sphere.
    """
    lengths = ((centers - centers[0]) ** 2).sum(axis=1)
    one, other = (2, 1) if lengths[2] > lengths[1] else (1, 2)
    d, touches = math.sqrt(lengths[one]), TOUCHES * size**2
    square = float(radii[0] ** 2)
    less, less_other = (square - float(radii[k] ** 2) for k in (one, other))
    if not d > ONE_CENTER * size:
        if max(abs(less), abs(less_other)) <= touches:
            raise ContinuumError
        return []
    x = (centers[one] - centers[0]) / d
    i = float(x @ (centers[other] - centers[0]))
    y = centers[other] - centers[0] - i * x
    j, u = float(np.linalg.norm(y)), 0.5 * (d + less / d)
    if not j > ONE_CENTER * size:  # in a line
        if not abs(less_other + i * i - 2.0 * i * u) <= touches or not square - u * u >= -touches:
            return []
        if square - u * u > touches:
            raise ContinuumError
        return [centers[0] + u * x]
    v = 0.5 * (j + (less_other + i * i) / j) - i * u / j
    square -= u * u + v * v
    if not square >= -touches:
        return []
    w = (1.0 if one == 1 else -1.0) * math.sqrt(max(square, 0.0))
    across = w * np.cross(x, y / j)
    return [centers[0] + u * x + v * y / j + sign * across for sign in (1.0, -1.0)]


def real_roots(p: Sequence[float]) -> list[float]:
    """The real roots of a polynomial, lowest coefficient first, the last not zero, ascending.

    Between the roots of its derivative there is one, or none. Where it touches zero there is one,
    too; beside a change of sign it does not touch: that root is found, and a pair nearly merged is
    two of them.
    """
    degree = len(p) - 1
    found: list[float] = []
    for order in range(1, degree + 1):
        lost = degree - order  # of the derivative that has this degree
        d = [p[k + lost] * math.perm(k + lost, lost) for k in range(order + 1)]
        largest = max(map(abs, d))
        bound = 1.0 + max(abs(each / d[order]) for each in d[:order])
        edges = [-bound, *found, bound]
        values = [_polynomial(d, x) for x in edges]
        changed = True  # nothing touches zero at the bound
        roots: list[float] = []
        for k in range(len(edges) - 1):
            low, high, at_low = edges[k], edges[k + 1], values[k]
            changes = (at_low < 0.0) != (values[k + 1] < 0.0)
            touches = abs(at_low) <= TOUCHES * largest * (1.0 + abs(low) ** order)
            if order == degree and touches and not changed and not changes and len(roots) < order:
                roots.append(low)
            if changes and len(roots) < order:
                roots.append(_bisected(d, low, high, is_negative=at_low < 0.0))
            changed = changes
        found = roots
    return found


def _bisected(p: Sequence[float], low: float, high: float, *, is_negative: bool) -> float:
    for _ in range(80):
        if not low < high:
            break
        middle = 0.5 * (low + high)
        if (_polynomial(p, middle) < 0.0) == is_negative:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def _polynomial(p: Sequence[float], x: float) -> float:
    value = 0.0
    for coefficient in reversed(p):
        value = value * x + coefficient
    return value


@dataclass(frozen=True, slots=True)
class _Triangle:
    """A platform on three circles.

    Its first point goes around the origin, |p| = r, and each of the two others is at e in the
    platform and goes around E: 2 (R e - E) . p = s^2 - r^2 - |e|^2 - |E|^2 + 2 E . R e, with R the
    turn by phi. These are linear in p, their determinant and the numerators are known functions of
    phi, and |p| = r is a polynomial of degree three in cos phi and sin phi, of degree six in
    tan(phi/2) (C. Gosselin, J. Sefrioui and M. Richard, 1992).
    """

    e: Floats
    E: Floats
    r: float
    s: Floats

    def rows(self, angle: float) -> tuple[Floats, Floats]:
        """The two linear equations at an angle: rows and right sides."""
        turned = self.e @ _placed(np.zeros(2), angle)[:2, :2].T
        sides = self.s**2 - self.r**2 - (self.e**2).sum(axis=1) - (self.E**2).sum(axis=1)
        return turned - self.E, 0.5 * sides + (self.E * turned).sum(axis=1)

    def miss(self, angle: float) -> float:
        """What |p| = r misses at an angle, times the square of the determinant."""
        (a, b), (c, d) = self.rows(angle)[0].tolist()
        right, other = self.rows(angle)[1].tolist()
        x, y, det = right * d - other * b, a * other - c * right, a * d - b * c
        return float(x * x + y * y - self.r * self.r * det * det)

    def angles(self) -> list[float]:
        """The platform's angles: at most six."""
        # half a turn away from where tan(phi/2) is zero there is no root
        tried = [abs(self.miss(TURN * k / 28)) for k in range(28)]
        largest, farthest = max(tried), int(np.argmax(tried))
        if not 0.0 < largest < math.inf:
            return []
        start = TURN * farthest / 28 - np.pi
        values = np.array([self.miss(start + TURN * k / 7) for k in range(7)]) / largest
        series = np.fft.fft(values) / 7.0  # of exp(i n phi)
        p = np.zeros(7)
        for n in range(4):
            # (1 + t^2)^3 exp(i n phi) = (1 + i t)^(3 + n) (1 - i t)^(3 - n)
            factors = [1j] * (3 + n) + [-1j] * (3 - n)
            power = np.ones(1, complex)
            for factor in factors:
                power = np.convolve(power, [1.0, factor])
            p += (2.0 if n else 1.0) * (series[n] * power).real
        return [start + 2.0 * math.atan(t) for t in real_roots(p.tolist())]

    def goes_around(self, size: float) -> bool:
        """Whether the platform is as large as the base, on equal circles."""
        (x, y), (X, Y) = self.e[0], self.E[0]
        square = x * x + y * y
        if not square > 0.0:
            return False
        c, s = (x * X + y * Y) / square, (x * Y - y * X) / square
        off = [self.e @ np.array([[c, s], [-s, c]]) - self.E, self.s - self.r]
        off.append((c * c + s * s - 1.0) * math.sqrt(square))
        return bool(max(np.abs(each).max() for each in off) <= ONE_ASSEMBLY * size)

    def points(self, angle: float, size: float) -> list[Floats]:
        """The places of the first point at an angle of the platform."""
        rows, right = self.rows(angle)
        (a, b), (c, d) = rows
        det, squares = a * d - b * c, (rows**2).sum(axis=1)
        i = int(squares[0] < squares[1])
        if not squares[i] > (NEARLY_AROUND * size) ** 2:
            ways = (TURN * k / PLACES_AROUND for k in range(PLACES_AROUND))
            return [self.r * np.array([math.cos(way), math.sin(way)]) for way in ways]
        is_single = squares[1 - i] > (ONE_ASSEMBLY * size) ** 2
        if is_single and abs(det) > ONE_ASSEMBLY * math.sqrt(squares.prod()):
            return [np.array([right[0] * d - right[1] * b, a * right[1] - c * right[0]]) / det]
        # both lines are one, or one is none: the other meets the circle twice
        along = right[i] / squares[i]
        beside = math.sqrt(max(self.r**2 / squares[i] - along**2, 0.0))
        across = beside * np.array([-rows[i, 1], rows[i, 0]])
        return [along * rows[i] + sign * across for sign in (1.0, -1.0)]


def _on_three_circles(platform: Platform, centers: Floats, radii: Floats) -> list[Floats]:
    """Poses of a platform on three circles, to be refined.

    Raises:
        ContinuumError: It goes around.
    """
    ends = np.array([leg.end[:2, 3] for leg in platform.legs])
    of = _Triangle(ends[1:] - ends[0], (centers[1:] - centers[0])[:, :2], radii[0], radii[1:])
    if of.goes_around(platform.size):
        raise ContinuumError
    poses: list[Floats] = []
    for angle in of.angles():
        carried = _placed(np.zeros(2), angle)[:2, :2] @ ends[0]
        for point in of.points(angle, platform.size):
            poses.append(_placed(centers[0, :2] + point - carried, angle))  # noqa: PERF401
    return poses
