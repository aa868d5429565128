"""Which of the small functions and macros of lanes a robot's functions for regular poses call."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable

_CALLED = re.compile(r"\b(\w+)\(")


@dataclass(frozen=True, slots=True)
class Tools:
    """What they call, of what only some robots need.

    Attributes:
        spreads_truths: Truth values come to all lanes of poses.
        raises: Angles that may be -pi or below are moved by a whole turn.
        lowers: Angles that may be above pi are.
        centres: Angles that may be either are.
        low: Lower ends of limits are named.
        high: Upper ends are.
        beyond: Joints have two that are not alike.
        exceeds: Joints have two that are.
        grazes: Joints may be beyond by rounding.
    """

    spreads_truths: bool
    raises: bool
    lowers: bool
    centres: bool
    low: bool
    high: bool
    beyond: bool
    exceeds: bool
    grazes: bool

    @property
    def turns(self) -> bool:
        """Whether angles are moved by whole turns."""
        return self.raises or self.lowers or self.centres


def tools_of(lines: Iterable[str]) -> Tools:
    """The tools that the lines of functions call."""
    called = set(_CALLED.findall("\n".join(lines)))

    def either(name: str) -> bool:
        return not called.isdisjoint({name, f"{name}_four", f"{name}_wide"})

    return Tools(
        spreads_truths="where_wide" in called,
        raises=either("raised"),
        lowers=either("lowered"),
        centres=either("centred"),
        low=either("low") or either("beyond"),
        high=any(map(either, ("high", "beyond", "exceeds"))),
        beyond=either("beyond"),
        exceeds=either("exceeds"),
        grazes=either("grazes"),
    )
