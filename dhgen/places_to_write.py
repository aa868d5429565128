"""Where a command may write: what is there already, and is not written over."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

from dhgen.errors import CommandError
from dhgen.generated_header import SUFFIXES, is_of_dhgen, robot_of, source_of

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence
    from pathlib import Path

    from dhgen.robot_files import AnyFile


def print_replaced(out: Path, text: str) -> None:
    """Says where a file takes the place of another one."""
    if out.exists() and out.read_bytes() != text.encode():
        print(f"note: {out} was there and is written over", file=sys.stderr)


def refuse_what_was_read(out: Path, read: Sequence[Path]) -> None:
    """Stops before a file is written over that the new one is made of."""
    if out.exists() and any(each.exists() and out.samefile(each) for each in read):
        raise CommandError(f"dhgen: {out} is what was read: write to another file")


def refuse_mute() -> None:
    """Stops where standard output was closed, for commands that do nothing but print."""
    if sys.__stdout__ is None:
        raise CommandError("dhgen: standard output is closed: there is nothing to print to")


def refuse_taken(file: AnyFile, out: Path) -> None:
    """Stops before the work, where files of another robot have the names of this one's.

    Robots are compared by their names: a robot file may have been moved.
    """
    for stem in file.stems:
        paths = (out / f"{stem}{suffix}" for suffix in SUFFIXES)
        owners = ((robot_of(path), path) for path in paths if path.is_file())
        other = next((each for each in owners if each[0] not in {None, file.robot.name}), None)
        if other is not None:
            owner, path = other
            raise CommandError(
                f"{file.path}: {out / stem}.* are files of the robot '{owner}', made of "
                f"{source_of(path)}: rename one of the robots, write to another folder (--out), or "
                "remove them if they are left over"
            )


def refuse_not_ours(source: Path, out: Path, names: Iterable[str]) -> None:
    """Stops where files of the user's own have the names of those that are to be written.

    What is empty, and what dhgen wrote, be it of an older version, is written over.

    Args:
        source: The robot file.
        out: The output folder.
        names: The paths in the folder of what is to be written.
    """
    there = ((out / name, name) for name in names)
    full = ((path, name) for path, name in there if path.is_file() and path.stat().st_size)
    found = [str(path) for path, name in full if not is_of_dhgen(out, name)]
    if found:
        are, them = ("are", "them") if len(found) > 1 else ("is", "it")
        raise CommandError(
            f"{source}: {', '.join(found)} {are} there already and not made by dhgen: move {them} "
            "elsewhere, or write to another folder (--out)"
        )


def refuse_occupied(paths: Sequence[Path]) -> None:
    """Stops before anything is written, where something that is there can't be written over."""
    for path in paths:
        if path.is_dir():
            raise CommandError(f"dhgen: can't write {path}: it is a folder")
        if path.exists() and not os.access(path, os.W_OK):
            raise CommandError(f"dhgen: can't write {path}: the file is read-only")
