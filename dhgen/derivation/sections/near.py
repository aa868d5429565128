"""How near an arm is to one with a closed form: three axes that nearly meet or are parallel."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from dhgen.derivation.text.blocks import paragraph
from dhgen.derivation.text.words import joined
from dhgen.kinematics.neighbours import EXACT, axis_triples, short_number
from dhgen.paul.refusal import NEARLY_CONCURRENT, NEARLY_PARALLEL

if TYPE_CHECKING:
    from dhgen.derivation.text.blocks import Block
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.neighbours import Triple

MISSED = "What keeps this arm from a closed form: "


def near_blocks(chain: Chain, unit: str) -> list[Block]:
    """By how much axes miss one point or one direction; `unit` is that of lengths."""
    triples = [t for t in axis_triples(chain) if min(t.tilt, t.miss / chain.size) >= EXACT]
    apart = [t for t in triples if t.miss < NEARLY_CONCURRENT * chain.size]
    leaning = [t for t in triples if t not in apart and t.tilt < NEARLY_PARALLEL]
    said = [f"{_axes(t)} are not quite parallel but {_degrees(t)} apart" for t in leaning]
    if apart:
        axes = joined([_axes(t) for t in apart])
        length = joined([f"{short_number(t.miss, 4)} {unit}" for t in apart])
        said.append(
            f"{axes} do not meet in one point. What they miss it by, the largest distance between "
            "neighbours of three or between the feet of their common normals on the middle one, is "
            f"{length}{', in this order' * (len(apart) > 1)}"
        )
    return [paragraph(f"{MISSED}{'; '.join(said)}.")] if said else []


def _axes(triple: Triple) -> str:
    return f"axes {joined([str(joint) for joint in triple.joints])}"


def _degrees(triple: Triple) -> str:
    return f"{short_number(math.degrees(triple.tilt), 3)} degrees"
