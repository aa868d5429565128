"""What numba compiled of a written module, kept for whoever imports it next.

Compiling takes longer than all the rest. Verification does it anyway, of files in a temporary
folder; what it made fits the same text wherever that lies (`_KEY` in the module), though tracebacks
out of it name that folder. Older numbas than 0.68 tell texts by their times, and compile again.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from dhgen.replace import replace_files
from dhgen.verify.native import import_module

config: Any
try:
    from numba.core import config
except ImportError:  # verified in plain Python
    config = None

if TYPE_CHECKING:
    from collections.abc import Mapping
    from types import ModuleType


def import_temporary(path: Path) -> ModuleType:
    """Imports a module from a temporary folder, where what numba compiles of it stays, too."""
    if config is None:
        return import_module(path)
    kept, config.CACHE_DIR = config.CACHE_DIR, ""  # NUMBA_CACHE_DIR would keep it for good
    try:
        return import_module(path)
    finally:
        config.CACHE_DIR = kept


def compiled_code(module: ModuleType) -> Mapping[str, bytes]:
    """The files of numba's cache that belong to an imported module, by name; none without numba."""
    folder = _cache_folder(module)
    if folder is None:
        return {}
    found = folder.glob(f"{Path(str(module.__file__)).stem}.*.nb[ci]")
    return {path.name: path.read_bytes() for path in found}


def keep_compiled(code: Mapping[str, bytes], path: Path, *, rewritten: bool) -> None:
    """Puts compiled code where numba looks for that of a module.

    Where nothing can be written, whoever imports the module compiles it anew.

    Args:
        code: What `compiled_code` gave for the same text.
        path: The module.
        rewritten: Whether it held another text before. If not, functions that numba knows there
            are left alone: its index may have other numbers for the code of other arguments.
    """
    folder = _cache_folder(import_module(path)) if code else None
    if folder is None:
        return
    try:
        for index in sorted(name for name in code if name.endswith(".nbi")):
            if rewritten or not (folder / index).exists():
                _keep_function(code, folder, index)
    except OSError:
        return


def _keep_function(code: Mapping[str, bytes], folder: Path, index: str) -> None:
    """One function's code; without an index numba takes none of it for anything."""
    (folder / index).unlink(missing_ok=True)
    parts = sorted(name for name in code if name.startswith(index[:-3]) and name != index)
    replace_files(folder, {name: code[name] for name in (*parts, index)})


def _cache_folder(module: ModuleType) -> Path | None:
    """Where numba keeps what it compiles of a module."""
    stats = (getattr(value, "stats", None) for value in vars(module).values())
    paths = (getattr(each, "cache_path", None) for each in stats)
    return next((Path(path) for path in paths if path), None)
