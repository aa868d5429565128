"""`dhgen --check`: is the output folder what the compiler makes of the robot files?"""

from __future__ import annotations

import difflib
import os
import re
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from dhgen.compiler import compile_robot
from dhgen.errors import about
from dhgen.program.tolerances import DOUBLE, SINGLE

if TYPE_CHECKING:
    from collections.abc import Iterable

MOST_DIFFERENCES = 60  # lines of a diff that are shown

SUFFIXES = {".py", ".c", ".h", ".md"}


def stale(files: tuple[Path, ...], out: Path, *, numerical: bool = False) -> list[str]:
    """Everything that is not as it should be, as texts; empty when all is well.

    Raises:
        DhgenError: A robot file has mistakes or is not solved.
    """
    expected: dict[str, str] = {}
    makers: dict[str, Path] = {}
    for path, made in zip(files, _compile_all(files, numerical=numerical), strict=True):
        for name, text in made.items():
            expected[name] = text
            makers.setdefault(name, path)
    problems = []
    for name, text in sorted(expected.items()):
        problem = _difference(out / name, text)
        if problem:
            problems.append(f"{problem}\n  to mend: dhgen {makers[name]}{_out_option(out)}")
    problems += [
        f"{out / name}: extra file, no robot file makes it\n  to mend: rm {out / name}"
        for name in _extra(files, out, set(expected))
    ]
    return problems


def _compile_all(files: tuple[Path, ...], *, numerical: bool = False) -> list[dict[str, str]]:
    workers = min(len(files), os.cpu_count() or 1)
    files_of = partial(_files_of, numerical=numerical)
    if workers == 1:
        return [files_of(path) for path in files]
    with ProcessPoolExecutor(workers) as pool:
        return list(pool.map(files_of, files))


def _files_of(path: Path, *, numerical: bool) -> dict[str, str]:
    with about(path):
        return compile_robot(path, numerical=numerical).files


def _difference(path: Path, text: str) -> str | None:
    try:
        present = path.read_bytes().decode("utf-8", "replace")
    except FileNotFoundError:
        return f"{path}: missing"
    if present == text:
        return None
    diff = difflib.unified_diff(
        present.splitlines(), text.splitlines(), str(path), f"{path} (as compiled)", lineterm=""
    )
    lines = list(diff)
    if len(lines) > MOST_DIFFERENCES:
        more = len(lines) - MOST_DIFFERENCES
        lines = [*lines[:MOST_DIFFERENCES], f"... and {more} lines more"]
    return "\n".join([f"{path}: changed", *lines])


def _extra(files: tuple[Path, ...], out: Path, expected: set[str]) -> list[str]:
    """Files of the output folder that neither these robot files nor their neighbours make."""
    folders = {path.resolve().parent for path in files}
    neighbours = _stems(each for folder in folders for each in folder.glob("*.yaml"))
    known = _stems(files)
    if not out.is_dir():
        return []
    return sorted(
        path.name
        for path in out.iterdir()
        if path.suffix in SUFFIXES
        and path.name not in expected
        and (path.stem in known or path.stem not in neighbours)
    )


def _stems(files: Iterable[Path]) -> set[str]:
    """What the names of files may begin with that are made of these robot files."""
    names = map(_robot_name, files)
    return {name + precision.suffix for name in names for precision in (DOUBLE, SINGLE)}


def _robot_name(path: Path) -> str:
    """The name that a robot file gives itself, or that of the file."""
    text = path.read_text(encoding="utf-8", errors="replace")
    found = re.search(r"^name:\s*(\w+)", text, re.MULTILINE)
    return found.group(1) if found else path.stem


def _out_option(out: Path) -> str:
    return "" if out == Path("generated") else f" --out {out}"
