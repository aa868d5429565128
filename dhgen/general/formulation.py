"""The twelve ways to hide one joint of the loop, and the constant tables of each.

From the loop Rz(φ1) L0 Rz(φ2) L1 Rz(φ3) L2 Rz(φ4) L3 Rz(φ5) L4 Rz(φ6) L5 = 1 follows

    G(L5) G(φ1) G(L0) G(φ2) G(L1) G(φ3) G(L2) x = G(−φ6) G(L4⁻¹) G(−φ5) G(L3⁻¹) x

for x the features of the origin and z, because φ4 leaves them alone. The right side has eight
monomials besides 1. What annihilates these gives six equations: bilinear in (1, c1, s1) and the
nine monomials of φ2 and φ3 (Raghavan and Roth 1993, who hide the third joint of the left side and
have to divide a factor out; with the outer one the determinant has degree 8 to begin with).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.general.features import FEATURES, MONOMIALS, ONE, START, act, monomials, turn
from dhgen.general.householder import left_null_space
from dhgen.general.rigid import Matrix, inverse

if TYPE_CHECKING:
    from collections.abc import Sequence

EQUATIONS = 6
HALF_ANGLES = ("square", "first", "one")  # x², x, 1 for x = tan(φ/2)
Tensor = dict[tuple[int, int, int], list[float]]  # by the powers of φ1, φ2, φ3


@dataclass(frozen=True, slots=True)
class Formulation:
    """One way to hide a joint.

    Attributes:
        joints: The joints φ1 ... φ6 are, from 0; φ1 is hidden.
        sign: φ = sign θ; −1 reads the loop backwards.
        pose: Which of L0 ... L5 is the pose P (or its inverse when backwards: see `links`).
        links: L0 ... L5 but for the pose, None in its place.
        table: Rows of 35, to be multiplied by the monomials of L_pose. When `pose` is not 3 or 4,
            162 rows: the six equations' coefficients, index ((a 6 + r) 3 + i) 3 + j for 1, c1, s1
            (a), equation r, x3², x3, 1 (i) and x2², x2, 1 (j), with x = tan(φ/2). Otherwise 126
            rows: the right side's features, index 14 m + feature with m = 0 for 1 and 1 ... 8.
        left: When `pose` is 3 or 4, the left side's features, 27 rows of 14, index
            (a 3 + i) 3 + j as above; else empty.
    """

    joints: tuple[int, ...]
    sign: int
    pose: int
    links: tuple[Matrix | None, ...]
    table: tuple[tuple[float, ...], ...]
    left: tuple[tuple[float, ...], ...]

    @property
    def splits_each_pose(self) -> bool:
        """Whether the null space of the right side has to be found for every pose."""
        return self.pose in {3, 4}


def formulations(links: Sequence[Matrix]) -> tuple[Formulation, ...]:
    """All twelve, from K0 ... K4: six beginnings forwards, six backwards."""
    loop: list[Matrix | None] = [*links, None]
    reverse: list[Matrix | None] = [*(inverse(K) for K in reversed(links)), None]
    return tuple(
        _formulation(around, start, sign)
        for sign, around in ((1, loop), (-1, reverse))
        for start in range(6)
    )


def _formulation(around: Sequence[Matrix | None], start: int, sign: int) -> Formulation:
    # Backwards the loop is Rz(-θ6) K4⁻¹ ... K0⁻¹ Rz(-θ1) P⁻¹⁻¹: the same pose stands at its end,
    # P⁻¹ forwards and P backwards.
    order = [(start + i) % 6 for i in range(6)]
    joints = tuple(i if sign > 0 else 5 - i for i in order)
    links = tuple(around[i] for i in order)
    pose = order.index(5)
    if pose in {3, 4}:
        table, left = _split_each_pose(links, pose)
    else:
        table, left = _split_once(links, pose), ()
    return Formulation(joints, sign, pose, links, table, left)


def _basis(k: int) -> tuple[float, ...]:
    return tuple(float(i == k) for i in range(MONOMIALS))


def _values(link: Matrix | None, unit: int) -> Sequence[float]:
    """The monomials of a link; of the pose, the `unit`-th alone."""
    return _basis(unit) if link is None else monomials(link)


def _left_side(links: Sequence[Matrix | None], unit: int) -> Tensor:
    """The left side's features by the powers (1, c, s) of φ1, φ2, φ3."""
    tensor: Tensor = {}
    first = act(_values(links[2], unit), START)
    for c, after_3 in enumerate(turn(first)):
        for b, after_2 in enumerate(turn(act(_values(links[1], unit), after_3))):
            for a, after_1 in enumerate(turn(act(_values(links[0], unit), after_2))):
                tensor[a, b, c] = act(_values(links[5], unit), after_1)
    return tensor


def _right_side(links: Sequence[Matrix | None], unit: int) -> list[list[float]]:
    """The right side's features by the nine monomials of φ5 and φ6, 1 first.

    The link that is the pose has to be given as its inverse: the right side contains inverses.
    """
    columns: list[list[float]] = []
    first = act(_inverse_values(links[3], unit), START)
    for after_5 in turn(first):
        columns += turn(act(_inverse_values(links[4], unit), after_5))
    return columns


def _inverse_values(link: Matrix | None, unit: int) -> Sequence[float]:
    return _basis(unit) if link is None else monomials(inverse(link))


def _half_angles(tensor: dict[tuple[int, int, int], float]) -> list[list[list[float]]]:
    """[a][i][j]: from (1, c, s) of φ2 and φ3 to x2 (j) and x3 (i), times (1 + x2²)(1 + x3²)."""

    def powers(one: float, cosine: float, sine: float) -> tuple[float, float, float]:
        return one - cosine, 2.0 * sine, one + cosine

    result = []
    for a in range(3):
        by_x3 = [powers(*(tensor[a, b, c] for c in range(3))) for b in range(3)]
        result.append([list(powers(*(by_x3[b][i] for b in range(3)))) for i in range(3)])
    return result


def _split_once(links: Sequence[Matrix | None], pose: int) -> tuple[tuple[float, ...], ...]:
    """The six equations for each monomial of the pose; the right side is the same for all."""
    columns = [column[1:] for column in _right_side(links, 0)]
    null = left_null_space(columns[1:], EQUATIONS)
    per_unit = []
    for unit in range(MONOMIALS):
        tensor = _left_side(links, unit)
        if unit == 0:
            # the right side's constant column goes over to the left
            tensor[0, 0, 0] = [
                x - (columns[0][i - 1] if i > ONE else 0.0) for i, x in enumerate(tensor[0, 0, 0])
            ]
        values = [0.0] * (3 * EQUATIONS * 9)
        for r, row in enumerate(null):
            equation = {key: sum_of_products(row, features[1:]) for key, features in tensor.items()}
            for a, by_x3 in enumerate(_half_angles(equation)):
                for i, by_x2 in enumerate(by_x3):
                    for j, value in enumerate(by_x2):
                        values[((a * EQUATIONS + r) * 3 + i) * 3 + j] = value
        per_unit.append(values)
    assert pose not in {3, 4}
    return tuple(zip(*per_unit, strict=True))


def sum_of_products(a: Sequence[float], b: Sequence[float]) -> float:
    """A scalar product that passes over zeros, which are many here."""
    total = 0.0
    for x, y in zip(a, b, strict=True):
        if y:
            total += x * y
    return total


def _split_each_pose(
    links: Sequence[Matrix | None], pose: int
) -> tuple[tuple[tuple[float, ...], ...], tuple[tuple[float, ...], ...]]:
    """The right side for each monomial of the pose's inverse, and the left side, constant."""
    assert links[pose] is None
    right = []
    for unit in range(MONOMIALS):
        columns = _right_side(links, unit)
        right.append([x for column in columns for x in column[1:]])
    tensor = _left_side(links, 0)
    left: list[list[float]] = [[] for _ in range(27)]
    for feature in range(1, FEATURES):
        part = _half_angles({key: features[feature] for key, features in tensor.items()})
        flat = [value for by_x3 in part for by_x2 in by_x3 for value in by_x2]
        for row, value in zip(left, flat, strict=True):
            row.append(value)
    return tuple(zip(*right, strict=True)), tuple(map(tuple, left))
