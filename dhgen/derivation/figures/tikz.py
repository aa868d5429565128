"""Shapes as TikZ, for LaTeX; how each kind looks is in the template of a handout."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.figures.sheet import Disc, Path, Words, number
from dhgen.derivation.text.latex_text import latex_letters, latex_text

if TYPE_CHECKING:
    from dhgen.derivation.figures.sheet import Shape

IN_FORMULAS = "i"  # the kind of names that are letters of formulas
_ANCHORS = {"": "base west", "middle": "base", "end": "base east"}


def tikz(shape: Shape) -> str:
    """A shape as a command of TikZ, lengths in pixels."""
    match shape:
        case Path(kind, data, is_faint):
            return rf"\path[{_looks(kind, 'faint' * is_faint)}] svg {{{data}}};"
        case Disc(kind, (x, y), radius):
            return rf"\path[{_looks(kind)}] {_point(x, y)} circle[radius={number(radius)}pt];"
        case Words(kind, (x, y), runs, anchor):
            looks = f"{_looks('words', kind)},anchor={_ANCHORS[anchor]}"
            is_name = IN_FORMULAS in kind.split()
            text = _name(runs) if is_name else "".join(latex_text(run) for run, _ in runs)
            return rf"\node[{looks}] at {_point(x, y)} {{{text}}};"


def _looks(*kinds: str) -> str:
    return ",".join(f"as {kind}" for kind in " ".join(kinds).split())


def _point(x: float, y: float) -> str:
    return f"({number(x)}pt,{number(y)}pt)"


def _name(runs: tuple[tuple[str, bool], ...]) -> str:
    shown = (f"_{{{latex_letters(run)}}}" if below else latex_letters(run) for run, below in runs)
    return f"${''.join(shown)}$"
