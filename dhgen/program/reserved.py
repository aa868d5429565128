"""Names that are kept for others: no value and no constant of a program gets one."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterable


@dataclass(frozen=True, slots=True)
class Reserved:
    """Names that are kept.

    Attributes:
        own: For the arm's numbers, and for what a program is given.
        values: For others, where values are written.
        constants: For others, where constants are written.
        numbered: The same as a pattern; empty for none.
    """

    own: frozenset[str] = frozenset()
    values: frozenset[str] = frozenset()
    constants: frozenset[str] = frozenset()
    numbered: str = ""

    def with_own(self, names: Iterable[str]) -> Reserved:
        """The reserved names and the names of an arm and a program."""
        return replace(self, own=frozenset(names))

    def is_kept_from_constants(self, name: str) -> bool:
        """Whether a constant has to be called otherwise, whichever arm it is of."""
        return name in self.constants or re.fullmatch(self.numbered, name) is not None


NOTHING = Reserved()
