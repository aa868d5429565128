"""What is known of the arm beside its numbers: how it is solved, and how far it reaches."""

from __future__ import annotations

from dataclasses import dataclass
from math import isinf
from typing import TYPE_CHECKING

from dhgen.general.loop import out_of_reach

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel


@dataclass(frozen=True, slots=True)
class Arm:
    """An arm.

    Attributes:
        most: Solutions that it may have.
        closed: How many polynomials in closed form are tried.
        per_root: Solutions at one of their simple roots.
        per_double_root: And at a double one.
        eliminations: How many formulations with a determinant are tried after that.
        size: The length that is one in the loop.
        per_size: Its inverse.
        reach: The square of what is out of reach for all links in line; empty where nothing is.
        slides: Places of the loop's joints that slide.
    """

    most: int
    closed: int
    per_root: int
    per_double_root: int
    eliminations: int
    size: float
    per_size: float
    reach: str
    slides: tuple[int, ...]


def arm(kernel: GeneralKernel) -> Arm:
    """How an arm is solved."""
    loop, farthest = kernel.loop, out_of_reach(kernel.loop)
    per_root = kernel.closed[0].solutions_per_root if kernel.closed else 0
    return Arm(
        most=kernel.rows,
        closed=len(kernel.closed),
        per_root=per_root,
        per_double_root=2 * per_root,
        eliminations=len(kernel.eliminations),
        size=loop.size,
        per_size=1.0 / loop.size,
        reach="" if isinf(farthest) else repr(farthest),
        slides=loop.slides,
    )
