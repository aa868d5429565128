"""Whether the determinant of the Jacobian is a product, asked on random lines modulo a prime.

In the tangents of half the angles, and times powers of 1 + t^2, it is a polynomial with letters for
lengths and twists. Were it a product, it would be one on every line through the space of these
tangents and with all values of the letters, with factors of the same degrees (D. Hilbert, 1892). So
it is none, but for factors in the letters alone, if no degree is common to what is found on some
lines. There the arithmetic is that of whole numbers modulo a prime of 127 bits: without rounding,
and with roots of 2 and 3.
"""

from __future__ import annotations

import random
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise
from typing import TYPE_CHECKING

from sympy.polys.domains import ZZ
from sympy.polys.galoistools import gf_add_mul, gf_ddf_zassenhaus, gf_div, gf_monic, gf_mul

from dhgen.derivation.velocity.posture import Posture

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.derivation.story import Story
    from dhgen.derivation.velocity.posture import Real

PRIME = 2**127 - 801  # leaves 23 when it is divided by 24: 2 and 3 have square roots
LINES = 16
MOST = 2  # powers of 1 + t^2 by which the determinant is a polynomial, for every angle

Line = dict[int, tuple[int, int]]


@lru_cache(maxsize=8)
def is_irreducible(story: Story) -> bool:
    """Whether it was found that no product of what moves is it; False where that is not known."""
    chain, source = story.algebra.chain, random.Random(2)  # noqa: S311 - places, no secrets
    known = _constants(story, source).keys() == {each.name for each in chain.constants}
    if not known or any(each.apart for each in chain.passive):
        return False
    degrees: set[int] = set()
    for _ in range(LINES):
        polynomial = _on_a_line(story, source)
        if polynomial is None:
            return False
        found = _degrees(polynomial)
        degrees = degrees & found if degrees else found
        if len(degrees) == 2:  # 0 and all
            return True
    return False


def _degrees(polynomial: list[int]) -> set[int]:
    """The degrees that factors of a polynomial, by descending powers, may have."""
    _, monic = gf_monic(polynomial, PRIME, ZZ)
    sums = {0}
    for part, degree in gf_ddf_zassenhaus(monic, PRIME, ZZ):
        for _ in range((len(part) - 1) // degree):
            sums |= {each + degree for each in sums}
    return sums | {len(polynomial) - 1}  # a double factor is in no part


def _on_a_line(story: Story, source: random.Random) -> list[int] | None:
    """The polynomial on a random line; None where rows and columns are not equally many."""
    chain = story.algebra.chain
    line = {joint.number: _pair(source) for joint in chain.joints}
    for joint in chain.free:
        line[joint] = line[joint][0], 0
    constants = _constants(story, source)
    turning = [each for each in line if each not in story.algebra.slides and line[each][1]]
    count = 2 * MOST * len(turning) + len(chain.joints) + 2
    values = []
    for x in range(count):
        rows = [list(map(_reduced, row)) for row in _posture(story, line, constants, x).jacobian()]
        named = [row for row in rows if any(row)]
        if len(named) != len(chain.solved):
            return None
        value = _determinant(named)
        for joint in turning:
            t = line[joint][0] + line[joint][1] * x
            value = value * pow(1 + t * t, MOST, PRIME) % PRIME
        values.append(value)
    polynomial = _through(values)
    if len(polynomial) in {0, count}:
        return None
    for joint in turning:
        a, b = line[joint]
        circle = [b * b % PRIME, 2 * a * b % PRIME, (1 + a * a) % PRIME]
        quotient, rest = gf_div(polynomial, circle, PRIME, ZZ)
        while not rest:
            polynomial = quotient
            quotient, rest = gf_div(polynomial, circle, PRIME, ZZ)
    return polynomial


def _pair(source: random.Random) -> tuple[int, int]:
    return source.randrange(2, PRIME - 1), source.randrange(2, PRIME - 1)


def _constants(story: Story, source: random.Random) -> dict[str, Real]:
    """Random values of lengths and twists."""
    found: dict[str, Real] = {}
    for each in story.algebra.chain.constants:
        if each.square is not None:
            found[each.name] = pow(_reduced(each.square), (PRIME + 1) // 4, PRIME)
        elif each.is_length:
            found[each.name] = source.randrange(2, PRIME - 1)
        elif each.cosine is not None:
            found[each.cosine], found[each.name] = _turn(source.randrange(2, PRIME - 1))
    return found


def _turn(t: int) -> tuple[int, int]:
    """A cosine and its sine: (1 - t^2) / (1 + t^2) and 2 t / (1 + t^2)."""
    below = pow(1 + t * t, -1, PRIME)
    return (1 - t * t) * below % PRIME, 2 * t * below % PRIME


def _posture(story: Story, line: Line, constants: Mapping[str, Real], x: int) -> Posture:
    """At a place of the line."""
    places = {joint: (a + b * x) % PRIME for joint, (a, b) in line.items()}
    turns = {j: _turn(t) for j, t in places.items() if j not in story.algebra.slides}
    return Posture(story, turns, places, constants)


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


def _through(values: list[int]) -> list[int]:
    """The polynomial with given values at 0, 1, 2 and so on, by Newton's differences."""
    left, below = list(values), [1]
    found: list[int] = []
    for k in range(len(values)):
        found = gf_add_mul(found, below, [left[0]] if left[0] else [], PRIME, ZZ)
        back = pow(k + 1, -1, PRIME)
        left = [(b - a) * back % PRIME for a, b in pairwise(left)]
        below = gf_mul(below, [1, -k % PRIME], PRIME, ZZ)
    return found
