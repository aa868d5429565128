"""Types 6, 7 and 8: two equations that are one equation between turned vectors of the plane.

With the first equation as the real and the second as the imaginary part, all three types read

    V exp(i p) + W exp(i q) = Z,

where p and q are angle sums (one may run backwards). The square of the size of W exp(i q) = Z - V exp(i p)
removes q, and the square of Z = ... leaves only the difference p - q: each is of type 2.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum
from dhgen.paul.step import Kind, Step, placing

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.forms import Form
    from dhgen.paul.knowledge import Cut, Knowledge
    from dhgen.paul.step import View

BY_DIFFERENCE = 100
BY_ELIMINATION = 240


@dataclass(frozen=True, slots=True)
class Turned:
    """The vector (re, im) turned by an angle sum, forwards (+1) or backwards (-1)."""

    angle: AngleSum
    sense: int
    re: Polynomial
    im: Polynomial


class TwoAngles:
    """Types 6, 7 and 8, two values for one angle; the other follows by type 3."""

    name = "types 6 to 8"
    arity = 2

    def why_not(self, forms: Sequence[Form], view: View) -> str | None:
        """Why the equations are not one vector equation in two angles."""
        first, second = forms
        if first.unknowns != second.unknowns or len(first.unknowns) != 2:
            return "not the same two unknowns"
        angles = [angle for angle in first.unknowns if isinstance(angle, AngleSum)]
        if len(angles) != 2:
            return "the unknowns are not two angles"
        names = [name for angle in angles for name in (angle.cosine, angle.sine)]
        linear = [(), *((name,) for name in names)]
        if not (first.within(linear) and second.within(linear)):
            return "not linear in the cosines and sines"
        turned = [_turned(first, second, angle) for angle in angles]
        if None in turned:
            return "the coefficients are not those of a turned vector"
        if any(_vanishes(vector, view) for vector in turned if vector is not None):
            return "a coefficient vanishes on every solution"
        return None

    def steps(self, forms: Sequence[Form], view: View) -> Iterator[Step]:
        """Up to three steps: for the difference of the angles, and for each of them."""
        first, second = forms
        vectors = [
            vector
            for angle in first.unknowns
            if isinstance(angle, AngleSum)
            and (vector := _turned(first, second, angle)) is not None
        ]
        v, w = vectors
        known = (-first.coefficient(), -second.coefficient())
        difference = _difference(v, w, view.knowledge)
        kind = _kind(v, w, difference)
        if difference is not None:
            yield _by_difference(v, w, known, difference, kind, (first, second), view)
        for kept, removed in ((v, w), (w, v)):
            step = _by_elimination(kept, removed, known, kind, (first, second), view)
            if step is not None:
                yield step


def _turned(first: Form, second: Form, angle: AngleSum) -> Turned | None:
    """The two equations' part in one angle as a turned vector, when it is one."""
    c1, s1 = first.coefficient(angle.cosine), first.coefficient(angle.sine)
    c2, s2 = second.coefficient(angle.cosine), second.coefficient(angle.sine)
    if (s1, s2) == (-c2, c1):
        return Turned(angle, 1, c1, c2)
    if (s1, s2) == (c2, -c1):
        return Turned(angle, -1, c1, c2)
    return None


def _vanishes(vector: Turned, view: View) -> bool:
    return view.witnesses.vanishes(vector.re) and view.witnesses.vanishes(vector.im)


def _difference(v: Turned, w: Turned, knowledge: Knowledge) -> tuple[AngleSum, int] | None:
    """The angle sum d and its sign with p - q = sign * d, when the angles are of one run."""
    balance: dict[Cut, int] = {}
    for vector, factor in ((v, 1), (w, -1)):
        start, end, sign = knowledge.runs.ends(vector.angle)
        balance[end] = balance.get(end, 0) + factor * vector.sense * sign
        balance[start] = balance.get(start, 0) - factor * vector.sense * sign
    plus = [cut for cut, count in balance.items() if count == 1]
    minus = [cut for cut, count in balance.items() if count == -1]
    if len(plus) != 1 or len(minus) != 1 or any(abs(n) > 1 for n in balance.values()):
        return None
    if plus[0][0] != minus[0][0] or knowledge.component(plus[0]) == knowledge.component(minus[0]):
        return None
    return knowledge.runs.between(minus[0], plus[0])


def _kind(v: Turned, w: Turned, difference: tuple[AngleSum, int] | None) -> Kind:
    nested = {*v.angle.terms} < {*w.angle.terms} or {*w.angle.terms} < {*v.angle.terms}
    straight = [not vector.re or not vector.im for vector in (v, w)]
    if nested and difference is not None and all(straight) and v.sense == w.sense:
        return Kind.ANGLE_AND_SUM
    return Kind.TWO_ANGLES if any(straight) else Kind.TWO_ANGLES_TURNED


def _square(re: Polynomial, im: Polynomial, view: View) -> Polynomial:
    return view.knowledge.runs.algebra.normal(re * re + im * im)


def _by_difference(
    v: Turned,
    w: Turned,
    known: tuple[Polynomial, Polynomial],
    difference: tuple[AngleSum, int],
    kind: Kind,
    forms: tuple[Form, Form],
    view: View,
) -> Step:
    """2 Re(v conj(w) exp(i (p - q))) = |Z|^2 - |v|^2 - |w|^2."""
    normal = view.knowledge.runs.algebra.normal
    angle, sign = difference
    re = normal(2 * (v.re * w.re + v.im * w.im))
    im = normal(2 * (v.im * w.re - v.re * w.im))
    rest = _square(v.re, v.im, view) + _square(w.re, w.im, view)
    letters = (
        ("V1", v.re), ("V2", v.im), ("W1", w.re), ("W2", w.im), ("Z1", known[0]), ("Z2", known[1]),
        ("X", -im * sign), ("Y", re), ("N", rest),
    )
    penalty = BY_DIFFERENCE + placing(forms[0]) + (0 if view.is_constant(re) and view.is_constant(im) else 60)
    return Step(kind, (angle,), forms, letters, 2, penalty + 10 * (kind is not Kind.ANGLE_AND_SUM))


def _by_elimination(
    kept: Turned,
    removed: Turned,
    known: tuple[Polynomial, Polynomial],
    kind: Kind,
    forms: tuple[Form, Form],
    view: View,
) -> Step | None:
    """2 Re(v exp(i p) conj(Z)) = |Z|^2 + |v|^2 - |w|^2."""
    if not any(known):
        return None
    if kind is Kind.ANGLE_AND_SUM:
        return None
    rest = _square(kept.re, kept.im, view) - _square(removed.re, removed.im, view)
    letters = (
        ("V1", kept.re), ("V2", kept.im), ("W1", removed.re), ("W2", removed.im),
        ("Z1", known[0]), ("Z2", known[1]), ("N", rest),
    )
    penalty = BY_ELIMINATION + placing(forms[0]) + sum(len(part) for part in known)
    return Step(kind, (kept.angle,), forms, letters, 2, penalty)
