"""Polynomials where every generator has a value, several places at once."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import accumulate, chain
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.form import Exponents

    Numbers = tuple[float, ...]

FEW = 64  # monomials that there is room for at first


class Samples:
    """Values of every generator; no monomial, nor polynomial, is computed twice.

    Polynomials are known by their identity, as what makes a number of them, their hash, takes
    longer than most questions.

    Attributes:
        values: Shape (generators, places).
    """

    def __init__(self, values: FloatArray) -> None:
        self.values = values
        self._rows: dict[Exponents, int] = {}
        self._monomials = np.empty((FEW, values.shape[1]))
        self._found: dict[int, tuple[FloatArray, FloatArray]] = {}
        self._numbers: dict[int, tuple[Numbers, Numbers]] = {}
        self._known: list[Polynomial] = []  # kept, or others could get their identities
        self._nothing = np.zeros(values.shape[1]), np.zeros(values.shape[1])

    def value(self, polynomial: Polynomial) -> FloatArray:
        """The polynomial, shape (places,)."""
        return self.value_and_size(polynomial)[0]

    def value_and_size(self, polynomial: Polynomial) -> tuple[FloatArray, FloatArray]:
        """The polynomial and the sum of the sizes of its terms, each of shape (places,)."""
        if not polynomial:
            return self._nothing
        found = self._found.get(id(polynomial))
        if found is None:
            self.learn([polynomial])
            found = self._found[id(polynomial)]
        return found

    def numbers(self, polynomial: Polynomial) -> tuple[Numbers, Numbers]:
        """The values as plain numbers, with which Python is faster where places are few."""
        found = self._numbers.get(id(polynomial))
        if found is None:
            value, size = self.value_and_size(polynomial)
            found = tuple(value.tolist()), tuple(size.tolist())
            if polynomial:
                self._numbers[id(polynomial)] = found
        return found

    def learn(self, polynomials: Iterable[Polynomial]) -> None:
        """Works out many together: what one alone takes is mostly the toll of small arrays."""
        each_once = {id(each): each for each in polynomials if each}
        new = [each for key, each in each_once.items() if key not in self._found]
        if not new:
            return
        terms = self._terms(new)
        starts = _starts(new)
        sums = (np.add.reduceat(each, starts) for each in (terms, np.abs(terms)))
        self._found.update(zip(map(id, new), zip(*sums, strict=True), strict=True))
        self._known += new

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
            self._monomials[first : len(rows)] = _monomials(new)(self.values)
        return _factors(*polynomials) * self._monomials[[rows[each] for each in monomials]]


class Sums:
    """Polynomials made ready for values that are not known yet, and for others after them."""

    def __init__(self, polynomials: Iterable[Polynomial]) -> None:
        """Sorts their terms."""
        every = list(polynomials)
        sums = [each for each in every if each]
        monomials = list(chain.from_iterable(sums))
        rows = {each: row for row, each in enumerate(dict.fromkeys(monomials))}
        self._count = len(every)
        self._places = [place for place, each in enumerate(every) if each]
        self._starts = _starts(sums)
        self._factors = _factors(*sums)
        self._monomials = _monomials(list(rows))
        self._rows = [rows[each] for each in monomials]

    def __call__(self, values: FloatArray) -> FloatArray:
        """What they are.

        Args:
            values: Of every generator, (generators, places).

        Returns:
            Shape (polynomials, places).
        """
        found = np.zeros((self._count, values.shape[1]))
        if self._places:
            terms = self._factors * self._monomials(values)[self._rows]
            found[self._places] = np.add.reduceat(terms, self._starts)
        return found


def terms_on(polynomial: Polynomial, values: FloatArray) -> FloatArray:
    """Every term on every column of `values`, shape (terms, columns)."""
    return _factors(polynomial) * _monomials(list(polynomial))(values)


@dataclass(frozen=True, slots=True)
class _Monomials:
    """Monomials by the generators that occur in any of them.

    Attributes:
        used: These generators.
        exponents: Theirs in each monomial, shape (monomials, used).
        upto: 0, 1 ... the highest of them, shape (powers, 1, 1).
    """

    used: NDArray[np.intp]
    exponents: NDArray[np.uint8]
    upto: NDArray[np.intp]

    def __call__(self, values: FloatArray) -> FloatArray:
        """Every one on every column of `values`, shape (monomials, columns)."""
        powers = values[self.used] ** self.upto
        return np.asarray(powers[self.exponents, np.arange(len(self.used))].prod(axis=1))


def _monomials(monomials: Sequence[Exponents]) -> _Monomials:
    size = len(monomials[0]) if monomials else 0
    every = np.frombuffer(b"".join(map(bytes, monomials)), np.uint8).reshape(-1, size or 1)
    used = np.flatnonzero(every.any(axis=0))
    upto = np.arange(int(every.max(initial=0)) + 1)
    return _Monomials(used, every[:, used], upto[:, None, None])


def _starts(polynomials: Sequence[Polynomial]) -> list[int]:
    """Where the terms of each begin, of all terms in one row."""
    return [0, *accumulate(map(len, polynomials[:-1]))]


def _factors(*polynomials: Polynomial) -> FloatArray:
    """The coefficients, shape (terms, 1)."""
    numbers = [int(c.numerator) / int(c.denominator) for p in polynomials for c in p.values()]
    return np.array(numbers)[:, None]
