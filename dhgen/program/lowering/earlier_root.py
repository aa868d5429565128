"""What later steps need to know of a square root."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhgen.program.building.graph import Node


@dataclass(frozen=True, slots=True)
class EarlierRoot:
    """A square root on whose sign later steps hang.

    Attributes:
        axis: The sign's place.
        share: Its value without sign, not zero, over what it is where lengths are the arm's size.
    """

    axis: int
    share: Node
