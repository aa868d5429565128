"""The figure of a parallel robot: its legs and its platform at the worked example."""

from __future__ import annotations

from math import atan2
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.figures.figure import Figure, figure_path
from dhgen.derivation.figures.sheet import Sheet
from dhgen.derivation.text.blocks import say
from dhgen.kinematics.numeric import numeric_arm
from dhgen.parallel.worked import square

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.derivation.figures.sheet import Point
    from dhgen.parallel.module import ParallelModule
    from dhgen.parallel.worked import Example

SIDE = 420.0  # of the drawing [pixels]
JOINT, FOOT = 3.0, 5.0  # radii of discs [pixels]
OBLIQUE = np.array([[1.0, 0.45, 0.0], [0.0, 0.35, 1.0]])  # x to the right, y away, z up
ABOVE = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
SHORT = 1e-6  # links that are not drawn [robot sizes]


def example_figure(module: ParallelModule, example: Example) -> Figure:
    """The legs from their feet to the platform at the example."""
    legs = [_points(module, example, number) for number in range(len(module.legs))]
    view = ABOVE if module.is_planar else OBLIQUE
    drawn = [leg @ view.T for leg in legs]
    ends = np.concatenate(drawn)
    low, high = ends.min(axis=0), ends.max(axis=0)
    scale = SIDE / max(high - low)

    def at(point: FloatArray) -> Point:
        x, y = scale * (point - low)
        return float(x), float(SIDE - y)

    sheet = Sheet()
    corners = [at(drawn[number][-1]) for number in _around(module)]
    sheet.line([*corners, corners[0]], "held")
    for number, leg in enumerate(drawn, start=1):
        points = [at(point) for point in leg]
        sheet.line(points, "link")
        for point in points[1:]:
            sheet.disc(point, JOINT, "body")
        sheet.disc(points[0], FOOT, "body")
        sheet.words((points[0][0] + 2 * FOOT, points[0][1] + 2 * FOOT), str(number), "tn")
    seen = "seen from above" if module.is_planar else "seen from the side"
    return Figure(
        figure_path(module.name, "platform"),
        f"{module.robot.title}: the legs and the platform",
        say(f"The legs and the platform at the example, {seen}."),
        sheet,
    )


def _around(module: ParallelModule) -> list[int]:
    """The legs in the order in which a line around the platform meets what they carry."""
    ends = [(leg.leg.end[3], leg.leg.end[7]) for leg in module.legs]
    x, y = np.mean(ends, axis=0)
    return sorted(range(len(ends)), key=lambda i: atan2(ends[i][1] - y, ends[i][0] - x))


def _points(module: ParallelModule, example: Example, number: int) -> FloatArray:
    """The points of a leg's axes, from its foot to the platform, in the robot's base."""
    leg = module.legs[number]
    row = int(np.argmax(example.inside[number]))
    q = example.rows[number, row, : leg.solver.chain.dof]
    arm, base = numeric_arm(leg.solver.chain), square(leg.leg.base)
    points = [np.zeros(3), *arm.axes(q)[1], arm.pose(q)[:3, 3]]
    kept = [points[0]]
    for point in points[1:]:
        if np.linalg.norm(point - kept[-1]) > SHORT * module.size:
            kept.append(point)
    return np.array(kept) @ base[:3, :3].T + base[:3, 3]
