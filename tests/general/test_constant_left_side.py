"""The monomials of a formulation's left side: numbers in C where no pose is among them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from dhgen.general.formulation import Formulation, formulations
from dhgen.general.links import Held
from dhgen.general.trial import left_side
from dhgen.targets.general.constant_left_side import LEFT, constant_left
from tests.general.arms import kernel, poses

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

NAME = "jaco2"


@pytest.mark.parametrize("formulation", formulations())
def test_they_are_those_at_every_pose(formulation: Formulation) -> None:
    arm = kernel(NAME)
    texts = constant_left(arm, formulation)
    pose = formulation.joints.index(5 if formulation.sign > 0 else 0)
    assert bool(texts) == (pose not in LEFT)
    if not texts:
        return
    table = np.array([[float(x) for x in text.split(", ")] for text in texts])
    around = [np.array(link.first)[None] for link in arm.loop.links]
    for _, P in poses(NAME, 3):
        every = formulation.links(around, P[None])
        np.testing.assert_array_equal(table, left_side(formulation, every, ()))


def test_not_where_a_joint_is_held_there() -> None:
    arm = kernel(NAME)
    formulation = next(f for f in formulations() if constant_left(arm, f))
    number = formulation.joints[0] - (formulation.sign < 0)
    links = list(arm.loop.links)
    rest = ((Held(0, slides=False, factor=1.0), links[number].first),)
    links[number] = replace(links[number], rest=rest)
    held = replace(arm, loop=replace(arm.loop, links=tuple(links)))
    assert not constant_left(held, formulation)


def test_not_behind_a_polynomial_in_closed_form() -> None:
    arm = kernel("xarm6")
    assert arm.closed
    assert not any(constant_left(arm, f) for f in formulations())
