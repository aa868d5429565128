"""`dhgen calibrate`: the robot file against products of matrices written out here."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest
from ruamel.yaml import YAML

from dhgen.cli import main
from dhgen.kinematics.build import build_chain
from dhgen.oracle.forward import forward
from dhgen.robot.load import load
from dhgen.robot.robot import DhTable, ReferenceAxes
from tests.calibration.products import of_deltas, of_origins
from tests.compiling import library, written

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray

ROBOTS = Path(__file__).resolve().parents[2] / "robots"
MEASURED = Path(__file__).with_name("ur5e_calibration.yaml")
# As Universal Robots' description has it: the table of robots/ur5e.yaml in other words.
NOMINAL = """kinematics:
  shoulder: {x: 0, y: 0, z: 0.1625, roll: 0, pitch: 0, yaw: 0}
  upper_arm: {x: 0, y: 0, z: 0, roll: 1.570796326794897, pitch: 0, yaw: 0}
  forearm: {x: -0.425, y: 0, z: 0, roll: 0, pitch: 0, yaw: 0}
  wrist_1: {x: -0.3922, y: 0, z: 0.1333, roll: 0, pitch: 0, yaw: 0}
  wrist_2: {x: 0, y: -0.0997, z: 0, roll: 1.570796326794897, pitch: 0, yaw: 0}
  wrist_3: {x: 0, y: 0.0996, z: 0, roll: 1.570796326589793, pitch: 3.141592653589793,
            yaw: 3.141592653589793}
"""
DELTAS = """deltas:
  - {theta: 1e-4, d: 1e-4, a: 2e-5, alpha: -3e-4}
  - {theta: 2e-4, a: 1e-4, alpha: 2e-4, beta: 1e-4}
  - {a: -1.5e-4}
  - {d: 1e-4, alpha: 1e-3, beta: -3e-4}
  - {}
  - {theta: -2e-3, alpha: 1e-4}
"""
# Of a UR10e, to a row whose common normals are 100 m away from the arm.
FAR = """deltas:
  - {theta: -0.0000418, d: 0.00017, a: 0.000183, alpha: -0.00069633}
  - {theta: -0.46364401, d: -122.43893069, a: 0.06513069, alpha: 0.00223607}
  - {theta: 0.12848779, d: 22.68952974, a: 0.03196714, alpha: 0.00188489}
  - {theta: 0.33512877, d: 99.75012303, a: -0.00000772, alpha: -0.00089633}
  - {theta: 0.00009265, d: 0.00012051, a: 0.00005179, alpha: -0.00059633}
  - {theta: 0, d: -0.00006698}
"""


@pytest.fixture(autouse=True)
def _folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def calibrated(robot: str, calibration: str | Path, *words: str) -> int:
    """What the command ends with."""
    if isinstance(calibration, str):
        Path("measured.yaml").write_text(calibration, encoding="utf-8")
        calibration = Path("measured.yaml")
    return main(["calibrate", str(ROBOTS / f"{robot}.yaml"), "--from", str(calibration), *words])


def joint_values(count: int) -> FloatArray:
    return np.random.default_rng(5).uniform(-np.pi, np.pi, (count, 6))


def test_origins_as_drivers_extract_them(capsys: pytest.CaptureFixture[str]) -> None:
    assert calibrated("ur5e", MEASURED) == 0
    told = capsys.readouterr()
    assert told.out.startswith("ur5e_calibrated: the tool is up to 0.0017 m and ")
    assert "axes 2 and 3 miss being parallel by 0.0026 rad" in told.err
    robot = load("ur5e_calibrated.yaml")
    assert robot.source == "ur5e with the calibration calib_6423711872134 of ur5e_calibration.yaml"
    assert [joint.limits for joint in robot.joints] == [(-2 * np.pi, 2 * np.pi)] * 6
    rows = YAML(typ="safe").load(MEASURED)["kinematics"]
    for q in joint_values(50):
        np.testing.assert_allclose(forward(robot, q), of_origins(rows, q), rtol=0.0, atol=1e-12)


MILLIMETRES = """
name: thousand
units: {length: mm}
joints:
  - {theta: q, d: 400, alpha: -pi/2}
  - {theta: q, a: 560}
  - {theta: q, alpha: -pi/2}
  - {theta: q, d: 515, alpha: pi/2}
  - {theta: q, alpha: -pi/2}
  - {theta: q, d: 80}
"""


def test_what_axes_miss_is_told_in_the_file_s_unit(capsys: pytest.CaptureFixture[str]) -> None:
    Path("thousand.yaml").write_text(MILLIMETRES, encoding="utf-8")
    Path("measured.yaml").write_text("deltas: [{}, {}, {}, {a: 0.05}, {}, {}]", encoding="utf-8")
    assert main(["calibrate", "thousand.yaml", "--from", "measured.yaml"]) == 0
    told = capsys.readouterr()
    assert "the tool is up to 0.05 mm" in told.out
    assert "axes 4 and 5 miss each other by 0.05 mm" in told.err


def test_a_parallel_robot_is_not_calibrated(capsys: pytest.CaptureFixture[str]) -> None:
    assert calibrated("parallel_3rrr", "deltas: []") == 2
    told = "a robot with legs is a parallel one: only serial arms are calibrated so far"
    assert capsys.readouterr().err == f"{ROBOTS / 'parallel_3rrr.yaml'}: {told}\n"


def test_an_arm_without_errors_stays_a_table() -> None:
    """The description's default numbers, rounded to 2e-10 rad, are the table's own."""
    assert calibrated("ur5e", NOMINAL) == 0
    robot, nominal = load("ur5e_calibrated.yaml"), load(ROBOTS / "ur5e.yaml")
    assert isinstance(robot.geometry, DhTable)
    for q in joint_values(50):
        np.testing.assert_allclose(forward(robot, q), forward(nominal, q), rtol=0.0, atol=1e-9)


@pytest.mark.parametrize(("mark", "end"), [("\ufeff", "\n"), ("", "\r\n"), ("\ufeff", "\r\n")])
def test_files_as_editors_write_them(mark: str, end: str) -> None:
    """With the mark that some begin with, and other ends of lines."""
    assert calibrated("puma560", DELTAS, "--out", "arm.yaml") == 0
    plain = Path("arm.yaml").read_text("utf-8")
    Path("marked.yaml").write_bytes((mark + DELTAS.replace("\n", end)).encode())
    assert calibrated("puma560", Path("marked.yaml"), "--out", "arm.yaml") == 0
    assert Path("arm.yaml").read_text("utf-8") == plain.replace("measured.yaml", "marked.yaml")


def test_links_may_stand_in_any_order() -> None:
    """As programs write them: by the alphabet."""
    rows = YAML(typ="safe").load(NOMINAL)["kinematics"]
    text = "".join(f"  {name}: {rows[name]}\n" for name in sorted(rows))
    assert calibrated("ur5e", f"kinematics:\n{text}".replace("'", "")) == 0
    robot, nominal = load("ur5e_calibrated.yaml"), load(ROBOTS / "ur5e.yaml")
    for q in joint_values(5):
        np.testing.assert_allclose(forward(robot, q), forward(nominal, q), rtol=0.0, atol=1e-9)


@pytest.mark.parametrize("convention", ["standard", "modified"])
def test_deltas_of_a_table(convention: str) -> None:
    """Of a modified row beta stands before the joint's own motion."""
    text = (ROBOTS / "puma560.yaml").read_text("utf-8").replace("standard", convention)
    Path("kind.yaml").write_text(text, encoding="utf-8")
    Path("measured.yaml").write_text(DELTAS, encoding="utf-8")
    assert main(["calibrate", "kind.yaml", "--from", "measured.yaml"]) == 0
    nominal, robot = load("kind.yaml"), load("puma560_calibrated.yaml")
    rows = YAML(typ="safe").load(DELTAS)["deltas"]
    for q in joint_values(50):
        reached = of_deltas(nominal, rows, q)
        np.testing.assert_allclose(forward(robot, q), reached, rtol=0.0, atol=1e-12)


def test_the_file_names_the_arm(capsys: pytest.CaptureFixture[str]) -> None:
    """Arms of one kind have files of their own, wherever their robot files lie."""
    for name in ("ur5e_sn1", "ur5e_sn2"):
        assert calibrated("ur5e", MEASURED, "--out", f"{name}.yaml") == 0
        assert load(f"{name}.yaml").name == name
        assert f"{name}: the tool is up to " in capsys.readouterr().out


@pytest.mark.parametrize(
    ("out", "why"),
    [
        ("ur5e-sn1.yaml", "not ur5e-sn1: a name is made of a-z, A-Z, 0-9 and _"),
        ("ur5e.yaml", "not ur5e: that is the arm of the data sheet"),
        ("null.yaml", "not null: it is a word of YAML"),
    ],
)
def test_files_whose_name_no_arm_can_have(
    out: str, why: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert calibrated("ur5e", MEASURED, "--out", out) == 0
    assert load(out).name == "ur5e_calibrated"
    assert f"note: the arm is called ur5e_calibrated, {why}" in capsys.readouterr().err


def test_axes_where_common_normals_are_far_away(capsys: pytest.CaptureFixture[str]) -> None:
    """No table: the arm has the size of its data sheet's, not that of the detour."""
    assert calibrated("ur10e", FAR) == 0
    assert "the file holds axes, not a table" in capsys.readouterr().err
    robot, nominal = load("ur10e_calibrated.yaml"), load(ROBOTS / "ur10e.yaml")
    assert isinstance(robot.geometry, ReferenceAxes)
    lengths = (0.1807, 0.6127, 0.57155, 0.17415, 0.11985, 0.11655)
    assert 1.3 < build_chain(robot).size < 1.5 * sum(lengths)
    rows = YAML(typ="safe").load(FAR)["deltas"]
    for q in joint_values(50):
        reached = of_deltas(nominal, rows, q)
        np.testing.assert_allclose(forward(robot, q), reached, rtol=0.0, atol=1e-12)


@pytest.mark.breadth
def test_joint_velocities_where_common_normals_are_far_away(tmp_path: Path) -> None:
    """Those with which the tool moves by the twist, where the arm is not nearly singular."""
    assert calibrated("ur10e", FAR) == 0
    solver = library(written(tmp_path / "ur10e_calibrated.yaml", tmp_path).module, tmp_path)
    twist = np.array([0.1, -0.2, 0.05, 0.3, 0.1, -0.2])
    values = np.array([[0.3, -1.2, 1.5, -0.6, 1.1, 0.2], [-2.0, -0.8, -1.3, 0.4, -1.4, 2.5]])
    for q in values:
        velocities = solver.joint_velocities(q, twist)
        np.testing.assert_allclose(solver.jacobian(q) @ velocities, twist, rtol=0.0, atol=1e-12)


def test_axes_where_they_are_asked_for() -> None:
    assert calibrated("ur5e", NOMINAL, "--axes", "--out", "axes.yaml") == 0
    assert isinstance(load("axes.yaml").geometry, ReferenceAxes)


def test_cells_are_those_of_robot_files() -> None:
    """Numbers, angles with their unit or in rad, arithmetic."""
    words = DELTAS.replace("theta: 1e-4, d: 1e-4", "theta: 0.01 deg - pi/3600, d: 2e-4/2")
    numbers = DELTAS.replace("theta: 1e-4", f"theta: {float(np.radians(0.01) - np.pi / 3600)!r}")
    for text, out in ((words, "words.yaml"), (numbers, "numbers.yaml")):
        assert calibrated("puma560", text, "--out", out) == 0
    q = joint_values(20)
    np.testing.assert_allclose(
        forward(load("words.yaml"), q), forward(load("numbers.yaml"), q), atol=1e-12
    )


@pytest.mark.parametrize("options", [(), ("--axes",)])
@pytest.mark.parametrize("robot", ["puma560", "ur5e"])
def test_nothing_advises_to_undo_it(robot: str, options: tuple[str, ...]) -> None:
    """Deltas of few digits, too: these are what was measured."""
    rows = "".join(f"  - {{theta: {0.0003 * k}, alpha: -0.0004}}\n" for k in (1, -1, 2, -2, 3, 1))
    assert calibrated(robot, f"deltas:\n{rows}", *options, "--out", "arm.yaml") == 0
    assert load("arm.yaml").notices == ()


def test_what_is_written_over_is_told_and_what_is_read_stays(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """As `dhgen import` does."""
    kind = Path("kind.yaml")
    kind.write_text((ROBOTS / "ur5e.yaml").read_text("utf-8"), encoding="utf-8")
    Path("measured.yaml").write_text(NOMINAL, encoding="utf-8")
    command = ["calibrate", "kind.yaml", "--from", "measured.yaml", "--out"]
    for read in ("kind.yaml", "measured.yaml"):
        before = Path(read).read_bytes()
        assert main([*command, read]) == 2
        assert f"dhgen: {read} is what was read: write to another file" in capsys.readouterr().err
        assert Path(read).read_bytes() == before
    Path("other.yaml").write_text("mine\n", encoding="utf-8")
    assert main([*command, "other.yaml"]) == 0
    assert "note: other.yaml was there and is written over" in capsys.readouterr().err
    assert main([*command, "other.yaml"]) == 0
    assert "written over" not in capsys.readouterr().err
    assert main([*command, "some/where/arm.yaml"]) == 0
    assert load("some/where/arm.yaml").name == "arm"


@pytest.mark.parametrize(
    ("robot", "text", "message"),
    [
        ("ur10e", MEASURED, "this is the calibration of another arm: by it the tool of ur10e is "),
        (
            "puma560",
            DELTAS.replace("theta: 2e-4", "theta: -26.6"),
            "; an angle of 26.6 looks like degrees: they are in rad, or written with deg",
        ),
        (
            "ur5e",
            NOMINAL.replace("0.425", "425"),
            "; a length of 425 on an arm of 1.3 m looks like another unit: they are in m",
        ),
        ("scara", DELTAS, "6 rows for an arm of 4 joints"),
        (
            "welding_5r",
            "deltas: [{}, {}, {}, {}, {}]",
            "welding_5r is asked for pointing: calibrations are for ",
        ),
        ("abb_irb2400", DELTAS, "drives of abb_irb2400 are coupled, or sums limited: "),
        ("puma", DELTAS, "deltas are for arms with a table; this one has axes"),
        ("puma560", "deltas: [{tehta: 1}]", "measured.yaml:1:11: no key is called 'tehta'"),
        (
            "puma560",
            f"units: {{angle: deg}}\n{DELTAS}",
            "measured.yaml:1:1: no key of a calibration is called 'units': convention and units ",
        ),
        (
            "ur5e",
            f"{NOMINAL}convention: modified\n",
            "no key of a calibration is called 'convention'",
        ),
        ("puma560", "deltas: 3", "measured.yaml:1:9: deltas is a list with a row for each joint"),
        ("puma560", "deltas: [3]", "measured.yaml:1:10: expected {theta: 0, d: 0, a: 0, "),
        ("puma560", "deltas: [{theta: nan}]", "measured.yaml:1:18: expected a number"),
        ("puma560", "deltas: [{theta: 1 dgr}]", "expected a number: 'dgr' is no unit: degrees are"),
        ("puma560", "deltas: [{d: 1 deg}]", "is an angle, but a length belongs here"),
        ("ur5e", "kinematics: {shoulder: {x: 0}}", "y, z, roll, pitch, yaw missing"),
        ("ur5e", "name: ur5e", "measured.yaml:1:1: a calibration holds kinematics: "),
        (
            "ur5e",
            NOMINAL.replace("wrist_1", "wrist1"),
            "no link is called 'wrist1'; did you mean 'wrist_1'",
        ),
        ("ur5e", NOMINAL.replace("wrist_2", "hash"), "wrist_2 missing"),
        ("ur5e", f"{NOMINAL}{DELTAS}", "a calibration holds kinematics or deltas, not both"),
        ("ur5e", "", "measured.yaml: the file is empty"),
        ("ur5e", f"{NOMINAL}#{' ' * 131072}", "at most 128 KiB"),
        ("ur5e", Path(), "this is a folder; name the files in it"),
        ("ur5e", Path("none.yaml"), "none.yaml: the file can't be read: No such file"),
    ],
)
def test_mistakes_are_told_at_their_place(
    robot: str, text: str | Path, message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    code = calibrated(robot, text)
    assert (code, message) == (2, message)
    assert message in capsys.readouterr().err
    assert not list(Path().glob("*_calibrated.yaml"))


@pytest.mark.breadth
def test_all_calibrated_arms_are_solved(tmp_path: Path) -> None:
    """By the general algorithm: no two axes are parallel any more."""
    assert calibrated("ur5e", MEASURED) == 0
    compilation = written(tmp_path / "ur5e_calibrated.yaml", tmp_path)
    assert compilation.module.method == "general 6R"
    solver = library(compilation.module, tmp_path)
    for q in joint_values(200):
        rows, _ = solver.ik(np.array(forward(compilation.robot, q)), np.zeros(6))
        gap = np.abs(np.remainder(rows - q + np.pi, 2 * np.pi) - np.pi).max(axis=1)
        assert np.nanmin(gap) < 1e-6
