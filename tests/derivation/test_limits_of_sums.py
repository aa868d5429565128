"""Limits of sums of joint values, and whole turns, in derivations and in what solvers return."""

from __future__ import annotations

import math
import re
from itertools import product

import numpy as np
import pytest

from dhgen.derivation.document import document_blocks
from dhgen.derivation.french.language import French
from dhgen.derivation.text.plain import plain
from dhgen.derivation.whole_turns import are_inside, turned_rows
from dhgen.kinematics.build import build_chain
from dhgen.runtime.python.status import OUT_OF_LIMITS
from tests.derivation.made import made_of
from tests.derivation.stories import document, story_of
from tests.derivation.test_french import COMMITTED
from tests.kinematics.values import table
from tests.targets.made import made_up, solving

ROWS = "theta: q, a: 0.5", "theta: q, a: 0.35"
OWN = "theta: q, a: 0.5, limits: [-190 deg, 170 deg]", "theta: q, a: 0.35, limits: [0, 350 deg]"
LOW, HIGH = 100, 300


def sum_limit(low: int = LOW, high: int = HIGH) -> str:
    return f"[{{of: q1 + q2, from: {low} deg, to: {high} deg}}]"


@pytest.mark.parametrize("rows", [ROWS, OWN])
@pytest.mark.parametrize(("low", "high"), [(LOW, HIGH), (-150, -80), (380, 420)])
def test_the_example_keeps_limits_of_sums(rows: tuple[str, ...], low: int, high: int) -> None:
    """Its own joint values as they are printed, and the row from which it came."""
    of = story_of(table(*rows, task="[x, y]", limits=sum_limit(low, high)))
    example = of.example
    assert example is not None
    assert low - 1e-6 <= np.degrees(example.q.sum()) <= high + 1e-6
    np.testing.assert_allclose(example.rows[example.followed], example.q, rtol=0, atol=1e-9)
    assert example.inside[example.followed]


@pytest.mark.parametrize("rows", [ROWS, OWN])
@pytest.mark.parametrize(("low", "high"), [(LOW, HIGH), (-350, -250), (20, 60)])
def test_rows_have_the_turns_that_keep_all_limits(
    rows: tuple[str, ...], low: int, high: int
) -> None:
    """Of all copies within four turns, tried one by one, the nearest to zero that keeps them."""
    chain = build_chain(table(*rows, task="[x, y]", limits=sum_limit(low, high)))
    ends = np.array([joint.limits or (-np.inf, np.inf) for joint in chain.joints])
    for q in np.random.default_rng(5).uniform(-math.pi, math.pi, (40, 2)):
        copies = [q + 2.0 * math.pi * np.array(k) for k in product(range(-4, 5), repeat=2)]
        kept = [
            each
            for each in copies
            if (ends[:, 0] <= each).all()
            and (each <= ends[:, 1]).all()
            and math.radians(low) <= each.sum() <= math.radians(high)
        ]
        assert are_inside(chain, q) == bool(kept)
        if kept:
            nearest = min(kept, key=lambda each: float(each @ each))
            np.testing.assert_allclose(turned_rows(chain, q), nearest, rtol=0, atol=1e-9)


@pytest.mark.parametrize(("name", "rows"), [("sum_alone", ROWS), ("sum_and_own", OWN)])
def test_printed_rows_are_those_of_the_solver(name: str, rows: tuple[str, ...]) -> None:
    compiled = made_up(name, rows, f"task: [x, y]\nlimits: {sum_limit()}\n")
    ik_all = solving(compiled, "Python")
    of = story_of(compiled.robot)
    assert of.example is not None
    found, status = ik_all(of.example.T)
    np.testing.assert_allclose(of.example.rows, found, rtol=0, atol=1e-9)
    assert of.example.inside.tolist() == (np.asarray(status) != OUT_OF_LIMITS).tolist()


def test_limits_of_sums_are_stated() -> None:
    told = "Sums of joint values have limits: $q_2 + q_3$ from $-70^\\circ$ to $205^\\circ$."
    assert told in document("fanuc_lrmate200id_j23")
    slides = "d: q, alpha: pi/2", "d: q, alpha: -pi/2"
    limit = "[{of: q1 - 0.5*q2, from: 0.1, to: 0.7}]"
    text = made_of(*slides, task="[y, z]", limits=limit)
    assert "Sums of joint values have limits: $q_1 - 0.5 q_2$ from $0.1$ to $0.7$ m." in text
    assert "one with a joint, or a sum of joint values, beyond its limits" in text


def test_french_of_limits_of_sums() -> None:
    slides = "d: q, limits: [0, 1]", "theta: q, a: 0.3", "theta: q, a: 0.2", "theta: q, alpha: pi/2"
    robots = (
        table(*ROWS, task="[x, y]", limits=sum_limit()),
        table(*OWN, task="[x, y]", limits=sum_limit()),
        table(*slides, task="[x, y, z, yaw]", limits="[{of: q2 - q3, from: 1 deg, to: 2}]"),
    )
    for robot in robots:
        language = French()
        for block in document_blocks(story_of(robot)):
            plain(language.block(block))
        assert language.untranslated == []


@pytest.mark.parametrize("name", COMMITTED)
def test_values_beyond_half_a_turn_are_explained(name: str) -> None:
    """Angles come in (-180, 180]: where a table has others the text says how they became so."""
    text = document(name)
    example = text.partition("## An example\n")[2].partition("\n## ")[0]
    table_of = "\n".join(re.findall(r"^\| \d.*", example, re.MULTILINE))
    angles = [float(each) for each in re.findall(r"\$(-?[\d.]+)\^\\circ", table_of)]
    if any(not -180.0 <= each <= 180.0 for each in angles):
        assert "\nWhole turns move angles inside" in text or "differ by whole turns" in text


def test_the_formula_for_whole_turns() -> None:
    """Where limits are from 0 to 350 degrees, and where none but half a turn is."""
    first = "theta: q, a: 0.3, limits: [{} deg, {} deg]"
    told = r"a value $q < q_{\min}$ becomes $q + 2 \pi \lceil (q_{\min} - q) / (2 \pi) \rceil$"
    for low, high, reaches in (
        (0, 350, True),
        (-190, 45, True),
        (200, 500, True),
        (-180, 170, True),
        (-170, 180, False),
        (-266, 266, False),
        (-180, 180, False),
    ):
        text = made_of(first.format(low, high), "theta: q, a: 0.25", task="[x, y]")
        assert (told in text) == reaches
        assert ("here those of $q_1$. With" in text) == reaches
