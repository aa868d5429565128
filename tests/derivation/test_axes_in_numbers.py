"""An arm given by axes whose points are numbers: their letters, and what becomes of differences."""

from __future__ import annotations

import math
import re
from functools import cache, reduce

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from tests.derivation.made import made_for
from tests.derivation.stories import document, story
from tests.derivation.values import letters_of
from tests.kinematics.values import axes


@cache
def written(third: float = 0.3) -> str:
    """Three parallel axes, slanted, between two others; where the middle one is."""
    return made_for(
        axes(
            "type: revolute, direction: [0, 0, 1], point: [0, 0, 0]",
            "type: revolute, direction: [0, 1, 1], point: [0, 0, 0.3]",
            f"type: revolute, direction: [0, 1, 1], point: [{third}, 0, 0.3]",
            "type: revolute, direction: [0, 1, 1], point: [0.6, 0, 0.3]",
            "type: revolute, direction: [1, 0, 0], point: [0.6, 0.1, 0.3]",
            "type: revolute, direction: [0, 0, 1], point: [0.9, 0.1, 0.3]",
            home="{xyz: [0.9, 0.1, 0.5], rpy: [90 deg, 0 deg, 45 deg]}",
        )
    )


@pytest.mark.breadth
def test_entries_of_the_pose_and_points_of_axes_have_letters_of_their_own() -> None:
    text = written()
    assert r"With $\mathit{POS} = (m_{ij})$ its entries are" in text
    assert "p_{3x}" in text
    assert "p_{12}" not in text


@pytest.mark.slow
def test_lengths_that_cancel_are_left_out() -> None:
    text = written()
    assert r"$\sqrt{Z_1^2 + Z_2^2}$ is greater than $p_{4x}$. The two" in text  # never less than 0
    reach = r"is greater than $p_{4x}$ or less than $2 p_{3x} - p_{4x}$"
    assert reach in written(0.4)
    assert "| $K^2 = Y^2$ | $s_3 = 0$ |" in text


def about(direction: list[float], point: list[float], angle: float) -> np.ndarray:
    """A turn about an axis through a point, by Rodrigues' formula."""
    k, p = np.array(direction) / np.linalg.norm(direction), np.array(point)
    K = np.array([[0, -k[2], k[1]], [k[2], 0, -k[0]], [-k[1], k[0], 0]])
    T = np.eye(4)
    T[:3, :3] += math.sin(angle) * K + (1 - math.cos(angle)) * K @ K
    T[:3, 3] = p - T[:3, :3] @ p
    return T


def of_the_puma(q: list[float]) -> dict[str, float]:
    """The cosines and sines of its joints."""
    functions = {"c": math.cos, "s": math.sin}
    return {f"{n}_{j}": f(x) for j, x in enumerate(q, start=1) for n, f in functions.items()}


def cell_of(cell: str, known: dict[str, float]) -> float:
    """An entry of a printed matrix in numbers."""
    python = re.sub(r"(?<=[\w)]) (?=[\w(])", " * ", cell.strip())
    return float(eval(python, {}, known))  # noqa: S307  our own text


def test_frames_come_out_of_the_motions_of_document_001() -> None:
    """The document's K_i, from the axes as the robot file has them."""
    L2, D3, D4 = 0.4318, 0.15005, 0.4318
    x, z = [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]
    lines: list[tuple[list[float], list[float]]] = [(z, [0, 0, 0]), (x, [0, 0, 0]), (x, [0, 0, L2])]
    lines += [(z, [D3, 0, 0]), (x, [D3, 0, L2 + D4]), (z, [D3, 0, 0])]
    of, q = story("puma"), [0.3, -0.7, 1.1, 0.4, -0.9, 0.6]
    here, zero = letters_of(of, q), letters_of(of, [0.0] * 6)
    K = [about(*line, angle) for line, angle in zip(lines, q, strict=True)]
    F = [np.eye(4)]
    for joint in "₁₂₃₄₅₆":
        F.append(F[-1] @ zero[f"A{joint}"])
    for i, joint in enumerate("₁₂₃₄₅₆"):
        assert np.allclose(here[f"A{joint}"], np.linalg.inv(F[i]) @ K[i] @ F[i + 1])
    assert np.allclose(
        forward(of.robot, np.array(q)), reduce(np.matmul, K)
    )  # the tool begins there
    text = document("puma").splitlines()
    for i, matrix in enumerate(K):
        printed = next(line for line in text if f"K_{i + 1} = \\begin" in line)
        printed = printed.split(f"K_{i + 1} = \\begin{{bmatrix}}")[1].split(r"\end")[0]
        known = dict(of_the_puma(q), L_2=L2, D_3=D3, D_4=D4)
        cells = [row.split("&") for row in printed.split(r"\\")]
        assert np.allclose([[cell_of(cell, known) for cell in row] for row in cells], matrix)
    told = next(line for line in text if line.startswith("If $F_i$ is"))
    assert r"$A_i = F_{i-1}^{-1} K_i F_i$" in told
