"""The same of MathML, as it stands in a page."""

from __future__ import annotations

from html.parser import HTMLParser
from xml.etree import ElementTree as ET

from tests.derivation.reading import Node, Nodes, grouped, primed, spelt

VOID = {"meta", "img", "br"}  # have no end
SILENT = {"", "\u2061", "\u2062"}  # signs between a function or a factor and what follows
NOTHING: Node = ("id", "")  # what stands before a matrix: {}^0T_3
LETTERS = str.maketrans({"∘": "°", "−": "-"})


class Tree(HTMLParser):
    """A page as elements."""

    def __init__(self) -> None:
        super().__init__()
        self.builder = ET.TreeBuilder()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.builder.start(tag, {key: value or "" for key, value in attrs})
        if tag in VOID:
            self.builder.end(tag)

    def handle_endtag(self, tag: str) -> None:
        self.builder.end(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self.builder.end(tag)

    def handle_data(self, data: str) -> None:
        self.builder.data(data)


def elements(page: str) -> ET.Element:
    """The root of a page."""
    tree = Tree()
    tree.feed(page)
    return tree.builder.close()


def of_mathml(element: ET.Element) -> Nodes:
    """The nodes of what is inside an element."""
    return grouped([node for child in element for node in _of_tag(child)])


def _of_tag(element: ET.Element) -> Nodes:
    text = (element.text or "").strip().translate(LETTERS)
    match element.tag:
        case "mn":
            return [("num", float(text.replace(",", ".")))]
        case "mi" | "mtext":
            return [("id", text)] if text else []
        case "mo":
            return [] if text in SILENT else [("op", text)]
        case "mspace" if element.get("width") == "0.167em":  # between factors
            return []
        case "mspace":
            return [("space",)]
        case "mtable":
            return [("matrix", [[of_mathml(cell) for cell in row] for row in element])]
        case "mrow" if len(element) and all(child.get("mathvariant") for child in element):
            return [("id", "".join(element.itertext()))]
        case "mrow" | "mtd":
            return of_mathml(element)
        case _:
            return [_of_parts(element.tag, [_of_tag(child) for child in element])]


def _of_parts(tag: str, parts: list[Nodes]) -> Node:
    """What stands around a letter, above or below a line, or under a root."""
    match tag:
        case "msub":
            return ("sub", parts[0][0], parts[1])
        case "msup" if spelt(parts[1]) in {"′", "'"}:
            return primed(parts[0][0])
        case "msup":
            return ("sup", parts[0][0] if parts[0] else NOTHING, parts[1])
        case "msubsup":
            return ("sup", ("sub", parts[0][0], parts[1]), parts[2])
        case "mfrac":
            return ("frac", *map(grouped, parts))
        case "msqrt":
            return ("sqrt", grouped([node for part in parts for node in part]))
        case "mover":
            accent = next(c for c in "^˙→" if c in spelt(parts[1]).replace("ˆ", "^"))
            return ("id", spelt(parts[0]) + accent)
        case _:
            return ("row", [node for part in parts for node in part])
