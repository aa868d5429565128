"""Where a combination vanishes, in joint angles."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.geometry import NEAR
from dhgen.derivation.known_functions import by_joints
from dhgen.derivation.notation.matrices import expanded
from dhgen.derivation.text.blocks import say
from dhgen.derivation.text.formula import ZERO, equal
from dhgen.derivation.text.lines import width
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import PLAIN
from dhgen.derivation.text.walk import begins_negative
from dhgen.kinematics.ring import primitive, used_places
from dhgen.paul.witness import build_witnesses

if TYPE_CHECKING:
    from dhgen.derivation.step_context import StepContext
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Prose
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial


NEVER = say("none with the numbers of this arm")
LONGEST = 9  # terms of a condition in joint angles
WIDEST = 130  # visible characters of one
SAME = 1e-9  # how near two values on the witnesses are when they are equal


def other_combination(context: StepContext) -> Polynomial | None:
    """Y s - X c of a step of type 2 by joint angles: another element of the same matrices.

    The pool is searched for an equation whose side with U_0 is this combination, up to its sign
    and a constant.
    """
    story = context.story
    form = story.combination(context.number).form
    found: list[Polynomial] = []
    for equation in story.derivation.pool.equations:
        for sign in (1, -1):
            rest = equation.left - sign * form
            if story.algebra.is_constant(rest):
                value = sign * (equation.right - rest)
                if value and len(value) <= LONGEST:
                    found.append(value)
    if not found:
        return _by_square(context)
    return min(found, key=lambda value: (len(value), str(value)))


def _by_square(context: StepContext) -> Polynomial | None:
    """The sine or cosine of a joint whose square is X^2 + Y^2 on every witness."""
    if context.polynomial("Z"):
        return None
    algebra = context.story.algebra
    witnesses = build_witnesses(context.story.derivation.pool)
    x, y = (witnesses.evaluate(context.polynomial(name)) for name in "XY")
    for angle in algebra.angles:
        for name in (angle.sine, angle.cosine):
            generator = algebra.generator(name)
            if np.max(np.abs(x * x + y * y - witnesses.evaluate(generator) ** 2)) < SAME:
                return generator
    return None


def condition_in_joints(context: StepContext, joints: Polynomial | None) -> Formula | Prose | None:
    """joints = 0, or else the step's other combination, where that is short."""
    if joints is None:
        return vanishing(context, context.story.combination(context.number).form)
    story = context.story
    return equal(unsigned(story, without_lengths(story.algebra, joints)), ZERO)


def vanishing(context: StepContext, *forms: Polynomial) -> Formula | Prose | None:
    """All of some forms = 0 by joints alone, with the signs that read best, where that is short."""
    story = context.story
    algebra = story.algebra
    found: list[Polynomial] = []
    for form in forms:
        joints = by_joints(story, form)
        if joints is None:
            return None
        if joints:
            single_joints = without_lengths(algebra, expanded(algebra, joints))
            found.append(min(without_lengths(algebra, joints), single_joints, key=len))
    if any(map(algebra.is_constant, found)) or are_never_zero(algebra, *found):
        return NEVER
    condition = equal(*dict.fromkeys(unsigned(story, form) for form in found), ZERO)
    return condition if found and width(condition) <= WIDEST else None


def without_lengths(algebra: Algebra, form: Polynomial) -> Polynomial:
    """A form without the numbers and lengths, and sums of them, that all its terms share."""
    _, rest = primitive(form)
    first = len(algebra.ring.gens) - len(algebra.chain.ring.gens)
    moving = {monomial[:first] for monomial in rest}
    if len(moving) == 1:
        still = (0,) * (len(algebra.ring.gens) - first)
        return algebra.ring.from_dict({(*moving.pop(), *still): algebra.ring.domain.one})
    common = tuple(min(powers) for powers in zip(*rest, strict=True))
    lowered = tuple(0 if place < first else power for place, power in enumerate(common))
    return algebra.ring.from_dict(
        {
            tuple(e - p for e, p in zip(monomial, lowered, strict=True)): coefficient
            for monomial, coefficient in rest.terms()
        }
    )


def unsigned(story: Story, polynomial: Polynomial) -> Formula:
    """A polynomial or its opposite: without a leading minus, else by alphabet."""
    choices = [story.write_forward(polynomial), story.write_forward(-polynomial)]
    return min(choices, key=lambda each: (begins_negative(each), show(each, PLAIN)))


LOOKED_AT = 2048  # angles, evenly spread
Terms = list[tuple[float, int, int]]  # a number, and the powers of the cosine and the sine


def are_never_zero(algebra: Algebra, *factors: Polynomial) -> bool:
    """Whether factors are never zero together, as far as numbers show.

    They do if the factors, or some of them, hold the cosine and sine of one angle, and else
    lengths and twists alone: between two of the angles that are looked at, none can change by more
    than its slope allows.
    """
    if len(factors) > 1 and any(are_never_zero(algebra, factor) for factor in factors):
        return True
    constants = frozenset(algebra.index[constant.name] for constant in algebra.chain.constants)
    moving = frozenset().union(*map(used_places, factors)) - constants
    pairs = [(algebra.index[a.cosine], algebra.index[a.sine]) for a in algebra.angles]
    pair = next((pair for pair in pairs if moving <= set(pair)), None)
    if pair is None:
        return False
    each = [_terms(algebra, factor, *pair) for factor in factors]
    half = math.pi / LOOKED_AT
    margin = math.hypot(*(half * _slope(terms) + NEAR * _size(terms) for terms in each))
    angles = (2 * half * k for k in range(LOOKED_AT))
    return all(math.hypot(*(_value(terms, angle) for terms in each)) > margin for angle in angles)


def _terms(algebra: Algebra, factor: Polynomial, cosine: int, sine: int) -> Terms:
    values = {algebra.index[each.name]: each.value for each in algebra.chain.constants}
    found = []
    for powers, coefficient in factor.terms():
        value = int(coefficient.numerator) / int(coefficient.denominator)
        value *= math.prod(number ** powers[place] for place, number in values.items())
        found.append((value, powers[cosine], powers[sine]))
    return found


def _size(terms: Terms) -> float:
    return sum(abs(value) for value, _, _ in terms)


def _slope(terms: Terms) -> float:
    """What the derivative by the angle does not exceed."""
    return sum(abs(value) * (i + j) for value, i, j in terms)


def _value(terms: Terms, angle: float) -> float:
    c, s = math.cos(angle), math.sin(angle)
    return sum(value * c**i * s**j for value, i, j in terms)
