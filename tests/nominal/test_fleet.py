"""C whose table comes at run time: each arm of a kind has the solutions of its own table."""

from __future__ import annotations

import ctypes
import re
import subprocess
from dataclasses import replace
from typing import TYPE_CHECKING

import numba
import numpy as np
import pytest

from dhgen.atomic_write import write_files
from dhgen.calibrated import kind_of
from dhgen.errors import UnsolvedError, VerificationError
from dhgen.method import Method
from dhgen.oracle.forward import forward
from dhgen.robot.load import load_text
from dhgen.robot.task import TaskKind
from dhgen.robot_files import RobotFile
from dhgen.runtime import c_runtime_files, runtime_files
from dhgen.runtime.python.calibrate import ANOTHER_ARM, NO_MISS, NOT_FINITE, TAKEN
from dhgen.status import HELD, Status
from dhgen.targets.c.calibrated import kind_files
from dhgen.targets.python.calibrated import kind_module
from dhgen.targets.reserved import RESERVED
from dhgen.verify.calibrated import Calibration, FleetArm, poses_of, verify_kind
from dhgen.verify.native import C_FLAGS, PORTABLE, c_compiler, compile_solver
from tests.compiling import compile_file, library, module_of, worked_out_once, written
from tests.nominal.fleets import (
    EACH,
    NAMES,
    THOUSAND,
    TURNED,
    assert_alike,
    compiled,
    count_alike,
    file_of,
    kind,
    random_joints,
    table_of,
    turned,
)
from tests.nominal.twins import ROBOTS, twin
from tests.structures import first_of, quick_first

if TYPE_CHECKING:
    from pathlib import Path


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where kinds' C is written, with the runtime beside it."""
    made = tmp_path_factory.mktemp("fleets")
    write_files(made, c_runtime_files())
    return made


@pytest.mark.parametrize("noise", [1e-6, 1e-4, 1e-3])
@pytest.mark.parametrize("name", EACH)
def test_rows_are_all_solutions_of_the_table(name: str, noise: float, folder: Path) -> None:
    """Without the nominal arm's rows the general algorithm answers alone, with a certificate."""
    table, q = table_of(name, noise), random_joints(300)
    fleet, upper = compiled(folder, name), kind(name).module.name.upper()
    arm, plain = (
        FleetArm(library, kind(name), table)
        for library in (fleet, compiled(folder, name, f"-D{upper}_PLAIN"))
    )
    assert arm.fault == TAKEN
    T = poses_of(kind(name), table, q)
    rows, status = arm.batch(T)
    wanted, kinds = plain.batch(T)
    assert_alike((rows, status), (wanted, kinds))
    assert noise > 1e-4 or count_alike(rows, wanted) < 0.7 * len(q)  # others come from nominal rows
    for joints, pose, each in zip(q, T, rows, strict=True):
        solutions = each[~np.isnan(each[:, 0])]
        assert turned(solutions, joints).max(axis=1).min() < 1e-7
        missed = poses_of(kind(name), table, solutions) - pose
        assert np.abs(missed).max() < 1e-10 * max(1.0, kind(name).nominal.chain.size)


@pytest.mark.parametrize("name", EACH)
def test_forward_kinematics_and_jacobian(name: str, folder: Path) -> None:
    table, step = table_of(name, 1e-3), 1e-6
    arm = FleetArm(compiled(folder, name), kind(name), table)
    size = max(1.0, kind(name).nominal.chain.size)
    for q in random_joints(20):
        T = poses_of(kind(name), table, q[None])[0]
        np.testing.assert_allclose(arm.fk(q), T, rtol=0.0, atol=1e-13 * size)
        J = arm.jacobian(q)
        ahead, back = (poses_of(kind(name), table, q + s * np.eye(6)) for s in (step, -step))
        rates = (ahead - back) / (2.0 * step)
        spin = rates[:, :3, :3] @ T[:3, :3].T
        expected = np.concatenate(
            [rates[:, :3, 3].T, [spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0]]]
        )
        np.testing.assert_allclose(J, expected, rtol=0.0, atol=1e-8 * size)
        twist = J @ np.array([0.1, -0.2, 0.3, 0.2, -0.1, 0.4])
        found = arm.joint_velocities(q, twist)
        if np.linalg.cond(J / np.array([size] * 3 + [1.0] * 3)[:, None]) < 50.0:
            np.testing.assert_allclose(found, [0.1, -0.2, 0.3, 0.2, -0.1, 0.4], atol=1e-8)


@pytest.mark.parametrize("name", EACH)
def test_seeds_and_single_poses(name: str, folder: Path) -> None:
    table = table_of(name, 1e-4)
    arm, q = FleetArm(compiled(folder, name), kind(name), table), random_joints(40)
    T = poses_of(kind(name), table, q)
    rows, status = arm.batch(T)
    for joints, pose, each, kinds in zip(q, T, rows, status, strict=True):
        alone, said = arm.ik(pose, np.zeros(6))
        np.testing.assert_array_equal(said, kinds)
        np.testing.assert_array_equal(alone, each)
        inside = each[np.isin(kinds, [Status.OK, Status.FREE_JOINT])]
        if (turned(inside, joints).max(axis=1, initial=0.0) < 1e-7).any():
            near = arm.nearest(pose, joints + 1e-3)
            np.testing.assert_allclose(near, joints, rtol=0.0, atol=1e-7)
    spoiled = T[0].copy()
    spoiled[0, 0] = np.nan
    assert (arm.ik(spoiled, np.zeros(6))[1] == Status.INVALID_POSE).all()
    far = T[0].copy()
    far[:3, 3] += 10.0 * kind(name).nominal.chain.size
    assert (arm.ik(far, np.zeros(6))[1] == Status.UNREACHABLE).all()


def singular_joints(arm: FleetArm, count: int) -> np.ndarray:
    """Joint values at which the Jacobian is singular, by halving intervals of one joint."""
    source = np.random.default_rng(6)
    found: list[np.ndarray] = []
    while len(found) < count:
        q, joint = source.uniform(-np.pi, np.pi, 6), int(source.integers(1, 5))

        def determinant(x: float, q: np.ndarray = q, joint: int = joint) -> float:
            q[joint] = x
            return float(np.linalg.det(arm.jacobian(q)))

        low, high = -0.4, 0.4
        if determinant(low) * determinant(high) > 0.0:
            continue
        for _ in range(60):
            middle = 0.5 * (low + high)
            if determinant(middle) * determinant(low) > 0.0:
                low = middle
            else:
                high = middle
        determinant(low)
        found.append(q)
    return np.array(found)


@pytest.mark.parametrize("name", EACH)
def test_singular_poses_keep_their_solution(name: str, folder: Path) -> None:
    """Where branches meet one row holds the solution, as far as the pose tells joint values."""
    table = table_of(name, 1e-4)
    arm = FleetArm(compiled(folder, name), kind(name), table)
    q = singular_joints(arm, 20)
    T = poses_of(kind(name), table, q)
    for joints, pose in zip(q, T, strict=True):
        rows, status = arm.ik(pose, joints)
        held = rows[~np.isnan(rows[:, 0])]
        assert np.isin(status, HELD).any()
        assert turned(held, joints).max(axis=1).min() < 1e-4
        assert np.abs(poses_of(kind(name), table, held) - pose).max() < 1e-9


@pytest.mark.parametrize("noise", [1e-5, 1e-3])
@pytest.mark.parametrize("name", EACH)
def test_the_nominal_arm_is_no_farther_than_said(name: str, noise: float, folder: Path) -> None:
    table, nominal = table_of(name, noise), np.array(kind(name).table.rows)
    arm = FleetArm(compiled(folder, name), kind(name), table)
    numbers = arm.members
    left, right = (
        np.vstack([np.reshape(side, (3, 4)), [0.0, 0.0, 0.0, 1.0]])
        for side in (numbers.left, numbers.right)
    )
    signs = np.array([joint.sign for joint in kind(name).nominal.chain.joints])
    q = random_joints(2000)
    others = q + signs * np.array(numbers.more)
    T = left @ poses_of(kind(name), table, q) @ right
    N = poses_of(kind(name), nominal, others)
    moved = np.linalg.norm(T[:, :3, 3] - N[:, :3, 3], axis=1).max()
    chord = np.linalg.norm(T[:, :3, :3] - N[:, :3, :3], axis=(1, 2)).max() / np.sqrt(2.0)
    angle = 2.0 * np.arcsin(0.5 * chord)
    assert 0.2 * numbers.turned < angle <= numbers.turned
    assert 0.1 * numbers.moved < moved <= numbers.moved


def test_angles_of_an_arm_know_no_unit_of_lengths(folder: Path) -> None:
    metres, millimetres = (
        FleetArm(compiled(folder, name), kind(name), table_of(name, 1e-9)).members
        for name in ("puma560", f"puma560{THOUSAND}")
    )
    assert millimetres.turned == pytest.approx(metres.turned, rel=1e-6)
    assert millimetres.moved == pytest.approx(1000.0 * metres.moved, rel=1e-6)


def test_tables_that_are_not_taken(folder: Path) -> None:
    name = "puma560"
    library, nominal = compiled(folder, name), np.array(kind(name).table.rows)
    assert FleetArm(library, kind(name), nominal).fault == NO_MISS
    longer = nominal.copy()
    longer[1, 2] += 1e-3  # the wrist still has one centre: that is another closed form
    assert FleetArm(library, kind(name), longer).fault == NO_MISS
    longer[4, 2] += 1e-4
    assert FleetArm(library, kind(name), longer).fault == TAKEN
    other = table_of(name, 1e-4)
    other[2, 1] += 0.2
    assert FleetArm(library, kind(name), other).fault == ANOTHER_ARM
    other[2, 1] = np.nan
    assert FleetArm(library, kind(name), other).fault == NOT_FINITE


def test_arms_that_are_not_taken_have_their_pose(folder: Path) -> None:
    """Solutions may be missing, but none is another arm's."""
    name, q = "puma560", random_joints(20)
    library, nominal = compiled(folder, name), np.array(kind(name).table.rows)
    for table, said in ((nominal, NO_MISS), (nominal + 0.3, ANOTHER_ARM)):
        arm = FleetArm(library, kind(name), table)
        assert arm.fault == said
        T = poses_of(kind(name), table, q)
        np.testing.assert_allclose([arm.fk(each) for each in q], T, rtol=0.0, atol=1e-13)
        for pose, rows in zip(T, arm.batch(T)[0], strict=True):
            held = rows[~np.isnan(rows[:, 0])]
            missed = np.abs(poses_of(kind(name), table, held) - pose)
            assert missed.max(initial=0.0) < 1e-9


def test_a_table_that_is_not_finite_leaves_nothing_behind(folder: Path) -> None:
    name, q = "puma560", random_joints(5)
    table = table_of(name, 1e-4)
    T = poses_of(kind(name), table, q)
    table[5, 3] = np.inf
    arm = FleetArm(compiled(folder, name), kind(name), table)
    assert arm.fault == NOT_FINITE
    assert np.isnan(arm.numbers).all()
    assert np.isnan(arm.fk(q[0])[:3]).all()
    rows, status = arm.batch(T)
    assert np.isnan(rows).all()
    assert (status == Status.UNREACHABLE).all()
    assert np.isnan(arm.nearest(T[0], q[0])).all()


@pytest.mark.parametrize("name", TURNED)
def test_expected_poses_are_those_of_the_robot_file(name: str) -> None:
    q, size = random_joints(50), kind(name).nominal.chain.size
    T = poses_of(kind(name), np.array(kind(name).table.rows), q)
    np.testing.assert_allclose(T, forward(file_of(name).robot, q), rtol=0.0, atol=1e-14 * size)


# Each compiles an arm for its table. One for parallel axes and one for a wrist, one nearly as the
# data sheet says and one far off: that rows are all solutions is asked of all arms above.
TABLES = [("ur5e", 1e-3), ("puma560", 1e-4)]
FURTHER_TABLES = [
    *(("ur5e", 1e-4), ("puma560", 1e-3)),
    *(("kuka_kr6_r900", noise) for noise in (1e-4, 1e-3)),
]


@pytest.mark.slow  # compiles the general algorithm for the table, too
@pytest.mark.parametrize(("name", "noise"), first_of([*TABLES, *FURTHER_TABLES], count=2))
def test_rows_are_those_of_a_module_of_the_table(name: str, noise: float, tmp_path: Path) -> None:
    """Of a kind whose file is the data sheet's table alone, as twins are."""
    for stem, error in (("nominal", 0.0), ("own", noise)):
        text = twin(name, error).replace(f"name: twin_{name}", f"name: {stem}")
        (tmp_path / f"{stem}.yaml").write_text(text, encoding="utf-8")
    own = library(written(tmp_path / "own.yaml", tmp_path).module, tmp_path)
    file = RobotFile.read(tmp_path / "nominal.yaml")
    fleet = kind_of(file.robot, module_of(file.path), RESERVED)
    write_files(tmp_path, kind_files(fleet))
    made = compile_solver(tmp_path / "nominal_fleet.c", tmp_path, "nominal_fleet", 6, 16, 0)
    assert made is not None
    table = np.array(module_of(tmp_path / "own.yaml").links.rows)
    arm = FleetArm(made.library, fleet, table)
    T = poses_of(fleet, table, random_joints(500))
    rows, status = arm.batch(T)
    wanted, kinds = own.batch(T)
    assert_alike((rows, status), (wanted, kinds))


def test_the_structure_in_python_is_that_in_c(folder: Path, tmp_path: Path) -> None:
    compiled(folder, "puma560")
    names = [name for name, *_ in Calibration._fields_]
    told = "".join(f"TOLD(offsetof(dhgen_calibration, {name}));" for name in names)
    text = f"""\
#include <stdio.h>
#include <stddef.h>
#include "dhgen/calibration.h"
#define TOLD(number) printf("%d ", (int)(number))
int main(void) {{ {told} TOLD(sizeof(dhgen_calibration)); return 0; }}
"""
    (tmp_path / "sizes.c").write_text(text, encoding="utf-8")
    said = run_program([f"-I{folder}", "sizes.c"], tmp_path)
    expected = [*(getattr(Calibration, name).offset for name in names), ctypes.sizeof(Calibration)]
    assert said.split() == [str(number) for number in expected]


def test_the_program_of_the_readme(folder: Path, tmp_path: Path) -> None:
    text = (ROBOTS.parent / "README.md").read_text("utf-8").split("### Many arms of one kind")[1]
    (tmp_path / "arm.c").write_text(text.split("```c\n")[1].split("```")[0], encoding="utf-8")
    library, place = compiled(folder, "ur5e", "-DUR5E_FLEET_PLAIN"), folder / "ur5e_fleet.c"
    said = run_program([f"-I{folder}", "-O1", "arm.c", str(place)], tmp_path)
    steps = 1e-4 * (np.arange(24) % 5 - 2.0)
    table = np.array(kind("ur5e").table.rows) + steps.reshape(6, 4)
    q = np.array([[0.3, -0.8, 0.5, 1.0, 0.2, 0.1]])
    arm = FleetArm(library, kind("ur5e"), table)
    rows, status = arm.ik(poses_of(kind("ur5e"), table, q)[0], np.zeros(6))
    assert turned(rows[np.isin(status, HELD)], q).max(axis=1).min() < 1e-9
    assert said == f"{np.isin(status, HELD).sum()} solutions\n"


def run_program(arguments: list[str], folder: Path) -> str:
    """What a program in C says."""
    command = [str(c_compiler()), *C_FLAGS, *arguments, "-o", "program", "-lm"]
    subprocess.run(command, cwd=folder, check=True)
    done = subprocess.run(["./program"], cwd=folder, check=True, capture_output=True, text=True)
    return done.stdout


@pytest.mark.parametrize("single_file", quick_first([False, True]))
def test_no_warnings_and_several_kinds_in_one_program(*, single_file: bool, tmp_path: Path) -> None:
    if not single_file:
        write_files(tmp_path, c_runtime_files())
    for name in NAMES[:2]:
        write_files(tmp_path, kind_files(kind(name), single_file=single_file))
    text = "".join(f'#include "{kind(name).module.name}.h"\n' for name in NAMES[:2])
    (tmp_path / "main.c").write_text(f"{text}int main(void) {{ return 0; }}\n", encoding="utf-8")
    sources = ["main.c", *(f"{kind(name).module.name}.c" for name in NAMES[:2])]
    command = [str(c_compiler()), *C_FLAGS, "-Wshadow", "-Wdouble-promotion", "-O0"]
    subprocess.run([*command, *sources, "-o", "program", "-lm"], cwd=tmp_path, check=True)


def test_its_own_runtime_and_the_shared_one(folder: Path) -> None:
    name, table = "puma560", table_of("puma560", 1e-4)
    module = kind(name).module
    alone = compile_solver(folder / f"{module.name}.c", folder, module.name, 6, 16, 0, PORTABLE)
    assert alone is not None
    arm = FleetArm(alone.library, kind(name), table)
    other = FleetArm(compiled(folder, name), kind(name), table)
    T = poses_of(kind(name), table, random_joints(50))
    (rows, status), (wanted, kinds) = arm.batch(T), other.batch(T)
    np.testing.assert_array_equal(status, kinds)
    np.testing.assert_allclose(rows, wanted, rtol=0.0, atol=1e-9)


AXES = "{ 1.0, 1.0, 1.0, 1.0, 1.0, 1.0 }, /* how joints count */"
RATES = "dhgen_serial_jacobian(arm, q, J);\n"


def test_verification_sees_what_is_wrong(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """In plain Python, where what is wrong with the C is seen sooner."""
    monkeypatch.setattr(numba.config, "DISABLE_JIT", True)
    monkeypatch.setattr("dhgen.verify.calibrated.FEW", 1)
    own = kind("puma560")
    places = [tmp_path / each for each in ("right", "axes", "rates")]
    for place in places:
        place.mkdir()
        write_files(place, {**runtime_files(), **kind_files(own), **kind_module(own)})
    verify_kind(own, places[0])
    module, functions = f"{own.module.name}.c", "dhgen/functions_calibrated.h"
    changes = (
        (module, AXES, AXES.replace("1.0", "-1.0", 1), "fk"),
        (functions, RATES, f"{RATES}    J[0] += 1e-3;\n", "the Jacobian"),
    )
    for place, (name, right, wrong, what) in zip(places[1:], changes, strict=True):
        text = (place / name).read_text("utf-8")
        assert right in text
        (place / name).write_text(text.replace(right, wrong), encoding="utf-8")
        with pytest.raises(VerificationError, match=f"{what} is off by"):
            verify_kind(own, place)


def test_ranges_beyond_half_a_turn_are_verified(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Joint values in (-pi, pi] may be a turn away from where such limits have them."""
    monkeypatch.setattr(numba.config, "DISABLE_JIT", True)
    monkeypatch.setattr("dhgen.verify.calibrated.FEW", 1)
    path = ROBOTS / "kuka_kr6_r900.yaml"
    rows = iter(("", ", limits: [-190 deg, 45 deg]", ", limits: [30 deg, 430 deg]"))
    text = re.sub(
        r"(theta: .*?)\}", lambda cells: f"{cells[1]}{next(rows, '')}}}", path.read_text("utf-8")
    )
    file = RobotFile(path, load_text(text, path.stem), text)
    assert [joint.limits is not None for joint in file.robot.joints[:3]] == [False, True, True]
    own = kind_of(file.robot, worked_out_once(file)[1], RESERVED)
    write_files(tmp_path, {**runtime_files(), **kind_files(own), **kind_module(own)})
    verify_kind(own, tmp_path)


def test_robot_files_ask_for_it(tmp_path: Path) -> None:
    """A whole compilation: the files, and the derivation's section."""
    path = tmp_path / "puma560.yaml"
    text = (ROBOTS / "puma560.yaml").read_text("utf-8")
    path.write_text(f"{text}calibration: true\n", encoding="utf-8")
    made = compile_file(path)
    assert {"puma560_fleet.c", "puma560_fleet.h"} < set(made.files)
    assert "## Arms with tables of their own" in made.files["puma560.md"]
    assert RobotFile.read(path).stems == ("puma560", "puma560_f32", "puma560_fleet")


def test_scaras_have_no_fleet() -> None:
    with pytest.raises(UnsolvedError, match="it has other joints than six that turn"):
        kind("scara")


def test_refusals() -> None:
    file = RobotFile.read(ROBOTS / "puma560.yaml")
    module = module_of(file.path)
    plain = replace(file.robot, plain=True)
    with pytest.raises(UnsolvedError, match="it is plain"):
        kind_of(plain, module, RESERVED)
    with pytest.raises(UnsolvedError, match="its own method is quartic, no closed form"):
        kind_of(file.robot, replace(module, method=Method.QUARTIC), RESERVED)
    given = replace(file.robot, free=(1,))
    with pytest.raises(UnsolvedError, match=r"the caller gives joint 1 \(free\), and all six are"):
        kind_of(given, module, RESERVED)
    given = replace(file.robot, free=(1, 4))
    with pytest.raises(UnsolvedError, match=r"the caller gives joints 1, 4 \(free\)"):
        kind_of(given, module, RESERVED)
    task = replace(module.chain.task, kind=TaskKind.POSITION)
    moved = replace(module, chain=replace(module.chain, task=task))
    with pytest.raises(UnsolvedError, match="it is not asked for poses alone"):
        kind_of(file.robot, moved, RESERVED)
    general = replace(module, chain=kind("puma560").module.chain)
    with pytest.raises(UnsolvedError, match="no three of its axes side by side are parallel, or"):
        kind_of(file.robot, general, RESERVED)


def test_lengths_count_in_sizes_of_the_nominal_arm() -> None:
    """Also in what the arm that stands for all says, which has no tool."""
    size = 0.29 + 0.27 + 0.07 + 0.302 + 0.072  # of an IRB 120 with its tool
    source = kind_files(kind("abb_irb120"))["abb_irb120_fleet.c"]
    starts = re.search(r"48, ([\d.]+), 1e-10, /\* starts in a round; size", source)
    weights = re.search(r"\}, ([\d.]+), \{ 1e-14, 1e-10 \}, entries", source)
    assert starts is not None
    assert weights is not None
    assert float(starts[1]) == pytest.approx(size, rel=1e-12)
    assert float(weights[1]) == pytest.approx(1.0 / size, rel=1e-12)
