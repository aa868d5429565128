"""Robot files, folders and lists: what a survey is of."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import NoReturn

import numpy as np
import pytest

from dhgen.errors import RobotFileError
from dhgen.oracle.forward import forward
from dhgen.robot.load import load
from dhgen.survey.sources import robot_files
from tests.robots.cases import ROBOTS, robot

TABLES = Path(__file__).parents[1] / "robots" / "tables.json"


def test_a_folder_is_its_robot_files(tmp_path: Path) -> None:
    files = robot_files([ROBOTS], tmp_path)
    assert [each.path for each in files] == sorted(ROBOTS.glob("*.yaml"))
    assert [each.name for each in files] == [each.path.stem for each in files]


def test_files_keep_their_order(tmp_path: Path) -> None:
    given = [ROBOTS / "scara.yaml", ROBOTS / "adept.yaml"]
    assert [each.path for each in robot_files(given, tmp_path)] == given


def test_a_list_of_tables_becomes_robot_files(tmp_path: Path) -> None:
    files = robot_files([TABLES], tmp_path)
    assert len(files) == 62
    robots = {each.name: load(each.path) for each in files}
    q = np.linspace(-1, 1, 6)
    for name in ("kawasaki_rs007n", "fanuc_lrmate200id"):  # a base and a tool
        np.testing.assert_allclose(forward(robots[name], q), forward(robot(name), q), atol=1e-12)
    assert robots["kuka_iiwa14"].free == (3,)
    assert robots["scorbot_pointing"].task.kind.value == "pointing"


def test_a_table_alone_and_a_file_called_yml(tmp_path: Path) -> None:
    folder = tmp_path / "robots"
    folder.mkdir()
    (folder / "planar.yml").write_text((ROBOTS / "planar_rr.yaml").read_text(encoding="utf-8"))
    (folder / "arm.urdf").write_text("<robot/>")
    (folder / "parts.xacro").write_text("<robot/>")
    (tmp_path / "alone.json").write_text(json.dumps(json.loads(TABLES.read_text())[0]))
    files = robot_files([folder, tmp_path / "alone.json"], tmp_path)
    assert [each.path.name for each in files] == ["arm.urdf", "planar.yml", "3.yaml"]
    assert load(files[2].path).name == files[2].name


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("{}", "expected a list of tables"),
        ("[1]", "expected a list of tables, .*: entry 1 is not a table"),
        ('[{}, 1, {}, "x"]', "expected a list of tables, .*: entries 2, 4 are not tables"),
        ("[", "can't be read: Expecting value"),
        ("[" * 100_000, "nested too deeply"),
        ('[{"free": [1], "free": [2]}]', "the key 'free' appears twice"),
        ("[]", "the list is empty"),
    ],
)
def test_what_is_no_list(tmp_path: Path, text: str, said: str) -> None:
    (tmp_path / "x.json").write_text(text)
    with pytest.raises(RobotFileError, match=said):
        robot_files([tmp_path / "x.json"], tmp_path)


def test_a_folder_that_may_not_be_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(_: Path) -> NoReturn:
        raise PermissionError(13, "Permission denied")

    # as both list a folder, so that root can ask, too
    monkeypatch.setattr("os.scandir", refuse)
    monkeypatch.setattr("os.listdir", refuse)
    with pytest.raises(RobotFileError, match="the folder can't be read: Permission denied"):
        robot_files([tmp_path], tmp_path)


def test_all_paths_that_lead_nowhere_are_told_at_once(tmp_path: Path) -> None:
    given = [tmp_path, tmp_path / "x.yaml", tmp_path / "x.json"]
    with pytest.raises(RobotFileError) as refused:
        robot_files(given, tmp_path)
    assert str(refused.value).splitlines() == [
        f"{tmp_path}: no robot files (*.yaml, *.yml, *.urdf) here; name lists in JSON themselves",
        f"{tmp_path}/x.yaml: no such file or folder",
        f"{tmp_path}/x.json: the list can't be read: No such file or directory",
    ]


@pytest.mark.parametrize(
    ("name", "key", "value", "said"),
    [
        ("arm", "fre", [3], "table 2: unknown key 'fre'; did you mean 'free'.*: \"fre\":$"),
        ("arm", "joints", [{"theta": "q", "d": "x"}], 'table 2: unknown name \'x\'; .*: "d": "x"$'),
        ("arm", "base", [[1, 0], [0, 1]], "table 2: base: expected 4 values, not 2: a row of four"),
        ("arm", "tool", {"xyz": [0, "z", 0]}, "table 2: tool, xyz: unknown name 'z'; .*: \"z\"$"),
        ("../arm", "joints", [], "table 2: '../arm': the robot can't have this name"),
        ("\x1b[31m", "joints", [], "table 2: .*can't have this name"),
    ],
)
def test_a_mistake_in_a_table_has_its_place(
    tmp_path: Path, name: str, key: str, value: object, said: str
) -> None:
    good = {"name": "good", "joints": [{"theta": "q", "d": 0, "a": 1, "alpha": 0}]}
    (tmp_path / "x.json").write_text(json.dumps([good, {**good, "name": name, key: value}]))
    first, second = robot_files([tmp_path / "x.json"], tmp_path)
    assert load(first.path).name == first.name == "good"
    assert second.name == (name if name == "arm" else "table 2")
    with pytest.raises(RobotFileError) as refused:
        load(second.path)
    told = second.located(refused.value.diagnostics[0])
    assert told.startswith(f"{tmp_path}/x.json: table 2: ")
    assert re.search(said, told)
    assert told.isprintable()
