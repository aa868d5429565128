"""What is surveyed: robot files, folders of them, and lists of tables in JSON."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from dhgen.errors import Diagnostic, RobotFileError

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

# Of a table in a list: what a robot file has too.
KEPT = ("name", "source", "convention", "parameters", "joints", "axes", "home", "task", "free")
FRAMES = ("base", "tool")


def robot_files(given: Sequence[Path], folder: Path) -> tuple[Path, ...]:
    """The robot files that are meant, in order.

    Args:
        given: Robot files; folders, of which every *.yaml is meant; JSON files, each a list of
            tables whose `base` and `tool` are 4x4 matrices.
        folder: An empty one, where tables of lists become robot files.

    Raises:
        RobotFileError: A list is none, or nothing is there.
    """
    files: list[Path] = []
    for path in given:
        if path.is_dir():
            files += sorted(path.glob("*.yaml"))
        elif path.suffix == ".json":
            files += _unpacked(path, folder)
        else:
            files.append(path)
    if not files:
        raise _refusal(given[0], "no robot files here")
    return tuple(files)


def _unpacked(path: Path, folder: Path) -> list[Path]:
    """JSON is YAML: a table needs only its matrices called so."""
    files: list[Path] = []
    for table in _tables(path):
        robot: dict[str, Any] = {key: table[key] for key in KEPT if key in table}
        robot.setdefault("title", str(table.get("class", table.get("name"))))
        robot |= {key: {"matrix": table[key]} for key in FRAMES if key in table}
        files.append(folder / f"{len(files):04d}_{table.get('name')}.yaml")
        files[-1].write_text(json.dumps(robot), encoding="utf-8")
    return files


def _tables(path: Path) -> list[dict[str, Any]]:
    try:
        tables = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise _refusal(path, f"the list can't be read: {error}") from None
    if not isinstance(tables, list) or not all(isinstance(table, dict) for table in tables):
        raise _refusal(path, "a list of tables is meant: [{...}, ...]")
    return tables


def _refusal(path: Path, reason: str) -> RobotFileError:
    return RobotFileError((Diagnostic(str(path), 0, 0, reason),))
