"""The runtime: code that is the same for all robots, shipped unchanged beside what is generated."""

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
    python = Path(__file__).parent / "python"
    paths = sorted(python.rglob("*.py"))
    return MappingProxyType(
        {
            f"{PYTHON}/{path.relative_to(python).as_posix()}": path.read_text("utf-8")
            for path in paths
        }
    )
