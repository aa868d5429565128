"""The ring of an arm's equations: pose entries, cosines and sines, lengths, constants."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from operator import itemgetter
from typing import TYPE_CHECKING

from sympy.polys.domains import QQ
from sympy.polys.rings import PolyRing

from dhgen.kinematics.chain import Chain, Fixed, Slide, parallel_groups
from dhgen.kinematics.normal import NormalForm, normal_form

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.kinematics.chain import Element
    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.transform import Transform

# Row and column, from 0, of the entries of a pose by their names.
POSE_PLACES = {f"t{row + 1}{column + 1}": (row, column) for row in range(3) for column in range(4)}
POSE_NAMES = tuple(POSE_PLACES)
POINTS = 6  # so many, at most, do six unknown joints not move
# no parameter can be called so
SHOULDER_NAMES = tuple(tuple(f"b__{row}{column}" for column in (1, 2, 3)) for row in (1, 2, 3))


@dataclass(frozen=True, slots=True, order=True)
class AngleSum:
    """The sum of the angles of consecutive parallel axes, e.g. theta2 + theta3 - theta4.

    Attributes:
        terms: (joint, sign) pairs in the order of the joints; the first sign is +1.
    """

    terms: tuple[tuple[int, int], ...]

    @property
    def suffix(self) -> str:
        """What follows c and s in the names: 23, 2m3 for a difference, 9_10 beyond nine joints."""
        return _suffix(self.terms)

    @property
    def cosine(self) -> str:
        """Name of its cosine."""
        return "c" + self.suffix

    @property
    def sine(self) -> str:
        """Name of its sine."""
        return "s" + self.suffix


@cache
def _suffix(terms: tuple[tuple[int, int], ...]) -> str:
    # joint 12 is _12, or else it would be called like the sum of joints 1 and 2
    return "".join(
        ("m" if sign < 0 else "") + (str(joint) if joint <= 9 else f"_{joint}")
        for joint, sign in terms
    )


def _ways(angle: AngleSum) -> tuple[tuple[tuple[int, int], ...], tuple[tuple[int, int], ...]]:
    """The terms of a sum, and of the sum's opposite."""
    return angle.terms, tuple((joint, -sign) for joint, sign in angle.terms)


def _is_in(terms: tuple[tuple[int, int], ...], left: Mapping[int, int]) -> bool:
    """Whether angles are among the ones that are left of a sum."""
    return all(left.get(joint, 0) * sign > 0 for joint, sign in terms)


@dataclass(frozen=True, slots=True)
class Algebra:
    """A chain with its ring.

    Attributes:
        chain: The arm.
        ring: Generators: pose entries, points, the shoulder's rotation where the arm angle gives
            it, cosines, sines, lengths, then constants.
        normal: The normal form of this ring.
        angles: Every sum of consecutive parallel axes, single joints included.
        slides: The names of prismatic lengths by joint number.
        points: Names of the coordinates of points.
        index: Position of every generator by name.
    """

    chain: Chain
    ring: PolyRing
    normal: NormalForm
    angles: tuple[AngleSum, ...]
    slides: dict[int, str]
    points: tuple[tuple[str, str, str], ...]
    index: dict[str, int]

    def generator(self, name: str) -> Polynomial:
        """The generator of that name."""
        return self.ring.gens[self.index[name]]

    def cosine_sine(self, terms: tuple[tuple[int, int], ...]) -> tuple[Polynomial, Polynomial]:
        """Cosine and sine of a signed sum of joint angles, in any order and with any first sign.

        One that is no sum of consecutive parallel axes, as passive rows leave it, is written with
        those of such sums.
        """
        first, *others = self._sums_in(terms)
        cosine, sine = self._cosine_sine(first)
        for each in others:
            c, s = self._cosine_sine(each)
            cosine, sine = (
                self.normal(cosine * c - sine * s),
                self.normal(sine * c + cosine * s),
            )
        return cosine, sine

    def _cosine_sine(self, terms: tuple[tuple[int, int], ...]) -> tuple[Polynomial, Polynomial]:
        sign = terms[0][1]
        angle = AngleSum(tuple((joint, sign * each) for joint, each in terms))
        return self.generator(angle.cosine), sign * self.generator(angle.sine)

    def _sums_in(self, terms: tuple[tuple[int, int], ...]) -> list[tuple[tuple[int, int], ...]]:
        """The terms of a sum in as few sums of consecutive parallel axes as it is made of."""
        ordered = tuple(sorted(terms))
        angle = AngleSum(tuple((joint, ordered[0][1] * each) for joint, each in ordered))
        if angle.cosine in self.index:
            return [ordered]
        left, found = dict(terms), []
        longest = sorted(self.angles, key=lambda each: -len(each.terms))
        while any(left.values()):
            found.append(
                next(part for each in longest for part in _ways(each) if _is_in(part, left))
            )
            for joint, sign in found[-1]:
                left[joint] -= sign
        return found

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of all points' coordinates."""
        return tuple(name for point in self.points for name in point)

    def is_constant(self, polynomial: Polynomial) -> bool:
        """Whether a polynomial is made of the arm's lengths and twists alone."""
        first = len(self.ring.gens) - len(self.chain.ring.gens)
        return all(not any(monomial[:first]) for monomial in polynomial)

    def degree(self, *polynomials: Polynomial) -> int:
        """How many lengths are multiplied in these polynomials (0 for the zero polynomial)."""
        constants = [constant.name for constant in self.chain.constants if constant.is_length]
        names = ("t14", "t24", "t34", *self.coordinates, *self.slides.values(), *constants)
        exponents = itemgetter(*(self.index[name] for name in names))
        terms = (monomial for polynomial in polynomials for monomial in polynomial)
        return max(map(sum, map(exponents, terms)), default=0)

    def lift(self, transform: Transform) -> Transform:
        """A constant transform of the chain as a transform of this ring."""
        return transform.mapped(self._lifted_entry)

    def _lifted_entry(self, entry: Polynomial) -> Polynomial:
        """The chain's constants are the last generators of the ring."""
        before = (0,) * (len(self.ring.gens) - len(self.chain.ring.gens))
        return self.ring.from_dict({before + powers: number for powers, number in entry.items()})

    def lifted(self, elements: tuple[Element, ...]) -> tuple[Element, ...]:
        """Elements of the chain with their constants in this ring."""
        return tuple(
            Fixed(self.lift(element.transform)) if isinstance(element, Fixed) else element
            for element in elements
        )


def build_algebra(chain: Chain) -> Algebra:
    """The ring of an arm."""
    angles = tuple(
        AngleSum(tuple((joint, sign * run[start][1]) for joint, sign in run[start : end + 1]))
        for run in parallel_groups(chain)
        for start in range(len(run))
        for end in range(start, len(run))
    )
    apart = [each for each in chain.passive if each.apart]
    angles += tuple(AngleSum(each.terms) for each in apart if each.turns)
    slides = {
        element.joint: f"r{element.joint}"
        for link in chain.links
        for element in link
        if isinstance(element, Slide)
    }
    slides |= {each.terms[0][0]: f"r{each.label}" for each in apart if not each.turns}
    trig = [name for angle in angles for name in (angle.cosine, angle.sine)]
    constants = [symbol.name for symbol in chain.ring.symbols]
    shoulder = [name for row in SHOULDER_NAMES for name in row] if chain.arm_angle else []
    # a joint whose value the caller gives may leave one more unmoved
    numbers = ("", *range(2, POINTS + chain.given + 1))
    points = tuple((f"w{each}x", f"w{each}y", f"w{each}z") for each in numbers)
    names = [
        *POSE_NAMES,
        *(name for point in points for name in point),
        *shoulder,
        *trig,
        *slides.values(),
        *constants,
    ]
    ring = PolyRing(names, QQ)
    return Algebra(
        chain=chain,
        ring=ring,
        normal=normal_form(ring, chain.constants, {a.sine: a.cosine for a in angles}),
        angles=angles,
        slides=slides,
        points=points,
        index={name: position for position, name in enumerate(names)},
    )
