"""The polynomials of an example in numbers, and their roots."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.notation.names import letter, theta
from dhgen.derivation.text.blocks import display, joined, paragraph, say
from dhgen.derivation.text.formula import (
    ZERO,
    Listing,
    Power,
    Sum,
    Symbol,
    add,
    equal,
    minus,
    times,
)
from dhgen.derivation.types.circle import HALF
from dhgen.derivation.values import degrees, figures

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.arrays import FloatArray
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.algebra import AngleSum
    from dhgen.program.interpret import Polynomial

GREEK = (r"\lambda", "λ"), (r"\mu", "μ")
ORDINALS = ("first", "second", "third", "fourth")


def quartic_blocks(taken: Polynomial, row: int, angle: AngleSum) -> list[Block]:
    """The quartic of a step in a row: its coefficients, its roots, and which one the row takes.

    Args:
        taken: The polynomial of the program.
        row: The row, from 0.
        angle: What the step gives.
    """
    own = taken.coefficients[row]
    same = (taken.coefficients == own).all(axis=1)
    roots = np.unique(taken.root[same & ~np.isnan(taken.root)])
    tangents = np.tan(roots / 2.0)
    names = [(r"\lambda", "λ", "0"), *((*g, n) for n in "12" for g in GREEK)]
    size = float(np.abs(own).max())
    shown = [
        equal(letter(*name), figures(value, size))
        for name, value in zip(names, own.tolist(), strict=True)
    ]
    place = ORDINALS[int(np.searchsorted(roots, taken.root[row]))]
    return [
        paragraph("The coefficients of the polynomial in {} are", theta(angle)),
        display(Listing(tuple(shown))),
        paragraph("and the equation in {} is", HALF),
        display(equal(sum_of_powers(in_tangent(own), size), ZERO)),
        paragraph(
            f"Its real roots are {{}}, and with them {{}}. The row takes the {place}.",
            alternatives(HALF, [figures(float(each)) for each in tangents]),
            alternatives(theta(angle), [degrees(float(each)) for each in roots]),
        ),
    ]


def in_tangent(circle: FloatArray) -> list[float]:
    """The coefficients by descending powers of tan(x/2), from a0, a1, b1, a2, b2."""
    a0, a1, b1, a2, b2 = circle.tolist()
    return [a0 - a1 + a2, 2 * (b1 - 2 * b2), 2 * (a0 - 3 * a2), 2 * (b1 + 2 * b2), a0 + a1 + a2]


def sum_of_powers(coefficients: Sequence[float], size: float) -> Formula:
    """A polynomial in numbers by descending powers, without its zeros."""
    terms: list[Formula] = []
    for power, value in enumerate(reversed(coefficients)):
        shown = figures(abs(value), size)
        if shown.text != "0":
            factors = (Power(HALF, power),) if power > 1 else (HALF,) * power
            term = times(shown, *factors)
            terms.insert(0, minus(term) if value < 0 else term)
    return Sum(tuple(terms)) if terms[1:] else add(*terms)


def alternatives(name: Symbol, values: Iterable[Symbol]) -> Prose:
    """x = 1, 2 and 3."""
    first, *others = values
    return joined([say("{}", equal(name, first)), *(say("{}", each) for each in others)])
