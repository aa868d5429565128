"""Printed formulas as numbers: the letters of an arm at joint values, and what a formula is worth.

Numbers are Python's: sums and products in the order of the formula, the same on every machine.
"""

from __future__ import annotations

import math
from decimal import Decimal
from operator import truediv
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.known_functions import pose_by_joints
from dhgen.derivation.notation.names import ARM_SIZE, cosine, joint_symbol, letter, sine, theta
from dhgen.derivation.text.formula import (
    Call,
    Minus,
    Number,
    Power,
    Product,
    Quotient,
    Root,
    Size,
    Sum,
    Symbol,
)
from dhgen.kinematics.algebra import POSE_PLACES, SHOULDER_NAMES
from dhgen.kinematics.ring import terms_in_numbers

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from dhgen.arrays import FloatArray
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.constants import Polynomial

DIGITS = 5
LARGE = 6  # the power of ten from which on a number is written with it
SURE = 12  # digits that rounding leaves right: what is half way between two is so on every machine
NOTHING = 1e-13  # of the arm's size, or of one: rounding


def value_of(formula: Formula, letters: Mapping[str, float]) -> float:
    """What a formula is worth.

    Args:
        formula: The formula, of numbers.
        letters: The value of every letter, by its spelling in a terminal.

    Raises:
        KeyError: A letter has no value, or the formula is none of numbers.
    """
    match formula:
        case Symbol(text=text):
            return letters[text]
        case Number(value):
            return value.numerator / value.denominator
        case Minus(operand):
            return -value_of(operand, letters)
        case Sum(terms):
            return sum(value_of(term, letters) for term in terms)
        case Product(factors):
            return math.prod(value_of(factor, letters) for factor in factors)
        case Power(base, exponent) if exponent > 0:
            return math.prod([value_of(base, letters)] * exponent)
        case _:
            function, arguments = _applied(formula)
            return _FUNCTIONS[function](*(value_of(each, letters) for each in arguments))


def _applied(formula: Formula) -> tuple[str, tuple[Formula, ...]]:
    """A function and what it is of."""
    match formula:
        case Quotient(above, below):
            return "/", (above, below)
        case Root(operand):
            return "root", (operand,)
        case Size(operand):
            return "size", (operand,)
        case Call(function, arguments):
            return function, arguments
    raise KeyError(formula)


def _sign(x: float) -> float:
    return math.copysign(1.0, x)


def _root(x: float) -> float:
    return math.sqrt(max(x, 0.0))  # below zero by rounding


_FUNCTIONS: dict[str, Callable[..., float]] = {
    "/": truediv,
    "root": _root,
    "size": abs,
    "atan2": math.atan2,
    "sgn": _sign,
    "cos": math.cos,
    "sin": math.sin,
    "tan": math.tan,
}


def letters_at(story: Story, q: Sequence[float], T: FloatArray) -> dict[str, float]:
    """The value of every letter that steps may hold, by its spelling in a terminal.

    Args:
        story: The derivation.
        q: Joint values, as the caller sees them.
        T: Their pose, shape (4, 4).
    """
    known, letters = _of_joints(story, q)
    known |= {
        name: math.fsum(terms_in_numbers(polynomial, known))
        for name, polynomial in _of_the_pose(story).items()
    }
    letters |= {story.letters[name].text: value for name, value in known.items()}
    letters[ARM_SIZE.text] = float(f"{story.algebra.chain.size:.12g}")
    for row, column in POSE_PLACES.values():
        letters[letter("p", "p", f"{row + 1}{column + 1}").text] = float(T[row, column])
    return letters


def letters_of_joints(story: Story, q: Sequence[float]) -> dict[str, float]:
    """The letters of joints without letters that a pose gives."""
    known, letters = _of_joints(story, q)
    return letters | {story.letters[name].text: value for name, value in known.items()}


def _of_joints(story: Story, q: Sequence[float]) -> tuple[dict[str, float], dict[str, float]]:
    """The values of generators by their names, and of letters."""
    algebra = story.algebra
    inner = dict(enumerate(algebra.chain.drives.values(np.asarray(q)).tolist(), start=1))
    known = {constant.name: constant.value for constant in algebra.chain.constants}
    letters = {"π": math.pi, "π/2": math.pi / 2}
    for angle in algebra.angles:
        total = sum(sign * inner[joint] for joint, sign in angle.terms)
        known |= {angle.cosine: math.cos(total), angle.sine: math.sin(total)}
        letters |= {theta(angle).text: total}
        letters |= {cosine(angle).text: math.cos(total), sine(angle).text: math.sin(total)}
    known |= {name: inner[joint] for joint, name in algebra.slides.items()}
    letters |= {joint_symbol(place).text: value for place, value in enumerate(q, start=1)}
    return known, letters


def _of_the_pose(story: Story) -> dict[str, Polynomial]:
    """The entries of U_0, coordinates of named points and entries of B_0, by joints."""
    algebra, problem = story.algebra, story.derivation.problem
    found = pose_by_joints(story, {*POSE_PLACES, *algebra.coordinates})
    if algebra.chain.arm_angle:
        shoulder = problem.spans.product(0, 3)
        for row, entries in enumerate(SHOULDER_NAMES):
            found |= {name: shoulder.entry(row, place) for place, name in enumerate(entries)}
    return found


def signs_of_row(story: Story, row: int) -> dict[str, float]:
    """The branch signs of a row, from 0, by their spelling in a terminal."""
    signs: dict[str, float] = {}
    for axis in reversed(story.program.axes):
        row, chosen = divmod(row, axis.count)
        if axis.count == 2:
            signs[story.sign(axis).text] = -1.0 if chosen else 1.0
    return signs


def figures(value: float, size: float = 1.0) -> Symbol:
    """A number to five digits, from a million on with a power of ten.

    What is rounding beside `size` is zero.
    """
    if abs(value) <= NOTHING * size:
        return Symbol("0", "0")
    exact = Decimal(f"{value:.{SURE}g}")
    rounded = round(exact, DIGITS - 1 - exact.adjusted())
    exponent = rounded.adjusted() if rounded.adjusted() >= LARGE else 0
    text = f"{rounded.scaleb(-exponent):f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    shown = Symbol(text, text.replace("-", "−"))
    if not exponent:
        return shown
    return Symbol(rf"{shown.latex} \cdot 10^{{{exponent}}}", f"{shown.text}e{exponent}")


def degrees(value: float) -> Symbol:
    """An angle in degrees, to five digits."""
    shown = figures(math.degrees(value), 100.0)
    return Symbol(rf"{shown.latex}^\circ", f"{shown.text}°")


def joint_value(story: Story, joint: int, value: float) -> Symbol:
    """A joint value, as an angle or a length."""
    if joint in story.algebra.slides:
        return figures(value, story.algebra.chain.size)
    return degrees(value)
