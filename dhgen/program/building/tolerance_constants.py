"""Tolerances as constants of a program, with their names and what they are."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node
    from dhgen.program.role import Tolerance

_NAMES = {
    "free": ("free_limit", "a length that fixes no angle"),
    "free_square": ("free_limit_squared", "square of a length that fixes no angle"),
    # the same for regular poses, which end farther from there
    "doubt": ("doubt_limit", "a length that fixes no angle"),
    "doubt_square": ("doubt_limit_squared", "square of a length that fixes no angle"),
    "near": ("near_limit", "a length whose direction is good to few digits"),
    "near_square": (
        "near_limit_squared",
        "square of a length whose direction is good to few digits",
    ),
    "double": ("double_root", "a polynomial's value at a root, relative to its coefficients"),
    "simple": ("simple_root", "its slope at a root that stands for one, relative to them"),
    "reach": ("reach_slack", "rounding at the boundary of the workspace"),
    "none": ("least_root", "a root of nothing, by rounding"),
    "merge": ("merge_slack", "nearer to that boundary two branches are one"),
    "blur": ("blur_slack", "the same where they follow an angle that is good to few digits"),
    "nothing": ("square_rounding", "squares are rounded by this"),
    "longest": ("longest_slide", "no slide is longer"),
    "limit_slack": ("limit_slack", "half of what rounding may take a joint beyond its limit"),
    "steep": ("steep_limit", "a vertical axis, which has no yaw, is no longer seen from above"),
    "consistent": ("pose_slack", "a pose may be rounded by this"),
    "exact": ("exact_slack", "a row that misses the pose by no more is exact"),
    "doubtful": ("doubtful_slack", "a row may miss the pose by this before it is refined"),
}


def tolerance_constant(builder: Builder, role: Tolerance, value: float) -> Node:
    """A tolerance by its name."""
    name, meaning = _NAMES[role.kind]
    return builder.constant(f"{name}{role.degree or ''}", value, meaning, role.degree, role)
