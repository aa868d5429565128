"""The robot files say what the published tables say: same poses, limits and tasks.

`tables.json` holds the tables as their sources give them, with every digit of a conversion; its
forward model here is the textbook's product of four matrices a row.
"""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from dhgen.oracle.forward import forward
from tests.robots.cases import ROBOTS, about, robot

Table = dict[str, Any]

# Not every table has a robot file: joints 5 and 6 of this arm turn about one axis.
REFUSED = {"degenerate_collinear_56"}
# Strokes and a task that the table leaves open.
CHOSEN = {"cartesian"}


@cache
def tables() -> dict[str, Table]:
    text = (Path(__file__).parent / "tables.json").read_text(encoding="utf-8")
    return {table["name"]: table for table in json.loads(text)}


NAMES = sorted(set(tables()) - REFUSED)


def number(cell: str, q: float) -> float:
    """A cell: a sum of q, numbers and simple fractions of pi."""
    total = 0.0
    for term in cell.replace("(", "").replace(")", "").split(" + "):
        factor, _, divisor = term.replace("pi", str(np.pi)).partition("/")
        total += q if factor == "q" else float(factor) / float(divisor or 1)
    return total


def along(axis: int, length: float) -> np.ndarray:
    T = np.eye(4)
    T[axis, 3] = length
    return T


def pose(table: Table, q: np.ndarray) -> np.ndarray:
    """Z A_1 ... A_n E by the matrices of the convention."""
    T = np.array(table.get("base", np.eye(4)))
    for joint, value in zip(table["joints"], q, strict=True):
        cells = (number(joint[name], value) for name in ("theta", "d", "a", "alpha"))
        theta, d, a, alpha = cells
        z = about("z", theta, np.zeros(3)) @ along(2, d)
        x = about("x", alpha, np.zeros(3)) @ along(0, a)
        T = T @ (z @ x if table["convention"] == "standard" else x @ z)
    return np.array(T @ np.array(table.get("tool", np.eye(4))))


def test_every_table_has_a_robot_file() -> None:
    files = {path.stem for path in ROBOTS.glob("*.yaml")}
    assert set(tables()) - files == REFUSED


@pytest.mark.parametrize("name", NAMES)
def test_poses_are_those_of_the_table(name: str) -> None:
    table = tables()[name]
    source = np.random.default_rng(5)
    for q in source.uniform(-3, 3, (20, len(table["joints"]))):
        np.testing.assert_allclose(forward(robot(name), q), pose(table, q), rtol=0, atol=1e-12)


@pytest.mark.parametrize("name", NAMES)
def test_what_is_asked_is_that_of_the_table(name: str) -> None:
    table = tables()[name]
    assert robot(name).free == tuple(table.get("free", ()))
    assert name in CHOSEN or robot(name).task.kind.value == table.get("task", "pose")
    limits = [joint.limits for joint in robot(name).joints]
    for pair, row in zip(limits, table["joints"], strict=True):
        if "limits" in row:
            assert pair == pytest.approx(row["limits"], abs=1e-9)
        else:
            assert name in CHOSEN or pair is None
