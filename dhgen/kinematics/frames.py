"""Constant frames (base, tool, home) as transforms of ring elements."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.transform import Transform

if TYPE_CHECKING:
    from dhgen.kinematics.constants import ConstantTable
    from dhgen.robot.robot import Frame


def read_frame(frame: Frame, table: ConstantTable, letter: str, meaning: str) -> Transform:
    """A constant frame; its numbers get names that begin with `letter`."""
    rotation = [
        table.scalar(
            entry,
            f"{letter}{place // 3 + 1}{place % 3 + 1}",
            f"{meaning}, entry {place // 3 + 1},{place % 3 + 1}",
        )
        for place, entry in enumerate(frame.rotation)
    ]
    origin = [
        table.length(entry, f"{letter}{axis}", f"{axis} of the {meaning}")
        for axis, entry in zip("xyz", frame.xyz, strict=True)
    ]
    rows = tuple(tuple(rotation[3 * row : 3 * row + 3]) for row in range(3))
    return Transform(rows, tuple(origin))
