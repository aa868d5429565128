"""Functions that numba compiles apart from callers: code out of the cache finds them again."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.compiling import written

GENERATED = Path(__file__).resolve().parents[2] / "generated"

pytestmark = pytest.mark.breadth  # numba takes seconds for each process

ARM = """
name: chain
title: Planar arm with two links
source: made up
convention: standard
parameters: {{length: {length}}}
joints:
  - {{theta: q, d: 0, a: length, alpha: 0}}
  - {{theta: q, d: 0, a: length, alpha: 0}}
task: [x, y]
"""

# A function that keeps what it calls in its cache, as users' do.
CALLER = """
import numpy as np
from numba import njit
import chain

@njit(cache=True)
def call(T, q, status):
    return chain.ik_into(T, q, status)
"""

ASK = """
import numpy as np
import caller, chain

def reach(module, answer):
    q, status = answer
    assert status[0] == module.OK, status
    return float(np.hypot(*(module.fk(q[0])[:2, 3] - T[:2, 3])))

T = np.eye(4)
T[:2, 3] = 0.7, 0.4
q, status = np.empty((2, 2)), np.empty(2, np.uint8)
assert caller.call(T, q, status) == 2
assert reach(chain, (q, status)) < 1e-9
assert reach(chain, chain.ik_all(T)) < 1e-9
asked = caller.call, chain._CALLS["unseeded"]
print(sum(sum(each.stats.cache_misses.values()) for each in asked))
"""


def write(folder: Path, length: float) -> None:
    """The arm's module, and a function that calls it."""
    path = folder / "chain.yaml"
    path.write_text(ARM.format(length=length), encoding="utf-8")
    written(path, folder)


def run(script: str, *folders: Path) -> subprocess.CompletedProcess[str]:
    """A clean process."""
    paths = ":".join(map(str, folders))
    return subprocess.run(
        [sys.executable, "-c", script],
        check=False,
        capture_output=True,
        text=True,
        cwd=folders[0],
        env={"PYTHONPATH": paths, "NUMBA_CACHE_DIR": str(folders[0] / "cache")},
    )


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """An arm, used once: numba's cache holds it."""
    made = tmp_path_factory.mktemp("apart")
    write(made, 0.5)
    (made / "caller.py").write_text(CALLER, encoding="utf-8")
    first = run(ASK, made)
    assert not first.returncode, first.stderr
    assert int(first.stdout) == 2
    return made


def test_the_cache_is_used(folder: Path) -> None:
    again = run(ASK, folder)
    assert not again.returncode, again.stderr
    assert int(again.stdout) == 0


WARM = """
import numpy as np
from numba.core import event
import chain

chain.warm_up()
T = np.eye(4)
T[:2, 3] = 0.7, 0.4
with event.install_recorder("numba:compile") as compiled:
    chain.ik(T, chain.ik_all(T)[0][0])
    chain.ik_all(T, np.ones(2))
    chain.ik_batch(T[np.newaxis])
    chain.ik_into(T, np.empty((2, 2)), np.empty(2, np.uint8))
    chain.jacobian(np.zeros(2))
print([each.data["dispatcher"].py_func.__name__ for _, each in compiled.buffer])
"""


def test_warm_up_leaves_nothing_to_compile(folder: Path) -> None:
    answer = run(WARM, folder)
    assert answer.stdout == "[]\n", answer.stderr


TWO = """
import importlib.util, sys
import numpy as np

def load(path):
    spec = importlib.util.spec_from_file_location("chain", path)
    module = sys.modules["chain"] = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module

modules = [load(path) for path in sys.argv[1:]]
T = np.eye(4)
T[:2, 3] = 0.7, 0.4
for module in [*modules, *reversed(modules)]:
    q, status = module.ik_all(T)
    assert status[0] == module.OK
    assert np.abs(module.fk(q[0])[:2, 3] - T[:2, 3]).max() < 1e-9
print("done")
"""


def test_two_texts_of_one_name_in_a_process(folder: Path, tmp_path: Path) -> None:
    write(tmp_path, 0.8)
    paths = [str(each / "chain.py") for each in (folder, tmp_path)]
    script = TWO.replace("sys.argv[1:]", repr(paths))
    answer = run(script, folder)
    assert answer.stdout == "done\n", answer.stderr


CACHED = """
import chain
from numba import njit

@njit(cache=True)
def call(q):
    return chain.{name}(q)
"""
CALL_BOTH = """
import numpy as np
import calls_fk, calls_jacobian

print(calls_fk.call(np.zeros(2)).shape, calls_jacobian.call(np.zeros(2)).shape)
"""


def test_callers_out_of_the_cache_call_what_they_were_made_for(folder: Path) -> None:
    """Code of one name, made in two processes, numba takes for the same."""
    for name in ("fk", "jacobian"):
        (folder / f"calls_{name}.py").write_text(CACHED.format(name=name), encoding="utf-8")
        made = run(f"import numpy, calls_{name}\ncalls_{name}.call(numpy.zeros(2))", folder)
        assert not made.returncode, made.stderr
    assert run(CALL_BOTH, folder).stdout == "(4, 4) (6, 2)\n"


def test_callers_that_hold_an_old_text_say_so(folder: Path) -> None:
    """numba does not see that what a cached function calls has changed."""
    write(folder, 0.6)
    answer = run(ASK, folder)
    assert answer.returncode == 1
    assert "ModuleNotFoundError: No module named 'chain " in answer.stderr


FIRST_CALLS = """
import sys
from numba.core import event

class Listener(event.Listener):
    def on_start(self, event):
        function = event.data["dispatcher"].py_func
        names.append(f"{function.__module__.split()[0]}.{function.__qualname__.split()[0]}")

    def on_end(self, event):
        pass

names = []
event.register("numba:compile", Listener())
for name in ("general_6r", "second"):
    names.clear()
    arm = __import__(name)
    arm.ik_all(arm.fk([0.3, 0.4, -0.5, 0.6, 0.7, 0.8]))
print(*names)
"""


def test_a_further_general_arm_compiles_its_own_functions_alone(tmp_path: Path) -> None:
    """What general arms share is compiled once, by the first of them."""
    copy = (GENERATED / "manseur_doty.py").read_text("utf-8")
    for name in ("dhgen_runtime", "general_6r.py"):
        (tmp_path / name).symlink_to(GENERATED / name)
    # nothing in the cache is of this file
    (tmp_path / "second.py").write_text(f"{copy}# {tmp_path}\n", encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-c", FIRST_CALLS],
        check=False,
        capture_output=True,
        text=True,
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(tmp_path)},
    )
    assert not done.returncode, done.stderr
    files = {name.split(".")[0] for name in done.stdout.split()}
    own = [name for name in done.stdout.split() if name.startswith("second.")]
    assert own == ["second.fk", "second._solve", "second.jacobian"]
    # beside what is merged into these
    assert files <= {"second", "arrays", "at_once", "pose", "numba"}
