"""The runtime as it is compiled, and as it is in plain Python."""

from __future__ import annotations

import importlib
import sys
from functools import cache
from types import ModuleType
from typing import Any

import dhgen.runtime.python as runtime
from dhgen.runtime.python.jit import COMPILED
from tests.structures import first_of

# numba takes seconds for what plain Python shows to be right, and for what all modules contain.
KINDS = first_of(["plain", "compiled"] if COMPILED else ["plain"])


@cache
def part(kind: str, name: str) -> Any:
    """A module of the runtime, by whether it is compiled."""
    if kind == "compiled":
        return importlib.import_module(f"dhgen.runtime.python.{name}")
    hidden = {key: sys.modules.pop(key) for key in list(sys.modules) if key.startswith("numba")}
    sys.modules["numba"] = None  # type: ignore[assignment]
    try:
        plain = sys.modules.setdefault("plain", ModuleType("plain"))
        plain.__path__ = list(runtime.__path__)
        vars(plain).update(DIGEST=runtime.DIGEST, INTERFACE=runtime.INTERFACE)
        return importlib.import_module(f"plain.{name}")
    finally:
        del sys.modules["numba"]
        sys.modules.update(hidden)
