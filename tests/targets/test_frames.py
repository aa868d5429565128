"""The frames of links in both languages, against products of matrices written out here."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.arm import base_frame
from dhgen.oracle.forward import forward
from dhgen.robot.expression import evaluate
from dhgen.robot.robot import Convention, DhTable, JointKind, ReferenceAxes
from tests.targets.made import in_c, in_python, robot

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.arrays import FloatArray
    from dhgen.robot.expression import Expression

# Standard with a slide, with a joint that counts against its axis, modified; axes with and without
# slides and slanting directions.
TABLES = ("scara", "puma560", "general_5r1p_pair", "franka_panda")
AXES = ("puma", "wrist_cardan", "planar_pr", "xarm6")


def joint_values(name: str, count: int = 5) -> FloatArray:
    return np.random.default_rng(4).uniform(-1.5, 1.5, (count, len(robot(name).joints)))


def numbers(name: str, cells: Sequence[Expression]) -> list[float]:
    values = {each.name: each.value for each in robot(name).parameters}
    return [evaluate(cell, values) for cell in cells]


def about_z(angle: float, length: float) -> FloatArray:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, length], [0, 0, 0, 1.0]])


def about_x(angle: float, length: float) -> FloatArray:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[1.0, 0, 0, length], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]])


def links_of_table(name: str, q: FloatArray) -> list[FloatArray]:
    """Z A_1 ... A_i for every i."""
    table, T, found = robot(name).geometry, base_frame(robot(name)), []
    assert isinstance(table, DhTable)
    for row, value in zip(table.rows, row_values(table, q), strict=True):
        theta, d, a, alpha = numbers(name, (row.theta, row.d, row.a, row.alpha))
        turns = row.kind is JointKind.REVOLUTE
        along_z = about_z(theta + value * turns, d + value * (not turns))
        modified = table.convention is Convention.MODIFIED
        T = T @ (about_x(alpha, a) @ along_z if modified else along_z @ about_x(alpha, a))
        found.append(T)
    return found


def row_values(table: DhTable, q: FloatArray) -> FloatArray:
    return q * [row.sign for row in table.rows]


def in_both(name: str, q: FloatArray) -> list[FloatArray]:
    """The frames of Python and of C."""
    frames, values = np.empty((len(q) + 2, 4, 4)), np.ascontiguousarray(q)
    pointers = (each.ctypes.data_as(ctypes.c_void_p) for each in (values, frames))
    in_c(name).library[f"{name}_frames"](*pointers)
    return [in_python(name).frames(q), frames]


@pytest.mark.parametrize("name", TABLES + AXES)
def test_frames_lead_from_base_to_tool(name: str) -> None:
    for q in joint_values(name):
        for frames in in_both(name, q):
            assert frames.shape == (len(q) + 2, 4, 4)
            np.testing.assert_allclose(frames[0], base_frame(robot(name)), rtol=0.0, atol=1e-15)
            reached = forward(robot(name), q)
            np.testing.assert_allclose(frames[-1], reached, rtol=1e-14, atol=1e-13)


@pytest.mark.parametrize("name", TABLES)
def test_links_have_the_frames_of_the_table(name: str) -> None:
    for q in joint_values(name):
        for frames in in_both(name, q):
            links = links_of_table(name, q)
            np.testing.assert_allclose(frames[1:-1], links, rtol=1e-14, atol=1e-13)


@pytest.mark.parametrize("name", AXES)
def test_links_of_axes_are_carried_along(name: str) -> None:
    """At q = 0 they are parallel to the base at their points; no turn moves those of its axis."""
    axes = robot(name).geometry
    assert isinstance(axes, ReferenceAxes)
    points = [numbers(name, axis.point) for axis in axes.axes]
    q, count = joint_values(name, 1)[0], len(axes.axes)
    for frames in in_both(name, np.zeros(count)):
        at_rest = np.linalg.inv(frames[0]) @ frames[1:-1]
        np.testing.assert_allclose(at_rest[:, :3, 3], points, rtol=0.0, atol=1e-15)
        np.testing.assert_allclose(at_rest[:, :3, :3] - np.eye(3), 0.0, atol=1e-15)
    for joint in range(count):
        if axes.axes[joint].kind is JointKind.REVOLUTE:
            still = in_both(name, np.where(np.arange(count) < joint, q, 0.0))
            turned = in_both(name, np.where(np.arange(count) <= joint, q, 0.0))
            for before, after in zip(still, turned, strict=True):
                moved = after[joint + 1, :3, 3] - before[joint + 1, :3, 3]
                np.testing.assert_allclose(moved, 0.0, atol=1e-13)


def test_stacks_give_stacks() -> None:
    q = joint_values("puma560", 6)
    frames = in_python("puma560").frames
    assert frames(q.reshape(2, 3, 6)).shape == (2, 3, 8, 4, 4)
    np.testing.assert_array_equal(frames(q)[4], frames(q[4]))
    assert frames(np.empty((0, 6))).shape == (0, 8, 4, 4)


@pytest.mark.parametrize("wrong", [[0.0] * 5, 1.0, [[0.0] * 7], "abc"])
def test_other_numbers_of_values_are_refused(wrong: object) -> None:
    with pytest.raises(ValueError, match="q must hold"):
        in_python("puma560").frames(wrong)
