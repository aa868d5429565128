"""Which row to take: limits, whole turns, the shortest motion; the two ways to turn a wrist."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.notation.names import joint_symbol, single, theta
from dhgen.derivation.steps import leaves_a_joint_free
from dhgen.derivation.text.blocks import Heading, joined, paragraph, say
from dhgen.derivation.text.formula import Listing, Symbol, add, minus, subtract
from dhgen.derivation.values import figures
from dhgen.kinematics.turns import coupled_turns

if TYPE_CHECKING:
    from dhgen.derivation.example import Example
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block
    from dhgen.kinematics.chain import Chain

TURN = 2.0 * math.pi
SQUARES = Symbol(r"\sum_i (q_i - q_i^{\mathrm{seed}})^2", "Σᵢ (qᵢ − qᵢ,seed)²")
HALF = Symbol(r"\pi", "π")
ALL = " Such rows have the status OK, empty rows UNREACHABLE."
OTHERS = " The status of other rows with a solution is OK, that of empty rows UNREACHABLE."
FREE = (
    " A row in which a joint took the seed's value, because the pose leaves it free, has "
    "FREE_JOINT."
)
MARKED = (
    "A row is a solution, whether the arm can stand there or not: one with a joint beyond its "
    "limits keeps its place and has the status OUT_OF_LIMITS."
)
SUMS_MARKED = (
    "A row is a solution, whether the arm can stand there or not: one with a joint, or a sum of "
    "joint values, beyond its limits keeps its place and has the status OUT_OF_LIMITS."
)
UNMARKED = "No joint has limits, so the arm can take every row that holds a solution."


def choosing_section(story: Story) -> list[Block]:
    """The whole section; nothing where there is one row and no limit."""
    chain = story.algebra.chain
    limited = bool(chain.sums) or any(joint.limits for joint in chain.joints)
    free = leaves_a_joint_free(story)
    if story.program.rows == 1 and not limited:
        return []
    return [
        Heading(2, say("Choosing a row")),
        paragraph(
            ((SUMS_MARKED if chain.sums else MARKED) if limited else UNMARKED)
            + (FREE if free else "")
            + (OTHERS if limited or free else ALL)
        ),
        *_whole_turns(chain),
        *_shortest(story, "the one inside its limits" if limited else "the one"),
        *_flipped(story),
    ]


def _whole_turns(chain: Chain) -> list[Block]:
    """Joints whose angle has several values for one posture of the arm."""
    joints = (each for each, turns in zip(chain.joints, chain.turning, strict=True) if turns)
    wide = [each.number for each in joints if each.limits and np.ptp(each.limits) > TURN]
    if not wide or coupled_turns(chain) is not None:
        return []
    some = joined([say("{}", joint_symbol(number)) for number in wide])
    return [
        paragraph(
            "The limits of {} are more than a whole turn apart, so that some angles fit in twice. "
            "A row holds one of them; only the search for the nearest row takes the one nearest to "
            "the seed.",
            some,
        )
    ]


def _shortest(story: Story, which: str) -> list[Block]:
    """The shortest motion, document 002's choice, and what it is in the example."""
    chain, example = story.algebra.chain, story.example
    if story.program.rows == 1:
        return []
    angles = ["angles in radians"] if any(chain.turning) else []
    lengths = [] if all(chain.turning) else ["lengths divided by the size of the arm, {}"]
    units = f", {' and '.join(angles + lengths)}"
    size = [] if all(chain.turning) else [figures(chain.size)]
    unit = f" {story.robot.length_unit}" if size else ""
    choice = "Document 002 chooses" if story.cites_courses else "One may choose"
    blocks: list[Block] = [
        paragraph(
            f"{choice} the row that the arm reaches by the shortest motion from where it stands, "
            "the seed: "
            f"{which} with the least {{}}{units}{unit}.",
            SQUARES,
            *size,
        )
    ]
    if example is None or coupled_turns(chain) is not None:
        return blocks
    row, distance = nearest_to_zero(chain, example)
    named = f", {story.branch_names[row]}" if story.has_branch_words else ""
    blocks.append(
        paragraph(
            f"In the example, with a seed of zeros, that is row {row}{named}, where the sum "
            "is {}.",
            figures(distance),
        )
    )
    return blocks


def nearest_to_zero(chain: Chain, example: Example) -> tuple[int, float]:
    """The row inside the limits that is nearest to q = 0 in an example, and the sum of squares."""
    rows = [
        sum(
            (_nearest(value, joint.limits) if turns else value / chain.size) ** 2
            for value, joint, turns in zip(q, chain.joints, chain.turning, strict=True)
        )
        if inside
        else math.inf
        for q, inside in zip(example.rows.tolist(), example.inside, strict=True)
    ]
    row = int(np.argmin(rows))
    return row, rows[row]


def _nearest(angle: float, limits: tuple[float, float] | None) -> float:
    """The copy of an angle by whole turns that is nearest to zero, inside the limits."""
    copies = [angle + turn * TURN for turn in (-2, -1, 0, 1, 2)]
    inside = [each for each in copies if limits is None or limits[0] <= each <= limits[1]]
    return min(inside or copies, key=abs)


def _flipped(story: Story) -> list[Block]:
    """What two rows of a spherical wrist have to do with each other."""
    if story.wrist is None or not any("flip" in axis.meaning for axis in story.program.axes):
        return []
    first, middle, last = story.wrist
    outside = {f"{kind}{joint}" for joint in (first, last) for kind in "cs"}
    one, half, other = (theta(single(joint)) for joint in story.wrist)
    if _is_even(story, outside | {f"s{middle}"}):
        middle_turned = minus(half)
    elif _is_even(story, outside | {f"c{middle}"}):
        middle_turned = subtract(HALF, half)
    else:
        return []
    return [
        paragraph(
            "Rows that differ in noflip and flip alone hold the two ways to turn the wrist: where "
            "one has {}, the other has {}, up to whole turns.",
            Listing((one, half, other)),
            Listing((add(one, HALF), middle_turned, add(other, HALF))),
        )
    ]


def _is_even(story: Story, turned: set[str]) -> bool:
    """Whether the wrist's rotation stays as it is where these cosines and sines change signs."""
    assert story.wrist is not None
    first, _, last = story.wrist
    algebra = story.algebra
    rotation = story.derivation.problem.spans.product(first - 1, last).rotation
    places = [algebra.ring.gens.index(each) for each in map(algebra.generator, sorted(turned))]
    return not any(
        sum(monomial[place] for place in places) % 2
        for row in rotation
        for entry in row
        for monomial in entry
    )
