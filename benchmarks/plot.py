"""The picture: every solver a dot, an arm a line, time to the right on a logarithmic scale."""

from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib as mpl
from matplotlib.figure import Figure

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from benchmarks.contestant import Contestant
    from benchmarks.results import Result

# Text stays text and identifiers come from a fixed salt: the same figures give the same bytes.
STYLE = {"svg.fonttype": "none", "svg.hashsalt": "dhgen", "font.size": 9.0}
OURS = {
    "C, -O2": ("v", "#7aa6d8"),
    "C, scalar": ("<", "#7aa6d8"),
    "C, one pose, AVX2": ("s", "#3f7cc4"),
    "C, one pose": ("D", "#12467f"),
    "C, batch, AVX2": ("P", "#3f7cc4"),
    "C, batch": ("*", "#12467f"),
    "Python, ik_into": (">", "#2a9d8f"),
    "Python, ik_all": ("^", "#2a9d8f"),
    "Python, ik_batch": ("X", "#2a9d8f"),
}
COLOURS = ("#d1495b", "#edae49", "#8d5a97", "#66635b", "#c77d4f", "#b0b0b0")
SHAPES = {"one call from Python": "o", "batch from Python": "h", "exported C, one pose": "d"}


def draw(results: Sequence[Result], path: Path) -> None:
    """Writes the picture of some results as SVG."""
    colours = _colours(results)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(9.0, 0.9 + 0.55 * len(results)))
        axes = figure.add_subplot()
        for place, result in enumerate(results):
            axes.axhline(place, color="#e0e0e0", zorder=0)
            for entry in result.entries:
                shape, colour = _mark(entry.contestant, colours)
                axes.plot(
                    entry.timing.least,
                    place,
                    linestyle="none",
                    marker=shape,
                    color=colour,
                    markersize=8,
                    alpha=0.9,
                    label=entry.contestant.label,
                )
        axes.set_xscale("log")
        axes.set_xlabel("CPU time for all solutions of one pose [ns]")
        axes.set_yticks(
            range(len(results)), [f"{each.case.name}\n{each.case.kind}" for each in results]
        )
        axes.set_ylim(len(results) - 0.5, -0.5)
        axes.grid(axis="x", color="#e8e8e8")
        axes.set_axisbelow(True)
        handles, labels = axes.get_legend_handles_labels()
        marks = dict(sorted(zip(labels, handles, strict=True), key=_ours_first))
        place_right = {"loc": "center left", "bbox_to_anchor": (1.0, 0.5), "frameon": False}
        axes.legend(marks.values(), marks.keys(), **place_right)
        for side in ("top", "right", "left"):
            axes.spines[side].set_visible(False)
        figure.savefig(path, bbox_inches="tight", metadata={"Date": None, "Creator": None})


def _ours_first(mark: tuple[str, object]) -> tuple[bool, str]:
    label, _ = mark
    return not label.startswith("dhgen"), label


def _colours(results: Sequence[Result]) -> dict[str, str]:
    tools = {e.contestant.tool: None for r in results for e in r.entries if not e.contestant.ours}
    return {tool: COLOURS[place % len(COLOURS)] for place, tool in enumerate(sorted(tools))}


def _mark(contestant: Contestant, colours: dict[str, str]) -> tuple[str, str]:
    if contestant.ours:
        return OURS[contestant.way]
    return SHAPES.get(contestant.way, "o"), colours[contestant.tool]
