"""Random arms by structure: where axes meet or are parallel, and which other joint slides.

Everything that the structure leaves open is random: lengths, offsets, twists. So an arm holds no
coincidence that its structure does not have, and all arms of one seed are the same everywhere.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

JOINTS = 6
PLACES = range(1, JOINTS - 1)  # of the first of three axes
RIGHT = ("pi/2", "-pi/2")


def write_structures(folder: Path, seed: int) -> list[Path]:
    """One robot file for every structure, in a fixed order."""
    paths = []
    for name, text in structures(seed):
        paths.append(folder / f"{name}.yaml")
        paths[-1].write_text(text, encoding="utf-8")
    return paths


def structures(seed: int) -> Iterator[tuple[str, str]]:
    """Names and robot files: three axes that meet or are parallel somewhere, a slide or none."""
    random = np.random.default_rng(seed)
    for kind in ("meet", "parallel"):
        for place in PLACES:
            three = range(place, place + 3)
            outside = [joint for joint in range(1, JOINTS + 1) if joint not in three]
            for slide in (0, *outside):
                name = f"{kind}_{place}" + (f"_slide_{slide}" if slide else "")
                yield f"{name}_{seed}", _robot(f"{name}_{seed}", kind, place, slide, random)


def _robot(name: str, kind: str, place: int, slide: int, random: np.random.Generator) -> str:
    rows = [_row(joint, kind, place, slide, random) for joint in range(1, JOINTS + 1)]
    return "\n".join([f"name: {name}", "convention: standard", "joints:", *rows]) + "\n"


def _row(joint: int, kind: str, place: int, slide: int, random: np.random.Generator) -> str:
    """A row of a standard table; axis i is the z of frame i - 1, which row i leads away from."""
    d, a = (f"{value:.3f}" for value in random.uniform(0.05, 0.5, 2))
    oblique, angle = (f"{value:.3f}" for value in random.uniform(0.3, 1.3, 2))
    alpha = str(random.choice([*RIGHT, oblique, f"-{oblique}"]))
    if joint in (place, place + 1):
        if kind == "meet":
            a = "0"
            d = "0" if joint == place + 1 else d
        else:
            alpha = "0"
    if joint == slide:
        return f"  - {{theta: {angle}, d: q, a: {a}, alpha: {alpha}}}"
    return f"  - {{theta: q, d: {d}, a: {a}, alpha: {alpha}}}"
