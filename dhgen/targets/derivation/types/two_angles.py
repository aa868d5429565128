"""Types 6, 7 and 8: the squares remove one angle, what is left is of type 2."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.paul.step import Kind
from dhgen.targets.derivation.blocks import display, paragraph, say
from dhgen.targets.derivation.effects import merged_effect
from dhgen.targets.derivation.formula import (
    ZERO,
    Formula,
    Listing,
    Size,
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
from dhgen.targets.derivation.names import cosine, letter, sine, theta
from dhgen.targets.derivation.step_context import Singularity, StepText, type_letter

if TYPE_CHECKING:
    from dhgen.kinematics.constants import Polynomial
    from dhgen.targets.derivation.blocks import Block
    from dhgen.targets.derivation.step_context import StepContext

X, Y, Z1, Z2 = (type_letter(name) for name in ("X", "Y", "Z1", "Z2"))
K = letter("K", "K")


def print_two_angles(context: StepContext) -> StepText:
    """The law of cosines for the angle between two links, or an angle by itself."""
    s, c = sine(context.angle), cosine(context.angle)
    x, y, rest = reduced_coefficients(context)
    write = context.story.write
    reach = add(square(Z1), square(Z2))
    k = subtract(reach, write(rest))
    names = [name for name, value in (("X", x), ("Y", y)) if value]
    left = add(*(times(type_letter(n), s if n == "X" else c) for n in names))
    lines: list[Formula] = [context.definition("Z1"), context.definition("Z2")]
    values = {"X": x, "Y": y}
    lines += [equal(type_letter(n), write(values[n], context.number)) for n in names]
    lines.append(equal(K, k))
    blocks: list[Block] = [
        paragraph(
            "With the known terms on the right, called {} and {}, the sum of the squares of both "
            "equations holds {} alone: {}, where",
            Z1, Z2, theta(context.angle), equal(left, K),
        ),
        display(*lines),
        *_solution(context, x, y),
    ]
    met = _met(context, x, y)
    far = relation(square(K), ">", add(*(square(type_letter(n)) for n in names)))
    blocks.append(
        paragraph(
            "No solution when {}{}. The two solutions meet when the two sides are equal: {}; then {}.",
            far, _reach(context), met.meaning, met.effect,
        )
    )
    return StepText(tuple(blocks), (met,))


def reduced_coefficients(context: StepContext) -> tuple[Polynomial, Polynomial, Polynomial]:
    """X, Y and N of X s + Y c = Z1^2 + Z2^2 - N for the step's angle."""
    step = context.step
    letters = dict(step.coefficients)
    if "X" in letters:
        return letters["X"], letters["Y"], letters["N"]
    sense = -1 if _runs_backwards(context) else 1
    v1, v2, z1, z2 = (letters[name] for name in ("V1", "V2", "Z1", "Z2"))
    normal = context.story.algebra.normal
    x = normal(2 * sense * (z2 * v1 - z1 * v2))
    return x, normal(2 * (z1 * v1 + z2 * v2)), -letters["N"]


def _runs_backwards(context: StepContext) -> bool:
    first = context.step.forms[0]
    return first.coefficient(context.angle.sine) == context.polynomial("V2") != 0


def _solution(context: StepContext, x: Polynomial, y: Polynomial) -> list[Block]:
    s, c = sine(context.angle), cosine(context.angle)
    sign = context.sign
    name = theta(context.angle)
    if x and y:
        w = letter("W", "W")
        radicand = subtract(add(square(X), square(Y)), square(K))
        return [
            display(
                equal(w, subtract(times(Y, s), times(X, c)), times(sign, root(radicand))),
                equal(name, atan2(add(times(X, K), times(Y, w)), subtract(times(Y, K), times(X, w)))),
            )
        ]
    one = subtract(square(Y if y else X), square(K))
    below = Y if y else X
    known, free = over(K, below), over(times(sign if y else minus(sign), root(one)), below)
    lines = (equal(c, known), equal(s, free)) if y else (equal(s, known), equal(c, free))
    return [display(Listing(lines)), display(equal(name, atan2(s, c)))]


def _met(context: StepContext, x: Polynomial, y: Polynomial) -> Singularity:
    s, c = context.story.algebra.generator(context.angle.sine), context.story.algebra.generator(
        context.angle.cosine
    )
    form = context.story.algebra.normal(y * s - x * c)
    names = [n for n, value in (("X", x), ("Y", y)) if value]
    condition = equal(square(K), add(*(square(type_letter(n)) for n in names)))
    joints = None
    if context.is_constant("V1", "V2", "W1", "W2"):
        _, inner = _primitive(form)
        joints = equal(context.story.write_forward(inner), ZERO)
    meaning = say("the arm is stretched or folded")
    if context.step.kind is not Kind.ANGLE_AND_SUM and not context.is_constant("V1", "V2", "W1", "W2"):
        meaning = say("the two circles touch")
    return Singularity(context.number, condition, joints, meaning, merged_effect(context))


def _primitive(form: Polynomial) -> tuple[object, Polynomial]:
    """The form without numbers and lengths that all its terms share."""
    from dhgen.targets.derivation.ring import content, primitive  # noqa: PLC0415

    _, rest = primitive(form)
    return content(rest)


def _reach(context: StepContext) -> object:
    """The longest and the shortest reach, for two links of fixed length."""
    if not context.is_constant("V1", "V2", "W1", "W2"):
        return say("")
    v, w = _length(context, "V"), _length(context, "W")
    return say(
        ": the point with the coordinates {}, {} is farther than {} or nearer than {}",
        Z1, Z2, add(v, w), Size(subtract(v, w)),
    )


def _length(context: StepContext, name: str) -> Formula:
    parts = [context.value(name + part) for part in "12" if context.polynomial(name + part)]
    return root(add(*(square(part) for part in parts)))
