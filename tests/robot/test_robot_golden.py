"""What the user reads about a file, word by word: reviewed by eye, compared exactly."""

from __future__ import annotations

from pathlib import Path

import pytest

from dhgen.errors import RobotFileError
from dhgen.robot.load import load_text

GOLDEN = Path(__file__).parent / "golden"
FILES = sorted(GOLDEN.glob("*.yaml"))


def said(path: Path) -> str:
    """The errors of a file, or the notices about it."""
    try:
        robot = load_text(path.read_text(encoding="utf-8"), path.name)
    except RobotFileError as error:
        return f"{error}\n"
    return "".join(f"{notice}\n" for notice in robot.notices)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_texts(path: Path) -> None:
    assert said(path) == path.with_suffix(".txt").read_text(encoding="utf-8")


def test_every_text_has_its_file() -> None:
    assert {path.stem for path in FILES} == {path.stem for path in GOLDEN.glob("*.txt")}
