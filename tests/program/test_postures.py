"""Rows look like their names: the arm is drawn from its Jacobian, and what is seen is compared."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from tests.derivation.stories import document
from tests.generated.asking import labels
from tests.generated.solvers import library, robot

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.kinematics.numeric import NumericArm

POSES = 40
CLEAR = 1e-3  # of the arm's size: nearer to the border of two postures nothing is seen
FEWEST = 100  # rows in which something has to be seen

# Six axes, the last three of which meet; axes 2 and 3 are parallel and level.
FACING = [
    *("abb_irb120", "abb_irb1600", "abb_irb4600", "abb_irb6640", "comau_ns16", "denso_vs060"),
    *("fanuc_lrmate200id", "fanuc_m710ic50", "kawasaki_rs007n", "kuka_kr210", "kuka_kr6_r900"),
    *("staubli_rx90", "yaskawa_gp7"),
]
SIDED = ["puma", "puma560", "staubli_tx2_90", "staubli_tx40", "doosan_m1013"]
THREE_PARALLEL = ["ur5", "ur5e", "ur10e", "ur20", "techman_tm5_900"]
LEVEL_LINKS = ["scara", "scara_rrp", "adept_cobra600", "epson_t3", "planar_rr", "scara_wrist"]


@dataclass(frozen=True, slots=True)
class Drawn:
    """Solutions of one row name: directions (N, n, 3) of axes, and points nearest to the tool."""

    name: str
    tool: FloatArray
    directions: FloatArray
    points: FloatArray

    def meeting(self, one: int, two: int) -> FloatArray:
        """Where two axes are nearest to each other, on both: the middle."""
        u, v = self.directions[:, one - 1], self.directions[:, two - 1]
        a, b = self.points[:, one - 1], self.points[:, two - 1]
        middles = []
        for ui, vi, ai, bi in zip(u, v, a, b, strict=True):
            (s, t), *_ = np.linalg.lstsq(np.stack([ui, -vi], axis=1), bi - ai, rcond=None)
            middles.append(((ai + s * ui) + (bi + t * vi)) / 2.0)
        return np.array(middles)


def drawn(name: str) -> list[Drawn]:
    """All rows of random poses, as the written C has them."""
    arm = model(name)
    turning = np.array(arm.chain.turning)
    source = np.random.default_rng(2)
    q = source.uniform(-1.0, 1.0, (POSES, arm.chain.dof)) * np.where(turning, np.pi, arm.chain.size)
    rows, _ = library(name).batch(np.ascontiguousarray(arm.pose(q)))
    return [
        at(name, rows[:, row][~np.isnan(rows[:, row, 0])], label)
        for row, label in enumerate(labels(name))
    ]


@cache
def model(name: str) -> NumericArm:
    """The arm in numbers."""
    return numeric_arm(build_chain(robot(name)))


def at(name: str, q: FloatArray, label: str = "") -> Drawn:
    """The arm at joint values (N, n)."""
    T, J = model(name).moved(q)
    velocities, directions = (np.swapaxes(part, 1, 2) for part in (J[:, :3], J[:, 3:]))
    tool = T[:, :3, 3]
    # v = u x (tool - point), and tool - point is across u where the point is nearest
    points = tool[:, None] + np.cross(directions, velocities)
    return Drawn(label, tool, directions, points)


def test_points_are_on_the_axes() -> None:
    """What is drawn is right: axes 4, 5 and 6 of a spherical wrist meet where axes 4 and 5 do."""
    for each in drawn("puma560"):
        centre = each.meeting(4, 5)
        off = np.cross(centre - each.points[:, 5], each.directions[:, 5])
        assert np.abs(off).max() < 1e-9


def above(each: Drawn, end: FloatArray) -> FloatArray:
    """By how much the elbow is above the line from the shoulder to the end, in the arm's plane."""
    u = each.directions[:, 1]
    level = np.cross([0.0, 0.0, 1.0], u)
    elbow, end = (point - each.points[:, 1] for point in (each.points[:, 2], end))
    x, z = (elbow * level).sum(axis=1), elbow[:, 2]
    across, up = (end * level).sum(axis=1), end[:, 2]
    # the line at the elbow's x has the height x up / across
    return np.asarray(z - x * up / across)


def plane_of(each: Drawn, wrist: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Level, in the arm's plane: coordinates of the shoulder and the wrist; the wrist's beside it.

    Counted from axis 1 and, for the third, to the left of who looks to the wrist.
    """
    ahead = np.cross([0.0, 0.0, 1.0], each.directions[:, 1])
    first = each.meeting(1, 2)  # on both axes where they meet, else in the middle
    axis = first + 0.0
    axis[:, :2] = each.points[:, 0, :2]
    shoulder = ((each.points[:, 1] - axis) * ahead).sum(axis=1)
    to_wrist = wrist - axis
    reach = (to_wrist * ahead).sum(axis=1)
    beside = (to_wrist * each.directions[:, 1]).sum(axis=1)
    left = np.cross([0.0, 0.0, 1.0], ahead * np.sign(reach)[:, None])
    offset = beside[:, None] * each.directions[:, 1]
    return shoulder, reach, (offset * left).sum(axis=1)


@pytest.mark.parametrize("name", [*FACING, *SIDED, *THREE_PARALLEL])
def test_elbows_that_are_up_are_above(name: str) -> None:
    """Unless the arm reaches back: those that can are told so."""
    seen = told = 0
    for each in drawn(name):
        three = name in THREE_PARALLEL
        end = each.points[:, 3] if three else each.meeting(4, 5)
        wrist = each.meeting(5, 6) if three else end
        shoulder, reach, _ = plane_of(each, wrist)
        end_reach = plane_of(each, end)[1]
        height = above(each, end)
        ahead = np.where(np.abs(height) > CLEAR, (end_reach - shoulder) * reach, 0.0)
        clear, behind = ahead > CLEAR, ahead < -CLEAR
        words = each.name.split("-")
        assert ("up" in words) != ("down" in words)
        assert np.all((height[clear] > 0.0) == ("up" in words))
        assert np.all((height[behind] < 0.0) == ("up" in words))
        seen += int(np.count_nonzero(clear))
        told += int(np.count_nonzero(behind))
    assert seen > FEWEST
    assert "the end of the forearm, unless " in document(name) or not told
    assert told or name not in THREE_PARALLEL


@pytest.mark.parametrize("name", ["rpr", "olson_pprrrr"])
def test_joints_that_carry_a_link_are_no_wrists(name: str) -> None:
    """The one is asked for positions alone; of the other axes 4 and 5 are parallel, and 6 meets 5.

    Its joint 4 moves axis 5, which a wrist's joint leaves where it is.
    """
    assert not any("flip" in word for label in labels(name) for word in label.split("-"))
    places = at(name, np.random.default_rng(4).uniform(-1.0, 1.0, (20, model(name).chain.dof)))
    if name == "olson_pprrrr":
        assert np.linalg.norm(places.points[:, 4] - places.points[:, 3], axis=1).min() > CLEAR


@pytest.mark.parametrize("name", FACING)
def test_arms_that_face_the_wrist_are_in_front(name: str) -> None:
    """They face where their shoulder is; those with none beside axis 1, where they are at zero."""
    zero = at(name, np.zeros((1, 6)))
    _, at_zero, _ = plane_of(zero, zero.meeting(4, 5))
    for each in drawn(name):
        shoulder, reach, _ = plane_of(each, each.meeting(4, 5))
        front = each.name.startswith("front-")
        assert front or each.name.startswith("back-")
        ahead = at_zero if np.abs(shoulder).max() < 1e-9 else shoulder
        assert np.all((ahead * reach > 0.0) == front)


@pytest.mark.parametrize("name", [*SIDED, *THREE_PARALLEL])
def test_left_arms_are_beside_axis_1_on_the_left(name: str) -> None:
    for each in drawn(name):
        wrist = each.meeting(5, 6) if name in THREE_PARALLEL else each.meeting(4, 5)
        _, _, left = plane_of(each, wrist)
        assert np.all((left > 0.0) == each.name.startswith("left-"))


@pytest.mark.parametrize("name", LEVEL_LINKS)
def test_level_elbows_are_left_or_right(name: str) -> None:
    for each in drawn(name):
        ends_at_tool = name in {"planar_rr", "scara_rrp"}  # no further axis turns
        end = each.tool if ends_at_tool else each.points[:, 3]
        line = (end - each.points[:, 0])[:, :2]
        elbow = (each.points[:, 1] - each.points[:, 0])[:, :2]
        side = line[:, 0] * elbow[:, 1] - line[:, 1] * elbow[:, 0]
        assert np.all((side > 0.0) == each.name.startswith("left"))


@pytest.mark.parametrize("name", ["wrist_zyz", "wrist_zxz", "wrist_cardan"])
def test_wrists_flip(name: str) -> None:
    assert labels(name) == ["noflip", "flip"]
