"""Arms of fewer joints than the task has numbers: what is printed of columns of J is true."""

from __future__ import annotations

import math
import random
from itertools import combinations

import numpy as np
import pytest

from dhgen.derivation.document import singular_places
from dhgen.derivation.velocity.tall import SomeColumns, has_fewer_joints, some_columns
from dhgen.kinematics.numeric import numeric_arm
from dhgen.oracle.forward import jacobian
from tests.derivation.stories import document, story
from tests.derivation.test_formulas_hold import with_pose
from tests.derivation.values import evaluate, indexed

PALLETIZERS = ["kuka_kr40pa", "kuka_youbot", "phantomx", "scorbot_pointing", "xarm5"]


def columns_of(name: str) -> SomeColumns:
    of = story(name)
    found = some_columns(of, singular_places(of))
    assert found is not None
    return found


@pytest.mark.parametrize("name", [*PALLETIZERS, "craig_417"])
def test_the_determinant_is_that_of_the_columns_alone(name: str) -> None:
    """By the squares of their minors, which no frame changes, at random joint values."""
    of, found = story(name), columns_of(name)
    source = random.Random(4)  # noqa: S311 - configurations, no secrets
    for _ in range(3):
        q = [source.uniform(-3.0, 3.0) for _ in range(of.dof)]
        letters = with_pose(of, q)
        columns = seen_at(name, q, found)
        minors = sum(
            np.linalg.det(columns[list(rows)]) ** 2
            for rows in combinations(range(6), columns.shape[1])
        )
        assert math.isclose(abs(evaluate(found.formula, letters)), math.sqrt(minors), rel_tol=1e-9)


def seen_at(name: str, q: list[float], found: SomeColumns) -> np.ndarray:
    """Columns of the oracle's J with the velocity of a frame's origin, seen from another frame."""
    of = story(name)
    letters = with_pose(of, q)
    frames = [
        letters["Z"],
        *(letters["Z"] @ letters[f"{indexed('T', k)}⁰"] for k in range(1, of.dof + 1)),
    ]
    frames.append(letters["T_base,tool"])
    J = np.asarray(jacobian(of.robot, q))
    moved = frames[found.centre][:3, 3] - frames[-1][:3, 3]
    turn = frames[found.frame][:3, :3].T
    velocities = J[:3] + np.cross(J[3:].T, moved).T
    whole = np.vstack([turn @ velocities, turn @ J[3:]])
    columns = whole[:, [joint - 1 for joint in found.joints]]
    rows = [row for row in range(6) if np.abs(columns[row]).max() > 1e-9]
    assert len(rows) == len(found.joints)
    return np.asarray(columns)


@pytest.mark.parametrize("name", PALLETIZERS)
def test_where_it_is_zero_the_arm_is_singular(name: str) -> None:
    of = story(name)
    arm = numeric_arm(of.algebra.chain)
    q = np.array([0.4, -0.3, 0.0, 0.7, 0.2][: of.dof])
    joint = of.algebra.chain.joints[2]
    q[2] = -joint.sign * joint.offset
    J = np.asarray(jacobian(of.robot, q.tolist()))
    assert np.linalg.matrix_rank(J, tol=1e-9) < arm.chain.dof
    assert "columns 2, 3 and 4 have only three rows that are not zero" in document(name)


def test_arms_without_such_columns_are_told_why_they_have_no_determinant() -> None:
    for name in ("adept", "general_5r"):
        of = story(name)
        assert has_fewer_joints(of)
        assert "$J$ has more rows than columns, and no determinant." in document(name)
    assert not has_fewer_joints(story("scara_wrist"))
