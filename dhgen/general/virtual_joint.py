"""One more joint for an arm that has one too few for its task: a turn that has to be zero.

Five joints take a pose only if it lies on a surface of five dimensions among the poses, which has
six. With any turn behind the fifth joint the arm takes every pose nearby, and the solutions whose
sixth angle is zero are those of the five joints. Four joints whose tool only points are alike.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.general.links import Link
from dhgen.kinematics.rigid import IDENTITY, Matrix, inverse, scaled

if TYPE_CHECKING:
    from collections.abc import Sequence


# From the frame of the last joint to that of the turn [arm sizes]: skew to its axis, at a distance
# that is neither short nor long, and parallel to none of the frame's axes.
BEYOND: Matrix = (
    (2 / 7, 3 / 7, 6 / 7, 0.4),
    (6 / 7, 2 / 7, -3 / 7, 0.3),
    (-3 / 7, 6 / 7, -2 / 7, -0.2),
    (0.0, 0.0, 0.0, 1.0),
)
# An angle above this [rad] belongs to a pose that the arm does not take: rounding of a
# pose, as far as it is accepted, is a thousand times less, and the angle is more only where the
# arm is nearly singular. Where the certificate fails, or solutions meet, it may be: then the second
# bound holds.
NEARLY_NONE = 0.01
NEARLY_NONE_IN_DOUBT = 0.1


def with_virtual_joint(links: Sequence[Link], size: float) -> list[Link]:
    """C0 ... C6 of six joints from C0 ... C5 of five: C5 becomes W J6 W⁻¹ C5; or of fewer.

    Args:
        links: Constant transforms, one more than the joints [file's unit].
        size: Of the arm [file's unit].
    """
    beyond = scaled(BEYOND, size)
    return [*links[:-1], Link(beyond), links[-1].between(inverse(beyond), IDENTITY)]
