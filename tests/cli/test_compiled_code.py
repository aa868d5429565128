"""What numba compiled for the verification serves whoever imports the written files."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numba
import pytest

from dhgen.runtime.python.jit import digest_of
from dhgen.verify.compiled import compiled_code, import_temporary, keep_compiled, together
from dhgen.verify.native import import_module
from tests.cli.commands import ROOT, copy, full_disk

BY_NAME = "import planar_rr as robot, dhgen_pose as pose"
IN_A_PACKAGE = "from generated import planar_rr as robot, dhgen_pose as pose"
FROM_A_FILE = """
import importlib.util

def module(name):
    spec = importlib.util.spec_from_file_location(f"made up {name}", f"generated/{name}.py")
    made = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(made)
    return made

robot, pose = module("planar_rr"), module("dhgen_pose")
"""
CALL = """
import numpy as np
from numba import njit
from numba.core import event

@njit
def call(q):
    return robot.fk(q)

T = pose.from_xyz_rpy((0.4, 0.3, 0.0), (0.0, 0.0, 0.5))
with event.install_recorder("numba:compile") as compiled:
    robot.warm_up()
    q, status = robot.ik_all(T)
    q = robot.ik(T, q[0])
    robot.ik_batch(T[np.newaxis])
    robot.jacobian(q)
assert np.allclose(robot.fk(q)[:2, 3], T[:2, 3])
assert np.allclose(call(q)[:2, 3], T[:2, 3])
assert np.allclose(pose.to_xyz_rpy(T)[1], (0.0, 0.0, 0.5))
print(sorted({each.data["dispatcher"].py_func.__name__ for _, each in compiled.buffer}))
"""


@pytest.mark.breadth
def test_nothing_is_left_to_compile_whatever_the_name(verified: Path, tmp_path: Path) -> None:
    """numba looks for functions in the module in which they were compiled."""
    folder = copy(verified, tmp_path)
    places = {"PYTHONPATH": f"{folder}:{folder / 'generated'}", "NUMBA_CACHE_DIR": ""}
    for how in (FROM_A_FILE, BY_NAME, IN_A_PACKAGE):
        done = subprocess.run(
            [sys.executable, "-c", how + CALL],
            cwd=folder,
            env=os.environ | places,
            capture_output=True,
            text=True,
            check=False,
        )
        assert (done.stdout, done.stderr) == ("[]\n", ""), how


def planar(folder: Path) -> Path:
    """A robot's module in a folder, with the runtime beside it."""
    shutil.copytree(ROOT / "generated" / "dhgen_runtime", folder / "dhgen_runtime")
    return Path(shutil.copy(ROOT / "generated" / "planar_rr.py", folder))


def digest(module: Path) -> str:
    """The digest that names of the module's compiled functions hold."""
    return str(vars(import_module(module))["_HOW"].digest)


def kept(folder: Path) -> dict[str, bytes]:
    """The files of numba's cache in a folder, at any depth."""
    paths = (path for end in ("nbi", "nbc") for path in folder.rglob(f"*.{end}"))
    return {path.name: path.read_bytes() for path in paths}


def test_it_goes_where_numba_was_told_to_keep_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    module = planar(tmp_path)
    monkeypatch.setattr(numba.config, "CACHE_DIR", str(tmp_path / "told"))
    own = {f"planar_rr.made {digest(module)}-1.nbi": b"made"}
    text = module.parent / "dhgen_runtime" / "general" / "rows.py"
    shared = {f"dhgen_runtime/general/rows.made {digest_of(text)}-1.nbi": b"for all robots"}
    keep_compiled(own | shared, module)
    assert len(list((tmp_path / "told").rglob("*.nbi"))) == 2
    assert len(kept(tmp_path)) == 2
    assert compiled_code(import_module(module, lend=False)) == own | shared
    assert not any(".made " in name for name in compiled_code(import_temporary(module)))


def test_what_numba_knows_of_the_same_text_stays(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its index numbers the code of other arguments in an order of its own."""
    monkeypatch.setattr(numba.config, "CACHE_DIR", "")
    module = planar(tmp_path)
    one, two = f"planar_rr.one {digest(module)}-1", f"planar_rr.two {digest(module)}-2"
    first = {f"{one}.1.nbc": b"1", f"{one}.nbi": b"one"}
    keep_compiled(first, module)
    (folder,) = {path.parent for path in tmp_path.rglob("*.nbi")}
    (folder / f"{one}.1.nbc").write_bytes(b"a user's")
    second = {f"{two}.1.nbc": b"2", f"{two}.nbi": b"two"}
    keep_compiled(first | second, module)
    assert kept(tmp_path) == first | second | {f"{one}.1.nbc": b"a user's"}


def test_what_numba_knew_of_another_text_goes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(numba.config, "CACHE_DIR", "")
    module = planar(tmp_path)
    keep_compiled({f"planar_rr.one {digest(module)}-1.nbi": b"one"}, module)
    assert kept(tmp_path)
    module.write_text(module.read_text(encoding="utf-8") + "# changed\n", encoding="utf-8")
    new = {f"planar_rr.one {digest(module)}-1.nbi": b"new"}
    keep_compiled(new, module)
    assert kept(tmp_path) == new


def test_no_index_is_kept_without_its_code(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A full disk in between: there is nothing then, instead of other code than the index says."""
    monkeypatch.setattr(numba.config, "CACHE_DIR", "")
    module = planar(tmp_path)
    one = f"planar_rr.one {digest(module)}-1"
    with monkeypatch.context() as patch:
        patch.setattr(Path, "write_bytes", full_disk)
        keep_compiled({f"{one}.1.nbc": b"1", f"{one}.nbi": b"one"}, module)
    assert not list(tmp_path.rglob("*.nbi"))


def test_of_two_folders_a_function_is_taken_whole() -> None:
    """An index has its own numbers for the code of other arguments."""
    one = {f"dhgen_runtime/jit.one.py311.{end}": b"1" for end in ("nbi", "1.nbc", "2.nbc")}
    other = {f"dhgen_runtime/jit.one.py311.{end}": b"2" for end in ("nbi", "1.nbc")}
    alone = {f"dhgen_runtime/jit.two.py311.{end}": b"1" for end in ("nbi", "1.nbc")}
    assert together(one | alone, other) == other | alone


WHOLE = """
import sys
from pathlib import Path

from dhgen.atomic_write import write_files
from dhgen.verify.verify import imported
from tests.compiling import compile_file

made = compile_file(Path("robots/planar_rrrr.yaml"))
write_files(Path(sys.argv[1]), made.files)
imported(made.module, Path(sys.argv[1]))

from dhgen.runtime.python.numerical.search import OWN

print(OWN._apart["all_joints"][0].py_func.__code__.co_filename)
"""


def test_what_solves_all_joints_is_compiled_once_for_all_robots(tmp_path: Path) -> None:
    """Its code is the compiler's own and stays, though robots have a copy of the text."""
    command = [sys.executable, "-c", WHOLE, str(tmp_path)]
    run = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    assert (
        Path(run.stdout.strip())
        == ROOT / "dhgen" / "runtime" / "python" / "numerical" / "search.py"
    )
