"""All real roots of a polynomial on the circle that is known by what computes it.

Its fit has a rounding of 1e-15 of its largest value, all around the circle; where roots crowd, or
come near to the circle, that hides whether there are any. Values that are computed there have their
digits: what may be a double root is looked at again, through a lens of its own. Values lack the
digits that what they are computed from lacks: where they come near to zero, that is asked.
"""

from __future__ import annotations

from dataclasses import replace
from math import cos, pi, sin
from typing import TYPE_CHECKING

from dhgen.general.circle import LIFTED, Roots, Window, roots, trigonometric
from dhgen.general.lens import Lens, sampled
from dhgen.runtime.python.general.tables import CELLS, WIDTH

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.general.lens import At

NOISE = 1e-6  # harmonics beyond the eighth above this: f vanishes identically at this pose
# f may nearly vanish identically: a look with more noise than this does not tell what there is not.
CLEAR = 1e-10
LOOKS = 4  # more closely, at most
# How far a closer look reaches to both sides [rad], nearly, and its cosine from half the tangent.
NEAR = 1 / 16
COSINE = (1 - (NEAR / 2) ** 2) / (1 + (NEAR / 2) ** 2)
# In the middle a lens of this strength magnifies 1 / NEAR times.
STRENGTH = (1 - NEAR) / (1 + NEAR)
# In cells: from tan(ψ/2) = tan(φ/2) / NEAR, NEAR becomes 0.93 rad.
REACH = 38


def real_roots(at: At, vanishes: Callable[[float], bool] = lambda _: True) -> Roots | None:
    """All real roots [rad], None of a polynomial that vanishes identically.

    Args:
        at: Values from the cosines and sines of angles, (24,) each.
        vanishes: Whether what they are computed from allows a root at an angle beside which they
            show none.
    """
    samples, lens = sampled(at)
    f = trigonometric(samples)
    if not f.noise <= NOISE or not samples.any():
        return None
    found = _closer(at, vanishes, _with_lifted(_through(lens, roots(f)), vanishes))
    return replace(found, complete=found.complete and f.noise <= CLEAR)


def _with_lifted(found: Roots, vanishes: Callable[[float], bool]) -> Roots:
    """The places where f turns back beside zero are double roots where there may be any."""
    lifted = filter(vanishes, found.lifted)
    return Roots(found.simple, (*found.double, *lifted), found.complete)


def _closer(at: At, vanishes: Callable[[float], bool], found: Roots) -> Roots:
    """Where roots may be double they are replaced by what a closer look shows, if it shows all."""
    looks: list[float] = []
    unseen: list[float] = []
    clear = True
    while len(looks) < LOOKS:
        places = [x for x in found.double if not any(_near(x, seen) for seen in looks)]
        if not places:
            break
        looks.append(places[0])
        near = _magnified(at, vanishes, places[0])
        clear = clear and near.complete
        if near.complete:
            found = Roots(
                _replaced(found.simple, near.simple, places[0]),
                _replaced(found.double, near.double, places[0]),
                found.complete,
            )
            shown = any(_near(x, places[0]) for x in (*found.simple, *found.double))
            if not shown and vanishes(places[0]):
                unseen.append(places[0])
    # what was given up stands among the double roots
    every = all(any(_near(x, seen) for seen in looks) for x in found.double)
    complete = found.complete or (clear and every)
    return Roots(found.simple, found.double, complete, unseen=tuple(unseen))


def _magnified(at: At, vanishes: Callable[[float], bool], middle: float) -> Roots:
    """The roots around an angle, through a lens that magnifies what is there."""
    lens = Lens(STRENGTH * cos(middle), STRENGTH * sin(middle))
    f = trigonometric(lens.samples(at))
    if not f.noise <= CLEAR:
        return Roots((), (), complete=False)
    window = Window(int(middle % (2 * pi) / WIDTH) % CELLS, REACH, LIFTED / NEAR)
    return _with_lifted(_through(lens, roots(f, window)), vanishes)


def _through(lens: Lens, found: Roots) -> Roots:
    """Roots as they are without the lens."""
    every = found.simple, found.double, found.lifted
    simple, double, lifted = (tuple(map(lens.angle, angles)) for angles in every)
    return Roots(simple, double, found.complete, lifted)


def _replaced(
    before: tuple[float, ...], closer: tuple[float, ...], middle: float
) -> tuple[float, ...]:
    """Of the former what is far from the middle, of the latter what is near."""
    return (
        *(x for x in before if not _near(x, middle)),
        *(x for x in closer if _near(x, middle)),
    )


def _near(x: float, middle: float) -> bool:
    return cos(x - middle) >= COSINE
