"""A step of a derivation: which equations, of which type, give which unknown."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Protocol

from dhgen.kinematics.algebra import AngleSum
from dhgen.paul.equation import common_origins
from dhgen.paul.form import Length
from dhgen.paul.witness import OWN_LENGTHS, RANDOM_LENGTHS

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.normal import NormalForm
    from dhgen.paul.equation import Origin
    from dhgen.paul.form import Form, Unknown
    from dhgen.paul.kind import Kind
    from dhgen.paul.knowledge import Knowledge
    from dhgen.paul.witness import Witnesses


MIXED_FORM = 15
POINT_FORM = 3
# A divisor is next to nothing: that of a twist of 1.5708, its cosine, would take five digits. It
# costs more than a second root: what a calibration alone makes known is not known.
NEARLY_NOTHING = 12_000
NOTHING = 1e-2
SHORT = 0.06  # of the arm's size: an angle that is divided by it is good to a digit less
FEW_SIZES = 4  # so many lengths of an arm make its size, more or less


@dataclass(frozen=True, slots=True)
class Products:
    """A coefficient that is worked out only where it is used: most steps are never taken.

    Attributes:
        terms: (n, f, g) for every n f g of its sum.
        normal: The normal form.
    """

    terms: tuple[tuple[int, Polynomial, Polynomial], ...]
    normal: NormalForm = field(compare=False)
    _sum: list[Polynomial] = field(default_factory=list, compare=False)

    @property
    def polynomial(self) -> Polynomial:
        """The sum in normal form."""
        if not self._sum:
            self._sum.append(self.normal.products(self.terms))
        return self._sum[0]


@dataclass(frozen=True, slots=True)
class Step:
    """One step.

    Attributes:
        kind: The type of the equations.
        unknowns: What becomes known: one angle sum or length, both (types 4 and 5), or two lengths.
        forms: The equations as they look at this point.
        letters: The type's letters and what they are here, in the type's order.
        penalty: For ranking: how ill-conditioned and how long.
        fallback: Of type 2 with Z = 0: another such step for this angle, whose X and Y differ from
            zero where the step's own vanish.
        degenerate: How many conditions make its equations lose an angle that is not free: one
            is often met, two seldom. 0 where that never happens.
    """

    kind: Kind
    unknowns: tuple[Unknown, ...]
    forms: tuple[Form, ...]
    letters: tuple[tuple[str, Polynomial | Products], ...]
    penalty: int
    fallback: Step | None = None
    degenerate: int = 0

    @property
    def roots(self) -> int:
        """How many values the step gives."""
        return self.kind.value.roots

    @property
    def origins(self) -> tuple[Origin, ...]:
        """Where a reader finds the forms, one place each: in one line of one matrix if possible."""
        equations = [form.equation for form in self.forms]
        return common_origins(equations) or tuple(each.origin for each in equations)

    @property
    def angle(self) -> AngleSum:
        """The angle that becomes known, of types that give one."""
        return next(unknown for unknown in self.unknowns if isinstance(unknown, AngleSum))

    @property
    def lengths(self) -> tuple[Length, ...]:
        """The lengths that become known."""
        return tuple(unknown for unknown in self.unknowns if isinstance(unknown, Length))

    @property
    def length(self) -> Length:
        """The length that becomes known, of types that give one."""
        (length,) = self.lengths
        return length

    @property
    def coefficients(self) -> tuple[tuple[str, Polynomial], ...]:
        """The type's letters and their polynomials."""
        return tuple((letter, _worked_out(value)) for letter, value in self.letters)

    def coefficient(self, letter: str) -> Polynomial:
        """The polynomial behind one of the type's letters."""
        return _worked_out(dict(self.letters)[letter])

    def has(self, letter: str) -> bool:
        """Whether the step has this letter."""
        return letter in dict(self.letters)


def _worked_out(value: Polynomial | Products) -> Polynomial:
    return value.polynomial if isinstance(value, Products) else value


def learn(knowledge: Knowledge, step: Step) -> Knowledge:
    """The state after a step."""
    for unknown in step.unknowns:
        if isinstance(unknown, AngleSum):
            knowledge = knowledge.with_angle(unknown)
        else:
            knowledge = knowledge.with_slide(unknown.joint)
    return knowledge


@dataclass(frozen=True, slots=True)
class View:
    """What a type looks at besides its equations."""

    knowledge: Knowledge
    witnesses: Witnesses

    def is_constant(self, polynomial: Polynomial) -> bool:
        """Whether a coefficient is made of the arm's lengths alone."""
        return self.knowledge.runs.algebra.is_constant(polynomial)

    def is_nearly_nothing(self, *factors: Polynomial) -> bool:
        """Whether factors of one equation are small together wherever the arm is.

        Whatever its lengths are: so are the products of the cosines of nearly right twists.
        """
        unit = self.knowledge.runs.algebra.chain.size / FEW_SIZES
        return self.witnesses.largest(factors, RANDOM_LENGTHS, unit) < NOTHING

    def is_short(self, *factors: Polynomial) -> bool:
        """Whether factors of one equation are small together, with the arm's own lengths.

        What is computed from it is good to as many digits fewer.
        """
        size = self.knowledge.runs.algebra.chain.size
        return self.witnesses.largest(factors, OWN_LENGTHS, size) < SHORT

    def normal(self, polynomial: Polynomial) -> Polynomial:
        """The normal form."""
        return self.knowledge.runs.algebra.normal(polynomial)

    def products(self, *terms: tuple[int, Polynomial, Polynomial]) -> Products:
        """The sum of n f g, to be multiplied out when it is wanted."""
        return Products(terms, self.knowledge.runs.algebra.normal)

    def is_constant_sum(self, products: Products) -> bool:
        """Whether a sum of products is made of the arm's lengths alone.

        Where the witnesses show that it varies, it is not multiplied out.
        """
        if self.witnesses.surely_varies(products.terms):
            return False
        return self.is_constant(products.polynomial)


def placing(form: Form) -> int:
    """A penalty for equations outside U_0 ... U_n, except those of a point that the pose gives."""
    origin = form.equation.origin
    if not origin.is_mixed:
        return 0
    return POINT_FORM if origin.column == 4 else MIXED_FORM


Offer = tuple[Step, ...] | str
"""The steps that equations give, or why they are not of a type."""


def steps_of(offers: Iterable[Offer]) -> tuple[Step, ...]:
    """The steps of all that give some."""
    return tuple(step for offer in offers if not isinstance(offer, str) for step in offer)


class EquationType(Protocol):
    """A type: when it applies, and the steps it gives."""

    name: str
    arity: int
    anywhere: bool  # whether a pair need not be in one column or row
    ordered: bool  # whether the same pair in the other order may give another step

    def steps(self, forms: Sequence[Form], view: View) -> Offer:
        """The steps that the equations give, or why they are not of this type."""
        ...
