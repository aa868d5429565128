"""The course texts that a derivation cites by number: what they are, for a reader without them."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from dhgen.derivation.text.blocks import Given, Paragraph, Prose, paragraph
from dhgen.derivation.text.words import many

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.derivation.text.blocks import Block

TITLES = {
    "000": '"Modélisation d\'un robot manipulateur", on forward and inverse models',
    "001": '"Cinématique", on rotations and axes in the reference position',
    "002": '"Modélisation et commande des robots de manipulation" (Université des Frères Mentouri, '
    "Constantine), on Paul's method",
    "003": '"Modèle géométrique", on Denavit-Hartenberg tables and Paul\'s method',
    "004": "an inverse model worked out, without a title",
}
_CITED = re.compile(r"document (\d{3})\b")


def cited_documents(blocks: Iterable[Block]) -> list[Block]:
    """A paragraph on the documents that paragraphs cite; none where they cite none."""
    cited = sorted({number for text in _texts(blocks) for number in _CITED.findall(text)})
    known = [number for number in cited if number in TITLES]
    if not known:
        return []
    subject = f"{many('document', known).capitalize()}, cited here by number,"
    if not known[1:]:
        return [paragraph(f"{subject} is a course text in French: {TITLES[known[0]]}.")]
    titles = "; ".join(f"{number}: {TITLES[number]}" for number in known)
    return [paragraph(f"{subject} are course texts in French. {titles}.")]


def _texts(blocks: Iterable[Block]) -> Iterable[str]:
    for block in blocks:
        if isinstance(block, Paragraph):
            yield from _words(block.prose)
            yield from _words(block.lead) if block.lead else ()


def _words(prose: Prose) -> Iterable[str]:
    yield prose.text
    for part in prose.parts:
        if isinstance(part, Given):
            yield part.text
        elif isinstance(part, Prose):
            yield from _words(part)
