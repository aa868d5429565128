"""The runtime: code that is the same for all robots, shipped unchanged beside what is generated.

It is in `c` and in `python`, with what users call besides in `helpers`. `plain` is the Python of it
without numba, for the compiler itself.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping

PYTHON = "dhgen_runtime"  # the folder of the Python runtime beside robots


@cache
def runtime_files() -> Mapping[str, str]:
    """The files of the runtime by their paths in the folder of the robots."""
    return MappingProxyType({**python_runtime_files(), **c_runtime_files()})


@cache
def c_runtime_files() -> Mapping[str, str]:
    """The runtime's files in C, which robots' sources include, in `dhgen`."""
    folder = Path(__file__).parent / "c"
    paths = sorted(path for path in (folder / "dhgen").rglob("*") if path.suffix in {".c", ".h"})
    return MappingProxyType(
        {path.relative_to(folder).as_posix(): path.read_text("utf-8") for path in paths}
    )


@cache
def python_runtime_files() -> Mapping[str, str]:
    """The runtime's files in Python, which robots' modules import, in `dhgen_runtime`."""
    folder = Path(__file__).parent / "python"
    paths = sorted(folder.rglob("*.py"))
    return MappingProxyType(
        {f"{PYTHON}/{p.relative_to(folder).as_posix()}": p.read_text("utf-8") for p in paths}
    )
