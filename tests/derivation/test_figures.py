"""Figures show the arm that an independent forward model has, in files that anything can read."""

from __future__ import annotations

import math
import re
from itertools import combinations
from typing import TYPE_CHECKING
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from dhgen.derivation import derivation_files, derivation_terminal
from dhgen.derivation.figures.arm import arm_figure
from dhgen.derivation.figures.position import drawn_position
from dhgen.derivation.figures.sheet import number, width_of
from dhgen.derivation.figures.skeleton import Skeletons
from dhgen.oracle.arm import base_frame
from dhgen.oracle.forward import forward
from dhgen.robot.expression import evaluate
from dhgen.robot.load import load_text
from dhgen.robot.robot import Convention, DhTable, JointKind
from tests.derivation.stories import EACH, GENERATED, WHOLE, story, story_of
from tests.serial import PARALLEL, SERIAL

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.arrays import FloatArray
    from dhgen.robot.robot import Robot

FIGURES = sorted((GENERATED / "figures").glob("*.svg"))
HANDOUT = (GENERATED.parent / "templates/derivation/handout.tex.jinja").read_text("utf-8")
SVG = "{http://www.w3.org/2000/svg}"
TABLES = ["general_6r", "kuka_kr6_r900", "scara", "spherical_wrist_general_arm", "stanford", "ur5"]
LINE = re.compile(r"M(\S+) (\S+)L(\S+) (\S+)")
WRONG = re.compile(r"nan|inf|e-\d|href|(?<![\d.])-0(?![\d.]*[1-9])")
LINK = re.compile(r"!\[[^\]]*\]\(([^)]*)\)")


def parsed(text: str) -> ET.Element:
    return ET.fromstring(text)  # noqa: S314 - our own


@pytest.mark.parametrize("name", [*EACH, *WHOLE, "puma", "general_4r2p", "dobot_magician"])
def test_the_tool_is_where_an_independent_model_has_it(name: str) -> None:
    of = story(name)
    q = np.random.default_rng(3).uniform(-1.5, 1.5, (5, of.dof))
    arms = Skeletons(of)
    for values, T in zip(q, forward(of.robot, q), strict=True):
        arm = arms.at(values)
        np.testing.assert_allclose(arm.tool, T, atol=1e-9)
        if arm.members:
            np.testing.assert_allclose(arm.members[-1].end, T[:3, 3], atol=1e-9)
            ends = [member.end for member in arm.members[:-1]]
            np.testing.assert_allclose(ends, [m.start for m in arm.members[1:]], atol=1e-12)


@pytest.mark.parametrize("name", TABLES)
def test_lines_are_the_lengths_of_the_table_in_parallel_projection(name: str) -> None:
    """Some direction of sight and one scale take the table's d and a to what the file draws."""
    of = story(name)
    space = table_points(of.robot, drawn_position(of, Skeletons(of)))
    text = (GENERATED / "figures" / f"{name}_arm.svg").read_text("utf-8")
    drawn = drawn_points(text, len(space))
    known = np.column_stack([space, np.ones(len(space))])
    found, *_ = np.linalg.lstsq(known, drawn, rcond=None)
    assert np.abs(known @ found - drawn).max() < 0.2
    if np.linalg.matrix_rank(known, 1e-6) == 4:
        across, down = found[:3].T
        assert np.linalg.norm(across) == pytest.approx(np.linalg.norm(down), rel=0.02)
        assert across @ down == pytest.approx(0.0, abs=0.02 * (across @ across))


def table_points(robot: Robot, q: FloatArray) -> FloatArray:
    """Where the lengths of a table of either convention begin and end, (k, 3)."""
    table = robot.geometry
    assert isinstance(table, DhTable)
    values = {parameter.name: parameter.value for parameter in robot.parameters}
    T = base_frame(robot)
    points = [np.zeros(3)] if np.any(T[:3, 3]) else []
    points.append(T[:3, 3])
    for row, value in zip(table.rows, q, strict=True):
        theta, d, a, alpha = (evaluate(e, values) for e in (row.theta, row.d, row.a, row.alpha))
        if row.kind is JointKind.REVOLUTE:
            theta += row.sign * value
        else:
            d += row.sign * value
        along_z, along_x = (turn(2, theta), shift(2, d)), (shift(0, a), turn(0, alpha))
        standard = table.convention is Convention.STANDARD
        for step in (*along_z, *along_x) if standard else (*along_x, *along_z):
            T = T @ step
            points.append(T[:3, 3])
    points.append(forward(robot, q)[:3, 3])
    kept = [points[0]]
    for point in points[1:]:
        if np.linalg.norm(point - kept[-1]) > 1e-9:
            kept.append(point)
    return np.array(kept)


def turn(axis: int, angle: float) -> FloatArray:
    T = np.eye(4)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    T[i, i] = T[j, j] = math.cos(angle)
    T[j, i] = math.sin(angle)
    T[i, j] = -T[j, i]
    return T


def shift(axis: int, length: float) -> FloatArray:
    T = np.eye(4)
    T[axis, 3] = length
    return T


def drawn_points(text: str, count: int) -> FloatArray:
    """The ends of the arm's members in a file, (count, 2): lines that join up, drawn first."""
    lines = []
    for element in parsed(text).iter(f"{SVG}path"):
        if element.get("class") in {"link", "held"}:
            found = LINE.fullmatch(element.get("d", ""))
            assert found is not None
            lines.append([float(each) for each in found.groups()])
    ends = np.array(lines[: count - 1])
    assert len(ends) == count - 1
    assert (ends[:-1, 2:] == ends[1:, :2]).all()
    return np.vstack([ends[:1, :2], ends[:, 2:]])


@pytest.mark.parametrize("path", FIGURES, ids=lambda path: path.stem)
def test_every_figure_is_whole(path: Path) -> None:
    text = path.read_text("utf-8")
    root = parsed(text)
    assert root.tag == f"{SVG}svg"
    assert root.findtext(f"{SVG}title")
    assert root.findtext(f"{SVG}desc")
    assert len(text) < 12_000
    styles, drawn = text.split("</style>")
    assert not WRONG.search(drawn)
    for kind in {word for each in re.findall(r'class="([^"]+)"', drawn) for word in each.split()}:
        assert f".{kind}" in styles  # else a reader sees nothing of it
        assert f"as {kind}/.style" in HANDOUT
    left, top, width, height = map(float, root.get("viewBox", "").split())
    for element in root.iter():
        for x, y in re.findall(r"[ML](\S+?) ([-\d.]+)", element.get("d", "")):
            assert left <= float(x) <= left + width
            assert top <= float(y) <= top + height


def test_documents_link_every_figure_and_nothing_else() -> None:
    linked = {
        path.stem: LINK.findall(path.read_text("utf-8"))
        for path in GENERATED.glob("*.md")
        if path.with_suffix(".c").exists()
    }
    assert set(linked) == {*SERIAL, *PARALLEL, *(f"{name}_leg" for name in PARALLEL)}
    targets = [target for found in linked.values() for target in found]
    assert sorted(targets) == [f"figures/{path.name}" for path in FIGURES]
    first = {name: "platform" if name in PARALLEL else "arm" for name in linked}
    assert all(f"figures/{name}_{first[name]}.svg" in linked[name] for name in linked)
    assert sum(path.stat().st_size for path in FIGURES) < 3_000_000


@pytest.mark.parametrize("name", ["scara", "puma560", "general_6r"])
def test_figures_are_made_the_same_again(name: str) -> None:
    again = story_of(story(name).robot)
    files = derivation_files(again, f"robots/{name}.yaml")
    figures = {path: text for path, text in files.items() if path.endswith(".svg")}
    assert figures
    for path, text in figures.items():
        assert text == (GENERATED / path).read_text("utf-8")


@pytest.mark.parametrize("noise", [0.0, 3e-13, -3e-13])
def test_rounding_of_other_machines_changes_no_coordinate(noise: float) -> None:
    assert number(12.25 + noise) == number(12.25)
    assert number(-0.35 + noise) == number(-0.35)
    assert number(noise) == number(-0.04 + noise) == "0"
    assert number(7.0 + noise) == "7"


@pytest.mark.parametrize("name", ["planar_rr", "puma560", "scara", "stanford", "ur5", "xarm6"])
def test_letters_do_not_lie_on_each_other(name: str) -> None:
    letters = arm_figure(story(name)).sheet.letters
    assert len(letters) > story(name).dof
    for one, other in combinations(letters, 2):
        apart = one[2] <= other[0] or other[2] <= one[0] or one[3] <= other[1] or other[3] <= one[1]
        assert apart


def test_indices_are_set_below_and_take_less_room() -> None:
    assert width_of("x₁₂") == width_of("x_12") < width_of("x12")
    text = (GENERATED / "figures/scara_arm.svg").read_text("utf-8")
    assert '<tspan dy="4" font-size="10">1</tspan>' in text


TWO = """\
name: arm
title: "A <b>bold</b> & ]]> arm"
source: made up
convention: standard
joints:
  - {theta: q, d: 0, a: 1, alpha: 0}
  - {theta: q, d: 0, a: 1, alpha: 0}
task: [x, y]
"""


def test_what_users_wrote_breaks_no_file() -> None:
    of = story_of(load_text(TWO, "arm.yaml"))
    files = derivation_files(of, "a--b/arm & <x>.yaml")
    for path, text in files.items():
        if path.endswith(".svg"):
            title = parsed(text).findtext(f"{SVG}title")
            assert title is not None
            assert title.startswith("A <b>bold</b> & ]]> arm: ")


def test_the_terminal_has_no_figures() -> None:
    of = story("scara")
    assert "svg" not in derivation_terminal(of)
