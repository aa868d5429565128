"""The example of an arm solved by iteration, worked through by hand from its Markdown.

The links are added up here, without the compiler's forward model.
"""

from __future__ import annotations

import re
from itertools import product

import numpy as np
import pytest

from tests.derivation.stories import document

TEXT = document("planar_rrrr")
LINK = 0.25  # of four, m: the arm's size is one
DIGITS = 2e-4  # what five digits leave of differences [rad, arm sizes]


def joints(line: str) -> np.ndarray:
    return np.radians([float(each) for each in re.findall(r"q_\d = (-?[\d.]+)\^", line)])


def matrices(text: str) -> list[np.ndarray]:
    """Those of numbers, in their order."""
    bodies = re.findall(r"\\begin\{bmatrix\} (.*?) \\end", text)
    rows = ([row.split(" & ") for row in body.split(r" \\ ")] for body in bodies)
    return [np.array(each, float) for each in rows]


def tip(q: np.ndarray) -> np.ndarray:
    angles = np.cumsum(q)
    return LINK * np.array([np.cos(angles).sum(), np.sin(angles).sum()])


def slopes(q: np.ndarray, h: float = 1e-6) -> np.ndarray:
    """The rows of the Jacobian by differences, (2, 4)."""
    return np.transpose([(tip(q + h * e) - tip(q - h * e)) / (2.0 * h) for e in np.eye(4)])


EXAMPLE = TEXT.partition("## An example\n")[2].partition("\n## ")[0]
OWN, SEED, ROW = (joints(line) for line in EXAMPLE.split("\n") if "q_4 = " in line)
POSE, MISS, AT_SEED, STEP, AT_ROW, AWAY, FACTORS = matrices(EXAMPLE)


def test_the_first_step_follows_from_its_formula() -> None:
    assert tip(OWN) == pytest.approx(POSE[:2, 3], abs=1e-5)
    (there,) = re.findall(r"There the tool is at \$x = (.*)\$, \$y = (.*)\$\.", EXAMPLE)
    assert tip(SEED) == pytest.approx(np.array(there, float), abs=1e-5)
    assert MISS[:, 0] == pytest.approx(tip(OWN) - tip(SEED), abs=1e-5)
    assert pytest.approx(slopes(SEED), abs=1e-5) == AT_SEED
    (damping,) = re.findall(r"\\lambda & = ([\d.]+)", EXAMPLE)
    assert float(damping) == pytest.approx(0.1 * float(MISS[:, 0] @ MISS[:, 0]), rel=1e-4)
    found = AT_SEED.T @ np.linalg.solve(AT_SEED @ AT_SEED.T + float(damping) * np.eye(2), MISS)
    assert pytest.approx(found, abs=DIGITS) == STEP


def test_the_row_is_a_solution_and_none_beside_it_is_nearer_to_the_seed() -> None:
    assert tip(ROW) == pytest.approx(POSE[:2, 3], abs=1e-5)
    assert pytest.approx(slopes(ROW), abs=1e-5) == AT_ROW
    assert AWAY[:, 0] == pytest.approx(ROW - SEED, abs=1e-5)
    assert pytest.approx(AWAY, abs=1e-5) == AT_ROW.T @ FACTORS
    assert np.linalg.norm(ROW - SEED) < np.linalg.norm(OWN - SEED)


def test_it_is_singular_where_it_says_and_nowhere_else() -> None:
    assert "$s_4 = s_{34} = s_{234} = 0$" in TEXT
    for q_1, *others in product((0.3, 2.0), (0.0, np.pi), (0.0, np.pi), (0.0, np.pi)):
        assert np.linalg.svd(slopes(np.array([q_1, *others])))[1][1] < 1e-9
    for place in range(3):
        q = np.array([0.3, 0.0, np.pi, 0.0])
        q[1 + place] += 0.7
        assert np.linalg.svd(slopes(q))[1][1] > 1e-2
