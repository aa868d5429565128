"""What is drawn as reached is reached, and nothing else is."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.derivation.figures.outline import NEAR, outlines
from dhgen.derivation.figures.raster import reached
from dhgen.derivation.figures.reach import Section, find_reach
from dhgen.derivation.figures.workspace import tick_step
from dhgen.kinematics.numeric import numeric_arm
from dhgen.oracle.forward import forward
from dhgen.program.interpret import interpret
from tests.derivation.stories import story
from tests.structures import first_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.derivation.figures.raster import Raster
    from dhgen.derivation.figures.reach import Reach
    from dhgen.derivation.story import Story

DRAWN = [
    "cuspidal_3r", "franka_panda", "kuka_iiwa14", "kuka_kr40pa_drives", "kuka_kr6_r900",
    "planar_rr", "planar_rrr", "puma560", "scara", "scara_prrr", "stanford", "ur5", "welding_5r",
    "xarm6",
]  # fmt: skip


def drawn(name: str) -> tuple[Story, Reach, Raster]:
    of = story(name)
    reach = find_reach(of)
    assert reach is not None
    return of, reach, reached(reach)


def inside(of: Story, count: int) -> FloatArray:
    """Joint values within the limits, (count, n)."""
    chain = of.algebra.chain
    ends = [joint.limits or (-math.pi, math.pi) for joint in chain.joints]
    low, high = np.array(ends).T
    return np.random.default_rng(5).uniform(low, high, (count, chain.dof))


@pytest.mark.parametrize("name", first_of(DRAWN, count=4))
def test_no_joint_values_lead_out_of_what_is_drawn(name: str) -> None:
    of, reach, raster = drawn(name)
    assert raster.holds(reach.coordinates(inside(of, 20_000)), within=1).all()


@pytest.mark.parametrize(
    ("name", "where"),
    [
        ("cuspidal_3r", "the tool"),
        ("kuka_kr6_r900", "the wrist centre"),
        ("planar_rr", "the tool"),
        ("puma560", "the tool"),
        ("stanford", "the tool"),
    ],
)
def test_nothing_is_reached_beside_what_is_drawn(name: str, where: str) -> None:
    """Two to four cells off its border the solver has no row within the limits."""
    of, reach, raster = drawn(name)
    assert reach.name == where
    q = inside(of, 400)
    targets = beside(raster)
    picked = np.random.default_rng(7).integers(0, len(targets), len(q))
    T = forward(of.robot, q)
    T[:, :3, 3] += moved_to(reach, q, targets[picked])
    found = interpret(of.program, T, np.zeros_like(q))
    assert not (found.solved & within_limits(of, found.q)).any()


def beside(raster: Raster) -> FloatArray:
    """The middles of cells that are near to what is reached, but not next to it, (N, 2)."""
    rows, columns = np.indices([side + 6 for side in raster.held.shape]) - 3
    points = raster.origin + raster.cell * np.stack([columns, rows], axis=-1).reshape(-1, 2)
    near = raster.holds(points, within=4) & ~raster.holds(points, within=2)
    assert near.sum() > 300
    return points[near & (points[:, 0] > 0.0)]


def moved_to(reach: Reach, q: FloatArray, targets: FloatArray) -> FloatArray:
    """By how much the tool has to be moved for the point to be there, (N, 3)."""
    at = reach.points(q)
    shift = np.zeros_like(at)
    if reach.section is Section.ABOVE:
        shift[:, :2] = targets - at[:, :2]
        return shift
    across = np.hypot(at[:, 0], at[:, 1])
    shift[:, :2] = at[:, :2] * ((targets[:, 0] - across) / across)[:, None]
    shift[:, 2] = targets[:, 1] - at[:, 2]
    return shift


def within_limits(of: Story, q: FloatArray) -> NDArray[np.bool_]:
    kept = np.ones(q.shape[:-1], bool)
    for place, joint in enumerate(of.algebra.chain.joints):
        if joint.limits is not None:
            low, high = joint.limits
            turn = 2.0 * math.pi if of.algebra.chain.turning[place] else 0.0
            values = [q[..., place] + k * turn for k in (-1, 0, 1)]
            kept &= np.any([(low <= value) & (value <= high) for value in values], axis=0)
    return kept


def test_a_stretched_arm_reaches_the_ring_between_its_links() -> None:
    _, _, raster = drawn("planar_rr")
    angle = np.linspace(0.0, 2.0 * math.pi, 100)
    around = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    slack = 2.5 * raster.cell
    for radius, held in ((0.7 - slack, True), (0.7 + slack, False), (0.1 + slack, True)):
        assert (raster.holds(radius * around, within=0) == held).all()
    assert not raster.holds((0.1 - slack) * around, within=0).any()
    assert not raster.holds(np.zeros((1, 2)), within=0).any()


def test_the_border_of_the_ring_is_two_circles() -> None:
    _, _, raster = drawn("planar_rr")
    lines = [raster.origin + raster.cell * line for line in outlines(raster.held)]
    inner, outer = sorted(lines, key=lambda line: float(np.hypot(*line.T).max()))
    np.testing.assert_allclose(np.hypot(*inner.T), 0.1, atol=1.5 * raster.cell)
    np.testing.assert_allclose(np.hypot(*outer.T), 0.7, atol=1.5 * raster.cell)
    assert len(outer) < 150


def test_borders_turn_at_corners_that_touch() -> None:
    held = np.zeros((44, 44), bool)
    held[2:22, 2:22] = held[22:42, 22:42] = True
    areas = []
    for line in outlines(held):
        x, y = line.T
        areas.append(0.5 * float(x @ np.roll(y, -1) - y @ np.roll(x, -1)))
    assert len(areas) == 2, "what only corners join is apart"
    assert areas == pytest.approx([400.0, 400.0], abs=80 * NEAR / 2)


@pytest.mark.parametrize(
    "name", ["cartesian", "fanuc_lrmate200id_j23", "general_6r", "planar_rrrr", "wrist_zyz"]
)
def test_no_plane_is_drawn_that_shows_nothing(name: str) -> None:
    assert find_reach(story(name)) is None


def test_the_point_is_one_that_three_joints_move() -> None:
    reach = find_reach(story("ur5"))
    assert reach is not None
    assert (reach.name, reach.movers) == ("the point where axes 5 and 6 meet", (2, 3, 4))
    q = inside(story("ur5"), 3)
    z, at = numeric_arm(story("ur5").algebra.chain).axes(q)
    for joint in (5, 6):
        off = np.cross(reach.points(q) - at[:, joint - 1], z[:, joint - 1])
        np.testing.assert_allclose(off, 0.0, atol=1e-12)


@pytest.mark.parametrize(("length", "step"), [(1.4, 0.5), (0.62, 0.2), (5.0, 1.0), (900.0, 200.0)])
def test_numbers_on_axes_are_round(length: float, step: float) -> None:
    assert tick_step(length) == pytest.approx(step)
