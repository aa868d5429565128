"""A general arm at singular poses: answered, followed from the seed, said so."""

from __future__ import annotations

from itertools import product
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.kinematics.build import build_chain
from dhgen.numerical.kernel import numerical_kernel
from dhgen.numerical.runtime_arm import runtime_arm
from dhgen.oracle.forward import forward
from dhgen.program.interpret import interpret
from dhgen.robot.load import load
from dhgen.runtime.plain import plain
from dhgen.runtime.python.numerical.arm import arm_numbers
from dhgen.status import Status
from dhgen.survey.singular import in_a_family, singular_sets
from dhgen.tolerances import TOLERANCES
from dhgen.verify.native import CompiledSolver, compile_solver
from tests.compiling import library, written
from tests.general.files import compiled, without_derivation
from tests.robots.cases import ROBOTS, robot
from tests.structures import first_of
from tests.targets.calling import LANGUAGES
from tests.targets.made import made_up, solving

if TYPE_CHECKING:
    from pathlib import Path

    from dhgen.compiler import Compilation
    from dhgen.targets.module import SolverModule

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

# xArm6: axes 4 and 5 meet, and axes 1 and 2; at a straight wrist joints turn against each other.
XARM6 = """
name: arm
parameters: {a2: 0.28948866, a3: 0.0775, d4: 0.3425, a5: 0.076}
joints:
  - {theta: q, d: 0.267, alpha: -pi/2}
  - {theta: q - 1.3849179, a: a2}
  - {theta: -q + 1.3849179, a: a3, alpha: -pi/2}
  - {theta: q, d: d4, alpha: pi/2}
  - {theta: q, a: a5, alpha: -pi/2}
  - {theta: q, d: 0.097}
"""


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> tuple[Compilation, CompiledSolver]:
    folder: Path = tmp_path_factory.mktemp("singular")
    (folder / "arm.yaml").write_text(XARM6, encoding="utf-8")
    compilation = written(folder / "arm.yaml", folder)
    assert compilation.module.method == "general 6R"
    return compilation, library(compilation.module, folder)


def module_of(text: str, folder: Path) -> SolverModule:
    """The programs of an arm that is written as this."""
    path = folder / "arm.yaml"
    path.write_text(text, encoding="utf-8")
    return without_derivation(load(path))


def gaps(rows: np.ndarray, q: np.ndarray) -> np.ndarray:
    """The largest difference of each row from joint values, whole turns aside."""
    return np.asarray(np.abs(np.remainder(rows - q + np.pi, 2 * np.pi) - np.pi).max(axis=-1))


def test_right_angles_are_answered_from_the_seed(
    made: tuple[Compilation, CompiledSolver],
) -> None:
    _, solver = made
    random = np.random.default_rng(0)
    for q in [np.zeros(6), *random.choice([0.0, np.pi / 2, np.pi, -np.pi / 2], (120, 6))]:
        T = solver.fk(np.ascontiguousarray(q))
        rows, status = solver.ik(T, np.ascontiguousarray(q))
        held = rows[status != 1]
        assert gaps(held, q).min() < 1e-3
        for row in held:
            np.testing.assert_allclose(solver.fk(np.ascontiguousarray(row)), T, atol=1e-9)


def test_the_first_joint_follows_the_seed_where_the_last_turns_about_its_axis(
    made: tuple[Compilation, CompiledSolver],
) -> None:
    _, solver = made
    q = on_the_first_axis(solver)
    T = solver.fk(q)
    rows, status = solver.ik(T, q)
    held = rows[status != 1]
    assert gaps(held, q).min() < 1e-9
    assert (status[status != 1] == 2).all()
    for row in held:
        np.testing.assert_allclose(solver.fk(np.ascontiguousarray(row)), T, atol=1e-9)


def on_the_first_axis(solver: CompiledSolver) -> np.ndarray:
    """Joint values with the tool on axis 1 and down, by joints 3 and 5."""
    q = np.array([0.0, -0.5, -1.0, 0.0, 0.5, 0.0])
    for _ in range(20):
        T, J = solver.fk(q), solver.jacobian(q)
        missing = T[0, 3], np.arctan2(T[0, 2], -T[2, 2])
        q[[2, 4]] -= np.linalg.solve(np.stack([J[0, [2, 4]], -J[4, [2, 4]]]), missing)
    q[[0, 5]] = 0.7, 0.2
    return q


@pytest.mark.parametrize("first", first_of([-2.5, 3.0]))
def test_of_a_continuum_a_solution_inside_the_limits_is_taken(tmp_path: Path, first: float) -> None:
    """Joints 1 and 6 turn against each other; near to the seed joint 6 is beyond its limit."""
    limited = XARM6.replace("d: 0.097}", "d: 0.097, limits: [-0.5, 0.5]}")
    module = module_of(limited, tmp_path)
    solver = compiled(module, tmp_path)
    q = on_the_first_axis(solver)
    T, seed = solver.fk(q), np.array([first, *q[1:]])
    rows, status = solver.ik(T, seed)
    meant = interpret(module.solver, T[None], seed)
    known = meant.q[0][meant.solved[0]]
    inside = known[np.abs(known[:, 5]) < 0.5 + 1e-9]
    # four continua, that differ in joints 2 to 5: wrist and elbow have two ways each
    continua: list[np.ndarray] = []
    for row in known[:, 1:5]:
        if all(gaps(other, row) > 1e-5 for other in continua):
            continua.append(row)
    assert len(continua) == 4
    for held in (rows[status == 2], inside):
        for continuum in continua:
            assert gaps(held[:, 1:5], continuum).min() < 1e-5
        assert (
            np.abs(np.remainder(held - q + np.pi, 2 * np.pi) - np.pi)[:, 1:5].max(axis=1).min()
            < 1e-6
        )
        for row in held:
            np.testing.assert_allclose(solver.fk(np.ascontiguousarray(row)), T, atol=1e-9)


INSTRUMENT = [
    "theta: q, alpha: -pi/2",
    "theta: q, alpha: -pi/2",
    "d: q",
    "theta: q, alpha: pi/2",
    "theta: q, alpha: -pi/2, a: 0.0091",
    "theta: q, alpha: -pi/2",
]


@pytest.mark.breadth
def test_a_continuum_gives_one_row_that_is_nearest_to_the_seed_in_both_languages() -> None:
    """Joints 2 and 6 turn about one axis: its members differ in these alone."""
    arm = made_up("instrument", INSTRUMENT, "", "modified")
    q = np.array([-np.pi / 2, np.pi, 0.00273, -np.pi / 2, -np.pi / 2, np.pi])
    seed = np.array([-1.3225, 2.3399, -0.0059, 1.3266, -1.5666, -0.3423])
    T = np.asarray(forward(arm.robot, q[None])[0], dtype=float)
    found = []
    for language in LANGUAGES:
        rows, status = solving(arm, language)(T, seed)
        rows = rows[status == Status.FREE_JOINT]
        found.append(rows)
        fixed = rows[:, [0, 2, 3, 4]]
        assert gaps(fixed, q[[0, 2, 3, 4]]).min() < 1e-6
        for k, row in enumerate(rows):
            assert gaps(np.delete(fixed, k, axis=0), fixed[k]).min() > 1e-3
            turns = np.linspace(-np.pi, np.pi, 1000)[:, None]
            members = [row + turns * [0, 1, 0, 0, 0, way] for way in (-1, 1)]
            misses = [np.abs(forward(arm.robot, each) - T).max() for each in members]
            assert min(misses) < 1e-9
            off = members[int(np.argmin(misses))] - seed
            turned = off - 2 * np.pi * np.round(off / (2 * np.pi))
            own = gaps(row[[1, 5], None], seed[[1, 5], None])
            assert (own**2).sum() <= (turned[:, [1, 5]] ** 2).sum(axis=1).min() + 1e-9
    assert len(found[0]) == len(found[1])
    for row in found[0]:
        assert gaps(found[1], row).min() < 1e-6


def test_every_continuum_has_a_row() -> None:
    """The instrument reaches a pose from the other side, too: half a turn of joint 1, drawn back.

    So to every continuum there is another one with the opposite sign of d3. Many candidates come to
    the first ones that are found: none of them may use up the rows of the others.
    """
    arm = made_up("instrument", INSTRUMENT, "", "modified")
    solve, half = solving(arm, "C"), np.pi / 2
    sides: list[tuple[float, ...]] = [
        (np.pi, np.pi, np.pi, np.pi, 0, np.pi),
        (half, 0, np.pi, -half, 0, -half),
    ]
    sides += [(half, np.pi, np.pi, -half, np.pi, -half), (np.pi, 0, np.pi, half, -half, np.pi)]
    for q in sides:
        T = np.asarray(forward(arm.robot, np.array([q]))[0], dtype=float)
        for seed in np.random.default_rng(5).uniform(-np.pi, np.pi, (4, 6)):
            rows, status = solve(T, seed)
            lengths = rows[status == Status.FREE_JOINT, 2]
            assert len(lengths) >= 4
            assert 2 * (lengths > 0).sum() == len(lengths)


@pytest.mark.breadth
@pytest.mark.parametrize("name", ["puma560_calibrated", "kinova_gen3_lite"])
def test_solutions_that_meet_are_found_without_a_seed(name: str, tmp_path: Path) -> None:
    solver = compile_solver(ROBOTS.parent / "generated" / f"{name}.c", tmp_path, name, 6, 16, 0)
    assert solver is not None
    kinds = singular_sets(robot(name), 60, seed=5)
    missed = []
    for kind in [kind for kind in kinds if "singular by" in kind or kind == "right angles"]:
        poses = np.ascontiguousarray(forward(robot(name), kinds[kind]), dtype=float)
        for q, T in zip(kinds[kind], poses, strict=True):
            rows, status = solver.ik(T, np.zeros(6))
            met = gaps(rows[status != 1], q).min(initial=np.inf) < 1e-3 or (status == 2).any()
            if not met and not in_a_family(robot(name), q):
                missed.append((kind, q.tolist()))
    assert not missed


# A laser arm that points with a tilted tool: at right angles four roots of its quartic meet.
LASER = """
name: arm
task: pointing
joints:
  - {theta: q, d: 0.35, a: 0.03, alpha: pi/2}
  - {theta: q, a: 0.22}
  - {theta: q, a: 0.22}
  - {theta: q + pi/2, a: 0.02, alpha: pi/2}
  - {theta: q, d: 0.15}
tool: {xyz: [0.05, 0, 0.1], rpy: [0, 40 deg, 0]}
"""
# A welding arm with a hollow wrist, its three axes past each other.
HOLLOW = """
name: arm
parameters: {tw: 65 deg}
joints:
  - {theta: q, d: 0.45, a: 0.155, alpha: -pi/2}
  - {theta: q - pi/2, a: 0.614, alpha: pi}
  - {theta: q, a: 0.2, alpha: -pi/2}
  - {theta: q, d: -0.64, alpha: tw}
  - {theta: q, d: -0.08, alpha: -tw}
  - {theta: q, d: -0.1, alpha: pi}
tool: {xyz: [0.03, 0, 0.35], rpy: [0, 35 deg, 0]}
"""
# Another arm that points: four roots of its quartic meet.
POINTING = """
name: arm
task: pointing
joints:
  - {theta: q, d: 0.362, a: 0.136, alpha: -pi/2}
  - {theta: q, d: -0.059, a: 0.582}
  - {theta: q, a: 0.507}
  - {theta: q + 1.866, d: 0.079, a: -0.04, alpha: pi/2}
  - {theta: q, d: 0.104}
tool: {xyz: [-0.067, 0, 0.129], rpy: [0, 23.257 deg, 0]}
"""
# Beside right angles its first polynomial is next to nothing all around, and tells of no root.
NEXT_TO_NOTHING = """
name: arm
convention: modified
joints:
  - {theta: q, a: 0.267, alpha: -pi/2}
  - {theta: q, d: 0.221, alpha: pi/2}
  - {theta: q, a: 0.131, alpha: -pi/2}
  - {theta: q, d: 0.246, alpha: pi/2}
  - {theta: q, d: 0.055, a: 0.153, alpha: pi/2}
  - {theta: q, d: 0.563, a: 0.426, alpha: -pi/2}
"""
BESIDE = (-1.3702218649780145, np.pi / 2 - 1e-8, np.pi / 2 + 1e-8, np.pi, -np.pi, -0.41788624)
# Painting arms. Of one four roots meet, lifted by more than their rounding is known to be;
# double roots of the other lead nowhere, and poses close by have two solutions on both sides.
ROLLS = """
name: arm
convention: modified
joints:
  - {theta: q, d: 0.73}
  - {theta: q - pi/2, alpha: -pi/2, a: 0.2}
  - {theta: q, a: 1.1}
  - {theta: q, alpha: -pi/2, a: 0.15, d: 1.25}
  - {theta: q, alpha: pi/3, d: 0.12}
  - {theta: q, alpha: -pi/3, d: 0.118}
tool: {xyz: [0, 0, 0.25], rpy: [0, pi/4, 0]}
"""
INLINE = """
name: arm
joints:
  - {theta: q, d: 0.6, a: 0.3, alpha: pi/2}
  - {theta: q + pi/2, a: 1.2}
  - {theta: q, alpha: pi/2}
  - {theta: q, d: 1.25, alpha: -pi/2}
  - {theta: q, a: 0.12, alpha: pi/2}
  - {theta: q, d: 0.15}
tool: {xyz: [0.05, 0, 0.2], rpy: [0, 30 deg, 0]}
"""
# A welding arm that points. Where its quartic has no coefficients it has a continuum.
WELDING = """
name: arm
task: pointing
joints:
  - {theta: q, d: 0.3, a: 0.08, alpha: pi/2}
  - {theta: q, a: 0.5}
  - {theta: q, a: 0.45}
  - {theta: q, d: 0.03, alpha: pi/2}
  - {theta: q, d: 0.12, alpha: pi/2}
tool: {xyz: [0.02, 0, 0.1]}
"""
# A Stanford arm with the last digits of a calibration. Stretched with a straight wrist, two joints
# hardly move the tool, and the first polynomial is next to nothing all around.
CALIBRATED = """
name: arm
joints:
  - {theta: q, d: 0.319, a: 0.337, alpha: -2.0e-8}
  - {theta: q, d: -2.5e-9, a: 0.414, alpha: 3.1415926263}
  - {d: q, a: -8.6e-9, alpha: 3.7e-8}
  - {theta: q, d: 0.508, a: -1.9e-8, alpha: 1.5707964025}
  - {theta: q, d: -1.3e-8, a: 1.3e-9, alpha: -1.5707963112}
  - {theta: q, d: 0.303, a: 9.1e-9, alpha: -7.8e-9}
"""
# An arm of four turns on a rail, calibrated, whose joints 3 and 5 hardly move the tool where it is
# folded: joint values 0.04 rad beside the solution miss the pose by less than one that is rounded.
RAIL = """
name: arm
convention: modified
joints:
  - {alpha: -9.6e-7, a: 2.3e-7, theta: 0, d: q}
  - {alpha: 1.1e-7, a: 1.99999958, theta: q, d: -8.6e-7}
  - {alpha: 1.57079591, a: 4.5e-8, theta: q, d: 0.99999915}
  - {alpha: 1.57079603, a: -1.8e-7, theta: q, d: -7.4e-7}
  - {alpha: -1.57079718, a: 3.4e-7, theta: q, d: 3.00000086}
"""


@pytest.mark.parametrize(
    ("text", "q"),
    first_of(
        [
            (ROLLS, (np.pi, 0.0, np.pi / 2, -np.pi / 2, 0.0, np.pi / 2)),
            (INLINE, (0.0, -np.pi / 2, np.pi / 2, np.pi, np.pi / 2, -np.pi / 2)),
            (NEXT_TO_NOTHING, BESIDE),
            (WELDING, (0.0, np.pi, 0.0, np.pi / 2, 0.0)),
            (POINTING, (np.pi, -2.709841362760041, np.pi, 0.12261522952881965, -np.pi / 2)),
            (LASER, (-np.pi / 2, 0.0, 0.0, -np.pi / 2, -np.pi / 2)),
            (HOLLOW, (0.0, 0.0, np.pi / 2, np.pi / 2, 0.0, np.pi)),
        ],
        count=4,
    ),
)
def test_where_roots_meet_or_polynomials_vanish_there_are_rows(
    tmp_path: Path, text: str, q: tuple[float, ...]
) -> None:
    """Rounding moves roots that meet by thousandths; in C, and in what C is held to."""
    module = module_of(text, tmp_path)
    solver = compiled(module, tmp_path)
    T = solver.fk(np.array(q))
    rows, _ = solver.ik(T, np.array(q))
    meant = interpret(module.solver, T[None], np.array(q))
    for held in (rows[np.isfinite(rows).all(axis=1)], meant.q[0][meant.solved[0]]):
        assert gaps(held, np.array(q)).min() < 1e-9  # a free joint followed the seed
        named = np.s_[:, :3, 2:]
        reached = np.array([solver.fk(np.ascontiguousarray(row)) for row in held])
        np.testing.assert_allclose(reached[named], np.tile(T, (len(held), 1, 1))[named], atol=1e-9)


@pytest.mark.parametrize(
    ("text", "q"),
    first_of(
        [
            (ROLLS, (np.pi, 0.0, np.pi / 2, -np.pi / 2, 0.0, np.pi)),
            (ROLLS, (np.pi / 2, np.pi, np.pi / 2, np.pi / 2, 0.0, np.pi)),
            (INLINE, (np.pi, np.pi, -np.pi / 2, 0.0, np.pi, 0.0)),
        ]
    ),
)
def test_where_many_roots_meet_there_is_one_row(
    tmp_path: Path, text: str, q: tuple[float, ...]
) -> None:
    """Joint values up to 0.02 rad beside the solution miss the pose by less than 1e-10."""
    module = module_of(text, tmp_path)
    solver = compiled(module, tmp_path)
    T = solver.fk(np.array(q))
    for seed in (np.zeros(6), np.array(q)):
        rows, status = solver.ik(T, seed)
        meant = interpret(module.solver, T[None], seed)
        assert not meant.free.any()
        assert not (status == 2).any()
        for held in (rows[status != 1], meant.q[0][meant.solved[0]]):
            assert (gaps(held, np.array(q)) < 0.05).sum() == 1


def test_an_exact_solution_is_not_left_for_one_of_a_rounded_pose(tmp_path: Path) -> None:
    """The seed leads beside it, and what lies between both would solve a rounded pose, too."""
    module = module_of(RAIL, tmp_path)
    solver = compiled(module, tmp_path)
    T = solver.fk(np.array([0.0, np.pi, np.pi, -np.pi, -np.pi]))
    rows, status = solver.ik(T, np.zeros(5))
    meant = interpret(module.solver, T[None], np.zeros(5))
    for held in (rows[status != 1], meant.q[0][meant.solved[0]]):
        assert len(held)
        reached = np.array([solver.fk(np.ascontiguousarray(row)) for row in held])
        np.testing.assert_allclose(reached, np.tile(T, (len(held), 1, 1)), atol=1e-10)


def test_nearly_free_joints_do_not_leave_a_pose_without_rows(tmp_path: Path) -> None:
    """The polynomial does not tell that there are none, and steps from anywhere lead to some."""
    (tmp_path / "arm.yaml").write_text(CALIBRATED, encoding="utf-8")
    arm = load(tmp_path / "arm.yaml")
    solver = compiled(without_derivation(arm), tmp_path)
    quarters = np.arange(-1, 3) * np.pi / 2
    for first, fourth, fifth, sixth in product(quarters, quarters[::2], quarters[1::2], quarters):
        T = solver.fk(np.array([first, 0.0, 0.0, fourth, fifth, sixth]))
        rows, status = solver.ik(T, np.zeros(6))
        assert (status != 1).any()
        for row in rows[status != 1]:
            np.testing.assert_allclose(solver.fk(np.ascontiguousarray(row)), T, atol=1e-9)
    kernel = numerical_kernel(build_chain(arm), redundant=False)
    numbers, descent = arm_numbers(runtime_arm(kernel)), plain("numerical.descent")
    goal = T[:3].copy(), np.zeros(0), 0
    for start in range(plain("general.rows").STARTS):
        u = np.empty(6)
        descent.start_of(numbers, start, np.zeros(6), u)
        missed = descent.descend(numbers, goal, np.zeros(6), u)
        assert missed <= TOLERANCES.refined


# A slide before five turns, with twists of 1.5708: at right angles two solutions lie 1.5e-5 rad
# apart in the hidden joint, half a turn away two more, and the determinant shows none of them.
CROWD = """
name: arm
joints:
  - {theta: pi/2, d: q, a: 0.2, alpha: 1.5708}
  - {theta: q, d: -0.2, alpha: 1.5708}
  - {theta: q, a: 0.488, alpha: 1.5708}
  - {theta: q, d: 0.26, a: 0.2, alpha: 3.1416}
  - {theta: q, alpha: pi/2}
  - {theta: q, a: -0.2}
"""


@pytest.mark.breadth
def test_where_roots_crowd_no_pose_is_left_without_rows(tmp_path: Path) -> None:
    """The determinant shows no root; that none is there the equations do not say either."""
    solver = compiled(module_of(CROWD, tmp_path), tmp_path)
    random = np.random.default_rng(0)
    quarters = np.array([0.0, np.pi / 2, -np.pi / 2, np.pi])
    for _ in range(2000):
        q = np.array([random.choice([0.387, 0.774, 1.161, 1.548]), *random.choice(quarters, 5)])
        _, status = solver.ik(solver.fk(q), np.zeros(6))
        assert (status != 1).any()
