"""Where steps degenerate, by the joints: the same condition as by the pose, at random places."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import pytest

from dhgen.derivation.known_functions import by_joints
from dhgen.derivation.sections.shoulder import arm_angle_places
from dhgen.derivation.step_context import Singularity, StepContext
from dhgen.derivation.steps import step_blocks
from dhgen.derivation.text.blocks import Prose
from dhgen.derivation.text.formula import Relation
from dhgen.derivation.text.plain import words
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import PLAIN
from dhgen.paul.kind import Kind
from tests.derivation.stories import EACH, OWN, story
from tests.derivation.test_formulas_hold import configuration, with_pose
from tests.derivation.values import evaluate

if TYPE_CHECKING:
    from dhgen.derivation.story import Story

LETTERS = ("X", "Y", "Z", "X1", "Y1", "X2", "Y2")


def singularities(of: Story, number: int) -> tuple[Singularity, ...]:
    """Those of a step."""
    return step_blocks(of, number)[1]


def in_joints(name: str, condition: str) -> str:
    """What a step with this condition says of the joints, as plain text."""
    of = story(name)
    every = [each for number in range(1, len(of.steps) + 1) for each in singularities(of, number)]
    (found,) = (
        each
        for each in every
        if not isinstance(each.condition, Prose) and show(each.condition, PLAIN) == condition
    )
    assert found.joints is not None
    return words(Prose("{}", (found.joints,)))


@pytest.mark.parametrize("name", [*EACH, *OWN])
def test_what_the_pose_tells_is_worth_the_same_by_the_joints(name: str) -> None:
    of = story(name)
    letters = with_pose(of, configuration(of, 3))
    for number, step in enumerate(of.steps, start=1):
        context = StepContext(of, number, step)
        held = [each for each, _ in step.coefficients if each in LETTERS]
        for letter in held:
            form = context.polynomial(letter)
            joints = by_joints(of, form)
            if joints is not None:
                expected = evaluate(of.write(form), letters)
                found = evaluate(of.write_forward(joints), letters)
                assert found == pytest.approx(expected, abs=1e-9 * max(1.0, letters["size"] ** 2))


@pytest.mark.parametrize("name", EACH)
def test_the_root_of_a_step_vanishes_with_what_is_said_of_the_joints(name: str) -> None:
    """One is the other but for a factor that does not move."""
    of = story(name)
    for number, step in enumerate(of.steps, start=1):
        if step.kind is not Kind.ANGLE or not step.coefficient("Z"):
            continue
        form = of.combination(number).form
        for each in singularities(of, number)[:1]:
            if not isinstance(each.joints, Relation) or len(each.joints.sides) != 2:
                continue
            ratios = []
            for seed in range(4):
                letters = with_pose(of, configuration(of, seed))
                said = evaluate(each.joints.sides[0], letters)
                ratios.append(abs(evaluate(of.write(form), letters) / said))
            assert max(ratios) == pytest.approx(min(ratios), rel=1e-6), (number, each.joints)


@pytest.mark.breadth
def test_long_and_hidden_conditions_are_told() -> None:
    assert in_joints("abb_irb4600", "t₁₄ = t₂₄ = 0") == "a₁ + a₂ s₂ + d₄ c₂₃ + a₃ s₂₃ = 0"
    assert in_joints("staubli_rx90", "Z₁ = Z₂ = 0") == "a₂ − d₄ s₃ = c₃ = 0"
    assert in_joints("olson_pprrrr", "Z² = X²") == "c₄ = 0"
    assert in_joints("wrist_oblique", "D₁ = 0") == "s₂ = 0"
    assert in_joints("kuka_iiwa14", "X = Y = Z = 0").startswith("s₃ s₄ = ")


def test_what_the_numbers_do_not_allow_is_said() -> None:
    """The tool is d3 from where the axes meet: on axis 1, where X = Y = 0, its height is d3 or -d3.

    Then Z is d3 times the difference or the sum of the cosines of 50 and 60 degrees.
    """
    assert in_joints("wrist_oblique", "X = Y = Z = 0") == "none with the numbers of this arm"


def test_an_arm_angle_is_told_where_it_has_no_plane() -> None:
    of = story("kuka_iiwa14_arm_angle")
    (found,) = arm_angle_places(of)
    assert isinstance(found.joints, Relation)
    first, second, _ = found.joints.sides
    assert isinstance(found.condition, Relation)
    for seed in range(3):
        letters = with_pose(of, configuration(of, seed))
        across = [evaluate(side, letters) for side in found.condition.sides[:2]]
        d5 = letters["d₅"]
        turned = d5 * evaluate(first, letters), evaluate(second, letters)
        assert math.hypot(*turned) == pytest.approx(math.hypot(*across))
