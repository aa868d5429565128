"""By how much axes miss being parallel, square or meeting, where that is little and no snapping."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

from dhgen.descriptions.lines import are_parallel, common_normal
from dhgen.descriptions.rotations import cross, dot
from dhgen.descriptions.snap import MOST

if TYPE_CHECKING:
    from dhgen.descriptions.lines import Arm, Axis

TILT = 0.02  # [rad] beyond, an angle is meant: so much 1.55 is off
GAP = 2e-3  # [arm sizes] and so is a length
SHOWN = 4


class Miss(NamedTuple):
    """Two neighbours and what they nearly are.

    Attributes:
        text: For people.
        off: By how much they miss it [rad, or arm sizes].
    """

    text: str
    off: float


def misses(arm: Arm, unit: str) -> str | None:
    """What is nearly so and is kept as it is, lengths in a unit; None where nothing is."""
    return _told(_all_misses(arm, unit))


def misses_note(arm: Arm) -> str | None:
    """The note on misses of a description, with the option that takes them as exact."""
    found = _all_misses(arm, "m")
    if not found:
        return None
    needed = [_rounded_up(miss.off) for miss in found]
    taken = [each for each in needed if float(each) <= MOST]
    if not taken:
        why = f"--snap takes at most {MOST:g} as exact"
        return f"{_told(found)}; if that is not meant, change the description: {why}"
    what = "it" if len(taken) == len(needed) else "what misses by less"
    advised = f"dhgen import --snap {max(taken, key=float)} takes {what} as exact"
    return f"{_told(found)}; if that is not meant, {advised}"


def _told(found: list[Miss]) -> str | None:
    if not found:
        return None
    shown = "; ".join(miss.text for miss in found[:SHOWN])
    more = f"; and {len(found) - SHOWN} more" if len(found) > SHOWN else ""
    return f"kept as it is: {shown}{more}"


def _all_misses(arm: Arm, unit: str) -> list[Miss]:
    return [
        miss
        for number, (one, other) in enumerate(pairwise(arm.axes), 1)
        for miss in _misses(arm, number, one, other, unit)
    ]


def _misses(arm: Arm, number: int, one: Axis, other: Axis, unit: str) -> list[Miss]:
    axes = f"axes {number} and {number + 1}"
    u, v = one.direction, other.direction
    tilt = math.atan2(math.hypot(*cross(u, v)), abs(dot(u, v)))
    found = []
    if arm.near <= tilt < TILT:
        found.append(Miss(f"{axes} miss being parallel by {tilt:.2g} rad", tilt))
    slope = math.pi / 2 - tilt
    if arm.near <= slope < TILT:
        found.append(Miss(f"{axes} miss a right angle by {slope:.2g} rad", slope))
    if one.turns and other.turns and not are_parallel(u, v, TILT):
        _, foot, landing = common_normal((one.point, u), (other.point, v))
        gap = math.dist(foot, landing)
        if arm.negligible <= gap < GAP * arm.size:
            length = f"{1e3 * gap:.3g} mm" if unit == "m" else f"{gap:.3g} {unit}"
            found.append(Miss(f"{axes} miss each other by {length}", gap / arm.size))
    return found


def _rounded_up(value: float) -> str:
    """One digit, not below the value."""
    power = 10.0 ** math.floor(math.log10(value))
    return f"{math.ceil(value / power * 1.01) * power:.0e}".replace("e-0", "e-")
