"""Types 6, 7 and 8: the squares remove one angle, what is left is of type 2."""

from __future__ import annotations

import math
from itertools import permutations
from typing import TYPE_CHECKING

from dhgen.derivation.conditions import are_never_zero, unsigned, without_lengths
from dhgen.derivation.effects import free_effect, merged_effect, nothing_said, point_name
from dhgen.derivation.notation.names import cosine, letter, sine, theta
from dhgen.derivation.step_context import Singularity, StepText, type_letter
from dhgen.derivation.text.blocks import display, paragraph, say
from dhgen.derivation.text.formula import (
    ZERO,
    Formula,
    Minus,
    Size,
    Sum,
    add,
    atan2,
    equal,
    minus,
    over,
    relation,
    root,
    square,
    subtract,
    times,
)
from dhgen.kinematics.algebra import AngleSum
from dhgen.kinematics.ring import constant_value

if TYPE_CHECKING:
    from dhgen.derivation.step_context import StepContext
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.kinematics.constants import Polynomial

X, Y, Z1, Z2 = (type_letter(name) for name in ("X", "Y", "Z1", "Z2"))
K, W = letter("K", "K"), letter("W", "W")
CLOSE = 1e-9  # two lengths nearer than this, relative to their sum, are equal
REACH = add(square(Z1), square(Z2))


def print_two_angles(context: StepContext) -> StepText:
    """The law of cosines for the angle between two links, or an angle by itself."""
    s, c = sine(context.angle), cosine(context.angle)
    x, y, rest = reduced_coefficients(context)
    named = [(letter_, part, f) for letter_, part, f in ((X, x, s), (Y, y, c)) if part]
    left = add(*(times(letter_, function) for letter_, _, function in named))
    lines: list[Formula] = [
        equal(letter_, context.story.write(part, context.number)) for letter_, part, _ in named
    ]
    lines.append(equal(K, subtract(REACH, context.in_full(rest))))
    met, free = _met(context, x, y), _free(context, x, y)
    far = relation(square(K), ">", add(*(square(letter_) for letter_, _, _ in named)))
    blocks: list[Block] = [
        *_squares(context, x, y, rest),
        paragraph("This is {} with", equal(left, K)),
        display(*lines),
        *_solution(context, x, y),
        paragraph(
            "No solution when {}{}. The two solutions meet when {}: {}. Then {}.",
            far,
            _reach(context),
            met.condition,
            met.meaning,
            met.effect,
        ),
    ]
    if free is None:
        return StepText(tuple(blocks), (met,))
    text = "Degenerate when {}: {}. Then {}."
    blocks.append(paragraph(text, free.condition, free.meaning, free.effect))
    return StepText(tuple(blocks), (met, free))


def _squares(context: StepContext, x: Polynomial, y: Polynomial, rest: Polynomial) -> list[Block]:
    """The equation that the sum of the squares gives."""
    known = [each.right if each.joints_left else each.left for each in context.quotes]
    stand = all(context.polynomial(name) in known for name in ("Z1", "Z2"))
    moved = "With the known terms moved to the right, the right sides are"
    called: list[Block] = [
        paragraph("The right sides are" if stand else moved),
        display(context.definition("Z1"), context.definition("Z2")),
    ]
    if is_elimination(context):
        text = (
            "With the terms of the other angle on a side of their own, the sum of the squares "
            "depends on {} only."
        )
        return [*called, paragraph(text, theta(context.angle))]
    algebra = context.story.algebra
    s, c = (algebra.generator(name) for name in (context.angle.sine, context.angle.cosine))
    text = "and the sum of the squares of both equations depends on {} alone{}:"
    return [
        *called,
        paragraph(text, theta(context.angle), _difference(context)),
        display(equal(context.story.write_forward(x * s + y * c + rest), REACH)),
    ]


def _difference(context: StepContext) -> Prose:
    """That the step's angle is the difference of the equations' two, where it is."""
    angles = [u for u in context.step.forms[0].unknowns if isinstance(u, AngleSum)]
    for first, second in permutations(angles, 2):
        terms = dict(first.terms)
        for joint, facing in second.terms:
            terms[joint] = terms.get(joint, 0) - facing
        if {joint: facing for joint, facing in terms.items() if facing} == dict(
            context.angle.terms
        ):
            difference = subtract(theta(first), theta(second))
            return say(", because {}", equal(difference, theta(context.angle)))
    return say("")


def reduced_coefficients(context: StepContext) -> tuple[Polynomial, Polynomial, Polynomial]:
    """X, Y and N of X s + Y c = Z1^2 + Z2^2 - N for the step's angle."""
    letters = dict(context.step.coefficients)
    rest = -letters["N"] if is_elimination(context) else letters["N"]
    return letters["X"], letters["Y"], rest


def is_elimination(context: StepContext) -> bool:
    """Whether the step's angle is one of the equations' own, not their difference."""
    return context.angle in context.step.forms[0].unknowns and "Z" in dict(
        context.step.coefficients
    )


def _solution(context: StepContext, x: Polynomial, y: Polynomial) -> list[Block]:
    s, c = sine(context.angle), cosine(context.angle)
    sign = context.sign
    name = theta(context.angle)
    if x and y:
        radicand = subtract(add(square(X), square(Y)), square(K))
        solution = atan2(add(times(X, K), times(Y, W)), subtract(times(Y, K), times(X, W)))
        return [
            paragraph(
                "The squares of {} and {} add up to {}, so",
                add(times(X, s), times(Y, c)),
                subtract(times(Y, s), times(X, c)),
                add(square(X), square(Y)),
            ),
            display(
                equal(W, subtract(times(Y, s), times(X, c)), times(sign, root(radicand))),
                equal(name, solution),
            ),
        ]
    return [display(*by_one_function(context, Y if y else X, K, by_cosine=bool(y)))]


def by_one_function(
    context: StepContext, factor: Formula, right: Formula, *, by_cosine: bool
) -> tuple[Formula, ...]:
    """Y c = Z or X s = Z: the cosine or the sine is known, the other up to its sign."""
    s, c = sine(context.angle), cosine(context.angle)
    known, other = (c, s) if by_cosine else (s, c)
    sign = context.sign if by_cosine else minus(context.sign)
    length = root(subtract(square(factor), square(right)))
    return (
        equal(known, over(right, factor)),
        equal(other, over(times(sign, length), factor)),
        equal(theta(context.angle), atan2(s, c)),
    )


def _met(context: StepContext, x: Polynomial, y: Polynomial) -> Singularity:
    algebra = context.story.algebra
    s, c = (algebra.generator(name) for name in (context.angle.sine, context.angle.cosine))
    condition = equal(square(K), add(*(square(n) for n, part in ((X, x), (Y, y)) if part)))
    joints = None
    in_column = all(origin.column == 4 for origin in context.step.origins)
    point = point_name(context) if in_column else say("the arm")
    meaning = say("{} is at the edge of its reach", point)
    if context.is_constant("V1", "V2", "W1", "W2"):
        if not is_elimination(context):
            shared = without_lengths(algebra, algebra.normal(y * s - x * c))
            joints = equal(unsigned(context.story, shared), ZERO)
        meaning = say("the arm is stretched or folded")
    return Singularity(context.number, condition, joints, meaning, merged_effect(context))


def _free(context: StepContext, x: Polynomial, y: Polynomial) -> Singularity | None:
    """Where the equations lose the angle, if that may be: K, too, has to vanish with X and Y.

    Of the three vectors that add up to nothing one has no length then, so that the others are
    equally long.
    """
    algebra = context.story.algebra
    if algebra.is_constant(x) and algebra.is_constant(y):
        return None
    if are_never_zero(algebra, x, y):
        return None
    vectors = ([context.step.coefficient(name + part) for part in "12"] for name in "VWZ")
    fixed = [parts for parts in vectors if all(map(algebra.is_constant, parts))]
    lengths = [math.hypot(*(constant_value(algebra, part) for part in parts)) for parts in fixed]
    if len(lengths) == 2 and abs(lengths[0] - lengths[1]) > CLOSE * sum(lengths):
        return None
    text = "two links of equal length are folded upon each other, and " + nothing_said(context)
    meaning = say(text, theta(context.angle))
    named = [letter_ for letter_, part in ((X, x), (Y, y)) if part]
    condition = equal(*named, K, ZERO)
    return Singularity(context.number, condition, None, meaning, free_effect(context), frees=True)


def _reach(context: StepContext) -> Prose:
    """The longest and the shortest reach, for two links of fixed length."""
    if not context.is_constant("V1", "V2", "W1", "W2"):
        return say("")
    (v, v_value), (w, w_value) = _length(context, "V"), _length(context, "W")
    longest, shortest = add(v, w), subtract(v, w) if v_value >= w_value else subtract(w, v)
    first, second = _signed(context, "V"), _signed(context, "W")
    if first is not None and second is not None:
        longest = _collected(context, first + second, longest)
        difference = first - second if v_value >= w_value else second - first
        shortest = _collected(context, difference, shortest)
    if abs(v_value - w_value) <= CLOSE * (v_value + w_value):
        return say(": {} is greater than {}", root(REACH), longest)
    text = ": {} is greater than {} or less than {}"
    return say(text, root(REACH), longest, shortest)


def _signed(context: StepContext, name: str) -> Polynomial | None:
    """The length of a vector with one coordinate."""
    parts = [part for each in "12" if (part := context.polynomial(name + each))]
    if len(parts) != 1:
        return None
    return -parts[0] if constant_value(context.story.algebra, parts[0]) < 0.0 else parts[0]


def _collected(context: StepContext, length: Polynomial, formula: Formula) -> Formula:
    """A length as it is when terms of a sum cancel, or else the sum."""
    terms = len(formula.terms) if isinstance(formula, Sum) else 1
    return context.in_full(length) if len(length) < terms else formula


def _length(context: StepContext, name: str) -> tuple[Formula, float]:
    """The length of a vector, as a formula and as a number."""
    names = [name + part for part in "12" if context.polynomial(name + part)]
    values = [constant_value(context.story.algebra, context.polynomial(each)) for each in names]
    size = sum(value * value for value in values) ** 0.5
    if len(names) > 1:
        return root(add(*(square(context.value(each)) for each in names))), size
    formula = context.value(names[0])
    if isinstance(formula, Sum):
        return (minus(formula) if values[0] < 0.0 else formula), size
    negative = (values[0] < 0.0) != isinstance(formula, Minus)
    bare = formula.operand if isinstance(formula, Minus) else formula
    return (Size(bare) if negative else bare), size
