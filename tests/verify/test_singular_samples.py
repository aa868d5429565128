"""Verification comes to the poses where an arm is singular, whatever its offsets are."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING

import numba
import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.compiler import verified
from dhgen.errors import VerificationError
from dhgen.kinematics.build import build_chain
from dhgen.oracle.arm import arm, arm_size
from dhgen.survey.singular import task_jacobian
from dhgen.verify.languages import Languages
from dhgen.verify.samples import NEAR, Sample, samples
from dhgen.verify.verify import verify
from tests.compiling import compile_file, solvers_of
from tests.robots.cases import ROBOTS, robot
from tests.targets.made import robot_path

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.kinematics.chain import Chain

COUNT = 30
ON_THEM = {"right angles", "at joint limits", "singular", "nearly singular"}  # joints on limits


def sample_of(name: str, kind: str) -> np.ndarray:
    (found,) = [s.q for s in samples(build_chain(robot(name)), COUNT) if s.name == kind]
    return found


@pytest.mark.parametrize(
    ("name", "joints"),
    [
        ("puma560", (2, 3, 5)),
        ("ur5", (2, 3, 4, 5)),
        ("kuka_iiwa14", (2, 4, 6)),
        ("kuka_iiwa14_arm_angle", (2, 4, 6)),
        ("stanford", (2, 5)),
        ("scara", (2,)),
        ("scorbot_pointing", (3,)),
        ("planar_rr", (2,)),
    ],
)
def test_they_are_singular(name: str, joints: tuple[int, ...]) -> None:
    """By the survey's own model; a little beside they are so by one joint's value each."""
    arms = robot(name)
    exact, beside = sample_of(name, "singular"), sample_of(name, "nearly singular")
    J = task_jacobian(arm(arms).divided_by(arm_size(arms)), arms, exact)
    assert np.linalg.svd(J, compute_uv=False)[..., -1].max() < 1e-9
    moved = np.abs(beside[:, None] - exact).max(axis=2).min(axis=1)
    kind = moved[:, None] / np.array(NEAR)
    assert np.count_nonzero(np.abs(kind - 1.0).min(axis=1) < 1e-4) == len(exact)
    nearest = np.abs(beside[:, None] - exact).sum(axis=2).argmin(axis=1)
    away = np.abs(beside - exact[nearest])
    assert {joint + 1 for joint in away.argmax(axis=1)} == set(joints)


def test_arms_that_are_nowhere_singular_have_none() -> None:
    assert not [s for s in samples(build_chain(robot("cartesian")), COUNT) if "singular" in s.name]


@pytest.fixture
def interpreted(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(numba.config, "DISABLE_JIT", True)
    monkeypatch.setattr("dhgen.verify.verify.COUNT", COUNT)


@pytest.mark.slow
@pytest.mark.usefixtures("interpreted")
def test_a_stretched_arm_that_is_said_to_be_out_of_reach(tmp_path: Path) -> None:
    """It is stretched at no right angle: nothing but the singular samples comes there."""
    compilation = compile_file(ROBOTS / "puma_arm.yaml")
    shorter = set()
    for file, text in compilation.files.items():
        # where the elbow is to end: inside of where its links are stretched
        short = re.sub(r"(boundary3 =) [\d.e-]+", r"\1 -1e-12", text)
        write_files(tmp_path, {file: short})
        shorter |= {file} if short != text else set()
    assert shorter == {"puma_arm.py", "puma_arm.c"}
    with pytest.raises(VerificationError, match="puma_arm, singular, q = "):
        verify(compilation.module, tmp_path)


@pytest.mark.breadth
@pytest.mark.usefixtures("interpreted")
@pytest.mark.parametrize("name", ["folding_7r", "folding_7r_arm_angle"])
def test_a_hand_that_folds_back_into_the_shoulder(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Beside the fold next to nothing is left of the distance from which the elbow is known.

    Batches are the same poses once more, and in plain Python take as long as all the rest.
    """
    monkeypatch.setattr(Languages, "batch", lambda *_: None)
    report = verified(solvers_of(robot_path(name)))
    assert report.poses > 5 * COUNT
    assert report.residual < 1e-11


def samples_on_limits(chain: Chain, count: int) -> tuple[Sample, ...]:
    """As many as there always are of the sorts that come there, and a few others."""
    return tuple(
        each if each.name in ON_THEM else replace(each, q=each.q[:COUNT])
        for each in samples(chain, count)
    )


@pytest.mark.breadth
@pytest.mark.parametrize("name", ["stretched_elbow", "one_sided", "remote_centre"])
def test_limits_at_singular_places_refuse_no_arm(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Joints that stand on their limits there, and joint values that are beyond to begin with.

    Without batches, as above.
    """
    monkeypatch.setattr(numba.config, "DISABLE_JIT", True)
    monkeypatch.setattr("dhgen.verify.verify.samples", samples_on_limits)
    monkeypatch.setattr(Languages, "batch", lambda *_: None)
    report = verified(solvers_of(robot_path(name)))
    assert report.residual < 1e-11
