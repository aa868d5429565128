"""Rows that one language has and the other has not, or has elsewhere."""

from __future__ import annotations

from functools import cache
from types import SimpleNamespace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.errors import VerificationError
from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.status import Status
from dhgen.verify.demands import Demands
from dhgen.verify.languages import Languages
from tests.compiling import module_of
from tests.general.files import without_derivation
from tests.kinematics.values import table
from tests.targets.made import ROBOTS

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.targets.module import SolverModule

BENT = np.array([0.3, 0.9])
STRETCHED = np.array([0.3, 0.0])


@cache
def module() -> SolverModule:
    return module_of(ROBOTS / "planar_rr.yaml")


def compared(python: FloatArray, c: FloatArray, q: FloatArray, *, singular: bool) -> None:
    """Compares rows (B, n), NaN where there is none, for the pose of joint values."""

    def solver(rows: FloatArray) -> SimpleNamespace:
        status = np.where(np.isnan(rows).any(axis=1), Status.UNREACHABLE, Status.OK).astype(
            np.uint8
        )
        given = (rows, status)
        return SimpleNamespace(ik_all=lambda *_: given, ik=lambda *_: given)

    demands = Demands(module())
    T = demands.measures.arm.pose(q[None])[0]
    languages = Languages(module(), solver(python), (solver(c),), demands)  # type: ignore[arg-type]
    languages.call(T, q, "here", singular=singular)


def with_a_row(q: FloatArray, *, there: bool) -> FloatArray:
    return np.array([q, q if there else np.full(2, np.nan)])


@pytest.mark.parametrize("first", [True, False])
def test_only_at_an_edge_may_a_language_have_a_row_alone(first: bool) -> None:  # noqa: FBT001
    python, c = with_a_row(STRETCHED, there=first), with_a_row(STRETCHED, there=not first)
    compared(python, c, STRETCHED, singular=True)
    with pytest.raises(VerificationError, match="Python gives"):
        compared(python, c, STRETCHED, singular=False)
    python, c = with_a_row(BENT, there=first), with_a_row(BENT, there=not first)
    with pytest.raises(VerificationError, match="Python gives"):
        compared(python, c, BENT, singular=True)


def test_a_row_that_stands_alone_has_to_be_a_solution() -> None:
    python, c = with_a_row(STRETCHED, there=True), with_a_row(STRETCHED, there=False)
    python[1, 0] += 1e-6
    with pytest.raises(VerificationError, match="misses the pose"):
        compared(python, c, STRETCHED, singular=True)


def test_of_joint_values_that_are_one_each_language_may_give_its_own() -> None:
    """A Panda with its elbow folded: axes 3 and 5 are one line, and only q3 + q5 is fixed."""
    demands = Demands(module_of(ROBOTS / "franka_panda.yaml"))
    third, fourth, fifth = np.eye(7)[2:5]
    folded = np.array([0.2, 0.7, 0.9, 0.0, 2.6, 1.3, 0.4])
    bent = folded - fourth
    turn = 2.0 * (third - fifth)

    def agree(row: FloatArray, other: FloatArray) -> None:
        T = demands.measures.arm.pose(row[None])[0]
        demands.agree(row[None], other[None], T, "C", "here")

    agree(folded, folded + turn)
    with pytest.raises(VerificationError, match="C: a row misses the pose"):
        agree(bent, bent + turn)


def test_two_solutions_are_not_one() -> None:
    demands = Demands(module())
    T = demands.measures.arm.pose(BENT[None])[0]
    mirrored = np.array([2.0 * np.arctan2(T[1, 3], T[0, 3]) - BENT[0], -BENT[1]])
    demands.reproduce(mirrored[None], T, "here")
    with pytest.raises(VerificationError, match="Python and C differ"):
        demands.agree(BENT[None], mirrored[None], T, "C", "here")


# Links of one length: at q3 = pi the wrist centre lies on axis 2, and joint 2 is free.
UNIT_LINKS = (
    "theta: q, a: 1, alpha: pi/2",
    "theta: q, d: 2, a: 1, alpha: -pi/2",
    "theta: q + (-pi/2), a: 1, alpha: -pi/2",
)
WRIST = (
    "theta: q, d: 1, alpha: pi/2",
    "theta: q, alpha: pi/2",
    "theta: q",
)
ON_AXIS = np.array([-0.6, 2.9, np.pi, -0.4, 1.2, 2.8])
OFF_AXIS = ON_AXIS - [0.0, 0.0, 1.0, 0.0, 0.0, 0.0]


def flipped(q: FloatArray) -> FloatArray:
    """The other solution of a wrist of three turns."""
    return np.asarray(q + np.array([0.0, 0.0, 0.0, np.pi, -2.0 * q[4], np.pi]))


def with_joint_2(q: FloatArray, theta2: float) -> FloatArray:
    """The solution of the pose of q with another joint 2, the wrist's angles from its matrix."""
    arm = numeric_arm(build_chain(table(*UNIT_LINKS)))
    moved = q.copy()
    moved[1] = theta2
    T = numeric_arm(build_chain(table(*UNIT_LINKS, *WRIST))).pose(q)
    R = arm.pose(moved[:3])[:3, :3].T @ T[:3, :3]
    theta5 = np.arctan2(np.hypot(R[0, 2], R[1, 2]), -R[2, 2])
    moved[3:] = np.arctan2(R[1, 2], R[0, 2]), theta5, np.arctan2(-R[2, 1], R[2, 0])
    return moved


def hold_the_same(rows: list[FloatArray], others: list[FloatArray]) -> bool:
    demands = Demands(without_derivation(table(*UNIT_LINKS, *WRIST)))
    T = demands.measures.arm.pose(rows[0][None])[0]
    return demands.hold_the_same(np.array(rows), np.array(others), T, "here")


def test_where_the_arm_is_singular_solutions_may_stand_in_other_rows() -> None:
    q, none = ON_AXIS, np.full(6, np.nan)
    assert hold_the_same([q, flipped(q)], [flipped(q), q])
    assert hold_the_same([q, flipped(q), none], [none, q, flipped(q)])
    assert not hold_the_same([q, flipped(q)], [q, none])
    assert not hold_the_same([OFF_AXIS, flipped(OFF_AXIS)], [flipped(OFF_AXIS), OFF_AXIS])


def test_values_of_a_free_joint_stand_for_each_other_along_a_curve() -> None:
    """The wrist follows joint 2, but not in proportion: half way the straight way misses."""
    other = with_joint_2(ON_AXIS, 2.5)
    demands = Demands(without_derivation(table(*UNIT_LINKS, *WRIST)))
    T = demands.measures.arm.pose(ON_AXIS[None])[0]
    straight = demands.measures.ways(ON_AXIS, other)[0]
    assert demands.measures.residual(straight, T) > 1e-3
    assert hold_the_same([ON_AXIS], [other])
    bent = next(demands.measures.curves(ON_AXIS, other, T))
    for values in bent:
        np.testing.assert_allclose(values, with_joint_2(ON_AXIS, values[1]), atol=1e-6)
