"""A joint exactly on its limit, and the arm next to a singular pose: rounding may put it beyond."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.oracle.arm import arm_size
from dhgen.targets.module import regular_solver
from tests.compiling import library
from tests.structures import first_of
from tests.targets.calling import FREE_JOINT, HELD, LANGUAGES, OK, Solver, gap
from tests.targets.made import folder, made, made_up, poses_of, residual, robot

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

pytestmark = pytest.mark.slow  # rare: what is common fails first, in other files

INSIDE = (OK, FREE_JOINT)
# Right angles of five digits, and limits that leave a gap of 5e-6 rad.
FIVE_DIGITS = """theta: q, d: 0.4865, a: 0.15, alpha: -1.5708, limits: [-3.14159, 3.14159]
theta: q - 1.5708, a: 0.7, limits: [-1.5708, 2.618]
theta: q, a: 0, alpha: -1.5708, limits: [-4.1, 0.96]
theta: q, d: 0.6, alpha: 1.5708, limits: [-3.49, 3.49]
theta: q, alpha: -1.5708, limits: [-2.0, 2.0]
theta: q + 3.1416, d: 0.065, limits: [-6.98, 6.98]""".splitlines()

FAR_SCARA = """theta: q, d: 340, a: 325, alpha: 0, limits: [-170 deg, 170 deg]
theta: q, a: 225, alpha: 0, limits: [-145 deg, 145 deg]
theta: 0, d: -q, limits: [-200, 0]
theta: q, alpha: pi, d: -25, limits: [-360 deg, 360 deg]""".splitlines()
FAR_BASE = "units: {length: mm}\nbase: {xyz: [1000, -250, 733.5], rpy: [pi, 0, pi/2]}\n"
# A head that nods about an oblique axis, on three slides; the tool points.
NODDING = """theta: pi/2, d: q, alpha: pi/2, limits: [-1000, 1000]
theta: pi/2, d: q, alpha: pi/2, limits: [-600, 600]
theta: 0, d: q, limits: [-500, 0]
theta: q, alpha: pi/4, limits: [-2*pi, 2*pi]
theta: q, d: 90, alpha: -pi/4, limits: [-pi, pi]""".splitlines()
NODDING_REST = "units: {length: mm}\ntool: {xyz: [0, 0, 120]}\ntask: pointing\n"


def highest(name: str) -> FloatArray:
    """The upper limits of an arm's joints, all of which have some (n,)."""
    return np.array([joint.limits[1] for joint in robot(name).joints if joint.limits])


def test_the_row_of_the_seed_does_not_take_the_other_ones() -> None:
    """A row beyond a limit by rounding is the seed's own all the same."""
    solver = library(made_up("far_scara", FAR_SCARA, FAR_BASE).module, folder())
    source = np.random.default_rng(21)
    for _ in range(200):
        q = np.array([np.deg2rad(170.0), -1e-6, 0.0, 0.0])
        q[2:] = source.uniform(-200.0, 0.0), source.uniform(-6.0, 6.0)
        rows, status = solver.ik(solver.fk(q), q)
        assert gap(rows[np.isin(status, INSIDE)], q).min() < 1e-9
        there = rows[np.isin(status, HELD)]
        assert len(there) == 2
        assert gap(there[:1], there[1])[0] == pytest.approx(2e-6, rel=1e-2)


def test_fast_code_leaves_an_elbow_that_tells_too_little_of_limits() -> None:
    """Joint 1 is known to 2e-9 rad there, of seven joints with the axes of three nearly in line."""
    name, given = "kuka_iiwa14", 2
    q = np.array([-highest(name)[0], 0.05, 2.41, 2e-6, 0.73, 0.89, -1.76])
    rows, status = Solver(name, "C").all(poses_of(name, q[None])[0], q, q[[given]])
    assert gap(rows[np.isin(status, INSIDE)], q).min() < 1e-9


@pytest.mark.breadth
def test_a_gap_between_limits_is_not_crossed_by_rounding() -> None:
    """From the seed steps lead 8e-6 rad beyond a limit, which is inside on the other side."""
    name = "five_digits"
    compiled = made_up(name, FIVE_DIGITS, "")
    solver = library(compiled.module, folder())
    q = np.array([3.14159, -1.408115877685677, 0.96, -1.7523437389, 1.569754359, 6.279318099])
    seed = q + np.array([-0.003059, 0.002264, 0.001226, -7.5e-05, 0.001134, -0.001754])
    rows, status = solver.ik(solver.fk(q), seed)
    held = rows[np.isin(status, INSIDE)]
    nearest = np.abs(held[gap(held, seed).argmin()] - seed)[:5]
    assert nearest.max() < 0.01


@pytest.mark.parametrize("language", LANGUAGES)
def test_rows_are_turned_as_everywhere_whatever_the_seed_is(language: str) -> None:
    """Also those that are taken from the seed: in (-pi, pi] where limits allow."""
    name = "abb_irb120"
    solver, source = Solver(name, language), np.random.default_rng(23)
    for near in np.repeat([1e-10, 1e-9, 1e-7], 10):
        q = source.uniform(-1.0, 1.0, 6)
        q[4], q[5] = near, source.choice([-1.0, 1.0]) * highest(name)[5]
        rows, status = solver.all(poses_of(name, q[None])[0], q)
        held = rows[np.isin(status, INSIDE)]
        assert gap(held, q).min() < 1e-3
        assert (np.abs(held) <= np.pi).all()


# A joint on its limit, and another 1e-9 to 1e-7 rad from where two solutions meet. On the iiwa, two
# joints: the row of the other solution, which is 3e-6 rad beyond, is looked at first.
MEETING = {
    "general_prrprr": (
        *(0.0, 1.1215530563442835, -1.080449447090736, 0.4, -1.946369726130538),
        -0.7953645578323747,
    ),
    "franka_panda": (-1.9488, 0.66853, 2.8973, -0.46700342573982, -1.78192, 3.7525, 0.0096),
    "kuka_iiwa14": (
        *(-2.9670597283903604, 0.1684773115807592, 2.9472727032345016, -0.3519665930458419),
        *(2.9670597283903604, -2.0943951023931953, 1.1988545394767913),
    ),
}


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("name", MEETING)
def test_the_other_solution_is_not_put_onto_the_limit(name: str, language: str) -> None:
    """It is beyond, by next to nothing; the limit is where the first one stands."""
    q = np.array(MEETING[name])
    free = [joint - 1 for joint in robot(name).free]
    given = [q[free]] if free else []
    rows, status = Solver(name, language).all(poses_of(name, q[None])[0], q, *given)
    held = rows[np.isin(status, INSIDE)]
    assert gap(held, q).min() < 1e-9
    for place, row in enumerate(held):
        assert gap(np.delete(held, place, axis=0), row).min(initial=1.0) > 1e-8


@pytest.mark.parametrize("language", LANGUAGES)
def test_limits_that_leave_a_small_gap_at_one_side(language: str) -> None:
    """A joint just beyond 355 degrees comes as -5: that is next to the end, not far below zero."""
    name = "gap_beside_zero"
    solver = Solver(name, language)
    ends, source = (0.0, np.deg2rad(355.0)), np.random.default_rng(25)
    for _ in range(60):
        near = source.choice([1e-9, 1e-8, 1e-7, 1e-6]) * source.choice([-1.0, 1.0])
        q = np.array([source.choice(ends), near, -0.2, source.choice([*ends, 3.0])])
        for seed in (q, np.zeros(4)):
            rows, status = solver.all(poses_of(name, q[None])[0], seed)
            held = rows[np.isin(status, INSIDE)]
            assert gap(held, q).min() < 1e-6
            assert len(held) < 2 or gap(held[:1], held[1])[0] > 1e-10


def test_lengths_beyond_limits_count_in_arm_sizes() -> None:
    """Three slides on their ends, by rounding half a micrometre beyond, told in millimetres."""
    solver = library(made_up("nodding", NODDING, NODDING_REST).module, folder())
    q = np.array([-1000.0, 600.0, -500.0, 2.2096413686920403, -3.1415841076677156])
    rows, status = solver.ik(solver.fk(q), q)
    held = rows[np.isin(status, INSIDE)]
    assert np.abs(held - q).max(axis=1).min() < 1e-2


@pytest.mark.parametrize("name", ["scara", "stanford", "epson_t3"])
def test_slides_are_beyond_limits_in_arm_sizes(name: str) -> None:
    """To fast code: what an arm of millimetres may be rounded by is more than for one of metres."""
    solver = regular_solver(made(name).module)
    assert solver is not None
    sizes = [1.0 / c.value for c in solver.program.constants if c.name == "per_size"]
    # the oracle's adds up lengths and strokes
    assert [0.5 < size / arm_size(robot(name)) < 1.0 + 1e-9 for size in sizes] == [True]


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("elbow", first_of([1e-4, 3e-5, 1e-3]))
def test_on_a_limit_where_an_arm_is_nearly_singular_twice_over(elbow: float, language: str) -> None:
    """The wrist centre is near axis 1 and the elbow nearly stretched: neither near enough alone."""
    name, source = "seven_with_limits", np.random.default_rng(27)
    solver, end = Solver(name, language), highest(name)[0]
    for tilt in np.repeat([0.0, 1e-5, 1e-4, 1e-3], 10 if language == "Python" else 60):
        q = np.array([end * source.choice([-1.0, 1.0]), tilt, *source.uniform(-2.0, 2.0, 5)])
        q[3] = elbow * source.choice([-1.0, 1.0])
        for seed in (q, q + source.uniform(-0.01, 0.01, 7)):
            rows, status = solver.all(poses_of(name, q[None])[0], seed, q[[2]])
            held = rows[np.isin(status, INSIDE)]
            # wrist on axis 1 and stretched elbow: of a family, the one next to the seed
            near = 1e-6 if (np.array([tilt, elbow]) > 1e-4).all() else 0.01
            assert gap(held, q).min(initial=np.pi) < near


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("wrist", [1e-5, 1e-6, 1e-7])
def test_a_nearly_straight_wrist_turns_far_where_a_joint_is_put_on_its_limit(
    wrist: float, language: str
) -> None:
    """An elbow that rounding takes for stretched puts joint 2 some 1e-8 rad beyond."""
    name, source = "stretched_on_a_limit", np.random.default_rng(28)
    solver = Solver(name, language)
    for bent in np.repeat([1e-7, 5e-8, 2e-8, 1e-8], 5 if language == "Python" else 40):
        q = source.uniform(-3.0, 3.0, 6)
        q[0], q[1] = q[0] / 2, source.choice([highest(name)[1], np.deg2rad(-110.0)])
        q[2] = np.arctan2(-0.48, 0.035) + bent * source.choice([-1.0, 1.0])
        q[4] = wrist * source.choice([-1.0, 1.0])
        T = poses_of(name, q[None])[0]
        rows, status = solver.all(T)
        held = rows[np.isin(status, INSIDE)]
        # any turn of the wrist that meets the pose with an elbow on either side of stretched
        assert gap(held[:, :3], q[:3]).min(initial=np.pi) < 1e-6
        assert residual(name, held, T[None]) < 1e-12
