"""Printed formulas as numbers: the letters of a configuration, and what a formula is worth."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.derivation.notation.expressions import expression_symbol
from dhgen.derivation.sections.tables import sign_and_offset
from dhgen.derivation.text.formula import (
    Call,
    Element,
    Matrix,
    Minus,
    Number,
    Power,
    Product,
    Quotient,
    Root,
    Size,
    Sum,
    Symbol,
)
from dhgen.kinematics.algebra import AngleSum
from dhgen.kinematics.arm_angle import triangle
from dhgen.kinematics.chain import Fixed, Slide, Turn
from dhgen.kinematics.numeric import numeric_arm
from tests.kinematics.values import matrix
from tests.kinematics.values import number as value_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.arrays import FloatArray
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.chain import Chain

Value = Any  # a number or a matrix
Letters = dict[str, Value]


def evaluate(formula: Formula | None, letters: Letters) -> Value:
    """A formula's value; KeyError where a letter has none."""
    match formula:
        case Symbol(text=text):
            return letters[text]
        case Number(value):
            return float(value)
        case Matrix(rows):
            return np.array([[evaluate(entry, letters) for entry in row] for row in rows])
        case Element(matrix, row, column):
            return evaluate(matrix, letters)[row - 1, column - 1]
        case Minus() | Sum() | Product() | Power() | Quotient():
            return _arithmetic(formula, letters)
        case Root() | Size() | Call():
            return _function(formula, letters)
    raise KeyError(formula)


def _arithmetic(formula: Minus | Sum | Product | Power | Quotient, letters: Letters) -> Value:
    match formula:
        case Minus(operand):
            return -evaluate(operand, letters)
        case Sum(terms):
            return sum(evaluate(term, letters) for term in terms)
        case Product(factors):
            result = evaluate(factors[0], letters)
            for factor in factors[1:]:
                value = evaluate(factor, letters)
                result = result @ value if isinstance(value, np.ndarray) else result * value
            return result
        case Power(base, -1):
            return np.linalg.inv(evaluate(base, letters))
        case Power(base, exponent):
            return evaluate(base, letters) ** exponent
        case Quotient(over, under):
            return evaluate(over, letters) / evaluate(under, letters)


def _function(formula: Root | Size | Call, letters: Letters) -> Value:
    match formula:
        case Root(operand):
            return math.sqrt(max(evaluate(operand, letters), 0.0))
        case Size(operand):
            return abs(evaluate(operand, letters))
        case Call(function, arguments):
            values = [evaluate(argument, letters) for argument in arguments]
            if function == "sgn":
                return math.copysign(1.0, values[0])
            if function == "atan2":
                return math.atan2(*values)
            circular = {"cos": math.cos, "sin": math.sin, "tan": math.tan}
            return circular[function](values[0])


def letters_of(story: Story, q: Sequence[float]) -> Letters:
    """Every letter of a derivation at a configuration, from the chain's own constants."""
    chain = story.algebra.chain
    values = {c.name: c.value for c in chain.constants}
    inner = {j.number: j.sign * q[j.number - 1] + j.offset for j in chain.joints}
    letters = {story.letters[name].text: value for name, value in values.items()}
    for angle in story.algebra.angles:
        total = sum(sign * inner[joint] for joint, sign in angle.terms)
        letters[story.letters[angle.cosine].text] = math.cos(total)
        letters[story.letters[angle.sine].text] = math.sin(total)
        letters["θ" + story.letters[angle.cosine].text[1:]] = total
    for joint, name in story.algebra.slides.items():
        letters[story.letters[name].text] = inner[joint]
    for number, value in enumerate(q, start=1):
        letters[indexed("q", number)] = value
    for each in chain.joints:
        offset = expression_symbol(sign_and_offset(story, each.number)[1]).text
        letters |= {offset: each.offset, f"({offset})": each.offset}
        if offset.startswith("−"):  # q = θ − (−x) is printed as θ + x
            letters[offset[1:]] = -each.offset
    return letters | _matrices(story, inner, values) | _limits(story)


def _matrices(story: Story, inner: dict[int, float], values: dict[str, float]) -> Letters:
    """A_i, T_i^0, U_m, Z, E and POS as numbers, and the entries of U_0 and of named points."""
    chain = story.algebra.chain
    problem = story.derivation.problem
    base, tool = matrix(chain.base, values), matrix(chain.tool, values)
    links = [_link(chain, i, inner, values) for i in range(chain.dof)]
    found: Letters = {"Z": base, "E": tool}
    total = np.eye(4)
    for number, link in enumerate(links, start=1):
        total = total @ link
        found[indexed("T", number) + "⁰"] = total
        found[indexed("A", number)] = link
    pose = base @ total @ tool
    found |= {"POS": pose, "T_base,tool": pose}
    moved = list(links)
    if not problem.base_left:
        moved[0] = base @ moved[0]
    moved[-1] = moved[-1] @ tool @ np.linalg.inv(matrix(problem.tool_left, values))
    target = np.eye(4)
    for link in moved:
        target = target @ link
    for row in range(3):
        for column in range(4):
            found[indexed("t", f"{row + 1}{column + 1}")] = target[row, column]
            found[indexed("p", f"{row + 1}{column + 1}")] = pose[row, column]
    found |= _points(story, target, values)
    for number in range(chain.dof):
        found[indexed("U", number)] = target
        target = np.linalg.inv(moved[number]) @ target
    found |= _shoulder(story, inner, links, base) if chain.arm_angle else {}
    return found | {f"moved {i}": link for i, link in enumerate(moved, start=1)}


def _shoulder(
    story: Story, inner: dict[int, float], links: list[FloatArray], base: Value
) -> Letters:
    """B_m, the entries of B_0, and the vectors of the arm in the base and in frame 3."""
    chain = story.algebra.chain
    found: Letters = {}
    rest = three = np.linalg.multi_dot(links[:3])
    for row in range(3):
        for column in range(3):
            found[indexed("b", f"{row + 1}{column + 1}")] = three[row, column]
    for number, link in enumerate(links[:3]):
        found[indexed("B", number)] = rest
        rest = np.linalg.inv(link) @ rest
    q = np.array([joint.sign * (inner[joint.number] - joint.offset) for joint in chain.joints])
    at = triangle(numeric_arm(chain), q)
    v, e, z = at.wrist - at.shoulder, at.elbow - at.shoulder, at.first
    to_base, to_three = base[:3, :3].T, (base @ three)[:3, :3].T
    found |= {"v": to_base @ v, "z": to_base @ z}
    found |= {"v′": to_three @ v, "e′": to_three @ e, "z′": to_three @ at.fourth}
    return {name: value[:, None] if np.ndim(value) == 1 else value for name, value in found.items()}


def _points(story: Story, target: FloatArray, values: dict[str, float]) -> Letters:
    """The entries of named points: of the tool seen from the base, of the base from the tool."""
    pool = story.derivation.pool
    inverse: FloatArray = np.asarray(np.linalg.inv(target), dtype=np.float64)
    seen = [(point.names, point.in_tool, target) for point in pool.points]
    seen += [(point.names, point.in_base, inverse) for point in pool.base_points]
    found: Letters = {}
    for names, coordinates, transform in seen:
        place = transform @ [*(value_of(entry, values) for entry in coordinates), 1.0]
        for name, value in zip(names, place, strict=False):
            found[story.letters[name].text] = value
    return found


def _limits(story: Story) -> Letters:
    return {"π/2": math.pi / 2, "π": math.pi, "robot": story.robot.name}


def _link(
    chain: Chain, place: int, inner: dict[int, float], values: dict[str, float]
) -> FloatArray:
    total = np.eye(4)
    for element in chain.links[place]:
        match element:
            case Fixed(transform):
                total = total @ matrix(transform, values)
            case Turn(joint, sign):
                c, s = math.cos(inner[joint]), sign * math.sin(inner[joint])
                turn = np.eye(4)
                turn[:2, :2] = [[c, -s], [s, c]]
                total = total @ turn
            case Slide(joint, sign):
                slide = np.eye(4)
                slide[2, 3] = sign * inner[joint]
                total = total @ slide
    return total


def indexed(letter: str, index: int | str) -> str:
    """A letter with a lowered index."""
    return letter + str(index).translate(str.maketrans("0123456789-,", "₀₁₂₃₄₅₆₇₈₉₋,"))


def sign_letter(of: Story, place: int) -> str:
    """The letter of a branch sign: its index is that of the joints that its step gives."""
    unknowns = of.steps[of.program.axes[place].step - 1].unknowns
    angles = [each for each in unknowns if isinstance(each, AngleSum)]
    lengths = [each for each in unknowns if not isinstance(each, AngleSum)]
    if not angles:
        return indexed("ε", lengths[0].joint)
    (first, _), *others = angles[0].terms
    return indexed("ε", f"{first}" + "".join(f"{'-' * (s < 0)}{joint}" for joint, s in others))
