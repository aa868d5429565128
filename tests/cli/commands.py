"""The command as tests call it: as a process of its own, and in folders of theirs."""

from __future__ import annotations

import errno
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import NoReturn

Run = Callable[..., subprocess.CompletedProcess[str]]

ROOT = Path(__file__).resolve().parents[2]
PLANAR = ROOT / "robots" / "planar_rr.yaml"
HELPERS = "arrays.py cuda.py grad.py kernels.cuh native.c native.py pose.c pose.h pose.py"
FILES = [f"dhgen_{name}" for name in HELPERS.split()] + [
    f"planar_rr.{end}" for end in ("c", "h", "md", "py")
]
WRONG = """\
name: wrong
title: wrong
source: made up
convention: standard
joints:
  - {theta: q, d: x, a: 0, alpha: 0}
task: pose
"""
UNSOLVABLE = """\
name: redundant
title: A planar arm with a joint to spare
source: made up
convention: standard
joints:
  - {theta: q, d: 0, a: 0.4, alpha: 0}
  - {theta: q, d: 0, a: 0.3, alpha: 0}
  - {theta: q, d: 0, a: 0.2, alpha: 0}
  - {theta: q, d: 0, a: 0.1, alpha: 0}
task: pose
"""


def dhgen(*words: str | Path, folder: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    """Runs the command in a folder, as a process of its own."""
    return subprocess.run(
        [sys.executable, "-m", "dhgen", *map(str, words)],
        cwd=folder,
        env=os.environ | {"PYTHONPATH": str(ROOT)} | environment,
        capture_output=True,
        text=True,
        check=False,
    )


def names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir() if path.is_file())


def copy(written: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(written, tmp_path / "copy"))


# The command that verifies with few poses: in plain Python all of them take ten seconds.
HASTY_PROGRAM = """
import sys
import dhgen.verify.verify
from dhgen.cli import main
dhgen.verify.verify.COUNT = 4
sys.exit(main())
"""
HASTY = f"-c '{HASTY_PROGRAM}'"


def in_shell(
    words: str, folder: Path, program: str = "-m dhgen"
) -> subprocess.CompletedProcess[str]:
    """Runs the command as a shell does that closes streams, what it proves without numba."""
    return subprocess.run(
        ["/bin/sh", "-c", f"{sys.executable} {program} {words}"],
        cwd=folder,
        env=os.environ | {"PYTHONPATH": str(ROOT), "NUMBA_DISABLE_JIT": "1"},
        capture_output=True,
        text=True,
        check=False,
    )


def full_disk(path: Path, *_: object, **__: object) -> NoReturn:
    """In place of Path.write_bytes: as Python, which names the files only that it can't open."""
    path.touch()
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
