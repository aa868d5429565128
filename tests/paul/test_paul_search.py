"""Which routes are found, and that they are the same ones on every machine."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.errors import UnsolvedError
from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.paul import form_reader
from dhgen.paul.derive import derive
from dhgen.paul.form import unknown_name
from dhgen.paul.further_forms import with_inverse_forms
from dhgen.paul.kind import Kind
from dhgen.paul.knowledge import initial_knowledge
from dhgen.paul.pool import build_pool
from dhgen.paul.problem import build_problem
from dhgen.paul.search import Search
from dhgen.paul.step import Step, learn
from dhgen.paul.types import QUARTIC
from dhgen.paul.witness import OWN_LENGTHS, build_witnesses
from dhgen.program.interpret import interpret
from dhgen.program.lowering.lower import lower
from dhgen.robot.load import load
from tests.kinematics.values import algebra_of, table
from tests.paul.arms import all_steps, derivation
from tests.robots.cases import NAMES, robot
from tests.structures import first_of

if TYPE_CHECKING:
    from dhgen.paul.derivation import Derivation

ROOT = Path(__file__).parents[2]
SLIDE_BEFORE_THE_LAST = """
name: arm
source: made up
convention: standard
joints:
  - {theta: q, d: 0.4, a: 0.1, alpha: -pi/2}
  - {theta: q, a: 0.4}
  - {theta: q, a: 0.1, alpha: -pi/2}
  - {theta: 0, d: q}
  - {theta: q, d: 0.1, alpha: pi/2}
  - {theta: q, d: 0.1}
"""
RAIL = build_chain(
    table(
        "theta: 0, d: q, alpha: -pi/2",
        "theta: q, a: L2",
        "theta: q, a: L3",
        parameters="{L2: 0.4, L3: 0.3}",
        task="pose",
    )
)


def route(name: str) -> list[tuple[int, str]]:
    """The types of a derivation and what they give."""
    return [
        (step.kind.number, " ".join(map(unknown_name, step.unknowns)))
        for step in derivation(name).steps
    ]


def kinds(name: str) -> set[int]:
    return {step.kind.number for step in all_steps(name)}


def places(steps: list[Step], kind: Kind) -> set[tuple[str, ...]]:
    return {tuple(o.name for o in step.origins) for step in steps if step.kind is kind}


@pytest.mark.parametrize("name", NAMES)
def test_routes_make_every_joint_known(name: str) -> None:
    knowledge = initial_knowledge(derivation(name).problem.algebra)
    for step in derivation(name).steps:
        after = learn(knowledge, step)
        assert after.missing == knowledge.missing - len(step.unknowns)
        knowledge = after
    assert knowledge.complete
    assert knowledge.open_joints == ()


def test_every_type_of_the_table_is_met() -> None:
    assert set().union(*map(kinds, NAMES)) >= set(range(1, 9))


def test_scara_by_type_8_from_u0_or_by_type_6_from_column_4_of_u1() -> None:
    # documents 001 and 003
    assert route("scara") == [(1, "r3"), (3, "theta124"), (8, "theta2"), (3, "theta1")]
    column = ("U0[1, 4]", "U0[2, 4]")
    assert [o.name for o in derivation("scara").steps[2].origins] == list(column)
    assert ("U1[1, 4]", "U1[2, 4]") in places(all_steps("scara"), Kind.TWO_ANGLES)


def test_the_slider_needs_type_5() -> None:
    assert route("planar_pr") == [(5, "theta2 r1")]


def test_a_plane_in_polar_coordinates_is_type_4() -> None:
    assert route("planar_rp") == [(4, "theta1 r2")]


def test_document_004() -> None:
    assert route("rrprrr") == [
        (2, "theta1"),
        (4, "theta2 r3"),
        (2, "theta4"),
        (3, "theta5"),
        (3, "theta6"),
    ]


def test_the_puma_is_decoupled_at_its_wrist() -> None:
    # document 001: q1, the triangle of the two links, then the wrist ZXZ
    wrist = [(2, "theta4"), (3, "theta5"), (3, "theta6")]
    assert route("puma") == [(2, "theta1"), (8, "theta3"), (3, "theta2"), *wrist]


def test_the_ur5_goes_by_quadratics() -> None:
    types = [step.kind for step in derivation("ur5").steps]
    assert types.count(Kind.ANGLE) == 2
    assert types.count(Kind.ANGLE_AND_SUM) == 1
    assert Kind.CIRCLE not in types
    assert [unknown for _, unknown in route("ur5")][3:5] == ["theta234", "theta3"]


@pytest.mark.parametrize("name", NAMES)
def test_offers_come_cheapest_first_and_hold_what_was_chosen(name: str) -> None:
    found = derivation(name)
    for step, offers in zip(found.steps, found.offers, strict=True):
        ranks = [(offer.roots, offer.penalty) for offer in offers]
        assert ranks == sorted(ranks)
        assert [offer.forms for offer in offers].count(step.forms) >= 1


@pytest.mark.parametrize("name", ["scara", "arm_6r", "stanford"])
def test_equal_choices_are_taken_in_the_same_order_again(name: str) -> None:
    again = derive(build_chain(robot(name)))
    assert shown(again) == shown(derivation(name))


@pytest.mark.parametrize("name", first_of(["kuka_iiwa14", "franka_panda"]))
def test_the_simplest_equations_give_the_order_that_all_of_them_give(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By the number of terms alone the last angles would come from short, silent equations."""
    found = derivation(name)
    monkeypatch.setattr(form_reader, "ENOUGH", 10**6)
    complete = derive(build_chain(robot(name)))
    assert [step.origins for step in complete.steps] == [step.origins for step in found.steps]
    assert sum(map(len, complete.offers)) > sum(map(len, found.offers))


def test_a_rail_with_two_links_is_solved_from_the_origin_of_frame_2() -> None:
    """Along the rail the last link is known from the pose: what is left across it is L2 c2."""
    found = derive(RAIL)
    first = found.steps[0]
    assert [unknown_name(step.unknowns[0]) for step in found.steps] == ["theta2", "r1", "theta23"]
    assert [step.roots for step in found.steps] == [2, 1, 1]
    l2 = found.problem.algebra.generator("L2")
    assert [first.coefficient(letter) for letter in "XY"] == [0, l2]


@pytest.mark.parametrize("numbers", [(1,), (9,), (2, 2), (2, 1, 3), (1, 1, 1)])
def test_whatever_steps_are_chosen_the_solutions_are_the_same(numbers: tuple[int, ...]) -> None:
    found = derive(RAIL, steps=numbers)
    for number, step, offers in zip(numbers, found.steps, found.offers, strict=False):
        assert step.forms == offers[number - 1].forms
    q = np.array([[0.3, 0.7, -1.1], [-0.2, -2.0, 0.4]])
    r1, theta2, theta3 = q.T  # the elbow on the other side of the rail's normal: c2 is the same
    other = np.stack([r1 - 2 * 0.4 * np.sin(theta2), -theta2, 2 * theta2 + theta3], axis=1)
    rows = interpret(lower(found), numeric_arm(RAIL).pose(q), np.zeros_like(q)).q
    for expected in (q, other):
        away = rows - expected[:, None]
        away[..., 1:] = np.abs(np.remainder(away[..., 1:] + np.pi, 2 * np.pi) - np.pi)
        assert np.nanmin(np.abs(away).max(axis=2), axis=1).max() < 1e-9
    assert np.isfinite(rows[..., 0]).sum() == 2 * len(q)


@pytest.mark.parametrize(
    ("arm", "numbers", "told"),
    [
        ("rail", (99,), "step 1 has [0-9]+ equations to choose from, not 99"),
        ("rail", (9, 1, 1, 1), "step 4 has 0 equations"),
        ("general_6r", (1,), "there are none to choose, the arm is solved as a whole"),
    ],
)
def test_steps_that_are_not_there_are_refused(
    arm: str, numbers: tuple[int, ...], told: str
) -> None:
    chain = RAIL if arm == "rail" else build_chain(robot(arm))
    with pytest.raises(UnsolvedError, match=told):
        derive(chain, steps=numbers)


def shown(found: Derivation) -> list[str]:
    steps = [*found.steps, *(offer for offers in found.offers for offer in offers)]
    return [f"{s.kind} {s.unknowns} {s.penalty} {s.coefficients} {s.origins}" for s in steps]


def test_a_factor_that_may_vanish_is_not_needed_where_a_constant_one_does(tmp_path: Path) -> None:
    """Column 4 gives c3 times a length, and elsewhere the same times c5, silent at c5 = 0."""
    path = tmp_path / "arm.yaml"
    path.write_text(SLIDE_BEFORE_THE_LAST, encoding="utf-8")
    found = derive(build_chain(load(path)))
    (elbow,) = (step for step in found.steps if unknown_name(step.unknowns[0]) == "theta3")
    factors = [elbow.coefficient(letter) for letter in "XY"]
    assert [bool(factor) for factor in factors] == [False, True]
    assert found.problem.algebra.is_constant(factors[1])


def test_an_equation_seen_from_both_ends_of_the_arm_is_not_two() -> None:
    """The squared distance of two points, from the base and from the tool: 0 = 0 of type 9."""
    link = ("theta: q, d: 0.1, alpha: pi/2", "theta: q, a: 0.1, alpha: -pi/2")
    algebra = algebra_of(table(*(link * 4), free="[1, 2]"))
    pool = with_inverse_forms(build_pool(build_problem(algebra)))
    assert Search(pool, QUARTIC).best() is None


def test_a_multiple_of_an_equation_with_constant_factors_is_not_needed() -> None:
    """x of the tool in the base is its place across axis 3 times s1, silent at s1 = 0."""
    arm = table(
        "theta: q",
        "theta: -pi/2, d: q, alpha: -pi/2",
        "theta: q, d: 0.26, a: 0.27, alpha: pi",
        "theta: pi/2, d: q, a: 0.24",
        "theta: q, alpha: -45 deg",
        "theta: q, alpha: -pi/2",
    )
    found = derive(build_chain(arm))
    _, elbow = (step for step in found.steps if step.kind is Kind.ANGLE)
    assert unknown_name(elbow.unknowns[0]) == "theta3"
    x, y = (build_witnesses(found.pool).evaluate(elbow.coefficient(letter)) for letter in "XY")
    assert np.hypot(x, y)[OWN_LENGTHS] == pytest.approx(np.hypot(0.27, 0.24))
