"""An arm given by axes whose points are numbers: their letters, and what becomes of differences."""

from __future__ import annotations

from functools import cache

from tests.derivation.made import made_for
from tests.kinematics.values import axes


@cache
def written(third: float = 0.3) -> str:
    """Three parallel axes, slanted, between two others; where the middle one is."""
    return made_for(
        axes(
            "type: revolute, direction: [0, 0, 1], point: [0, 0, 0]",
            "type: revolute, direction: [0, 1, 1], point: [0, 0, 0.3]",
            f"type: revolute, direction: [0, 1, 1], point: [{third}, 0, 0.3]",
            "type: revolute, direction: [0, 1, 1], point: [0.6, 0, 0.3]",
            "type: revolute, direction: [1, 0, 0], point: [0.6, 0.1, 0.3]",
            "type: revolute, direction: [0, 0, 1], point: [0.9, 0.1, 0.3]",
            home="{xyz: [0.9, 0.1, 0.5], rpy: [90 deg, 0 deg, 45 deg]}",
        )
    )


def test_entries_of_the_pose_and_points_of_axes_have_letters_of_their_own() -> None:
    text = written()
    assert r"With $\mathit{POS} = (m_{ij})$ its entries are" in text
    assert "p_{3x}" in text
    assert "p_{12}" not in text


def test_lengths_that_cancel_are_left_out() -> None:
    text = written()
    assert r"$\sqrt{Z_1^2 + Z_2^2}$ is greater than $p_{4x}$. The two" in text  # never less than 0
    reach = r"is greater than $p_{4x}$ or less than $2 p_{3x} - p_{4x}$"
    assert reach in written(0.4)
    assert "| $K^2 = Y^2$ | $s_3 = 0$ |" in text
