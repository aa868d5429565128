"""How Python eliminates: the reflections of many angles at once, and what functions are called."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Reflection:
    """Of the row with a column's number and those from `rest` on: it stays in the first only."""

    column: int
    rest: int


@dataclass(frozen=True, slots=True)
class Elimination:
    """The reflections in their order.

    Attributes:
        equations: Of the six equations, so that three are free of the last monomials.
        shifted: Of the same three, shifted, under those.
        last: Of what is left, six by six.
    """

    equations: tuple[Reflection, ...] = tuple(Reflection(k, k + 1) for k in range(3))
    shifted: tuple[Reflection, ...] = tuple(Reflection(k, 3) for k in range(3))
    last: tuple[Reflection, ...] = tuple(Reflection(k, k + 1) for k in range(5))


@dataclass(frozen=True, slots=True)
class Kinds:
    """What the names of functions end with, which are written for two kinds of polynomials.

    Attributes:
        determinant: Of the equations of a formulation.
        closed: In closed form.
    """

    determinant: str = ""
    closed: str = "_closed"
