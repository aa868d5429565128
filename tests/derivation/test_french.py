"""The French derivation: every sentence has a pair, and the formulas are those of the English."""

from __future__ import annotations

import ast
import re
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

import dhgen.derivation
from dhgen.derivation.document import document_blocks
from dhgen.derivation.figures.all import figures_of
from dhgen.derivation.formats import derivation_as
from dhgen.derivation.french import sentences as french_sentences
from dhgen.derivation.french.catalogue import HOLE, Pair, catalogue
from dhgen.derivation.french.language import French
from dhgen.derivation.french.sentences import french, sentences
from dhgen.derivation.text.blocks import Drawing, say
from dhgen.derivation.text.formula import Symbol
from dhgen.printing.templates import template_folder
from tests.derivation.markdown_text import MARK, texts
from tests.derivation.stories import GENERATED, NAMES, WHOLE, document, story
from tests.derivation.test_handouts import ENGINES, compiled
from tests.structures import first_of

if TYPE_CHECKING:
    from collections.abc import Iterator


DOCS = GENERATED.parent / "docs/fr"
WRITTEN = sorted({path.stem for path in DOCS.glob("*.md")} - {"README"})
PACKAGE = Path(dhgen.derivation.__file__).parent
# What letters mean that the file of a robot has no name for.
MEANINGS = [
    PACKAGE.parent / "kinematics" / f"{name}.py"
    for name in ("axes", "build", "constants", "transform")
]
COMMITTED = sorted(path.stem for path in GENERATED.glob("*.md"))
SHORT = 6  # letters: too few to tell one sentence from another
GAP = " □ "  # where a sentence has a formula or anything else that varies


def in_french(name: str) -> str:
    """The Markdown."""
    return derivation_as("markdown", story(name), f"robots/{name}.yaml", French())[0]


@pytest.mark.parametrize("name", COMMITTED)
def test_every_sentence_of_every_arm_has_its_french(name: str) -> None:
    lacking = [
        sentence
        for text in texts(document(name))
        if french(text) is None
        for sentence in sentences(text)
        if french(sentence) is None
    ]
    assert not lacking


@pytest.mark.parametrize("name", first_of([*NAMES, *WHOLE], count=4))
def test_nothing_stays_english(name: str) -> None:
    """Of the blocks and figures themselves, with what the user wrote in its places."""
    language, of = French(), story(name)
    figures = figures_of(of)
    for block in document_blocks(of, figures):
        language.block(block)
    for figure in figures:
        language.figure(figure)
    assert language.missing == []


@pytest.mark.parametrize("name", WRITTEN)
def test_committed_french_is_that_of_the_committed_english(name: str) -> None:
    """`docs/fr` against `generated`: block by block, without making either."""
    english, written = document(name), (DOCS / f"{name}.md").read_text(encoding="utf-8")
    told = list(texts(written, ("articulation", "nom")))
    expected = [french(text) or text for text in texts(english)]
    for one, other in zip(expected, told, strict=True):
        pattern, text = (" ".join(each.split()) for each in (one, other))
        either = re.escape(pattern).replace(rf",\ {MARK}", rf"(?:,|\ ;)\ {MARK}")  # with decimals
        assert re.fullmatch(either.replace(MARK, ".+?"), text), (one, other)
    assert formulas_of(written, undo=True) == formulas_of(english, undo=False)
    tree = re.compile(r"```text\n(.*?)\n```", re.DOTALL)
    drawn = [French().block(Drawing(each)) for each in tree.findall(english)]
    assert drawn == [Drawing(each) for each in tree.findall(written)]


@pytest.mark.parametrize("name", WRITTEN)
def test_committed_french_figures_are_the_english_ones_but_for_their_words(name: str) -> None:
    words = re.compile("<(?:text|title|desc|!--).*\n")
    paths = sorted((DOCS / "figures").glob(f"{name}_*_fr.svg"))
    assert paths
    for path in paths:
        other = GENERATED / "figures" / path.name.replace("_fr.svg", ".svg")
        here, there = (each.read_text(encoding="utf-8") for each in (path, other))
        if path.stem.removesuffix("_fr") in {
            f"{name}_arm",
            f"{name}_postures",
            f"{name}_workspace",
        }:
            assert words.sub("", here) == words.sub("", there)


UNDONE = (
    (r"\{,\}", "."),
    (r" \\thinspace ;(?=\\quad )", ","),
    (r"\{\}\^(\d)([TR]_(?:\{[^{}]*\}|\w))", r"\2^\1"),
    (r"base,outil", "base,tool"),
    (r"\\mathrm\{init\}", r"\\mathrm{seed}"),
    (r"\\text\{et\}", r"\\text{and}"),
    (r"\\,;\\ ", ", "),
)


def formulas_of(text: str, *, undo: bool) -> tuple[list[str], Counter[str]]:
    """Formulas on lines of their own, and those in sentences; French ones as English has them."""
    for before, after in UNDONE if undo else ():
        text = re.sub(before, after, text)
    displayed = re.findall(r"```math\n(.*?)\n```", text, re.DOTALL)
    prose = re.sub(r"```.*?```", "", text, flags=re.DOTALL)
    return displayed, Counter(re.findall(r"\$`?([^$`]+)`?\$", prose))


@pytest.mark.parametrize("name", first_of([*NAMES, *WHOLE], count=4))
def test_its_formulas_are_those_of_the_english(name: str) -> None:
    """Which other tests evaluate: none is lost, none stands twice, and none has another number."""
    told = formulas_of(in_french(name), undo=True)
    assert told == formulas_of(document(name), undo=False)
    assert len(told[0]) > 5


@pytest.mark.slow
@pytest.mark.parametrize("engine", first_of(["pdflatex", "xelatex"]))
def test_latex_compiles_without_a_warning(engine: str, tmp_path: Path) -> None:
    if engine not in ENGINES:
        pytest.skip(f"no {engine}")
    text = derivation_as("latex", story("scara"), "x.yaml", French())[0]
    log = compiled(engine, text, tmp_path)
    assert re.findall(r"^(?:Overfull|LaTeX Warning|Missing character).*", log, re.MULTILINE) == []


def test_html_has_commas_inside_of_its_numbers() -> None:
    text = derivation_as("html", story("scara"), "x.yaml", French())[0]
    assert '<html lang="fr">' in text
    assert re.search(r"<mn>\d+,\d+</mn>", text)
    assert not re.search(r"<mn>\d+\.\d+</mn>|(?<!</mrow>)<mn>\d+</mn><mrow><mo>&#x0002C;", text)


def test_a_tree_of_roots_keeps_its_columns() -> None:
    """Racine is longer than root: all lines move behind it, not those with a root alone."""
    english = "┌ root 1 ─ θ₁ ─┬   row 0\n│              └   row 1  up\n└ root 2 ─ θ₁ ─┬   row 2"
    block = French().block(Drawing(english))
    assert isinstance(block, Drawing)
    one, other, _ = block.text.split("\n")
    assert one == "┌ racine 1 ─ θ₁ ─┬  ligne 0"
    assert other.endswith("└  ligne 1 up")
    assert one.index("┬") == other.index("└")


def test_a_sentence_without_french_stays_and_is_noted() -> None:
    language = French()
    prose = say("There is always a solution. Nobody says {} here.", Symbol("x", "x"))
    written = language.prose(prose)
    assert written.text == "Il y a toujours une solution. Nobody says {} here."
    assert language.untranslated == ["Nobody says … here."]


def test_articles_and_what_precedes_them_are_joined() -> None:
    assert french("the velocity of the wrist centre along x") is None
    told = french(f"the velocity of the wrist centre along {MARK}")
    assert told == f"la vitesse du centre du poignet le long de {MARK}"
    told = french(f"What the tool reaches, seen from above. The arm at {MARK}.")
    assert told == f"Ce qu’atteint l’outil, vu de dessus. Le bras en {MARK}."


def test_a_catalogue_is_french() -> None:
    """Signs have a space before them that ends no line, and both languages end alike."""
    english = re.compile(r"\b(?:the|and|of|is|are|which)\b")
    for pair in catalogue():
        words = HOLE.sub("", pair.french)
        assert not re.search(r"(?<![\u00a0])[:;?!»](?!\w)", words), pair
        assert "'" not in words, pair
        assert not english.search(re.sub(r"\(.*\)", "", words)), pair
        assert pair.english[-1] == pair.french[-1] or pair.english[-1] not in ".:,", pair


def test_no_sentence_has_two_pairs() -> None:
    twice = [
        english for english, n in Counter(pair.english for pair in catalogue()).items() if n > 1
    ]
    assert not twice


# What is in the sources and no part of a document: other formats, styles, messages of faults.
APART = (
    r"HTML needs|blocks stand in paragraphs|^By what is placed|borders are closed|det J|g × z|"
    r"square root of|"
    r"no arm with passive|^base (west|east)$|^i t[nzx]$|the derivation of its inverse|"
    r"Generated from|Do not edit|^and templates|\\|=|→|′|the plane across the axes|"
    r"the closed form of an arm within|and Newton steps"
)


def chunks() -> Iterator[str]:
    """What the sections and templates say, in pieces between formulas and ends of sentences."""
    for text in [*written_in_sections(), *written_in_templates()]:
        bare = " ".join(re.sub(r"\{\w*\}", GAP, text).split())
        for piece in re.split(r"□|(?<=[.!?:]) (?=[A-Z0-9])|; ", bare):
            words = piece.strip(' ,.:;()*"`')
            if len(re.findall(r"[A-Za-z'-]+(?= |$)", words)) > 1 and not re.search(APART, words):
                yield words


def written_in_sections() -> Iterator[str]:
    for path in [*PACKAGE.rglob("*.py"), *MEANINGS]:
        if path.parent.name == "french" or path.name in {"languages.py", "summary.py"}:
            continue
        tree = ast.parse(path.read_text(encoding="utf-8"))
        told = [node for node in ast.walk(tree) if not isinstance(node, ast.Expr)]
        said = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
        formatted = [node for node in told if isinstance(node, ast.JoinedStr)]
        said |= {id(part) for each in formatted for part in each.values}
        for each in formatted:
            yield "".join(
                str(part.value) if isinstance(part, ast.Constant) else GAP for part in each.values
            )
        for node in told:
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                yield from () if id(node) in said else (node.value,)


def written_in_templates() -> Iterator[str]:
    for path in (template_folder() / "derivation").glob("*.md.jinja"):
        text = re.sub(r"\{#.*?#\}", "", path.read_text(encoding="utf-8"), flags=re.DOTALL)
        text = re.sub(r"```.*?```|\{\{.*?\}\}|\{%.*?%\}|\$[^$]*\$", GAP, text, flags=re.DOTALL)
        yield from re.split(r"\n\s*\n|\*\*|##", text)


def test_what_no_committed_arm_says_has_its_french_too() -> None:
    english = [" ".join(HOLE.sub(GAP, pair.english).split()) for pair in catalogue()]
    known = "\n".join(english).replace("axis □ ", "axis 1")
    lacking = {chunk for chunk in chunks() if chunk not in known}
    assert not lacking


def test_every_pair_is_of_a_sentence_that_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    """By a committed derivation or, for some words, in the sources."""
    filled, used = french_sentences.filled, set()

    def noted(pair: Pair, found: re.Match[str]) -> str | None:
        used.add(pair.place)
        return filled(pair, found)

    monkeypatch.setattr(french_sentences, "filled", noted)
    french.cache_clear()
    for name in COMMITTED:
        assert all(map(french, texts(document(name))))
    said = {chunk for chunk in chunks() if len(chunk) > SHORT}
    for pair in catalogue():
        if pair.place in used:
            continue
        words = " ".join(HOLE.sub(GAP, pair.english).split())
        is_short = sum(map(str.isalpha, words)) < 2.5 * SHORT
        assert is_short or any(chunk in words for chunk in said), pair
