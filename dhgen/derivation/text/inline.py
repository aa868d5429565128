"""Prose in one line, in any format: its words, users' texts and formulas, one after the other."""

from __future__ import annotations

from string import Formatter
from typing import TYPE_CHECKING

from dhgen.derivation.text.blocks import Given, Prose
from dhgen.derivation.text.formula import Listing

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator

    from dhgen.derivation.text.formula import Formula


def in_line(
    prose: Prose,
    words: Callable[[str], str],
    given: Callable[[str], str],
    formula: Callable[[Formula], str],
    link: Callable[[str, str], str] = lambda text, _: text,
) -> str:
    """Prose, its places filled.

    Args:
        prose: The words and what is in their places.
        words: Writes words of the derivation's own.
        given: Writes a text of the user, without line breaks.
        formula: Writes a formula; of several side by side each is one.
        link: Links a written text to a document, by its path.
    """

    def written(part: Formula | Given | Prose) -> str:
        match part:
            case Given(text, path):
                own = given(" ".join(text.split()))
                return link(own, path) if path else own
            case Prose():
                return "".join(pieces(part))
            case Listing(items, separator):
                return f"{separator} ".join(map(formula, items))
            case _:
                return formula(part)

    def pieces(that: Prose) -> Iterator[str]:
        parts = iter(that.parts)
        for text, place, _, _ in Formatter().parse(that.text):
            yield words(text)
            if place is not None:
                yield written(next(parts))

    return "".join(pieces(prose))
