"""Limits on the number of joints: products of more than that, written out, fill the memory."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.errors import UnsolvedError
from dhgen.kinematics.chain import parallel_groups

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain


MOST_DIRECTIONS = 20  # each of them doubles the products; axes beside parallel ones don't
MOST_GIVEN = 8


def demand_few_directions(chain: Chain) -> None:
    """Refuses chains whose products cannot be written out.

    Raises:
        UnsolvedError: The chain is one of them.
    """
    directions = len(parallel_groups(chain))
    if directions > MOST_DIRECTIONS:
        raise UnsolvedError(
            f"the axes of this arm change direction {directions - 1} times: its products would "
            f"fill the memory, those of up to {MOST_DIRECTIONS - 1} are written out\n"
            "solve a part of it, with the rest in `base` and `tool`"
        )


def demand_few_given(chain: Chain) -> None:
    """Refuses formulas in the values of too many joints.

    Raises:
        UnsolvedError: The caller gives too many.
    """
    if are_too_many_given(chain.given):
        raise UnsolvedError(
            f"up to {MOST_GIVEN} joints may be given: with the {chain.given} under `free`, the "
            "equations of the others would fill the memory\n"
            "solve for the joints after them, with these in `base`, or use --numerical"
        )


def are_too_many_given(count: int) -> bool:
    """Whether formulas in so many values that the caller gives would fill the memory."""
    return count > MOST_GIVEN
