"""Solutions that are joined without a singular place between: by a formula and a way of our own."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from dhgen.derivation.cuspidal import joined_rows
from dhgen.kinematics.build import build_chain
from dhgen.robot.load import load_text
from tests.derivation.stories import story

A1, D2, A2, A3 = 1.0, 1.0, 2.0, 1.5  # of cuspidal_3r
NODES = 360


def sign(second: Any, third: Any) -> Any:
    """Of det J = a3 (a2 + a3 c3) (a1 s3 + c2 (a2 s3 - d2 c3)); a2 > a3, so of the last factor."""
    return np.sign(A1 * np.sin(third) + np.cos(second) * (A2 * np.sin(third) - D2 * np.cos(third)))


def are_joined(one: tuple[int, int], other: tuple[int, int]) -> bool:
    """Whether a way of steps of one degree leads from one to the other, the sign kept."""
    angles = np.radians(np.arange(NODES) * 360.0 / NODES)
    same = sign(angles[:, None], angles[None]) == sign(angles[one[0]], angles[one[1]])
    reached = np.zeros((NODES, NODES), bool)
    reached[one] = True
    for _ in range(2 * NODES):
        near = reached.copy()
        for shift in ((0, 1), (0, -1), (1, 0), (-1, 0)):
            near |= np.roll(reached, shift, (0, 1))
        if (near & same == reached).all():
            break
        reached = near & same
    return bool(reached[other])


def test_two_solutions_of_the_cuspidal_arm_are_joined() -> None:
    of = story("cuspidal_3r")
    assert of.example is not None
    rows = of.example.rows
    assert np.isfinite(rows).all()
    pair = joined_rows(of.algebra.chain, rows)
    nodes = [tuple(np.round(np.degrees(row[1:])).astype(int) % NODES) for row in rows]
    joined = [(i, j) for i in range(4) for j in range(i) if are_joined(nodes[i], nodes[j])]
    assert pair is not None
    assert pair[::-1] in joined


@pytest.mark.parametrize(
    ("limits", "more"),
    [(", limits: [-3, 3]", ""), ("", "limits:\n  - {of: q2 + q3, from: -1, to: 1}\n")],
)
def test_nothing_is_said_where_limits_may_be_between(limits: str, more: str) -> None:
    of = story("cuspidal_3r")
    assert of.example is not None
    links = (f"d: 0, a: {A1}, alpha: -pi/2", f"d: {D2}, a: {A2}, alpha: pi/2", f"d: 0, a: {A3}")
    joints = "".join(f"  - {{theta: q, {cells}{limits}}}\n" for cells in links)
    plain, limited = (
        build_chain(load_text(f"name: arm\nsource: a test\ntask: position\njoints:\n{text}", "arm"))
        for text in (joints.replace(limits, "") if limits else joints, joints + more)
    )
    assert joined_rows(plain, of.example.rows) is not None
    assert joined_rows(limited, of.example.rows) is None


HEAD = "name: arm\nsource: a test\njoints:\n"
ELBOW = "  - {theta: q, d: 0.4, alpha: -pi/2}\n  - {theta: q, a: 0.4}\n  - {theta: q, a: 0.3}\n"


def test_where_a_sign_tells_them_apart_they_are_not() -> None:
    """An elbow: det J = -a2 a3 s3 (a2 c2 + a3 c23) has another sign in up and in down."""
    chain = build_chain(load_text(f"{HEAD}{ELBOW}task: position\n", "arm"))
    rows = np.array([[0.3, -0.5, 1.1], [0.3, 0.2, -1.1]])
    assert joined_rows(chain, rows) is None
