"""How Python searches for the roots of a polynomial, for each kind of polynomial."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel


@dataclass(frozen=True, slots=True)
class Search:
    """How a polynomial is sampled.

    Attributes:
        kind: What the functions' names end with.
        what: The polynomial, in words.
        room: A line that makes room for its computation, or none.
        at: Its value where the cosine and sine are c and s.
    """

    kind: str
    what: str
    room: str
    at: str


@dataclass(frozen=True, slots=True)
class Searches:
    """The two kinds.

    Attributes:
        determinant: Of the equations of a formulation.
        closed: A polynomial in closed form.
    """

    determinant: Search
    closed: Search


def searches(kernel: GeneralKernel, name: str) -> Searches:
    """Both, for functions that begin with a name."""
    zero = f" / _{name}_nearness(c, s) ** {kernel.first.order}" if kernel.hides_a_slide else ""
    return Searches(
        Search(
            kind="",
            what="The determinant",
            room="    factor = np.empty((6, 6))\n",
            at=f"_{name}_fold(of, c, s, factor){zero}",
        ),
        Search(
            kind="_closed",
            what="The polynomial",
            room="",
            at=f"_{name}_closed_polynomial(of, c, s)",
        ),
    )
