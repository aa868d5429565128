"""The languages of a derivation: it is made in English, and others are made of the finished one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

if TYPE_CHECKING:
    from collections.abc import Sequence

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

    @property
    def untranslated(self) -> Sequence[str]:
        """The sentences without a translation, each once, with an ellipsis for every formula."""
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

    @property
    def untranslated(self) -> Sequence[str]:
        """None: all are English."""
        return ()


ENGLISH = English()


def language_of(code: str) -> Language:
    """The language of a derivation.

    Args:
        code: `en` or `fr`.
    """
    if code == ENGLISH.code:
        return ENGLISH
    from dhgen.derivation.french.language import French  # noqa: PLC0415  a catalogue, long to read

    return French()
