"""Robots given by their axes in the reference position (document 001: P(q) = K_1 ... K_n P(0)).

When every axis points along a direction whose frame is exact, the chain is built from the axes
as they are, with their parameters: frame i is the reference frame carried along by joint i, at
a point of axis i. Any other set of axes is for `common_normals.py`, and so is one where letters
hide that an axis meets another, or lies level with it, seen along a slanting direction. So is one
without letters of the user's whose points are elsewhere on slanting axes than where these are
nearest to their neighbours: there is nothing to be kept.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING

from dhgen.kinematics.chain import Chain, ChainJoint, Element, Fixed, Slide, Turn, arm_size
from dhgen.kinematics.constants import ConstantTable
from dhgen.kinematics.normal import NormalForm, normal_form
from dhgen.kinematics.ring import terms_in_numbers
from dhgen.kinematics.transform import Transform, compose, identity, inverse, read_frame
from dhgen.robot.angles import SNAP
from dhgen.robot.exact import Surd, square_root, surd
from dhgen.robot.expression import ZERO
from dhgen.robot.robot import Frame, JointKind

if TYPE_CHECKING:
    from collections.abc import Mapping

    from sympy.polys.rings import PolyRing

    from dhgen.kinematics.constants import Polynomial
    from dhgen.robot.expression import Expression
    from dhgen.robot.robot import AxisJoint, ReferenceAxes, Robot

    Axis = tuple[list[Polynomial], list[Polynomial]]  # direction and point
    Rotation = tuple[tuple[Polynomial, ...], ...]


def exact_axes(robot: Robot, reference: ReferenceAxes) -> Chain | None:
    """The chain of reference axes as they are, or None for `common_normals.py`."""
    table = ConstantTable({parameter.name: parameter.value for parameter in robot.parameters})
    _read(robot, reference, table)
    ring = table.close()
    axes, home, base, tool = _read(robot, reference, table)
    constants = tuple(table.constants.values())
    normal = normal_form(ring, constants, {})
    placed = _frames(reference.axes, axes, ring, normal)
    if placed is None:
        return None
    frames, signs = placed
    joints = tuple(
        ChainJoint(number, joint.kind, sign, 0.0, joint.limits, joint.name)
        for number, (joint, sign) in enumerate(zip(reference.axes, signs, strict=True), 1)
    )
    values = {each.name: each.value for each in constants}
    steps = _steps([identity(ring), *frames, home], normal, values)
    if steps is None:
        return None
    if not robot.parameters and not all(_is_level(step, normal) for step in steps[1:-1]):
        return None
    *links, last = steps
    # wherever the arm is in its frame, and that in the caller's
    lengths = [_distance(step, values) for step in (*steps[1:], tool)]
    return Chain(
        name=robot.name,
        joints=joints,
        links=_links(reference.axes, links, identity(ring)),
        base=base,
        tool=compose(last, tool, normal),
        constants=constants,
        ring=ring,
        task=robot.task,
        free=robot.free,
        size=arm_size(lengths, joints),
        arm_angle=robot.arm_angle,
    )


def _read(
    robot: Robot, reference: ReferenceAxes, table: ConstantTable
) -> tuple[list[Axis], Transform, Transform, Transform]:
    first: dict[tuple[str, Expression], tuple[str, str]] = {}

    def coordinate(x: str, cell: Expression, name: str, of: str) -> Polynomial:
        """What is at one height shares its name, so that what coincides in the file does here."""
        name, meaning = first.setdefault((x, cell), (f"{name}{x}", f"{x} of {of}"))
        return table.length(cell, name, meaning)

    axes = [
        (
            [table.scalar(c, f"u{i}{x}", f"{x} of axis {i}") for x, c in _xyz(_unit(joint))],
            [coordinate(x, c, f"p{i}", f"axis {i}") for x, c in _xyz(joint.point)],
        )
        for i, joint in enumerate(reference.axes, start=1)
    ]
    turned = read_frame(Frame((ZERO,) * 3, reference.home.rotation), table, "h", "home pose")
    origin = [coordinate(x, c, "h", "the home pose") for x, c in _xyz(reference.home.xyz)]
    home = Transform(turned.rotation, tuple(origin))
    base = read_frame(robot.base, table, "z", "base frame")
    return axes, home, base, read_frame(robot.tool, table, "e", "tool frame")


def _unit(joint: AxisJoint) -> tuple[Expression, Expression, Expression]:
    """The direction at length one where that takes roots of 2 and 3 only; elsewhere as it is."""
    parts = [surd(cell) for cell in joint.direction]
    x, y, z = (part or Surd.of(0) for part in parts)
    square, *irrational = (x * x + y * y + z * z).coefficients
    length = None if None in parts or any(irrational) else square_root(square)
    scale = length and length.inverse()
    if scale is None or scale == Surd.of(1):
        return joint.direction
    return (x * scale).expression(), (y * scale).expression(), (z * scale).expression()


def _xyz(cells: tuple[Expression, Expression, Expression]) -> list[tuple[str, Expression]]:
    return list(zip("xyz", cells, strict=True))


def _frames(
    joints: tuple[AxisJoint, ...], axes: list[Axis], ring: PolyRing, normal: NormalForm
) -> tuple[list[Transform], list[int]] | None:
    """A frame on every axis in the reference position, and whether its z is the axis or -axis."""
    frames: list[Transform] = []
    signs: list[int] = []
    at: tuple[Polynomial, ...] = (ring.zero,) * 3
    for joint, (direction, point) in zip(joints, axes, strict=True):
        framed = _frame_along(direction, ring, normal)
        if framed is None:
            return None
        rotation, sign = framed
        if joint.kind is JointKind.REVOLUTE:
            at = _nearest(rotation, point, at)
        frames.append(Transform(rotation, at))
        signs.append(sign)
    return frames, signs


def _steps(
    frames: list[Transform], normal: NormalForm, values: Mapping[str, float]
) -> list[Transform] | None:
    """From each frame to the next, or None where a coordinate is zero that letters do not show."""
    steps = [
        _settled(compose(inverse(before, normal), after, normal), values)
        for before, after in pairwise(frames)
    ]
    backward = (inverse(step, normal).translation for step in steps)
    hidden = any(_cancels(entry, values) for translation in backward for entry in translation)
    return None if hidden else steps


def _is_level(step: Transform, normal: NormalForm) -> bool:
    """Whether a frame's origin is where its axis is nearest to the one before."""
    (x, y, _), direction = step.translation, step.column(2)
    return not normal(x * direction[0] + y * direction[1])


def _settled(step: Transform, values: Mapping[str, float]) -> Transform:
    """Coordinates that agree, but for what floating point left in the file, agree.

    So do lengths that happen to: what coincides is what solves an arm.
    """
    kept = (entry.ring.zero if _cancels(entry, values) else entry for entry in step.translation)
    return Transform(step.rotation, tuple(kept))


def _cancels(entry: Polynomial, values: Mapping[str, float]) -> bool:
    """Whether the terms of a coordinate add up to zero in numbers, though not in letters."""
    terms = terms_in_numbers(entry, values)
    return len(terms) > 1 and abs(math.fsum(terms)) <= SNAP * max(map(abs, terms))


def _distance(step: Transform, values: Mapping[str, float]) -> float:
    return math.hypot(*(math.fsum(terms_in_numbers(entry, values)) for entry in step.translation))


def _links(
    joints: tuple[AxisJoint, ...], steps: list[Transform], still: Transform
) -> tuple[tuple[Element, ...], ...]:
    """The way from each frame to the next, then the joint."""
    links: list[tuple[Element, ...]] = []
    for number, (joint, step) in enumerate(zip(joints, steps, strict=True), start=1):
        move = Turn(number) if joint.kind is JointKind.REVOLUTE else Slide(number)
        links.append((move,) if step == still else (Fixed(step), move))
    return tuple(links)


def _frame_along(
    direction: list[Polynomial], ring: PolyRing, normal: NormalForm
) -> tuple[Rotation, int] | None:
    """A rotation whose z axis is the direction (up to a sign), when that is exact.

    Exact are the directions of length one with at least one component zero.
    """
    if normal(sum((c * c for c in direction), ring.zero)) != ring.one:
        return None
    sign = 1
    if direction.count(ring.zero) == 2 and -ring.one in direction:
        sign, direction = -1, [-component for component in direction]
    if direction[2] == ring.one:
        return identity(ring).rotation, sign
    for axis in (2, 1, 0):
        if direction[axis] != ring.zero:
            continue
        x = [ring.one if place == axis else ring.zero for place in range(3)]
        y = _cross(direction, x)
        return tuple(zip(x, y, direction, strict=True)), sign
    return None


def _cross(left: list[Polynomial], right: list[Polynomial]) -> list[Polynomial]:
    return [
        left[(k + 1) % 3] * right[(k + 2) % 3] - left[(k + 2) % 3] * right[(k + 1) % 3]
        for k in range(3)
    ]


def _nearest(
    rotation: Rotation, point: list[Polynomial], previous: tuple[Polynomial, ...]
) -> tuple[Polynomial, ...]:
    """The point of an axis level with the previous frame, where that needs no division.

    Sliding a frame along its own axis changes no pose; it makes neighbouring axes that meet
    share their point, wherever the file puts it (document 003, rules 2 and 3).
    """
    direction = [row[2] for row in rotation]
    one = point[0].ring.one
    return tuple(
        previous[place] if component in {one, -one} else point[place]
        for place, component in enumerate(direction)
    )
