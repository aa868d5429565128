"""`dhgen --check`: is the output folder what the compiler makes of the robot files?"""

from __future__ import annotations

import difflib
import re
import shlex
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

from dhgen.compiler import source_name
from dhgen.derivation.figures.figure import FOLDER
from dhgen.descriptions.write import identifier
from dhgen.errors import DhgenError, about
from dhgen.generated_header import SUFFIXES, is_generated, source_folder
from dhgen.legs.read import SUFFIX as LEG
from dhgen.parallel.compile import compile_file
from dhgen.printing.comments import plain_path
from dhgen.robot.load import DESCRIPTIONS, is_description
from dhgen.robot.robot import FLEET
from dhgen.robot.schema import MAX_LEGS
from dhgen.robot_files import ENDINGS, led_to
from dhgen.runtime import runtime_files
from dhgen.tolerances import DOUBLE, SINGLE
from dhgen.workers import side_by_side

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable, Mapping, Sequence
    from pathlib import Path

    from dhgen.compiler import Compilation
    from dhgen.parallel.compile import ParallelCompilation
    from dhgen.robot_files import AnyFile, RobotFiles

MOST_DIFFERENCES = 60  # lines of a diff that are shown
MOST_NAMES = 4  # of missing files that are shown
# In C and in Python that hold what they need of the runtime.
INSIDE = ("#undef DHGEN_SHARED /* the whole runtime", "# The runtime that this file holds, by")


@dataclass(frozen=True, slots=True)
class Comparison:
    """What `--check` finds.

    Attributes:
        problems: Everything in the folder that is not as it should be, as texts.
        refusals: Why arms are refused, in the order of their files.
    """

    problems: tuple[str, ...]
    refusals: tuple[DhgenError, ...]

    @property
    def exit_code(self) -> int:
        """0 when all is well, 1 when something is stale or not solved."""
        return max(bool(self.problems), *(each.exit_code for each in self.refusals), 0)


def compare(
    files: RobotFiles, out: Path, options: Sequence[str] = (), *, single_file: bool = False
) -> Comparison:
    """The folder against what the compiler makes; a file that is refused hides no other.

    Args:
        files: The robot files.
        out: The folder.
        options: The options of the command that mends it.
        single_file: Whether C and Python hold what they need of the runtime.
    """
    expected: dict[str, str] = {}
    makers: dict[str, Path] = {}
    refusals: list[DhgenError] = []
    compiler = partial(compile_file, out=out, single_file=single_file)
    compiled = side_by_side(partial(_files_of, compiler), files.loaded)
    for file, made in zip(files.loaded, compiled, strict=True):
        if isinstance(made, DhgenError):
            refusals.append(made)
            continue
        for name, text in made.items():
            expected[name] = text
            makers.setdefault(name, file.path)
    problems: list[str] = []
    for maker in dict.fromkeys(makers.values()):
        own = {name: text for name, text in expected.items() if makers[name] == maker}
        command = shlex.join(["dhgen", str(maker), *options])
        problems += _stale(out, own, command, single_file=single_file)
    extra = _extra(files.paths, set(makers.values()), out, set(expected))
    problems += [_extra_text(out / name, files.paths) for name in extra]
    return Comparison(tuple(problems), tuple(refusals))


def _extra_text(path: Path, robots: tuple[Path, ...]) -> str:
    """The message about a file that these robot files do not make."""
    if not is_generated(path):
        return (
            f"{path}: not written by dhgen\n"
            "  to fix: move it elsewhere: all .py, .c, .h and .md files here must be generated"
        )
    looked = " or ".join(sorted({f"{robot.parent}/" for robot in robots}))
    return (
        f"{path}: extra file: no robot file in {looked} generates it\n"
        f"  to fix: add its robot file to the command, or {shlex.join(['rm', str(path)])}"
    )


def _files_of(
    compiler: Callable[[AnyFile], Compilation | ParallelCompilation], file: AnyFile
) -> dict[str, str] | DhgenError:
    try:
        with about(file.path):
            return dict(compiler(file).files)
    except DhgenError as refusal:
        return refusal


def _stale(out: Path, own: Mapping[str, str], command: str, *, single_file: bool) -> Iterable[str]:
    """The message about a robot's files that are not what the compiler makes, if there are any.

    Args:
        out: The folder.
        own: What they should be, by their paths in the folder.
        command: The one that makes them.
        single_file: Whether they should hold what they need of the runtime.
    """
    told, missing, otherwise = [], [], []
    for name, text in own.items():
        path = out / name
        try:
            present = path.read_bytes().decode("utf-8", "replace")
        except (FileNotFoundError, NotADirectoryError):
            missing.append(name)
        except OSError as error:  # a folder, or a circle of links
            told.append(f"{path}: can't be read ({error.strerror})")
        else:
            if _holds_runtime(present) != _holds_runtime(text):
                otherwise.append(str(path))
            elif present != text:
                told.append(_changed(path, present, text))
    mend = command
    if otherwise:
        made = "without" if single_file else "with"
        told.append(f"{', '.join(otherwise)}: made {made} --single-file")
        mend = f"check {made} --single-file, or {command}"
        missing = [name for name in missing if name not in runtime_files()]
    told += _missing(out, missing)
    if told:
        yield "\n".join([*told, f"  to fix: {mend}"])


def _holds_runtime(text: str) -> bool:
    """Whether a solver in C or Python was made with --single-file, or in single precision."""
    return any(mark in text for mark in INSIDE)


def _missing(out: Path, names: Sequence[str]) -> Iterable[str]:
    """The message about files that are not there."""
    if len(names) == 1:
        yield f"{out / names[0]}: missing"
    elif names:
        more = f" and {len(names) - MOST_NAMES} more" * (len(names) > MOST_NAMES)
        yield f"{out}: {len(names)} files are missing: {', '.join(names[:MOST_NAMES])}{more}"


def _changed(path: Path, present: str, text: str) -> str:
    """The message about a file that is another one, with what differs."""
    diff = difflib.unified_diff(
        present.splitlines(),
        text.splitlines(),
        f"{path} (as it is)",
        f"{path} (as compiled)",
        lineterm="",
    )
    lines = list(diff)
    if len(lines) > MOST_DIFFERENCES:
        more = len(lines) - MOST_DIFFERENCES
        lines = [*lines[:MOST_DIFFERENCES], f"... and {more} more lines"]
    return "\n".join([f"{path}: changed", *lines])


def _extra(files: tuple[Path, ...], makers: set[Path], out: Path, expected: set[str]) -> list[str]:
    """Files of the output folder that neither these robot files nor their neighbours make.

    What a refused file would make isn't known: only the other files count (what all robots share is
    among what any of them makes). Files generated from another folder are not looked at.
    """
    folders = {led_to(path).parent for path in files}
    sources = {_folder_of(plain_path(source_name(path, out))) for path in files}
    around = (each for folder in folders for each in _robots_in(folder))
    neighbours = _stems([*files, *around])
    known = _stems(makers)
    if not makers or not out.is_dir():
        return []
    own = sorted(
        name
        for name, stem in [*_in_the_folder(out), *_figures(out)]
        if name not in expected
        and (stem in known or stem not in neighbours)
        and source_folder(out / name) in {None, *sources}
    )
    return own + _extra_of_the_runtime(out, expected)


def _robots_in(folder: Path) -> Iterable[Path]:
    """Robot files, and robot descriptions, of which MJCF files are called .xml."""
    for end in (*ENDINGS, *DESCRIPTIONS):
        yield from folder.glob(f"*{end}")
    yield from filter(is_description, folder.glob("*.xml"))


def _in_the_folder(out: Path) -> Iterable[tuple[str, str]]:
    """Files that can be solvers and documents: their names, and the stems that these begin with."""
    for path in out.iterdir():
        if path.suffix in SUFFIXES:
            yield path.name, path.stem


def _figures(out: Path) -> Iterable[tuple[str, str]]:
    """The messages about generated figures; drawings of others may lie beside them."""
    for path in (out / FOLDER).glob("*.svg"):
        if is_generated(path):
            yield f"{FOLDER}/{path.name}", path.stem.rpartition("_")[0]


def _extra_of_the_runtime(out: Path, expected: set[str]) -> list[str]:
    """Files in the folders of the runtime that are none of its own."""
    folders = {name.partition("/")[0] for name in expected if "/" in name}
    paths = (path for folder in folders for path in (out / folder).rglob("*"))
    found = (path.relative_to(out).as_posix() for path in paths if path.suffix in SUFFIXES)
    return sorted(name for name in found if name not in expected)


def _folder_of(source: str) -> str:
    """The folder before a name, if there is any."""
    return source.rpartition("/")[0]


def _stems(files: Iterable[Path]) -> set[str]:
    """What the names of files may begin with that are made of these robot files."""
    names = map(_robot_name, files)
    legs = [LEG, *(f"{LEG}{number}" for number in range(1, MAX_LEGS + 1))]
    suffixes = (DOUBLE.suffix, SINGLE.suffix, FLEET, *legs)
    return {name + suffix for name in names for suffix in suffixes}


def _robot_name(path: Path) -> str:
    """The name in a robot file, or of an import's robot; else the file's name."""
    try:
        text = path.read_text(encoding="utf-8", errors="replace")
    except OSError:  # it is refused for that
        return path.stem
    if is_description(path):
        named = re.search(r"<(?:robot|mujoco)\b[^>]*?\b(?:name|model)\s*=\s*[\"']([^\"']+)", text)
        return identifier(named.group(1) if named else path.stem)
    found = re.search(r"^name:\s*(\w+)", text, re.MULTILINE)
    return found.group(1) if found else path.stem
