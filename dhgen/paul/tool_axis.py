"""Where the tool's z axis meets the axis of the last joint: that point is known from the pose.

A task that names the position of the tool and the direction of its z axis gives every point of that
axis. The last joint turns the tool's origin, but not the point on its own axis.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.chain import Turn
from dhgen.kinematics.product import product
from dhgen.kinematics.ring import used_places
from dhgen.kinematics.transform import Transform, identity, translation
from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.chain import Element
    from dhgen.kinematics.constants import Polynomial

ROOTS = {"sqrt2", "sqrt3"}


def way_from_the_last_axis(algebra: Algebra, link: tuple[Element, ...]) -> Transform:
    """The translation along the tool's z axis from the last axis, if they meet, to its origin.

    Args:
        algebra: The arm's ring.
        link: The elements of A_n E.
    """
    still = identity(algebra.ring)
    chain = algebra.chain
    last = next((place for place, element in enumerate(link) if isinstance(element, Turn)), None)
    if chain.task.kind is not TaskKind.POINTING or last is None or chain.dof in chain.free:
        return still
    behind = product(link[last + 1 :], algebra)
    length = _length(algebra, behind)
    zero = algebra.ring.zero
    return still if length is None else translation(algebra.ring, (zero, zero, length))


def _length(algebra: Algebra, behind: Transform) -> Polynomial | None:
    """How far the origin is from the z axis, along the direction of column 3."""
    (x, y, _), (along_x, along_y, _) = behind.translation, behind.column(2)
    if not (x or y) or algebra.normal(x * along_y - y * along_x):
        return None
    offset, lean = (x, along_x) if along_x else (y, along_y)
    back = _inverse(algebra, lean)
    return None if back is None else algebra.normal(offset * back)


def _inverse(algebra: Algebra, number: Polynomial) -> Polynomial | None:
    """1 over a number that is one term of roots; None for others."""
    names = [algebra.ring.symbols[place].name for place in used_places(number)]
    if len(number) != 1 or not set(names) <= ROOTS:
        return None
    square = algebra.normal(number * number)
    return algebra.normal(number * (1 / square.coeff(1)))
