"""Whether polynomials have a factor in common, seen in images of one letter.

Most have none, and a greatest common divisor in all letters takes five times as long to find that.
"""

from __future__ import annotations

from functools import reduce
from typing import TYPE_CHECKING

from sympy.polys.domains import ZZ
from sympy.polys.galoistools import gf_gcd, gf_trunc

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.kinematics.constants import Polynomial

PRIME = 2**61 - 1
FACTOR = 48271  # its powers replace letters


def have_nothing_in_common(polynomials: Sequence[Polynomial]) -> bool:
    """Whether it is certain that only numbers divide all of them, of which none is zero."""
    first = polynomials[0]
    shared = [
        letter
        for letter in range(first.ring.ngens)
        if all(each.degree(letter) > 0 for each in polynomials)
    ]
    whole = [each.clear_denoms()[1] for each in polynomials]
    return all(_is_in_no_factor(letter, whole) for letter in shared)


def _is_in_no_factor(letter: int, whole: Sequence[Polynomial]) -> bool:
    """Whether no common factor has this letter, as numbers in place of all others show.

    A factor's image divides all images, and is of the same degree unless the coefficient of the
    highest power in the polynomials vanishes.
    """
    images = [_image(each, letter) for each in whole]
    if len(images[0]) <= whole[0].degree(letter):
        return False
    common = reduce(lambda one, other: gf_gcd(one, other, PRIME, ZZ), images)
    return len(common) == 1


def _image(whole: Polynomial, letter: int) -> list[int]:
    """The coefficients of powers of a letter modulo the prime, the highest first."""
    degree = whole.degree(letter)
    found = [0] * (degree + 1)
    for powers, coefficient in whole.terms():
        value = int(coefficient)
        for place, power in enumerate(powers, start=1):
            if power and place != letter + 1:
                value = value * pow(FACTOR, place * power, PRIME) % PRIME
        found[degree - powers[letter]] += value
    image: list[int] = gf_trunc([ZZ(each) for each in found], PRIME)
    return image
