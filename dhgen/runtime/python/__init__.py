# SPDX-License-Identifier: MIT
"""The runtime of generated robots in Python: what is the same for all of them.

It lies as `dhgen_runtime` beside the robots, which find it there by whatever name they are
imported. Everything is plain Python and right without numba; with numba it is compiled.

In reading order: `jit` (numba or plain Python); `places` and `arm` (the numbers of an arm),
`status` and `tolerances`; `angles`, `arrays`, `rigid`, `frames`, `turns`, `limits` and `pose` (what
all else is made of); `careful` (any pose, singular ones too), with the steps around the formulas:
`retry`, `duplicates`, `follow_seed`, `clamp`, `refine` with `least_squares`, `complete`;
`circle_roots`; `nearest`; `coupled`, with `coupled_turns`; `left_to_the_seed`; `velocities`;
`one_pose` and `tiles` (regular poses), `at_once` (arms without branches), `functions` (made from
their texts); `arguments`, `entry`, `calls` and `calls_given` (public functions), `words`. `general`
and `numerical` are for arms without a closed form. Tables that come at run time: `calibration`,
`calibrate`, `serial`, `calibrated`, `calibrated_arm`, `calls_calibrated`, `refused_numbers`.
Platforms on legs: `platform`, `direct`, `assemblies`, `parallel`.
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
