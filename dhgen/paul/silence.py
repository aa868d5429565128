"""Steps of type 2 that may say nothing somewhere, beside steps that say the same everywhere."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.paul.kind import Kind
from dhgen.paul.witness import OWN_LENGTHS, VANISHING

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.step import Step, View


def without_needless_silence(steps: list[Step], view: View) -> list[Step]:
    """Without X s + Y c = Z whose X and Y may vanish where constant factors say the same.

    That is so where X or Y is zero in both, and where the equation is a multiple of the constant
    one, be it for another angle, by a factor that varies.
    """
    angles = [step for step in steps if step.kind is Kind.ANGLE]
    sure = [step for step in angles if all(map(view.is_constant, _factors(step)))]
    told = set(map(id, sure))
    doubtful = [step for step in angles if id(step) not in told]
    if not sure or not doubtful:
        return steps
    known = [_place(step, view) for step in sure]
    places, squares = (np.stack(each) for each in zip(*known, strict=True))
    silent = {
        id(step)
        for step in doubtful
        if any(_are_single(step, other) for other in sure)
        or _is_multiple(*_place(step, view), places, squares)
    }
    return [step for step in steps if id(step) not in silent]


def _factors(step: Step) -> tuple[Polynomial, Polynomial]:
    return step.coefficient("X"), step.coefficient("Y")


def _are_single(step: Step, other: Step) -> bool:
    """Whether both hold the sine or the cosine of one angle alone."""
    alone = not all(_factors(step)) and not all(_factors(other))
    return alone and step.unknowns == other.unknowns


def _is_multiple(
    place: FloatArray, square: FloatArray, places: FloatArray, squares: FloatArray
) -> bool:
    """Whether an equation of type 2 differs from one of others by a factor that varies.

    Then the solution is as far from the direction of (X, Y) in both, whatever their angles are.
    The others are in rows.
    """
    factors = (square / squares)[:, OWN_LENGTHS]
    varies = np.ptp(factors, axis=1) > VANISHING * np.max(factors, axis=1)
    same = np.max(np.abs(places - place), axis=1) <= VANISHING
    return bool(np.any(varies & same))


def _place(step: Step, view: View) -> tuple[FloatArray, FloatArray]:
    """(X c - Y s)^2 / (X^2 + Y^2), and its divisor, on the witnesses."""
    angle = step.angle
    algebra, on = view.knowledge.runs.algebra, view.witnesses.evaluate
    x, y = map(on, _factors(step))
    c, s = (on(algebra.generator(name)) for name in (angle.cosine, angle.sine))
    square = x * x + y * y
    return (x * c - y * s) ** 2 / square, square
