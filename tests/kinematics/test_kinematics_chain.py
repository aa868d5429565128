"""The exact chain against the oracle, for arms that nobody drew."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from dhgen.kinematics.axes import exact_axes
from dhgen.kinematics.build import build_chain
from dhgen.kinematics.chain import Fixed, parallel_groups
from dhgen.kinematics.numeric import numeric_arm
from dhgen.oracle.arm import arm_size
from dhgen.oracle.forward import forward
from dhgen.oracle.poses import random_joints
from dhgen.robot.robot import ReferenceAxes
from tests.kinematics.values import algebra_of, axes, poses, table
from tests.robots.cases import NAMES, robot

angles = st.one_of(
    st.sampled_from(
        ["0", "pi/2", "-pi/2", "pi", "pi/12", "-5*pi/6", "3*pi/4", "20 deg", "-160 deg"]
    ),
    st.integers(-300, 300).map(lambda hundredths: f"{hundredths / 100}"),
)
lengths = st.one_of(
    st.sampled_from(["0", "L", "-L/2", "L - 0.1", "2*L"]),
    st.integers(-90, 90).map(lambda hundredths: f"{hundredths / 100}"),
)


def joint(constant: str, sign: str) -> str:
    return f"{sign}q" if constant == "0" else f"{sign}q + {constant}"


signs = st.sampled_from(["", "-"])
revolute = st.builds(
    lambda theta, sign, d, a, alpha: f"theta: {joint(theta, sign)}, d: {d}, a: {a}, alpha: {alpha}",
    *(angles, signs, lengths, lengths, angles),
)
prismatic = st.builds(
    lambda theta, d, sign, a, alpha: f"theta: {theta}, d: {joint(d, sign)}, a: {a}, alpha: {alpha}",
    *(angles, lengths, signs, lengths, angles),
)


def frames_of(cells: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    return st.builds(
        lambda x, y, z, *turns: f"{{xyz: [{x}, {y}, {z}], rpy: [{', '.join(turns)}]}}",
        *(cells, cells, cells, angles, angles, angles),
    )


frames = frames_of(lengths)
vectors = st.builds(lambda x, y, z: np.array([x, y, z]), *[st.integers(-3, 3)] * 3)


@settings(max_examples=20)
@given(
    rows=st.lists(st.one_of(revolute, revolute, prismatic), min_size=1, max_size=4),
    convention=st.sampled_from(["standard", "modified"]),
    base=frames,
    tool=frames,
    seed=st.integers(0, 999),
)
def test_tables_of_either_convention(
    rows: list[str], convention: str, base: str, tool: str, seed: int
) -> None:
    arm = table(*rows, parameters="{L: 0.4}", convention=convention, base=base, tool=tool)
    algebra = algebra_of(arm)
    q = random_joints(arm, 2, seed=seed)
    expected = forward(arm, q)
    np.testing.assert_allclose(poses(algebra, q), expected, atol=1e-12)
    np.testing.assert_allclose(numeric_arm(algebra.chain).pose(q), expected, atol=1e-12)


# with a zero component and of a length that takes roots of 2 and 3 only: kept as they are
EXACT = [
    *("1, 0, 0", "0, -1, 0", "0, 0, 1", "0, 0, -1", "cos(pi/6), sin(pi/6), 0", "0, 3/5, 4/5"),
    *("0, 1, 1", "-1, 0, sqrt(3)", "0, -2, 0", "3, 4, 0", "0, 2.5, -2.5"),
]


def entry(kind: str, direction: str, point: str) -> str:
    at = "" if kind == "prismatic" else f", point: [{point}]"
    return f"type: {kind}, direction: [{direction}]{at}"


kinds = st.sampled_from(["revolute", "revolute", "prismatic"])
points = st.builds(lambda *cells: ", ".join(cells), lengths, lengths, lengths)
# letters alone, which agree where their values do
lettered = st.sampled_from(["0", "L", "-L/2", "2*L", "M", "L - M", "-M"])
lettered_points = st.builds(lambda *cells: ", ".join(cells), lettered, lettered, lettered)
exact_entries = st.builds(entry, kinds, st.sampled_from(EXACT), lettered_points)
directions = st.tuples(*[st.integers(-5, 5)] * 3).filter(any).map(lambda v: ", ".join(map(str, v)))
entries = st.builds(entry, kinds, st.one_of(directions, st.sampled_from(EXACT)), points)


@settings(max_examples=20)
@given(st.lists(exact_entries, min_size=1, max_size=4), frames_of(lettered), st.integers(0, 999))
def test_axes_with_exact_directions_stay_as_they_are(
    given_axes: list[str], home: str, seed: int
) -> None:
    arm = axes(*given_axes, parameters="{L: 0.4137, M: 0.2718}", home=home)
    assert isinstance(arm.geometry, ReferenceAxes)
    assert exact_axes(arm, arm.geometry) is not None
    q = random_joints(arm, 2, seed=seed)
    np.testing.assert_allclose(poses(algebra_of(arm), q), forward(arm, q), atol=1e-12)


@settings(max_examples=20)
@given(st.lists(entries, min_size=1, max_size=6), frames, frames, st.integers(0, 999))
def test_axes_in_any_direction(given_axes: list[str], home: str, tool: str, seed: int) -> None:
    skew = "type: revolute, direction: [1, 2, 3], point: [L, 0, 0.1]"
    arm = axes(*given_axes, skew, parameters="{L: 0.4}", home=home, tool=tool)
    assert isinstance(arm.geometry, ReferenceAxes)
    assert exact_axes(arm, arm.geometry) is None
    chain = build_chain(arm)
    q, tolerance = random_joints(arm, 2, seed=seed), 1e-9 * max(1.0, chain.size)
    np.testing.assert_allclose(numeric_arm(chain).pose(q), forward(arm, q), atol=tolerance)


def test_what_lies_level_with_slanting_axes_is_level() -> None:
    """A planar arm drawn at 30 degrees, in sixteen digits, has no lateral offsets."""
    along = "direction: [-0.5, 0.8660254037844386, 0]"
    arm = axes(
        "type: revolute, direction: [0, 0, 1], point: [0, 0, 0]",
        f"type: revolute, {along}, point: [0.0866025403784438, 0.05, 0.35]",
        f"type: revolute, {along}, point: [0.692820323027551, 0.4, 1.05]",
        home="{xyz: [0.8660254037844386, 0.5, 0.8]}",
    )
    found = {each.meaning: each.value for each in build_chain(arm).constants}
    assert found["joint offset 1"] == 0.35
    assert found["link length 2"] == pytest.approx(-0.1, abs=1e-13)
    assert not any("offset 2" in meaning or "offset 3" in meaning for meaning in found)


def test_nearly_parallel_axes_have_frames_inside_the_arm() -> None:
    """Their common normals are hundreds of metres away: there the tool loses digits."""
    tilted = axes(
        "type: revolute, direction: [0, 0, 1], point: [0, 0, 0]",
        "type: revolute, direction: [0.0003, 1, -0.0002], point: [0, 0, 0.0892]",
        "type: revolute, direction: [-0.0004, 1, 0.0006], point: [-0.425, 0, 0.0892]",
        "type: revolute, direction: [0.0001, 1, -0.0003], point: [-0.8171, 0, 0.0890]",
        "type: revolute, direction: [0.0002, 0.0005, -1], point: [-0.8171, 0.1092, 0.089]",
        "type: revolute, direction: [-0.0002, 1, 0.0001], point: [-0.8173, 0.1092, -0.0057]",
        home="{xyz: [-0.8173, 0.1917, -0.0057], rpy: [-pi/2, 0, 0]}",
    )
    chain = build_chain(tilted)
    assert chain.size < 3.0
    q = random_joints(tilted, 20, seed=1)
    np.testing.assert_allclose(numeric_arm(chain).pose(q), forward(tilted, q), atol=1e-12)


@pytest.mark.parametrize("angle", ["5e-9", "3e-8", "1e-7", "1e-5", "1e-3"])
@pytest.mark.parametrize("apart", [0.0, 0.1])
def test_nearly_parallel_axes_that_meet_do_so_where_they_do(angle: str, apart: float) -> None:
    """One minus the squared cosine of 5e-9 is zero, and of 1e-7 it has two digits."""
    tilted = axes(
        "type: revolute, direction: [0, 0, 1], point: [0.1, 0.2, 0]",
        f"type: revolute, direction: [{angle}, 0, 1], point: [0.1 - {apart}*{angle}, 0.2, 0]",
        "type: revolute, direction: [0.3, 1, 0.2], point: [0.4, 0, 0.3]",
        home="{xyz: [0.6, 0, 0.3]}",
    )
    chain = build_chain(tilted)
    q = random_joints(tilted, 20, seed=1)
    np.testing.assert_allclose(numeric_arm(chain).pose(q), forward(tilted, q), atol=1e-9)
    found = {each.meaning: each.value for each in chain.constants}
    assert found.get("joint offset 1", 0.0) == pytest.approx(apart, abs=1e-6)


def test_coordinates_that_agree_by_value_are_one() -> None:
    arm = axes(
        "type: revolute, direction: [0, 0, 1], point: [0, 0, 0]",
        "type: revolute, direction: [0, 1, 0], point: [0.1, 0, L]",
        parameters="{L: 0.4, M: 0.5}",
        home="{xyz: [0.1, 0, M - 0.1]}",
    )
    assert not any(build_chain(arm).tool.translation)


@pytest.mark.parametrize("slant", ["0, 1, 0", "0.3, 1, 0.2"])
def test_the_size_of_an_arm_is_not_where_it_stands(slant: str) -> None:
    def size(x: float, y: float, base: str) -> float:
        arm = axes(
            f"type: revolute, direction: [0, 0, 1], point: [{x}, {y}, 0]",
            f"type: revolute, direction: [{slant}], point: [{x + 0.1}, {y}, 0.4]",
            f"type: revolute, direction: [{slant}], point: [{x + 0.5}, {y}, 0.4]",
            home=f"{{xyz: [{x + 0.9}, {y}, 0.4]}}",
            base=base,
        )
        return build_chain(arm).size

    here = size(0.0, 0.0, "{}")
    assert 1.0 < here < 3.0
    assert size(10.0, 20.0, "{xyz: [1000, 0, 0]}") == pytest.approx(here, rel=1e-9)


def test_an_offset_that_is_written_is_kept() -> None:
    """However small: the file's own zero is what its cells are taken as."""
    arm = axes(
        "type: revolute, direction: [0, 0, 1], point: [0, 0, 0]",
        "type: revolute, direction: [0, 1, 0], point: [1.2e-9, 0, 0.4]",
        home="{xyz: [0.8, 0, 0.4]}",
    )
    assert 1.2e-9 in {each.value for each in build_chain(arm).constants}
    parts = [part for link in build_chain(arm).links for part in link]
    assert any(part.transform.translation[0] for part in parts if isinstance(part, Fixed))


def test_small_turns_leave_rotations_rotations() -> None:
    """The cosine of 2e-5 is within 1e-9 of 1, its sine is not of 0."""
    arm = axes(
        "type: revolute, direction: [1, 2, 3], point: [0, 0, 0]",
        home="{rpy: [2e-5, -1e-5, 3e-5]}",
    )
    q = np.zeros((1, 1))
    pose = numeric_arm(build_chain(arm)).pose(q)
    np.testing.assert_allclose(pose, forward(arm, q), atol=1e-14)


def test_frames_of_skew_axes_keep_their_roots() -> None:
    """What floating point makes of a root of 2 is that root again."""
    arm = axes(
        "type: revolute, direction: [1, 1, 1], point: [0, 0, 1]",
        "type: revolute, direction: [1, 0, 0], point: [0, 0.5, 1]",
        home="{xyz: [0, 1, 1]}",
    )
    entries = {str(abs(entry.LC)) for row in build_chain(arm).tool.rotation for entry in row}
    assert entries == {"0", "1/2", "1"}  # of sqrt(2), and of 1


@pytest.mark.parametrize("name", NAMES)
def test_the_robots(name: str) -> None:
    found = poses(algebra_of(robot(name)), random_joints(robot(name), 5))
    expected = forward(robot(name), random_joints(robot(name), 5))
    tolerance = 1e-13 * max(1.0, arm_size(robot(name)))
    np.testing.assert_allclose(found, expected, atol=tolerance)


def test_skew_axes_that_are_parallel_make_one_run() -> None:
    # two neighbours along (1, 2, 3): floating point must not hide that they are parallel
    arm = axes(
        "type: revolute, direction: [1, 2, 3], point: [0, 0, 0]",
        "type: revolute, direction: [1, 2, 3], point: [1, 0, 0]",
        "type: revolute, direction: [-2, -4, -6], point: [0, 1, 0]",
    )
    assert parallel_groups(build_chain(arm)) == (((1, 1), (2, 1), (3, -1)),)


def test_runs_of_parallel_axes() -> None:
    expected = {
        "ur5": (((1, 1),), ((2, 1), (3, 1), (4, 1)), ((5, 1),), ((6, 1),)),
        "scara": (((1, 1), (2, 1), (4, 1)),),  # the slide between does not break the run
        "wrist_zyz": (((4 - 3, 1),), ((2, 1),), ((3, 1),)),
        "puma": (((1, 1),), ((2, 1), (3, 1)), ((4, 1),), ((5, 1),), ((6, 1),)),
    }
    assert {name: parallel_groups(build_chain(robot(name))) for name in expected} == expected


def test_a_slide_across_does_not_break_a_run_of_parallel_axes() -> None:
    arm = axes(
        "type: revolute, direction: [0, 0, 1], point: [0, 0, 0]",
        "type: prismatic, direction: [1, 0, 0]",
        "type: revolute, direction: [0, 0, -1], point: [1, 0, 0]",
    )
    algebra = algebra_of(arm)
    assert [run[0][0] for run in parallel_groups(algebra.chain)] == [1]
    q = random_joints(arm, 3)
    np.testing.assert_allclose(poses(algebra, q), forward(arm, q), atol=1e-14)


def test_signs_and_offsets_are_the_joints_business() -> None:
    arm = table("theta: -q + pi/3, a: 1", "theta: pi/2, d: -q + 0.25")
    first, second = build_chain(arm).joints
    assert (first.sign, second.sign) == (-1, -1)
    assert first.offset == pytest.approx(math.pi / 3)
    assert second.offset == 0.25
