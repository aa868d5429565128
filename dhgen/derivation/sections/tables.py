"""The robot's table or axes as the user wrote them, and what the letters of the formulas are."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.expressions import (
    expression_symbol,
    is_rounded_limit,
    limit_symbol,
    variable_symbol,
)
from dhgen.derivation.notation.names import (
    BASE,
    TOOL,
    inverse,
    joint_symbol,
    letter,
    single,
    theta,
)
from dhgen.derivation.sections.transforms import matrix_of, side_by_side
from dhgen.derivation.text.blocks import Given, Table, joined, paragraph, say
from dhgen.derivation.text.formula import Symbol, equal, times
from dhgen.kinematics.chain import Fixed
from dhgen.kinematics.product import product, reversed_elements
from dhgen.kinematics.transform import compose, identity
from dhgen.robot.expression import ZERO
from dhgen.robot.robot import AxisJoint, Convention, DhRow, DhTable, JointKind

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.chain import Element
    from dhgen.robot.expression import Expression
    from dhgen.robot.robot import Coupling


_CONVENTIONS = {
    Convention.STANDARD: Symbol(
        r"A_i = R_z(\theta_i) T_z(d_i) T_x(a_i) R_x(\alpha_i)", "Aᵢ = Rz(θᵢ) Tz(dᵢ) Tx(aᵢ) Rx(αᵢ)"
    ),
    Convention.MODIFIED: Symbol(
        r"A_i = R_x(\alpha_i) T_x(a_i) R_z(\theta_i) T_z(d_i)", "Aᵢ = Rx(αᵢ) Tx(aᵢ) Rz(θᵢ) Tz(dᵢ)"
    ),
}
_BEFORE, _OWN, _AFTER = (
    Symbol("z_{i-1}", "zᵢ₋₁"),
    Symbol("z_i", "zᵢ"),
    Symbol("z_{i+1}", "zᵢ₊₁"),
)
_I = Symbol("i", "i")
_TEXT = "{} convention: {}. Joint {} {} {}; {} points along the common normal of {} and {}."
_AXES = "The axes are given in the reference position, where every {} is zero, in the base frame"
_AXES_TEXT = (
    ". Frame {} moves with joint {} and has its {} axis along the joint's axis; {} takes frame {} "
    "to frame {}."
)

MOTION_ABOUT_AXIS = Symbol(
    r"K_i = \begin{bmatrix} R_i & p_i - R_i p_i \\ 0 & 1 \end{bmatrix}",
    "Kᵢ = [Rᵢ, pᵢ − Rᵢ pᵢ; 0, 1]",
)


def table_blocks(story: Story) -> list[Block]:
    """The Denavit-Hartenberg table and its convention."""
    geometry = story.robot.geometry
    assert isinstance(geometry, DhTable)
    limited = any(row.limits for row in geometry.rows)
    header = [say("joint"), *(say("{}", s) for s in _columns()), *([say("limits")] * limited)]
    rows = [
        (*_cells(label, row), *([_limits(row, story)] * limited))
        for label, row in zip(geometry.labels, geometry.rows, strict=True)
    ]
    standard = geometry.convention is Convention.STANDARD
    axes = (_BEFORE, _OWN) if standard else (_OWN, _AFTER)
    return [
        Table(tuple(header), tuple(rows)),
        paragraph(
            _TEXT,
            say("Standard" if standard else "Modified"),
            _CONVENTIONS[geometry.convention],
            _I,
            say(_motion(geometry)),
            axes[0],
            Symbol("x_i", "xᵢ"),
            *axes,
        ),
        *_sums(story),
        *_rounded(story),
        variables(story),
    ]


def _motion(geometry: DhTable) -> str:
    """What joints do with their axes."""
    kinds = {row.kind for row in geometry.rows}
    if len(kinds) > 1:
        return "turns about or slides along"
    return "turns about" if JointKind.REVOLUTE in kinds else "slides along"


def axes_blocks(story: Story) -> list[Block]:
    """The axes in the reference position."""
    header = [say(word) for word in ("joint", "type", "direction", "point")]
    joints = [joint for joint in story.robot.joints if isinstance(joint, AxisJoint)]
    limited = any(joint.limits for joint in joints)
    rows = []
    for place, joint in enumerate(joints, start=1):
        point = say("—") if joint.kind is JointKind.PRISMATIC else _triple(joint.point)
        cells = [_joint(str(place), joint), say(joint.kind.value), _triple(joint.direction), point]
        rows.append((*cells, *([_limits(joint, story)] * limited)))
    q, z, a = Symbol("q_i", "qᵢ"), Symbol("z", "z"), Symbol("A_i", "Aᵢ")
    return [
        Table((*header, *([say("limits")] * limited)), tuple(rows)),
        paragraph(_AXES + _cited(story) + _AXES_TEXT, q, _I, _I, z, a, Symbol("i-1", "i−1"), _I),
        *_of_document_001(story),
        *_sums(story),
        *_rounded(story),
        variables(story),
    ]


def _cited(story: Story) -> str:
    return " (document 001)" if story.cites_courses else ""


def _of_document_001(story: Story) -> list[Block]:
    """The motions K_i about the axes where they are, and how the frames come out of them."""
    if not story.steps:
        return []
    n = str(story.dof)
    moved = Symbol(rf"K_1 \cdots K_{n}", f"K₁⋯{letter('K', 'K', n).text}")
    frames = Symbol(rf"A_1 \cdots A_{n}", f"A₁⋯{letter('A', 'A', n).text}")
    last = letter("F", "F", n)
    return [
        paragraph(
            "Let {} be the motion of joint {} about, or along, its axis where it is in the "
            "reference position; of a joint that turns, {} with a point {} of the axis and the "
            "rotation {} about it. "
            f"Together the joints move the hand by {{}}{_cited(story)}:",
            Symbol("K_i", "Kᵢ"),
            _I,
            MOTION_ABOUT_AXIS,
            Symbol("p_i", "pᵢ"),
            Symbol("R_i", "Rᵢ"),
            moved,
        ),
        *side_by_side(_motions_about_axes(story)),
        paragraph(
            "If {} is frame {} in that position, {} and {}. {}",
            Symbol("F_i", "Fᵢ"),
            _I,
            Symbol(r"A_i = F_{i-1}^{-1} K_i F_i", "Aᵢ = Fᵢ₋₁⁻¹ Kᵢ Fᵢ"),
            equal(frames, Symbol(f"{moved.latex} {last.latex}", f"{moved.text} {last.text}")),
            _tool_behind(story, moved, last),
        ),
    ]


def _motions_about_axes(story: Story) -> list[Formula]:
    """K_i = F_i R_z(theta_i) F_i^-1 of every joint."""
    algebra = story.algebra
    before: list[Element] = []
    found: list[Formula] = []
    for element in (e for link in algebra.chain.links for e in algebra.lifted(link)):
        if isinstance(element, Fixed):
            before.append(element)
            continue
        motion = product([*before, element, *reversed_elements(before, algebra)], algebra)
        name = letter("K", "K", str(len(found) + 1))
        found.append(equal(name, matrix_of(motion, story.write_forward)))
    return found


def _tool_behind(story: Story, moved: Symbol, last: Symbol) -> Prose:
    """The transform behind the last frame, and why: the tool's pose where all joints are zero."""
    algebra, chain = story.algebra, story.algebra.chain
    fixed = [e for link in chain.links for e in algebra.lifted(link) if isinstance(e, Fixed)]
    tool, still = algebra.lift(chain.tool), identity(algebra.ring)
    base = [] if algebra.lift(chain.base) == still else [BASE]
    n = Given(str(story.dof))
    if tool == still:
        return say("The tool is frame {}.", n)
    pose, back = Symbol("H", "H"), inverse(last)
    if compose(product(fixed, algebra), tool, algebra.normal) == still:
        text = (
            "In the reference position the tool frame is to be on the base frame, so that its pose "
            "is {}; {} behind frame {} does that."
        )
        return say(text, times(*base, moved), equal(TOOL, back), n)
    text = (
        "With {} for the tool where the reference position has it, its pose is {}; {} stands "
        "behind frame {}."
    )
    return say(text, pose, times(*base, moved, pose), equal(TOOL, times(back, pose)), n)


def _columns() -> list[Symbol]:
    return [letter(r"\theta", "θ"), letter("d", "d"), letter("a", "a"), letter(r"\alpha", "α")]


def _cells(label: str, row: DhRow) -> tuple[Prose, ...]:
    number = int(label.rstrip("p"))
    theta_cell, d_cell = expression_symbol(row.theta), expression_symbol(row.d)
    if row.kind is JointKind.REVOLUTE:
        theta_cell = variable_symbol(number, row.sign, row.theta, row.couplings)
    else:
        d_cell = variable_symbol(number, row.sign, row.d, row.couplings)
    cells = (theta_cell, d_cell, expression_symbol(row.a), expression_symbol(row.alpha))
    return (_joint(label, row), *(say("{}", cell) for cell in cells))


def _joint(label: str, joint: DhRow | AxisJoint) -> Prose:
    """A joint's number, or the label of a passive row, and what the file calls it."""
    return say(f"{label}: {{}}", Given(joint.name)) if joint.name else say(label)


def _limits(joint: DhRow | AxisJoint, story: Story) -> Prose:
    if joint.limits is None:
        return say("—")
    low, high = (limit_symbol(value, joint.kind) for value in joint.limits)
    if joint.kind is JointKind.REVOLUTE:
        return say("{} to {}", low, high)
    return say("{} to {} {}", low, high, Given(story.robot.length_unit))


def _sums(story: Story) -> list[Block]:
    """The limits of sums of joint variables."""
    sums = story.robot.sums
    if not sums:
        return []
    shown = []
    for each in sums:
        low, high = (limit_symbol(value, each.kind) for value in each.limits)
        unit = [Given(story.robot.length_unit)] * (each.kind is JointKind.PRISMATIC)
        text = "{} from {} to {} {}" if unit else "{} from {} to {}"
        shown.append(say(text, variable_symbol(0, 0, ZERO, each.of), low, high, *unit))
    return [paragraph("Sums of joint values have limits: {}.", joined(shown))]


def _rounded(story: Story) -> list[Block]:
    """A remark for readers of the limits."""
    turning = [joint for joint in joints_of(story) if joint.kind is JointKind.REVOLUTE]
    limits = [value for joint in turning for value in joint.limits or ()]
    limits += [x for s in story.robot.sums if s.kind is JointKind.REVOLUTE for x in s.limits]
    if not any(map(is_rounded_limit, limits)):
        return []
    return [paragraph("Limits are rounded to a thousandth of a degree.")]


def _triple(cells: tuple[Expression, Expression, Expression]) -> Prose:
    shown = [expression_symbol(cell) for cell in cells]
    latex = ", ".join(symbol.latex for symbol in shown)
    return say("{}", Symbol(f"({latex})", "(" + ", ".join(symbol.text for symbol in shown) + ")"))


_ANGLE_TEXT = "In the formulas {} is the angle of joint {}: {}{}."
_LENGTH_TEXT = "In the formulas {} is the length of joint {}: {}."
_BOTH_TEXT = (
    "In the formulas {} is the angle of a revolute joint and {} the length of a prismatic "
    "one: {}{}."
)


def variables(story: Story) -> Block:
    """What theta_i and r_i are for the joint variables q_i."""
    angle, slide, q = Symbol(r"\theta_i", "θᵢ"), Symbol("r_i", "rᵢ"), Symbol("q_i", "qᵢ")
    changed: list[Prose] = []
    turning = plain = 0
    for number, joint in enumerate(joints_of(story), start=1):
        revolute = joint.kind is JointKind.REVOLUTE
        turning += revolute
        inner = theta(single(number)) if revolute else letter("r", "r", str(number))
        held = couplings_of(story, number)
        outer = variable_symbol(number, *sign_and_offset(story, number), held)
        if revolute and outer.text == joint_symbol(number).text:
            plain += 1
        else:
            changed.append(say("{}", equal(inner, outer)))
    if not changed:
        return paragraph(_ANGLE_TEXT, angle, _I, equal(angle, q), say(""))
    listed = joined(changed)
    if not turning:
        return paragraph(_LENGTH_TEXT, slide, _I, listed)
    rest = say(", otherwise {}", equal(angle, q)) if plain else say("")
    if turning == len(story.robot.joints):
        return paragraph(_ANGLE_TEXT, angle, _I, listed, rest)
    return paragraph(_BOTH_TEXT, angle, slide, listed, rest)


def joints_of(story: Story) -> tuple[DhRow | AxisJoint, ...]:
    """The joints as the user wrote them."""
    return tuple(story.robot.joints)


def couplings_of(story: Story, number: int) -> tuple[Coupling, ...]:
    """What other joints' drives add to a joint."""
    joint = story.robot.joints[number - 1]
    return joint.couplings if isinstance(joint, DhRow) else ()


def sign_and_offset(story: Story, number: int) -> tuple[int, Expression]:
    """What a joint's angle or length is for its variable: sign and what is added."""
    joint: DhRow | AxisJoint = story.robot.joints[number - 1]
    sign = story.algebra.chain.joints[number - 1].sign
    if not isinstance(joint, DhRow):
        return sign, ZERO
    return sign, joint.theta if joint.kind is JointKind.REVOLUTE else joint.d
