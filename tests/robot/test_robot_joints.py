"""Joints: the variable with its sign and offset, exact angles, limits, and axes."""

from __future__ import annotations

import copy
import math
from fractions import Fraction

import pytest

from dhgen.errors import RobotFileError
from dhgen.kinematics.build import build_chain
from dhgen.robot.expression import ZERO, Name, Negate, Number, to_text
from dhgen.robot.robot import (
    AxisJoint,
    JointKind,
    ReferenceAxes,
)
from dhgen.robot.shape import NO_LIMITS
from tests.robot.robot_texts import (
    axes,
    marked,
    mistake,
    mistakes,
    robot,
    row,
    table,
    told_of_cells,
)

NAMED = table("theta: q, name: left/arm-joint 1", "theta: 0, d: q, name: arm.joint:2")
TURN = "type: revolute, direction: [0, 0, 1], point: [0, 0, 0]"
SLIDE = "type: prismatic, direction: [0, 0, 1]"


@pytest.mark.parametrize(
    ("cell", "sign", "offset"),
    [
        ("q", 1, "0"),
        ("-q", -1, "0"),
        ("q + 0.2", 1, "0.2"),
        ("q - 0.2", 1, "-0.2"),
        ("0.2 + q", 1, "0.2"),
        ("0.2 - q", -1, "0.2"),
        ("-q + 0.2", -1, "0.2"),
        ("-q - 0.2", -1, "-0.2"),
        ("-(q - 0.2)", -1, "0.2"),
        ("q + (-pi/2)", 1, "-pi/2"),
        ("(q)", 1, "0"),
        ("q + pi/2", 1, "pi/2"),
        ("q - 90 deg", 1, "-pi/2"),
        ("q + 0.1 + 0.2", 1, "0.3"),
        ("q + w", 1, "w"),
        ("q - w", 1, "-w"),
    ],
)
def test_the_variable_of_a_revolute_joint(cell: str, sign: int, offset: str) -> None:
    joint = row(f"theta: {cell}", parameters="{w: 0.3}")
    assert joint.kind is JointKind.REVOLUTE
    assert (joint.sign, to_text(joint.theta)) == (sign, offset)
    assert (joint.d, joint.a, joint.alpha) == (ZERO, ZERO, ZERO)


def test_a_prismatic_joint() -> None:
    joint = row("theta: pi/2, d: d1 - q, a: 0.1", parameters="{d1: 0.3}")
    assert (joint.kind, joint.sign, joint.d) == (JointKind.PRISMATIC, -1, Name("d1"))
    assert to_text(joint.theta) == "pi/2"


@pytest.mark.parametrize(
    ("cells", "at", "message"),
    [
        ("theta: 0", "{", "no variable: write q in theta (revolute) or in d (prismatic);"),
        ("theta: q, d: q", "q", "q is already in theta: a joint has only one variable"),
        ("theta: 2*q", "2*q", "q may only have a sign and an offset"),
        ("theta: q + q", "q + q", "q may only have a sign and an offset"),
        ("theta: q - q", "q - q", "q may only have a sign and an offset"),
        ("theta: sin(q)", "sin(q)", "q may only have a sign and an offset"),
        ("theta: q**1", "q**1", "q may only have a sign and an offset"),
        ("theta: q, a: q", "q", "the variable q is only allowed in theta or d of a joint"),
        ("theta: q, limits: [0]", "[", "expected 2 values, not 1"),
        ("theta: q, limits: [1, 1]", "[", "the lower limit 1 is not below the upper one 1"),
        ("theta: q, limits: [1, -1]", "[", "the lower limit 1 is not below the upper one -1"),
        ("theta: q, limits: [-.inf, 1]", "-.inf", "'-.inf' is not a number: if nothing stops the"),
        ("theta: q, limits: [-1, Infinity]", "Infinity", "'Infinity' is not a number: if"),
        ("theta: q, limits: [-1, 1e16]", "1e16", "'1e16' is beyond 1e+04 rad: if nothing stops"),
        ("d: q, limits: [null, 1]", "null", "'null' is not a number: if nothing stops the slide"),
        (
            "d: q, limits: [-2e9, 1]",
            "-2e9",
            "'-2e9' is beyond 1e+09: if nothing stops the slide",
        ),
        ("d: q, limits: [-inf, inf]", "[", "neither value limits the joint: leave 'limits' out"),
        ("theta: q, alhpa: 0", "alhpa", "unknown key 'alhpa'; did you mean 'alpha'? valid: theta"),
        ("theta: , d: q", "theta", "expected a number or an expression, not nothing"),
        ("theta: q, a: 0,4", "4", "write a decimal point: 0.4, not 0,4"),
        ("theta: q, a:1", "a:1", "a space must follow the colon: 'a: 1', not 'a:1'"),
        ("theta = q + pi", "theta = q + pi", "unknown key 'theta = q + pi': write 'theta: q + pi'"),
        ("theta: q, a 1", "a 1", "unknown key 'a 1': write 'a: 1', with a colon"),
        ("theta: q, b 1", "b 1", "unknown key 'b 1'; valid: theta, d"),
        ("theta: q, alpha: PI", "PI", "unknown name 'PI'; did you mean 'pi'? valid: pi, deg"),
        ("theta: q, a: 2*lambda", "lambda", "'lambda' is a keyword of Python, no name"),
        ("theta: q1", "q1", "the variable of this row is called q here: write q for q1"),
        ("d: 0.1 - q_2", "q_2", "unknown name 'q_2': in every row the joint's own variable is"),
        ("theta: q - q2", "q2", "unknown name 'q2': there is no joint 2"),
        ("theta: q1 + q2", "q1", "the variable of this row is called q here: write q for q1; with"),
        ("theta: q, a: q1", "q1", "unknown name 'q1'; valid: pi, deg, sqrt, sin, cos"),
        ("theta: q, free: true", "free", "unknown key 'free'; it stands on a line of its own as"),
        ("theta: q, task: pose", "task", "unknown key 'task'; it stands on a line of its own as"),
        ("theta: q, title: elbow", "title", "unknown key 'title'; a joint has only a 'name': say"),
        ("theta: q, name: [1]", "[", "expected a text, not a list of 1"),
        ('theta: q, name: a"b', 'a"b', "'a\"b': a joint can't have this name: it must be plain"),
        (
            "theta: q, name: Gelenk°",
            "Gelenk°",
            "'Gelenk°': a joint can't have this name: it must be plain",
        ),
        ("d: q, type: prismatic", "type", "unknown key 'type'; a joint slides by 'theta: 0, d: q'"),
        ("theta: q, min: -1", "min", "unknown key 'min'; limits are a list: 'limits: [-1.5, 1.5]'"),
        ("θ: q", "θ", "unknown key 'θ'; the angle about z is called 'theta'"),
        ("theta: q, α: 0", "α", "unknown key 'α'; the twist about x is called 'alpha'"),
        (
            "theta: q, r: 0.3",
            "r",
            "unknown key 'r'; the length along x is called 'a', the one along",
        ),
        ("theta: theta3", "theta3", "unknown name 'theta3': in every row the joint's own variable"),
        ("theta: th_1 + pi", "th_1", "unknown name 'th_1': in every row the joint's own variable"),
        ("thata: q", "thata", "unknown key 'thata'; did you mean 'theta'?"),
        ("theta: q, alpha: 1e5", "1e5", "the angle 100000 rad is beyond 1e+04"),
        ("theta: q, a: 30 deg", "30 deg", "'30 deg' is an angle, but a length belongs here: leave"),
        ("theta: q, d: 0.1 + deg", "0.1 + deg", "'0.1 + deg' is an angle, but a length belongs"),
        ("d: q - 30 deg", "q - 30 deg", "'q - 30 deg' is an angle, but a length belongs here"),
        ("d: q, limits: [0, 100 deg]", "100 deg", "'100 deg' is an angle, but a length belongs"),
    ],
)
def test_refused_rows(cells: str, at: str, message: str) -> None:
    (found,) = mistakes(table(cells))
    assert found.message.startswith(message)
    assert marked(found) == at


def test_a_parameter_that_is_called_as_books_call_variables_is_none() -> None:
    (found,) = mistakes(table("theta: q2 + th1", parameters="{th1: 0.3}"))
    assert found.message == "unknown name 'q2': in every row the joint's own variable is called q"


@pytest.mark.parametrize(
    ("limits", "written"),
    [
        ("(-1, 1)", "[-1, 1]"),
        ("-1, 1", "[-1, 1]"),
        ("( -pi/2 , 160 deg )", "[-pi/2, 160 deg]"),
        ("(1 - 2)*3, 2*(1 + 1)", "[(1 - 2)*3, 2*(1 + 1)]"),
        ("{-1, 1}", "[-1, 1]"),
    ],
)
def test_limits_without_square_brackets_are_told_so(limits: str, written: str) -> None:
    (found,) = mistakes(table(f"theta: q, limits: {limits}, a: 0.4"))
    assert found.message == f"'limits' takes a list in square brackets: {written}"
    assert marked(found) == limits.strip("{}")
    if "{" not in limits:
        below = f"name: r\njoints:\n  - theta: q\n    limits: {limits}\n    a: 0.4\n"
        assert mistake(below) == found.message


def test_what_stands_in_a_list_without_square_brackets_is_read_all_the_same() -> None:
    rows = "theta: q, limits: 1, x", "theta: q, limits: (1, -1)"
    found = mistakes(table(*rows, tool="{xyz: 0, y, 0.1}", free="1,2"))
    assert [each.message.split(":")[0] for each in found] == [
        "'xyz' takes a list in square brackets",
        "unknown name 'y'; valid",
        "'free' takes a list in square brackets",
        "every joint is free",
        "'limits' takes a list in square brackets",
        "unknown name 'x'; valid",
        "'limits' takes a list in square brackets",
        "the lower limit 1 is not below the upper one -1",
    ]


def test_a_list_in_quotes_is_told_so() -> None:
    told = "'limits' takes a list in square brackets, without quotes: [-1, 1]"
    assert mistake(table("theta: q, limits: '[-1, 1]'")) == told


@pytest.mark.parametrize(
    ("unit", "low", "high"),
    [("rad", "8.4292 rad", "3.14159 rad"), ("deg", "482.958 deg", "180 deg")],
)
def test_ends_in_the_wrong_order_are_shown_with_what_is_told_of_them(
    unit: str, low: str, high: str
) -> None:
    text = table("theta: q, alpha: 1.5708 deg + 1.5", "theta: q, limits: [-90 deg + 10, pi]")
    with pytest.raises(RobotFileError) as info:
        robot(f"{text}units: {{angle: {unit}}}\n")
    (order,) = info.value.diagnostics
    ends = f"'-90 deg + 10' ({low}) is not below the upper one 'pi' ({high})"
    assert order.message == f"the lower limit {ends}"
    (note,) = info.value.notes
    mixed = "has 10 in rad, as it is next to pi or deg: write 10 deg if degrees are meant"
    assert note.message == f"'-90 deg + 10' {mixed}"
    assert str(info.value) == f"{order}\nnote: {note}"


def test_notes_on_other_fields_wait_until_the_mistakes_are_mended() -> None:
    rows = "theta: q, limits: [170, x]", "theta: q, alpha: 1.5708", "alpha: 1.5708"
    with pytest.raises(RobotFileError) as info:
        robot(table(*rows))
    assert [found.message.split(";")[0] for found in info.value.diagnostics] == [
        "unknown name 'x'",
        "no variable: write q in theta (revolute) or in d (prismatic)",
    ]
    assert [(note.line, marked(note)) for note in info.value.notes] == [(3, "170")]
    again = copy.copy(info.value)  # as for another process
    assert str(again) == str(info.value)


@pytest.mark.parametrize("joint", ["theta: q", "d: q"])
@pytest.mark.parametrize(
    "ends", ["-.inf, .inf", "~, ~", "null, null", "-1e16, 1e16", "-inf, 1e12", "none, Unlimited"]
)
def test_of_limits_that_are_nowhere_one_is_told_to_leave_them_out(joint: str, ends: str) -> None:
    told = mistake(table(f"{joint}, limits: [{ends}]"))
    assert told == "neither value limits the joint: leave 'limits' out"
    assert not robot(table(joint)).notices


@pytest.mark.parametrize("limits", ["", "~", "null", "[]", ".inf", "none", "continuous"])
def test_limits_that_say_that_there_are_none(limits: str) -> None:
    told = mistake(f"name: r\njoints:\n- theta: q\n  limits: {limits}\n")
    assert told.startswith("expected ")
    assert told.endswith(f"; {NO_LIMITS}")


@pytest.mark.parametrize("unit", ["rad", "deg"])
@pytest.mark.parametrize("end", ["~", ".inf", "1e20"])
@pytest.mark.parametrize("ends", ["[0, {}]", "[-{}, 0]"])
def test_what_is_to_be_written_for_an_end_that_there_is_not_is_accepted(
    ends: str, end: str, unit: str
) -> None:
    text = ends.format(end).replace("-~", "~")
    told = mistake(table(f"theta: q, limits: {text}", units=f"{{angle: {unit}}}"))
    advice = told.split("write some turns, e.g. ")[1]
    text = ends.replace("-{}", "{}").format(advice)
    loaded = robot(table(f"theta: q, limits: {text}", units=f"{{angle: {unit}}}"))
    assert not loaded.notices
    assert loaded.joints[0].limits == pytest.approx(
        (0, 20 * math.pi) if ends[1] == "0" else (-20 * math.pi, 0)
    )


def test_a_slide_s_end_that_there_is_not_is_as_far_as_it_is_sent() -> None:
    told = mistake(axes(f"{SLIDE}, limits: [0, ~]"))
    assert told.endswith("if nothing stops the slide, write the farthest that it is ever sent")


@pytest.mark.parametrize("limits", ["1", "(1)", "none", "{min: -1, max: 1}"])
def test_limits_that_are_no_list_at_all(limits: str) -> None:
    assert mistake(table(f"theta: q, limits: {limits}")).startswith("expected a list [lowest,")


def test_a_parameter_may_be_called_infinity() -> None:
    assert row("theta: q, limits: [-inf, 2*inf]", parameters="{inf: 9}").limits == (-9.0, 18.0)


def test_all_mistakes_of_a_file_come_at_once_and_in_its_order() -> None:
    rows = ("theta: q, a: x, aplha: 0", "theta: 0", "d: q, alpha: 1/0")
    text = table(*rows, tool="{rpy: [0]}", task="t")
    found = mistakes(f"{text}units: {{angle: grad}}\n")
    assert [d.message.split(" ")[0] for d in found] == [
        "expected",
        "expected",
        "unknown",
        "unknown",
        "no",
        "division",
        "expected",
    ]
    assert sorted(found, key=lambda d: (d.line, d.column)) == list(found)


@pytest.mark.parametrize("cell", ["pi/2", "90 deg", "0.5*pi", "pi - pi/2", "1.5707963267948966"])
def test_a_right_angle_is_exact_without_a_notice(cell: str) -> None:
    loaded = robot(table(f"theta: q, alpha: {cell}"))
    assert [to_text(getattr(joint, "alpha", ZERO)) for joint in loaded.joints] == ["pi/2"]
    assert not loaded.notices


@pytest.mark.parametrize(
    "cell", ["-1.5700966665020601", "1.57009666650", "0.000300000000000", "3.00000000000e-4"]
)
def test_what_was_measured_to_twelve_digits_is_no_slip(cell: str) -> None:
    """A calibration, which a right angle in its place would undo."""
    loaded = robot(table(f"theta: q, alpha: {cell}"))
    assert getattr(loaded.joints[0], "alpha", ZERO) != ZERO
    assert not loaded.notices


def test_eleven_digits_may_be_a_slip() -> None:
    (notice,) = robot(table("theta: q + 0.00030000000000, alpha: 1.5700966665")).notices[:1]
    assert "write q if that is meant" in notice.message


@pytest.mark.parametrize(
    ("cell", "alpha", "message"),
    [
        ("1.57079632679", "pi/2", "is 4.9e-12 away from pi/2 and taken as pi/2"),
        ("-3.1415926536", "-pi", "is 1.0e-11 away from -pi and taken as -pi"),
        ("1e-10", "0", "is 1.0e-10 away from 0 and taken as 0"),
        ("0.5235987756", "pi/6", "is 1.7e-12 away from pi/6 and taken as pi/6"),
        ("1.5708", "1.5708", "is 3.7e-06 away from pi/2: write pi/2 if that is meant"),
        ("1.571", "1.571", "is 2.0e-04 away from pi/2: write pi/2 if that is meant"),
        ("-1.5708", "-1.5708", "is 3.7e-06 away from -pi/2: write -pi/2 if that is meant"),
        ("3.1416", "3.1416", "is 7.3e-06 away from pi: write pi if that is meant"),
        (  # pi/2 in single precision
            "1.5707963705062866",
            "1.5707963705062866",
            "is 4.4e-08 away from pi/2: write pi/2 if that is meant",
        ),
        (
            "90.01 deg",
            "90.01*(pi/180)",
            "is 1.0e-02 away from 90 deg: write 90 deg if that is meant",
        ),
    ],
)
def test_angles_that_mean_something_else_are_told(cell: str, alpha: str, message: str) -> None:
    loaded = robot(table(f"theta: q, alpha: {cell}"))
    assert [to_text(getattr(joint, "alpha", ZERO)) for joint in loaded.joints] == [alpha]
    (notice,) = loaded.notices
    assert notice.message == f"'{cell}' {message}"
    assert marked(notice) == cell


@pytest.mark.parametrize("cell", ["0.3", "0.5236", "1.5", "w"])
def test_other_angles_are_left_alone(cell: str) -> None:
    text = table(f"theta: q, alpha: {cell}", parameters="{w: 0.7}")
    assert [to_text(getattr(joint, "alpha", ZERO)) for joint in robot(text).joints] == [cell]
    assert not told_of_cells(text)


def test_lengths_next_to_nothing_are_zero() -> None:
    loaded = robot(table("theta: q, d: -1e-10, a: l", parameters="{l: 0}"))
    (joint,) = loaded.joints
    assert (getattr(joint, "d", None), getattr(joint, "a", None)) == (ZERO, ZERO)
    assert [notice.message for notice in loaded.notices] == [
        "'-1e-10' is 1.0e-10 away from 0 and taken as 0"
    ]


def test_what_is_taken_as_exact_is_kept_with_its_place() -> None:
    base = "[[1, 0, 0, 0], [0, 0, -0.9999999999, 1e-10], [0, 1, 0, 0], [0, 0, 0, 1]]"
    rows = "theta: 3.14159265359 - q", "theta: q + 1e-10", "theta: q, a: 0.4"
    loaded = robot(table(*rows, base=base))
    found = {(cell.place, cell.text, cell.exact) for cell in loaded.taken}
    assert found == {
        ("theta of joint 1", "3.14159265359 - q", "-q + pi"),
        ("theta of joint 2", "q + 1e-10", "q"),
        ("entry 2,3 of matrix of base", "-0.9999999999", "-1"),
        ("entry 2,4 of matrix of base", "1e-10", "0"),
    }


def test_axes() -> None:
    loaded = robot(axes(f"{TURN}, limits: [-1, 1]", SLIDE))
    assert isinstance(loaded.geometry, ReferenceAxes)
    turn, slide = loaded.joints
    assert isinstance(turn, AxisJoint)
    assert (turn.kind, turn.limits) == (JointKind.REVOLUTE, (-1.0, 1.0))
    assert (slide.kind, slide.limits) == (JointKind.PRISMATIC, None)


@pytest.mark.parametrize(
    ("entry", "message"),
    [
        ("type: revolute, direction: [0, 0, 1]", "the key 'point' is missing: a revolute joint"),
        ("direction: [0, 0, 1]", "the key 'type' is missing"),
        ("type: revolute, point: [0, 0, 0]", "the key 'direction' is missing"),
        ("type: prismatic, direction: [0, 0, 0]", "a direction can't have length 0"),
        ("type: prismatic, direction: [l - l, 0, 0]", "a direction can't have length 0"),
        ("type: rotary, direction: [0, 0, 1]", "expected 'revolute' or 'prismatic', not 'rotary'"),
        ("type: prismatic, direction: [0, 1]", "expected 3 values, not 2"),
        ("type: prismatic, direction: [0, 0, 1e12]", "the value 1e+12 is beyond 1e+09"),
    ],
)
def test_refused_axes(entry: str, message: str) -> None:
    assert mistake(axes(entry, parameters="{l: 1}")).startswith(message)


def test_negative_numbers_are_negated_ones() -> None:
    assert row("theta: q, a: -0.1").a == Negate(Number(Fraction(1, 10)))


def test_names_of_joints() -> None:
    assert [joint.name for joint in robot(NAMED).joints] == ["left/arm-joint 1", "arm.joint:2"]
    assert build_chain(robot(NAMED)).joint_names == ("left/arm-joint 1", "arm.joint:2")
    plain = build_chain(robot(table("theta: q", "theta: 0, d: q")))
    assert plain.joint_names == ("joint1", "joint2")
    long = mistake(table(f"theta: q, name: {'n' * 65}"))
    assert long.endswith("it has 65 characters; at most 64 are allowed")
    assert (plain.named((1, 2)), build_chain(robot(NAMED)).named((2,))) == (
        "1, 2",
        "2 (arm.joint:2)",
    )


@pytest.mark.parametrize("kind", ["table", "axes"])
def test_names_are_for_all_joints_and_differ(kind: str) -> None:
    rows = ("theta: q{}", "theta: q{}", "theta: q{}")
    turns = ("type: revolute, direction: [0, 0, 1], point: [0, 0, 0]{}",) * 3
    made, entries = (table, rows) if kind == "table" else (axes, turns)
    names = (", name: elbow", "", ", name: elbow")
    text = made(*(entry.format(name) for entry, name in zip(entries, names, strict=True)))
    twice, missing = sorted(mistakes(text), key=lambda each: each.message)
    assert (twice.message, marked(twice)) == ("joint 1 is called so, too", "elbow")
    assert missing.message == "joint 2 has no name: name every joint, or none"
    assert (twice.line - missing.line, missing.line) == (1, 4)
