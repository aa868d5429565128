"""Comparing two folders of generated files: what is the same is, what is changed is noticed."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import numpy as np
import pytest

from benchmarks.compare.__main__ import main
from benchmarks.compare.answers import same_set
from benchmarks.compare.libraries import BuildError, build, shape_of
from benchmarks.solvers import GENERATED
from dhgen.robot.load import load
from dhgen.verify.native import c_compiler

pytestmark = pytest.mark.skipif(c_compiler() is None, reason="there is no C compiler")

FEW = ("--poses", "60")
ROBOT = Path(__file__).parents[2] / "robots" / "scara.yaml"
# Of the SCARA's tool, and of a link of an arm that numba compiles in half the time.
LENGTHS = {
    "scara": (re.compile(r"\b(L4\W+)0\.1\b"), "0.100001"),
    "planar_rr": (re.compile(r"\b(a1 = )0\.4\b"), "0.400001"),
}


@pytest.fixture
def changed(tmp_path: Path) -> Path:
    """The generated files, two arms with another length."""
    folder = tmp_path / "changed"
    shutil.copytree(GENERATED, folder, ignore=shutil.ignore_patterns("__pycache__"))
    for robot, (length, other) in LENGTHS.items():
        for name in (f"{robot}.c", f"{robot}.py"):
            text = (GENERATED / name).read_text(encoding="utf-8")
            assert length.search(text)
            (folder / name).write_text(length.sub(rf"\g<1>{other}", text), encoding="utf-8")
    return folder


@pytest.mark.breadth
def test_a_folder_answers_as_itself(capsys: pytest.CaptureFixture[str]) -> None:
    folder = str(GENERATED)
    assert main([folder, folder, "scara", "franka_panda", *FEW]) == 0
    told = capsys.readouterr().out
    for name in ("scara.c", "scara_f32.c", "franka_panda.c"):
        assert re.search(rf"^{name}: 0 of \d{{4,}} calls differ, 0 in sets$", told, re.MULTILINE)


@pytest.mark.breadth
@pytest.mark.parametrize(
    ("name", "way"),
    [("scara", ()), ("planar_rr", ("--python",))],
)
def test_a_changed_constant_is_noticed(
    name: str,
    way: tuple[str, ...],
    changed: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("benchmarks.compare.__main__.PLAIN_POSES", 2)  # below numba's are asked for
    assert main([str(GENERATED), str(changed), name, *FEW, *way]) == 1
    told = capsys.readouterr().out
    for call in ("fk", "jacobian", "ik, without a seed", "ik_nearest, any seed", "ik_batch"):
        line = next(line for line in told.splitlines() if "random" in line and f" {call} " in line)
        _, _, _, calls, differ, *_ = (cell.strip() for cell in line.strip("|").split("|"))
        assert int(differ) > int(calls) / 2, call


@pytest.mark.breadth
def test_times_are_told_of_both(capsys: pytest.CaptureFixture[str]) -> None:
    folder, often = str(GENERATED), ("--processes", "2", "--rounds", "2")
    assert main([folder, folder, "scara", "--time", *FEW, *often]) == 0
    lines = [line for line in capsys.readouterr().out.splitlines() if "scara, random" in line]
    assert [line.split("|")[2].strip() for line in lines] == ["one pose", "batch"]
    for line in lines:
        assert float(line.split("|")[5].split("[")[0]) > 0.0


def test_sets_are_equal_in_any_order_and_whole_turns_apart() -> None:
    turning = np.array([True, False])
    rows = np.array([[1.0, 2.0], [np.nan, np.nan], [-3.0, 4.0]])
    moved = np.array([[-3.0 + 2 * np.pi, 4.0], [1.0, 2.0 + 1e-8]])
    assert same_set(rows, moved, turning, 1e-6)
    assert not same_set(rows, moved, turning, 1e-9)
    assert not same_set(rows, moved[:1], turning, 1e-6)
    assert not same_set(rows, moved[[0, 0]], turning, 1e-6)
    assert not same_set(rows, moved + np.array([0.0, 2 * np.pi]), turning, 1e-6)


def test_what_does_not_compile_is_told(changed: Path, tmp_path: Path) -> None:
    (changed / "scara.c").write_text("nothing\n", encoding="utf-8")
    with pytest.raises(BuildError, match="nothing"):
        build(shape_of(load(ROBOT), changed), changed, (), tmp_path / "broken.so")
