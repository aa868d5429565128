"""Helpers that lie beside robots.

`dhgen_pose` has poses in other notations, `dhgen_native` puts the C behind the functions of a
robot's module, `dhgen_kernels` makes CUDA kernels of it, and `dhgen_cuda` calls these for
arrays on a GPU, which `dhgen_arrays` reads and makes; `dhgen_grad` has derivatives for PyTorch and
JAX. They are here and in ../c.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping

HERE = Path(__file__).resolve().parent
FILES = (
    *(
        HERE / f"{name}.py"
        for name in ("dhgen_arrays", "dhgen_cuda", "dhgen_grad", "dhgen_native", "dhgen_pose")
    ),
    *(
        HERE.parent / "c" / f"dhgen_{name}"
        for name in ("native.c", "pose.h", "pose.c", "kernels.cuh")
    ),
)


@cache
def helper_files() -> Mapping[str, str]:
    """Their texts by the names that they have beside robots."""
    return MappingProxyType({path.name: path.read_text(encoding="utf-8") for path in FILES})
