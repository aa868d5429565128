"""What kind of arm it is, from its geometry alone."""

from __future__ import annotations

from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.neighbours import EXACT, axis_triples
from dhgen.kinematics.numeric import numeric_arm
from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.neighbours import Triple


TASKS = {
    TaskKind.POSE: "",
    TaskKind.POSITION: "position",
    TaskKind.ORIENTATION: "orientation",
    TaskKind.POINTING: "pointing",
}


def joint_letters(chain: Chain) -> str:
    """R or P for every joint; a free joint's letter is small."""
    return "".join(
        letter.lower() if number in chain.free else letter
        for number, letter in enumerate(chain.joint_types, start=1)
    )


def arm_class(chain: Chain) -> str:
    """The structure in a few words: "spherical wrist, ortho-parallel", "SCARA", "general 6R"."""
    task = chain.task
    asked = TASKS[task.kind] if task.kind in TASKS else ", ".join(task.coordinates)
    return ", ".join(filter(None, [*_structure(chain), asked]))


def _structure(chain: Chain) -> list[str]:
    directions = _directions(chain)
    turns = [d for d, turns in zip(directions, chain.turning, strict=True) if turns]
    slides = [d for d, turns in zip(directions, chain.turning, strict=True) if not turns]
    if not turns:
        return ["Cartesian"]
    if len(turns) > 1 and all(_parallel(one, other) for one, other in pairwise(turns)):
        if not slides:
            return ["planar"]
        upright = all(_parallel(turns[0], slide) for slide in slides)
        return ["SCARA" if upright else "planar with slides"]
    triples = axis_triples(chain)
    parallel = [triple for triple in triples if triple.tilt < EXACT]
    meeting = [triple for triple in triples if triple.miss < EXACT * chain.size]
    found = [*_meeting(chain, meeting), *(f"parallel axes {_named(t)}" for t in parallel)]
    if _is_ortho_parallel(chain, directions, meeting):
        found.append("ortho-parallel")
    if not found:
        return [f"general {len(turns)}R" + (f"{len(slides)}P" if slides else "")]
    return found


def _meeting(chain: Chain, triples: list[Triple]) -> list[str]:
    last = chain.dof
    return [
        "spherical wrist" if triple.joints[2] == last else f"axes {_named(triple)} meet"
        for triple in triples
    ]


def _named(triple: Triple) -> str:
    return "-".join(map(str, triple.joints))


def _is_ortho_parallel(chain: Chain, directions: list[FloatArray], meeting: list[Triple]) -> bool:
    """Six turns: axis 2 across axis 1, axis 3 parallel to axis 2, axis 4 across it, a wrist."""
    if chain.free or chain.joint_types != "RRRRRR" or (4, 5, 6) not in {t.joints for t in meeting}:
        return False
    one, two, three, four = directions[:4]
    return _across(one, two) and _parallel(two, three) and _across(three, four)


def _parallel(one: FloatArray, other: FloatArray) -> bool:
    return bool(np.linalg.norm(np.cross(one, other)) < EXACT)


def _across(one: FloatArray, other: FloatArray) -> bool:
    return bool(abs(one @ other) < EXACT)


def _directions(chain: Chain) -> list[FloatArray]:
    """Of every axis, all angles zero: what neighbours are to each other does not depend on it."""
    return list(numeric_arm(chain).axes(np.zeros(chain.dof))[0])
