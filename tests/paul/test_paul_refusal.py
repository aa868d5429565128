from __future__ import annotations

import pytest

from dhgen.errors import UnsolvedError
from dhgen.kinematics.build import build_chain
from dhgen.method import Method
from dhgen.paul.derive import derive
from dhgen.paul.mobility import Surplus, crowded_axes, determining_tasks
from dhgen.paul.pool import build_pool
from dhgen.paul.problem import build_problem
from dhgen.paul.refusal.free_joint_advice import GENERAL, Choice, choices_text
from dhgen.paul.refusal.other_convention import other_convention
from dhgen.paul.refusal.unsolved import missed_structure, refusal
from dhgen.paul.search import Search
from dhgen.paul.types import CLOSED
from tests.kinematics.values import algebra_of, table

SKEW = (
    "theta: q, d: 0.1, a: 0.2, alpha: 80 deg",
    "theta: q, d: 0.2, a: 0.3, alpha: 20 deg",
    "theta: q, d: 0.1, a: 0.2, alpha: 95 deg",
    "theta: q, a: 0.1",
)


def refused(*rows: str, **sections: str) -> list[str]:
    """The lines of a refusal."""
    with pytest.raises(UnsolvedError) as info:
        derive(build_chain(table(*rows, **sections)))
    return str(info.value).splitlines()


def stuck(*rows: str, **sections: str) -> list[str]:
    """What would be said of an arm with too many joints, if that were not said first."""
    algebra = algebra_of(table(*rows, **sections))
    search = Search(build_pool(build_problem(algebra)), CLOSED)
    assert search.best() is None
    return refusal(search, algebra.chain).splitlines()


FEW = "nearly no pose is in reach, and those few have infinitely many solutions: "


def test_too_many_joints_for_the_task_are_said_first() -> None:
    (first, *_) = refused(*["theta: q, a: 0.3"] * 3, task="[x, y]")
    assert first.startswith("the arm has infinitely many solutions for every pose: joints 1, 2, 3")
    assert "joints 1, 2, 3 can move together" in first


def test_a_joint_that_moves_nothing_is_named_alone() -> None:
    rows = [
        "theta: q, a: 0.3, alpha: 90 deg",
        "theta: q, a: 0.2, alpha: 90 deg",
        "theta: q, d: 0.1",
    ]
    first, second, *rest = refused(*rows, task="[x, y]")
    assert first.endswith("joint 3 can move without changing what the task names")
    assert second == "list it under `free`, to solve for the others given its value"
    assert "`task: orientation` determines every joint" in rest


def test_joints_that_move_nothing_are_named_together() -> None:
    rows = ("theta: q", "theta: q, d: 0.2", "d: q")
    _, second, third, *_ = refused(*rows, task="[z]")
    assert second == "joints 1, 2 can move without changing what the task names"
    assert third == "list them under `free`, to solve for the others given their values"
    first, _, second, third = refused(*rows[:2], task="position")
    assert first == f"{FEW}0 independent motions are left, and the task asks for 3"
    assert second == "joints 1, 2 can move without changing what the task names"
    assert third == "no joint is left to solve for: `task` must name something that the arm moves"


@pytest.mark.parametrize(
    ("rows", "task", "serving"),
    [
        (2, "[x, z]", "[x, y]` determines every joint"),
        (3, "position", "[x, y, yaw]` determines every joint"),
    ],
)
def test_a_coordinate_that_no_joint_moves_is_told(rows: int, task: str, serving: str) -> None:
    head, first, second, third, *_ = refused(*["theta: q, a: 0.3"] * rows, task=task)
    assert head.startswith(FEW)
    assert first == "the task names z, which no joint moves"
    assert "can move together" in second
    assert third == f"`task: {serving}"


def test_a_tool_that_points_along_the_axis_of_the_last_joint() -> None:
    """Its turn is asked for by a pose; a sixth joint is missing for all of them."""
    rows = (
        "theta: q, d: 0.1, alpha: pi/2",
        *["theta: q, a: 0.3"] * 2,
        "theta: q + pi/2, alpha: pi/2",
        "theta: q, d: 0.1",
    )
    lines = refused(*rows, task="pointing")
    assert lines[:2] == [
        f"{FEW}4 independent motions are left, and the task asks for 5",
        "joint 5 can move without changing what the task names",
    ]
    assert lines[3] == "  free: [5] leaves a closed form with 4 rows"
    assert lines[4] == "`task: pose` determines every joint of poses that the arm can take"
    assert derive(build_chain(table(*rows, task="pose"))).method is Method.CLOSED_FORM


@pytest.mark.slow
def test_a_planar_arm_asked_for_a_pose_hears_of_the_task_of_a_plane() -> None:
    lines = refused(*["theta: q, a: 0.3"] * 6, task="pose")
    assert lines[0] == f"{FEW}3 independent motions are left, and the task asks for 6"
    assert "`task: [x, y, yaw]` asks for what they move, and no more" in lines
    enough = refused(*["theta: q, a: 1"] * 3, task="[x, y]")
    assert not any("asks for what" in line for line in enough)


LEVEL = ("theta: q, alpha: pi/2", "theta: q, a: 0.3", "theta: q, a: 0.2", "theta: q, a: 0.1")


def test_a_pitch_is_proposed_where_level_axes_tilt_the_tool() -> None:
    """The arm stands in an upright plane, and what its three angles sum up to is the pitch."""
    lines = refused(*LEVEL, task="position")
    assert "`task: [x, y, z, pitch]` determines every joint" in lines
    assert derive(build_chain(table(*LEVEL, task="[x, y, z, pitch]"))).branches == 8


TURNS = ("theta: q, d: 0.1, alpha: pi/2", "theta: q, alpha: pi/2", "theta: q, d: 0.1")


@pytest.mark.parametrize(
    ("slides", "said"),
    [
        (("d: q", "d: q, alpha: pi/2"), ["joints 1 and 2 slide along one direction"]),
        (
            ("d: q, alpha: pi/2", "d: q, alpha: pi/3", "d: q"),
            ["joints 1, 2 and 3 slide in one plane"],  # twists about x: all are across it
        ),
        (("d: q, alpha: pi/2", "theta: pi/2, d: q, alpha: pi/2", "d: q"), []),
        (("d: q, alpha: pi/2", "theta: q, alpha: -pi/2", "d: q"), []),  # a turn takes them apart
    ],
)
def test_slides_that_leave_a_joint_too_many_are_the_reason(
    slides: tuple[str, ...], said: list[str]
) -> None:
    assert crowded_axes(build_chain(table(*slides, *TURNS))) == said


@pytest.mark.parametrize("third", ["theta: q, a: 0.2, alpha: pi/4", "theta: q + pi/7, a: 0.2"])
def test_a_pitch_that_is_no_sum_of_angles_is_not_proposed(third: str) -> None:
    """Behind a twist the tool leaves the plane; the second arm keeps to it."""
    tasks = determining_tasks(build_chain(table(*LEVEL[:2], third, LEVEL[3])))
    assert ("[x, y, z, pitch]" in tasks) == ("alpha" not in third)


def test_where_no_other_task_serves_none_is_named() -> None:
    head, first, *lines = refused(*["theta: q, a: 0.3"] * 4, task="[x, z]")
    assert head == f"{FEW}1 independent motion is left, and the task asks for 2"
    assert first == "the task names z, which no joint moves"
    assert not any("task:" in line for line in lines)


SLIDES = ("d: q, alpha: pi/2", "theta: pi/2, d: q, alpha: pi/2", "theta: pi/2, d: q")


@pytest.mark.parametrize(
    ("free", "said"),
    [
        ("[3, 4, 5]", "list joints 1, 4, 5 under `free` in place of joints 3, 4, 5, to solve"),
        ("[3]", "list joints 1, 4, 5 under `free` in place of joint 3, to solve for the others"),
        ("[5]", "list them under `free` too, to solve for the others given their values"),
    ],
)
def test_where_some_joints_are_free_the_whole_list_is_named(free: str, said: str) -> None:
    rows = (*SLIDES, "theta: q, alpha: pi/2", "theta: q")
    lines = refused(*rows, task="[x, y]", free=free)
    why, which = (i for i, line in enumerate(lines) if " given, joint" in line or said in line)
    assert f"with joint{'s' * (len(free) > 3)} {free[1:-1]} given, joint" in lines[why]
    assert lines[which].startswith(said)
    assert lines[which + 1] == "  free: [1, 4, 5] leaves a closed form with one row"


def test_one_more_free_joint_is_named_with_those_that_are_there() -> None:
    lines = refused(*["theta: q, a: 0.3"] * 4, task="[x, y]", free="[2]")
    assert lines[0].endswith(
        "with joint 2 given, joints 1, 3, 4 can move together without changing what the task names"
    )
    assert lines[1].startswith(
        "list one of them under `free` too, to solve for the others given its value"
    )
    assert lines[2].startswith("  free: [1, 2] or [2, 3] or [2, 4] leaves a closed form")


def test_axes_that_are_nearly_one_line_are_told_so() -> None:
    _, second, *_ = refused("theta: q, a: 1e-3", "theta: q, a: 1e6", task="[x, y]")
    assert second == "axes 1 and 2 are 0.001 apart, which at the arm's size counts as one line"


@pytest.mark.breadth
def test_axes_that_leave_a_joint_too_many_are_the_reason() -> None:
    """Six joints on five lines: a pose is in reach only by chance, and then joints 5, 6 turn."""
    first, second, third, *_ = refused(*SKEW, "theta: q, d: 0.2", "theta: q")
    assert first == f"{FEW}5 independent motions are left, and the task asks for 6"
    assert second == "axes 5 and 6 are the same line"
    assert third.startswith("joints 5, 6 can move together")


SAME_LINE = (
    "theta: q, d: 0.4, alpha: pi/2",
    "theta: q, a: 0.5",
    "theta: q, a: 0.1, alpha: pi/2",
    "theta: q, d: 0.4, alpha: -pi/2",
    "theta: q",
    "theta: q, d: 0.1",
)


UR = (
    "theta: q, d: 0.089, alpha: pi/2",
    "theta: q, a: -0.425",
    "theta: q, a: -0.392",
    "theta: q, d: 0.109, alpha: pi/2",
    "theta: q, d: 0.095, alpha: -pi/2",
    "theta: q, d: 0.082",
)
PUMA_BY_CRAIG = (
    "theta: q",
    "theta: q, alpha: -pi/2",
    "theta: q, a: 0.43, d: 0.12",
    "theta: q, a: -0.02, d: 0.43, alpha: -pi/2",
    "theta: q, alpha: pi/2",
    "theta: q, alpha: -pi/2",
)


@pytest.mark.parametrize(
    ("rows", "own", "said"), [(UR, "standard", "modified"), (PUMA_BY_CRAIG, "modified", "standard")]
)
def test_a_table_under_the_other_convention_is_told_so(
    rows: tuple[str, ...], own: str, said: str
) -> None:
    (line,) = other_convention(table(*rows, convention=said))
    assert line.startswith(f"with `convention: {own}` this table is an arm whose joints all count")
    assert not other_convention(table(*rows, convention=own))


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_an_arm_that_neither_convention_makes_proper_gets_no_such_line(convention: str) -> None:
    assert other_convention(table(*SAME_LINE, convention=convention)) == []
    assert other_convention(table(*["theta: q, a: 0.3"] * 3, task="[x, y]")) == []


SRS = ("-pi/2", "pi/2") * 3  # twists of an arm of seven joints, each axis square to the next


@pytest.mark.parametrize("own", ["standard", "modified"])
def test_a_table_of_seven_joints_under_the_other_convention_is_told_so(own: str) -> None:
    """The first or last two axes are one line then, and six joints are left, as many as count."""
    lengths = ("0.34", "0", "0.4", "0", "0.4", "0", "0.12")
    twists = (*SRS, "0") if own == "standard" else ("0", *SRS)
    rows = [f"theta: q, d: {d}, alpha: {alpha}" for d, alpha in zip(lengths, twists, strict=True)]
    other = "modified" if own == "standard" else "standard"
    (line,) = other_convention(table(*rows, convention=other))
    assert line.startswith(f"with `convention: {own}` no two neighbouring axes of this table are")
    assert not other_convention(table(*rows, convention=own))


@pytest.mark.breadth  # it derives all that is said
def test_what_free_joints_are_said_to_leave_comes_out() -> None:
    """Of five joints asked for a whole pose, without three axes that belong together."""
    (advice,) = (line for line in refused(*SAME_LINE) if line.startswith("  free: "))
    assert advice == "  free: [5] or [6] leaves a closed form with 4 rows"
    for free in "[5]", "[6]":
        left = derive(build_chain(table(*SAME_LINE, free=free)))
        assert (left.method, left.branches) == (Method.CLOSED_FORM, 4)


MEETING = ("theta: q, alpha: 80 deg", "theta: q, alpha: 20 deg", "theta: q, alpha: 95 deg")
PARALLEL = ("theta: q, a: 0.3",) * 3


def test_a_spherical_wrist_that_points_is_said_to_leave_its_eight_rows() -> None:
    """The tool lies on axis 6, so the wrist centre is known, as for whole poses."""
    rows = (
        "theta: q, d: 0.6, alpha: -pi/2",
        "theta: q, d: 0.2, a: 0.4",
        "theta: q, a: 0.02, alpha: pi/2",
        "theta: q, d: 0.4, alpha: -pi/2",
        "theta: q, alpha: pi/2",
        "theta: q, d: 0.06",
    )
    assert "  free: [6] leaves a closed form with 8 rows" in refused(*rows, task="pointing")
    robot = table(*rows, task="pointing", free="[6]")
    assert derive(build_chain(robot)).branches == 8


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        (["theta: q"] * 3, ["axes 1, 2 and 3 are the same line"]),
        ([SKEW[0], *PARALLEL, *SKEW[:2]], ["axes 2, 3, 4 and 5 are parallel"]),
        ([*SKEW[:2], *MEETING, "theta: q"], ["axes 3, 4, 5 and 6 meet in one point"]),
        (PARALLEL, []),
        ([*MEETING[:2], "theta: q, a: 0.1"], []),
        ([*SKEW[:2], "d: q", "theta: q"], []),
        (["theta: q", "theta: q", SKEW[0], "theta: q"], ["axes 1, 2 and 3 are the same line"]),
    ],
)
def test_lines_and_points_that_axes_share(rows: list[str], said: list[str]) -> None:
    assert crowded_axes(build_chain(table(*rows))) == said


def test_the_nearest_equations_are_named_by_their_place() -> None:
    lines = stuck(*["theta: q, a: 0.3"] * 3, task="[x, y]")
    assert lines[0] == "no order of equations solves for every joint; still unknown: 1, 2, 3"
    assert "  theta1, theta12, theta123 in U0[1, 4], U0[2, 4]" in lines
    assert lines[-2] == "  axes 1, 2, 3 are parallel"
    assert lines[-1].startswith("--numerical would give")


def test_a_wrist_that_nearly_meets() -> None:
    arm = (
        "theta: q, d: 0.4, a: 0.1, alpha: 50 deg",
        "theta: q, d: 0.1, a: 0.5, alpha: 30 deg",
        "theta: q, d: 0.2, a: 0.1, alpha: 75 deg",
    )
    wrist = ("theta: q, d: 0.5, alpha: -pi/2", "theta: q, d: 0.0321, alpha: pi/2")
    # the general algorithm solves it; what it misses is said all the same
    chain = build_chain(table(*arm, *wrist, "theta: q, d: 0.1"))
    assert "  axes 4, 5, 6 miss one point by 0.0321" in missed_structure(chain)
    assert "  axes 4, 5, 6 miss one point by 0.0321 mm" in missed_structure(chain, "mm")


def test_a_scara_that_was_calibrated() -> None:
    rows = ("theta: q, a: 0.4", "theta: q, a: 0.3, alpha: pi - 0.0001", "d: q", "theta: q, d: 0.1")
    chain = build_chain(table(*rows, task="pointing"))
    assert missed_structure(chain)[1:] == ["  axes 1, 2, 4 are 0.00573 deg from parallel"]


def test_reasons_stand_with_the_types_that_give_them() -> None:
    lines = stuck(*SKEW, task="[x, y, z]")
    assert len(lines) <= 25
    assert "no three consecutive axes are parallel or meet in one point, not even nearly" in lines
    assert "    type 2: the unknown is not a single angle" in lines
    assert "    types 1, 10: the unknown is not a single length" in lines


def test_what_was_found_before_the_end_is_named() -> None:
    # height comes from the slide alone, the plane has one joint too many
    lines = stuck("theta: 0, d: q", *["theta: q, a: 0.3"] * 3, task="[x, y, z]")
    assert "with r1 known, the equations with the fewest unknowns contain" in lines
    assert lines[0].endswith("; still unknown: 2, 3, 4")


def test_good_free_joints_are_named() -> None:
    lines = refused(*["theta: q, a: 0.3"] * 3, task="[x, y]")
    assert "  free: [1] or [2] or [3] leaves a closed form with 2 rows" in lines
    assert lines[-1].startswith("--numerical would give")


def test_any_joint_of_a_skew_arm_leaves_a_general_one() -> None:
    lines = refused(*SKEW, *SKEW[:3])
    assert "joints 1, 2, 3, 4, 5, 6, 7 can move together" in lines[0]
    each = " or ".join(f"[{joint}]" for joint in range(1, 8))
    assert f"  free: {each} leaves a general 6R with 16 rows" in lines


def test_many_joints_are_refused_without_their_products(monkeypatch: pytest.MonkeyPatch) -> None:
    """Multiplied out they fill much memory."""
    monkeypatch.setattr("dhgen.paul.derive.build_problem", None)
    lines = refused(*(SKEW * 4)[:14])
    assert lines[1].startswith("list 8 of them under `free`")
    assert "  only some of the 3003 sets of 8 joints were tried" in lines


def test_of_very_many_sets_of_free_joints_some_are_tried() -> None:
    lines = refused(*["theta: 0, d: q", "theta: pi/2, d: q, alpha: pi/2"] * 3)
    (free,) = (line for line in lines if line.startswith("  free: "))
    assert free.endswith("leaves a closed form with one row")
    assert "  only some of the 20 sets of 3 joints were tried" in lines


def test_of_many_sets_of_free_joints_the_first_few_are_shown() -> None:
    freed = [tuple(joint for joint in range(1, 21) if joint != held) for held in range(20, 4, -1)]
    choices = tuple(Choice(GENERAL, 16, free, Method.GENERAL_6R) for free in freed)
    spare = Surplus(19, tuple(range(1, 21)))
    first = list(freed[0])
    for many, more in (16, "one of 15 more sets"), (2, "another set"):
        told = f"  free: {first} or {more} leaves a general 6R with 16 rows"
        assert choices_text(choices[:many], spare)[0] == told


def twisted(count: int) -> tuple[str, ...]:
    """Rows whose axes are across one another in turn."""
    return tuple(f"theta: q, d: 0.1, a: 0.1, alpha: {'-' * (k % 2)}pi/2" for k in range(count))


def test_products_that_would_fill_the_memory_are_not_begun() -> None:
    first, second = refused(*twisted(21))
    assert first.startswith("the axes of this arm change direction 20 times: its products would")
    assert second == "solve a part of it, with the rest in `base` and `tool`"
    snake = build_chain(table(*["theta: q, a: 0.1"] * 40, task="[x, y]"))
    assert derive(snake, numerical=True).method is Method.NUMERICAL


def test_more_joints_than_may_be_given_are_not_asked_for() -> None:
    free = str(list(range(1, 10)))
    first, second = refused(*twisted(15), free=free)
    assert first.startswith("up to 8 joints may be given: with the 9 under `free`, the equations")
    assert second.endswith("with these in `base`, or use --numerical")
    chain = build_chain(table(*twisted(15), free=free))
    assert derive(chain, numerical=True).method is Method.NUMERICAL
    _, second, third = refused(*twisted(15))
    assert second == "9 are too many to be given under `free`: 8 may be"
    assert third.startswith("--numerical would give")
    assert "list 8 of them under `free`, to solve for the others" in refused(*twisted(14))[1]
