"""Joints of a redundant arm that make good free ones, found by solving the arm that remains."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import accumulate, combinations, groupby
from math import comb
from typing import TYPE_CHECKING

import numpy as np

from dhgen.errors import UnsolvedError
from dhgen.general.arm import is_general, slides_of
from dhgen.general.kernel import general_method, most_solutions
from dhgen.kinematics.neighbours import EXACT
from dhgen.kinematics.numeric import numeric_arm
from dhgen.kinematics.task import units
from dhgen.method import Method
from dhgen.paul.mobility import surplus
from dhgen.paul.refusal.size_limits import are_too_many_given
from dhgen.robot.robot import JointKind
from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain
    from dhgen.paul.derivation import Derivation
    from dhgen.paul.mobility import Surplus


MOST_CHOICES = 16  # trying more would take longer than a refusal may
MOST_SHOWN = 100  # characters of sets in a line
MOST_SKEW = 4  # so many joints are solved, or refused, soon without structure
MOST_TURNING = 3  # the same whatever the number of slides
POSITIONS = 3
RANKS = {Method.CLOSED_FORM: 0, Method.QUARTIC: 1}
GENERAL = 2  # rank of what takes the joints all at once


@dataclass(frozen=True, slots=True, order=True)
class Choice:
    """Joints whose values the caller might give, best first.

    Attributes:
        rank: 0 for a closed form, 1 for a quartic, 2 for the rest.
        rows: How many solutions the remaining arm has at most.
        free: All free joints then, from 1.
        method: How the remaining arm is solved.
    """

    rank: int
    rows: int
    free: tuple[int, ...]
    method: Method


def free_joint_advice(
    chain: Chain, spare: Surplus, derive: Callable[[Chain], Derivation]
) -> tuple[Choice, ...]:
    """The free joints for which the remaining arm is solved, best first; none if they are too many.

    Of very many sets some are tried, evenly spread.

    Args:
        chain: The arm.
        spare: What its task leaves open.
        derive: Solves an arm, or raises UnsolvedError.
    """
    if are_too_many_given(chain.given + spare.count):
        return ()
    sets = list(combinations(spare.joints, spare.count))
    found: list[Choice] = []
    for chosen in sets[:: -(-len(sets) // MOST_CHOICES)]:
        remaining = replace(chain, free=tuple(sorted((*chain.free, *chosen))))
        if surplus(remaining).count:
            continue
        if not _has_structure(remaining):
            found += _general(remaining)
            continue
        try:
            derivation = derive(remaining)
        except UnsolvedError:
            continue
        rank = RANKS.get(derivation.method, GENERAL)
        found.append(Choice(rank, derivation.branches, remaining.free, derivation.method))
    return tuple(sorted(found))


def choices_text(choices: tuple[Choice, ...], spare: Surplus) -> list[str]:
    """The advice as text: a line for each method and number of rows."""
    lines = []
    for (_, rows, method), alike in groupby(choices, lambda c: (c.rank, c.rows, c.method)):
        sets = _sets_text([f"[{', '.join(map(str, choice.free))}]" for choice in alike])
        count = "one row" if rows == 1 else f"{rows} rows"
        lines.append(f"  free: {sets} leaves a {method} with {count}")
    total = comb(len(spare.joints), spare.count)
    if choices and total > MOST_CHOICES:
        lines.append(f"  only some of the {total} sets of {spare.count} joints were tried")
    return lines


def _sets_text(sets: Sequence[str]) -> str:
    """The first few sets of free joints, and how many more there are."""
    shown = max(1, sum(end <= MOST_SHOWN for end in accumulate(map(len, sets))))
    left = len(sets) - shown
    more = [] if not left else ["another set"] if left == 1 else [f"one of {left} more sets"]
    return " or ".join([*sets[:shown], *more])


def _general(chain: Chain) -> list[Choice]:
    """An arm without structure as a choice, if the general algorithm is for it."""
    if not (is_general(chain) and chain.is_given_alone):
        return []
    slides = len(slides_of(chain))
    return [Choice(GENERAL, most_solutions(slides), chain.free, general_method(slides))]


def _has_structure(chain: Chain) -> bool:
    """Whether there is hope: few joints that turn, or three axes that belong together.

    The search on a general arm takes minutes and finds nothing. Where the task gives more equations
    than there are joints, it is short and often finds something.
    """
    joints = chain.solved
    turning = [joint for joint in joints if joint.kind is JointKind.REVOLUTE]
    if len(joints) <= MOST_SKEW or len(turning) <= MOST_TURNING or chain.overdetermined:
        return True
    arm, source = numeric_arm(chain), np.random.default_rng(9)
    places = [joint.number - 1 for joint in turning]
    q = source.uniform(-2.0, 2.0, (POSITIONS, chain.dof)) * units(chain)
    # the given joints take several values: axes on both sides of one must not meet by chance
    directions, points = arm.axes(q)
    if chain.task.kind is TaskKind.POINTING:  # the tool may turn about its z axis: one axis more
        T = arm.pose(q)
        directions = np.concatenate([directions, T[:, None, :3, 2]], axis=1)
        points = np.concatenate([points, T[:, None, :3, 3]], axis=1)
        places.append(chain.dof)
    for first in range(len(places) - 2):
        triple = places[first : first + 3]
        z, p = directions[:, triple], points[:, triple] / chain.size
        if _parallel(z) or _concurrent(z, p):
            return True
    return False


def _parallel(z: FloatArray) -> bool:
    return bool(np.abs(np.cross(z[:, :1], z[:, 1:])).max() < EXACT)


def _concurrent(z: FloatArray, p: FloatArray) -> bool:
    """Whether three lines (N, 3, 3) meet in one point, in each of N positions."""
    across = np.eye(3) - z[..., :, None] * z[..., None, :]
    normal = across.sum(axis=1)
    target = (across @ p[..., None]).sum(axis=1)
    centre = np.linalg.pinv(normal) @ target
    away = across @ (centre[:, None] - p[..., None])
    return bool(np.abs(away).max() < EXACT)
