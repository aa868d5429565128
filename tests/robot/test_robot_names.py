"""Names that a file may give, and those that would break what is made of them."""

from __future__ import annotations

import ast
import sys
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from dhgen.robot.names import why_no_parameter_name, why_no_robot_name
from tests.robot.robot_texts import JOINTS, MINIMAL, mistake, robot

RUNTIME = Path(__file__).resolve().parents[2] / "dhgen" / "runtime"


@pytest.mark.parametrize("name", ["puma560", "KR6_R900", "a", "x" * 48, "turtlebot", "c1"])
def test_names_of_robots(name: str) -> None:
    assert why_no_robot_name(name) is None
    assert robot(f"name: {name}\n{JOINTS}").name == name


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("", "a name is made of"),
        ("6r", "a name is made of"),
        ("../puma", "a name is made of"),
        ("a/b", "a name is made of"),
        ("a.b", "a name is made of"),
        ("a b", "a name is made of"),
        ('a"', "a name is made of"),
        ("a'", "a name is made of"),
        ("a\n", "a name is made of"),
        ("a\0", "a name is made of"),
        ("a\x1b[31m", "a name is made of"),
        ("рuma", "a name is made of"),  # the first letter is Cyrillic
        ("puma５", "a name is made of"),
        ("x" * 49, "it has 49 characters; at most 48 are allowed"),
        ("_a", "a leading or double underscore is reserved"),
        ("a__b", "a leading or double underscore is reserved"),
        ("class", "it is a keyword of Python"),
        ("None", "it is a keyword of Python"),
        ("lambda", "it is a keyword of Python"),
        ("register", "it is a keyword of C or C++"),
        ("restrict", "it is a keyword of C or C++"),
        ("typeof", "it is a keyword of C or C++"),
        ("namespace", "it is a keyword of C or C++"),
        ("sin", "it is a name of the C library"),
        ("atan2f", "it is a name of the C library"),
        ("malloc", "it is a name of the C library"),
        ("NULL", "it is a name of the C library"),
        ("NAN", "it is a name of the C library"),
        ("j0", "it is a name of the C library"),
        ("main", "it is a name of the C library"),
        ("math", "it is the name of a library or a device"),
        ("numba", "it is the name of a library or a device"),
        ("llvmlite", "it is the name of a library or a device"),
        ("json", "it is the name of a library or a device"),
        ("cProfile", "it is the name of a library or a device"),
        ("CON", "it is the name of a library or a device"),
        ("dhgen", "dhgen's own files, functions and macros have such names"),
        ("Dhgen", "dhgen's own files"),  # DHGEN_OK
        ("dhgen_runtime", "dhgen's own files"),  # the folder hides a module of that name
        ("dhgen_joint", "dhgen's own files"),  # dhgen_joint_velocities
    ],
)
def test_names_that_no_robot_can_have(name: str, reason: str) -> None:
    assert (why_no_robot_name(name) or "").startswith(reason)


def imported(path: Path) -> set[str]:
    """What a module imports, by statements and by their names as texts."""
    names = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        match node:
            case ast.Import():
                names |= {alias.name for alias in node.names}
            case ast.ImportFrom(level=0, module=str(module)):
                names.add(module)
            case ast.Call(func=ast.Attribute(attr="import_module"), args=[ast.Constant(str(name))]):
                names.add(name)
    return {name.partition(".")[0] for name in names}


def test_no_robot_hides_what_lies_beside_it_imports() -> None:
    paths = [path for folder in ("helpers", "python") for path in (RUNTIME / folder).rglob("*.py")]
    every = set().union(*map(imported, paths)) - {"__future__"}
    assert {"jax", "math", "numba", "torch"} < every
    assert {name for name in every if why_no_robot_name(name) is None} == set()


@pytest.mark.parametrize(
    "name",
    [
        *("scipy", "cffi", "setuptools", "cuda", "yaml", "coverage", "IPython"),  # numba and numpy
        *("torch", "jax", "jaxlib", "cupy", "warp", "nvidia"),  # helpers, and these in their turn
        *("sitecustomize", "usercustomize"),  # Python when it starts
        *("immintrin", "features", "endian"),  # headers: -Igenerated goes before the system's
    ],
)
def test_no_robot_hides_a_library(name: str) -> None:
    """`import scipy` beside a robot of that name would find the robot, also that of numba."""
    told = "it is the name of a library or a device, so generated files can't have it"
    assert why_no_robot_name(name) == told


def test_no_robot_hides_a_module_of_this_python() -> None:
    public = {name for name in sys.stdlib_module_names if not name.startswith("_")}
    assert {name for name in public if why_no_robot_name(name) is None} == set()


@pytest.mark.parametrize("escaped", ["../r", "a\\nb", "a\\0b", 'a\\"b', "a\\u202eb", "\\ud800"])
def test_a_hostile_name_is_shown_harmlessly(escaped: str) -> None:
    message = mistake(f'name: "{escaped}"\n{JOINTS}')
    assert message.isprintable()
    assert "the robot can't have this name: a name is made of a-z, A-Z, 0-9 and _" in message


@pytest.mark.parametrize("name", ["a2", "d4", "L1", "l_1", "theta_off", "s", "t1", "TU"])
def test_names_of_parameters(name: str) -> None:
    assert why_no_parameter_name(name) is None


@pytest.mark.parametrize(
    "name",
    [
        *("q", "pi", "deg", "sqrt", "sin", "cos"),
        *("c1", "s23", "q4", "theta", "theta2", "t06", "T", "U", "R"),
        *("for", "double", "atan2", "y1", "len", "np", "_a", "a__b", "1a", "ä", "a-b", ""),
        "x" * 33,
    ],
)
def test_names_that_no_parameter_can_have(name: str) -> None:
    assert why_no_parameter_name(name) is not None


@given(st.text(max_size=10))
def test_accepted_names_are_plain_identifiers(name: str) -> None:
    if why_no_robot_name(name) is None:
        assert name.isascii()
        assert name.isidentifier()


def test_texts_are_one_line() -> None:
    loaded = robot(f"{MINIMAL}title: Žižka’s arm № 5 */\nsource: >\n  a book,\n  page 3\n")
    assert loaded.title == "Žižka’s arm № 5 */"
    assert loaded.source == "a book, page 3"


def test_a_literal_block_becomes_one_line() -> None:
    assert robot(f"{MINIMAL}source: |\n  a book,\n    page 3\n").source == "a book, page 3"


def test_the_title_is_the_name_when_left_out() -> None:
    assert robot(MINIMAL).title == "r"


@pytest.mark.parametrize("key", ["title", "source"])
@pytest.mark.parametrize("escape", ["\\x07", "\\e", "\\0", "\\r", "\\u202e", "\\u2066", "\\u2028"])
def test_control_characters_are_refused(key: str, escape: str) -> None:
    assert "this text can't be used: it contains" in mistake(f'{MINIMAL}{key}: "a{escape}b"\n')


@pytest.mark.parametrize("character", ["\0", "\x07", "\x1b", "\x7f", "\x85", "\u2028", "\u202e"])
def test_control_characters_can_stand_nowhere_in_a_file(character: str) -> None:
    expected = f"the character U+{ord(character):04X} is not allowed in a robot file"
    assert mistake(f"{MINIMAL}# {character}\n") == expected


def test_a_text_has_an_end() -> None:
    assert "it has 2001 characters; at most 2000" in mistake(f"{MINIMAL}title: {'x' * 2001}\n")


def test_a_parameter_that_is_a_keyword_is_refused_once() -> None:
    """Where it is defined, not in every cell that holds it."""
    text = "name: r\nparameters: {lambda: 0.3}\njoints:\n  - {theta: q, a: 2*lambda}\n"
    assert mistake(text) == "'lambda' can't be a parameter: it is a keyword of Python"
