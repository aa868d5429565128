"""The languages of a derivation: it is made in English, and others are made of the finished one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from dhgen.derivation.figures.figure import Figure
    from dhgen.derivation.text.blocks import Block


class Language(Protocol):
    """What becomes of a finished derivation in a language."""

    @property
    def code(self) -> str:
        """Its name in HTML."""
        ...

    def block(self, block: Block) -> Block:
        """A block of the English derivation in this language."""
        ...

    def figure(self, figure: Figure) -> Figure:
        """An English figure in this language."""
        ...


@dataclass(frozen=True, slots=True)
class English:
    """English, in which derivations are made."""

    @property
    def code(self) -> str:
        """Its name in HTML."""
        return "en"

    def block(self, block: Block) -> Block:
        """The block itself."""
        return block

    def figure(self, figure: Figure) -> Figure:
        """The figure itself."""
        return figure


ENGLISH = English()
