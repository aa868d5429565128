"""Where numba can keep nothing: a folder that can't be written to, and no home to speak of."""

from __future__ import annotations

import os
import subprocess
import sys
from typing import TYPE_CHECKING

import pytest

from dhgen.atomic_write import write_files
from dhgen.oracle.levenberg_marquardt import _compiled
from dhgen.runtime import runtime_files
from tests.targets.made import folder, made

if TYPE_CHECKING:
    from pathlib import Path

IMPORTED = """
import warnings
with warnings.catch_warnings(record=True) as told:
    warnings.simplefilter("always")
    import {name}
print(*(each.message for each in told))
print({call})
"""


@pytest.mark.breadth
@pytest.mark.parametrize(
    ("name", "call"),
    [
        ("planar_rr", "planar_rr.ik_all(planar_rr.fk([0.1, 0.2]))[1].tolist()"),
        ("dhgen_pose", "dhgen_pose.from_xyz_rpy([0, 0, 0], [0, 0, 0])[0].astype(int).tolist()"),
    ],
)
def test_modules_work_and_name_the_remedy(name: str, call: str, tmp_path: Path) -> None:
    made("planar_rr")
    text = (folder() / f"{name}.py").read_text(encoding="utf-8")
    write_files(tmp_path, {**runtime_files(), f"{name}.py": text})
    (tmp_path / "__pycache__").touch()  # no folder for root either
    without = {key: os.environ[key] for key in os.environ if key != "NUMBA_CACHE_DIR"}
    nowhere = {"HOME": os.devnull, "XDG_CACHE_HOME": f"{os.devnull}/cache"}
    done = subprocess.run(
        [sys.executable, "-c", IMPORTED.format(name=name, call=call)],
        cwd=tmp_path,
        env=without | nowhere | {"PYTHONPATH": str(tmp_path)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    told, result = done.stdout.splitlines()
    assert "set NUMBA_CACHE_DIR to a writable folder" in told
    assert str(tmp_path) in told
    assert result == ("[0, 0]" if name == "planar_rr" else "[1, 0, 0, 0]")


def test_the_search_that_counts_solutions_works_there_too(monkeypatch: pytest.MonkeyPatch) -> None:
    def without_folder(*_: object, cache: bool = False) -> str:
        if cache:
            raise RuntimeError("cannot cache function: no locator available")
        return "compiled"

    monkeypatch.setattr("dhgen.oracle.levenberg_marquardt.njit", without_folder)
    assert str(_compiled(lambda: None)) == "compiled"
