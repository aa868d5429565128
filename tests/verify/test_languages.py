"""Rows that one language has and the other has not."""

from __future__ import annotations

from functools import cache
from types import SimpleNamespace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.errors import VerificationError
from dhgen.status import Status
from dhgen.verify.demands import Demands
from dhgen.verify.languages import Languages
from tests.compiling import compile_file
from tests.targets.made import ROBOTS

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.targets.module import SolverModule

BENT = np.array([0.3, 0.9])
STRETCHED = np.array([0.3, 0.0])


@cache
def module() -> SolverModule:
    return compile_file(ROBOTS / "planar_rr.yaml").module


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
    demands = Demands(compile_file(ROBOTS / "franka_panda.yaml").module)
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
