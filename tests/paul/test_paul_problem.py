"""U_0 with the entries that an arm cannot choose."""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.kinematics.algebra import POSE_PLACES
from dhgen.kinematics.task import compared_entries
from tests.kinematics.values import number
from tests.paul.arms import derivation, random_values
from tests.robots.cases import NAMES


def target(name: str) -> list[list[str]]:
    matrix = derivation(name).problem.target
    return [[str(matrix.entry(row, column)) for column in range(4)] for row in range(3)]


def test_scara_keeps_its_approach_vector() -> None:
    # document 001: the tool of a SCARA turns about the vertical only
    assert target("scara") == [
        ["t11", "-t21", "0", "t14"],
        ["t21", "t11", "0", "t24"],
        ["0", "0", "1", "t34"],
    ]
    assert derivation("scara").problem.known == {"t11", "t21", "t14", "t24", "t34"}


def test_six_joints_choose_every_entry() -> None:
    assert target("puma560") == [[f"t{i}{j}" for j in (1, 2, 3, 4)] for i in (1, 2, 3)]
    assert not derivation("puma560").problem.overdetermined


def test_tasks_say_what_is_known() -> None:
    known = {name: derivation(name).problem.known for name in ("planar_rr", "arm_3r", "wrist_zyz")}
    assert known["planar_rr"] == {"t14", "t24"}
    assert known["arm_3r"] == {"t14", "t24", "t34"}
    assert known["wrist_zyz"] == {f"t{i}{j}" for i in (1, 2, 3) for j in (1, 2, 3)}


def test_two_columns_tell_a_rotation() -> None:
    """The second is the product of the other two."""
    rng = np.random.default_rng(1)
    Q, R = (np.linalg.qr(each)[0] for each in rng.normal(size=(2, 500, 3, 3)))
    Q, R = (each * np.linalg.det(each)[:, None, None] for each in (Q, R))
    task = derivation("wrist_zyz").problem.algebra.chain.task
    told = [POSE_PLACES[name] for name in compared_entries(task)]
    miss = np.abs(Q - R)
    most = np.max([miss[:, row, column] for row, column in told], axis=0)
    assert (miss.max(axis=(1, 2)) <= 3.0 * most).all()
    assert compared_entries(derivation("planar_rr").problem.algebra.chain.task) == {"t14", "t24"}


@pytest.mark.parametrize("name", NAMES)
def test_a_pose_for_fewer_than_six_joints_has_to_be_checked(name: str) -> None:
    assert derivation(name).problem.overdetermined == (name in {"planar_rrr", "scara", "adept"})


@pytest.mark.parametrize("name", NAMES)
def test_what_is_substituted_is_true_of_the_arm(name: str) -> None:
    matrix = derivation(name).problem.target
    for values in random_values(name):
        for row in range(3):
            for column in range(4):
                entry = number(matrix.entry(row, column), values)
                size = max(1.0, abs(entry))
                assert abs(entry - values[f"t{row + 1}{column + 1}"]) < 1e-12 * size
