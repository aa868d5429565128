"""Poses whose solutions' hidden angles crowd: the general algorithm alone finds them all."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.runtime import c_runtime_files, runtime_files
from dhgen.runtime.python.calibration import NUMBERS
from dhgen.runtime.python.calibration import TURNED as TURNED_AT
from dhgen.targets.python.calibrated import kind_module
from dhgen.verify.calibrated import FleetArm, poses_of
from dhgen.verify.native import import_module
from tests.nominal.fleets import PLACED, compiled, kind, table_of, turned
from tests.structures import quick_first

if TYPE_CHECKING:
    from pathlib import Path

KR6 = "kuka_kr6_r900"
ARMS = {"KR6": KR6, "KR210": f"kuka_kr210{PLACED}"}
# Arm, errors of its table and their seed, joint values. Axes 2, 3 and 5 are nearly parallel, and
# two solutions' last angles differ by 1e-5 to 1e-4 rad, in two or four places of the circle.
POSES = """\
KR6 1e-4 1 -3.0367416471 0.58204166509 0.42963320822 -5.8943612868e-05 1.2171826033 -1.9252018154
KR6 1e-4 1 -2.9827452253 0.62020831592 0.61258269133 -5.2685097421e-06 1.2141159546 -1.9274251609
KR6 1e-4 1 -3.1154354829 0.53365419786 0.56258681418 -8.3534381051e-06 1.2137707124 -1.9751431222
KR6 1e-5 1 1.4749615826 -2.7212957298 -2.6089418094 3.1416004346 0.64241260184 -2.7254882106
KR6 1e-5 1 1.2045705117 1.4767840574 2.7431571225 3.1415927573 -1.2131031306 -0.045103847445
KR6 1e-5 2 -2.6762276217 -1.016033208 -2.8013165971 3.1416053437 -2.1591403153 -3.0183807286
KR6 1e-5 2 2.7399098349 -1.8386200644 2.4417840109 3.1416002566 -2.0953243469 -2.5778865616
KR6 1e-5 2 -2.5434005182 0.45145364555 -2.3581250843 3.1415995359 1.8953769842 -2.9284610014
KR210 1e-5 2 0.46798642928 -0.26874971482 -2.1484735605 3.1416040184 -2.2178208114 -2.3535649332
KR210 1e-5 2 2.3769863405 2.9114058018 -1.6130095522 3.1416124753 2.0763823798 -0.60518281995
KR210 1e-5 2 -1.5363753954 -0.28226281844 -2.1373295746 3.1415979115 0.56550595603 1.3007027466
"""
CASES = [
    (ARMS[arm], float(noise), int(seed), [float(number) for number in joints])
    for arm, noise, seed, *joints in map(str.split, POSES.splitlines())
]
MOVED = 12  # poses beside each of these


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where kinds are written, with the runtime beside them."""
    made = tmp_path_factory.mktemp("fleets")
    write_files(made, c_runtime_files())
    return made


@pytest.mark.parametrize(("name", "noise", "seed", "joints"), quick_first(CASES))
def test_all_are_found(
    name: str, noise: float, seed: int, joints: list[float], folder: Path
) -> None:
    """Those that made the pose, and those that the nominal arm's rows lead to."""
    table, upper = table_of(name, noise, seed), kind(name).module.name.upper()
    alone = FleetArm(compiled(folder, name, f"-D{upper}_PLAIN"), kind(name), table)
    near = FleetArm(compiled(folder, name), kind(name), table)
    source = np.random.default_rng(1)
    q = np.array([joints, *(joints + source.normal(0.0, 1e-6, (MOVED, 6)))])
    T = poses_of(kind(name), table, q)
    for each, pose, rows, others in zip(q, T, alone.batch(T)[0], near.batch(T)[0], strict=True):
        found, wanted = rows[~np.isnan(rows[:, 0])], others[~np.isnan(others[:, 0])]
        assert np.abs(poses_of(kind(name), table, found) - pose).max() < 1e-10
        assert turned(found, each).max(axis=1).min() < 1e-7
        assert turned(found[:, None], wanted[None]).max(axis=2).min(axis=0).max() < 1e-7


@pytest.mark.parametrize(("noise", "seed", "joints"), [pose[1:] for pose in CASES[:3:2]])
def test_all_are_found_in_python(
    noise: float, seed: int, joints: list[float], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In plain Python: a pose takes a while."""
    monkeypatch.setattr("numba.config.DISABLE_JIT", True)
    write_files(tmp_path, runtime_files())
    write_files(tmp_path, kind_module(kind(KR6)))
    made = import_module(tmp_path / f"{kind(KR6).module.name}.py")
    table, calls = table_of(KR6, noise, seed), vars(made)["_CALLS"]
    numbers, _ = calls["worked_out"](table)
    numbers[TURNED_AT - NUMBERS] = 1.0  # the nominal arm is nowhere near
    arm = calls["CalibratedArm"](table, numbers, calls)
    T = poses_of(kind(KR6), table, np.array([joints]))
    rows = arm.ik_batch(T)[0][0]
    found = rows[~np.isnan(rows[:, 0])]
    assert np.abs(poses_of(kind(KR6), table, found) - T).max() < 1e-10
    assert turned(found, np.array(joints)).max(axis=1).min() < 1e-7
    assert len(found) >= 4
