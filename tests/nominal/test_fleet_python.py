"""Python whose table comes at run time: each arm of a kind has the rows that C has of its table."""

from __future__ import annotations

import pickle
import sys
from typing import TYPE_CHECKING, Any
from unittest.mock import patch

import numba
import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.errors import VerificationError
from dhgen.runtime import runtime_files
from dhgen.runtime.python.calibrate import ANOTHER_ARM, NO_MISS, NOT_FINITE, TAKEN
from dhgen.runtime.python.calibration import NUMBERS
from dhgen.runtime.python.calibration import TURNED as TURNED_AT
from dhgen.runtime.python.jit import COMPILED
from dhgen.status import HELD, Status
from dhgen.targets.c.calibrated import kind_files
from dhgen.targets.python.calibrated import kind_module
from dhgen.verify.calibrated import FleetArm, PythonArm, poses_of, verify_kind
from dhgen.verify.native import import_module
from dhgen.verify.verify import imported
from tests.nominal.fleets import (
    EACH,
    TURNED,
    assert_alike,
    compiled,
    kind,
    random_joints,
    table_of,
    turned,
)
from tests.nominal.test_fleet import singular_joints
from tests.nominal.twins import ROBOTS
from tests.structures import BREADTH, quick_first, those_in

if TYPE_CHECKING:
    from pathlib import Path
    from types import ModuleType

# numba takes ten seconds for a kind beside what all share. Compiled are a wrist and parallel axes,
# before a release also a wrist whose base and tool turn all axes, of a modified table: what others
# have of a nominal arm are fewer of the same formulas. They run in plain Python, where the general
# algorithm answers alone, a few poses a second.
OTHERS = ("ur5e", "kuka_kr6_r900", *TURNED)
COMPILED_SLOWLY = ("ur5e",)
COMPILED_TOO = [
    "puma560",
    *(
        pytest.param(name, marks=pytest.mark.slow if name in COMPILED_SLOWLY else BREADTH)
        for name in OTHERS
    ),
]
POSES = 200 if COMPILED else 2
CONFIG: Any = numba.config
KNOWN: dict[tuple[str, bool], ModuleType] = {}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where kinds are written, with the runtime beside them."""
    made = tmp_path_factory.mktemp("fleets")
    write_files(made, runtime_files())
    return made


def module(folder: Path, name: str, *, plain: bool = False) -> ModuleType:
    """The module of a kind."""
    if (name, plain) not in KNOWN:
        write_files(folder, kind_module(kind(name)))
        own = kind(name).module
        with patch.object(CONFIG, "DISABLE_JIT", new=plain or CONFIG.DISABLE_JIT):
            path = folder / f"{own.name}.py"
            KNOWN[name, plain] = import_module(path) if plain else imported(own, folder)
    return KNOWN[name, plain]


def both(
    folder: Path, name: str, table: np.ndarray, *, plain: bool = False
) -> tuple[PythonArm, FleetArm]:
    """An arm in both languages."""
    return (
        PythonArm(module(folder, name, plain=plain), table),
        FleetArm(compiled(folder, name), kind(name), table),
    )


@pytest.mark.parametrize("name", EACH)
def test_what_a_table_makes_of_an_arm_is_what_c_makes_of_it(name: str, folder: Path) -> None:
    size = max(1.0, kind(name).nominal.chain.size)
    for noise in (1e-6, 1e-4, 1e-3):
        python, c = both(folder, name, table_of(name, noise), plain=True)
        assert python.fault == c.fault == TAKEN
        np.testing.assert_allclose(python.numbers, c.numbers, rtol=0.0, atol=1e-12 * size)


@pytest.mark.slow
@pytest.mark.parametrize("noise", [1e-6, 1e-4, 1e-3])
@pytest.mark.parametrize("name", COMPILED_TOO)
def test_rows_are_those_of_c(name: str, noise: float, folder: Path) -> None:
    table, q = table_of(name, noise), random_joints(POSES)
    python, c = both(folder, name, table)
    T = poses_of(kind(name), table, q)
    for joints, pose, *found in zip(q, T, *python.batch(T), *c.batch(T), strict=True):
        rows, status, wanted, kinds = found
        np.testing.assert_array_equal(status, kinds)
        np.testing.assert_allclose(rows, wanted, rtol=0.0, atol=1e-7)
        held = rows[np.isin(status, HELD)]
        assert turned(held, joints).max(axis=1).min() < 1e-7
        missed = poses_of(kind(name), table, held) - pose
        assert np.abs(missed).max() < 1e-10 * max(1.0, kind(name).nominal.chain.size)


@pytest.mark.parametrize("name", those_in(TURNED[1:], OTHERS))
def test_rows_are_those_of_c_without_numba(name: str, folder: Path) -> None:
    table, q = table_of(name, 1e-4), random_joints(2)
    python, c = both(folder, name, table, plain=True)
    T = poses_of(kind(name), table, q)
    (rows, status), (wanted, kinds) = python.batch(T), c.batch(T)
    np.testing.assert_array_equal(status, kinds)
    np.testing.assert_allclose(rows, wanted, rtol=0.0, atol=1e-9)
    near, other = (each.nearest(T[0], q[0]) for each in (python, c))
    np.testing.assert_allclose(near, other, rtol=0.0, atol=1e-9)


@pytest.mark.skipif(not COMPILED, reason="in plain Python the general algorithm answers alone")
def test_rows_come_from_the_nominal_arm(folder: Path) -> None:
    """They are other numbers than those of the general algorithm alone, in the last digits."""
    table = table_of("puma560", 1e-5)
    calls = vars(module(folder, "puma560"))["_CALLS"]
    arm, _ = calls["worked_out"](table)
    far = arm.copy()
    far[TURNED_AT - NUMBERS] = 1.0  # the nominal arm is nowhere near
    T = poses_of(kind("puma560"), table, random_joints(200))
    (rows, status), (others, kinds) = (
        calls["CalibratedArm"](table, each, calls).ik_batch(T) for each in (arm, far)
    )
    assert_alike((rows, status), (others, kinds))
    alike = [np.array_equal(*each, equal_nan=True) for each in zip(rows, others, strict=True)]
    assert np.mean(alike) < 0.5


@pytest.mark.parametrize("name", COMPILED_TOO)
def test_forward_kinematics_jacobian_and_velocities(name: str, folder: Path) -> None:
    table, size = table_of(name, 1e-3), max(1.0, kind(name).nominal.chain.size)
    python, c = both(folder, name, table)
    q, twist = random_joints(20), np.array([0.1, -0.2, 0.3, 0.2, -0.1, 0.4])
    np.testing.assert_allclose(
        python.fk(q), poses_of(kind(name), table, q), rtol=0.0, atol=1e-13 * size
    )
    for joints, J in zip(q, python.jacobian(q), strict=True):
        np.testing.assert_allclose(J, c.jacobian(joints), rtol=0.0, atol=1e-13 * size)
        found, wanted = (each.joint_velocities(joints, twist) for each in (python, c))
        np.testing.assert_allclose(found, wanted, rtol=1e-9, atol=1e-11)


@pytest.mark.parametrize("name", COMPILED_TOO)
def test_singular_poses_are_complete_as_in_c(name: str, folder: Path) -> None:
    """What rounding leaves open there is the pose's: rows of one language solve it in the other."""
    table = table_of(name, 1e-4)
    python, c = both(folder, name, table)
    q = singular_joints(c, 10 if COMPILED else 1)
    for joints, pose in zip(q, poses_of(kind(name), table, q), strict=True):
        (rows, status), (others, kinds) = (each.ik(pose, joints) for each in (python, c))
        held, there = rows[np.isin(status, HELD)], others[np.isin(kinds, HELD)]
        assert turned(held, joints).max(axis=1).min() < 1e-4
        assert np.abs(poses_of(kind(name), table, held) - pose).max() < 1e-9
        for one, other in ((held, there), (there, held)):
            assert turned(one[:, None], other[None]).max(axis=2).min(axis=1).max() < 1e-3


def test_seeds_limits_and_poses_that_are_none(folder: Path) -> None:
    name, table = "puma560", table_of("puma560", 1e-4)
    python, c = both(folder, name, table)
    q = random_joints(20 if COMPILED else 2)
    T = poses_of(kind(name), table, q)
    for joints, pose in zip(q, T, strict=True):
        np.testing.assert_allclose(
            python.nearest(pose, joints), c.nearest(pose, joints), rtol=0.0, atol=1e-7
        )
        np.testing.assert_array_equal(python.ik(pose, joints)[1], c.ik(pose, joints)[1])
    spoiled, far = T[0].copy(), T[0].copy()
    spoiled[0, 0], far[0, 3] = np.nan, 100.0
    assert (python.ik(spoiled, q[0])[1] == Status.INVALID_POSE).all()
    assert (python.ik(far, q[0])[1] == Status.UNREACHABLE).all()
    made = module(folder, name)
    arm = made.calibrated(table)
    with pytest.raises(made.Unreachable, match="the pose is out of reach"):
        arm.ik(far)
    with pytest.raises(ValueError, match="T is not a valid pose: not finite, or not a right-"):
        arm.ik(spoiled)
    with pytest.raises(ValueError, match="q_seed must be finite"):
        arm.ik_all(T[0], [np.nan] * 6)
    with pytest.raises(ValueError, match="no branch 'left'"):
        arm.ik(T[0], branch="left")


OTHER, LARGE = "table is that of another arm: ", ": numbers above 1e+05 [rad, arm sizes] are no cal"
ENTRIES = {
    (1, 3, np.nan): ("table[1][3], alpha of row 2, is not finite: nan", ""),
    (0, 1, np.inf): ("table[0][1], d of row 1, is not finite: inf", ""),
    (2, 1, 0.35): (OTHER, "table[2][1], d of row 3: 0.35 m in place of 0.15005"),
    (3, 3, -1.2): (OTHER, "table[3][3], alpha of row 4: -1.2 rad in place of 1.57079633"),
    (2, 1, 1e300): (f"table[2][1], d of row 3, is 1e+300 m{LARGE}", ""),
    # parallel axes have no common normal
    (0, 3, 0.0): (OTHER, "table[0][3], alpha of row 1: 0 rad in place of 1.57079633"),
    # what the base, a zero or the tool would take up
    (0, 1, -1e300): (f"table[0][1], d of row 1, is -1e+300 m{LARGE}", ""),
    (4, 0, 1e300): (f"table[4][0], theta of row 5, is 1e+300 rad{LARGE}", ""),
    (5, 2, 1e300): (f"table[5][2], a of row 6, is 1e+300 m{LARGE}", ""),
}


@pytest.mark.parametrize("entry", ENTRIES, ids=str)
def test_tables_that_are_refused_say_which_number_it_is(
    entry: tuple[int, int, float], folder: Path
) -> None:
    table, (row, column, value) = table_of("puma560", 1e-4), entry
    table[row, column] = value
    python, c = both(folder, "puma560", table)
    assert python.fault == c.fault == (ANOTHER_ARM if np.isfinite(value) else NOT_FINITE)
    with pytest.raises(ValueError, match="table") as refused:
        module(folder, "puma560").calibrated(table)
    begins, ends = ENTRIES[entry]
    assert str(refused.value).startswith(begins)
    assert str(refused.value).endswith(ends)


def test_origins_of_another_arm_are_refused(folder: Path) -> None:
    """Also where numba compiles: what only compiled functions may call is not called."""
    with pytest.raises(ValueError, match="origins are those of another arm: its tool is up to"):
        module(folder, "puma560").calibrated_by_origins(np.zeros((6, 6)))
    with pytest.raises(ValueError, match=r"up to [\d.]+ rad and [\d.]+ m away"):
        module(folder, "puma560").calibrated_by_origins(np.zeros((6, 6)))


def test_tables_that_miss_nothing_say_which_axes_it_is(folder: Path) -> None:
    made, other = module(folder, "puma560"), module(folder, "ur5e", plain=True)
    python, c = both(folder, "puma560", np.array(made.NOMINAL))
    assert python.fault == c.fault == NO_MISS
    with pytest.raises(ValueError, match="in table axes 2, 3 and 4 are parallel to 1e-09, as"):
        other.calibrated(other.NOMINAL)
    with pytest.raises(ValueError, match="in table axes 4, 5 and 6 meet to 1e-09, as those of"):
        made.calibrated(made.NOMINAL)
    with pytest.raises(ValueError, match=r"table must have shape \(6, 4\), not \(5, 4\)"):
        made.calibrated(made.NOMINAL[:5])
    with pytest.raises(ValueError, match="table must hold real numbers"):
        made.calibrated([["a"] * 4] * 6)


def test_arms_are_printed_and_filled_by_lists(folder: Path) -> None:
    table = table_of("puma560", 1e-4)
    made = module(folder, "puma560")
    arm = made.calibrated(table.tolist())
    assert repr(arm).startswith(f"<arm of {made.__name__}, from the nominal one at most 0.00")
    assert 0.0 < arm.turned < 0.01
    assert 0.0 < arm.moved < 0.01
    kept = arm.numbers.copy()
    table[:] = 0.0
    np.testing.assert_array_equal(arm.numbers, kept)
    with pytest.raises(ValueError, match="read-only"):
        arm.table[0, 0] = 1.0
    again = made.calibrated(arm.table)
    np.testing.assert_array_equal(again.numbers, kept)


def test_the_program_of_the_readme(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = (ROBOTS.parent / "README.md").read_text("utf-8").split("### Many arms of one kind")[1]
    monkeypatch.setitem(sys.modules, "ur5e_fleet", module(folder, "ur5e", plain=True))
    names: dict[str, Any] = {}
    exec(text.split("```python\n")[1].split("```")[0], names)  # noqa: S102
    T = poses_of(kind("ur5e"), names["table"], np.array([[0.3, -0.8, 0.5, 1.0, 0.2, 0.1]]))
    np.testing.assert_allclose(names["T"], T[0], rtol=0.0, atol=1e-14)
    held = names["q"][np.isin(names["status"], HELD)]
    assert turned(held, np.array([0.3, -0.8, 0.5, 1.0, 0.2, 0.1])).max(axis=1).min() < 1e-9


def test_arms_are_pickled_as_their_tables(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made = module(folder, "puma560")
    monkeypatch.setitem(sys.modules, made.__name__, made)
    arm = made.calibrated(table_of("puma560", 1e-4))
    other = pickle.loads(pickle.dumps(arm))  # noqa: S301
    np.testing.assert_array_equal(other.numbers, arm.numbers)


def test_arrays_of_the_caller_s_and_other_numba_functions(folder: Path) -> None:
    made = module(folder, "puma560")
    arm = made.calibrated(table_of("puma560", 1e-4))
    T = arm.fk([0.3, -0.8, 0.5, 1.0, 0.2, 0.1])
    wanted, kinds = arm.ik_all(T)
    q, status = np.full((6, 16), 7.0).T, np.full(16, 9, np.uint8)  # of another layout
    held = arm.ik_into(T, q, status)
    assert held == np.isin(kinds, (Status.OK, Status.FREE_JOINT)).sum()
    np.testing.assert_array_equal(q, wanted)
    np.testing.assert_array_equal(status, kinds)
    with pytest.raises(ValueError, match=r"q must have shape \(16, 6\), not \(6, 16\)"):
        arm.ik_into(T, q.T, status)
    with pytest.raises(ValueError, match="status must be an array of uint8, not float64"):
        arm.ik_into(T, q, np.zeros(16))
    with pytest.raises(ValueError, match="q must be an array of float64, not float32"):
        arm.ik_into(T, q.astype(np.float32), status)
    with pytest.raises(ValueError, match="numbers must have shape"):
        made.ik_into(arm.numbers[:-1], T, q, status)
    if COMPILED:
        called_by_numba(made, arm, T)


def called_by_numba(made: Any, arm: Any, T: np.ndarray) -> None:
    """Numba functions call with and without a seed."""
    from numba import njit  # noqa: PLC0415  only where there is one

    ik_into, seed = made.ik_into, np.full(6, 0.1)

    @njit
    def solve(numbers: Any, T: Any, q: Any, status: Any, seed: Any) -> Any:
        return ik_into(numbers, T, q, status) + ik_into(numbers, T, q, status, seed)

    q, status = np.empty((16, 6)), np.empty(16, np.uint8)
    wanted, kinds = arm.ik_all(T, seed)
    solve(arm.numbers, T, q, status, seed)
    np.testing.assert_array_equal(q, wanted)
    np.testing.assert_array_equal(status, kinds)


def test_one_file_has_the_same_rows(
    folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In plain Python: it would compile the runtime that it holds once more."""
    table = table_of("puma560", 1e-4)
    python, _ = both(folder, "puma560", table)
    monkeypatch.setattr(CONFIG, "DISABLE_JIT", True)
    write_files(tmp_path, kind_module(kind("puma560"), single_file=True))
    alone = PythonArm(import_module(tmp_path / "puma560_fleet.py"), table)
    T = poses_of(kind("puma560"), table, random_joints(2))
    (rows, status), (wanted, kinds) = alone.batch(T), python.batch(T)
    np.testing.assert_array_equal(status, kinds)
    np.testing.assert_allclose(rows, wanted, rtol=0.0, atol=1e-9)


AXIS = "axis[i, k] = of[FACING + i] * P[4 * k + 2]"
WRONG = {
    "fk": ("puma560_fleet.py", "facing=(1.0, 1.0,", "facing=(-1.0, 1.0,", "fk is off by"),
    "table": ("puma560_fleet.py", "meeting=(3,)", "meeting=()", "takes the nominal table"),
    "rates": ("dhgen_runtime/serial.py", AXIS, f"{AXIS} * 1.001", "the Jacobian is off by"),
    "row": (
        "dhgen_runtime/numerical/solutions.py",
        "take(q[row], joints)",
        "take(q[row], joints + 1e-8)",
        "a row's pose is off by",
    ),
}


@pytest.mark.parametrize("what", quick_first(WRONG, count=2))
def test_verification_sees_what_is_wrong(
    what: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In plain Python, where what is wrong is seen sooner."""
    monkeypatch.setattr(CONFIG, "DISABLE_JIT", True)
    monkeypatch.setattr("dhgen.verify.calibrated.FEW", 1)
    own, (file, before, after, told) = kind("puma560"), WRONG[what]
    made = {**runtime_files(), **kind_files(own), **kind_module(own)}
    assert made[file].count(before) == 1
    write_files(tmp_path, {**made, file: made[file].replace(before, after)})
    with pytest.raises(VerificationError, match=told):
        verify_kind(own, tmp_path)
