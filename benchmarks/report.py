"""Tables as text, and their places in the documents."""

from __future__ import annotations

from typing import TYPE_CHECKING

from benchmarks.arms import CHECKOUT

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

DOCUMENT = CHECKOUT / "docs" / "benchmarks.md"
README = CHECKOUT / "README.md"


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A Markdown table, readable as it is; all columns but the first are right-aligned."""
    widths = [max(map(len, column)) for column in zip(head, *rows, strict=True)]

    def line(cells: Sequence[str]) -> str:
        first, *rest = zip(cells, widths, strict=True)
        texts = [first[0].ljust(first[1]), *(cell.rjust(width) for cell, width in rest)]
        return f"| {' | '.join(texts)} |"

    rule = ["-" * widths[0], *("-" * (width - 1) + ":" for width in widths[1:])]
    return "\n".join([line(head), f"| {' | '.join(rule)} |", *map(line, rows)])


def place(path: Path, mark: str, text: str) -> None:
    """Puts text between the two comments of a Markdown file that bear the mark.

    Raises:
        ValueError: The file has no such comments.
    """
    start, end = f"<!-- {mark} -->", f"<!-- /{mark} -->"
    whole = path.read_text(encoding="utf-8")
    if whole.count(start) != 1 or whole.count(end) != 1:
        raise ValueError(f"{path.name} needs one {start} and one {end}")
    before, rest = whole.split(start)
    after = rest.split(end)[1]
    path.write_text(f"{before}{start}\n{text}\n{end}{after}", encoding="utf-8")


def placed(text: str, mark: str) -> list[tuple[str, ...]]:
    """The cells of the tables between the two comments that bear the mark, heads among them."""
    inside = text.split(f"<!-- {mark} -->")[1].split(f"<!-- /{mark} -->", maxsplit=1)[0]
    lines = (line for line in inside.splitlines() if line.startswith("|"))
    rows = [tuple(cell.strip() for cell in line.split("|")[1:-1]) for line in lines]
    return [row for row in rows if set(row[0]) != {"-"}]


def time_text(nanoseconds: float) -> str:
    """A time with three digits and its unit."""
    for unit, size in (("s", 1e9), ("ms", 1e6), ("µs", 1e3)):
        if nanoseconds >= size:
            return f"{nanoseconds / size:.3g} {unit}"
    return f"{nanoseconds:.3g} ns"
