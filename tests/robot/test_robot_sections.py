"""The sections around the joints: name, task, free joints, units, parameters."""

from __future__ import annotations

import re
from fractions import Fraction

import pytest

from dhgen.robot.expression import Number, to_text
from dhgen.robot.reader import read_document
from dhgen.robot.report import Report
from dhgen.robot.robot import Convention, DhTable
from dhgen.robot.schema import RobotFile
from dhgen.robot.shape import Shape
from dhgen.robot.source import SourceText
from dhgen.robot.task import Task, TaskKind
from tests.robot.robot_texts import (
    JOINTS,
    MINIMAL,
    axes,
    marked,
    mistake,
    mistakes,
    robot,
    row,
    table,
)

SLIDE = "type: prismatic, direction: [0, 0, 1]"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("name: r\n", "no joints: write them as 'joints' (a table) or as 'axes'"),
        (f"{MINIMAL}axes:\n  - {{{SLIDE}}}\n", "a robot has joints or axes, not both"),
        ("name: r\njoints: []\n", "a robot has 1 to 64 joints, not 0"),
        ("name: r\naxes: []\n", "a robot has 1 to 64 joints, not 0"),
        (table(*["theta: q"] * 65), "a robot has 1 to 64 joints, not 65"),
        (
            "name: r\njoints: 3\n",
            "expected a list of joints, e.g. [{theta: q, d: 0, a: 0.4, alpha: pi/2}], n",
        ),
        (
            "name: r\njoints:\n",
            "expected a list of joints, e.g. [{theta: q, d: 0, a: 0.4, alpha: pi/2}], not",
        ),
        (
            "name: r\njoints: [3]\n",
            "expected a joint, e.g. {theta: q, d: 0, a: 0.4, alpha: pi/2}, not '3'",
        ),
        (JOINTS, "the key 'name' is missing"),
        (f"{MINIMAL}home: {{}}\n", "'home' goes with 'axes'; with 'joints' use 'tool'"),
        (axes(SLIDE, convention="standard"), "'convention' goes with 'joints'"),
        (f"{MINIMAL}convention: Modified\n", "expected 'standard' or 'modified', not 'Modified'"),
        (f"{MINIMAL}jionts: []\n", "unknown key 'jionts'; did you mean 'joints'? valid: name, tit"),
        (
            f"{MINIMAL}joint_limits: []\n",
            "unknown key 'joint_limits'; limits stand in each joint: 'limits: [-1.5, 1.5]'",
        ),
        (
            "name: r\njoints:\n  - {theta: q, offset: 0.3}\n",
            "unknown key 'offset'; an offset stands beside the variable: 'theta: q + 0.3'",
        ),
        (
            f"{MINIMAL}task: poses\n",
            "expected one of pose, position, orientation, pointing, direction, or a list such",
        ),
        (f"{MINIMAL}task: [x, x]\n", "a list holds some of x, y, z, and yaw, or pitch,"),
        (f"{MINIMAL}task: [w]\n", "a list holds some of x, y, z, and yaw, or pitch,"),
        (f"{MINIMAL}task: [x, yaw, yaw]\n", "a list holds some of x, y, z, and yaw, or pitch,"),
        (f"{MINIMAL}task: [z, roll]\n", "a list holds some of x, y, z, and yaw, or pitch,"),
        (f"{MINIMAL}task: [pitch, yaw]\n", "a list holds some of x, y, z, and yaw, or pitch,"),
        (f"{MINIMAL}task: []\n", "a list holds some of x, y, z, and yaw, or pitch,"),
        (f"{MINIMAL}task: {{a: 1}}\n", "expected one of pose"),
        (f"{MINIMAL}free: [2]\n", "there is no joint 2: joints are numbered from 1 to 1"),
        (f"{MINIMAL}free: [0]\n", "there is no joint 0: joints are numbered from 1 to 1"),
        (f"{MINIMAL}free: [-1]\n", "there is no joint -1: joints are numbered from 1 to 1"),
        (f"{MINIMAL}free: [1, 1]\n", "list free joints in ascending order, each once"),
        (f"{MINIMAL}free: [a]\n", "expected the number of a joint, not 'a'"),
        (f"{MINIMAL}free: [1.5]\n", "expected the number of a joint, not '1.5'"),
        (f"{MINIMAL}free: [1.0]\n", "expected the number of a joint, not '1.0'"),
        (f"{MINIMAL}free: ['１']\n", "expected the number of a joint, not '１'"),
        (f"{MINIMAL}free: [~]\n", "expected the number of a joint, not nothing"),
        (f"{MINIMAL}free: 1\n", "expected a list of joints, or arm_angle, not '1'"),
        (f"{MINIMAL}free: {{}}\n", "expected a list of joints, or arm_angle, not keys with values"),
        (f"{MINIMAL}numerical: maybe\n", "expected true or false, not 'maybe'"),
        (f"{MINIMAL}float32: [1]\n", "expected true or false, not a list of 1"),
        (f"{MINIMAL}float32: 1\n", "expected true or false, not '1'"),
        (f"{MINIMAL}numerical: yes\n", "expected true or false, not 'yes'"),
        (f"{MINIMAL}free: [1]\n", "every joint is free: there is nothing to solve"),
        (f"{MINIMAL}tool: [0, 0, 0.1]\n", "expected keys with values, e.g. {xyz: [0, 0, 0.1]}, or"),
        (f"{MINIMAL}tool: {{rpy: 3}}\n", "expected a list [roll, pitch, yaw], not '3'"),
        (
            axes("type: revolute, direction: [0, 0, 1], point: 0"),
            "expected a list [x, y, z], not '0'",
        ),
        (f"{MINIMAL}units: {{length: parsec}}\n", "expected 'm', 'dm', 'cm', 'mm', 'um', 'in' or"),
        (
            f"{MINIMAL}units: {{agnle: deg}}\n",
            "unknown key 'agnle'; did you mean 'angle'? valid: l",
        ),
    ],
)
def test_refused_files(text: str, message: str) -> None:
    assert mistake(text).startswith(message)


MISTYPED = ("", "[]", "[~]", "[[1]]", "[1, 2]", "{}", "{a: {b: 1}}", "true", "3", "maybe")


@pytest.mark.parametrize("key", sorted(RobotFile.model_fields.keys() - {"joints"}))
def test_a_value_of_another_type_is_told_what_is_valid(key: str) -> None:
    told = (
        "expected .*, not |'.*': the robot can't|unknown key|the key .* missing|a robot has |a li"
    )
    for value in MISTYPED:
        text = JOINTS if key == "name" else MINIMAL
        report = Report(read_document(SourceText.of(f"{text}{key}: {value}\n", "r.yaml")))
        Shape(report)
        for diagnostic in report.errors:
            assert re.match(told, diagnostic.message)


def test_the_file_around_the_joints() -> None:
    text = table(*["theta: q"] * 3, convention="modified", free="[1, 3]", units="{length: mm}")
    loaded = robot(text)
    assert isinstance(loaded.geometry, DhTable)
    assert loaded.geometry.convention is Convention.MODIFIED
    assert (loaded.free, loaded.length_unit) == ((1, 3), "mm")
    assert robot(MINIMAL).geometry == DhTable(Convention.STANDARD, (row("theta: q"),))


def test_the_arm_angle_in_place_of_joints() -> None:
    text = table(*["theta: q"] * 7, free="arm_angle")
    assert (robot(text).arm_angle, robot(text).free) == (True, ())
    assert not robot(table("theta: q", "theta: q", free="[1]")).arm_angle
    assert mistake(f"{MINIMAL}free: elbow\n").endswith("arm_angle, not 'elbow'")
    told = "'arm_angle': it stands without a list: write free: arm_angle"
    assert mistake(f"{MINIMAL}free: [arm_angle]\n") == told


@pytest.mark.parametrize("kind", ["pose", "position", "orientation", "pointing", "direction"])
def test_tasks(kind: str) -> None:
    assert robot(f"{MINIMAL}task: {kind}\n").task == Task(TaskKind(kind))


def test_a_task_of_coordinates_is_in_their_order() -> None:
    assert robot(f"{MINIMAL}task: [z, x]\n").task == Task(TaskKind.LIST, ("x", "z"))
    tilted = Task(TaskKind.LIST, ("x", "z"), ("roll", "pitch"))
    assert robot(f"{MINIMAL}task: [pitch, z, roll, x]\n").task == tilted
    assert robot(f"{MINIMAL}task: [yaw]\n").task == Task(TaskKind.LIST, (), ("yaw",))
    assert robot(MINIMAL).task == Task(TaskKind.POSE)


def test_parameters_may_use_those_before_them() -> None:
    first, second = robot(f"{MINIMAL}parameters: {{l: 0.1, m: 2*l - 1}}\n").parameters
    assert (first.name, first.expression, first.value) == ("l", Number(Fraction(1, 10)), 0.1)
    assert (second.name, to_text(second.expression), second.value) == ("m", "2*l - 1", -0.8)


@pytest.mark.parametrize(
    ("parameters", "message"),
    [
        ("{l: m, m: 1}", "the parameter 'm' is defined further down: move it up"),
        (
            "{l: m, m: l}",
            "these parameters are defined by each other: l by m, m by l; give one of them a number",
        ),
        (
            "{k: 1, l: 2*m, m: k + n, n: -l}",
            "these parameters are defined by each other: l by m, m by n, n by l; give",
        ),
        ("{l: l + 1}", "the parameter 'l' is defined by itself"),
        ("{l: q}", "the variable q is only allowed in theta or d of a joint"),
        ("{q: 1}", "'q' can't be a parameter: it is reserved (q, pi, deg, sqrt, sin, cos"),
        ("{c1: 1}", "'c1' can't be a parameter: the derivation uses such names itself"),
        ("{l: }", "expected a number or an expression, not nothing"),
        ("{l: [1]}", "expected a number or an expression, not a list of 1"),
        ("[l]", "expected names with values, e.g. {a1: 0.4}, not a list of 1"),
        ("{l: 0,5, m: 0.5}", "write a decimal point: 0.5, not 0,5"),
        ("{l: 0,5 deg}", "write a decimal point: 0.5 deg, not 0,5 deg"),
        ("\n  l: 0,5", "',' (U+002C) is not allowed in a cell: write '.'"),
        ("{l: 1/0, m: 1/l}", "division by zero"),
    ],
)
def test_refused_parameters(parameters: str, message: str) -> None:
    assert mistake(f"{MINIMAL}parameters: {parameters}\n").startswith(message)


def test_parameters_that_nothing_of_the_arm_uses_are_told() -> None:
    named = "{a1: 1, a2: 2, a3: 2*a1, a4: a3, tilt: 30 deg, w: tilt/2, hand: 0.1, b: hand}"
    text = table("theta: q, a: a1, alpha: w", parameters=named, tool="{xyz: [0, 0, b]}")
    told = robot(text).notices
    assert [marked(notice) for notice in told] == ["a2", "a3", "a4"]
    meant = "remove it, or use it in a cell"
    assert told[0].message == f"no cell uses the parameter 'a2': {meant}"


def test_lengths_out_of_all_proportion_are_told() -> None:
    told = robot(table("theta: q, a: 1e-3", "theta: q, d: -1e6, a: 20")).notices
    assert [marked(notice) for notice in told] == ["1e-3"]
    beside = "'1e-3' is 1.0e-09 of the longest length, 1e+06, and may count as zero"
    assert told[0].message.startswith(f"{beside}: write 0 if that is meant, and give all")
    assert robot(table("theta: q, a: 0.4", "d: q, limits: [-1e8, 0]")).notices
    assert not robot(table("theta: q, a: 0.4, d: 1e-8", base="{xyz: [3e6, 0, 0]}")).notices
    assert not robot(table("theta: q, a: 0.4", "d: q, limits: [1e-9, 1]")).notices


def test_lengths_that_may_be_out_of_proportion_are_a_doubt() -> None:
    arm = robot(table("theta: q, a: 0.3", "theta: q, a: 4e5"))
    assert not arm.notices
    (doubt,) = arm.doubts
    assert marked(doubt) == "0.3"
    assert doubt.message.startswith("'0.3' is 7.5e-07 of the longest length, 400000, and rounding")
    assert not robot(table("theta: q, a: 0.3", "theta: q, a: 4e3")).doubts


@pytest.mark.parametrize(
    ("rows", "unit", "told"),
    [
        (["d: 0.29", "a: 270", "d: 0.302"], "m", "'270' is 894 times as long as '0.302', and no"),
        (["d: 0.9", "a: 70", "a: 455"], "m", "'70' is 78 times as long as '0.9', and no"),
        (["d: 0.29", "a: 270", "d: 0.302"], "mm", "'0.302' is 1/894 of '270', and no length is b"),
        (["d: 0.4", "a: 1.0", "d: 0.2"], "mm", "the longest length of this arm is 1 mm: write `un"),
        (["d: 400", "a: 1000", "d: 0"], "m", "the longest length of this arm is 1000 m: write `un"),
        (["a: 1e8"], "m", "the longest length of this arm is 1e+08 m: write `units: {length: um"),
        (["a: 4e5"], "mm", "the longest length of this arm is 400000 mm: write `un"),
        (["a: 2e8"], "mm", "the longest length of this arm is 2e+08 mm: are its lengths in mm?"),
        (["a: 0.004"], "m", "the longest length of this arm is 0.004 m: are its lengths in m?"),
        (["a: 0.004"], "mm", "the longest length of this arm is 0.004 mm: are its lengths in mm?"),
        (["d: 290", "a: 0.27", "a: 70"], "mm", "'0.27' is 1/259 of '70', and no length is"),
        (["d: 0.4", "a: 455", "a: 35"], "mm", "'0.4' is 1/88 of '35', and no length is"),
        (["d: 290", "a: 0.8", "a: 110"], "mm", ""),  # 0.8 m would be longer than the others
        (["d: 0.00035", "a: 0.4", "d: 0.01"], "m", ""),  # an offset of Kinova's Gen3
        (["d: 400", "a: 1000", "d: 10"], "mm", ""),
        (["d: 0.4", "a: 1", "d: 0.2"], "um", ""),
        (["d: 1", "a: 2", "d: 60"], "in", ""),
    ],
)
def test_lengths_in_another_unit_are_told(rows: list[str], unit: str, told: str) -> None:
    text = table(*(f"theta: q, {row}" for row in rows), units=f"{{length: {unit}}}")
    assert [notice.message[: len(told)] for notice in robot(text).notices] == [told] * bool(told)


@pytest.mark.parametrize(
    ("unit", "links", "limits", "told"),
    [
        ("m", (0.3, 0.25), "[0, 200]", "'200' is 667 times as long as '0.3', and no length is"),
        ("m", (0.3, 0.25), "[1e-4, 0.2]", ""),  # where a slide begins is no length
        ("m", (0.8, 0.7), "[-6, 0]", ""),  # a rail
        ("mm", (300, 250), "[0, 0.2]", "'0.2' is 1/1250 of '250', and no length is"),
    ],
)
def test_slides_that_go_as_far_as_in_another_unit_are_told(
    unit: str, links: tuple[float, float], limits: str, told: str
) -> None:
    rows = [f"theta: q, a: {link}" for link in links]
    text = table(*rows, f"d: q, limits: {limits}", units=f"{{length: {unit}}}")
    assert [notice.message[: len(told)] for notice in robot(text).notices] == [told] * bool(told)


@pytest.mark.parametrize(
    ("unit", "base", "told"),
    [
        ("mm", "[0.2, 0.4, 0.8]", ["'0.8' is 1/625 of '500': are both in mm?"]),
        ("mm", "[200, 0, 0.8]", []),
        ("mm", "[0, 0, 1e-6]", []),  # no base is a micrometre away
        ("m", "[0, 0, 800]", []),  # a place in the world
    ],
)
def test_a_base_in_metres_below_an_arm_in_millimetres_is_told(
    unit: str, base: str, told: list[str]
) -> None:
    links = (0.5, 0.4) if unit == "m" else (500, 400)
    text = table(*(f"theta: q, a: {link}" for link in links), units=f"{{length: {unit}}}")
    notices = robot(f"{text}base: {{xyz: {base}}}\n").notices
    assert [notice.message for notice in notices] == told


@pytest.mark.parametrize(
    ("rest", "told"),
    [
        ("base: {xyz: [4e5, -5e6, 0]}", ["4e5", "-5e6"]),
        ("base: {xyz: [100, 0, 0]}", []),
    ],
)
def test_a_base_far_away_is_a_doubt(rest: str, told: list[str]) -> None:
    arm = robot(table("theta: q, a: 0.4", "theta: q, a: 0.3") + rest)
    assert [marked(doubt) for doubt in arm.doubts] == told
    assert all("subtract it from the poses" in doubt.message for doubt in arm.doubts)


def test_a_slide_that_goes_far_beside_the_rest_is_a_doubt() -> None:
    (doubt,) = robot(table("theta: q, a: 2", "d: q, limits: [-1e4, 3]")).doubts
    assert marked(doubt) == "-1e4"
    assert doubt.message.startswith("'-1e4' is 5.0e+03 times the rest of the arm, and positions")
    assert not robot(table("theta: q", "d: q, limits: [-1e4, 3]")).doubts


@pytest.mark.parametrize("value", ["true", "True", "TRUE"])
def test_switches_as_yaml_writes_them(value: str) -> None:
    assert robot(f"{MINIMAL}float32: {value}\n").float32
    assert not robot(f"{MINIMAL}float32: {'false' if value == 'true' else 'False'}\n").float32


def test_a_unit_in_a_cell_is_told_where_units_stand() -> None:
    file = "a cell takes no unit: write '400', and for all lengths of the file"
    assert mistake(table("theta: q, a: 400 mm")) == f"{file} 'units: {{length: mm}}'"
    assert mistake(table("theta: q, a: 400in")) == f"{file} 'units: {{length: in}}'"
    assert mistake(table("theta: q + 1 rad")).endswith(
        "'units: {angle: rad}', which is the default"
    )
    assert mistake(table("theta: q, alpha: 90 degrees")).endswith("write '90 deg'")
    # m is no unit where a parameter is called so
    message = mistake(table("theta: q, a: 2 m", parameters="{m: 1}"))
    assert message == "not valid arithmetic: an operand or an operator is missing"


def test_decimal_commas_are_each_told_at_their_place() -> None:
    found = mistakes(f"{MINIMAL}parameters: {{l: 0,5, m: 1,5}}\n")
    assert [(each.message[-2:], each.column) for each in found] == [(",5", 19), (",5", 27)]


def test_a_mistaken_parameter_entails_no_further_mistakes() -> None:
    text = table("theta: q, a: 1/l, limits: [l, 0]", parameters="{l: 1/0}", tool="{xyz: [l, 0, 0]}")
    assert mistake(text) == "division by zero"
