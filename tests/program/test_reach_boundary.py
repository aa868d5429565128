"""Regular poses end where a square root can't be told from zero, and only there."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.kinematics.numeric import numeric_arm
from dhgen.program.count import count_operations
from dhgen.program.regular.regular import regular
from dhgen.program.role import Tolerance
from tests.derivation.stories import story
from tests.program.doubts import doubtful

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

COUNT = 200


def joints(name: str) -> FloatArray:
    """Random joint values (COUNT, n) away from singular ones."""
    dof = numeric_arm(story(name).derivation.problem.algebra.chain).chain.dof
    return np.random.default_rng(4).uniform(0.3, 1.2, (COUNT, dof))


# PUMA's forearm is at right angles to its link 3 (d4, a3); UR5's elbow comes after its wrist, of
# which few digits are right where it is nearly straight
@pytest.mark.parametrize(
    ("name", "stretched", "wrist"),
    [("puma560", np.arctan2(0.4318, -0.0203), 1.0), ("ur5", 0.0, 1.0), ("ur5", 0.0, 5e-4)],
)
def test_a_stretched_or_folded_arm_is_doubtful_and_a_bent_one_is_not(
    name: str, stretched: float, wrist: float
) -> None:
    q = joints(name)
    q[:, 4] = wrist
    assert not doubtful(name, q).any()
    for elbow in (stretched, stretched + np.pi):
        q[:, 2] = elbow
        assert doubtful(name, q).all()


def test_a_distance_that_the_links_do_not_allow_is_no_doubt() -> None:
    """Links 2 and 3 of a PUMA 560 differ by 0.5 mm: joint 2 is free at no regular pose."""
    whole, solver = story("puma560").program, regular(story("puma560").program)
    assert solver is not None
    lengths = Tolerance("free_square", 2), Tolerance("doubt_square", 2)
    assert lengths[0] in {c.role for c in whole.constants}
    assert lengths[1] not in {c.role for c in solver.program.constants}


def test_a_distance_far_from_what_the_links_allow_is_never_tested() -> None:
    """UR5's links 2 and 3 differ by 33 mm: no joint 2 is free for being on its axis."""
    whole, solver = story("ur5").program, regular(story("ur5").program)
    assert solver is not None
    roles = {c.role for program in (whole, solver.program) for c in program.constants}
    assert not {Tolerance("free_square", 2), Tolerance("doubt_square", 2)} & roles


def test_what_has_to_be_of_length_1_is_neither_short_nor_divided_by_its_length() -> None:
    """SCARA's angle 1 + 2 + 4 is the direction of (T11, T21), which has to be that direction."""
    whole, solver = story("scara").program, regular(story("scara").program)
    assert solver is not None
    assert Tolerance("free", 0) in {c.role for c in whole.constants}
    assert Tolerance("doubt", 0) not in {c.role for c in solver.program.constants}
    count = count_operations(solver.program)
    assert (count.divisions, count.square_roots) == (0, 1)
