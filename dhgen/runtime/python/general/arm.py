# SPDX-License-Identifier: MIT
"""The array of a general arm: what numerical/arm.py makes, with the numbers of its loop."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from ..numerical.arm import arm_numbers
from .places import COSINE_VANISHES, LENGTH, SINE_VANISHES

if TYPE_CHECKING:
    from ..arrays import Floats
    from ..numerical.arm import Arm

Numbers = tuple[float, ...]
JOINTS = 6
FOUR_TURNS = 4  # and two slides
WAYS = 2  # to solve at a root where four turns leave it, one for each branch
WAYS_OF_A_WRIST = 4


@dataclass(frozen=True, slots=True)
class Inside:
    """A joint inside a link, whose value the caller gives.

    Attributes:
        given: Which of the values it is, from 0.
        slides: Whether it slides; else it turns.
        factor: Of its angle, 1 or -1, or of its length.
        after: The rigid transform behind it, twelve numbers.
    """

    given: int
    slides: bool
    factor: float
    after: Numbers


@dataclass(frozen=True, slots=True)
class Link:
    """A link of the loop: a rigid transform, twelve numbers, and the joints inside it."""

    first: Numbers
    inside: tuple[Inside, ...] = ()


@dataclass(frozen=True, slots=True)
class Formulation:
    """A formulation: the joints phi_1 (hidden) ... phi_6 are, and the sign of phi = sign q."""

    joints: tuple[int, ...]
    sign: float


@dataclass(frozen=True, slots=True)
class Special:
    """A value of a given joint at which formulations vanish.

    Attributes:
        given: Which of the values it is, from 0.
        cosine: Of an angle, a multiple of a quarter turn; both are 0 for a length, which is 0.
        sine: The same.
        within: How near is there [rad or length].
        formulations: Which are not tried there.
    """

    given: int
    cosine: float
    sine: float
    within: float
    formulations: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Wrist:
    """An offset wrist; lengths in arm sizes.

    Attributes:
        shoulder: Along axis 1 to S, where axes 1 and 2 meet.
        wrist: Along axis 5 to W, where axes 4 and 5 meet.
        upper: From S to the elbow.
        lower: From the elbow to W.
        cosine: Of the angle between the lower arm and axis 4.
        sine: Of the same.
        flip: On which side axis 4 leaves the lower arm.
        sources: What the turns of joints 1 ... 4 bring into line with axis 3, the elbow, W and
            axis 5: x and y of each.
    """

    shoulder: float
    wrist: float
    upper: float
    lower: float
    cosine: float
    sine: float
    flip: float
    sources: Numbers


@dataclass(frozen=True, slots=True)
class Loop:
    """An arm as a loop of six joints.

    Attributes:
        size: The length that is one in it [file's unit].
        reach: The square of what is out of reach [arm sizes]; infinite where nothing is.
        links: K0 ... K4, L and R.
        advances: Cosine and sine of what is added to each joint's angle.
        formulations: In the order in which they are tried.
        slides: Which of the joints slide, from 0.
        side: Where a slide is in the formulations: "left", "right" or "hidden".
        order: Half the order of the determinant's zero where a hidden slide's length is infinite.
        given: Sign and offset of the values that the caller gives.
        given_shares: What given values add to the angle or length of each joint that is given, a
            factor of every one of them; empty where none adds to another's.
        special: Values of these at which formulations vanish.
        wrist: The offset wrist, where there is one: its polynomial is tried first.
        pointing: Whether the last joint is the tool's turn about its own axis.
    """

    size: float
    reach: float
    links: tuple[Link, ...]
    advances: tuple[tuple[float, float], ...]
    formulations: tuple[Formulation, ...]
    slides: tuple[int, ...] = ()
    side: str = "left"
    order: int = 0
    given: tuple[tuple[float, float], ...] = ()
    given_shares: tuple[Numbers, ...] = ()
    special: tuple[Special, ...] = ()
    wrist: Wrist | None = None
    pointing: bool = False


def general_numbers(arm: Arm, loop: Loop) -> Floats:
    """Returns the array of a general arm."""
    two_slides, count, wrist = len(loop.slides) > 1, len(loop.formulations), loop.wrist
    per_root = 1 if wrist is None or wrist.sine else 2
    numbers = [
        *(arm.rows, count if two_slides else wrist is not None, 0 if two_slides else count),
        *(WAYS if wrist is None else WAYS_OF_A_WRIST, per_root, wrist is not None),
        *(loop.pointing, loop.size, 1.0 / loop.size, loop.reach),
        *(i in loop.slides for i in range(JOINTS)),
        *(bool(loop.slides), loop.side == "hidden", loop.order),
        *(loop.side == "left" and bool(loop.slides), loop.side == "right"),
        *(c for c, _ in loop.advances),
        *(s for _, s in loop.advances),
        *(_wrist(wrist) if wrist else [0.0] * 17),
    ]
    formulations = [x for each in loop.formulations for x in (*each.joints, each.sign)]
    links = [x for link in loop.links for x in _link(link)]
    given = []
    for number, pair in enumerate(loop.given):
        shares = loop.given_shares[number] if loop.given_shares else (0.0,) * len(loop.given)
        given += [*pair, *shares]
    special = [len(loop.special), *(x for each in loop.special for x in _special(each))]
    return arm_numbers(arm, [*map(float, numbers)], (formulations, links, given, special))


def _wrist(wrist: Wrist) -> Numbers:
    """Returns the numbers of an offset wrist."""
    return (
        *(wrist.shoulder, wrist.wrist, wrist.upper * wrist.upper),
        *(wrist.lower, wrist.lower * wrist.lower, wrist.cosine, wrist.sine, wrist.flip),
        *(float(bool(wrist.sine)), *wrist.sources),
    )


def _link(link: Link) -> Numbers:
    """Returns the record of a link."""
    inside = (
        (float(each.given), float(each.slides), each.factor, *each.after) for each in link.inside
    )
    return (float(len(link.inside)), *link.first, *(x for each in inside for x in each))


def _special(special: Special) -> Numbers:
    """Returns the record of a value at which formulations vanish."""
    kind = LENGTH
    if special.cosine or special.sine:
        kind = SINE_VANISHES if special.sine == 0.0 else COSINE_VANISHES
    sign = -1.0 if special.cosine + special.sine < 0.0 else 1.0
    bits = sum(1 << number for number in special.formulations)
    return (float(special.given), kind, sign, special.within, float(bits))
