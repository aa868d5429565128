"""The axes that complete a pose where the tool only points: the sixth angle follows from them."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from tests.derivation.stories import document

NAME = "general_5r_pointing"
# d, a, alpha in degrees, and the tool behind the last: from robots/general_5r_pointing.yaml
ROWS = (0.35, 0.1, 75), (0.08, 0.4, 20), (-0.05, 0.3, -65), (0.12, 0.06, 80), (0.09, 0.05, -70)
PITCH = 0.4


def turn(axis: int, angle: float) -> np.ndarray:
    c, s = math.cos(angle), math.sin(angle)
    R = np.array([[c, -s], [s, c]])
    places = [k for k in range(3) if k != axis]
    found = np.eye(3)
    found[np.ix_(places, places)] = R if axis != 1 else R.T
    return found


def test_the_sixth_angle_of_the_example_is_that_of_the_axes() -> None:
    example = document(NAME).partition("## An example\n")[2].partition("\n## ")[0]
    values = re.findall(r"q_\d = (-?[\d.]+)\^", example.partition(" the tool is at")[0])
    R = np.eye(3)
    for (_, _, alpha), degrees in zip(ROWS, values, strict=True):
        R = R @ turn(2, math.radians(float(degrees))) @ turn(0, math.radians(alpha))
    R = R @ turn(1, PITCH)
    x, y, z = R[:, 2]
    sigma = 1.0 if z >= 0.0 else -1.0
    first = np.array([1 - sigma * x * x / (sigma + z), -sigma * x * y / (sigma + z), -sigma * x])
    second = np.array([-x * y / (sigma + z), sigma - y * y / (sigma + z), -y])
    chosen = np.column_stack([first, second, R[:, 2]])
    assert chosen @ chosen.T == pytest.approx(np.eye(3))
    assert np.linalg.det(chosen) == pytest.approx(1.0)
    sixth = R.T @ chosen
    (printed,) = re.findall(r"\\theta_6 = (-?[\d.]+)\^\\circ", example)
    assert math.degrees(math.atan2(sixth[1, 0], sixth[0, 0])) == pytest.approx(
        float(printed), abs=0.01
    )


def test_the_choice_and_the_constant_transforms_are_stated() -> None:
    text = document(NAME)
    assert r"\hat x = \left(1 - \frac{\sigma x^2}{\sigma + z},\; -\frac{\sigma x y}" in text
    assert r"$K_4$ is $A_5$ with $\theta_5 = 0$ and the tool's transform behind it" in text
