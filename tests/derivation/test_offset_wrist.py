"""What is told of an offset wrist holds for any joint values, by the axes where they stand."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from dhgen.kinematics.numeric import numeric_arm
from tests.derivation.stories import story
from tests.derivation.test_wording import text_of


@pytest.mark.parametrize("name", ["xarm6", "abb_gofa_5", "fanuc_crx10ia", "yaskawa_hc10"])
def test_the_polynomial_vanishes_at_the_sixth_angle(name: str) -> None:
    text = text_of(name)
    arm = numeric_arm(story(name).algebra.chain)
    upper, lower, psi = triangle(name, text)
    C, S = math.cos(psi), math.sin(psi)
    draw = np.random.default_rng(6)
    for q in draw.uniform(-3.0, 3.0, (20, 6)):
        e, points = arm.axes(q)
        W = meeting(e[3], points[3], e[4], points[4]) - meeting(e[0], points[0], e[1], points[1])
        w, c, h, k = W @ W, W @ e[4], W @ e[0], e[0] @ e[4]
        rho2, m = w - h * h, k * w - h * c
        Q, D = w - upper**2 + lower**2, 4 * upper**2 * w - (upper**2 - lower**2 + w) ** 2
        U = c**2 * rho2 * (Q**2 * C**2 + D * S**2) - m**2 * (Q**2 * S**2 + D * C**2)
        V = Q * 2 * S * C * (c**2 * rho2 + m**2)
        size = (c**2 * rho2 + m**2) * (Q**2 + abs(D))
        assert abs(U * U - V * V * D) < 1e-12 * size**2
        if "serves two of the four ways" in text:
            assert abs(U) < 1e-12 * size
        B = points[2] + ((W + meeting_of_first(e, points) - points[2]) @ e[2]) * e[2]
        BW = W + meeting_of_first(e, points) - B
        turned = math.atan2(np.cross(BW, e[3]) @ e[2], BW @ e[3])
        assert abs(math.remainder(turned - psi, 2.0 * math.pi)) < 1e-9


def meeting_of_first(e: np.ndarray, p: np.ndarray) -> np.ndarray:
    """S of an arm, by its axes."""
    return meeting(e[0], p[0], e[1], p[1])


def triangle(name: str, text: str) -> tuple[float, float, float]:
    """Both sides and the angle as they are printed, with the lengths of the arm."""
    said = re.search(r"here \$a = (.*?)\$, \$r = (.*?)\$ and \$\\psi = (.*?)\$", text)
    assert said
    known = {letter(each.name): each.value for each in story(name).algebra.chain.constants}
    values = []
    for formula in said.groups():
        python = re.sub(r"\\mathrm{(\w+)}", r"\1", formula)
        python = re.sub(r"\\sqrt{(.*)}", r"sqrt(\1)", python).replace("^", "**")
        values.append(eval(python, {"sqrt": math.sqrt, "atan2": math.atan2}, known))  # noqa: S307
    upper, lower, psi = map(float, values)
    return upper, lower, psi


def letter(name: str) -> str:
    """How a length is printed: a_3."""
    return re.sub(r"(\d+)$", r"_\1", name)


def meeting(e: np.ndarray, p: np.ndarray, f: np.ndarray, o: np.ndarray) -> np.ndarray:
    """The point where two lines meet."""
    along = np.linalg.lstsq(np.stack([e, -f], axis=1), o - p, rcond=None)[0]
    assert np.linalg.norm(p + along[0] * e - o - along[1] * f) < 1e-9
    return np.asarray(p + along[0] * e)


def test_the_triangle_gives_the_condition() -> None:
    """Any S, B, W in a plane with the first axis: turned sides, by vectors and by the formula."""
    draw = np.random.default_rng(7)
    for tau in (-1.0, 1.0):
        u, SW, n = draw.normal(size=(3, 3))
        u, n, psi = u / np.linalg.norm(u), n / np.linalg.norm(n), 0.7
        w, c, h, k = SW @ SW, SW @ n, SW @ u, u @ n
        upper, lower = 0.6 * math.sqrt(w), 0.8 * math.sqrt(w)
        rho, m = math.sqrt(w - h * h), k * w - h * c
        Q, D = w - upper**2 + lower**2, 4 * upper**2 * w - (upper**2 - lower**2 + w) ** 2
        along, across = SW / math.sqrt(w), tau * (w * u - h * SW) / (rho * math.sqrt(w))
        assert np.allclose([along @ along, across @ across, along @ across], [1, 1, 0])
        for epsilon in (-1.0, 1.0):
            BW = (Q * along - epsilon * math.sqrt(D) * across) / (2 * math.sqrt(w))
            assert np.linalg.norm(BW) == pytest.approx(lower)
            assert np.linalg.norm(SW - BW) == pytest.approx(upper)
            C, S, root = math.cos(psi), math.sin(psi), epsilon * math.sqrt(D)
            turned = (BW @ along) * (C * along + S * across)
            turned += (BW @ across) * (C * across - S * along)
            condition = c * rho * (Q * C + root * S) + tau * m * (Q * S - root * C)
            assert turned @ n == pytest.approx(condition / (2 * w * rho))
