"""Lengths that are zero together: what is said of the arm is true of its numbers."""

from __future__ import annotations

import re

import pytest

from tests.derivation.made import made_of

ON_THE_AXIS = (
    "With the numbers of this arm $Z = 0$, so there is always a solution, and $D_1 = 0$ only when "
    "$X = Y = 0$. Degenerate when $D_1 = 0$: the tool's origin lies on axis 1, and every "
    r"$\theta_1$ works. Then $q_1$ takes the seed's value"
)
BESIDE_IT = "the tool's origin is as close to axis 1 as the offset of the arm allows"


def shoulder(offset: str) -> str:
    """An arm whose links lie 0.1 beside axis 1, and back by `offset`."""
    rows = "d: 0.4, alpha: pi/2", "d: 0.1, a: 0.4", f"d: {offset}, a: 0.3"
    return made_of(*(f"theta: q, {row}" for row in rows), task="position")


@pytest.mark.parametrize("offset", ["-0.1", "-0.3/3", "0.2-0.3"])
def test_a_point_that_offsets_lead_back_to_axis_1_leaves_it_free(offset: str) -> None:
    text = shoulder(offset)
    assert ON_THE_AXIS in text
    row = r"\| 1 \| \$D_1 = 0\$ \| .* \| the tool's origin lies on axis 1, and every"
    assert len(re.findall(row, text)) == 1
    assert BESIDE_IT not in text


def test_a_point_beside_axis_1_turns_about_it_by_two_angles() -> None:
    text = shoulder("-0.11")
    assert BESIDE_IT in text
    assert "With the numbers of this arm" not in text
