"""A template's Markdown becomes the blocks that it shows."""

from __future__ import annotations

import pytest

from dhgen.derivation.text.blocks import Display, Given, Heading, Paragraph, Prose, paragraph, say
from dhgen.derivation.text.formula import ZERO, Symbol, equal
from dhgen.derivation.text.markdown import markdown
from dhgen.derivation.text.template import Places

X, PHI = Symbol("x", "x"), Symbol(r"\varphi", "φ")


def test_headings_leads_and_paragraphs() -> None:
    places = Places()
    phi, name = places.of(PHI), places.of(Given("a*b"))
    text = f"## Of {name}\n\n**1. First.** Angles\n  like {phi} and\n$x$ stand.\n\nNo more.\n"
    assert list(places.read(text)) == [
        Heading(2, say("Of {}", Given("a*b"))),
        Paragraph(say("Angles like {} and {} stand.", PHI, X), lead=say("1. First.")),
        paragraph("No more."),
    ]


def test_fences_hold_places_or_both_spellings() -> None:
    places = Places()
    first, second = (places.of(equal(each, ZERO)) for each in (X, PHI))
    text = (
        f"Then\n\n```math\n{first}\n{second}\n```\n\nand\n\n"
        "```math\n\\frac{a}{b}, % a / b,\n\\cos\\varphi\n% cos φ\n```\n"
    )
    assert list(places.read(text)) == [
        paragraph("Then"),
        Display((equal(X, ZERO), equal(PHI, ZERO))),
        paragraph("and"),
        Display((Symbol(r"\frac{a}{b},", "a / b,"), Symbol(r"\cos\varphi", "cos φ"))),
    ]


def test_a_letter_may_have_two_spellings() -> None:
    (block,) = Places().read("Turn by $\\varphi\n% φ$, not by $x$.\n")
    assert block == paragraph("Turn by {}, not by {}.", PHI, X)


def test_blocks_stand_by_themselves_and_only_there() -> None:
    places = Places()
    blocks, none = places.of([paragraph("One."), paragraph("Two.")]), places.of([])
    assert list(places.read(f"{blocks}\n\n{none}\n\nThree.\n")) == [
        paragraph(each) for each in ("One.", "Two.", "Three.")
    ]
    with pytest.raises(AssertionError, match="paragraphs of their own"):
        list(places.read(f"Blocks {blocks} in a sentence.\n"))


def test_prose_in_prose_is_printed_in_its_place() -> None:
    places = Places()
    outer = places.of(Prose("the angle {}", (PHI,)))
    (block,) = places.read(f"This is {outer}.\n")
    assert markdown(block) == r"This is the angle $\varphi$."
