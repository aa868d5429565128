"""The solution next to the seed stands among the rows, and takes the place of no better one.

Beside a singular pose rounding of the pose says little about some joints: the seed says where they
are. It may be beyond a limit, its lengths may be in any unit, and single precision may be coarse.
"""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.robot.robot import JointKind
from tests.compiling import library, written
from tests.structures import first_of
from tests.targets.calling import (
    FREE_JOINT,
    HELD,
    INVALID_POSE,
    LANGUAGES,
    OK,
    OUT_OF_LIMITS,
    Solver,
    gap,
    in_single,
)
from tests.targets.made import ROBOTS, folder, in_c, poses_of, robot

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.verify.native import CompiledSolver

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

SLACK = 1.001e-9
WRIST = (3, 4, 5)  # the joints, from 0, of arms with a wrist
LIMITED = {"abb_irb120": 3, "hard_wrist": 3, "hard_stops": 3}  # a joint that a straight wrist frees
SLIDING = "prismatic_2_wrist"
IN_METRES = "d1: 0.3, a1: 0.1, a2: 0.15, d3: 0.1, a3: 0.08, d4: 0.43, d6: 0.08"
IN_MILLIMETRES = "d1: 300, a1: 100, a2: 150, d3: 100, a3: 80, d4: 430, d6: 80"


@pytest.mark.parametrize("language", first_of(LANGUAGES))
@pytest.mark.parametrize("name", LIMITED)
@pytest.mark.parametrize("off", [0.0, 1e-12, 1e-10])
def test_a_seed_beyond_a_limit_ends_no_row_inside(name: str, language: str, off: float) -> None:
    """It meets the pose, as joints inside the limits do; those are the solution."""
    solver, source = Solver(name, language), np.random.default_rng(15)
    limits = [joint.limits or (-1.0, 1.0) for joint in robot(name).joints]
    low, high = np.array(limits, dtype=float).T
    for _ in range(12):
        q = 0.5 * (low + high) + 0.3 * (high - low) * source.uniform(-1.0, 1.0, len(low))
        q[LIMITED[name]], q[4] = high[LIMITED[name]] - 0.02, off
        seed, turn = q.copy(), 0.02 + source.uniform(0.001, 0.02)
        seed[list(WRIST)] += (turn, 0.0, -turn)
        T = poses_of(name, q[None])[0]
        _, status = solver.all(T, seed)
        assert np.isin(status, (OK, FREE_JOINT)).any()
        assert (status == OUT_OF_LIMITS).sum() <= (solver.all(T, q)[1] == OUT_OF_LIMITS).sum()
        result, found = solver.nearest(T, seed)
        assert result in {OK, FREE_JOINT}
        assert ((low - SLACK <= found) & (found <= high + SLACK)).all()
        assert np.abs(found - seed).max() < 0.1


@pytest.mark.parametrize("language", first_of(LANGUAGES))
@pytest.mark.parametrize("name", ["ur5", "ur10e"])
@pytest.mark.parametrize("turns", [(-6, -5, -4, -3, 4, -7), (-6, 0, -4, -4, 4, 4)])
def test_no_answer_is_farther_from_the_seed_than_need_be(
    name: str, turns: tuple[int, ...], language: str
) -> None:
    """Where the elbow is folded and the wrist is straight, a step is easily longer than the way."""
    q, solver = np.array(turns) * (np.pi / 4), Solver(name, language)
    T, source = poses_of(name, q[None])[0], np.random.default_rng(21)
    for radius in (0.003, 0.009, 0.03):
        for _ in range(40):
            seed = source.normal(size=6)
            seed = q + seed * (radius / np.linalg.norm(seed))
            _, found = solver.nearest(T, seed)
            assert np.linalg.norm(found - seed) < 1.2 * radius


@cache
def in_millimetres() -> CompiledSolver:
    text = (ROBOTS / f"{SLIDING}.yaml").read_text(encoding="utf-8")
    path = folder() / f"{SLIDING}_mm.yaml"
    told = text.replace(IN_METRES, IN_MILLIMETRES).replace(f"name: {SLIDING}", f"name: {path.stem}")
    assert IN_MILLIMETRES in told
    assert path.stem in told
    path.write_text(told.replace("length: m", "length: mm"), encoding="utf-8")
    return library(written(path, folder()).module, folder())


def test_the_unit_of_slides_does_not_count() -> None:
    """Rows closer than 1e-3 to what the seed settles on are left: from there to it is no more."""
    source = np.random.default_rng(3)
    scale = np.array([1.0 if j.kind is JointKind.REVOLUTE else 1e3 for j in robot(SLIDING).joints])
    for _ in range(60):
        q = source.uniform(-1.0, 1.0, 6)
        q[4] = 10.0 ** -source.integers(10, 13)
        seed = q + source.uniform(-0.02, 0.02, 6)
        T = poses_of(SLIDING, q[None])[0]
        in_mm = T.copy()
        in_mm[:3, 3] *= 1e3
        _, found = Solver(SLIDING, "C").nearest(T, seed)
        other = in_millimetres().nearest(in_mm, seed * scale) / scale
        np.testing.assert_allclose(other, found, rtol=0.0, atol=3e-3)
        assert np.abs(found - seed).max() < 0.03


@pytest.mark.parametrize("near", first_of([1e-4, 3e-5, 1e-3]))
def test_single_precision_is_not_left_at_what_is_enough(near: float) -> None:
    """There a pose may be missed by 5e-5; joint values of the seed's often do."""
    name, source = "puma560", np.random.default_rng(4)
    missed: list[FloatArray] = []
    for _ in range(150):
        q = source.uniform(-1.0, 1.0, 6)
        q[4] = near
        seed = q + source.uniform(-0.08, 0.08, 6) * np.array([0, 0, 0, 1, 0, 1])
        (T,) = poses_of(name, q[None])
        rows, status = in_single(name, T, seed)
        held = rows[np.isin(status, HELD)].astype(float)
        missed.append(np.abs(poses_of(name, held) - T).max(axis=(1, 2)))
    assert np.quantile(np.concatenate(missed), 0.99) < 1e-6


@pytest.mark.parametrize("name", ["puma560", "prismatic_2_wrist"])
def test_a_seed_that_is_not_finite_is_none(name: str) -> None:
    """C says so where the pose asks for a seed; Python raises."""
    q = np.array([0.1, 0.2, 0.3, 0.4, 0.0, 0.6])
    seed = q.copy()
    seed[3] = np.nan
    (T,) = poses_of(name, q[None])
    rows, status = Solver(name, "C").all(T, seed)
    assert (status == INVALID_POSE).all()
    assert np.isnan(rows).all()
    with pytest.raises(ValueError, match="q_seed must be finite"):
        Solver(name, "Python").all(T, seed)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("near", [0.0, 1e-9, 1e-7, 1e-6, 1e-5])
def test_an_elbow_that_stops_where_it_is_stretched_is_followed(near: float, language: str) -> None:
    """The wrist is straight, too: steps that stop at the limit would turn it far away."""
    name, source = "stretched_elbow", np.random.default_rng(3)
    low, high = np.array([joint.limits for joint in robot(name).joints]).T
    for _ in range(15):
        q = 0.8 * source.uniform(low, high)
        q[[2, 4]] = near, 0.0
        seed = np.clip(q + source.uniform(-0.05, 0.05, 6), low, high)
        result, found = Solver(name, language).nearest(poses_of(name, q[None])[0], seed)
        assert result in {OK, FREE_JOINT}
        assert np.abs(found - seed).max() < 0.15


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_limit_makes_no_copy_of_another_solution(language: str) -> None:
    """A joint is 3e-3 beyond its limit, and the next solution inside is 0.05 away."""
    name = "puma560"
    q = np.array(
        [0.2759, 1.56651243643, -1.52381841044, 4.64157581, np.radians(100), 3.57663533906]
    )
    (T,) = poses_of(name, q[None])
    rows, status = Solver(name, language).all(T)
    held = rows[np.isin(status, HELD)]
    gaps = [gap(each, other) for k, each in enumerate(held) for other in held[:k]]
    assert len(held) >= 2
    assert min(gaps) > 1e-3


@pytest.mark.breadth
@pytest.mark.parametrize("language", LANGUAGES)
def test_a_solution_far_from_the_seed_keeps_its_row(language: str) -> None:
    """The seed's solution takes the place of one of its own family, though others are nearer."""
    name = "spherical_wrist_general_arm"
    q = np.array([np.pi / 2, 2.1889780068, 1.4944263499, -0.5548433741, 2.5e-12, 0.0])
    seed = np.array([1.56093676, 2.18899657, 1.4369865, -0.55364224, 0.04766135, 0.02452448])
    (T,) = poses_of(name, q[None])
    rows, status = Solver(name, language).all(T)
    followed, after = Solver(name, language).all(T, seed)
    kept = followed[np.isin(after, HELD)]
    assert gap(kept, seed).min() < 0.1
    apart = rows[np.isin(status, HELD)]
    apart = apart[gap(apart[:, :3], q[:3]) > 0.1]  # not of the straight wrist's family
    assert len(apart) >= 2
    assert all(gap(kept, each).min() < 1e-6 for each in apart)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("joint", [3, 5])
@pytest.mark.parametrize("end", [0, 1])
def test_at_an_end_of_more_than_a_turn_no_joint_is_turned(
    joint: int, end: int, language: str
) -> None:
    """Beside a straight wrist rounding takes it beyond: the other end is a whole turn away."""
    name, source = "puma560", np.random.default_rng(6)
    limits = np.array([at.limits for at in robot(name).joints])
    assert limits[joint, 1] - limits[joint, 0] > 2.0 * np.pi
    for straight in (0.0, 1e-11, 1e-10, 1e-9, 1e-8):
        for off in (0.0, 0.0, 0.0, 0.01):
            q = 0.7 * source.uniform(*limits.T)
            q[[joint, 4]] = limits[joint, end], straight
            seed = np.clip(q + off * source.uniform(-1.0, 1.0, 6), *limits.T)
            result, found = Solver(name, language).nearest(poses_of(name, q[None])[0], seed)
            assert result in {OK, FREE_JOINT}
            assert np.abs(found - seed).max() < 0.05
            assert (limits[:, 0] - SLACK <= found).all()
            assert (found <= limits[:, 1] + SLACK).all()
        beyond = q.copy()
        beyond[joint] += (-1.0, 1.0)[end] * 10.0 ** source.uniform(-9.0, -2.2)
        result, found = Solver(name, language).nearest(poses_of(name, q[None])[0], beyond)
        assert result in {OK, FREE_JOINT}
        assert np.abs(found - beyond).max() < 0.05


@pytest.mark.parametrize("joint", [0, 3, 5])
def test_nor_is_one_of_an_arm_that_is_solved_whole(joint: int) -> None:
    """Where the Jacobian's determinant has a root in joint 3."""
    name, source = "fanuc_crx10ia", np.random.default_rng(8)
    limits, solver = np.array([at.limits for at in robot(name).joints]), in_c(name)
    tried = 0
    while tried < 40:
        q = 0.9 * source.uniform(*limits.T)
        q[joint] = limits[joint, source.integers(2)]
        angles = np.linspace(0.95 * limits[2, 0], 0.95 * limits[2, 1], 60)
        values = [_determinant(solver, np.where(np.arange(6) == 2, angle, q)) for angle in angles]
        places = np.flatnonzero(np.diff(np.sign(values)))
        if not len(places):
            continue
        tried += 1
        q[2] = _root(solver, q, angles[places[0]], angles[places[0] + 1])
        q[2] += 10.0 ** -source.integers(5, 11)
        seed = np.clip(q + source.uniform(-0.02, 0.02, 6), *limits.T)
        result, found = Solver(name, "C").nearest(solver.fk(q), seed)
        assert result in {OK, FREE_JOINT}
        assert np.abs(found - seed).max() < 0.15


def _determinant(solver: CompiledSolver, q: FloatArray) -> float:
    return float(np.linalg.det(solver.jacobian(q)))


def _root(solver: CompiledSolver, q: FloatArray, low: float, high: float) -> float:
    """Joint 3 between two values at which the determinant has unlike signs, by bisection."""
    third = np.arange(6) == 2
    rising = _determinant(solver, np.where(third, low, q)) < 0.0
    for _ in range(50):
        middle = 0.5 * (low + high)
        below = (_determinant(solver, np.where(third, middle, q)) < 0.0) == rising
        low, high = (middle, high) if below else (low, middle)
    return low


@pytest.mark.parametrize("language", first_of(LANGUAGES))
def test_of_two_solutions_that_meet_at_a_limit_the_one_inside_is_kept(language: str) -> None:
    """They are 1e-5 apart, joint 3 stops between them, and the wrist is straight."""
    name, source = "offset_stop", np.random.default_rng(3)
    low, high = np.array([joint.limits for joint in robot(name).joints]).T
    for near in (1e-6, 1e-5):
        for _ in range(40 if language == "C" else 8):
            q = 0.8 * source.uniform(low, high)
            q[[2, 4]] = low[2] + near, 0.0
            seed = np.clip(q + source.uniform(-0.05, 0.05, 6), low, high)
            result, found = Solver(name, language).nearest(poses_of(name, q[None])[0], seed)
            assert result in {OK, FREE_JOINT}
            assert np.abs(found - seed).max() < 0.15


@pytest.mark.breadth
@pytest.mark.parametrize("off", [1e-3, 1e-2, 3e-2])
def test_where_two_things_are_singular_steps_may_lose_before_they_gain(off: float) -> None:
    """Twists of 1.5708, all joints at right angles or nearly so: 2 of 100 seeds were left."""
    name, source = "rounded_twists", np.random.default_rng(5)
    for k in range(300):
        q = source.integers(-2, 3, 6) * np.pi / 2
        if k % 3 == 1:
            q += source.normal(0.0, 1.0, 6) * 10.0 ** source.integers(-12, -3)
        seed = q + source.uniform(-off, off, 6)
        result, found = Solver(name, "C").nearest(poses_of(name, q[None])[0], seed)
        assert result in {OK, FREE_JOINT}
        assert np.abs(found - seed).max() < 0.1


@pytest.mark.parametrize("off", [1e-6, 1e-4, 1e-3])
def test_rounding_of_single_precision_turns_no_joint_away_from_the_seed(off: float) -> None:
    """With a straight wrist a step that asked for it turned joint 4 by up to 2 rad."""
    name, source = "puma560", np.random.default_rng(7)
    for _ in range(200):
        q = source.uniform(-1.0, 1.0, 6)
        q[4] = 0.0
        seed = q + source.uniform(-off, off, 6)
        (T,) = poses_of(name, q[None])
        rows, status = in_single(name, T, seed)
        held = rows[np.isin(status, HELD)].astype(float)
        assert np.abs(held - seed).max(axis=1).min() < 0.01


@pytest.mark.breadth
@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize(("singular", "beside"), [(3, -0.467004), (4, np.pi / 2 - 1e-6)])
def test_a_given_joint_beyond_its_limit_ends_no_row(
    language: str, singular: int, beside: float
) -> None:
    """The seed is a solution already: it takes its own row, and not that of the one beside it."""
    name, given = "franka_panda", 6
    solver, source = Solver(name, language), np.random.default_rng(3)
    for _ in range(20):
        q = source.uniform(-2.0, 2.0, 7)
        q[3], q[5], q[given] = -source.uniform(0.3, 2.8), source.uniform(0.2, 3.0), 2.95
        q[singular] = beside
        T = poses_of(name, q[None])[0]
        rows, status = solver.all(T, q, q[[given]])
        held = rows[np.isin(status, HELD)]
        assert gap(held, q).min() < 1e-6
        apart = [gap(held[:place], row).min(initial=1.0) for place, row in enumerate(held)]
        assert min(apart) > 1e-7
