"""Shapes as SVG; how each kind looks is in the template of a figure."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

from dhgen.derivation.figures.sheet import BELOW, Disc, Path, Words, number

if TYPE_CHECKING:
    from dhgen.derivation.figures.sheet import Shape


def svg(shape: Shape) -> str:
    """A shape as an element of SVG."""
    match shape:
        case Path(kind, data, is_faint):
            # what an area goes round is not reached
            holes = ' fill-rule="evenodd"' if kind == "area" else ""
            faint = ' stroke-opacity="0.45"' if is_faint else ""
            return f'<path class="{kind}" d="{data}"{holes}{faint}/>'
        case Disc(kind, (x, y), radius):
            place = f'cx="{number(x)}" cy="{number(y)}" r="{number(radius)}"'
            return f'<circle class="{kind}" {place}/>'
        case Words(kind, (x, y), runs, anchor):
            place = f'x="{number(x)}" y="{number(y)}"'
            place += f' text-anchor="{anchor}"' if anchor else ""
            kinds = f'class="{kind}" ' if kind else ""
            return f"<text {kinds}{place}>{_with_indices(runs)}</text>"


def _with_indices(runs: tuple[tuple[str, bool], ...]) -> str:
    parts: list[str] = []
    was_below = False
    for run, below in runs:
        shift = "" if below == was_below else f' dy="{BELOW if below else -BELOW}"'
        size = ' font-size="10"' if below else ""
        shown = escape(run, quote=False)
        parts.append(f"<tspan{shift}{size}>{shown}</tspan>" if shift or size else shown)
        was_below = below
    return "".join(parts)
