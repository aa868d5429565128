"""Values that don't need each other share a line, in the order of the program."""

from __future__ import annotations

import dis

from dhgen.targets.layout import WIDTH
from dhgen.targets.python.assignments import alike, side_by_side


def test_what_needs_a_value_stands_below_it() -> None:
    lines = side_by_side([("v1", "a + b"), ("v2", "a - b"), ("v3", "v1 * v2")], "    ")
    assert lines == ["    v1, v2 = a + b, a - b", "    v3 = v1 * v2"]


def test_a_name_within_a_longer_one_is_another() -> None:
    assert side_by_side([("v1", "a"), ("v2", "v11")], "") == ["v1, v2 = a, v11"]


def test_no_tuple_is_made_of_more_than_three() -> None:
    """CPython assigns up to three values without one: numba compiles what it did line by line."""
    lines = side_by_side([(f"v{number}", "a") for number in range(4)], "")
    assert lines == ["v0, v1, v2 = a, a, a", "v3 = a"]
    taken = {each.opname for each in dis.get_instructions(compile(lines[0], "", "exec"))}
    assert "STORE_NAME" in taken
    assert taken.isdisjoint({"BUILD_TUPLE", "UNPACK_SEQUENCE"})


def test_choices_stand_alone() -> None:
    lines = side_by_side([("v1", "a"), ("v2", "a if b else c"), ("v3", "a")], "")
    assert lines == ["v1 = a", "v2 = a if b else c", "v3 = a"]


def test_lines_fit_on_the_page() -> None:
    long = " + ".join(["a"] * 20)
    lines = side_by_side([("v1", long), ("v2", long), ("v3", " + ".join(["a"] * 30))], "")
    assert lines[:2] == [f"v1 = {long}", f"v2 = {long}"]
    assert lines[2] == "v3 = ("
    assert all(len(line) <= WIDTH for line in lines)


def test_targets_of_one_value_are_chained() -> None:
    assert alike([("x", "1"), ("y", "1"), ("z", "2")], "") == [("x = y", "1"), ("z", "2")]
