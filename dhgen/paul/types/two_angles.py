"""Types 6, 7 and 8: two equations that are one equation between turned vectors of the plane.

With the first equation as the real and the second as the imaginary part, all three types read

    V exp(i p) + W exp(i q) = Z,

where p and q are angle sums (one may run backwards). The square of the size of
W exp(i q) = Z - V exp(i p) removes q, and the square of Z = ... leaves only the difference p - q:
each is of type 2. Where Z is zero the two vectors are opposite at every pose: p - q has one value,
which no square root is needed for, and rounding would make two of it.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.paul.form import is_multiple
from dhgen.paul.kind import Kind
from dhgen.paul.step import Step, placing

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.kinematics.algebra import AngleSum
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.form import Form
    from dhgen.paul.knowledge import Cut, Knowledge
    from dhgen.paul.step import Offer, Products, View

    Term = tuple[int, Polynomial, Polynomial]

BY_DIFFERENCE = 100
BY_ELIMINATION = 240
VARIABLE_FACTORS = 60
NOT_A_SUM = 10  # type 8 has two links, the usual shape


class TwoAngles:
    """Types 6, 7 and 8, two values for one angle; the other follows by type 3."""

    name = "types 6 to 8"
    arity = 2
    anywhere = False
    ordered = False

    def steps(self, forms: Sequence[Form], view: View) -> Offer:
        """Up to three steps: for the difference of the angles, and for each of them.

        Or why the equations are not one vector equation in two angles.
        """
        read = _read(forms)
        if isinstance(read, str):
            return read
        if any(_vanishes(vector, view) for vector in (read.v, read.w)):
            return "a coefficient vanishes on every solution"
        if not any(read.known):
            return "no known side: the two vectors are opposite, and their difference has one value"
        difference = _difference(read.v, read.w, view.knowledge)
        kind = _kind(read.v, read.w, difference)
        found = () if difference is None else (_by_difference(read, difference, kind, view),)
        if kind is Kind.ANGLE_AND_SUM:
            return found
        both = (read, read.swapped())
        return (*found, *(_by_elimination(each, kind, view) for each in both))


@dataclass(frozen=True, slots=True)
class Turned:
    """The vector (re, im) turned by an angle sum, forwards (+1) or backwards (-1)."""

    angle: AngleSum
    sense: int
    re: Polynomial
    im: Polynomial


@dataclass(frozen=True, slots=True)
class _Vectors:
    """The vector equation v + w = known, with v and w turned by two angles."""

    forms: tuple[Form, Form]
    v: Turned
    w: Turned
    known: tuple[Polynomial, Polynomial]

    def swapped(self) -> _Vectors:
        """The pair with w first."""
        return _Vectors(self.forms, self.w, self.v, self.known)

    @property
    def letters(self) -> tuple[tuple[str, Polynomial | Products], ...]:
        """The components by name."""
        return (
            ("V1", self.v.re),
            ("V2", self.v.im),
            ("W1", self.w.re),
            ("W2", self.w.im),
            ("Z1", self.known[0]),
            ("Z2", self.known[1]),
        )


def _read(forms: Sequence[Form]) -> _Vectors | str:
    """The vector equation, or why the two equations are none."""
    first, second = forms
    if first.unknowns != second.unknowns or len(first.unknowns) != 2:
        return "not the same two unknowns"
    angles = first.two_angles
    if angles is None:
        return "the unknowns are not two angles"
    names = [name for angle in angles for name in (angle.cosine, angle.sine)]
    linear = [(), *((name,) for name in names)]
    if not (first.within(linear) and second.within(linear)):
        return "not linear in the cosines and sines"
    v, w = (_turned(first, second, angle) for angle in angles)
    if v is None or w is None:
        return "the coefficients are not those of a rotated vector"
    return _Vectors((first, second), v, w, (-first.coefficient(), -second.coefficient()))


def _turned(first: Form, second: Form, angle: AngleSum) -> Turned | None:
    """The two equations' part in one angle as a turned vector, when it is one."""
    c1, s1 = first.coefficient(angle.cosine), first.coefficient(angle.sine)
    c2, s2 = second.coefficient(angle.cosine), second.coefficient(angle.sine)
    for sense in (1, -1):
        if is_multiple(s1, c2, -sense) and is_multiple(s2, c1, sense):
            return Turned(angle, sense, c1, c2)
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


def _by_difference(
    vectors: _Vectors, difference: tuple[AngleSum, int], kind: Kind, view: View
) -> Step:
    """2 Re(v conj(w) exp(i (p - q))) = |Z|^2 - |v|^2 - |w|^2."""
    v, w, (angle, sign) = vectors.v, vectors.w, difference
    re = view.products((2, v.re, w.re), (2, v.im, w.im))
    im = view.products((-2 * sign, v.im, w.re), (2 * sign, v.re, w.im))
    rest = (*_square(1, v.re, v.im), *_square(1, w.re, w.im))
    letters = (*vectors.letters, ("X", im), ("Y", re), ("N", view.products(*rest)))
    penalty = BY_DIFFERENCE + placing(vectors.forms[0])
    if not (view.is_constant_sum(re) and view.is_constant_sum(im)):
        penalty += VARIABLE_FACTORS
        minus_rest = tuple((-n, f, g) for n, f, g in rest)
        letters = (*letters, ("Z", view.products(*_square(1, *vectors.known), *minus_rest)))
    if kind is not Kind.ANGLE_AND_SUM:
        penalty += NOT_A_SUM
    return Step(kind, (angle,), vectors.forms, letters, penalty)


def _by_elimination(vectors: _Vectors, kind: Kind, view: View) -> Step:
    """2 Re(v exp(i p) conj(Z)) = |Z|^2 + |v|^2 - |w|^2."""
    v, w = vectors.v, vectors.w
    rest = (*_square(1, v.re, v.im), *_square(-1, w.re, w.im))
    length = sum(len(part) for part in vectors.known)
    penalty = BY_ELIMINATION + placing(vectors.forms[0]) + length
    z1, z2 = vectors.known
    along = view.products((2, v.re, z1), (2, v.im, z2))
    across = view.products((2 * v.sense, v.re, z2), (-2 * v.sense, v.im, z1))
    total = view.products(*_square(1, z1, z2), *rest)
    letters = (*vectors.letters, ("N", view.products(*rest)))
    letters = (*letters, ("X", across), ("Y", along), ("Z", total))
    return Step(kind, (v.angle,), vectors.forms, letters, penalty)


def _square(sign: int, x: Polynomial, y: Polynomial) -> tuple[Term, Term]:
    """x^2 + y^2 with a sign, as terms of a sum of products."""
    return (sign, x, x), (sign, y, y)
