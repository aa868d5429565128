"""A module whose runtime is the compiler's own takes what numba keeps of that one."""

from __future__ import annotations

from pathlib import Path

import dhgen.runtime.python
from dhgen.atomic_write import write_files
from dhgen.runtime import runtime_files
from dhgen.verify.native import import_module

OWN = Path(dhgen.runtime.python.__file__).parent
GENERATED = Path(__file__).resolve().parents[2] / "generated"


def runtime_of(folder: Path, *, lend: bool = True) -> Path:
    """Where the runtime of a module in a folder comes from."""
    module = import_module(folder / "planar_rr.py", lend=lend)
    return Path(vars(module)["_arms"].__file__).parent


def test_only_the_same_runtime_is_lent(tmp_path: Path) -> None:
    own = (GENERATED / "planar_rr.py").read_text("utf-8")
    write_files(tmp_path, {**runtime_files(), "planar_rr.py": own})
    beside = tmp_path / "dhgen_runtime"
    assert runtime_of(tmp_path) == OWN
    assert runtime_of(tmp_path, lend=False) == beside
    arm = beside / "arm.py"
    arm.write_text(arm.read_text("utf-8") + "\n", encoding="utf-8")
    assert runtime_of(tmp_path) == beside
