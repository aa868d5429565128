from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dhgen.kinematics.algebra import AngleSum
from dhgen.paul.form import Length
from dhgen.paul.form_reader import FormReader
from dhgen.paul.knowledge import Knowledge, initial_knowledge
from dhgen.paul.step import learn
from tests.kinematics.values import algebra_of, joint_values, number, table
from tests.paul.arms import derivation, random_values
from tests.robots.cases import NAMES, robot


def angle(*joints: int) -> AngleSum:
    return AngleSum(tuple((abs(joint), 1 if joint > 0 else -1) for joint in joints))


@pytest.mark.parametrize("name", NAMES)
def test_forms_hold_and_keep_unknowns_out_of_their_coefficients(name: str) -> None:
    found = derivation(name)
    algebra = found.problem.algebra
    reader = FormReader(found.pool)
    knowledge = initial_knowledge(algebra)
    points = random_values(name, 2)
    for step in (*found.steps, None):
        hidden = {
            algebra.index[each]
            for a in algebra.angles
            if not knowledge.knows(a)
            for each in (a.cosine, a.sine)
        }
        hidden |= {algebra.index[n] for j, n in algebra.slides.items() if j not in knowledge.slides}
        for form in reader.forms(knowledge):
            assert 1 <= len(form.unknowns) <= 2
            for values in points:
                parts = [
                    number(factor, values) * math.prod(values[each] for each in monomial)
                    for monomial, factor in form.terms.items()
                ]
                assert abs(sum(parts)) <= 1e-11 * max(1e-3, *map(abs, parts))
            for factor in form.terms.values():
                assert not any(powers[place] for powers in factor for place in hidden)
        if step is not None:
            knowledge = learn(knowledge, step)
    assert reader.forms(knowledge) == []
    assert knowledge.complete


def test_a_sum_with_one_part_known_is_the_other_part() -> None:
    start = initial_knowledge(algebra_of(robot("ur5")))
    knowledge = start.with_angle(angle(2))
    assert start.representative(angle(2, 3)) == angle(2, 3)
    assert knowledge.representative(angle(2, 3)) == angle(3)
    assert knowledge.representative(angle(2, 3, 4)) == angle(3, 4)
    assert knowledge.with_angle(angle(2, 3, 4)).representative(angle(3)) == angle(3)
    assert knowledge.with_angle(angle(2, 3, 4)).representative(angle(4)) == angle(3)


def test_two_sums_make_their_difference_known() -> None:
    start = initial_knowledge(algebra_of(robot("ur5")))
    knowledge = start.with_angle(angle(2)).with_angle(angle(2, 3))
    assert knowledge.knows(angle(3))
    assert not knowledge.knows(angle(4))
    assert knowledge.open_joints == (1, 4, 5, 6)
    assert (start.missing, knowledge.missing) == (6, 4)
    assert knowledge.with_angle(angle(2, 3, 4)).knows(angle(4))


ANTIPARALLEL = table(
    *["theta: q, a: 1, alpha: pi"] * 2, "theta: q, a: 1", "theta: q, a: 1, alpha: pi", "theta: q"
)


@settings(max_examples=80)
@given(st.lists(st.integers(0, 14), max_size=3), st.lists(st.floats(-3, 3), min_size=5, max_size=5))
def test_rewriting_changes_no_value(known: list[int], q: list[float]) -> None:
    algebra = algebra_of(ANTIPARALLEL)
    knowledge: Knowledge = initial_knowledge(algebra)
    for number_of_angle in known:
        knowledge = knowledge.with_angle(algebra.angles[number_of_angle])
    values = joint_values(algebra, np.array(q))
    angle_of = {name: a for a in algebra.angles for name in (a.cosine, a.sine)}
    for total in algebra.angles:
        if knowledge.knows(total):
            continue
        shortest = knowledge.representative(total)
        assert len(shortest.terms) <= len(total.terms)
        cosine, sine = knowledge.rewritten(total)
        assert number(cosine, values) == pytest.approx(values[total.cosine], abs=1e-12)
        assert number(sine, values) == pytest.approx(values[total.sine], abs=1e-12)
        generators = [symbol.name for symbol in cosine.ring.symbols]
        for powers in (*cosine, *sine):
            for name, power in zip(generators, powers, strict=True):
                if power and name in angle_of and not knowledge.knows(angle_of[name]):
                    assert angle_of[name] == shortest


def test_equations_with_two_sums_of_one_unknown_are_written_in_it() -> None:
    found = derivation("puma560")
    reader = FormReader(found.pool)
    start = initial_knowledge(found.problem.algebra)
    both = {form.equation.origin: form for form in reader.forms(start.with_angle(angle(1)))}
    crowded = [form for form in both.values() if form.unknowns == (angle(2), angle(2, 3))]
    assert crowded
    knowledge = start.with_angle(angle(1)).with_angle(angle(2))
    after = {form.equation.origin: form for form in reader.forms(knowledge)}
    # theta2 is known now; a lone c23 is left as U_i gives it
    assert {after[form.equation.origin].unknowns for form in crowded} == {(angle(2, 3),)}


def test_lengths_come_after_angles() -> None:
    found = derivation("spherical")
    reader = FormReader(found.pool)
    knowledge = initial_knowledge(found.problem.algebra).with_angle(angle(1))
    pairs = {form.unknowns for form in reader.forms(knowledge) if len(form.unknowns) == 2}
    assert pairs == {(angle(2), Length(3, "r3"))}
