"""Robot files, folders and lists: what a survey is of."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from dhgen.errors import RobotFileError
from dhgen.robot.load import load
from dhgen.survey.oracle.forward import forward
from dhgen.survey.sources import robot_files
from tests.robots.cases import ROBOTS, robot

TABLES = Path(__file__).parents[1] / "robots" / "tables.json"


def test_a_folder_is_its_robot_files(tmp_path: Path) -> None:
    assert list(robot_files([ROBOTS], tmp_path)) == sorted(ROBOTS.glob("*.yaml"))


def test_files_keep_their_order(tmp_path: Path) -> None:
    given = [ROBOTS / "scara.yaml", ROBOTS / "adept.yaml"]
    assert list(robot_files(given, tmp_path)) == given


def test_a_list_of_tables_becomes_robot_files(tmp_path: Path) -> None:
    files = robot_files([TABLES], tmp_path)
    assert len(files) == 62
    robots = {each.name: each for each in map(load, files)}
    q = np.linspace(-1, 1, 6)
    for name in ("kawasaki_rs007n", "fanuc_lrmate200id"):  # a base and a tool
        np.testing.assert_allclose(forward(robots[name], q), forward(robot(name), q), atol=1e-12)
    assert robots["kuka_iiwa14"].free == (3,)
    assert robots["scorbot_pointing"].task.kind.value == "pointing"


@pytest.mark.parametrize(
    ("text", "said"),
    [("{}", "a list of tables is meant"), ("[1]", "a list"), ("[", "can't be read")],
)
def test_what_is_no_list(tmp_path: Path, text: str, said: str) -> None:
    (tmp_path / "x.json").write_text(text)
    with pytest.raises(RobotFileError, match=said):
        robot_files([tmp_path / "x.json"], tmp_path)


def test_an_empty_folder(tmp_path: Path) -> None:
    with pytest.raises(RobotFileError, match="no robot files here"):
        robot_files([tmp_path], tmp_path)
