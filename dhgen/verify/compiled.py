"""What numba compiled of a written module, kept for whoever imports it next.

Compiling takes longer than all the rest. Verification does it anyway, of files in a temporary
folder; what it made fits the same text wherever that lies (`key` of `dhgen_runtime/jit.py`), though
tracebacks out of it name that folder. Older numbas than 0.68 compare texts by their times, and
compile again.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import dhgen.runtime.python
from dhgen.atomic_write import replace_files
from dhgen.runtime import PYTHON
from dhgen.runtime.python.jit import digest_of
from dhgen.verify.native import import_module

config: Any
njit: Any
try:
    from numba import njit
    from numba.core import config
except ImportError:  # verified in plain Python
    config = None

if TYPE_CHECKING:
    from collections.abc import Mapping
    from types import ModuleType


def import_temporary(path: Path) -> ModuleType:
    """Imports a module from a temporary folder, where numba keeps what it compiles of it, too."""
    if config is None:
        return import_module(path)
    kept, config.CACHE_DIR = config.CACHE_DIR, ""  # NUMBA_CACHE_DIR would keep it for good
    try:
        return import_module(path)
    finally:
        config.CACHE_DIR = kept


def compiled_code(module: ModuleType) -> Mapping[str, bytes]:
    """What numba made of an imported module and of the runtime; nothing without numba.

    Files of numba's cache, by their names, with folders for files of the runtime: there numba keeps
    what it compiles of a text of the runtime for one robot, too, and what it made for others.
    """
    made: dict[str, bytes] = {}
    for place, text, folder in _cached(module):
        known = {vars(module)["_HOW"].digest, digest_of(text)}
        for path in folder.glob(f"{text.stem}.*.nb[ci]"):
            if any(digest in path.name for digest in known):
                made[place + path.name] = path.read_bytes()
    return made


def runtime_code() -> Mapping[str, bytes]:
    """What numba keeps of the compiler's own runtime, by names as in `compiled_code`.

    What solves all joints at once is compiled once for all robots: the text imported first is used
    wherever else it lies, too.
    """
    if config is None:
        return {}
    own = Path(dhgen.runtime.python.__file__).parent
    made: dict[str, bytes] = {}
    for text in sorted(own.rglob("*.py")):
        place, digest = _place(text, own), digest_of(text)
        for path in _folder(text).glob(f"{text.stem}.* {digest}-*.nb[ci]"):
            made[place + path.name] = path.read_bytes()
    return made


def together(code: Mapping[str, bytes], other: Mapping[str, bytes]) -> Mapping[str, bytes]:
    """Compiled code of two folders: where both have a function, all of the second's.

    An index has its own numbers for the code of other arguments.
    """
    known = {_function(name) for name in other}
    return {**{name: made for name, made in code.items() if _function(name) not in known}, **other}


def _function(name: str) -> str:
    """What names of an index and of the code that it lists have in common."""
    return name.rsplit(".", 1 if name.endswith(".nbi") else 2)[0]


def keep_compiled(code: Mapping[str, bytes], path: Path) -> None:
    """Puts compiled code where numba looks for the code of a module and of the runtime beside it.

    What numba has there of a function of the same text is kept: its index may have other numbers
    for the code of other arguments. Names hold the digest of a text: code of other texts of the
    module is removed. Where nothing can be written, whoever imports the module compiles it anew.

    Args:
        code: What `compiled_code` gave for the same text.
        path: The module.
    """
    if not code:
        return
    module = import_module(path, lend=False)
    try:
        for place, text, folder in _cached(module):
            for old in folder.glob(f"{text.stem}.*.nb[ci]") if not place else ():
                if vars(module)["_HOW"].digest not in old.name:
                    old.unlink()
            start = f"{place}{text.stem}."
            own = {name.removeprefix(place): name for name in code if name.startswith(start)}
            for index in sorted(name for name in own if name.endswith(".nbi")):
                if not (folder / index).exists():
                    _keep_function({each: code[name] for each, name in own.items()}, folder, index)
    except OSError:
        return


def _keep_function(code: Mapping[str, bytes], folder: Path, index: str) -> None:
    """One function's code; without an index numba takes none of it for anything."""
    parts = sorted(name for name in code if name.startswith(index[:-3]) and name != index)
    replace_files(folder, {name: code[name] for name in (*parts, index)})


def _cached(module: ModuleType) -> list[tuple[str, Path, Path]]:
    """The places of texts, the texts, and where numba keeps what it compiles of them.

    First the module itself, which has no place, then the files of its runtime after the folders
    that they lie in; nothing without numba.
    """
    known = vars(module)["_CALLS"]["velocities_at"]  # a text of the runtime that all robots have
    if config is None or not hasattr(known, "stats"):
        return []
    path = Path(str(module.__file__)).resolve()
    runtime = Path(known.py_func.__code__.co_filename).parent
    found = [("", path)]
    found += [(_place(text, runtime), text) for text in sorted(runtime.rglob("*.py"))]
    in_tree = Path(str(known.stats.cache_path)) == runtime / "__pycache__"
    kept, config.CACHE_DIR = config.CACHE_DIR, "" if in_tree else config.CACHE_DIR
    try:
        return [(place, text, _folder(text)) for place, text in found]
    finally:
        config.CACHE_DIR = kept


def _place(text: Path, runtime: Path) -> str:
    """The folder in the runtime that a text of its own lies in."""
    return f"{PYTHON}/{text.parent.relative_to(runtime).as_posix()}/".replace("./", "")


def _folder(text: Path) -> Path:
    """Where numba keeps what it compiles of a text."""

    def probe() -> None: ...

    probe.__code__ = probe.__code__.replace(co_filename=str(text))
    return Path(str(njit(cache=True)(probe).stats.cache_path))
