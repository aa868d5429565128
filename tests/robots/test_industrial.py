"""The industrial arms in poses that everyone who uses them knows."""

from __future__ import annotations

from dhgen.oracle.forward import forward
from tests.robots.cases import assert_close, lengths, robot


def test_ur5_lies_along_minus_x_at_zero() -> None:
    T = forward(robot("ur5"), [0] * 6)
    assert_close(T[:3, 3], [-0.81725, -0.19145, -0.005491])


def test_puma560_reaches_forward_at_zero() -> None:
    p = lengths("puma560")
    T = forward(robot("puma560"), [0] * 6)
    assert_close(T[:3, 3], [p["a2"] + p["a3"], -p["d3"], p["d1"] + p["d4"]])


def test_stanford_slides_upwards_at_zero() -> None:
    p = lengths("stanford")
    T = forward(robot("stanford"), [0, 0, 0.5, 0, 0, 0])
    assert_close(T[:3, 3], [0, p["d2"] - p["a3"], p["d1"] + 0.5])


def test_kuka_stands_upright_at_zero() -> None:
    p = lengths("kuka_kr6_r900")
    T = forward(robot("kuka_kr6_r900"), [0] * 6)
    assert_close(T[:3, 3], [p["a1"] - p["a3"], 0, p["d1"] + p["a2"] + p["d4"] + p["d6"]])
