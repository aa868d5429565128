# SPDX-License-Identifier: MIT
"""The runtime of generated robots in Python: what is the same for all of them.

It lies as `dhgen_runtime` beside the robots, which find it there by whatever name they are
imported. Everything is plain Python and right without numba; with numba it is compiled.

In reading order: `jit` (numba or plain Python).
"""

from __future__ import annotations

import hashlib
from pathlib import Path

INTERFACE = 1  # what a robot's module was generated for; another number is refused


def _digest() -> str:
    """The digest of the runtime's own sources: compiled code is kept under it.

    numba looks at the text of one file only, and takes code from its cache although a function in
    another file that it calls has changed.
    """
    folder = Path(__file__).parent
    made = hashlib.sha256()
    for path in sorted(folder.rglob("*.py")):
        made.update(f"{path.relative_to(folder).as_posix()}\0".encode())
        made.update(path.read_bytes() + b"\0")
    return made.hexdigest()[:16]


DIGEST = _digest()
