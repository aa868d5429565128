"""How the angles of a table follow from those whose cosines and sines have letters."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import letter, reference_angle
from dhgen.derivation.text.blocks import joined, paragraph, say
from dhgen.derivation.text.formula import Symbol, equal, minus, subtract
from dhgen.derivation.text.walk import symbols_in
from dhgen.kinematics.constants import TURN_TOLERANCE
from dhgen.kinematics.expressions import multiple_of_pi
from dhgen.robot.expression import evaluate
from dhgen.robot.robot import DhTable, JointKind

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block
    from dhgen.derivation.text.formula import Formula, Relation
    from dhgen.robot.expression import Expression

PI = Symbol(r"\pi", "π")
PI_HALF = Symbol(r"\pi/2", "π/2")


def reference_angles(story: Story) -> list[Block]:
    """A sentence with the angles of the table that are not those of the letters."""
    found = list(_relations(story))
    if not found:
        return []
    shown = joined([say("{}", each) for each in found])
    if any("^" in side.text for each in found for side in symbols_in(each)):
        return [paragraph("A hat marks an angle between 0 and {}: {}.", PI_HALF, shown)]
    return [paragraph("Angles of one size share its letters: {}.", shown)]


def _relations(story: Story) -> Iterator[Relation]:
    """α_3 = π - α_3^ and such, in the order of the table."""
    constants = story.algebra.chain.constants
    pairs = {
        math.atan2(sine.value, cosine.value): reference_angle(sine, constants)
        for sine in constants
        for cosine in constants
        if sine.cosine == cosine.name
    }
    for symbol, cell in _angles(story):
        turns = multiple_of_pi(cell)
        if turns is not None and (turns * 12).denominator == 1:
            continue
        values = {each.name: each.value for each in story.robot.parameters}
        angle = math.remainder(evaluate(cell, values), 2.0 * math.pi)
        size = min(abs(angle), math.pi - abs(angle))
        near = (of for value, of in pairs.items() if abs(value - size) < 2 * TURN_TOLERANCE)
        reference = next(near, None)
        if reference is not None and reference != symbol:
            yield equal(symbol, _turned(angle, reference))


def _turned(angle: float, reference: Symbol) -> Formula:
    """An angle by the one between 0 and pi/2."""
    folded = abs(angle) > math.pi / 2
    if angle >= 0.0:
        return subtract(PI, reference) if folded else reference
    return subtract(reference, PI) if folded else minus(reference)


def _angles(story: Story) -> Iterator[tuple[Symbol, Expression]]:
    """The angles of the table that do not move, with their letters."""
    geometry = story.robot.geometry
    if not isinstance(geometry, DhTable):
        return
    for number, row in enumerate(geometry.rows, start=1):
        if row.kind is JointKind.PRISMATIC:
            yield letter(r"\theta", "θ", str(number)), row.theta
        yield letter(r"\alpha", "α", str(number)), row.alpha
