"""Singular sets are singular, and of the kinds that the arm's books name."""

from __future__ import annotations

import numpy as np
import pytest

from dhgen.oracle.forward import jacobian
from dhgen.survey.singular import in_a_family, singular_sets
from tests.robots.cases import robot
from tests.structures import first_of


def distance(values: np.ndarray, *places: float) -> np.ndarray:
    gap = np.abs(values[:, None] - np.array(places))
    return np.asarray(np.abs(gap - 2 * np.pi * np.round(gap / (2 * np.pi))).min(axis=1))


def least(name: str, q: np.ndarray) -> np.ndarray:
    return np.asarray(np.linalg.svd(jacobian(robot(name), q), compute_uv=False)[:, -1])


@pytest.mark.parametrize(
    "name", first_of(["puma560", "stanford", "ur5", "xarm5", "concurrent_345"], count=2)
)
def test_they_are_singular(name: str) -> None:
    sets = singular_sets(robot(name), 20)
    exact = [q for kind, q in sets.items() if kind.startswith("singular by")]
    assert exact or len(robot(name).joints) < 6
    for q in exact:
        assert least(name, q).max() < 1e-9


def test_those_of_the_puma() -> None:
    sets = singular_sets(robot("puma560"), 50)
    assert {kind for kind in sets if kind.startswith("singular by")} == {
        f"singular by joint {joint}" for joint in (2, 3, 5)
    }
    assert all(len(q) == 50 for q in sets.values())
    # the wrist straight
    assert distance(sets["singular by joint 5"][:, 4], 0.0, np.pi).max() < 1e-12
    # the elbow stretched and folded, beside the forearm's offset; or the wrist above axis 1
    elbow = np.arctan2(0.0203, 0.4318)
    straight = distance(sets["singular by joint 3"][:, 2], elbow + np.pi / 2, elbow - np.pi / 2)
    assert 10 < np.count_nonzero(straight < 1e-9) < 50


def test_a_planar_arm_is_singular_where_it_is_straight() -> None:
    sets = singular_sets(robot("planar_rr"), 50)
    q = sets["singular by joint 2"]
    assert distance(q[:, 1], 0.0, np.pi).max() < 1e-12
    assert {0, 1} == set(np.round(np.abs(q[:, 1]) / np.pi).astype(int))
    beside = distance(sets["nearly singular by joint 2"][:, 1], 0.0, np.pi)
    assert beside.min() > 0.9e-10
    assert beside.max() < 1.1e-6


def test_free_joints_are_left_alone() -> None:
    assert "singular by joint 3" not in singular_sets(robot("kuka_iiwa14"), 5)
    assert "singular by joint 4" in singular_sets(robot("kuka_iiwa14"), 5)


@pytest.mark.parametrize("name", ["ur5", "fanuc_lrmate200id_j23"])
def test_a_straight_wrist_has_a_family_and_a_bent_one_has_none(name: str) -> None:
    """Also where drives move other joints than their own."""
    straight, bent = ([0.3, 0.4, 0.5, 0.6, angle, 0.7] for angle in (0.0, 0.1))
    assert in_a_family(robot(name), np.array(straight))
    assert not in_a_family(robot(name), np.array(bent))
