"""What a derivation prints is true: every formula on a line of its own, at random places."""

from __future__ import annotations

import math
import random
from functools import cache
from itertools import product
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.derivation.document import document_blocks
from dhgen.derivation.sections.elements import element_blocks, known_side_blocks
from dhgen.derivation.sections.forward import forward_section
from dhgen.derivation.sections.inverse import inverse_beginning
from dhgen.derivation.sections.jacobian import jacobian_blocks
from dhgen.derivation.sections.joints import joint_values
from dhgen.derivation.steps import step_blocks
from dhgen.derivation.text.blocks import Display, Paragraph, unfolded
from dhgen.derivation.text.formula import Formula, Listing, Relation, Symbol
from dhgen.derivation.text.lines import broken
from dhgen.derivation.text.plain import box
from dhgen.derivation.text.style import PLAIN
from dhgen.oracle.arm_angle import given_values
from dhgen.oracle.forward import forward, jacobian
from dhgen.program.interpret import interpret
from tests.derivation.stories import EACH, OWN, WHOLE, story
from tests.derivation.values import Letters, evaluate, indexed, letters_of, sign_letter

if TYPE_CHECKING:
    from dhgen.derivation.story import Story

TOLERANCE = 1e-9
DEFINING = "This is", "The determ", "By now all of"  # how texts begin that define letters
ANGLES, RATIOS = "θq", "cs"  # how the letters of what has no unit begin


def relations(blocks: list[object]) -> list[Relation]:
    """All relations that stand on lines of their own, and letters defined in a sentence."""
    found: list[Relation] = []
    for block in blocks:
        if isinstance(block, Paragraph) and block.prose.text.startswith(DEFINING):
            for part in block.prose.parts:
                found += [
                    f
                    for f in _flat(part)  # type: ignore[arg-type]
                    if isinstance(f, Relation) and isinstance(f.sides[0], Symbol)
                ]
        if isinstance(block, Display):
            for formula in block.formulas:
                found += [f for f in _flat(formula) if isinstance(f, Relation)]
    return found


def _flat(formula: Formula) -> list[Formula]:
    return list(formula.items) if isinstance(formula, Listing) else [formula]


def configuration(of: Story, seed: int) -> list[float]:
    """Joint values away from every singular place, with high probability."""
    source = random.Random(seed)  # noqa: S311 - configurations, not secrets
    size = of.algebra.chain.size
    return [
        source.uniform(-3.0, 3.0)
        if j.number not in of.algebra.slides
        else source.uniform(0.2, 2.0) * size
        for j in of.algebra.chain.joints
    ]


def holds(relation: Relation, letters: Letters) -> bool:
    """Whether all sides with a value are equal; a new letter takes the value of the others."""
    known: list[object] = []
    for side in relation.sides:
        try:
            known.append(evaluate(side, letters))
        except KeyError:
            if not isinstance(side, Symbol):
                raise
    assert known, box(relation)
    first = relation.sides[0]
    if isinstance(first, Symbol) and first.text not in letters:
        letters[first.text] = known[-1]
    begins = first.text[0] if isinstance(first, Symbol) else "?"
    size = 1.0 if begins in ANGLES + RATIOS else letters["size"]
    return all(_equal(value, known[-1], turn=begins in ANGLES, size=size) for value in known)


def _equal(left: object, right: object, *, turn: bool, size: float) -> bool:
    difference = np.asarray(left) - np.asarray(right)
    if turn:
        difference = np.remainder(difference + math.pi, 2.0 * math.pi) - math.pi
    return bool(np.max(np.abs(difference)) < TOLERANCE * max(1.0, size) ** 4)


def with_pose(of: Story, q: list[float]) -> Letters:
    """The letters of a configuration."""
    return {**letters_of(of, q), "size": of.algebra.chain.size, "ℓ": of.algebra.chain.size}


def given_to_steps(of: Story) -> list[Relation]:
    """What the pose gives to the steps: before all of them, and before each."""
    blocks = inverse_beginning(of)
    for number in range(1, len(of.steps) + 1):
        blocks += [*known_side_blocks(of, number), *element_blocks(of, number)]
    return relations([*unfolded(blocks)])


def with_entries(of: Story, letters: Letters) -> Letters:
    """The same, with what the text calls the entries of a matrix before its steps."""
    every = dict(letters)
    for relation in given_to_steps(of):
        name = relation.sides[0]
        if isinstance(name, Symbol) and name.text not in every:
            every[name.text] = evaluate(relation.sides[-1], every)
    return every


@pytest.mark.parametrize("name", [*EACH, *WHOLE])
def test_forward_model(name: str) -> None:
    of = story(name)
    printed = relations(list(forward_section(of)))
    for seed in range(3):
        q = configuration(of, seed)
        letters = with_pose(of, q)
        np.testing.assert_allclose(
            letters["T_base,tool"], forward(of.robot, q), atol=1e-9 * of.algebra.chain.size
        )
        for relation in printed:
            if relation.sides[0] != Symbol("J", "J"):
                assert holds(relation, letters), box(relation)


@pytest.mark.parametrize("name", [*EACH, *WHOLE])
def test_jacobian(name: str) -> None:
    of = story(name)
    q = configuration(of, 7)
    for relation in relations(list(jacobian_blocks(of))):
        found = evaluate(relation.sides[1], with_pose(of, q))
        np.testing.assert_allclose(found, jacobian(of.robot, q), atol=1e-9 * of.algebra.chain.size)


@pytest.mark.parametrize("name", [*EACH, *OWN])
def test_matrices_of_the_inverse(name: str) -> None:
    of = story(name)
    printed = given_to_steps(of)
    for seed in range(3):
        letters = with_pose(of, configuration(of, seed))
        for number in range(1, of.dof + 1):
            letters[indexed("A", number)] = letters[f"moved {number}"]
        for relation in printed:
            assert holds(relation, letters), box(relation)


@pytest.mark.parametrize("name", [*EACH, *OWN])
def test_steps_with_the_branch_signs_of_the_program(name: str) -> None:
    """The program finds a configuration in one row; the steps hold with just that row's signs."""
    of = story(name)
    for seed in range(3):
        q = configuration(of, seed)
        given = given_values(of.robot, np.array(q))
        rows = interpret(of.program, forward(of.robot, q)[None], None, given)
        # which root of a polynomial it is, no formula says
        counts = [axis.count for axis in of.program.axes]
        choices = [(1.0, -1.0) if count == 2 else (0.0,) * count for count in counts]
        signs = list(product(*choices))
        true = [signs[row] for row in range(of.program.rows) if _is(of, rows.q[0, row], q)]
        assert len(true) == 1
        signs = list(dict.fromkeys(signs))
        letters = with_entries(of, with_pose(of, q))
        del letters["Z"], letters["E"]  # in a step Z is a letter of its type
        good = [choice for choice in signs if _steps_hold(of, letters, choice)]
        assert good == true


def _is(of: Story, found: object, q: list[float]) -> bool:
    difference = np.asarray(found) - np.asarray(q)
    for joint in of.algebra.chain.joints:
        if joint.number not in of.algebra.slides:
            difference[joint.number - 1] = math.remainder(
                difference[joint.number - 1], 2.0 * math.pi
            )
    return bool(np.max(np.abs(difference)) < 1e-6 * max(1.0, of.algebra.chain.size))


@cache
def step_relations(name: str) -> tuple[tuple[Relation, ...], ...]:
    """The relations of every step, and last those of the joint values."""
    of = story(name)
    steps = [step_blocks(of, number)[0] for number in range(1, len(of.steps) + 1)]
    return tuple(tuple(relations(list(blocks))) for blocks in (*steps, joint_values(of)))


def _steps_hold(of: Story, place: Letters, signs: tuple[float, ...]) -> bool:
    letters = dict(place)
    for number, sign in enumerate(signs):
        letters[sign_letter(of, number)] = sign
    *steps, last = step_relations(of.robot.name)
    for step in steps:
        local = dict(letters)
        if not all(holds(relation, local) for relation in step):
            return False
        letters |= {name: value for name, value in local.items() if name[0] in "DFGHM"}
    return all(holds(relation, letters) for relation in last)


@pytest.mark.parametrize("name", [*EACH, *WHOLE])
def test_no_formula_is_wider_than_a_page(name: str) -> None:
    for relation in relations(list(unfolded(document_blocks(story(name))))):
        if len(box(relation)) == 1:
            for left, right in broken(relation, PLAIN):
                assert len(f"{left} {right}") <= 112, box(relation)
