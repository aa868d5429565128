"""The determinant of the Jacobian as a product of conditions of singular configurations.

It is a polynomial in cosines, sines, slides and lengths. That it is a monomial in lengths times a
product of conditions is tested at random places of the field of whole numbers modulo a prime of 127
bits, in which there is no rounding: two polynomials of degree d that differ agree at such a place
with a probability of d in that prime (J. T. Schwartz, 1980).
"""

from __future__ import annotations

import random
from dataclasses import dataclass
from fractions import Fraction
from itertools import product
from math import prod
from typing import TYPE_CHECKING

from dhgen.derivation.text.formula import (
    ZERO,
    Minus,
    Power,
    Relation,
    factors_of,
    number,
    times,
)
from dhgen.derivation.velocity.posture import Posture, exact_value
from dhgen.robot.task import Directions

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence

    from dhgen.derivation.step_context import Singularity
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.formula import Formula
    from dhgen.derivation.velocity.posture import Real

PRIME = 2**127 - 801  # leaves 23 when it is divided by 24: 2 and 3 have square roots
POWERS = 3  # exponents of factors are below this
SIMPLE = 64  # a number that may come before a product
MOST_ANGLES = 4  # cosines and sines of the arm's own, of which powers are tried
# In the places of lengths, so that their powers can be read off a product.
LENGTHS = (101, 103, 107, 109, 113, 127, 131, 137, 139, 149, 151, 157, 163, 167, 173, 179, 181, 191)


@dataclass(frozen=True, slots=True)
class Factor:
    """A condition as a factor.

    Attributes:
        formula: What vanishes.
        power: How often it is a factor.
        place: The first place where it is listed; None where no step has it as its condition.
        is_never_zero: Whether the numbers of the arm keep it from vanishing.
    """

    formula: Formula
    power: int
    place: Singularity | None
    is_never_zero: bool = False


@dataclass(frozen=True, slots=True)
class Determinant:
    """The determinant in factors.

    Attributes:
        constant: What does not move: a number and powers of lengths.
        factors: The conditions.
        rows: How many rows of the Jacobian are not zero, among those that the task names.
    """

    constant: Formula
    factors: tuple[Factor, ...]
    rows: int

    @property
    def formula(self) -> Formula:
        """All of it."""
        return times(self.constant, *(raised(f.formula, f.power) for f in self.factors))


def raised(formula: Formula, power: int) -> Formula:
    """A formula with an exponent that is not one."""
    return formula if power == 1 else Power(formula, power)


def determinant_of(story: Story, places: Sequence[Singularity]) -> Determinant | None:
    """The determinant of a square task's Jacobian; None where the conditions don't make it up."""
    chain = story.algebra.chain
    if chain.arm_angle or any(each.apart for each in chain.passive):
        return None  # coupled drives only add columns to others
    source = random.Random(2)  # noqa: S311 - places, no secrets
    names = [constant.name for constant in chain.constants if constant.is_length]
    lengths = dict(zip(names, LENGTHS, strict=False))
    if len(lengths) < len(names):
        return None
    first = drawn(story, lengths, source)
    named = _named_rows(first)
    if len(named) != len(chain.solved) or not _is_yaw_plain(first):
        return None
    candidates = _candidates(places)
    formulas = [formula for formula, _ in candidates]
    compared = [_values(drawn(story, first.constants, source), named, formulas) for _ in range(3)]
    powers = _powers(compared)
    if powers is None:
        return None
    left = _quotient(*_values(first, named, formulas), powers)
    constant = _monomial(left, lengths, _angles(first))
    others = {name: source.randrange(1, PRIME) for name in lengths}
    other = drawn(story, others, source)
    again = _quotient(*_values(other, named, formulas), powers)
    if constant is None or again != _at(constant, other.constants):
        return None
    found = zip(candidates, powers, strict=True)
    factors = tuple(Factor(formula, p, place) for (formula, place), p in found if p)
    return Determinant(_written(story, *constant), factors, len(named))


def drawn(story: Story, known: Mapping[str, Real], source: random.Random) -> Posture:
    """A random posture of an arm of which some constants are known, the lengths among them."""
    turns: dict[int, tuple[int, int]] = {}
    slides: dict[int, int] = {}
    for joint in story.algebra.chain.joints:
        if joint.number in story.algebra.slides:
            slides[joint.number] = source.randrange(2, PRIME - 1)
        else:
            turns[joint.number] = _turn(source)
    constants = dict(known)
    for constant in story.algebra.chain.constants:
        if constant.square is not None:
            constants.setdefault(constant.name, _root(constant.square))
        elif constant.cosine is not None and constant.name not in constants:
            constants[constant.cosine], constants[constant.name] = _turn(source)
    return Posture(story, turns, slides, constants)


def _turn(source: random.Random) -> tuple[int, int]:
    """A random cosine and its sine: (1 - t^2) / (1 + t^2) and 2 t / (1 + t^2)."""
    t = source.randrange(2, PRIME - 1)
    below = pow(1 + t * t, -1, PRIME)
    return (1 - t * t) * below % PRIME, 2 * t * below % PRIME


def _root(square: Fraction) -> int:
    """A square root of 2 or of 3."""
    return pow(_reduced(square), (PRIME + 1) // 4, PRIME)


def _is_yaw_plain(posture: Posture) -> bool:
    """Whether the tool's x axis is always level, where the task names the yaw."""
    if posture.story.algebra.chain.task.directions is not Directions.YAW:
        return True
    tool = posture.frames()[0][-1]
    return not _reduced(tool[2][0])


def _angles(posture: Posture) -> dict[str, int]:
    """The cosines and sines of the arm's own angles."""
    chain = posture.story.algebra.chain
    names = [c.name for c in chain.constants if not c.is_length and c.square is None]
    return {name: _reduced(posture.constants[name]) for name in names}


def _named_rows(posture: Posture) -> list[int]:
    """The rows of the Jacobian that are not zero for every posture."""
    return [place for place, row in enumerate(posture.jacobian()) if any(map(_reduced, row))]


def _candidates(places: Sequence[Singularity]) -> list[tuple[Formula, Singularity]]:
    """Conditions that are one formula in joints, each once."""
    found: dict[Formula, Singularity] = {}
    for place in places:
        joints = place.joints
        if isinstance(joints, Relation) and len(joints.sides) == 2 and joints.sides[1] == ZERO:
            for factor in factors_of(_unsigned(joints.sides[0])):
                found.setdefault(factor.base if isinstance(factor, Power) else factor, place)
    return list(found.items())


def _unsigned(formula: Formula) -> Formula:
    return formula.operand if isinstance(formula, Minus) else formula


def _values(posture: Posture, rows: list[int], formulas: list[Formula]) -> tuple[int, list[int]]:
    """The determinant, and what every formula is worth."""
    matrix, letters = posture.jacobian(), posture.letters()
    values = [_reduced(exact_value(formula, letters)) for formula in formulas]
    return _determinant([[_reduced(entry) for entry in matrix[row]] for row in rows]), values


def _reduced(value: Real) -> int:
    """A whole number or a fraction modulo the prime."""
    exact = Fraction(value)
    return exact.numerator * pow(exact.denominator, -1, PRIME) % PRIME


def _determinant(rows: list[list[int]]) -> int:
    """By elimination."""
    left, total = rows, 1
    for k in range(len(left)):
        pivot = next((i for i in range(k, len(left)) if left[i][k]), None)
        if pivot is None:
            return 0
        if pivot != k:
            left[k], left[pivot], total = left[pivot], left[k], -total
        total = total * left[k][k] % PRIME
        back = pow(left[k][k], -1, PRIME)
        for i in range(k + 1, len(left)):
            factor = left[i][k] * back % PRIME
            left[i] = [(a - factor * b) % PRIME for a, b in zip(left[i], left[k], strict=True)]
    return total % PRIME


def _powers(places: list[tuple[int, list[int]]]) -> tuple[int, ...] | None:
    """The exponents with which the determinant is a constant times the product."""
    if not all(value and all(forms) for value, forms in places):
        return None
    count = len(places[0][1])
    for powers in sorted(product(range(POWERS), repeat=count), key=lambda each: (sum(each), each)):
        if len({_quotient(*each, powers) for each in places}) == 1:
            return powers
    return None


def _quotient(value: int, forms: list[int], powers: tuple[int, ...]) -> int:
    below = prod(form**power for form, power in zip(forms, powers, strict=True))
    return int(value * pow(below, -1, PRIME) % PRIME)


def _monomial(
    value: int, lengths: Mapping[str, int], angles: Mapping[str, int]
) -> tuple[int, dict[str, int]] | None:
    """A value as a small whole number and powers of lengths, cosines and sines."""
    if len(angles) > MOST_ANGLES:
        return None
    for powers in product(range(POWERS), repeat=len(angles)):
        left = _quotient(value, list(angles.values()), powers)
        scale = left if left < PRIME // 2 else left - PRIME
        exponents = {**dict.fromkeys(lengths, 0), **dict(zip(angles, powers, strict=True))}
        for name, length in lengths.items():
            while scale % length == 0:
                scale //= length
                exponents[name] += 1
        if abs(scale) <= SIMPLE:
            return scale, exponents
    return None


def _at(constant: tuple[int, dict[str, int]], constants: Mapping[str, Real]) -> int:
    scale, exponents = constant
    powers = (_reduced(constants[name]) ** power for name, power in exponents.items())
    return int(scale * prod(powers) % PRIME)


def _written(story: Story, scale: int, exponents: Mapping[str, int]) -> Formula:
    letters = [(story.letters[name], power) for name, power in exponents.items() if power]
    return times(number(scale), *(raised(each, p) for each, p in letters))
