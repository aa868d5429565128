"""The Python runtime without numba, for the compiler itself and as what compiled code is held to.

A few poses are solved sooner than anything is compiled.
"""

from __future__ import annotations

import sys
from functools import cache
from importlib import import_module
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from typing import Any

NAME = "dhgen_runtime in plain Python"


@cache
def plain(module: str) -> Any:  # noqa: ANN401  its functions have the types of the compiled ones
    """A module of the runtime, e.g. `general.search`, by which nothing is compiled."""
    if NAME not in sys.modules:
        _load()
    return import_module(f"{NAME}.{module}")


def _load() -> None:
    """Loads the package under another name, first the module that imports numba."""
    folder = Path(__file__).parent / "python"
    spec = spec_from_file_location(
        NAME, folder / "__init__.py", submodule_search_locations=[str(folder)]
    )
    assert spec is not None
    assert spec.loader is not None
    package = sys.modules[NAME] = module_from_spec(spec)
    spec.loader.exec_module(package)
    held = {"numba": sys.modules["numba"]} if "numba" in sys.modules else {}
    sys.modules["numba"] = None  # type: ignore[assignment]  # as where there is none
    try:
        import_module(f"{NAME}.jit")
    finally:
        del sys.modules["numba"]
        sys.modules.update(held)
