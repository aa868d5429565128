"""What is surveyed: robot files, folders of them, and lists of tables in JSON."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from dhgen.errors import Diagnostic, RobotFileError

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

FRAMES = ("base", "tool")
NOTES = ("class", "confidence")  # of a table in a list, for its readers


@dataclass(frozen=True, slots=True)
class Source:
    """A robot file.

    Attributes:
        path: Where it is.
        name: Of the arm, as long as the file has not been read.
        place: Which table of which list it was made of; nothing for a file of the user's own.
    """

    path: Path
    name: str
    place: str = ""

    def tell(self, remark: Diagnostic) -> str:
        """A remark and its place; of a list the user never saw the file."""
        if not self.place:
            return str(remark)
        return ": ".join(filter(None, [self.place, remark.message, remark.source.strip(" ,[{")]))


def robot_files(given: Sequence[Path], folder: Path) -> tuple[Source, ...]:
    """The robot files that are meant, in order.

    Args:
        given: Robot files; folders, of which every *.yaml is meant; JSON files, each a list of
            tables: robot files in JSON whose `base` and `tool` may be 4x4 matrices.
        folder: An empty one, where tables of lists become robot files.

    Raises:
        RobotFileError: A path leads nowhere, a list is none, or nothing is there.
    """
    found: list[Source] = []
    mistakes: list[Diagnostic] = []
    for path in given:
        try:
            found += _files(path, folder, len(found))
        except RobotFileError as error:
            mistakes += error.diagnostics
    if mistakes:
        raise RobotFileError(tuple(mistakes))
    return tuple(found)


def _files(path: Path, folder: Path, before: int) -> list[Source]:
    if path.is_dir():
        files = [Source(each, each.stem) for each in sorted(path.glob("*.yaml"))]
    elif path.suffix == ".json":
        files = _unpacked(path, folder, before)
    elif path.exists():
        files = [Source(path, path.stem)]
    else:
        raise _refusal(path, "there is no such file or folder")
    if not files:
        raise _refusal(path, "no robot files here")
    return files


def _unpacked(path: Path, folder: Path, before: int) -> list[Source]:
    """JSON is YAML: a table needs only its matrices called so."""
    files: list[Source] = []
    for number, table in enumerate(_tables(path), start=1):
        robot = {key: value for key, value in table.items() if key not in NOTES}
        robot.setdefault("title", str(table.get("class", table.get("name"))))
        for key in FRAMES:
            if isinstance(robot.get(key), list):
                robot[key] = {"matrix": robot[key]}
        file = folder / f"{before + number}.yaml"
        file.write_text(json.dumps(robot, indent=1), encoding="utf-8")
        place = f"table {number}"
        name = str(robot.get("name", ""))
        files.append(Source(file, name if name.isidentifier() else place, f"{path}: {place}"))
    return files


def _tables(path: Path) -> list[dict[str, Any]]:
    try:
        tables = json.loads(path.read_text(encoding="utf-8"), object_pairs_hook=_unique)
    except OSError as error:
        raise _refusal(path, f"the list can't be read: {error.strerror}") from None
    except RecursionError:
        raise _refusal(path, "the list can't be read: it is nested too deeply") from None
    except ValueError as error:
        raise _refusal(path, f"the list can't be read: {error}") from None
    if not isinstance(tables, list) or not all(isinstance(table, dict) for table in tables):
        raise _refusal(path, "a list of tables is meant: [{...}, ...]")
    return tables


def _unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """An object; ValueError where a key stands twice."""
    made = dict(pairs)
    for key, _ in pairs:
        if sum(key == other for other, _ in pairs) > 1:
            raise ValueError(f"the key '{key}' stands twice in one table")
    return made


def _refusal(path: Path, reason: str) -> RobotFileError:
    return RobotFileError((Diagnostic(str(path), 0, 0, reason),))
