"""Letters in the order in which their values become known."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.text.formula import Symbol
from dhgen.derivation.text.walk import symbols_in

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.derivation.text.formula import Relation


def in_order(relations: Iterable[Relation]) -> list[Relation]:
    """Without a definition that a later one of the same letter replaces.

    A later one replaces it that uses letters that are defined in between: the angle of two
    equations added, whose letters come after the angle of the first alone.
    """
    kept: list[Relation] = []
    for each in relations:
        name = each.sides[0]
        places = [place for place, other in enumerate(kept) if other.sides[0] == name]
        if places and isinstance(name, Symbol):
            between = {other.sides[0] for other in kept[places[0] + 1 :]}
            if (between & {*symbols_in(each)}) - {name}:
                kept = [other for other in kept if other.sides[0] != name]
        kept.append(each)
    return kept
