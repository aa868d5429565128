"""Numbers of the nearest arm with a structure that every language needs."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain

APART = 2  # what its closed form is given last: by how much two arms' tools are turned and apart


def nearest_angles(chain: Chain) -> list[list[float]]:
    """The angles of an arm, each as the factors of all joint values and what is added."""
    drives = chain.drives
    return [
        [*row, offset] for row, offset in zip(drives.matrix.tolist(), drives.offsets, strict=True)
    ]
