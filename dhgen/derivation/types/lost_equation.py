"""Where an equation in one angle loses it, as geometry: a point or an axis lies along another axis.

What holds of all drawn poses in which that is so is named.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.text.blocks import Given, say
from dhgen.derivation.velocity.lost import point_name
from dhgen.kinematics.algebra import POSE_PLACES
from dhgen.kinematics.chain import Turn
from dhgen.kinematics.product import product, reversed_elements
from dhgen.kinematics.ring import terms_in_numbers
from dhgen.kinematics.transform import identity

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from dhgen.arrays import FloatArray
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Prose
    from dhgen.kinematics.constants import Polynomial

DRAWN = 3
PLACES = 300  # among which some are within reach and others are not
NONE = 1e-9  # a sum, of the sizes of its terms
Line = tuple["FloatArray", "FloatArray"]  # a point and a direction


def lost_where(
    story: Story, joint: int, forms: Sequence[Polynomial], rest: Sequence[Polynomial]
) -> Prose | None:
    """Where two equations lose a joint's angle; None where no name for that is known.

    Args:
        story: The derivation.
        joint: Which: the first or the last.
        forms: What its cosine and sine are multiplied by.
        rest: P, Q and R of both without these, where P c + Q s + R = 0 with another angle.
    """
    links = story.derivation.problem.links
    if links[0][0] != Turn(1, 1) or joint not in {1, story.dof}:
        return None
    draw = np.random.default_rng(7)
    for name, poses in _candidates(story, joint):
        values = [_letters(story, poses(draw)) for _ in range(DRAWN)]
        if all(_is_none(form, each) for each in values for form in forms):
            places = (_letters(story, poses(draw)) for _ in range(PLACES))
            return name if len({_is_outside(rest, each) for each in places}) == 2 else None
    return None


def _is_outside(rest: Sequence[Polynomial], letters: dict[str, float]) -> bool:
    """Whether no angle meets both equations: those of lines that cross outside the unit circle."""
    p1, q1, r1, p2, q2, r2 = (_worth(form, letters) for form in rest)
    across = (q1 * r2 - q2 * r1) ** 2 + (r1 * p2 - r2 * p1) ** 2
    return across > (p1 * q2 - q1 * p2) ** 2


def _worth(form: Polynomial, letters: dict[str, float]) -> float:
    used = {symbol.name: letters.get(symbol.name, math.nan) for symbol in form.ring.symbols}
    return math.fsum(terms_in_numbers(form, used))


def _candidates(
    story: Story, joint: int
) -> Iterator[tuple[Prose, Callable[[np.random.Generator], FloatArray]]]:
    """What may lie along axis 1, the z axis of the frame of U_0, and poses in which it does."""
    zero, z = np.zeros(3), np.array([0.0, 0.0, 1.0])
    size = story.algebra.chain.size
    kept = story.derivation.problem.tool_left == identity(story.algebra.ring)  # U_0 has the tool
    if joint == 1:
        if kept:
            yield (
                say("{} lies on axis 1", point_name(story, story.dof + 1)),
                lambda draw: _pose(draw, (zero, z), size, turns=True),
            )
        for point in story.derivation.pool.points:
            place = _numbers(story, point.in_tool)
            named = point_name(story, story.frame_of(point))
            yield (
                say("{} lies on axis 1", named),
                lambda draw, at=place: _pose(draw, (at, z), size, turns=True),  # type: ignore[misc]
            )
        if kept:
            yield (
                say("the tool's z axis lies along axis 1"),
                lambda draw: _pose(draw, (zero, z), size),
            )
        return
    last = story.derivation.problem.links[-1]
    turn = next(k for k, element in enumerate(last) if isinstance(element, Turn))
    back = product(reversed_elements(last[turn + 1 :], story.algebra), story.algebra)
    line = _numbers(story, back.translation), _numbers(story, back.column(2))
    axis = Given(str(joint))
    yield (
        say("axis {} is parallel to axis 1", axis),
        lambda draw: _pose(draw, line, size, moves=True),
    )
    yield say("axis {} lies along axis 1", axis), lambda draw: _pose(draw, line, size)


def _pose(
    draw: np.random.Generator, line: Line, size: float, *, turns: bool = False, moves: bool = False
) -> FloatArray:
    """A pose that puts a line of the tool along the z axis; it may lean, or be anywhere."""
    point, direction = line
    Q, _ = np.linalg.qr(np.column_stack([direction, draw.normal(size=(3, 2))]))
    Q[:, 0] = direction
    Q[:, 2] = np.cross(Q[:, 0], Q[:, 1])
    angle, up = draw.uniform(-math.pi, math.pi), draw.choice([-1.0, 1.0])
    c, s = math.cos(angle), math.sin(angle)
    R = np.array([[0.0, c, -s * up], [0.0, s, c * up], [up, 0.0, 0.0]]) @ Q.T
    if turns:
        R, _ = np.linalg.qr(draw.normal(size=(3, 3)))
        R *= np.linalg.det(R)
    away = size * draw.normal(size=3) * ([1.0, 1.0, 1.0] if moves else [0.0, 0.0, 1.0])
    return np.column_stack([R, away - R @ point])


def _letters(story: Story, pose: FloatArray) -> dict[str, float]:
    """What the entries of the pose and the coordinates of named points are worth."""
    found = {name: float(pose[place]) for name, place in POSE_PLACES.items()}
    found |= {each.name: each.value for each in story.algebra.chain.constants}
    pool, R = story.derivation.pool, pose[:, :3]
    for point in pool.points:
        at = R @ _numbers(story, point.in_tool) + pose[:, 3]
        found |= dict(zip(point.names, at.tolist(), strict=True))
    for other in pool.base_points:
        at = R.T @ (_numbers(story, other.in_base) - pose[:, 3])
        found |= dict(zip(other.names, at.tolist(), strict=True))
    return found


def _numbers(story: Story, vector: Sequence[Polynomial]) -> FloatArray:
    values = {each.name: each.value for each in story.algebra.chain.constants}
    return np.array([math.fsum(terms_in_numbers(entry, values)) for entry in vector])


def _is_none(form: Polynomial, letters: dict[str, float]) -> bool:
    used = {symbol.name: letters.get(symbol.name, math.nan) for symbol in form.ring.symbols}
    terms = terms_in_numbers(form, used)
    return abs(sum(terms)) <= NONE * sum(map(abs, terms))
