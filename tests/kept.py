"""What compilers make for many tests, made once a run: its workers share a folder."""

from __future__ import annotations

import fcntl
import hashlib
import os
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    import pytest

FOLDER = "DHGEN_TESTS_FOLDER"  # the run's folder, of which workers know by their environment
DONE = "done"


def make_folder(config: pytest.Config) -> None:
    """Makes the run's folder, in the process that starts the workers; it goes with the run."""
    if FOLDER not in os.environ:
        kept = tempfile.TemporaryDirectory(prefix="dhgen-run-")
        os.environ[FOLDER] = kept.name
        config.add_cleanup(kept.cleanup)


def made_once(key: Sequence[str], make: Callable[[Path], None]) -> Path:
    """A folder with what `make` puts there, by whichever process of the run comes first.

    Args:
        key: What is made of what; sources do not change in a run.
        make: Fills the folder, which exists and is empty.
    """
    name = hashlib.sha256("\0".join(key).encode()).hexdigest()[:24]
    folder = Path(os.environ[FOLDER]) / name
    with folder.with_suffix(".lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (folder / DONE).exists():
            folder.mkdir(exist_ok=True)
            make(folder)
            (folder / DONE).touch()
    return folder
