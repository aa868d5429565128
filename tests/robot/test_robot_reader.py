"""YAML with positions, and what a robot file has no use for."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from dhgen.errors import RobotFileError
from dhgen.robot.load import load, load_text
from dhgen.robot.reader import MAX_BYTES
from tests.robot.robot_texts import JOINTS, MINIMAL, marked, mistake, mistakes, table

if TYPE_CHECKING:
    from pathlib import Path

NO_PLACE = "are not allowed in a robot file"
WRITE_OUT = "write the values out wherever they belong"
SPREADSHEET = (
    "this looks like a spreadsheet table, but a robot file is YAML: a line 'name: my_arm', a "
    "line 'joints:', and below it a line like '  - {theta: q, d: 0.1, a: 0.4, alpha: pi/2}' for "
    "every joint; the README has all keys"
)
LIST = (
    "a robot file holds keys with values, e.g. 'name: puma560', not a list; JSON lists of "
    "tables are for 'dhgen survey'"
)
SECOND_COLON = "not valid YAML: mapping values are not allowed here"
BRACES = "; put several keys on one line in braces, e.g. {theta: q, d: 0}"


def test_positions_of_keys_and_values() -> None:
    first, second = mistakes("name: r\njoints:\n  - {theta: q,\n     aplha: 0, a: x}\n")
    assert (first.line, first.column, marked(first)) == (4, 6, "aplha")
    assert (second.line, second.column, marked(second)) == (4, 19, "x")


@pytest.mark.parametrize("cell", ["1 + x", "'1 + x'", '"1 + x"', "   1 + x"])
def test_the_caret_stands_under_the_part_of_a_cell(cell: str) -> None:
    (found,) = mistakes(table(f"theta: q, a: {cell}"))
    assert marked(found) == "x"


def test_a_folded_cell_is_marked_where_it_starts() -> None:
    (found,) = mistakes("name: r\njoints:\n- theta: q\n  a: 1 +\n    x\n")
    assert (found.line, found.column) == (4, 6)


def test_line_ends_of_all_systems() -> None:
    text = table("theta: q, a: x")
    (unix,), (dos,) = mistakes(text), mistakes(text.replace("\n", "\r\n"))
    assert unix == dos


def test_a_byte_order_mark_is_passed_over(tmp_path: Path) -> None:
    path = tmp_path / "r.yaml"
    path.write_text(MINIMAL, encoding="utf-8-sig")
    assert load(path).name == "r"


def test_a_tab_does_not_move_the_caret() -> None:
    (found,) = mistakes("name: r\njoints:\n  - {theta: q,\ta: x}\n")
    assert "\t" not in found.source
    assert marked(found) == "x"


def test_duplicate_keys_are_all_reported() -> None:
    found = mistakes("name: r\nname: s\njoints:\n  - {theta: q, theta: q}\n")
    assert [(d.line, d.column) for d in found] == [(2, 1), (4, 16)]
    assert found[0].message == "duplicate key 'name': line 1 has it too"


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (f"name: &r r\n{JOINTS}", f"anchors ('&r') {NO_PLACE}: {WRITE_OUT}"),
        (f"name: *r\n{JOINTS}", f"aliases ('*r') {NO_PLACE}: {WRITE_OUT}"),
        (f"name: !!str r\n{JOINTS}", f"tags (!) {NO_PLACE}: leave them out"),
        (f"name: ! r\n{JOINTS}", f"tags (!) {NO_PLACE}: leave them out"),
        (f"{MINIMAL}base: {{<<: {{}}}}\n", f"merge keys (<<) {NO_PLACE}: {WRITE_OUT}"),
        (f"%YAML 1.1\n---\n{MINIMAL}", f"YAML directives (%) {NO_PLACE}: leave them out"),
        (
            f"{MINIMAL}---\n{MINIMAL}",
            "a robot file holds one document; give each robot its own file",
        ),
        (f"? [a]\n: 1\n{MINIMAL}", "a key is a name, not a collection"),
        ("- 1\n", LIST),
        ('[{"name": "r", "joints": [{"theta": "q"}]}]', LIST),
        ("robot", "expected keys with values, e.g. 'name: puma560'"),
        ("one line, no table", "expected keys with values, e.g. 'name: puma560'"),
        ("a text, folded\n\ninto two", "expected keys with values, e.g. 'name: puma560'"),
        ("theta;d;a;alpha\nq;0,1;0;90\nq;0;0,4;0\n", SPREADSHEET),
        ("theta,d,a,alpha\r\nq,0.1,0,90\r\n\r\n", SPREADSHEET),
        ("theta\td\ta\talpha\nq\t0.1\t0\t90\n", SPREADSHEET),
        ("theta [deg];d [mm]\n-90;\n", SPREADSHEET),
        ("", "the file is empty"),
        ("# nothing\n", "the file is empty"),
        ("---\n", "the file is empty"),
        ('name: "\\UFFFFFFFF"', "not valid YAML: an escape stands for no character"),
        ("name: r\n  joints: []\n", SECOND_COLON),
        ("name: r\njoints:\n  - theta: q, d: 0\n", SECOND_COLON + BRACES),
        ("name: r\nparameters: l: 0.1, m: 0.2\n", SECOND_COLON + BRACES),
        ("title: r: an arm\n", f"{SECOND_COLON}; put a text with a colon in quotes"),
    ],
)
def test_refused_yaml(text: str, message: str) -> None:
    assert mistake(text) == message


def test_a_long_list_is_a_list_first() -> None:
    assert mistake("[" + "{theta: q}, " * 2000 + "]") == LIST


def test_a_syntax_error_has_its_place() -> None:
    (found,) = mistakes("name: r\njoints: [\n")
    assert (found.line, found.column) == (2, 10)
    assert found.message.startswith("not valid YAML: ")


def test_a_quoted_merge_key_is_a_plain_unknown_key() -> None:
    assert mistake(f"{MINIMAL}'<<': 1\n").startswith("unknown key '<<'")


@pytest.mark.parametrize("name", ["no.yaml", "./no.yaml", "../x/no.yaml"])
def test_a_missing_file_is_shown_as_given(name: str) -> None:
    with pytest.raises(RobotFileError, match="the file can't be read: No such file") as info:
        load(name)
    assert str(info.value).startswith(f"{name}: ")


def test_a_folder_is_no_file(tmp_path: Path) -> None:
    with pytest.raises(RobotFileError, match=r"this is a folder; name the files in it: .*\*\.yaml"):
        load(tmp_path)


def test_a_file_name_with_nul() -> None:
    with pytest.raises(RobotFileError, match="the file can't be read"):
        load("a\0b")


def test_a_file_that_is_not_utf8_says_where(tmp_path: Path) -> None:
    path = tmp_path / "r.yaml"
    path.write_bytes("name: r\ntitle: Žižka ".encode() + b"\xff\n" + JOINTS.encode())
    with pytest.raises(RobotFileError) as info:
        load(path)
    (found,) = info.value.diagnostics
    assert (found.line, found.column) == (2, 14)
    assert found.message == "the file is not UTF-8: save it as UTF-8"


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"\x7fELF\x02\x01\x01\0\0\xff\n", "this is not text; a robot file is YAML"),
        (b"\x89PNG\r\n\x1a\n", "this is not text; a robot file is YAML"),
        (MINIMAL.encode("utf-16"), "the file is UTF-16: save it as UTF-8"),
        (b'<robot name="r">\n</robot>\n', "this is a URDF; a robot file is YAML"),
        (b'\xef\xbb\xbf<?xml version="1.0"?>\n<robot/>', "this is a URDF; a robot file is YAML"),
        (b"<!-- an arm -->\n<mujoco/>\n", "this is an MJCF; a robot file is YAML"),
        (b"<!-- an arm -->\n<arm/>\n", "this is XML; a robot file is YAML"),
        (b'<robot><xacro:include filename="a"/></robot>', "this is a xacro; a robot file is YAML"),
        ('<robot name="r"/>'.encode("utf-16"), "this is a URDF; a robot file is YAML"),
        (b"<robot>" + b" " * MAX_BYTES, "this is a URDF; a robot file is YAML"),
    ],
)
def test_what_is_no_text_is_not_shown(content: bytes, message: str, tmp_path: Path) -> None:
    path = tmp_path / "r.yaml"
    path.write_bytes(content)
    with pytest.raises(RobotFileError) as info:
        load(path)
    assert str(info.value) == f"{path}: {message}"


def test_paths_and_texts_load_the_same(tmp_path: Path) -> None:
    path = tmp_path / "r.yaml"
    path.write_text(MINIMAL, encoding="utf-8")
    assert load(path) == load(str(path)) == load_text(MINIMAL, str(path))


@pytest.mark.parametrize("text", ["name: r\njoints:\n\t- {theta: q}\n", "name: r\n \ttask: x\n"])
def test_tabs_at_the_beginning_of_a_line_are_named(text: str) -> None:
    assert mistake(text).endswith("; YAML indents with spaces, not tabs")


def test_other_mistakes_of_yaml_are_not_blamed_on_tabs() -> None:
    assert "spaces" not in mistake("name: r\njoints: [\n\n")


def test_what_is_no_text_does_not_fill_the_screen(tmp_path: Path) -> None:
    path = tmp_path / "r.yaml"
    path.write_bytes(b"4^" + b"\xff\xc3\xa9" * 1000)
    with pytest.raises(RobotFileError, match="the file is not UTF-8: save it as UTF-8") as info:
        load(path)
    assert max(len(line) for line in str(info.value).splitlines()[1:]) <= 124


BLANK = "a space must follow the colon: "


@pytest.mark.parametrize(
    ("text", "at", "told"),
    [
        (table("theta: q, limits:[-1, 1]"), "3:16 limits:", "'limits: [-1, 1]'"),
        ("name: r\njoints:\n- theta: q\n  limits:[-1, 1]\n", "4:3 limits:", "'limits: [-1, 1]'"),
        ("name: r\njoints:\n  - theta:q\n    d: 0\n", "3:5 theta:", "'theta: q'"),
        ("name: r\njoints:\n  - theta:q # a turn\n    d: 0\n", "3:5 theta:", "'theta: q'"),
        ("name: r\njoints:\n  - theta:q\n", "3:5 theta:q", "'theta: q'"),
        (f"name: r\ntitle:my arm, and yours\n{JOINTS}", "2:1 title:", "'title: my arm, and yours'"),
        (f"name:r\n{JOINTS}", "1:1 name:", "'name: r'"),
        (f"{MINIMAL}task:pose\n", "4:1 task:", "'task: pose'"),
        ("name:r", "1:1 name:r", "'name: r'"),
        (f"{MINIMAL}parameters:\n  l: 1\n  m:2\n", "6:3 m:", "'m: 2'"),
        (f"{MINIMAL}tool:{{xyz: [0, 0, 1]}}\n", "4:1 tool:", "'tool: {xyz: [0, 0, 1]}'"),
        (table("theta: q, a: l", parameters="{l:1}"), "2:14 l:1", "'l: 1'"),
    ],
)
def test_a_blank_that_is_missing_after_a_colon_is_told(text: str, at: str, told: str) -> None:
    (found,) = mistakes(text)
    assert f"{found.line}:{found.column} {marked(found)}" == at
    assert found.message.startswith(f"{BLANK}{told}, not '")


def test_all_blanks_that_are_missing_are_told_at_once() -> None:
    text = "name:r\ntitle:'an arm: mine'\n# task:none\njoints:\n  - {theta:q, limits:[0, 1]}\n"
    told = [(found.line, found.message.removeprefix(BLANK)) for found in mistakes(text)]
    assert told == [
        (1, "'name: r', not 'name:r'"),
        (2, "\"title: 'an arm: mine'\", not \"title:'an arm: mine'\""),
        (5, "'theta: q', not 'theta:q'"),
        (5, "'limits: [0, 1]', not 'limits:[0, 1]'"),
    ]


def test_a_key_without_its_blank_is_read_all_the_same() -> None:
    first, second = mistakes(table("theta:q, a:x"))[:2], mistakes(table("theta:q, b:1"))[2:]
    assert [found.message for found in first] == [
        f"{BLANK}'theta: q', not 'theta:q'",
        f"{BLANK}'a: x', not 'a:x'",
    ]
    assert [(marked(found), found.message[:15]) for found in second] == [("b", "unknown key 'b'")]


def test_other_mistakes_of_yaml_are_not_blamed_on_blanks() -> None:
    for text in (
        "name: r\nsource: see\n  http://x.y\njoints: [\n",
        "name: r\nsource: 'see a,b:c'\njoints: [\n",
        f"name: r # as in x.yaml, line:1\ntitle: [\n{JOINTS}",
    ):
        assert mistake(text).startswith("not valid YAML: ")
    told = mistake("name: r\njoints:\n  - theta:q, d: 0\n")
    assert told.endswith("; put several keys on one line in braces, with a space after every colon")
