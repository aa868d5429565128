# SPDX-License-Identifier: MIT
"""The direct model of a parallel robot: refined from a seed, and all poses where that is known."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from .platform import LENGTHS, Leg, Platform, motion_of, moved_by, rates
from .status import FREE_JOINT, INVALID_POSE, OK, UNREACHABLE

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Floats = NDArray[np.float64]

STEPS = 60  # of the direct model
LONGEST_STEP = 0.25  # of those [rad, robot sizes]
CLOSED = 1e-12  # what legs may miss the platform by [robot sizes, rad]
DAMPING = 1e-14  # of a step, as a share of the squares that it divides
SAME_DRIVES = 1e-9  # drives of two rows that differ by less are the same [rad, robot sizes]
# A's smallest singular value below which a platform is singular, lengths in robot sizes: a root of
# what legs may miss.
SINGULAR = 1e-6
# A root that two of a polynomial's may share is tried where its imaginary part is as small as this,
# and circles and spheres that touch may miss each other by the square of it [robot sizes].
TOUCHES = 3e-5
ONE_ASSEMBLY = 1e-6  # two assemblies nearer than this are one [rad, robot sizes]
MOST = 6  # assemblies of a platform on three circles
TWO_CIRCLES, THREE_CIRCLES, THREE_SPHERES = "two circles", "three circles", "three spheres"
TURN = 2.0 * np.pi


def direct(
    platform: Platform, drives: Floats, T_seed: Floats, width: int
) -> tuple[Floats, Floats, int]:
    """The pose near a seed, the joint values (legs, width) and a status; NaN without a pose."""
    none = np.full((4, 4), np.nan), np.full((len(platform.legs), width), np.nan)
    valid, X = platform.read(T_seed)
    if not valid or not np.isfinite(drives).all():
        return (*none, INVALID_POSE)
    q = none[1].copy()
    first = 0
    for number, leg in enumerate(platform.legs):
        own = _nearest_drives(platform, leg, X, drives[first : first + len(leg.driven)])
        if own is None:
            return (*none, UNREACHABLE)
        q[number, : leg.module.DOF] = own
        first += len(leg.driven)
    for _ in range(STEPS):
        motions = [motion_of(platform, leg, X, q[i]) for i, leg in enumerate(platform.legs)]
        A, _ = rates(platform, motions)
        freed = [motion.free.T @ motion.miss for motion in motions]
        step = _damped(A, -np.concatenate(freed))
        longest = np.abs(step).max()
        share = min(1.0, LONGEST_STEP / longest) if longest > 0.0 else 1.0
        step *= share
        for number, (leg, motion) in enumerate(zip(platform.legs, motions, strict=True)):
            passive = list(leg.passive)
            if not passive:
                continue
            moved = _damped(motion.J[:, passive], share * motion.miss + motion.V @ step)
            most = np.abs(moved).max()
            q[number, passive] += moved * min(1.0, 2.0 * LONGEST_STEP / max(most, 1e-300))
        X = moved_by(platform, X, step)
        if max(np.abs(motion.miss).max() for motion in motions) <= CLOSED:
            for number, leg in enumerate(platform.legs):
                turns = [i for i in leg.passive if leg.module.JOINT_TYPES[i] == "R"]
                q[number, turns] -= TURN * np.ceil(q[number, turns] / TURN - 0.5)
            free = least_values(platform, X, q)[1] <= SINGULAR
            return X, q, FREE_JOINT if free else OK
    return (*none, UNREACHABLE)


def least_values(platform: Platform, X: Floats, q: Floats) -> tuple[float, float]:
    """The smallest singular values of B and of A; lengths in robot sizes."""
    motions = [motion_of(platform, leg, X, q[i]) for i, leg in enumerate(platform.legs)]
    A, B = rates(platform, motions)
    one, other = (np.linalg.svd(each, compute_uv=False) for each in (B * drive_scale(platform), A))
    return float(one[-1]), float(other[-1])


def drive_scale(platform: Platform) -> Floats:
    """What units of the drives are: lengths count in robot sizes."""
    slides = [leg.module.JOINT_TYPES[i] == "P" for leg in platform.legs for i in leg.driven]
    return np.where(slides, platform.size, 1.0)


def _damped(M: Floats, y: Floats) -> Floats:
    """The least squares of M x = y, damped a little: it has an answer where M is singular, too."""
    squares = M.T @ M
    damping = DAMPING * np.trace(squares) + 1e-300
    return np.linalg.solve(squares + damping * np.eye(len(squares)), M.T @ y)


def _nearest_drives(platform: Platform, leg: Leg, X: Floats, drives: Floats) -> Floats | None:
    """The leg's joint values at a pose whose drives are nearest to given ones, with those.

    Rows that differ in passive joints alone are told apart by limits: one within them goes first.
    """
    rows, status = map(np.asarray, leg.module.ik_all(leg.pose(X)))
    has = ~np.isnan(rows).any(axis=1)
    rows, good = rows[has], ((status == OK) | (status == FREE_JOINT))[has]
    if not len(rows):
        return None
    miss = np.zeros(len(rows))
    for joint, drive in zip(leg.driven, drives, strict=True):
        off = rows[:, joint] - drive
        turns = leg.module.JOINT_TYPES[joint] == "R"
        miss += np.abs(off - TURN * np.ceil(off / TURN - 0.5) if turns else off / platform.size)
    near = miss <= miss.min() + SAME_DRIVES
    own: Floats = rows[np.argmax(near & good if (near & good).any() else near)].copy()
    own[list(leg.driven)] = drives
    return own


def assemblies(platform: Platform, elimination: str, drives: Floats, width: int) -> Floats:
    """All poses (k, 4, 4) that drives' values allow, refined."""
    if not np.isfinite(drives).all():
        return np.empty((0, 4, 4))
    centers, radii = np.empty((len(platform.legs), 3)), np.empty(len(platform.legs))
    first = 0
    for number, leg in enumerate(platform.legs):
        own = drives[first : first + len(leg.driven)]
        centers[number], radii[number] = _center(leg, own)
        first += len(leg.driven)
    if elimination == THREE_CIRCLES:
        seeds = _triangle(platform, centers, radii)
    else:
        centers -= [leg.end[:3, 3] for leg in platform.legs]
        meet = _circles if elimination == TWO_CIRCLES else _spheres
        seeds = [_placed(point, 0.0) for point in meet(centers, radii, platform.size)]
    found: list[Floats] = []
    for seed in seeds:
        T, _, status = direct(platform, drives, seed, width)
        if status not in {OK, FREE_JOINT}:
            continue
        units = np.array([1.0, 1.0, 1.0, platform.size])
        if all(np.abs((T - other)[:3] / units).max() > ONE_ASSEMBLY for other in found):
            found.append(T)
    return np.array(found).reshape(-1, 4, 4)


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
    """Where two circles in the plane meet."""
    apart = (centers[1] - centers[0])[:2]
    square = apart @ apart
    if square <= (TOUCHES**2 * size) ** 2:
        return []
    along = 0.5 * (square + radii[0] ** 2 - radii[1] ** 2) / square
    beside = radii[0] ** 2 / square - along**2
    if beside < -(TOUCHES**2) * size**2 / square:
        return []
    across = np.sqrt(max(beside, 0.0)) * np.array([-apart[1], apart[0]])
    return [centers[0][:2] + along * apart + sign * across for sign in (1.0, -1.0)]


def _spheres(centers: Floats, radii: Floats, size: float) -> list[Floats]:
    """Where three spheres meet: on the line that the planes of two pairs of them share."""
    normals = centers[1:] - centers[0]
    line = np.cross(*normals)
    if np.linalg.norm(line) <= (TOUCHES * size) ** 2:
        return []
    sides = 0.5 * (radii[0] ** 2 - radii[1:] ** 2 + (normals**2).sum(axis=1))
    foot = np.linalg.lstsq(normals, sides, rcond=None)[0]
    square = radii[0] ** 2 - foot @ foot
    if square < -((TOUCHES * size) ** 2):
        return []
    beside = np.sqrt(max(square, 0.0)) / np.linalg.norm(line) * line
    return [centers[0] + foot + sign * beside for sign in (1.0, -1.0)]


def _triangle(platform: Platform, centers: Floats, radii: Floats) -> list[Floats]:
    """A platform on three circles: the roots of a polynomial of degree six, as poses.

    Its first point goes around the origin, |p| = r, and each of the two others is at e in the
    platform and goes around E: 2 (R e - E) . p = s^2 - r^2 - |e|^2 - |E|^2 + 2 E . R e, with R the
    turn by phi.
    These are linear in p, and |p| = r is a polynomial of degree three in cos phi and sin phi
    (Gosselin, Sefrioui and Richard 1992). As one in exp(i phi) its coefficients are those of a
    Fourier series, and its roots of length one are the angles.
    """
    ends = np.array([leg.end[:2, 3] for leg in platform.legs])
    e, E = ends[1:] - ends[0], (centers[1:] - centers[0])[:, :2]
    r, s = radii[0], radii[1:]

    def rows(angle: float) -> tuple[Floats, Floats]:
        turned = e @ _placed(np.zeros(2), angle)[:2, :2].T
        sides = s**2 - r**2 - (e**2).sum(axis=1) - (E**2).sum(axis=1)
        return turned - E, 0.5 * sides + (E * turned).sum(axis=1)

    def miss(angle: float) -> float:
        lines, sides = rows(angle)
        across = np.array([[lines[1, 1], -lines[0, 1]], [-lines[1, 0], lines[0, 0]]]) @ sides
        return float(across @ across - r * r * np.linalg.det(lines) ** 2)

    values = np.array([miss(TURN * k / 7) for k in range(7)])
    series = np.fft.fft(values) / 7.0
    roots = np.roots(np.concatenate([series[3::-1], series[:3:-1]]))
    poses: list[Floats] = []
    for root in roots[np.abs(np.abs(roots) - 1.0) < TOUCHES]:
        angle = float(np.angle(root))
        lines, sides = rows(angle)
        lengths = np.linalg.norm(lines, axis=1)
        if abs(np.linalg.det(lines)) > ONE_ASSEMBLY * lengths.prod():
            points = [np.linalg.solve(lines, sides)]
        else:  # both lines are one: it meets the circle twice
            normal = lines[np.argmax(lengths)] / lengths.max()
            along = sides[np.argmax(lengths)] / lengths.max()
            beside = np.sqrt(max(r * r - along * along, 0.0)) * np.array([-normal[1], normal[0]])
            points = [along * normal + beside, along * normal - beside]
        turn = _placed(np.zeros(2), angle)[:2, :2]
        poses += [_placed(centers[0][:2] + point - turn @ ends[0], angle) for point in points]
    return poses
