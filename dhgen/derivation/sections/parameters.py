"""The numbers of the arm: the user's parameters, and numbers that the formulas give a letter."""

from __future__ import annotations

import math
import re
from itertools import product
from typing import TYPE_CHECKING

from dhgen.derivation.notation.expressions import expression_symbol, number_symbol
from dhgen.derivation.notation.names import is_primed, letter, parameter, reference_angle
from dhgen.derivation.text.blocks import Given, joined, paragraph, say
from dhgen.derivation.text.formula import Symbol, equal, minus, subtract
from dhgen.derivation.text.walk import symbols_in
from dhgen.kinematics.chain import Fixed
from dhgen.kinematics.constants import TURN_TOLERANCE
from dhgen.kinematics.expressions import multiple_of_pi
from dhgen.kinematics.ring import used_places
from dhgen.robot.expression import Name, Negate, Number, evaluate, parts
from dhgen.robot.robot import DhTable, JointKind

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.derivation.text.formula import Formula, Relation
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.constants import Constant
    from dhgen.robot.expression import Expression
    from dhgen.robot.robot import Parameter


CELLS = ("twist", "the angle")
ANGLES = (*CELLS, "the parameter")
TURNED = ("cosine of", "sine of")
EXACT = 1e-12  # of a length: rounding
DIGITS = 15  # that arithmetic of floating-point numbers leaves right, as a rule


def constant_blocks(story: Story) -> list[Block]:
    """Every letter of the formulas whose value is a number."""
    blocks: list[Block] = []
    constants = _written(story.algebra.chain)
    used = {each.parameter: each for each in constants}
    primed = any(is_primed(each.name) for each in story.robot.parameters)
    shown = [_parameter(each, used.get(each.name), story) for each in story.robot.parameters]
    if shown:
        prime = (
            " A prime distinguishes a parameter from the other meaning of its name."
            if primed
            else ""
        )
        blocks.append(paragraph("Parameters: {}." + prime, joined(shown)))
    made = [each for each in constants if each.parameter is None and each.square is None]
    unsaid = [each for each in made if not _is_of_a_shown_angle(each)]
    if unsaid:
        numbers = joined([_constant(story, each) for each in unsaid])
        blocks.append(paragraph("Further numbers of the table get letters here: {}.", numbers))
    if made:
        blocks += reference_angles(story)
    if any(_is_in_radians(cell) for _, cell in _angles(story, moving=True)):
        blocks.append(paragraph("Angles without a degree sign are in radians."))
    return blocks


def _is_of_a_shown_angle(constant: Constant) -> bool:
    """Whether it is the cosine or sine of a cell of the table."""
    function, of, what = constant.meaning.partition(" of ")
    return f"{function}{of}".strip() in TURNED and what.startswith(CELLS)


def _is_in_radians(cell: Expression) -> bool:
    """Whether an angle is written as a number, and neither in degrees nor in parts of pi."""
    text = expression_symbol(cell).text
    return re.search("[1-9]", text) is not None and not {"°", "π"} & set(text)


def _written(chain: Chain) -> list[Constant]:
    """The constants that occur.

    Of some angles only the cosine does; and of coordinates that agree, only their difference did.
    """
    fixed = [part.transform for link in chain.links for part in link if isinstance(part, Fixed)]
    places = {
        place
        for transform in (*fixed, chain.base, chain.tool)
        for row, column in product(range(3), range(4))
        for place in used_places(transform.entry(row, column))
    }
    used = {chain.ring.symbols[place].name for place in places}
    return [
        each
        for each in chain.constants
        if each.name in used or each.parameter or not (each.cosine or each.is_length)
    ]


def _parameter(each: Parameter, constant: Constant | None, story: Story) -> Prose:
    written = each.expression
    plain = isinstance(written, Number) or (
        isinstance(written, Negate) and isinstance(written.operand, Number)
    )
    shown = expression_symbol(written)
    if shown.text.endswith("°"):
        return say("{}", equal(parameter(each.name), shown))
    value = each.value if plain else float(f"{each.value:.{DIGITS}g}")
    sides = [parameter(each.name), *([] if plain else [shown]), number_symbol(value)]
    is_length = constant is not None and constant.is_length
    is_length = is_length or each.name in _lengths_that_make_others(story)
    unit = say(" {}", Given(story.robot.length_unit)) if is_length else say("")
    if constant is None and _is_an_angle(each.name, story):
        unit = say(" rad")
    return say("{}{}", equal(*sides), unit)


def _lengths_that_make_others(story: Story) -> set[str]:
    """Parameters of which a length is made: twice they are twice that.

    Such a length is another parameter, or what is added to the variable of a prismatic joint.
    """
    values = {each.name: each.value for each in story.robot.parameters}
    lengths = {each.parameter for each in story.algebra.chain.constants if each.is_length}
    made = [each.expression for each in story.robot.parameters if each.name in lengths]
    geometry = story.robot.geometry
    if isinstance(geometry, DhTable):
        made += [row.d for row in geometry.rows if row.kind is JointKind.PRISMATIC]
    found: set[str] = set()
    for each in made:
        names = {part.name for part in parts(each) if isinstance(part, Name)}
        if names:
            once = evaluate(each, values)
            twice = evaluate(each, values | {name: 2.0 * values[name] for name in names})
            found |= names if abs(twice - 2.0 * once) < EXACT * abs(once) else set()
    return found


def _is_an_angle(name: str, story: Story) -> bool:
    """Whether a parameter is in an angle of the table, or its cosine or sine is a letter."""
    if any(Name(name) in parts(cell) for _, cell in _angles(story, moving=True)):
        return True
    meanings = tuple(f"{function} the parameter {name}" for function in TURNED)
    return any(each.meaning in meanings for each in story.algebra.chain.constants)


def _constant(story: Story, constant: Constant) -> Prose:
    unit = say(" {}", Given(story.robot.length_unit)) if constant.is_length else say("")
    symbol = story.letters[constant.name]
    value = number_symbol(constant.value)
    return say("{}{} ({})", equal(symbol, value), unit, _named(_meaning(constant)))


def _named(meaning: str) -> Prose:
    """What a number is; a parameter of that name is the user's."""
    before, parameter_, rest = meaning.partition("the parameter ")
    name, comma, after = rest.partition(",")
    if not parameter_:
        return say(meaning)
    return say(f"{before}{parameter_}{{}}{comma}{after}", Given(name))


def _meaning(constant: Constant) -> str:
    """What a number is; an angle inside a frame's rotation is not one entry of it."""
    function, of, what = constant.meaning.partition(" of ")
    if f"{function}{of}".strip() not in TURNED:
        return constant.meaning
    if not what.startswith(ANGLES):
        place = re.sub(r"^(.*), entry .*", r"the \1", what)
        what = f"an angle in {place}"
    return f"{function} of {what}{_unsigned(function, constant)}"


def _unsigned(function: str, constant: Constant) -> str:
    """A clause for a cosine or sine that is less than zero."""
    if constant.angle is None:
        return ""
    value = math.cos(constant.angle) if function == "cosine" else math.sin(constant.angle)
    return "" if value > 0.0 else ", without its sign"


PI = Symbol(r"\pi", "π")
PI_HALF = Symbol(r"\pi/2", "π/2")


def reference_angles(story: Story) -> list[Block]:
    """A sentence with the angles of the table that are not the letters' angles."""
    found = list(_relations(story))
    if not found:
        return []
    shown = joined([say("{}", each) for each in found])
    if any("^" in side.text for each in found for side in symbols_in(each)):
        return [paragraph("A hat marks an angle between 0 and {}: {}.", PI_HALF, shown)]
    return [paragraph("Angles of one size share its letters: {}.", shown)]


def _relations(story: Story) -> Iterator[Relation]:
    """α_3 = π - α_3^ and such, in the order of the table."""
    constants = story.algebra.chain.constants
    pairs = {
        math.atan2(sine.value, cosine.value): reference_angle(sine, constants)
        for sine in constants
        for cosine in constants
        if sine.cosine == cosine.name
    }
    for symbol, cell in _angles(story):
        turns = multiple_of_pi(cell)
        if turns is not None and (turns * 12).denominator == 1:
            continue
        values = {each.name: each.value for each in story.robot.parameters}
        angle = math.remainder(evaluate(cell, values), 2.0 * math.pi)
        size = min(abs(angle), math.pi - abs(angle))
        near = (of for value, of in pairs.items() if abs(value - size) < 2 * TURN_TOLERANCE)
        reference = next(near, None)
        if reference is not None and reference != symbol:
            yield equal(symbol, _turned(angle, reference))


def _turned(angle: float, reference: Symbol) -> Formula:
    """An angle by the one between 0 and pi/2."""
    folded = abs(angle) > math.pi / 2
    if angle >= 0.0:
        return subtract(PI, reference) if folded else reference
    return subtract(reference, PI) if folded else minus(reference)


def _angles(story: Story, *, moving: bool = False) -> Iterator[tuple[Symbol, Expression]]:
    """The angles of the table that do not move, with their letters; or offsets of moving ones, too.

    Args:
        story: The arm.
        moving: Whether angles of revolute joints are asked for as well.
    """
    geometry = story.robot.geometry
    if not isinstance(geometry, DhTable):
        return
    for label, row in zip(geometry.labels, geometry.rows, strict=True):
        if moving or row.kind is JointKind.PRISMATIC:
            yield letter(r"\theta", "θ", label), row.theta
        yield letter(r"\alpha", "α", label), row.alpha
