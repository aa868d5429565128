"""Dicts in the place of robot files: the same robots, and mistakes at their keys."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from dhgen.errors import RobotFileError
from dhgen.robot.load import load_text
from dhgen.robot.mapping import keyed_text, load_mapping

ROW: dict[Any, Any] = {"theta": "q", "a": 0.3}


def mistakes(mapping: dict[str, Any]) -> list[str]:
    with pytest.raises(RobotFileError) as refused:
        load_mapping(mapping)
    return str(refused.value).splitlines()


def arm(*rows: object, **keys: object) -> dict[str, Any]:
    return {"name": "arm", "joints": list(rows), **keys}


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.25, "0.25"),
        (np.float64(0.25), "0.25"),
        (np.int64(2), "2"),
        (1e-05, "1e-05"),
        ("a1 + 2*pi", "a1 + 2*pi"),
        (np.str_("a1"), "a1"),
        ("-pi/2", "-pi/2"),
        (math.pi / 2, "1.5707963267948966"),
        ("", '""'),
        ("yes", '"yes"'),
        ("null", '"null"'),
        ("a: b", '"a: b"'),
        ("#", '"#"'),
        ("größer", '"größer"'),
        (None, "null"),
        (True, "true"),
        ((1, 2), "[1, 2]"),
        (np.eye(2), "[[1.0, 0.0], [0.0, 1.0]]"),
        ({"x": [1.5, "q"]}, "{x: [1.5, q]}"),
    ],
)
def test_values_are_written_as_yaml_reads_them(value: object, text: str) -> None:
    assert keyed_text({"key": value}).text == f"key: {text}\n"


def test_the_text_is_the_robot_file_with_a_line_a_joint() -> None:
    mapping = arm(ROW, {**ROW, "limits": (-1, np.float64(1.5))}, tool=np.eye(4), task=["x", "y"])
    text, robot = load_mapping(mapping)
    assert text.splitlines()[:4] == [
        "name: arm",
        "joints:",
        "  - {theta: q, a: 0.3}",
        "  - {theta: q, a: 0.3, limits: [-1, 1.5]}",
    ]
    assert load_text(text, "arm.yaml") == robot


@pytest.mark.parametrize(
    ("mapping", "told"),
    [
        ({}, ["dict: the key 'name' is missing", "dict: no joints: write them"]),
        ({"name": "arm"}, ["dict: no joints: write them"]),
        (
            {"nmae": "arm", "joints": [ROW]},
            ["dict: the key", "nmae: unknown key 'nmae'; did"],
        ),
        (arm({**ROW, "d": "x"}), ["joints[0].d: unknown name 'x'"]),
        (arm(ROW, {**ROW, "dd": 1}), ["joints[1].dd: unknown key 'dd'; did you mean 'd'?"]),
        (arm(ROW, {**ROW, "limits": [1, 2, 3]}), ["joints[1].limits: expected 2 values, not 3"]),
        (arm(ROW, {**ROW, "limits": [1, "y"]}), ["joints[1].limits[1]: unknown name 'y'"]),
        (arm({**ROW, "a": float("nan")}), ["joints[0].a: 'nan' is not a finite number"]),
        (arm({**ROW, "a": -math.inf}), ["joints[0].a: 'inf' is not a finite number"]),
        (arm({**ROW, "a": True}), ["joints[0].a: 'true' is not a number"]),
        (arm({**ROW, "a": "0.1 +"}), ["joints[0].a: not valid arithmetic"]),
        (arm(ROW, tool={"xyz": [0, 0]}), ["tool.xyz: expected 3 values, not 2"]),
        (arm(ROW, base=[[1, 2]]), ["base[0]: expected 4 values, not 2"]),
        (arm(ROW, free=[9]), ["free[0]: there is no joint 9"]),
        (arm(ROW, numerical="maybe"), ["numerical: expected true or false, not 'maybe'"]),
        (arm(ROW, title="\x07"), ["title: "]),
        (
            arm({**ROW, "a": Fraction(1, 3)}),
            ["joints[0].a: expected a number, a text, a list or a"],
        ),
        (arm({**ROW, 3: 4}), ["joints[0]: a key is a text, not int '3'"]),
        (arm(ROW, **{"x" * 2000: 1}), ["xxxx"]),
        ({"name": "arm", "joints": 3}, ["joints: expected a list of joints"]),
        (arm([1, 2]), ["joints[0]: expected a joint"]),
    ],
)
def test_mistakes_are_at_their_keys(mapping: dict[str, Any], told: list[str]) -> None:
    found = mistakes(mapping)
    assert [line[: len(start)] for line, start in zip(found, told, strict=True)] == told


def test_all_mistakes_are_told_at_once() -> None:
    rows = ({**ROW, "d": "x"}, {**ROW, "alpha": "y"})
    assert len(mistakes(arm(*rows, task="posee"))) == 3


def test_a_list_within_itself_ends() -> None:
    endless: list[object] = []
    endless.append(endless)
    assert mistakes({"name": "arm", "joints": endless}) == ["joints: nested more than 12 deep"]


def test_notes_are_at_their_keys() -> None:
    _, robot = load_mapping(arm(ROW, parameters={"a1": 1}))
    assert [str(note).partition(": no cell")[0] for note in robot.notices] == ["parameters.a1"]
