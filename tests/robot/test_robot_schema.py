"""The JSON Schema for editors is the one that the models make, and agrees with what loads."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from dhgen.robot.schema import main, schema_text
from dhgen.robot_files import read_file

ROBOTS = Path(__file__).parents[2] / "robots"
FILES = sorted(ROBOTS.glob("*.yaml"))


def test_the_committed_schema_is_current() -> None:
    committed = (ROBOTS / "robot.schema.json").read_text(encoding="utf-8")
    assert committed == schema_text(), "run: python -m dhgen.robot.schema"


def test_the_command_writes_it(tmp_path: Path) -> None:
    main([str(tmp_path / "s.json")])
    assert (tmp_path / "s.json").read_text(encoding="utf-8") == schema_text()


def test_every_key_is_described() -> None:
    schema = json.loads(schema_text())
    frame = schema["$defs"]["FrameEntry"]["anyOf"][0]
    rows = [schema["$defs"][name] for name in ("JointRow", "AxisRow", "LegEntry", "Units")]
    for model in (schema, frame, *rows):
        assert model["additionalProperties"] is False
        for key, entry in model["properties"].items():
            assert entry.get("description"), key


def test_a_cell_is_a_number_or_a_text() -> None:
    row = json.loads(schema_text())["$defs"]["JointRow"]["properties"]
    assert row["theta"]["type"] == ["number", "string"]


# Angles with noise on purpose, of which dhgen warns.
NEARLY_RIGHT = {"kuka_kr6_r900_calibrated", "puma560_calibrated"}


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_the_robots_of_the_project_load(path: Path) -> None:
    robot = read_file(path).robot
    assert robot.name == path.stem
    assert robot.source
    assert bool(robot.notices) == (path.stem in NEARLY_RIGHT)
