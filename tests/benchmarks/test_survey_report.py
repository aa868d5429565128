"""The README's table of all arms is that of the robot files, and a part of it is surveyed again."""

from __future__ import annotations

import re

import pytest

from benchmarks.options import parallel_names, robot_names
from benchmarks.report import README
from benchmarks.survey import MARK, padded, report, written
from dhgen.kinematics.build import build_chain
from dhgen.survey.sources import arm_class, joint_letters
from dhgen.survey.survey import survey
from dhgen.survey.table import HEAD, cells
from tests.robots.cases import ROBOTS, robot

GENERATED = ROBOTS.parent / "generated"
TEXT = README.read_text(encoding="utf-8")
ROWS = {row[0]: dict(zip(HEAD, row, strict=True)) for row in written(TEXT)}
AGAIN = ("planar_rrr", "scara", "cuspidal_3r", "wrist_oblique", "planar_rrrr")
# What rows may miss their pose by, in arm sizes.
BOUNDS = {
    "closed form": 1e-11,
    "quartic": 1e-11,
    "general 6R": 1e-9,
    "general 5R1P": 1e-9,
    "general 4R2P": 1e-9,
    "numerical": 1e-9,
}


def test_every_robot_file_has_its_line() -> None:
    every = sorted([*robot_names(), *parallel_names()])
    assert list(ROWS) == every, "python -m benchmarks.survey --write (--arms NAME ...)"


def test_an_arm_that_is_not_solved_stands_there_with_the_reason() -> None:
    solved = tuple(ROWS["scara"].values())
    refused = padded(("loose", "RRR", "planar", "not solved: axes 1 and 2 are the same line"))
    text = f"<!-- {MARK} -->\n{report([solved, refused])}\n<!-- /{MARK} -->"
    assert written(text) == [solved, refused]
    assert re.search(r"^\| not solved +\| +1 \| +0/0 \|", text, re.MULTILINE)
    assert re.search(
        rf"^\| all +\| +2 \| +{ROWS['scara']['found/expected']} \|", text, re.MULTILINE
    )


def test_totals_are_those_of_the_lines() -> None:
    assert f"<!-- {MARK} -->\n{report(written(TEXT))}\n<!-- /{MARK} -->" in TEXT


@pytest.mark.parametrize("name", parallel_names())
def test_a_line_of_a_parallel_robot_is_its(name: str) -> None:
    row, header = ROWS[name], (GENERATED / f"{name}.h").read_text(encoding="utf-8")
    legs, _, types = row["joints"].partition("-")
    assert f"_LEGS = {legs}," in header
    assert f"_JOINTS = {len(types)}," in header
    assert f"_ROWS = {row['rows']}," in header


@pytest.mark.parametrize("name", robot_names())
def test_a_line_is_that_of_its_arm(name: str) -> None:
    row, header = ROWS[name], (GENERATED / f"{name}.h").read_text(encoding="utf-8")
    chain = build_chain(robot(name))
    assert (row["joints"], row["structure"]) == (joint_letters(chain), arm_class(chain))
    assert f'_METHOD "{row["method"]}"' in header
    assert re.search(rf"_ROWS = {row['rows']}\b", header)


@pytest.mark.parametrize("name", ROWS)
def test_every_arm_is_solved_completely(name: str) -> None:
    row = ROWS[name]
    found, expected = map(int, row["found/expected"].split("/"))
    answered, asked = map(int, row["singular poses"].split("/"))
    assert found == expected >= 200
    assert answered == asked > 100
    assert row["spurious"] == "0"
    assert float(row["residual"]) <= BOUNDS[row["method"]]


@pytest.mark.breadth
def test_some_arms_surveyed_again() -> None:
    lines = survey([ROBOTS / f"{name}.yaml" for name in AGAIN], 4)
    assert [line.name for line in lines] == list(AGAIN)
    for line in lines:
        assert line.complete
        row = dict(zip(HEAD, cells(line), strict=True))
        for column in ("joints", "structure", "method", "degree", "rows", "spurious"):
            assert row[column] == ROWS[line.name][column]
