"""Second equations: which steps have one, and that it holds."""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.paul.common_zeros import outlasts
from dhgen.paul.equation import MOMENT
from dhgen.paul.fallback_equation import across
from dhgen.paul.witness import build_witnesses
from tests.paul.arms import derivation
from tests.structures import first_of


@pytest.mark.parametrize(
    ("name", "column", "place"),
    [
        ("bartell_rprpr", MOMENT, "U1[3] x U1[4], element 2"),
        ("katana_400", 3, "U1[3, 3]"),
        ("scorbot_pointing", 3, "U1[3, 3]"),
    ],
)
def test_where_it_stands(name: str, column: int, place: str) -> None:
    second = derivation(name).steps[0].fallback
    assert second is not None
    (origin,) = second.origins
    assert (origin.column, origin.name) == (column, place)


@pytest.mark.parametrize("name", first_of(["katana_400", "bartell_rprpr", "xarm5", "kuka_youbot"]))
def test_it_holds_and_stays(name: str) -> None:
    made = derivation(name)
    step, algebra = made.steps[0], made.problem.algebra
    assert step.fallback is not None
    (form,) = step.fallback.forms
    difference = build_witnesses(made.pool).evaluate(form.equation.difference)
    assert np.abs(difference).max() < 1e-9
    first, other = across(made.pool, step), across(made.pool, step.fallback)
    assert outlasts(algebra, other, first)
    assert not outlasts(algebra, first, first)
    assert not outlasts(algebra, other * first, first)


@pytest.mark.parametrize("name", ["puma560", "ur5", "stanford", "rail_5dof", "craig_417"])
def test_none_is_needed(name: str) -> None:
    assert all(step.fallback is None for step in derivation(name).steps)
