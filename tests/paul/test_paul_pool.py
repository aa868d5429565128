from __future__ import annotations

import pytest

from dhgen.paul.equation import Origin, common_origins
from tests.paul.arms import all_steps, assert_zero, derivation, random_values
from tests.robots.cases import NAMES


@pytest.mark.parametrize("name", NAMES)
def test_every_equation_holds_everywhere(name: str) -> None:
    equations = derivation(name).pool.equations
    assert equations
    for values in random_values(name):
        for equation in equations:
            assert_zero(equation.difference, values)


@pytest.mark.parametrize("name", NAMES)
def test_equations_are_kept_once_and_say_all_their_places(name: str) -> None:
    equations = derivation(name).pool.equations
    seen = [equation.difference for equation in equations]
    assert len({*seen, *(-each for each in seen)}) == 2 * len(seen)
    places = [origin for equation in equations for origin in equation.origins]
    assert len(set(places)) == len(places)
    for equation in equations:
        assert equation.origins[0] == equation.origin
        assert equation.difference in (
            equation.right - equation.left,
            equation.left - equation.right,
        )


@pytest.mark.parametrize("name", ["scara", "planar_rr", "arm_3r", "wrist_zyz"])
def test_no_equation_uses_what_the_task_leaves_open(name: str) -> None:
    problem = derivation(name).problem
    given = {problem.algebra.index[entry] for entry in problem.known}
    poses = {problem.algebra.index[f"t{i}{j}"] for i in (1, 2, 3) for j in (1, 2, 3, 4)}
    for equation in derivation(name).pool.equations:
        used = {p for monomial in equation.difference for p, e in enumerate(monomial) if e}
        assert not used & (poses - given)


def test_the_matrix_of_document_004() -> None:
    # column 4 of U1 = A2 A3: s1 t14 - c1 t24 = 0 is its second row
    places = {str(e.difference): e.origins for e in derivation("rrprrr").pool.equations}
    (found,) = [o for text, o in places.items() if text in {"t14*s1 - t24*c1", "-t14*s1 + t24*c1"}]
    assert Origin(1, 6, 6, 2, 4) in found


def test_the_wrist_centre_is_a_named_point_behind_joint_6() -> None:
    # p - d6 a: the origin of frame 5 from the pose alone (document 003)
    (point,) = derivation("arm_6r").pool.points
    assert [str(entry) for entry in point.in_tool] == ["0", "0", "-d6"]


def test_places_have_names() -> None:
    assert Origin(2, 6, 6, 3, 4).name == "U2[3, 4]"
    assert Origin(1, 5, 6, 3, 4).name == "U1 A6^-1 [3, 4]"
    assert Origin(0, 4, 6, 1, 2).name == "U0 (A5 A6)^-1 [1, 2]"
    assert Origin(1, 6, 6, 0, 4).name == "the squared length of column 4 of U1"
    assert Origin(1, 5, 6, 0, 4).name == "the squared length of column 4 of U1 A6^-1"


@pytest.mark.parametrize("name", NAMES)
def test_steps_show_their_forms_side_by_side(name: str) -> None:
    for step in all_steps(name):
        assert len(step.origins) == len(step.forms)
        for origin, form in zip(step.origins, step.forms, strict=True):
            assert origin in form.equation.origins
        if len(step.forms) == 2:
            first, second = step.origins
            assert (first.m, first.k) == (second.m, second.k)
            assert first.row == second.row or first.column == second.column
            assert first.row * second.row > 0
        unmixed = [all(not o.is_mixed for o in f.equation.origins) for f in step.forms]
        if all(unmixed):
            assert not any(origin.is_mixed for origin in step.origins)


def test_a_common_place_without_joints_from_the_right_comes_first() -> None:
    # two equations of the UR5 first stand in mixed forms, but also in U1: that is the one to show
    for step in derivation("ur5").steps[-2:]:
        assert [origin.name for origin in step.origins] == ["U1[2, 4]", "U1[1, 4]"]
    assert common_origins([f.equation for f in derivation("scara").steps[-1].forms]) == (
        Origin(0, 4, 4, 2, 4),
        Origin(0, 4, 4, 1, 4),
    )


def test_equations_of_different_matrices_have_no_common_place() -> None:
    steps = {step.unknowns: step for step in derivation("puma560").steps}
    first, *_, last = steps.values()
    assert common_origins([first.forms[0].equation, last.forms[0].equation]) == ()
