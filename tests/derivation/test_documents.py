"""The documents of all robots: sections, formulas that GitHub reads, trees, summaries."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import product

import pytest

from dhgen.derivation import (
    alternatives_text,
    derivation_document,
    derivation_summary,
    derivation_terminal,
    tool_at_zero,
)
from dhgen.derivation.sections.closing import tree_text
from dhgen.derivation.sections.transforms import PAGE
from dhgen.derivation.story import Story
from dhgen.derivation.summary import CHECKED
from dhgen.derivation.types import PRINTERS
from dhgen.kinematics.build import build_chain
from dhgen.paul.kind import Kind
from dhgen.robot.load import load
from tests.derivation.golden import FOLDER, made
from tests.derivation.golden import NAMES as GOLDEN
from tests.derivation.made import made_of
from tests.derivation.stories import (
    ALL_WHOLE,
    EACH,
    WITH_STEPS,
    document,
    story,
    story_of,
)
from tests.kinematics.values import table
from tests.robots.cases import ROBOTS

CALIBRATED = "Arms with tables of their own"
SECTIONS = [
    "The robot",
    "Coupled drives",
    "Forward",
    "Inverse",
    "The solutions",
    "An example",
    "Choosing a row",
    "Singular configurations",
    CALIBRATED,
    "Velocity",
]


def sections_of(name: str) -> list[str]:
    """Those of the document of an arm that is solved step by step."""
    chain = build_chain(load(ROBOTS / f"{name}.yaml"))
    coupled = chain.drives.are_coupled or chain.passive
    missing = {"Coupled drives"} if not coupled else set()
    robot = load(ROBOTS / f"{name}.yaml")
    if not any(joint.limits for joint in robot.joints) and "   row 1" not in document(name):
        missing.add("Choosing a row")
    if "## Velocity\n" not in document(name):  # which arms have it, test_velocity knows
        missing.add("Velocity")
    if not robot.calibration:
        missing.add(CALIBRATED)
    return [section for section in SECTIONS if section not in missing]


@pytest.mark.parametrize("name", GOLDEN)
def test_golden(name: str) -> None:
    expected = (FOLDER / f"{name}.md").read_text(encoding="utf-8")
    assert made(name) == expected


@pytest.mark.parametrize("name", WITH_STEPS)
def test_sections_in_order(name: str) -> None:
    text = document(name)
    assert re.findall(r"^## (.*)$", text, re.MULTILINE) == sections_of(name)
    steps = [int(number) for number in re.findall(r"^\*\*(\d+)\. \$", text, re.MULTILINE)]
    assert steps == list(range(1, len(steps) + 1))
    assert steps


@pytest.mark.parametrize("name", ALL_WHOLE)
def test_sections_of_an_arm_without_steps(name: str) -> None:
    found = re.findall(r"^## (.*)$", document(name), re.MULTILINE)
    assert found[:2] == ["The robot", "Forward"]
    assert found[2].startswith("Inverse")
    assert found[3:] == ["An example", "Singular configurations", "Velocity"]


@pytest.mark.parametrize("name", WITH_STEPS)
def test_every_type_that_a_step_cites_is_told(name: str) -> None:
    text = document(name)
    cited = re.findall(r"^\*\*\d+\..* — type (\d)", text, re.MULTILINE)
    told = re.findall(r"^\| (\d) \| \$.*\$ \| ([\d, ]+) \|$", text, re.MULTILINE)
    steps = {int(step): kind for kind, steps in told for step in steps.split(", ")}
    assert [steps[number] for number in sorted(steps)] == cited
    assert [kind for kind, _ in told] == sorted(set(cited))


@pytest.mark.parametrize("name", ["general_6r", "spherical_wrist_general_arm"])
def test_a_forward_model_is_no_longer_than_a_few_pages(name: str) -> None:
    """What can't be read is a product of what can: its truth is held to as all other formulas."""
    forward = document(name).split("## Inverse")[0]
    assert "T_6^0 = T_5^0 A_6" in forward.replace("&", "").replace("  ", " ")
    assert len(forward.splitlines()) < 4 * PAGE


def test_rows_are_said_to_keep_their_place_only_where_they_do() -> None:
    keeps = "each always in the same one"
    assert keeps in document("scara")
    assert keeps not in document("concurrent_345")
    assert keeps not in document("xarm6")


def test_roots_ascend_and_their_rows_do_not_keep_their_places() -> None:
    ends = "A branch ends where a square root has a negative argument; its rows are empty and the"
    ascend = "The roots are in the order of their angles, from root 1; where there are fewer than"
    under = "Under each root a branch ends where a square root has a negative argument; its row is"
    for name, told in {
        "scara": (True, False, False),
        "cuspidal_3r": (False, True, False),
        "parallel_123": (False, True, True),
    }.items():
        assert tuple(each in document(name) for each in (ends, ascend, under)) == told


def test_half_a_turn_is_a_root_that_the_half_angle_s_tangent_misses() -> None:
    for name, joint in (("cuspidal_3r", "1"), ("concurrent_345", "6")):
        told = "Where the coefficient of $x^4$ vanishes, half a turn is a value of "
        assert told + rf"$\theta_{joint}$ too." in document(name)


def test_two_roots_that_meet_are_a_singular_configuration() -> None:
    row = "| 1 | two roots of the equation meet | {} | two solutions become one; they count once"
    assert row.format(r"$\det J = 0$") in document("parallel_123")
    factor = "$c_2 (a_2 s_3 - d_2 c_3) + a_1 s_3 = 0$"
    assert row.format(factor) in document("cuspidal_3r")


def test_a_second_equation_is_told_with_its_element_and_in_numbers() -> None:
    text = document("kuka_youbot")
    elements, step = text.split("**1. $")[:2]
    assert "U_1[3,3] & = s_1 t_{13} - c_1 t_{23} = 0" in elements
    size = r"With $\ell = 0.6875$ m, the arm's size (the sum of all its lengths), and "
    assert size + r"$\mathrm{sgn}(0) = 1$:" in step
    assert r"\hat X & = X + \sigma \ell X'" in step  # a length and a number


def test_an_arm_near_to_a_closed_form_is_told_so() -> None:
    """The offset of the xArm's wrist is 76 mm; Manseur and Doty's arm is near to nothing."""
    assert "axes 4, 5 and 6 do not meet in one point" in document("xarm6")
    assert "from a closed form" not in document("manseur_doty")


@pytest.mark.parametrize("name", [*WITH_STEPS, *ALL_WHOLE])
def test_formulas_are_left_alone_by_markdown(name: str) -> None:
    """Inside a line, what Markdown takes for its own stands between dollars and backquotes.

    A bracket with a space behind opens no tag. \\lt and \\gt, which TeX itself lacks, are nowhere:
    pandoc makes LaTeX of these documents.
    """
    assert not re.search(r"\\[lg]t\b", document(name))
    text = re.sub(r"```.*?```", "", document(name), flags=re.DOTALL)
    for safe in re.findall(r"\$`[^`]*`\$", text):
        text = text.replace(safe, "")
    text = text.replace(r"\$", "")
    assert text.count("$") % 2 == 0
    for formula in re.findall(r"\$([^$]*)\$", text):
        assert not re.search(r"\}_|\\[^A-Za-z]|[|*`]|[<>](?! )", formula), formula


@pytest.mark.parametrize("name", [*WITH_STEPS, *ALL_WHOLE])
def test_braces_are_balanced(name: str) -> None:
    for formula in re.findall(r"```math\n(.*?)\n```", document(name), re.DOTALL):
        assert formula.count("{") == formula.count("}")
        assert formula.count(r"\begin") == formula.count(r"\end")


@pytest.mark.parametrize("name", EACH)
def test_the_tree_has_a_leaf_for_every_row(name: str) -> None:
    of = story(name)
    lines = tree_text(of).splitlines()
    assert len(lines) == of.program.rows
    leaves = [re.search(r"row (\d+)", line) for line in lines]
    assert [int(leaf[1]) for leaf in leaves if leaf] == list(range(of.program.rows))


def test_the_tree_of_an_arm_with_three_signs() -> None:
    lines = tree_text(story("arm_6r")).splitlines()
    signs: dict[int, str] = {}
    for line, choice in zip(lines, product(("+1", "−1"), repeat=3), strict=True):
        for place, value in re.findall(r"ε([₁₃₄]) = ([+−]1)", line):
            signs["₁₃₄".index(place)] = value
        assert tuple(signs[place] for place in range(3)) == choice


@pytest.mark.parametrize("name", EACH)
def test_the_terminal_says_the_same(name: str) -> None:
    of = story(name)
    text = derivation_terminal(of)
    for section in sections_of(name):
        assert f"\n{section}\n{'-' * len(section)}\n" in text
    assert "$" not in text
    assert "\\" not in text
    assert tree_text(of).splitlines()[-1] in text


@pytest.mark.parametrize("name", EACH)
def test_summary(name: str) -> None:
    of = story(name)
    text = derivation_summary(of)
    lines = text.splitlines()
    for number, step in enumerate(of.steps, start=1):
        assert lines[number - 1].startswith(f"{number}. ")
        assert f"type {step.kind.number}" in lines[number - 1]
    assert len(lines) <= 16


@pytest.mark.parametrize(
    ("rows", "enough"),
    [
        (("theta: q, a: 0.4", "theta: q, a: 0.3"), ["[x, y]"]),
        (("theta: q, alpha: pi/2", "theta: q, a: 0.3", "theta: q, a: 0.2"), ["position"]),
        (("theta: q, a: 0.4", "theta: q, a: 0.3", "theta: q, a: 0.2"), ["[x, y, yaw]"]),
        (
            ("theta: q, alpha: pi/2", *(f"theta: q, a: 0.{n}" for n in (3, 2, 1))),
            ["[x, y, z, pitch]"],
        ),
    ],
)
def test_a_task_that_asks_for_as_much_as_the_arm_can_choose_is_named(
    rows: tuple[str, ...], enough: list[str]
) -> None:
    of = story_of(table(*rows))
    lines = derivation_summary(of).splitlines()
    told = [f"`task: {task}` would ask for as much as it can" for task in enough]
    assert lines[lines.index(CHECKED) + 1 :] == told


@pytest.mark.parametrize(
    ("rows", "sections", "told"),
    [  # worked out by hand: links along x, twists about it, the tool along its own z
        (("theta: q, a: 0.4", "theta: q, a: 0.3"), {}, "x 0.7, y 0, z 0 m; rpy 0, 0, 0 deg"),
        (("theta: q + pi/2, d: 1, a: 2",), {}, "x 0, y 2, z 1 m; rpy 0, 0, 90 deg"),
        (
            ("theta: q, a: 2, alpha: -pi/2",),
            {"tool": "{xyz: [0, 0, 5]}"},
            "x 2, y 5, z 0 m; rpy ",
        ),
        (("theta: q",), {"tool": "{rpy: [0, pi/2, pi/6]}"}, "x 0, y 0, z 0 m; rpy 0, 90, 30 deg"),
        (("theta: q - pi",), {}, "x 0, y 0, z 0 m; rpy 0, 0, 180 deg"),
        (("d: q, a: 120",), {"units": "{length: mm}"}, "x 120, y 0, z 0 mm; rpy 0, 0, 0 deg"),
    ],
)
def test_the_tool_at_zero(rows: tuple[str, ...], sections: dict[str, str], told: str) -> None:
    robot = table(*rows, **sections)
    line = tool_at_zero(build_chain(robot), robot.length_unit)
    assert line.startswith(f"tool at q = 0: {told}")


def test_alternatives_name_the_way_of_document_003() -> None:
    text = alternatives_text(story("scara").derivation)
    assert re.search(r"type 6, two values, U₁\[1,4\] and U₁\[2,4\]", text)
    assert len(re.findall(r"\(taken\)$", text, re.MULTILINE)) == len(story("scara").steps)


@pytest.mark.parametrize("name", ["katana_400", "kuka_youbot", "scorbot_pointing", "xarm5"])
def test_what_protects_a_plain_formula_comes_after_it(name: str) -> None:
    """The arm lies in an upright plane through axis 1, and so does the tool: any book begins so."""
    first = document(name).split("**1. ")[1].split("**2. ")[0]
    plain = re.search(r"atan2\}\((-?)\\varepsilon_1 t_\{24\}, \1\\varepsilon_1 t_\{14\}\)", first)
    assert plain
    assert plain.start() < first.index("are small, this says little")
    assert first.index("this says little") < first.index(r"\varepsilon_1 \hat X")


def test_every_type_has_a_printer() -> None:
    assert set(PRINTERS) == set(Kind)


def test_what_the_pose_leaves_of_a_free_joint_is_said() -> None:
    """Where the tool's y axis is upright a few values of joint 1 let this arm take the pose."""
    rows = (
        "theta: q, d: 0.4, alpha: pi/2",
        "theta: q, a: 0.3, alpha: pi/2",
        "theta: q, alpha: pi/2",
        "theta: 0, d: q",
    )
    text = made_of(*rows)
    assert r"every $\theta_1$ works" not in text
    told = r"this equation holds for every $\theta_1$, and the others decide which values work"
    assert told in text
    assert "every $" in document("spherical")
    assert "this equation holds for every" not in document("spherical")


def test_what_the_pose_leaves_of_a_slide_is_said() -> None:
    """Where cos theta_4 is zero the slide's equation says nothing, and two lengths work."""
    rows = (
        "theta: q, a: 0.25, alpha: 60 deg",
        "theta: q, d: 0.25, alpha: 90 deg",
        "theta: -90 deg, d: 0.25 - q, alpha: 45 deg",
        "theta: q, d: 0.25, a: 0.25, alpha: 90 deg",
        "theta: q, d: 0.25, a: 0.25",
    )
    text = made_of(*rows)
    assert "every $r_3$ works" not in text
    assert "this equation holds for every $r_3$ if $Y = 0$, and the others decide" in text


def test_numbers_of_a_frame_are_not_called_its_entries() -> None:
    rows = "theta: q, a: 0.4", "theta: q, a: 0.3*cos(0.2)"
    text = made_of(*rows, base="{rpy: [0, 0, 15 deg]}", tool="{rpy: [0, 0, 0.3]}", task="[x, y]")
    assert not re.search("[ez]_{[0-9]", text)
    assert r"Z = \begin{bmatrix} \frac{\sqrt{2}}{4} (1 + \sqrt{3})" in text
    assert "(cosine of an angle in link length 2)" in text
    assert "(sine of an angle in the tool frame)" in text
    assert r"E = \begin{bmatrix} \cos \eta_2 & -\sin \eta_2 & 0 & 0 \\" in text


def test_a_parameter_s_cosine_is_called_its_own_and_no_sine_is_listed_for_nothing() -> None:
    rows = "theta: q, a: 0.4", "theta: q, a: cos(w)/4", "theta: q, d: 0.1*sin(-v)"
    text = made_of(*rows, parameters="{w: 30 deg, v: 0.3}", task="[x, y, z]", free="[3]")
    assert "(cosine of the parameter w)" in text
    assert "sine of the parameter w" not in text.replace("cosine", "")
    assert "(sine of the parameter v, without its sign)" in text
    assert "an angle in" not in text


def test_cells_that_are_taken_as_exact_are_said() -> None:
    rows = "theta: q - 1.57079632679, a: 1e-9, alpha: 1.5707963268", "theta: -q, a: 0.4", "d: q"
    text = made_of(*rows, tool="{xyz: [0, 0.2, -1e-10]}", task="position")
    told = (
        r"theta of joint 1 as $q - \pi/2$ in place of q - 1.57079632679, a of joint 1 as $0$ in "
        r"place of 1e-9, alpha of joint 1 as $\pi/2$ in place of 1.5707963268 and entry 3 of xyz "
        "of tool as $0$ in place of -1e-10."
    )
    assert f"\nCells within 1e-9 of an exact value are taken as it: {told}\n" in text
    exact = made_of("theta: q, a: 0.4", "theta: q, a: 0.3, alpha: 90 deg", task="[x, y]")
    assert "are taken as it" not in exact


def test_a_point_of_the_base_has_the_letter_of_its_coordinates() -> None:
    text = document("franka_panda")
    assert "w_{2x} & = " in text
    assert "Seen from the last frame it is at $w_2$:" in text


def test_the_square_of_a_cosine_is_not_that_of_its_angle() -> None:
    assert r"\cos^2 \alpha_2" in document("manseur_doty")
    assert r"\alpha_2^2" not in document("manseur_doty")


def test_directions_do_not_meet_an_axis() -> None:
    """The last step of both compares directions; in one of them they are never parallel."""
    assert "lies on axis 6" not in document("spherical_wrist_general_arm")
    assert "every $\\theta_4$ works" not in document("concurrent_345")
    assert r"Y_1 & = \frac{1}{2} \\" in document("concurrent_345")


def test_other_forms_than_those_of_paul_are_announced() -> None:
    right, seen = "and so on from the right.", "in which a frame of the base is seen from the tool"
    assert right in document("ur5")
    assert seen not in document("ur5")
    assert right in document("concurrent_345")
    assert seen in document("concurrent_345")
    assert right not in document("puma560")


def test_why_the_squares_hold_one_angle_is_said() -> None:
    assert r"alone, because $\theta_{23} - \theta_2 = \theta_3$:" in document("puma560")
    assert r"alone, because $\theta_2 - \theta_{2-3} = \theta_3$:" in document("comau_ns16")


def test_where_all_coefficients_vanish_is_said_in_words() -> None:
    of = story("cuspidal_3r")
    told = (
        "all coefficients of the equation vanish at once, for instance where the tool's origin "
        "lies on axis 1 in a pose that can be reached"
    )
    assert f"\nDegenerate when {told}: every $" in document("cuspidal_3r")
    assert f"| {told} | no short form | every $" in document("cuspidal_3r")
    summary = derivation_summary(of)
    assert f"degenerate where {told}: every θ₁ works" in summary


@pytest.mark.parametrize("name", WITH_STEPS + ALL_WHOLE)
def test_the_reader_is_told_which_documents_are_cited(name: str) -> None:
    text = document(name)
    told = re.findall(r"^Documents? ([\d, and]+), cited here by number", text, re.MULTILINE)
    cited = re.findall(r"[Dd]ocument (\d{3})", text)
    assert len(told) <= 1
    assert set(re.findall(r"\d{3}", "".join(told))) == set(cited)


def test_the_degree_of_a_general_arm_is_that_of_its_solutions() -> None:
    assert r"of degree 16 in $\tan\frac{\varphi}{2}$, with at most sixteen roots" in document(
        "general_6r"
    )
    assert r"of degree 8 in $\tan\frac{\varphi}{2}$, with at most eight roots" in document(
        "general_4r2p"
    )
    for name, degree in (("general_6r", "16 in tan(θ6/2)"), ("general_5r1p", "16 in ")):
        of = story(name)
        summary = derivation_summary(of)
        assert f"a polynomial of degree {degree}" in summary
    assert "An arm of this kind has" in document("general_6r")
    assert "a turn behind them are found together" in document("general_5r")
    assert "Together they have at most sixteen solutions" in document("general_5r")


def test_texts_of_the_user_are_escaped() -> None:
    of = story("planar_rr")
    robot = replace(of.robot, title="A *bold* <b>arm</b> | $x$", source="see [here](http://x.y)_")
    text = derivation_document(Story(robot, of.derivation, of.program), "robots/x.yaml")
    assert r"# A \*bold\* \<b\>arm\</b\> \| \$x\$: inverse kinematics" in text
    assert r"see \[here\](http://x.y)\_" in text


def test_a_parameter_never_shares_its_letter() -> None:
    """The PUMA's D4 is a length, so the signed roots are called F."""
    text = document("puma")
    assert "D_4 c_{23}" in text
    assert "F_4 = " in text
