"""Headers that a compiler reads once in a process: its vectors take longer than a robot's C."""

from __future__ import annotations

import subprocess
import tempfile
from functools import cache
from pathlib import Path

VECTORS = """\
#if defined(__SSE2__)
#include <immintrin.h>
#endif
"""
_KEPT: list[tempfile.TemporaryDirectory[str]] = []


@cache
def read_before(compiler: str, header: str, *flags: str) -> tuple[str, ...]:
    """Further flags with which a compiler, with these flags, goes on from where a header ends."""
    kept = tempfile.TemporaryDirectory(prefix="dhgen-headers-")
    _KEPT.append(kept)
    path = Path(kept.name) / "before.h"
    path.write_text(header, encoding="utf-8")
    language = "c++-header" if compiler.endswith("++") else "c-header"
    # gcc and clang take this file instead of the header's text
    own = "-x", language, str(path), "-o", f"{path}.gch"
    subprocess.run([compiler, *flags, *own], check=True)
    return "-include", str(path)
