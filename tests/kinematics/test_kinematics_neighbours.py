from __future__ import annotations

import math

import pytest

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.neighbours import axis_triples
from tests.kinematics.values import table
from tests.robots.cases import robot

WRIST = ("theta: q, d: 0.4, alpha: -pi/2", "theta: q, d: {d5}, alpha: pi/2", "theta: q, d: 0.1")


def wrist(d5: str) -> tuple[str, ...]:
    return tuple(row.format(d5=d5) for row in WRIST)


def test_a_spherical_wrist_meets_in_one_point() -> None:
    (triple,) = axis_triples(build_chain(table(*wrist("0"))))
    assert triple.joints == (1, 2, 3)
    assert triple.miss == pytest.approx(0, abs=1e-15)
    assert triple.tilt == pytest.approx(math.pi / 2)


def test_an_offset_wrist_misses_by_its_offset() -> None:
    (triple,) = axis_triples(build_chain(table(*wrist("-0.03"))))
    assert triple.miss == pytest.approx(0.03)


def test_parallel_and_nearly_parallel_axes() -> None:
    found = {t.joints: t for t in axis_triples(build_chain(robot("ur5")))}
    assert found[2, 3, 4].tilt == pytest.approx(0, abs=1e-15)
    assert found[2, 3, 4].miss == math.inf
    rows = ("theta: q, a: 1, alpha: 2 deg", "theta: q, a: 1, alpha: -1 deg", "theta: q")
    (triple,) = axis_triples(build_chain(table(*rows)))
    assert math.degrees(triple.tilt) == pytest.approx(2)


def test_only_revolute_joints_that_are_not_given() -> None:
    assert axis_triples(build_chain(robot("spherical"))) == ()  # RRP
    seven = ("theta: q, d: 0.3, alpha: pi/2",) * 7
    joints = [t.joints for t in axis_triples(build_chain(table(*seven, free="[3]")))]
    assert joints == [(4, 5, 6), (5, 6, 7)]


def test_slides_turn_no_axis_and_points_across_them_are_not_told() -> None:
    (triple,) = axis_triples(build_chain(robot("scara")))  # RRPR
    assert triple.joints == (1, 2, 4)
    assert triple.tilt == pytest.approx(0, abs=1e-15)
    assert triple.miss == math.inf
    first, *others = wrist("0")
    (triple,) = axis_triples(build_chain(table(first, "d: q", *others)))
    assert triple.joints == (1, 3, 4)
    assert triple.miss == math.inf
