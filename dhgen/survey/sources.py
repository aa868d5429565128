"""What is surveyed: robot files, folders, lists of tables in JSON; and what kind of arm each is."""

from __future__ import annotations

import json
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.errors import Diagnostic, RobotFileError, refused
from dhgen.kinematics.neighbours import EXACT, axis_triples
from dhgen.kinematics.numeric import numeric_arm
from dhgen.robot.task import TaskKind
from dhgen.robot_files import ENDINGS

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.neighbours import Triple


FRAMES = ("base", "tool")
MATRIX = "matrix"  # who writes a list may leave it out
MEANT = (*ENDINGS, ".urdf")  # in a folder: most xacro files are parts of robots
NONE_HERE = "no robot files (*.yaml, *.yml, *.urdf) here; name lists in JSON themselves"
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

    def located(self, remark: Diagnostic) -> str:
        """A remark and its place; of a list the user never saw the file."""
        if not self.place:
            return str(remark)
        shown = remark.source.strip(" ,[{")
        keys = "" if '":' in shown else ", ".join(self._keys(remark.line))
        return ": ".join(filter(None, [self.place, keys, remark.message, shown]))

    def _keys(self, line: int) -> list[str]:
        """The keys that a line of the file is below, except keys that no list has."""
        keys: list[str] = []
        lines = self.path.read_text(encoding="utf-8").splitlines()[:line]
        depth = len(lines[-1]) - len(lines[-1].lstrip()) if lines else 0
        for text in reversed(lines):
            rest = text.lstrip()
            if len(text) - len(rest) < depth:
                depth = len(text) - len(rest)
                keys += [rest.split('"')[1]] if rest.startswith('"') else []
        return [key for key in reversed(keys) if key != MATRIX]


def robot_files(given: Sequence[Path], folder: Path) -> tuple[Source, ...]:
    """The robot files that are meant, in order.

    Args:
        given: Robot files; folders, of which every *.yaml, *.yml and *.urdf is meant; JSON files,
            each a list of tables or one: robot files in JSON whose `base` and `tool` may be 4x4
            matrices.
        folder: An empty one, where tables of lists become robot files.

    Raises:
        RobotFileError: A path does not exist, a list is none, or nothing is there.
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
        files = [Source(each, each.stem) for each in _robots_in(path)]
    elif path.suffix == ".json":
        files = _unpacked(path, folder, before)
    elif path.exists():
        files = [Source(path, path.stem)]
    else:
        raise refused(path, "no such file or folder")
    if not files:
        raise refused(path, NONE_HERE if path.is_dir() else "the list is empty")
    return files


def _robots_in(folder: Path) -> list[Path]:
    try:  # Path.glob finds nothing where it may not look
        return sorted(each for each in folder.iterdir() if each.suffix in MEANT)
    except OSError as error:
        raise refused(folder, f"the folder can't be read: {error.strerror}") from None


def _unpacked(path: Path, folder: Path, before: int) -> list[Source]:
    """JSON is YAML: a table needs only its matrices called so."""
    files: list[Source] = []
    for number, table in enumerate(_tables(path), start=1):
        robot = {key: value for key, value in table.items() if key not in NOTES}
        robot.setdefault("title", str(table.get("class", table.get("name"))))
        for key in FRAMES:
            if isinstance(robot.get(key), list):
                robot[key] = {MATRIX: robot[key]}
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
        raise refused(path, f"the list can't be read: {error.strerror}") from None
    except RecursionError:
        raise refused(path, "the list can't be read: it is nested too deeply") from None
    except ValueError as error:
        raise refused(path, f"the list can't be read: {error}") from None
    if isinstance(tables, dict) and "name" in tables:
        return [tables]
    if not isinstance(tables, list):
        raise refused(path, "expected a list of tables: [{...}, ...]")
    wrong = [str(n) for n, table in enumerate(tables, start=1) if not isinstance(table, dict)]
    if wrong:
        if len(wrong) == 1:
            fault = f"entry {wrong[0]} is not a table"
        else:
            fault = f"entries {', '.join(wrong)} are not tables"
        raise refused(path, f"expected a list of tables, [{{...}}, ...]: {fault}")
    return tables


def _unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """An object; ValueError where a key occurs twice."""
    made = dict(pairs)
    for key, _ in pairs:
        if sum(key == other for other, _ in pairs) > 1:
            raise ValueError(f"the key '{key}' appears twice in one table")
    return made


def joint_letters(chain: Chain) -> str:
    """R or P for every joint; a free joint's letter is small."""
    return "".join(
        letter.lower() if number in chain.free else letter
        for number, letter in enumerate(chain.joint_types, start=1)
    )


def arm_class(chain: Chain) -> str:
    """The structure in a few words: "spherical wrist, ortho-parallel", "SCARA", "general 6R"."""
    task = chain.task
    asked = "" if task.kind is TaskKind.POSE else task.text.strip("[]")
    return ", ".join(filter(None, [*_structure(chain), asked]))


def _structure(chain: Chain) -> list[str]:
    directions = _directions(chain)
    turns = [d for d, turns in zip(directions, chain.turning, strict=True) if turns]
    slides = [d for d, turns in zip(directions, chain.turning, strict=True) if not turns]
    if not turns:
        return ["Cartesian"]
    if len(turns) > 1 and all(_parallel(one, other) for one, other in pairwise(turns)):
        if not slides:
            return ["planar"]
        upright = all(_parallel(turns[0], slide) for slide in slides)
        return ["SCARA" if upright else "planar with slides"]
    triples = axis_triples(chain)
    parallel = [triple for triple in triples if triple.tilt < EXACT]
    meeting = [triple for triple in triples if triple.miss < EXACT * chain.size]
    found = [*_meeting(chain, meeting), *(f"parallel axes {_named(t)}" for t in parallel)]
    if _is_ortho_parallel(chain, directions, meeting):
        found.append("ortho-parallel")
    if not found:
        return [f"general {len(turns)}R" + (f"{len(slides)}P" if slides else "")]
    return found


def _meeting(chain: Chain, triples: list[Triple]) -> list[str]:
    last = chain.dof
    return [
        "spherical wrist" if triple.joints[2] == last else f"axes {_named(triple)} meet"
        for triple in triples
    ]


def _named(triple: Triple) -> str:
    return "-".join(map(str, triple.joints))


def _is_ortho_parallel(chain: Chain, directions: list[FloatArray], meeting: list[Triple]) -> bool:
    """Six turns: axis 2 across axis 1, axis 3 parallel to axis 2, axis 4 across it, a wrist."""
    if chain.free or chain.joint_types != "RRRRRR" or (4, 5, 6) not in {t.joints for t in meeting}:
        return False
    one, two, three, four = directions[:4]
    return _across(one, two) and _parallel(two, three) and _across(three, four)


def _parallel(one: FloatArray, other: FloatArray) -> bool:
    return bool(np.linalg.norm(np.cross(one, other)) < EXACT)


def _across(one: FloatArray, other: FloatArray) -> bool:
    return bool(abs(one @ other) < EXACT)


def _directions(chain: Chain) -> list[FloatArray]:
    """Of every axis, all angles zero: what neighbours are to each other does not depend on it."""
    return list(numeric_arm(chain).axes(np.zeros(chain.dof))[0])
