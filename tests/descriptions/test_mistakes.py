"""Mistakes in a URDF are told all at once, each at its place, and harm is refused at once."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING

import pytest

from dhgen.descriptions.convert import convert
from dhgen.descriptions.urdf import read_urdf
from dhgen.descriptions.wishes import Wishes
from dhgen.errors import RobotFileError

if TYPE_CHECKING:
    from dhgen.descriptions.convert import Import

LINKS = '<link name="a"/>\n<link name="b"/>\n<link name="c"/>\n'
TURN = (
    '<joint name="{name}" type="revolute"><parent link="{parent}"/><child link="{child}"/>'
    '<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="{axis}"/><limit lower="-1" upper="1"/></joint>\n'
)


def turn(name: str, parent: str, child: str, **cells: str) -> str:
    given = {"xyz": "0 0 0.5", "rpy": "0 0 0", "axis": "0 1 0", **cells}
    return TURN.format(name=name, parent=parent, child=child, **given)


def robot(*joints: str, links: str = LINKS) -> str:
    return f'<robot name="r">\n{links}{"".join(joints)}</robot>\n'


RIGHT = robot(turn("one", "a", "b"), turn("two", "b", "c"))


def read(text: str | bytes) -> Import:
    content = text if isinstance(text, bytes) else text.encode()
    return convert(read_urdf(content, "arm.urdf"), Wishes())


def mistakes(text: str | bytes) -> list[tuple[int, str]]:
    with pytest.raises(RobotFileError) as refused:
        read(text)
    return [(mistake.line, mistake.message) for mistake in refused.value.diagnostics]


def test_the_file_that_the_others_differ_from_is_right() -> None:
    assert len(read(RIGHT).chain.actuated) == 2


@pytest.mark.parametrize(
    ("text", "line", "told"),
    [
        (robot(turn("one", "a", "b", xyz="0 nan 0")), 5, "'nan' is not a number"),
        (robot(turn("one", "a", "b", rpy="0 0 inf")), 5, "'inf' is not a number"),
        (robot(turn("one", "a", "b", xyz="0, 0, 1")), 5, "without commas"),
        (robot(turn("one", "a", "b", xyz="0 0")), 5, "xyz needs three numbers, not '0 0'"),
        (robot(turn("one", "a", "b", xyz="0 0 1_0")), 5, "'1_0' is not a number"),
        (robot(turn("one", "a", "b", xyz="0 0 1e99")), 5, "'1e99' is beyond all sizes"),
        (robot(turn("one", "a", "b", axis="0 0 0")), 5, "an axis can't have length 0"),
        (robot(turn("one", "a", "d")), 5, "there is no link 'd'; valid: a, b, c"),
        (robot(turn("one", "a", "b"), turn("one", "b", "c")), 6, "'one' is already in line 5"),
        (robot(turn("one", "a", "a")), 5, "'one' moves the link that it is on"),
        (robot(turn("one", "a", "b"), turn("two", "c", "b")), 6, "two joints move the link 'b'"),
        (robot(turn("one", "a", "b"), turn("two", "b", "a")), 6, "in a circle"),
        (robot(turn("1", "a", "b"), turn("2", "c", "d"), links=LINKS + '<link name="d"/>\n'), 7,
         "the links are not one tree: no joint moves 'a', 'c'"),
        (robot(turn("one", "a", "b"), links=LINKS + '<link name="a"/>\n'), 5,
         "the link 'a' is already in line 2"),
        (robot('<joint name="j" type="hinge"><parent link="a"/><child link="b"/></joint>'), 5,
         "unknown type of joint 'hinge'"),
        (robot('<joint name="j"><parent link="a"/><child link="b"/></joint>'), 5, "needs a type"),
        (robot('<joint name="j" type="fixed"><parent link="a"/></joint>'), 5, "needs a <child"),
        (robot('<joint type="fixed"><parent link="a"/><child link="b"/></joint>'), 5,
         "a <joint> needs a name"),
        (robot(), 1, "no <joint>"),
        ("<model/>", 1, "a URDF begins with <robot>, not <model>"),
        (RIGHT.replace("</robot>", ""), 8, "not well-formed XML: no element found"),
        (RIGHT.replace("<axis", "<axi<s", 1), 5, "not well-formed XML"),
        (RIGHT.replace('"r"', '"&name;"'), 1, "undefined entity"),
        ("", 1, "no element found"),
    ],
)  # fmt: skip
def test_a_mistake_is_told_at_its_line(text: str, line: int, told: str) -> None:
    found = mistakes(text)
    assert found[0][0] == line
    assert told in found[0][1]


def test_the_caret_is_under_the_number() -> None:
    with pytest.raises(RobotFileError) as refused:
        read(robot(turn("one", "a", "b", xyz="0.1 nan 0")))
    message = str(refused.value).splitlines()
    assert message[1][message[2].index("^") :].startswith("nan 0")
    assert message[2].count("^") == 3


def test_all_mistakes_are_told_at_once() -> None:
    text = robot(turn("one", "a", "b", xyz="0 nan 0"), turn("one", "b", "x", rpy="1 2"))
    assert [line for line, _ in mistakes(text)] == [5, 6, 6, 6]


def test_very_many_mistakes_are_cut_short() -> None:
    found = mistakes(robot(*(turn(f"j{i}", "a", "b", xyz="x y z") for i in range(50))))
    assert found[-1] == (0, "and 130 more mistakes")
    assert len(found) == 21
    found = mistakes(robot(*(turn(f"j{i}", "a", "b", xyz="x y z") for i in range(500))))
    assert found[-1] == (0, "and at least 480 more mistakes")


def test_a_planar_joint_is_refused_between_base_and_tip_alone() -> None:
    planar = turn("base", "a", "b").replace("revolute", "planar")
    text = robot(planar, turn("one", "b", "c"))
    assert read(text).chain.base == "b"
    with pytest.raises(RobotFileError, match="a planar joint is between base and tip"):
        convert(read_urdf(text.encode(), "arm.urdf"), Wishes(base="a", tip="c"))


@pytest.mark.parametrize("kind", ["planar", "floating"])
def test_a_joint_that_no_arm_has_is_no_base_behind_a_drive(kind: str) -> None:
    links = LINKS + '<link name="d"/>\n<link name="e"/>\n'
    loose = turn("loose", "b", "c").replace("revolute", kind)
    joints = turn("one", "a", "b"), loose, turn("two", "c", "d")
    ((_, told),) = mistakes(robot(*joints, links=links))  # of one joint each
    assert "--base a --tip b\n" in told
    assert "--base c --tip d" in told
    told = f"a {kind} joint is between base and tip, loose: start behind it, --base c"
    assert mistakes(robot(*joints, turn("three", "d", "e"), links=links)) == [(8, told)]


BOMB = (
    '<?xml version="1.0"?>\n<!DOCTYPE r [\n<!ENTITY a "aaaaaaaaaa">\n'
    + "".join(
        f'<!ENTITY {new} "{f"&{old};" * 10}">\n'
        for old, new in zip("abcdefghi", "bcdefghij", strict=True)
    )
    + "]>\n"
    + RIGHT.replace('"r"', '"&j;"')
)
MANY = 10_000
HOSTILE: dict[str, tuple[str | bytes, int | None]] = {
    "entities of entities": (BOMB, 2),
    "an entity of a file": (f'<!DOCTYPE r [<!ENTITY x SYSTEM "/etc/passwd">]>\n{RIGHT}', 1),
    "an entity from elsewhere": (f'<!DOCTYPE r SYSTEM "http://localhost/r.dtd">\n{RIGHT}', 1),
    "a parameter entity": (f'\n<!DOCTYPE r [<!ENTITY % x "y"> %x;]>\n{RIGHT}', 2),
    "ten megabytes": (RIGHT + "<!-- x -->\n" * 1_000_000, None),
    "ten megabytes of one line": (RIGHT + " " * 10_000_000, None),
    "deep": ("<robot>\n" + "<link>\n" * MANY, 65),
    "many elements": ("<robot>\n" + "<a/>\n" * 200_000, 20_001),
    "many mistakes": (robot(*(turn(f"j{i}", "a", "zzz") for i in range(MANY // 4))), 5),
    "many links": (
        robot(
            *(turn(f"j{i}", f"l{i}", f"l{i + 1}") for i in range(MANY // 4)),
            links="".join(f'<link name="l{i}"/>\n' for i in range(MANY // 4 + 1)),
        ),
        0,
    ),
    "a long circle": (
        robot(
            *(turn(f"j{i}", f"l{i}", f"l{(i + 1) % 2_500}") for i in range(2_500)),
            links="".join(f'<link name="l{i}"/>\n' for i in range(2_500)),
        ),
        None,
    ),
    "zeros": (b"<robot>\0</robot>", 1),
    "no text": (b"\x7fELF\x02\x01", 1),
    "an encoding that is none": ('<?xml version="1.0" encoding="x-none"?>\n' + RIGHT, 1),
    "half of UTF-16": (RIGHT.encode("utf-16")[:-3], None),
    "a long number": (robot(turn("one", "a", "b", xyz=f"0 0 {'9' * 100_000}")), 5),
    "a long name": (robot(turn("n" * 100_000, "a", "zzz")), 5),
}


@pytest.mark.parametrize("what", HOSTILE)
def test_harm_is_refused_at_once_at_its_line(what: str) -> None:
    text, line = HOSTILE[what]
    start = time.process_time()  # the machine may do other things besides
    found = mistakes(text)
    assert time.process_time() - start < 2.0
    assert line is None or found[0][0] == line
    assert all(len(message) < 600 for _, message in found)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "latin-1"])
def test_files_of_other_encodings_are_read(encoding: str) -> None:
    named = "latin-1" if encoding == "latin-1" else "utf-16" if encoding == "utf-16" else "utf-8"
    text = f'<?xml version="1.0" encoding="{named}"?>\n' + RIGHT.replace('"r"', '"Rücken"')
    assert read(text.encode(encoding)).robot.title == "Rücken"
    if encoding != "utf-16":
        assert read(text.partition("\n")[2].encode(encoding)).robot.title == "Rücken"


@pytest.mark.parametrize(
    "dirty",
    [
        RIGHT.replace("<axis", "<drake:damping/><axis", 1),  # a prefix that is not declared
        RIGHT.replace("<robot ", '<robot xacro:version="2" '),
        RIGHT.replace("<robot ", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" '),
        "\n\n<?xml version='1.0'?>\n" + RIGHT,
        RIGHT.replace("</robot>", '<transmission><joint name="one"/></transmission></robot>'),
        RIGHT.replace("</robot>", "<gazebo><link/><joint/></gazebo></robot>"),
        RIGHT.replace('"0 0 0.5"', '" 0  0\t.5 "'),
        RIGHT.replace(' rpy="0 0 0"', ""),
    ],
)
def test_what_real_files_hold_besides_is_no_mistake(dirty: str) -> None:
    assert dirty != RIGHT
    assert read(dirty).text == read(RIGHT).text
