"""Units of joints: degrees and radians, limits, and what looks like a slip of them."""

from __future__ import annotations

import math

import pytest

from dhgen.robot.expression import to_text
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

SLIDE = "type: prismatic, direction: [0, 0, 1]"


def test_limits_have_the_unit_of_their_joint() -> None:
    assert row("theta: q, limits: [-160 deg, pi]").limits == pytest.approx(
        (math.radians(-160), math.pi)
    )
    assert row("d: q, limits: [0, 2*l]", parameters="{l: 0.25}").limits == (0.0, 0.5)
    assert row("theta: q").limits is None


def test_degrees() -> None:
    joint = row("theta: q + 90, alpha: -45.5, limits: [-180, pi]", units="{angle: deg}")
    assert to_text(joint.theta) == "pi/2"
    assert to_text(joint.alpha) == "-45.5*(pi/180)"
    assert joint.limits == pytest.approx((-math.pi, math.pi))


@pytest.mark.parametrize("cell", ["30", "30 deg", "pi/6", "w", "v", "2*v/2", "60*sin(pi/6)"])
def test_in_a_file_of_degrees_what_speaks_of_pi_is_in_radians(cell: str) -> None:
    joint = row(f"theta: q, alpha: {cell}", units="{angle: deg}", parameters="{w: 30, v: pi/6}")
    assert to_text(joint.alpha) == "pi/6"


def test_degrees_leave_lengths_alone() -> None:
    joint = row("d: q + 90, a: 45, limits: [0, 100]", units="{length: mm, angle: deg}")
    assert (to_text(joint.d), to_text(joint.a), joint.limits) == ("90", "45", (0.0, 100.0))


def test_an_angle_under_a_name_is_no_length_either() -> None:
    told = "'{}' is an angle, but a length belongs here: leave out deg, or take its sin or cos"
    assert mistake(table("theta: q, a: w", parameters="{v: 30 deg, w: -v}")) == told.format("w")
    assert mistake(table("theta: q", tool="{xyz: [0, 0, 5 deg]}")) == told.format("5 deg")
    slide = f"{SLIDE}, limits: [-1, -(5 deg)]"
    assert mistake(axes(slide)) == told.format("-(5 deg)")


@pytest.mark.parametrize(
    "cell", ["2*sin(30 deg)", "l*(30 deg)", "l*w", "0.1*(30 deg)", "l*w/(360 deg)", "cos(w)"]
)
def test_a_length_may_be_that_of_an_arc_or_come_from_a_ratio_of_angles(cell: str) -> None:
    named = "{l: 0.1, w: 30 deg}"
    joint = row(f"d: q, a: {cell}, limits: [0, {cell}]", parameters=named)
    assert joint.limits
    assert joint.limits[1] > 0


def test_a_slip_in_degrees_is_told_in_degrees() -> None:
    loaded = robot(table("theta: q, alpha: 90.01", units="{angle: deg}"))
    assert [notice.message for notice in loaded.notices] == [
        "'90.01' is 1.0e-02 away from 90: write 90 if that is meant"
    ]


def test_radians_in_a_file_of_degrees_are_told() -> None:
    loaded = robot(table("theta: q, alpha: -1.5708", units="{angle: deg}"))
    assert [notice.message for notice in loaded.notices] == [
        "'-1.5708' is -1.5708 degrees: write -90 if -pi/2 is meant"
    ]
    for cell in ("1.5", "1.5708 deg"):
        assert not robot(table(f"theta: q, alpha: {cell}", units="{angle: deg}")).notices
    assert robot(table("theta: q, alpha: 3.14", units="{angle: deg}")).notices


def test_degrees_in_a_file_of_radians_are_told() -> None:
    loaded = robot(table("theta: q, alpha: 90"))
    assert [notice.message for notice in loaded.notices] == [
        "'90' is 14.3 turns: write 90 deg if degrees are meant"
    ]
    assert not robot(table("theta: q, alpha: 90 deg, limits: [-7, 7]")).notices


DEGREES = ("theta: q, alpha: -90, limits: [-165, 165]", "theta: q + 90, limits: [-110, w]")


def test_degrees_in_several_cells_are_a_mistake() -> None:
    """-90 rad are fourteen turns: the arm would be another one."""
    named = "{w: 70}"
    (found,) = mistakes(table(*DEGREES, parameters=named))
    assert marked(found) == "-90"
    assert found.message == (
        "'-90' is 14.3 turns, and 5 more angles are of many turns, too: write `units: {angle: deg}`"
        " if degrees are meant, `units: {angle: rad}` if not"
    )
    in_degrees = robot(table(*DEGREES, parameters=named, units="{angle: deg}"))
    assert not in_degrees.notices
    assert in_degrees.joints[1].limits == pytest.approx((math.radians(-110), math.radians(70)))


def test_many_turns_in_a_file_that_says_rad_are_only_noted() -> None:
    notices = told_of_cells(table(*DEGREES, parameters="{w: 70}", units="{angle: rad}"))
    assert notices[0] == "'-90' is 14.3 turns: write -90 deg if degrees are meant"
    assert len(notices) == 4
    assert not told_of_cells(table("theta: q, limits: [-13, 12]", "theta: q, limits: [-7, 7]"))[1:]


@pytest.mark.parametrize(
    ("joint", "told"),
    [
        ("theta: q + 90 + pi", "the offset of 'q + 90 + pi' has 90 in rad"),
        ("theta: q, alpha: 2*(pi - w/2)", "'2*(pi - w/2)' has w/2 in rad"),
        ("theta: q, limits: [0, 90 + 45 deg]", "'90 + 45 deg' has 90 in rad"),
    ],
)
def test_a_plain_number_beside_pi_is_told_in_a_file_of_degrees(joint: str, told: str) -> None:
    (message,) = told_of_cells(table(joint, parameters="{w: 90}", units="{angle: deg}"))
    meant = "w/2*deg" if "w" in joint else "90 deg"
    beside = ", as it is next to pi or deg: write"
    assert message == f"{told}{beside} {meant} if degrees are meant"


@pytest.mark.parametrize("unit", ["rad", "deg"])
def test_degrees_that_sin_and_cos_do_not_take_are_told(unit: str) -> None:
    cells = "a: 0.4*cos(30), d: sin(tilt - 60)"
    text = table(f"theta: q, {cells}", parameters="{tilt: 15}", units=f"{{angle: {unit}}}")
    assert told_of_cells(text) == [
        "'cos(30)' takes rad: write cos(30 deg) if degrees are meant",
        "'sin(tilt - 60)' takes rad: write sin((tilt - 60)*deg) if degrees are meant",
    ]
    fine = "theta: q, a: sin(w) + cos(30 deg), d: cos(0)*sqrt(90)"
    text = table(fine, parameters="{w: pi/7}", units=f"{{angle: {unit}}}")
    assert not told_of_cells(text)
    assert bool(told_of_cells(table("theta: q, a: sin(1.5)", units=f"{{angle: {unit}}}"))) == (
        unit == "deg"
    )


def test_a_plain_number_beside_pi_is_told_in_a_file_of_radians_if_it_is_many_turns() -> None:
    (notice,) = robot(table("theta: q + pi - 90")).notices
    told = "the offset of 'q + pi - 90' is 13.8 turns: write 90 deg if degrees are meant"
    assert notice.message == told
    assert not robot(table("theta: q + pi - 0.02, limits: [-pi - 1, pi + 1]")).notices


@pytest.mark.parametrize("cell", ["90*pi/200", "pi/2 - 3 deg", "v - pi/5 + 0", "w + 30*sin(pi/6)"])
def test_what_is_multiplied_with_pi_or_adds_angles_is_no_mixture(cell: str) -> None:
    named = "{w: 41, v: 40 deg}"
    text = table(f"theta: q, alpha: {cell}", parameters=named, units="{angle: deg}")
    assert not told_of_cells(text)


@pytest.mark.parametrize("limits", ["[-120, 120]", "[-92.5, w]", "[-355, 355]", "[-22, 22]"])
def test_limits_in_degrees_are_a_mistake_even_of_one_joint(limits: str) -> None:
    """Both ends count; whole numbers are no half turns, however near they come to some."""
    (found,) = mistakes(table(f"theta: q, limits: {limits}", parameters="{w: 160}"))
    assert "turns, and one more angle is of many turns, too: write `units: {angle: deg}`" in (
        found.message
    )
    joint = row(f"theta: q, limits: {limits}", parameters="{w: 160}", units="{angle: deg}")
    assert joint.limits
    assert joint.limits[1] < math.tau


@pytest.mark.parametrize(
    "limits",
    [
        "[-62.83, 62.83]",
        "[-62.8, 62.8]",
        "[-31.4159, 31.4159]",
        "[-15.708, 15.71]",
        "[-1, 18.85]",
        "[-12.6, 18.8]",
    ],
)
def test_limits_that_are_half_turns_are_radians(limits: str) -> None:
    """Ten turns of a wrist, or five: a note says it, and the arm is the one that is written."""
    text = table(f"theta: q, limits: {limits}", f"theta: q, limits: {limits}")
    assert len(told_of_cells(text)) == 2
    assert robot(text).joints[0].limits


@pytest.mark.parametrize("limits", ["[-720 deg, 720 deg]", "[-20*pi, 4*pi]", "[-12.566, 12.56]"])
def test_limits_that_name_their_unit_or_are_two_turns_are_nothing_to_speak_of(limits: str) -> None:
    assert not told_of_cells(table(f"theta: q, limits: {limits}", f"theta: q, limits: {limits}"))


def test_limits_of_many_turns_are_told_once_a_joint() -> None:
    text = table("theta: q, limits: [-170, 170]", units="{angle: rad}")
    assert told_of_cells(text) == ["'-170' is 27.1 turns: write -170 deg if degrees are meant"]
    text = table("theta: q, limits: [0, w]", parameters="{w: 160}")
    assert told_of_cells(text) == ["'w' is 25.5 turns: write 160 deg if degrees are meant"]


@pytest.mark.parametrize(
    ("limits", "message"),
    [
        ("[-3.14, 3.14]", "'-3.14' is -3.14 degrees: write -180 if -pi is meant"),
        ("[0, 3.1416]", "'3.1416' is 3.1416 degrees: write 180 if pi is meant"),
        ("[-90, w]", "'w' is 1.571 degrees: write 90 if pi/2 is meant"),
    ],
)
def test_limits_of_degrees_that_look_like_radians_are_told_once_a_joint(
    limits: str, message: str
) -> None:
    text = table(f"theta: q, limits: {limits}", parameters="{w: 1.571}", units="{angle: deg}")
    assert told_of_cells(text) == [message]


@pytest.mark.parametrize(
    ("joint", "unit"),
    [
        ("theta: q, limits: [-1080 deg, 6*pi]", "rad"),
        ("theta: q, limits: [-w, w]", "rad"),
        ("theta: q, limits: [-1.5708, 12.566]", "rad"),  # limits may be rounded
        ("theta: q, limits: [-1080, 1080]", "deg"),
        ("theta: q, limits: [-3.14 deg, 3]", "deg"),
        ("theta: q, limits: [-1.5, 3.2]", "deg"),
        ("d: q, limits: [-3.14, 3.14]", "deg"),
        ("d: q, limits: [-170, 170]", "rad"),
    ],
)
def test_limits_of_turns_that_are_meant_are_left_alone(joint: str, unit: str) -> None:
    text = table(joint, parameters="{w: 1080 deg}", units=f"{{angle: {unit}}}")
    assert not told_of_cells(text)


STIFF = ("theta: q, alpha: -90, limits: [-2.9, 2.9]", "theta: q, limits: [0, w]")


def test_limits_in_radians_beside_twists_in_degrees_are_told() -> None:
    """2.9 rad are 166 degrees: nobody builds an arm of which no joint turns by six degrees."""
    (message,) = told_of_cells(table(*STIFF, parameters="{w: 6.1}", units="{angle: deg}"))
    degrees = math.degrees(-2.9)
    told = f"all these limits are within 6.1 degrees: write {degrees:.6g} for '-2.9'"
    assert message == f"{told}, and the others so, if they are in rad"


@pytest.mark.parametrize(
    ("rows", "parameters"),
    [
        (STIFF, "{w: 8}"),  # one joint that turns
        (STIFF, "{w: pi}"),  # one plain pair of limits: the other says what it is
        ((STIFF[0], "d: q, limits: [0, w]"), "{w: 6}"),  # a slide has lengths
        ((STIFF[0], "theta: q, d: w"), "{w: 6}"),
    ],
)
def test_limits_of_a_few_degrees_that_may_be_meant_are_left_alone(
    rows: tuple[str, ...], parameters: str
) -> None:
    assert not told_of_cells(table(*rows, parameters=parameters, units="{angle: deg}"))
