"""Whole turns that move angles inside limits: what the template `turns.md.jinja` names."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import joint_symbol
from dhgen.derivation.text.blocks import joined, say
from dhgen.derivation.text.template import blocks_of
from dhgen.derivation.whole_turns import NEAR_HALF_TURN
from dhgen.kinematics.turns import coupled_turns, has_limits, joints_alone

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.kinematics.chain import Chain


def turns_inside(story: Story) -> list[Block]:
    """How angles in (-pi, pi] get inside their limits; nothing where whole turns don't help."""
    chain = story.algebra.chain
    alone, together = _moved_alone(chain), _moved_together(chain)
    return blocks_of(
        "turns",
        alone=_named(alone) if alone else None,
        together=_named(together) if together else None,
        sums=bool(chain.sums),
    )


def _moved_alone(chain: Chain) -> list[int]:
    """The joints, from 1, of which some angle is inside its limits after whole turns only."""
    joints = zip(joints_alone(chain), chain.turning, strict=True)
    return [
        joint.number
        for joint, turns in joints
        if turns and joint.limits and joint.number not in chain.free and _reaches(*joint.limits)
    ]


def _reaches(low: float, high: float) -> bool:
    """Whether some angle in (-pi, pi] is outside of limits, and inside after whole turns."""
    below, above = low <= -math.pi + NEAR_HALF_TURN, high > math.pi + NEAR_HALF_TURN
    return above if not below else high < math.pi - NEAR_HALF_TURN


def _moved_together(chain: Chain) -> list[int]:
    """The drives, from 1, whose whole turns are chosen together."""
    together = coupled_turns(chain)
    return sorted(together.drives) if together is not None and has_limits(chain) else []


def _named(numbers: list[int]) -> Prose:
    return joined([say("{}", joint_symbol(number)) for number in numbers])
