"""Files that are written whole or not at all."""

from __future__ import annotations

import tempfile
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping


def replace_files(folder: Path, contents: Mapping[str, bytes]) -> None:
    """Writes files to a folder; the old ones are kept unless all of the new ones have found room.

    Args:
        folder: Is there already.
        contents: By their paths in the folder, in the order in which they take their places.

    Raises:
        OSError: With the name of the file, as it was to be.
    """
    with _room(folder) as room:
        for name, content in contents.items():
            with naming(folder / name):
                (Path(room) / name).parent.mkdir(parents=True, exist_ok=True)
                (Path(room) / name).write_bytes(content)
        for name in contents:
            with naming(folder / name):
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                (Path(room) / name).replace(folder / name)


def write_files(folder: Path, texts: Mapping[str, str]) -> None:
    """Writes texts to a folder that nobody else looks at yet.

    Args:
        folder: Is made if need be.
        texts: By their paths in the folder.

    Raises:
        OSError: With the name of the file.
    """
    for name, text in texts.items():
        with naming(folder / name):
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(text, encoding="utf-8")


def _room(folder: Path) -> tempfile.TemporaryDirectory[str]:
    """A passing folder in one, so that files only change their names."""
    with naming(folder):
        return tempfile.TemporaryDirectory(prefix=".dhgen-", dir=folder)


@contextmanager
def naming(path: Path) -> Iterator[None]:
    """Adds the path to an OSError that lacks one."""
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from error
