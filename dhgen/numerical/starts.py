"""Starts that fill the joint space evenly, without a random state."""

from __future__ import annotations

STEPS = 60  # of the fixed point iteration; each wins a digit in base two at least


def directions(dimension: int) -> tuple[float, ...]:
    """What is added, modulo one, from start to start: the powers of 1 / x with x^(n+1) = x + 1.

    M. Roberts, The unreasonable effectiveness of quasirandom sequences (2018): for one dimension
    the golden ratio, for more its generalisation.
    """
    ratio = 2.0
    for _ in range(STEPS):
        ratio = _root(1.0 + ratio, dimension + 1)
    powers, power = [], 1.0
    for _ in range(dimension):
        power /= ratio
        powers.append(power)
    return tuple(powers)


def _root(value: float, degree: int) -> float:
    """The root of a degree by Newton's method: a library's own may round differently elsewhere."""
    x = value
    for _ in range(STEPS * degree):
        power = 1.0
        for _ in range(degree - 1):
            power *= x
        x -= (x * power - value) / (degree * power)
    return x
