"""What is written for a URDF is its arm, and a table that a person would have written."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import numpy as np
import pytest

import dhgen.descriptions
from dhgen.derivation import derivation_terminal
from dhgen.descriptions.convert import Import, convert
from dhgen.descriptions.urdf import read_urdf
from dhgen.descriptions.wishes import Wishes
from dhgen.oracle.forward import jacobian
from dhgen.robot.expression import evaluate
from dhgen.robot.load import load
from dhgen.robot.robot import Convention, DhTable, ReferenceAxes, Robot
from dhgen.robot_files import RobotFile
from tests.compiling import worked_out_once
from tests.descriptions.described import urdf_of
from tests.descriptions.reference import ARMS, FILES, worst_difference
from tests.structures import BREADTH, first_of

ROOT = Path(__file__).parents[2]
TABLES = sorted(
    path.stem
    for path in (ROOT / "robots").glob("*.yaml")
    if "\njoints:" in path.read_text(encoding="utf-8")
)
ROUNDING = 1e-12  # arm sizes
# Lengths of the data sheets, and how many angles beside q a table of such an arm needs.
DATA_SHEETS = {
    "gantry": ("PPPRRR", 4, 0),
    "iiwa14": ("RRRRRRR", 4, 0),
    "irb140": ("RRRRRR", 5, 1),
    "kr16": ("RRRRRR", 6, 1),
    "panda": ("RRRRRRR", 6, 0),  # both links at the elbow are 0.0825: one name
    "scara": ("RRPR", 3, 0),
    "ur5": ("RRRRRR", 6, 0),
}


def imported(text: str, **wishes: object) -> Import:
    return convert(read_urdf(text.encode(), "arm.urdf"), Wishes(**wishes))  # type: ignore[arg-type]


def of_file(name: str, **wishes: object) -> Import:
    return imported((FILES / f"{name}.urdf").read_text(encoding="utf-8"), **wishes)


def table_of(result: Import) -> DhTable:
    assert isinstance(result.robot.geometry, DhTable)
    return result.robot.geometry


@pytest.mark.parametrize("name", ARMS)
def test_the_robot_file_is_the_urdf_s_arm(name: str) -> None:
    text = (FILES / f"{name}.urdf").read_text(encoding="utf-8")
    result = imported(text)
    near = 1e-9 if "1.570796327" in text else ROUNDING * result.difference.size
    moved, turned = worst_difference(text, result)
    assert moved < near
    assert turned < max(near, ROUNDING)
    assert moved < 2 * result.difference.moved + ROUNDING  # what is told is measured


@pytest.mark.parametrize("name", ARMS)
def test_axes_where_they_are_asked_for(name: str) -> None:
    text = (FILES / f"{name}.urdf").read_text(encoding="utf-8")
    result = imported(text, as_axes=True)
    assert isinstance(result.robot.geometry, ReferenceAxes)
    assert max(worst_difference(text, result)) < 1e-9


@pytest.mark.parametrize("name", DATA_SHEETS)
def test_a_table_has_the_lengths_of_the_data_sheet(name: str) -> None:
    joints, lengths, offsets = DATA_SHEETS[name]
    result = of_file(name)
    kinds = "".join(row.kind.value[0].upper() for row in table_of(result).rows)
    assert kinds == joints
    assert len(result.robot.parameters) == lengths
    told = re.findall(r"theta: -?q( [-+] [^,]+)?", result.text)
    assert sum(map(bool, told)) == offsets
    assert "tool:" not in result.text  # all of the tool is in the last row
    assert ("base:" in result.text) == (name == "gantry")  # whose first slide is level
    assert table_of(result).convention is Convention.STANDARD


@pytest.mark.parametrize("name", first_of(TABLES, count=30))
def test_a_table_described_and_imported_has_no_more_letters(name: str) -> None:
    """The frames of a description may be anywhere along the axes; here they are the table's."""
    robot = load(ROOT / "robots" / f"{name}.yaml")
    result = imported(urdf_of(robot))
    assert result.robot.name == robot.name
    if not name.endswith("_calibrated"):  # which have lengths of less than a micrometre
        assert result.difference.relative < ROUNDING
    assert _letters(result.robot) <= _letters(robot)


def _letters(robot: Robot) -> int:
    """How many lengths of a table, of its base and of its tool are not zero."""
    values = {parameter.name: parameter.value for parameter in robot.parameters}
    assert isinstance(robot.geometry, DhTable)
    rows = [cell for row in robot.geometry.rows for cell in (row.d, row.a)]
    cells = (*rows, *robot.base.xyz, *robot.tool.xyz)
    return sum(abs(evaluate(cell, values)) > 1e-9 for cell in cells)


@pytest.mark.parametrize("name", ["abb_irb120", "franka_panda", "fanuc_crx10ia", "ur5e"])
def test_where_frames_are_along_their_axes_does_not_matter(name: str) -> None:
    robot = load(ROOT / "robots" / f"{name}.yaml")
    plain = urdf_of(robot)
    rng = np.random.default_rng(5)
    moved = plain
    for number in range(1, len(robot.joints) + 1):
        angle, height = rng.uniform(-3, 3), rng.uniform(-0.5, 0.5)
        moved = _shifted(moved, number, angle, height)
    assert moved != plain
    assert imported(moved, base="base").text == imported(plain).text


def _shifted(text: str, number: int, angle: float, height: float) -> str:
    """The same arm with another frame on an axis: two fixed joints around the joint."""
    there = f'<origin xyz="0 0 {height!r}" rpy="0 0 {angle!r}"/>'
    back = f'<origin rpy="0 0 {-angle!r}"/>'
    down = f'<origin xyz="0 0 {-height!r}"/>'
    (line,) = re.findall(f'.*<joint name="joint{number}".*', text)
    (origin,) = re.findall("<origin[^>]*>", line)
    (parent,) = re.findall('<parent link="([^"]*)"/>', line)
    moved = line.replace(origin, there)
    moved = moved.replace(f'parent link="{parent}"', f'parent link="near{number}"')
    moved = moved.replace(f'child link="link{number}"', f'child link="at{number}"')
    lines = [
        *(f'<link name="{name}{number}"/>' for name in ("near", "at", "off")),
        _fixed(f"to{number}", parent, f"near{number}", origin),
        moved,
        _fixed(f"back{number}", f"at{number}", f"off{number}", back),
        _fixed(f"down{number}", f"off{number}", f"link{number}", down),
    ]
    return text.replace(line, "\n".join(lines))


def _fixed(name: str, parent: str, child: str, origin: str) -> str:
    links = f'<parent link="{parent}"/><child link="{child}"/>'
    return f'<joint name="{name}" type="fixed">{links}{origin}</joint>'


def derivation_of(path: Path) -> str:
    file = RobotFile.read(path)
    return derivation_terminal(worked_out_once(file)[0])


@pytest.mark.parametrize(
    ("name", "own"),
    [
        ("irb140", "abb_irb120"),
        pytest.param("ur5", "ur5", marks=BREADTH),
        pytest.param("panda", "franka_panda", marks=BREADTH),
    ],
)
def test_a_derivation_is_not_longer_than_from_a_data_sheet(name: str, own: str) -> None:
    ours = derivation_of(FILES / f"{name}.urdf")
    theirs = derivation_of(ROOT / "robots" / f"{own}.yaml")
    assert ours.count("Step ") <= theirs.count("Step ")
    assert len(ours.splitlines()) <= len(theirs.splitlines()) + 5  # signs of drives are told


def test_what_a_file_says_of_itself() -> None:
    result = of_file("ur5")
    assert result.text.startswith(
        "name: ur5\ntitle: ur5\nsource: URDF arm.urdf, poses of tool0 in base_link_inertia\n"
    )
    for joint in result.chain.actuated:
        assert f"name: {joint.name}}}\n" in result.text
    assert "limits: [-180 deg, 180 deg], name: elbow_joint}" in result.text


def test_a_name_that_a_robot_file_can_not_hold_is_a_comment() -> None:
    text = (FILES / "ur5.urdf").read_text(encoding="utf-8").replace("elbow_joint", "Ellbogen ä")
    result = imported(text)
    assert "}  # Ellbogen ä\n" in result.text
    assert "name: wrist_1_joint" not in result.text
    *_, note = result.notes
    start = "joints are called joint1 to joint6, and their names are comments: a robot file can't "
    assert note.startswith(f"{start}hold 'Ellbogen ä', it must be plain: letters from a to z")
    assert not any("comments" in each for each in of_file("ur5").notes)


def test_of_several_names_that_a_robot_file_can_not_hold_the_first_is_told() -> None:
    text = (FILES / "ur5.urdf").read_text(encoding="utf-8").replace("elbow_joint", "e" * 300)
    *_, note = imported(text.replace("wrist_1_joint", "größe")).notes
    assert "a robot file can't hold 'eeee" in note
    assert note.endswith("it has 300 characters; at most 64 are allowed; nor can it hold 1 more")
    assert len(note) < 300


def test_names_that_yaml_would_read_as_something_else_have_quotes() -> None:
    result = imported((FILES / "ur5.urdf").read_text(encoding="utf-8").replace("elbow_joint", "on"))
    assert "name: 'on'}" in result.text
    assert result.robot.joints[2].name == "on"


@pytest.mark.parametrize(
    ("given", "name"),
    [
        ("UR5 robot", "ur5_robot"),
        ("2dof", "robot_2dof"),
        ("math", "robot_math"),
        ("class", "robot_class"),
        ("null", "robot_null"),
        ("true", "robot_true"),
        ("ÄÖ", "ao"),
        ("Müller Arm 7!", "muller_arm_7"),
        ("Mu\u0308ller", "muller"),  # the accent a character of its own
        ("Weiß", "weiss"),
        ("机器人", "robot"),
        ("", "robot"),
        ("a__b", "a_b"),
        ("x" * 99, "x" * 48),
        ("#: [{", "robot"),
    ],
)
def test_any_name_of_a_robot_becomes_one(given: str, name: str) -> None:
    text = (FILES / "scara.urdf").read_text(encoding="utf-8")
    result = imported(text.replace('name="epson_t3"', f'name="{given}"'))
    assert result.robot.name == name
    assert result.robot.title == (given[:80] or "robot")


def test_names_of_joints_can_t_leave_their_comment() -> None:
    text = (FILES / "scara.urdf").read_text(encoding="utf-8")
    result = imported(text.replace('name="j1"', 'name="j&#10;free: [1]"'))
    assert result.robot.free == ()
    assert "# j?free: [1]\n" in result.text


def test_seven_joints_get_one_that_is_given() -> None:
    assert of_file("panda").robot.free == (7,)
    assert of_file("iiwa14").robot.free == (3,)
    assert of_file("ur5").robot.free == ()


# Joints from the base: their axes, and where each is from the one before.
SLIDES = (("prismatic", "1 0 0", "0 0 0"), ("prismatic", "0 1 0", "0 0 0"))
LIFT = ("prismatic", "0 0 1", "0 0 0")
TURNS = (
    *(("revolute", "0 0 1", "0 0 0.2"), ("revolute", "0 1 0", "0.05 0 0.1")),
    *(("revolute", "0 1 0", "0 0 0.4"), ("revolute", "0 1 0", "0.05 0 0.3")),
    *(("revolute", "0 0 1", "0 0.1 0.1"), ("revolute", "0 1 0", "0.05 0 0.1")),
)


@pytest.mark.parametrize(
    ("joints", "free"),
    [
        # a gantry: its slides and the arm's last joints would be left
        ((*SLIDES, LIFT, *TURNS), (1, 2, 3)),
        # a base that drives in a plane, and an arm of five joints
        ((*SLIDES, *TURNS[:5]), (1,)),
        # of four parallel axes three are enough
        ((TURNS[0], *[TURNS[2]] * 4, ("revolute", "1 0 0", "0 0 0.1"), TURNS[0]), (2,)),
        # a table that turns about the first axis of what is on it
        ((("revolute", "1 0 0", "0 0 0"), TURNS[0], *TURNS), (1, 2)),
    ],
)
def test_six_joints_are_left_that_move_in_six_ways(
    joints: tuple[tuple[str, str, str], ...], free: tuple[int, ...]
) -> None:
    lines = ['<robot name="arm"><link name="l0"/>']
    for number, (kind, axis, xyz) in enumerate(joints, 1):
        lines.append(
            f'<link name="l{number}"/><joint name="j{number}" type="{kind}">'
            f'<parent link="l{number - 1}"/><child link="l{number}"/>'
            f'<origin xyz="{xyz}"/><axis xyz="{axis}"/><limit lower="-2" upper="2"/></joint>'
        )
    robot = imported("\n".join([*lines, "</robot>"])).robot
    assert robot.free == free
    q = np.random.default_rng(3).uniform(-1.5, 1.5, len(joints))
    left = [number for number in range(len(joints)) if number + 1 not in free]
    assert np.linalg.matrix_rank(jacobian(robot, q)[:, left], tol=1e-6) == 6


def test_what_reads_descriptions_knows_no_later_stage() -> None:
    folder = Path(dhgen.descriptions.__file__).parent
    allowed = ("dhgen.descriptions", "dhgen.robot.", "dhgen.errors", "dhgen.arrays")
    for path in folder.glob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("dhgen"):
                assert (node.module or "").startswith(allowed), path.name
    for path in (folder.parent / "robot").glob("*.py"):
        assert "dhgen.descriptions" not in path.read_text(encoding="utf-8"), path.name
