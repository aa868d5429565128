"""What numba keeps is taken for no other text: neither of the runtime nor of a robot.

numba looks at the file of a function only, not at those that it calls, and at no value of a global.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.compiling import written

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

ROOT = Path(__file__).resolve().parents[2]
PLANAR = ROOT / "robots" / "planar_rr.yaml"

ASK = """
import importlib.util, json, sys
import numpy as np
from numba.core import event

spec = importlib.util.spec_from_file_location(sys.argv[1], "planar_rr.py")
robot = sys.modules[sys.argv[1]] = importlib.util.module_from_spec(spec)
spec.loader.exec_module(robot)
T = np.eye(4)
T[:2, 3] = 0.4, 0.3
q, status = np.empty((robot.MAX_SOLUTIONS, robot.DOF)), np.empty(robot.MAX_SOLUTIONS, np.uint8)
with event.install_recorder("numba:compile") as compiled:
    robot.ik_into(T, q, status)
    chosen = robot.ik(T, [40.0, 0.0], branch=0, limits=False)
print(json.dumps({
    "reached": float(robot.fk(q[0])[0, 3]), "elbow": q[0, 1], "first": chosen[0],
    "compiled": len(compiled.buffer),
}))
"""


def ask(folder: Path, name: str) -> Mapping[str, float]:
    """What a robot in a folder answers in a clean process, imported under a name."""
    done = subprocess.run(
        [sys.executable, "-c", ASK, name],
        cwd=folder,
        env=os.environ | {"NUMBA_CACHE_DIR": str(folder / "cache"), "NUMBA_DISABLE_JIT": "0"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert not done.returncode, done.stderr
    answer: Mapping[str, float] = json.loads(done.stdout)
    return answer


@contextmanager
def changed(path: Path, right: str, wrong: str) -> Iterator[None]:
    text = path.read_text(encoding="utf-8")
    assert text.count(right) == 1
    path.write_text(text.replace(right, wrong), encoding="utf-8")
    try:
        yield
    finally:
        path.write_text(text, encoding="utf-8")


@pytest.fixture(scope="module")
def asked(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Mapping[str, float]]:
    """A robot and the runtime, with numba's cache filled; and what it answers."""
    folder = tmp_path_factory.mktemp("asked")
    written(PLANAR, folder)
    first = ask(folder, "planar_rr")
    assert first["compiled"] > 0
    assert first["reached"] == pytest.approx(0.4)
    assert first["first"] == pytest.approx(40.0, abs=3.2)
    again = ask(folder, "under_another_name")
    assert again == {**first, "compiled": 0}
    return folder, first


@pytest.mark.slow
def test_a_tolerance_of_the_runtime(asked: tuple[Path, Mapping[str, float]]) -> None:
    """Angles are not moved near to a seed that is farther away than this."""
    tolerances = asked[0] / "dhgen_runtime" / "tolerances.py"
    with changed(tolerances, "FAR_ANGLE = 1e5\n", "FAR_ANGLE = 1e1\n"):
        for name in ("planar_rr", "under_another_name"):
            answer = ask(asked[0], name)
            assert abs(answer["first"]) < 3.2
            assert answer["reached"] == pytest.approx(0.4)


def test_a_constant_of_a_robot(asked: tuple[Path, Mapping[str, float]]) -> None:
    folder, first = asked
    with changed(folder / "planar_rr.py", "\nk1 = 0.25 ", "\nk1 = 0.26 "):
        for name in ("planar_rr", "under_another_name"):
            assert abs(ask(folder, name)["elbow"] - first["elbow"]) > 1e-3
