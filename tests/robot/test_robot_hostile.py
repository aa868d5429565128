"""Files made to do harm are refused quickly, in little memory, and run nothing."""

from __future__ import annotations

import gc
import time
import tracemalloc
from contextlib import contextmanager
from typing import TYPE_CHECKING

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dhgen.errors import RobotFileError
from dhgen.robot.load import load, load_text
from tests.robot.robot_texts import JOINTS, MINIMAL, mistake, table
from tests.structures import first_of

if TYPE_CHECKING:
    from collections.abc import Iterator
    from pathlib import Path

    from dhgen.errors import Diagnostic

BOMB = "a: &a [x, x]\n" + "".join(
    f"{new}: &{new} [*{old}, *{old}]\n" for old, new in zip("abcdefghij", "bcdefghijk", strict=True)
)
SUM = "1" + "+1" * 60
HOSTILE = {
    "aliases of aliases": BOMB,
    "an object of Python": 'name: !!python/object/apply:os.system ["touch pwned"]\n',
    "a module of Python": f"name: !!python/module:os r\n{JOINTS}",
    "100 000 joints": "name: r\njoints:\n" + "  - {theta: q}\n" * 8_000,
    "many joints": "name: r\njoints:\n" + "- 1\n" * 30_000,
    "many joints in brackets": "name: r\njoints: [" + "1," * 60_000 + "]\n",
    "megabytes of a comment": f"{MINIMAL}# {'x' * 3_000_000}\n",
    "a long comment": f"{'#' * 130_000}\n",
    "many comments": "# x\n" * 32_000,
    "empty lines only": "\n" * 130_000,
    "brackets": f"name: r\njoints: {'[' * 10_000}",
    "closed brackets": f"name: r\njoints: {'[' * 10_000}{']' * 10_000}",
    "braces": "{a: " * 20_000,
    "nested by columns": "".join(f"{' ' * i}a:\n" for i in range(600)),
    "nested dashes": "- " * 60_000,
    "nested questions": "? " * 60_000,
    "documents": "---\n" * 30_000,
    "directives": "%a b\n" * 25_000,
    "anchors": "&a" * 60_000,
    "exclamation marks": "!" * 120_000,
    "a long key": f"{MINIMAL}? {'k' * 120_000}\n: 1\n",
    "many keys": MINIMAL + "".join(f"k{i}: 1\n" for i in range(2_000)),
    "one key many times": f"{'name: r' + chr(10):s}" * 2_000 + JOINTS,
    "many parameters": MINIMAL + "parameters:\n" + "".join(f"  p{i}: 1\n" for i in range(2_000)),
    "keys without blanks": "a:1\n" * 30_000 + "b: 1\n",
    "keys without blanks in a line": f"{'a:[1,' * 20_000}",
    "brackets behind a key": f"name: r\na:{'[' * 60_000}{']' * 60_000}\n",
    "limits without brackets": table(f"theta: q, limits: {'1, ' * 2_000}"),
    "limits in quotes": table(f"theta: q, limits: '{'1, ' * 30_000}'"),
    "a tower of powers": table("theta: q, a: 9**9**9**9"),
    "powers of powers": table("theta: q, a: ((((1.1**8)**8)**8)**8)**8"),
    "a power of ten": table("theta: q, a: 1e999999999"),
    "a long number": table(f"theta: q, a: {'9' * 120_000}"),
    "a long sum": table(f"theta: q, a: {'1+' * 60_000}1"),
    "parentheses": table(f"theta: q, a: {'(' * 100_000}"),
    "signs": table(f"theta: q, a: {'-' * 100_000}1"),
    "large cells": table(*[f"theta: q+{SUM}, d: {SUM}/0, a: {SUM}/0, alpha: {SUM}/0"] * 64),
    "a joint's number": f"{MINIMAL}free: [{'9' * 100_000}]\n",
    "an attribute": table("theta: q, a: pi.__class__"),
    "a call": table('theta: q, a: \'__import__("os").system("touch pwned")\''),
    "a merge": f"{MINIMAL}base: {{<<: {{xyz: [0, 0, 0]}}}}\n",
    "a long name": f"name: {'r' * 120_000}\n{JOINTS}",
    "NUL": f"name: r\0\n{JOINTS}",
    "a path": f"name: ../../etc/passwd\n{JOINTS}",
}


@contextmanager
def quickly() -> Iterator[None]:
    """Assert that what is done here takes less than two seconds of this thread.

    What the tests before have left is kept out of the collector's way: looking through it takes
    seconds, and whom a full collection falls on is chance.
    """
    gc.freeze()
    start = time.thread_time()
    try:
        yield
        assert time.thread_time() - start < 2
    finally:
        gc.unfreeze()


@pytest.mark.parametrize("case", first_of(HOSTILE, count=30))
def test_hostile_files_are_refused_quickly(
    case: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    with quickly(), pytest.raises(RobotFileError) as info:
        load_text(HOSTILE[case], "r.yaml")
    assert all(diagnostic.message.isprintable() for diagnostic in info.value.diagnostics)
    assert max(len(diagnostic.message) for diagnostic in info.value.diagnostics) < 500
    assert max(len(diagnostic.source) for diagnostic in info.value.diagnostics) <= 200
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "case", first_of(["aliases of aliases", "brackets", "many joints", "many keys"], count=2)
)
def test_hostile_files_take_little_memory(case: str) -> None:
    tracemalloc.start()
    try:
        with pytest.raises(RobotFileError):
            load_text(HOSTILE[case], "r.yaml")
        assert tracemalloc.get_traced_memory()[1] < 30e6
    finally:
        tracemalloc.stop()


def test_a_large_file_is_not_read_to_its_end(tmp_path: Path) -> None:
    path = tmp_path / "r.yaml"
    path.write_bytes(b"#" * 10_000_000)
    with pytest.raises(RobotFileError, match="a robot file has at most 128 KiB"):
        load(path)


def test_too_many_mistakes_of_spelling_take_no_time() -> None:
    names = ", ".join(f"parameter_{i:02d}: 1" for i in range(99))
    rows = [f"theta: q + parametre_{i}, d: paramter_{i}, a: pramater_{i}" for i in range(64)]
    with quickly(), pytest.raises(RobotFileError):
        load_text(table(*rows, parameters=f"{{{names}}}"), "r.yaml")


def test_a_name_from_another_alphabet() -> None:
    assert mistake(f"name: рuma\n{JOINTS}").startswith("'рuma': the robot can't have this name")


FULL = """\
name: r
title: A "quoted" title
parameters: {a2: 0.4318, w: 2*pi/7}
joints:
  - {theta: q - pi/2, d: 0.1, a: a2, alpha: -90 deg, limits: [-1, 1]}
  - {theta: 0, d: q}
base: {xyz: [0, 0, 1], rpy: [0, w, 0]}
tool: [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
task: [x, y]
free: [2]
units: {length: mm, angle: deg}
"""
MARKS = [
    "\n",
    "  ",
    "-",
    ":",
    "{",
    "}",
    "[",
    "]",
    "'",
    '"',
    "&a",
    "*a",
    "!",
    "|",
    ">",
    "#",
    "q",
    "~",
    "null",
    "?",
    "\t",
    "%",
    ",",
    "\\",
    "1e5",
    "**",
    "/0",
    "<<",
    "...",
]
PIECES = st.text(max_size=3) | st.sampled_from([*MARKS, " ", "---\n", "\ufeff", "\x85", "\ud800"])


def remarks(text: str) -> tuple[Diagnostic, ...]:
    """What is said about a file, whether it loads or not."""
    try:
        return load_text(text, "r.yaml").notices
    except RobotFileError as error:
        return error.diagnostics


@settings(max_examples=100)
@given(
    st.lists(
        st.tuples(st.integers(0, len(FULL)), st.integers(0, 4), PIECES), min_size=1, max_size=4
    )
)
def test_whatever_a_file_says_it_loads_or_is_refused(edits: list[tuple[int, int, str]]) -> None:
    text = FULL
    for place, removed, inserted in edits:
        text = text[:place] + inserted + text[place + removed :]
    places = [diagnostic.line for diagnostic in remarks(text)]
    assert places == sorted(places)
    assert max(places, default=0) <= text.count("\n") + text.count("\r") + 1
