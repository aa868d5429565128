"""Arctangents of one pose side by side: narrow ones share the lanes of one vector.

An angle that depends on neither of the signs in lanes is needed once, one that depends on one of
them twice; both are found in lanes that others leave, and moved to all lanes afterwards.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.program.ir import Apply, Let
from dhgen.targets.c.declared import Declaration

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.program.ir import Expression
    from dhgen.targets.c.lanes import LaneText

LANES = 4
# By the places of signs that an angle depends on: the lanes in which it may be found, and which of
# them every lane then takes.
_PLACES: dict[tuple[int, ...], tuple[list[tuple[int, ...]], tuple[int, ...]]] = {
    (): ([(0,), (1,), (2,), (3,)], (0, 0, 0, 0)),
    (0,): ([(0, 2), (1, 3)], (0, 0, 1, 1)),
    (1,): ([(0, 1), (2, 3)], (0, 1, 0, 1)),
    (0, 1): ([(0, 1, 2, 3)], (0, 1, 2, 3)),
}


@dataclass(frozen=True, slots=True)
class Packed:
    """An angle and its lanes of a vector.

    Attributes:
        let: The statement that names it.
        lanes: The lanes in which it is found.
        spread: For each of the four lanes the one in which its value is found.
    """

    let: Let
    lanes: tuple[int, ...]
    spread: tuple[int, ...]


def packed_angles(lets: list[Let], places: dict[int, int]) -> list[list[Packed]]:
    """The vectors, each with its angles, the wide ones first.

    Args:
        lets: The angles.
        places: Of the signs in lanes: 0 for the one that changes slowly, 1 for the other.
    """
    vectors: list[list[Packed]] = []
    for let in sorted(lets, key=lambda each: -len(each.axes)):
        choices, spread = _PLACES[tuple(sorted(places[axis] for axis in let.axes))]
        for vector in [*vectors, []]:
            taken = {lane for packed in vector for lane in packed.lanes}
            lanes = next((c for c in choices if not taken.intersection(c)), None)
            if lanes is not None:
                if not vector:
                    vectors.append(vector)
                vector.append(Packed(let, lanes, tuple(lanes[k] for k in spread)))
                break
    return vectors


def in_order(vectors: list[list[Packed]], known: Mapping[str, int]) -> list[list[Packed]]:
    """The vectors in the order in which their angles can be taken.

    Args:
        vectors: The vectors.
        known: When named values are known (`arrivals`).
    """
    return sorted(vectors, key=lambda each: max(known[packed.let.name] for packed in each))


def angle_declarations(vectors: list[list[Packed]], text: LaneText) -> list[Declaration]:
    """What computes the angles under their names: all ratios first, then the angles."""
    ratios, angles = [], []
    for number, vector in enumerate(vectors, start=1):
        sine, cosine = (_gathered(vector, operand, text) for operand in (0, 1))
        ratio = f"dhgen_ratio_four({sine}, {cosine})"
        ratios.append(Declaration("dhgen_direction_four", f"ratio{number}", ratio))
        alone = len(vector) == 1 and len(vector[0].lanes) == LANES
        name = vector[0].let.name if alone else f"packed{number}"
        angles.append(Declaration("dhgen_four", name, f"dhgen_angle_four(ratio{number})"))
        for packed in vector:
            text.declare(packed.let.name, lanes=True)
            if not alone:
                spread = ", ".join(map(str, packed.spread))
                value = f"dhgen_shuffle({name}, {name}, {spread})"
                angles.append(Declaration("dhgen_four", packed.let.name, value))
    return [*ratios, *angles]


def _gathered(vector: list[Packed], place: int, text: LaneText) -> str:
    """An operand of all angles of a vector, each in its lanes."""
    operands = [_operand(packed.let.expression, place) for packed in vector]
    if not any(text.text(operand).lanes for operand in operands):
        texts = [text.text(operands[0]).text] * LANES
        for packed, operand in zip(vector, operands, strict=True):
            for lane in packed.lanes:
                texts[lane] = text.text(operand).text
        return f"dhgen_four_of({', '.join(texts)})"
    gathered = text.vector(operands[0])
    for packed, operand in zip(vector[1:], operands[1:], strict=True):
        lanes = ", ".join(str(k + LANES if k in packed.lanes else k) for k in range(LANES))
        gathered = f"dhgen_shuffle({gathered}, {text.vector(operand)}, {lanes})"
    return gathered


def _operand(expression: Expression, place: int) -> Expression:
    assert isinstance(expression, Apply)
    return expression.operands[place]
