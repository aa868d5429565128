"""What the section on velocities prints is true, read from the Markdown as it is committed."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from functools import cache, partial
from itertools import pairwise
from types import CodeType, MappingProxyType
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.derivation.notation.names import symbols
from dhgen.derivation.velocity.determinant import determinant_of
from dhgen.kinematics.algebra import build_algebra
from dhgen.kinematics.build import build_chain
from dhgen.oracle.arm_angle import given_values
from dhgen.oracle.forward import forward, jacobian
from dhgen.robot.load import load
from dhgen.robot.task import Directions
from tests.derivation.made import made_for
from tests.derivation.stories import ROBOTS, WITH_STEPS, document, story, story_of
from tests.generated.solvers import module
from tests.serial import SERIAL
from tests.structures import first_of

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from dhgen.arrays import FloatArray
    from dhgen.derivation.text.formula import Symbol
    from dhgen.kinematics.algebra import Algebra
    from dhgen.robot.robot import Robot

PRINTED = re.compile(r"^\\det J = (.*)$", re.MULTILINE)
ROW = re.compile(r"^\| \$(.*)\$ \| (?:\d+|—|\$\\psi\$) \| (.*) \|$", re.MULTILINE)
MADE_UP = ROBOTS.parent / "tests/targets/robots"
NEVER = "never zero with the numbers of this arm"
TOKEN = re.compile(
    r"(?P<root>\\sqrt\{\d+\})|\\frac\{(?P<above>\d+)\}\{(?P<below>\d+)\}|(?P<number>\d+)"
    r"|(?P<name>(?:\\(?:sin|cos) )?(?:\\hat)?\\?[A-Za-z]+(?:_(?:\{[^}]*\}|\w))?)|(?P<sign>[-+()^])"
)
OF_ROOTS = re.compile(r"\\frac\{((?:\d+ )?\\sqrt\{\d+\})\}\{(\d+)\}")
NAMES = [name for name in SERIAL if PRINTED.search(document(name))]
ELSEWHERE = re.compile(r"With the velocity of (.*) and the angular .* seen from frame (\d),")
FRAME = re.compile(r"(?<!line to )the origin of frame (\d+)")
# A letter of the section, or an entry of J_v, and what it is.
DEFINED = re.compile(r"^(?P<name>[FGHK]|j_\{[xyz]\d\}) (?:& )?= (?P<value>.*)")
ALONE = re.compile(r"^\$(.*?)\$ is, but for factors that do not move, no product", re.MULTILINE)
BLOCK = re.compile(r"^J_v = \\begin\{bmatrix\} (.*) \\end\{bmatrix\}$", re.MULTILINE)


@cache
def _code(latex: str) -> CodeType:
    """A printed product of sums as an expression in the letters `at`."""
    words: list[str] = []
    plain = OF_ROOTS.sub(r"(\1 \\frac{1}{\2})", re.sub(r"\\(?:left|right)", "", latex))
    for found in TOKEN.finditer(plain):
        word = found[0]
        if found["root"]:
            word = f"{float(word[6:-1]) ** 0.5!r}"
        elif found["above"]:
            word = repr(int(found["above"]) / int(found["below"]))
        starts = word == "(" or word[0] not in "+-)^"
        if starts and words and words[-1] not in "+-(^":
            words.append("*")
        words.append(f"at[{word!r}]" if found["name"] else word)
    return compile("".join(words).replace("^", "**"), latex, "eval")


@dataclass(frozen=True, slots=True)
class Arm:
    """A robot, and the letters of its document.

    Attributes:
        robot: As its file says.
        algebra: Its ring.
        spelled: The letter of every generator.
    """

    robot: Robot
    algebra: Algebra
    spelled: Mapping[str, Symbol]

    @property
    def document(self) -> str:
        return document(self.robot.name)

    def worth(
        self, latex: str, q: FloatArray, others: Mapping[str, float] = MappingProxyType({})
    ) -> float:
        """A printed product of sums at joint values; `others` are further letters."""
        return float(eval(_code(latex), {"at": {**self.letters(q), **others}}))  # noqa: S307

    def letters(self, q: FloatArray) -> dict[str, float]:
        chain, letters = self.algebra.chain, self.spelled
        inner = dict(enumerate(chain.drives.values(q), start=1))
        found = {letters[c.name].latex: c.value for c in chain.constants}
        for angle in self.algebra.angles:
            total = sum(sign * inner[joint] for joint, sign in angle.terms)
            found[letters[angle.cosine].latex] = math.cos(total)
            found[letters[angle.sine].latex] = math.sin(total)
        return found | {letters[n].latex: inner[j] for j, n in self.algebra.slides.items()}

    def rates(self, q: FloatArray, text: str = "") -> FloatArray:
        """The rows that the task names, without those of zeros, of the joints solved for.

        Args:
            q: Joint values.
            text: What may name another point than the tool's origin, or the arm angle.
        """
        J, task = jacobian(self.robot, q), self.robot.task
        if found := ELSEWHERE.search(text):
            frames = module(self.robot.name).frames(q)
            point = named_point(found[1], frames, J)
            J[:3] += np.cross(J[3:].T, point - frames[-1][:3, 3]).T
            R = frames[int(found[2])][:3, :3]
            J = np.vstack([R.T @ J[:3], R.T @ J[3:]])
        J = np.delete(J, [joint - 1 for joint in self.robot.free], axis=1)
        spins = J[3:] if task.directions is Directions.ROTATION else J[:0]
        if task.directions is Directions.POINTING:
            spins = forward(self.robot, q)[:3, :2].T @ J[3:]
        elif task.directions is Directions.TILT:
            spins = J[3:5]
        elif task.directions is Directions.YAW:
            assert abs(forward(self.robot, q)[2, 0]) < 1e-12, "the tool's x axis stays level"
            spins = J[5:]
        rows = np.vstack([J[list(task.position_rows)], spins])
        rows = rows[np.abs(rows).max(axis=1) > 1e-12]
        return np.vstack([rows, self.elbow_rate(q)]) if self.robot.arm_angle else rows

    def elbow_rate(self, q: FloatArray) -> FloatArray:
        """How the arm angle changes with the joints, by differences."""
        steps = 1e-6 * np.eye(len(q))
        ahead, behind = (given_values(self.robot, q + sign * steps) for sign in (1.0, -1.0))
        return np.asarray(np.remainder(ahead - behind + np.pi, 2.0 * np.pi) - np.pi).T / 2e-6


def named_point(text: str, frames: FloatArray, J: FloatArray) -> FloatArray:
    """The point that a text names, else the tool's origin."""
    tip = frames[-1][:3, 3]
    if found := FRAME.search(text):
        return np.asarray(frames[int(found[1])][:3, 3])
    return meeting(J[:, -3:], tip) if "the wrist centre" in text else np.asarray(tip)


def meeting(J: FloatArray, tip: FloatArray) -> FloatArray:
    """Where the axes of some columns of the Jacobian meet."""
    axes = J[3:].T
    # of every axis the point next to the tool's origin
    points = np.cross(axes, J[:3].T) + tip
    across = [np.eye(3) - np.outer(a, a) for a in axes]
    return np.linalg.solve(sum(across), sum(P @ o for P, o in zip(across, points, strict=True)))


@cache
def arm(name: str) -> Arm:
    return arm_of(load(ROBOTS / f"{name}.yaml"))


def arm_of(robot: Robot) -> Arm:
    algebra = build_algebra(build_chain(robot))
    return Arm(robot, algebra, symbols(algebra))


def postures(of: Arm, count: int, seed: int) -> FloatArray:
    """Joint values (count, n)."""
    chain = of.algebra.chain
    reach = np.where(chain.turning, np.pi, chain.size)
    return np.random.default_rng(seed).uniform(-reach, reach, (count, chain.dof))


def test_every_square_task_has_it_or_says_why_not() -> None:
    for name in SERIAL:
        of, text = arm(name), section(name)
        rows, columns = of.rates(postures(of, 1, seed=0)[0], text).shape
        if rows == columns:
            assert (name in NAMES) != ("it is an irreducible polynomial. It is too long" in text)
        else:
            assert name not in NAMES
            assert "irreducible" not in text


@pytest.mark.parametrize("name", NAMES)
def test_the_determinant_is_the_product(name: str) -> None:
    check_product(arm(name), section(name))


@pytest.mark.parametrize("name", ["yaw_scara", "yaw_planar", "tilting_gantry"])
def test_it_is_that_of_a_task_with_a_part_of_the_rotation(name: str) -> None:
    robot = load(MADE_UP / f"{name}.yaml")
    check_product(arm_of(robot), section_of(made_for(robot)))


def test_it_is_that_of_a_task_with_a_pitch() -> None:
    """Up to the sign: a pitch falls where the tool is turned over."""
    robot = load(MADE_UP / "pitch_arm.yaml")
    of, printed = arm_of(robot), PRINTED.search(made_for(robot))
    assert printed is not None

    def asked(q: FloatArray) -> FloatArray:
        pose = forward(robot, q)
        return np.array([*pose[:3, 3], math.asin(-pose[2, 0])])

    for q in postures(of, 8, seed=1):
        steps = 1e-6 * np.eye(4)
        J = np.transpose([(asked(q + step) - asked(q - step)) / 2e-6 for step in steps])
        assert abs(of.worth(printed[1], q)) == pytest.approx(abs(np.linalg.det(J)), abs=1e-9)


def test_of_more_rows_than_joints_nothing_is_worked_out() -> None:
    """Of no rows the determinant would be 1."""
    robot = load(MADE_UP / "yaw_checked.yaml")
    assert determinant_of(story_of(robot)) is None
    text = made_for(robot)
    assert "det J" not in text
    assert "It is never zero" not in text


def test_of_a_wrist_nothing_is_worked_out_by_its_position() -> None:
    assert determinant_of(story("wrist_zyz"), by_position=True) is None


@pytest.mark.parametrize("name", ["planar_4r", "given_short", "trolley"])
def test_it_is_that_of_the_joints_solved_for_where_others_are_given(name: str) -> None:
    """Of a plane's arm, too, which has three rows that are not zero."""
    robot = load(MADE_UP / f"{name}.yaml")
    check_product(arm_of(robot), section_of(made_for(robot)))


def check_product(of: Arm, text: str) -> None:
    """The determinant at postures is what the printed product is worth there."""
    printed = PRINTED.search(text)
    assert printed is not None
    size = of.algebra.chain.size
    # the rate of the arm angle is known by differences
    exact = 1e-6 if of.robot.arm_angle else 1e-9
    for q in postures(of, 8, seed=1):
        J = of.rates(q, text)
        found = worth_there(of, text, printed[1], q)
        scale = max(1.0, size) ** len(J)
        assert found == pytest.approx(np.linalg.det(J), rel=exact, abs=1e-12 * scale)
        assert found != 0.0


def worth_there(of: Arm, text: str, latex: str, q: FloatArray) -> float:
    """A product of a text at joint values, with the letters that the text brings for it."""
    known: dict[str, float] = {}
    lines = re.sub(r" *\\\\\n& \\quad", "", text).split("\n")
    for found in filter(None, map(DEFINED.match, lines)):
        known[found["name"]] = of.worth(found["value"].removesuffix(r" \\"), q)
    if block := BLOCK.search(text):
        rows = [row.split(" & ") for row in block[1].split(r" \\ ")]
        known["J_v"] = float(np.linalg.det([[of.worth(e, q, known) for e in r] for r in rows]))
    if r"\lVert" in latex:
        known["v"] = shoulder_to_wrist(of, q)
    plain = latex.replace(r"\det J_v", "J_v").replace(r"\lVert \mathbf{v} \rVert", "v")
    return of.worth(plain, q, known)


def shoulder_to_wrist(of: Arm, q: FloatArray) -> float:
    """Between the points that the document calls so."""
    ends = re.findall(r"in the (?:shoulder|wrist) \$[SW]\$, the origin of frame (\d)", of.document)
    shoulder, wrist = (module(of.robot.name).frames(q)[int(end)][:3, 3] for end in ends)
    return float(np.linalg.norm(wrist - shoulder))


def section(name: str) -> str:
    return section_of(document(name))


def section_of(text: str) -> str:
    return text.partition("## Velocity\n")[2].partition("\n## ")[0]


@pytest.mark.parametrize("name", NAMES)
def test_its_factors_are_listed(name: str) -> None:
    """All that moves is in the table."""
    of, printed = arm(name), PRINTED.search(section(name))
    assert printed is not None
    q, other = postures(of, 2, seed=2)
    text, length = section(name), r"\lVert \mathbf{v} \rVert"
    rows = [latex for latex, _ in ROW.findall(text)]
    listed = list(dict.fromkeys([*rows, *ALONE.findall(text)]))
    assert all(each in printed[1] for each in listed)
    powers = [
        2 if f"{each}^2" in printed[1] or f"({each})^2" in printed[1] else 1 for each in listed
    ]
    moving = [*listed, *([length] if length in printed[1] else [])]
    powers += [1] * (len(moving) - len(listed))
    there = partial(worth_there, of, text)
    ratio = there(printed[1], q) / there(printed[1], other)
    product = [
        math.prod(there(e, x) ** p for e, p in zip(moving, powers, strict=True)) for x in (q, other)
    ]
    assert ratio == pytest.approx(product[0] / product[1], rel=1e-9)


WITH_BLOCKS = [name for name in WITH_STEPS if "J_{11} =" in document(name)]
MATRIX = r"%s (?:& )?= \\begin\{bmatrix\} (.*?) \\end\{bmatrix\}"
RATE = re.compile(
    r"^(?:\\dot\{q\}_(?P<joint>\d)|u_(?P<along>[xyz])) & = (?P<value>.*?)(?: \\\\)?$", re.MULTILINE
)
FRACTION = re.compile(r"(-?)\\frac\{(.*)\}\{(.*)\}")


def matrix(of: Arm, text: str, name: str, q: FloatArray) -> FloatArray:
    """A printed matrix in numbers."""
    found = re.search(MATRIX % re.escape(name), text)
    assert found is not None, name
    rows = found[1].split(r" \\ ")
    return np.array([[of.worth(entry, q) for entry in row.split(" & ")] for row in rows])


def wrist_jacobian(name: str, q: FloatArray) -> FloatArray:
    """At the point where the last three axes meet, in the frame behind joint 3."""
    of = arm(name)
    J, tip = jacobian(of.robot, q), forward(of.robot, q)[:3, 3]
    J[:3] += np.cross(J[3:].T, meeting(J[:, 3:], tip) - tip).T
    R = forward(of.robot, q)
    return np.asarray(np.vstack([R[:3, :3].T @ J[:3], R[:3, :3].T @ J[3:]]))


def test_spherical_wrists_have_blocks() -> None:
    assert len(WITH_BLOCKS) > 20


@pytest.mark.parametrize("name", WITH_BLOCKS)
def test_the_blocks_are_those_of_the_jacobian_up_to_the_frame(name: str) -> None:
    """Turned by one rotation into the tool's frame; the steps that are printed invert them."""
    of, text = arm(name), section(name)
    for q in postures(of, 4, seed=3):
        J11, J21, J22 = (matrix(of, text, f"J_{{{k}}}", q) for k in (11, 21, 22))
        printed, wanted = np.block([[J11, np.zeros((3, 3))], [J21, J22]]), wrist_jacobian(name, q)
        # the rotation that takes the printed columns to those that are wanted
        pairs = np.hstack([printed[:3], printed[3:]]), np.hstack([wanted[:3], wanted[3:]])
        U, _, V = np.linalg.svd(pairs[1] @ pairs[0].T)
        R = U @ np.diag([1.0, 1.0, np.linalg.det(U @ V)]) @ V
        np.testing.assert_allclose(R @ pairs[0], pairs[1], atol=1e-9 * of.algebra.chain.size)
        det = re.search(r"\\det J_\{22\} & = (.*?) \\\\$", text, re.MULTILINE)
        assert det is not None
        adjugate = matrix(of, text, r"(\det J_{22}) J_{22}^{-1}", q)
        np.testing.assert_allclose(adjugate / of.worth(det[1], q) @ J22, np.eye(3), atol=1e-9)
        if "follow from $v$ alone" in text:
            rates = np.array([0.3, -0.7, 0.4])
            np.testing.assert_allclose(rates_by_steps(of, text, q, J11 @ rates), rates, atol=1e-9)


def rates_by_steps(of: Arm, text: str, q: FloatArray, v: FloatArray) -> list[float]:
    """Velocities of joints 1 to 3 by the printed lines, from the wrist centre's."""
    known = {f"v_{axis}": float(value) for axis, value in zip("xyz", v, strict=True)}
    for line in RATE.finditer(text):
        value = line["value"].replace(r"\dot{q}_1", "w_1")
        fraction = FRACTION.fullmatch(value)
        found = of.worth(fraction[2] if fraction else value, q, known)
        if fraction:
            found /= of.worth(fraction[3], q, known) * (-1.0 if fraction[1] else 1.0)
        known[f"u_{line['along']}" if line["along"] else f"w_{line['joint']}"] = found
    return [known[f"w_{joint}"] for joint in (1, 2, 3)]


def singular(of: Arm, text: str, latex: str, seed: int) -> FloatArray | None:
    """Joint values at which a factor is zero, between two of one joint that differ in its sign."""
    q, worth = postures(of, 1, seed)[0], partial(worth_there, of, text, latex)
    for joint in np.random.default_rng(seed).permutation(len(q)):
        ends = [
            np.where(np.arange(len(q)) == joint, value, q) for value in np.linspace(-2.9, 3, 20)
        ]
        for one, two in pairwise(ends):
            if worth(one) * worth(two) < 0.0:
                return _bisected(worth, one, two)
    return None


def _bisected(value: Callable[[FloatArray], float], one: FloatArray, two: FloatArray) -> FloatArray:
    rises = value(one) < 0.0
    for _ in range(55):
        middle = (one + two) / 2.0
        one, two = (middle, two) if (value(middle) < 0.0) == rises else (one, middle)
    return (one + two) / 2.0


def _null(A: FloatArray) -> FloatArray:
    """A basis of what a matrix makes zero, in columns."""
    _, s, V = np.linalg.svd(A)
    return np.asarray(V[int((s > 1e-6 * s[0]).sum()) :].T)


AXIS = re.compile(r"\$([xyz])_(?:\{(\d+)\}|(\d))\$(?=$| that)")
LINE = re.compile(r"along the line to the origin of frame (\d+)$")


def lost_part(name: str, lost: str, q: FloatArray) -> float:
    """The most of a motion that is named as lost, of unit joint velocities."""
    of = arm(name)
    J = np.delete(jacobian(of.robot, q), [joint - 1 for joint in of.robot.free], axis=1)
    scale = np.where(of.algebra.chain.turning, 1.0, of.algebra.chain.size)
    J *= np.delete(scale, [joint - 1 for joint in of.robot.free])
    frames, z = module(name).frames(q), J[3:]
    point = named_point(lost, frames, J)
    moved = J[:3] + np.cross(z.T, point - frames[-1][:3, 3]).T
    if lost.startswith("with the tool at rest"):
        return float(np.abs(of.elbow_rate(q) @ _null(J)).max())
    if lost.startswith("one velocity"):
        return float(np.linalg.svd(moved, compute_uv=False)[-1])
    if line := LINE.search(lost):
        direction = frames[int(line[1])][:3, 3] - point
    else:
        axis = AXIS.search(lost)
        assert axis is not None, lost
        direction = frames[int(axis[2] or axis[3])][:3, "xyz".index(axis[1])]
    direction = direction / np.linalg.norm(direction)
    if lost.startswith("every velocity"):
        return float(np.abs(moved - np.outer(direction, direction @ moved)).max())
    if lost.startswith("the velocity"):
        return float(np.abs(direction @ moved).max())
    if lost.startswith("turning"):
        return float(np.abs(direction @ z).max())
    if joints := re.match("without turning, .* that joints (.*) give", lost):
        own = [int(joint) - 1 for joint in re.findall(r"\d", joints[1])]
        return float(np.abs(direction @ J[:3, own] @ _null(z[:, own])).max())
    if lost.startswith("with the orientation kept"):
        return float(np.abs(direction @ J[:3] @ _null(z)).max())
    assert lost.startswith("with ")
    return float(np.abs(direction @ z @ _null(moved)).max())


# In the first ones more than one motion is lost, one that is along no axis, those of an arm with a
# joint that is given, one in a direction of the base, whose row of the Jacobian is zero then, and
# those whose axes are parallel, or meet, before or in the middle of others.
FIRST = {"spherical", "staubli_tx2_90", "franka_panda", "rpr", "parallel_123", "concurrent_345"}
LOST = sorted(NAMES, key=lambda name: name not in FIRST)


@pytest.mark.parametrize("name", first_of(LOST, count=12))
def test_what_is_lost_is_lost(name: str) -> None:
    of, text = arm(name), section(name)
    listed = ROW.findall(text)
    for latex, lost in listed:
        assert lost != "no short name"
        if lost == NEVER:
            assert all(singular(of, text, latex, seed) is None for seed in range(5))
            continue
        others, seen = [each for each, _ in listed if each != latex], 0
        for seed in range(5):
            q = singular(of, text, latex, seed)
            if q is None:
                continue
            J = of.rates(q, text)
            if of.robot.arm_angle and "tool at rest" not in lost:
                J = J[:-1]  # a stretched arm has its elbow on no side
            # rows of zeros are not among its rows
            s = np.zeros(len(J) if of.robot.arm_angle else J.shape[1])
            s[: len(J)] = np.linalg.svd(J, compute_uv=False)
            assert s[-1] < 1e-9 * s[0]
            # where two factors vanish at once (links of one length, folded), others are lost
            of_one = lost.startswith("every velocity") or s[-2] > 1e-4 * s[0]
            alone = of_one and all(abs(worth_there(of, text, each, q)) > 1e-6 for each in others)
            if not alone or hasattr(module(name), "AXES"):
                continue
            assert lost_part(name, lost, q) < 1e-6 * max(1.0, of.algebra.chain.size), (lost, q)
            seen += 1
        assert seen or hasattr(module(name), "AXES")
