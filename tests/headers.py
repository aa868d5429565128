"""Headers that a compiler reads once in a run: its vectors take longer than a robot's C."""

from __future__ import annotations

import subprocess
from functools import cache
from typing import TYPE_CHECKING

from tests.kept import made_once

if TYPE_CHECKING:
    from pathlib import Path

VECTORS = """\
#if defined(__SSE2__)
#include <immintrin.h>
#endif
"""


@cache
def read_before(compiler: str, header: str, *flags: str) -> tuple[str, ...]:
    """Further flags with which a compiler, with these flags, goes on from where a header ends."""

    def read(folder: Path) -> None:
        path = folder / "before.h"
        path.write_text(header, encoding="utf-8")
        language = "c++-header" if compiler.endswith("++") else "c-header"
        # gcc and clang take this file instead of the header's text
        own = "-x", language, str(path), "-o", f"{path}.gch"
        subprocess.run([compiler, *flags, *own], check=True)

    folder = made_once((compiler, header, *flags), read)
    return "-include", str(folder / "before.h")
