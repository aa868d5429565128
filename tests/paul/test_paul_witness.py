"""Witnesses: the pose and the named points that numbers give are those that polynomials say."""

from __future__ import annotations

from itertools import chain

import numpy as np
import pytest

from dhgen.kinematics.algebra import POSE_NAMES, POSE_PLACES, SHOULDER_NAMES
from dhgen.kinematics.transform import compose, translation
from dhgen.paul.witness import build_witnesses
from tests.paul.arms import derivation

ARM_ANGLE = "kuka_iiwa14_arm_angle"


@pytest.mark.parametrize("name", ["puma560", "scorbot_pointing", "stanford", "ur5", ARM_ANGLE])
def test_they_are_those_of_the_polynomials(name: str) -> None:
    pool = derivation(name).pool
    witnesses, problem, algebra = build_witnesses(pool), pool.problem, pool.problem.algebra
    forward, back = problem.forward, problem.spans.inverse(0, len(problem.links))
    meant = {entry: forward.entry(*POSE_PLACES[entry]) for entry in POSE_NAMES}
    seen = [(p.names, p.in_tool, forward) for p in pool.points]
    seen += [(p.names, p.in_base, back) for p in pool.base_points]
    for names, coordinates, transform in seen:
        point = compose(transform, translation(algebra.ring, coordinates), algebra.normal)
        meant |= dict(zip(names, point.translation, strict=True))
    if pool.plane is not None:
        meant |= zip(*map(chain.from_iterable, (SHOULDER_NAMES, pool.plane.rotation)), strict=True)
    assert (name == ARM_ANGLE) is any(letter in meant for letter in SHOULDER_NAMES[0])
    for letter, polynomial in meant.items():
        np.testing.assert_allclose(
            witnesses.evaluate(algebra.generator(letter)),
            witnesses.evaluate(polynomial),
            rtol=0.0,
            atol=1e-13,
        )
