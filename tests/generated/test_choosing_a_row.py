"""What documents say of choosing a row: their numbers against what the C answers."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from tests.generated.solvers import GENERATED, library, robot

TURN = 2.0 * math.pi
CHOSEN = re.compile(
    r"with a seed of zeros, that is row (\d+)(?:, [^,]*)?, where the sum is \$([\d.]+)\$"
)
FLIPPED = "the other has $\\theta_4 + \\pi$, $-\\theta_5$, $\\theta_6 + \\pi$"


def text(name: str) -> str:
    return (GENERATED / f"{name}.md").read_text(encoding="utf-8")


def of_the_example(name: str) -> np.ndarray:
    """With q_1 = 45°, ... and r_3 = 0.2 the tool is at: the values of the caller's joints."""
    sentence = re.search(r"With (.*) the tool is at", text(name))
    assert sentence is not None
    numbers = re.findall(r"q_\{?\d+\}? = (-?[\d.]+)(\^\\circ)?", sentence[1])
    return np.array([math.radians(float(x)) if turns else float(x) for x, turns in numbers])


@pytest.mark.parametrize("name", ["abb_irb120", "kuka_kr6_r900", "puma560", "scara", "stanford"])
def test_the_row_that_is_nearest_to_zero(name: str) -> None:
    solver, seed = library(name), np.zeros(len(robot(name).joints))
    T = solver.fk(of_the_example(name))
    told = CHOSEN.search(text(name))
    assert told is not None
    rows, _ = solver.ik(T, seed)
    nearest = solver.nearest(T, seed)
    off = np.abs(np.remainder(rows - nearest + math.pi, TURN) - math.pi)
    assert int(told[1]) == int(np.nanargmin(off.max(axis=1)))
    size = re.search(r"lengths divided by the size of the arm, \$([\d.]+)\$", text(name))
    slides = [joint.kind.name == "PRISMATIC" for joint in robot(name).joints]
    scaled = nearest / np.where(slides, float(size[1]) if size else 1.0, 1.0)
    assert float(scaled @ scaled) == pytest.approx(float(told[2]), rel=1e-4)


@pytest.mark.parametrize("name", ["abb_irb120", "kuka_kr6_r900", "puma560", "stanford"])
def test_two_ways_to_turn_the_wrist(name: str) -> None:
    assert FLIPPED in text(name)
    rows, _ = library(name).ik(library(name).fk(of_the_example(name)), np.zeros(6))
    one, other = rows[0::2], rows[1::2]
    assert np.nanmax(np.abs((other - one)[:, :3])) < 1e-12
    half = np.array([math.pi, 0.0, math.pi])
    turned = other[:, 3:] - one[:, 3:] - half
    turned[:, 1] = other[:, 4] + one[:, 4]  # offsets of joint 5 are whole or half turns
    assert np.nanmax(np.abs(np.remainder(turned + math.pi / 2, math.pi) - math.pi / 2)) < 1e-12


def test_an_oblique_wrist_has_no_such_pair() -> None:
    assert "up to whole turns" not in text("wrist_oblique")


@pytest.mark.parametrize("name", ["fanuc_lrmate200id_j23", "scara_ball_screw"])
def test_where_turns_are_chosen_together_no_nearest_row_is_worked_out(name: str) -> None:
    chosen = text(name).split("## Choosing a row")[1].split("\n## ")[0]
    assert "with a seed of zeros" not in chosen
    assert "No joint has limits" not in chosen
