"""Robots whose file has no mistake, and whose legs are not solved or can't move the platform."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from dhgen.atomic_write import write_files
from dhgen.cli import main
from dhgen.errors import ImmobileError, UnsolvedError
from dhgen.parallel import compile as compiler
from dhgen.parallel.compile import compile_parallel
from dhgen.parallel.verify import verify_parallel
from tests.parallel.test_parallel_files import TWO, read

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.parallel.verify import ParallelReport

# Feet 4 apart, legs 0.5 long at most.
APART = TWO.replace("[-0.1, 0, 0]", "[-2, 0, 0]").replace("[0.1, 0, 0]", "[2, 0, 0]")
# Stretched, the left leg ends at x = 0.4 at most, and the right one at x = 0.56 at least.
LIMITED = TWO.replace("a: 0.3}", "a: 0.3, limits: [0, 1 deg]}").replace(
    "a: 0.2}", "a: 0.2, limits: [-20 deg, 20 deg]}"
)
# Three legs carry one point of the platform: it turns about that whatever the drives do.
TURNING = """\
name: two
legs:
  - base: {xyz: [0.3, 0, 0]}
    joints:
      - {theta: q, a: 0.3}
      - {theta: q, a: 0.3}
    actuated: [1]
    point: [0, 0, 0]
    turned: [0, 120 deg, 240 deg]
task: [x, y, yaw]
"""
# Two slides along z.
IN_ONE_LINE = """\
name: two
legs:
  - base: {xyz: [0.3, 0, 0]}
    joints:
      - {d: q, limits: [0, 1]}
      - {d: q, limits: [0, 1]}
      - {theta: q, a: 0.2}
    actuated: [1]
    point: [0.1, 0, 0]
    turned: [0, 120 deg, 240 deg]
task: position
"""


def refusal(text: str, folder: Path) -> str:
    """Why verification of the platform refuses a robot."""
    made = compile_parallel(read(text, folder))
    write_files(folder, made.files)
    with pytest.raises(ImmobileError) as refused:
        verify_parallel(made.module, folder, [])
    return str(refused.value)


def test_legs_that_do_not_reach_each_other(tmp_path: Path) -> None:
    told = refusal(APART, tmp_path)
    assert "all legs reach 0 of 80000 poses" in told
    assert "and without limits none of 4000 (leg 2 0): look at the legs' lengths" in told


def test_legs_that_limits_keep_apart(tmp_path: Path) -> None:
    told = refusal(LIMITED, tmp_path)
    assert "all legs reach 0 of 80000 poses" in told
    assert told.endswith(": look at the limits")


@pytest.mark.slow
def test_a_platform_that_its_drives_never_hold(tmp_path: Path) -> None:
    told = refusal(TURNING, tmp_path)
    assert told.startswith("at all 60 poses the platform can move while its drives are held")


def test_the_command_takes_it_for_a_mistake_in_the_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def refused(*_: object) -> ParallelReport:
        raise ImmobileError("the legs reach no pose")

    monkeypatch.setattr(compiler, "verified_parallel", refused)
    path = tmp_path / "two.yaml"
    path.write_text(TWO, encoding="utf-8")
    assert main([str(path), "--out", str(tmp_path / "out")]) == 2
    assert capsys.readouterr().err == f"{path}: the legs reach no pose\n"


def test_a_leg_whose_joints_depend_on_each_other_has_no_free_ones(tmp_path: Path) -> None:
    """Files of parallel robots have no `free`: it is not advised."""
    with pytest.raises(UnsolvedError) as refused:
        compile_parallel(read(IN_ONE_LINE, tmp_path))
    told = str(refused.value)
    assert told.startswith("legs 1, 2, 3: nearly no pose is in reach")
    assert "joints 1 and 2 slide along one direction" in told
    assert "free" not in told
