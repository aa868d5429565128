"""Polynomials where every generator has a value, several places at once."""

from __future__ import annotations

from itertools import accumulate, chain
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.form import Exponents

    Numbers = tuple[float, ...]

FEW = 64  # monomials that there is room for at first


class Samples:
    """Values of every generator; no monomial and no polynomial is worked out twice.

    Values of generators may come later, before they are asked for.

    Attributes:
        values: Shape (generators, places).
    """

    def __init__(self, values: FloatArray) -> None:
        self.values = values
        self._rows: dict[Exponents, int] = {}
        self._monomials = np.empty((FEW, values.shape[1]))
        self._found: dict[Polynomial, tuple[FloatArray, FloatArray]] = {}
        self._numbers: dict[Polynomial, tuple[Numbers, Numbers]] = {}
        self._nothing = np.zeros(values.shape[1]), np.zeros(values.shape[1])

    def value(self, polynomial: Polynomial) -> FloatArray:
        """The polynomial, shape (places,)."""
        return self.value_and_size(polynomial)[0]

    def value_and_size(self, polynomial: Polynomial) -> tuple[FloatArray, FloatArray]:
        """The polynomial and the sum of the sizes of its terms, each of shape (places,)."""
        if not polynomial:
            return self._nothing
        found = self._found.get(polynomial)
        if found is None:
            self.learn([polynomial])
            found = self._found[polynomial]
        return found

    def numbers(self, polynomial: Polynomial) -> tuple[Numbers, Numbers]:
        """The same as plain numbers, with which Python is faster where places are few."""
        found = self._numbers.get(polynomial)
        if found is None:
            value, size = self.value_and_size(polynomial)
            found = self._numbers[polynomial] = tuple(value.tolist()), tuple(size.tolist())
        return found

    def learn(self, polynomials: Iterable[Polynomial]) -> None:
        """Works out many together: what one alone takes is mostly the toll of small arrays."""
        new = [each for each in dict.fromkeys(polynomials) if each and each not in self._found]
        if not new:
            return
        terms = self._terms(new)
        starts = [0, *accumulate(map(len, new[:-1]))]
        sums = (np.add.reduceat(each, starts) for each in (terms, np.abs(terms)))
        self._found.update(zip(new, zip(*sums, strict=True), strict=True))

    def _terms(self, polynomials: Sequence[Polynomial]) -> FloatArray:
        """All terms of all of them, shape (terms, places)."""
        rows = self._rows
        monomials = list(chain.from_iterable(polynomials))
        new = [each for each in dict.fromkeys(monomials) if each not in rows]
        if new:
            first = len(rows)
            rows.update(zip(new, range(first, first + len(new)), strict=True))
            while len(rows) > len(self._monomials):
                self._monomials = np.concatenate([self._monomials, np.empty_like(self._monomials)])
            self._monomials[first : len(rows)] = monomials_on(new, self.values)
        return _factors(*polynomials) * self._monomials[[rows[each] for each in monomials]]


def terms_on(polynomial: Polynomial, values: FloatArray) -> FloatArray:
    """Every term on every column of `values`, shape (terms, columns)."""
    return _factors(polynomial) * monomials_on(list(polynomial), values)


def monomials_on(monomials: Sequence[Exponents], values: FloatArray) -> FloatArray:
    """Every monomial on every column of `values`, shape (monomials, columns)."""
    exponents = np.frombuffer(b"".join(map(bytes, monomials)), np.uint8).reshape(-1, len(values))
    used = np.flatnonzero(exponents.any(axis=0))
    highest = int(exponents.max(initial=0))
    powers = values[used] ** np.arange(highest + 1)[:, None, None]
    return np.asarray(powers[exponents[:, used], np.arange(len(used))].prod(axis=1))


def _factors(*polynomials: Polynomial) -> FloatArray:
    """The coefficients, shape (terms, 1)."""
    numbers = [int(c.numerator) / int(c.denominator) for p in polynomials for c in p.values()]
    return np.array(numbers)[:, None]
