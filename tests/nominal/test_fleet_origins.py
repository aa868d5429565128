"""Arms of a kind that are given by joints' frames, as drivers and URDFs give them."""

from __future__ import annotations

import math
import pickle
import re
import sys
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.calibration.calibrate import calibrate
from dhgen.calibration.read import read_calibration
from dhgen.oracle.forward import forward
from dhgen.runtime import c_runtime_files, runtime_files
from dhgen.runtime.python.calibrate import ANOTHER_ARM, NO_MISS, NOT_FINITE, TAKEN
from dhgen.targets.python.calibrated import kind_module
from dhgen.verify.calibrated import FleetArm, PythonArm, poses_of
from dhgen.verify.native import import_module
from tests.nominal.fleets import (
    TURNED,
    assert_alike,
    compiled,
    file_of,
    kind,
    random_joints,
    screw,
    table_of,
    turned,
)
from tests.nominal.twins import ROBOTS

if TYPE_CHECKING:
    from pathlib import Path
    from types import ModuleType

FILE = ROBOTS.parent / "tests" / "calibration" / "ur5e_calibration.yaml"  # of a driver
POSES = 300


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where kinds are written, with the runtime beside them."""
    made = tmp_path_factory.mktemp("origins")
    write_files(made, {**c_runtime_files(), **runtime_files()})
    return made


@pytest.fixture(scope="module")
def ur5e(folder: Path) -> ModuleType:
    """The module of a fleet in plain Python."""
    write_files(folder, kind_module(kind("ur5e")))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("numba.config.DISABLE_JIT", True)
        return import_module(folder / "ur5e_fleet.py")


def origin_of(T: np.ndarray) -> list[float]:
    """x, y, z, roll, pitch, yaw of a transform whose z axis is not turned to x."""
    R = T[:3, :3]
    pitch = math.atan2(-R[2, 0], math.hypot(R[2, 1], R[2, 2]))
    return [*T[:3, 3], math.atan2(R[2, 1], R[2, 2]), pitch, math.atan2(R[1, 0], R[0, 0])]


def origins_of(name: str, table: np.ndarray) -> np.ndarray:
    """Frames of a table's joints, each slid along its axis, joint values as they are."""
    source, behind, found = np.random.default_rng(12), np.eye(4), []
    for theta, d, a, alpha in table:
        z, x = screw(2, theta, d), screw(0, alpha, a)
        slide = screw(2, 0.0, source.uniform(-0.3, 0.3))
        is_modified = kind(name).table.convention == "modified"
        before, after = (x @ z, np.eye(4)) if is_modified else (z, x)
        found.append(origin_of(behind @ before @ slide))
        behind = np.linalg.inv(slide) @ after
    return np.array([*found, origin_of(behind)])


def read_origins() -> np.ndarray:
    """The numbers of the driver's file."""
    return np.array(read_calibration(FILE).rows)


def poses(name: str, origins: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Forward kinematics as a URDF has it: each origin, then the joint's turn about z."""
    lower = np.array([[0.0, 0.0, 0.0, 1.0]])
    base, tool = (
        np.concatenate([np.reshape(each, (3, 4)), lower])
        for each in (kind(name).table.base, kind(name).table.tool)
    )
    found = []
    for values in q:
        T = base
        for number, (x, y, z, roll, pitch, yaw) in enumerate(origins):
            place = np.eye(4)
            place[:3, 3] = x, y, z
            T = T @ place @ screw(2, yaw, 0.0) @ screw(1, pitch, 0.0) @ screw(0, roll, 0.0)
            if number < len(values):
                sign = kind(name).nominal.chain.joints[number].sign
                T = T @ screw(2, sign * values[number], 0.0)
        found.append(T @ tool)
    return np.array(found)


@pytest.mark.parametrize("name", TURNED)
def test_frames_of_a_table_make_the_arm_of_the_table(name: str, folder: Path) -> None:
    """Signs, base and tool count as they do there, wherever on their axes frames stand."""
    table, q = table_of(name, 1e-4), random_joints(POSES)
    origins, library = origins_of(name, table), compiled(folder, name)
    arm, own = FleetArm(library, kind(name), origins), FleetArm(library, kind(name), table)
    assert arm.fault == own.fault == TAKEN
    T = poses_of(kind(name), table, q)
    np.testing.assert_allclose(poses(name, origins, q), T, rtol=0.0, atol=1e-13)
    np.testing.assert_allclose([arm.fk(each) for each in q], T, rtol=0.0, atol=1e-13)
    for told in ("turned", "moved"):  # bounds, which take up the errors in another order
        assert getattr(arm.members, told) == pytest.approx(getattr(own.members, told), rel=0.03)
    assert_alike(arm.batch(T), own.batch(T))


def test_a_driver_s_file(folder: Path) -> None:
    """All solutions of the arm that it is of: those of the general algorithm alone."""
    origins, q = np.vstack([read_origins(), np.zeros(6)]), random_joints(POSES)
    arm, plain = (
        FleetArm(library, kind("ur5e"), origins)
        for library in (compiled(folder, "ur5e"), compiled(folder, "ur5e", "-DUR5E_FLEET_PLAIN"))
    )
    assert arm.fault == TAKEN
    T = poses("ur5e", origins, q)
    rows, status = arm.batch(T)
    assert_alike((rows, status), plain.batch(T))
    for joints, each in zip(q, rows, strict=True):
        solutions = each[~np.isnan(each[:, 0])]
        assert turned(solutions, joints).max(axis=1).min() < 1e-7
    held = rows[~np.isnan(rows[..., 0])]
    wanted = np.repeat(T, (~np.isnan(rows[..., 0])).sum(axis=1), axis=0)
    np.testing.assert_allclose(poses("ur5e", origins, held), wanted, rtol=0.0, atol=1e-10)
    made = calibrate(file_of("ur5e").robot, read_calibration(FILE))
    np.testing.assert_allclose(forward(made.robot, q), T, rtol=0.0, atol=1e-9)


def test_python_and_its_arms(
    folder: Path, ur5e: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    six = read_origins()
    seven = np.vstack([six, np.zeros(6)])
    arm = ur5e.calibrated_by_origins(six.tolist())
    c = FleetArm(compiled(folder, "ur5e"), kind("ur5e"), seven)
    np.testing.assert_allclose(PythonArm(ur5e, seven).numbers, c.numbers, rtol=0.0, atol=1e-12)
    np.testing.assert_array_equal(ur5e.calibrated_by_origins(seven).numbers, arm.numbers)
    assert arm.table is None
    np.testing.assert_array_equal(arm.origins, seven)
    assert ur5e.calibrated(table_of("ur5e", 1e-4)).origins is None
    with pytest.raises(ValueError, match="read-only"):
        arm.origins[0, 0] = 1.0
    monkeypatch.setitem(sys.modules, ur5e.__name__, ur5e)
    other = pickle.loads(pickle.dumps(arm))  # noqa: S301
    np.testing.assert_array_equal(other.numbers, arm.numbers)
    q = np.array([0.3, -0.8, 0.5, 1.0, 0.2, 0.1])
    rows, _ = arm.ik_all(poses("ur5e", seven, q[None])[0])
    assert turned(rows[~np.isnan(rows[:, 0])], q).max(axis=1).min() < 1e-9


REFUSED = {
    (2, 4, math.nan): ("origins[2][4], pitch of joint 3, is not finite: nan", NOT_FINITE),
    (6, 0, math.inf): (
        "origins[6][0], x of the frame behind the last joint, is not finite: inf",
        NOT_FINITE,
    ),
    (1, 2, 1e300): ("origins[1][2], z of joint 2, is 1e+300 m: numbers above 1e+05", ANOTHER_ARM),
    (2, 0, -0.6): ("origins are those of another arm: its tool is up to ", ANOTHER_ARM),
}


@pytest.mark.parametrize("entry", REFUSED, ids=str)
def test_origins_that_are_refused_say_which_it_is(
    entry: tuple[int, int, float], folder: Path, ur5e: ModuleType
) -> None:
    origins, (row, column, value) = np.vstack([read_origins(), np.zeros(6)]), entry
    origins[row, column] = value
    begins, said = REFUSED[entry]
    assert FleetArm(compiled(folder, "ur5e"), kind("ur5e"), origins).fault == said
    with pytest.raises(ValueError, match="origins") as refused:
        ur5e.calibrated_by_origins(origins)
    assert str(refused.value).startswith(begins)
    if "another arm" in begins:  # link 2 is 0.175 m longer than that of the file
        ends = (
            r"origins\[2\]: joint 3 is 0\.00\d+ rad and 0\.17 m from where the nominal arm has it"
        )
        assert re.search(f"{ends}, seen from joint 2$", str(refused.value))


def test_origins_that_miss_nothing(ur5e: ModuleType, folder: Path) -> None:
    origins = origins_of("ur5e", np.array(kind("ur5e").table.rows))
    assert FleetArm(compiled(folder, "ur5e"), kind("ur5e"), origins).fault == NO_MISS
    with pytest.raises(ValueError, match="in origins axes 2, 3 and 4 are parallel to 1e-09, as"):
        ur5e.calibrated_by_origins(origins)
    with pytest.raises(ValueError, match=r"must have shape \(7, 6\) or \(6, 6\), not \(5, 6\)"):
        ur5e.calibrated_by_origins(origins[:5])
    with pytest.raises(ValueError, match="origins must hold real numbers"):
        ur5e.calibrated_by_origins([["a"] * 6] * 7)


def test_the_program_of_the_readme(
    ur5e: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = (ROBOTS.parent / "README.md").read_text("utf-8").split("### Many arms of one kind")[1]
    (tmp_path / "calibration.yaml").write_bytes(FILE.read_bytes())
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(sys.modules, "ur5e_fleet", ur5e)
    names: dict[str, Any] = {}
    exec(text.split("```python\n")[2].split("```")[0], names)  # noqa: S102
    np.testing.assert_array_equal(names["arm"].origins[:6], read_origins())
