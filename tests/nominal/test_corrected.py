"""Calibrated twins of arms: with the nearest arm's rows they have the same solutions as without."""

from __future__ import annotations

import shutil
import subprocess
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.nominal.nominal import nominal_arm
from dhgen.robot.load import load_text
from dhgen.targets.reserved import RESERVED
from dhgen.verify.native import C_FLAGS, PORTABLE, c_compiler
from tests.compiling import library, written
from tests.nominal.fleets import assert_alike, count_alike
from tests.nominal.twins import SIX, coupled, seven, twin
from tests.structures import first_of

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.compiler import Compilation

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

POSES = 400


def compiled(text: str, folder: Path) -> Compilation:
    path = folder / "twin.yaml"
    path.write_text(text, encoding="utf-8")
    return written(path, folder)


@pytest.mark.parametrize(
    "text",
    first_of(
        [
            twin("puma560", 1e-4),
            coupled(twin("puma560", 1e-4)),
            seven("shoulder_missed"),
            twin("ur5e", 1e-4),
            twin("kuka_kr6_r900", 1e-4),
            seven("wrist_missed"),
            SIX,
        ],
        count=2,
    ),
)
def test_solutions_are_those_of_the_general_algorithm(text: str, tmp_path: Path) -> None:
    module = compiled(text, tmp_path).module
    assert module.nominal is not None
    plain = replace(PORTABLE, flags=(*PORTABLE.flags, f"-D{module.name.upper()}_PLAIN"))
    (tmp_path / "plain").mkdir()
    shutil.copytree(tmp_path, tmp_path / "plain", dirs_exist_ok=True, ignore=lambda *_: ["plain"])
    fast, general = library(module, tmp_path), library(module, tmp_path / "plain", plain)
    chain = module.chain
    q = np.random.default_rng(4).uniform(-np.pi, np.pi, (POSES, chain.dof))
    poses = numeric_arm(chain).pose(q)
    free = q[:, [number - 1 for number in chain.free]] if chain.free else None
    (found, status), (wanted, kinds) = fast.batch(poses, free), general.batch(poses, free)
    assert_alike((found, status), (wanted, kinds))
    assert count_alike(found, wanted) < 0.7 * POSES  # at least as many are solved in the other way


NAMED = """\
name: named
source: random
parameters: {near_a2: 0.4318, nearby: 0.15005, v1: 0.0203, h1: 0.4318, nearest_arm: 0.67183}
joints:
  - {theta: q, d: nearest_arm, a: 0.0001, alpha: 1.5708}
  - {theta: q, d: 0, a: near_a2, alpha: 0.0001}
  - {theta: q, d: nearby, a: v1, alpha: -1.5707}
  - {theta: q, d: h1, a: 0, alpha: 1.5709}
  - {theta: q, d: 0, a: 0.0001, alpha: -1.5708}
  - {theta: q, d: 0, a: 0, alpha: 0}
"""


@pytest.fixture(scope="module")
def named(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with what is made of that file."""
    folder = tmp_path_factory.mktemp("named")
    (folder / "named.yaml").write_text(NAMED, encoding="utf-8")
    assert written(folder / "named.yaml", folder).module.nominal is not None
    return folder


@pytest.mark.breadth
@pytest.mark.parametrize("flags", [(), ("-DNAMED_SCALAR",), ("-DNAMED_PLAIN",)])
def test_numbers_of_both_arms_have_names_of_their_own(flags: tuple[str, ...], named: Path) -> None:
    command = [str(c_compiler()), *C_FLAGS, "-Wshadow", *flags, "-c", "named.c", "-o", "named.o"]
    subprocess.run(command, cwd=named, check=True)


@pytest.mark.breadth
def test_arms_far_from_a_structure_have_no_nearest_one() -> None:
    """At errors of 3 mm hardly any pose of a UR5e is certain: that takes only time."""
    assert nominal_arm(build_chain(load_text(twin("ur5e", 3e-3), "twin.yaml")), RESERVED) is None
