"""The title, the opening paragraph, and the section about the robot as the user wrote it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.robot.expression import Name, Negate, Number
from dhgen.robot.robot import Convention, DhRow, DhTable, JointKind, TaskKind
from dhgen.targets.derivation.blocks import (
    Given,
    Heading,
    Paragraph,
    Table,
    joined,
    paragraph,
    say,
)
from dhgen.targets.derivation.expressions import (
    expression_symbol,
    limit_symbol,
    variable_symbol,
)
from dhgen.targets.derivation.formula import Listing, Symbol, equal, number, relation
from dhgen.targets.derivation.frames import frame_sentences
from dhgen.targets.derivation.names import joint_symbol, letter, parameter, single, theta
from dhgen.targets.derivation.words import counted, many

if TYPE_CHECKING:
    from dhgen.robot.robot import Parameter
    from dhgen.targets.derivation.blocks import Block, Prose
    from dhgen.targets.derivation.formula import Formula
    from dhgen.targets.derivation.story import Story

_CONVENTIONS = {
    Convention.STANDARD: Symbol(
        r"A_i = R_z(\theta_i)\,T_z(d_i)\,T_x(a_i)\,R_x(\alpha_i)",
        "Aᵢ = Rz(θᵢ) Tz(dᵢ) Tx(aᵢ) Rx(αᵢ)",
    ),
    Convention.MODIFIED: Symbol(
        r"A_i = R_x(\alpha_i)\,T_x(a_i)\,R_z(\theta_i)\,T_z(d_i)",
        "Aᵢ = Rx(αᵢ) Tx(aᵢ) Rz(θᵢ) Tz(dᵢ)",
    ),
}
_AXES = Symbol(r"z_{i-1}", "zᵢ₋₁"), Symbol("z_i", "zᵢ"), Symbol("x_i", "xᵢ")
_THETA_I = Symbol(r"\theta_i", "θᵢ")
_I = Symbol("i", "i")


def opening(story: Story) -> list[Block]:
    """The title and what the arm is."""
    kinds = [joint.kind for joint in story.robot.joints]
    letters = "".join("R" if kind is JointKind.REVOLUTE else "P" for kind in kinds)
    first = say(
        f"{letters}: {_kinds(kinds)}. {_task(story)} {_solutions(story)}"
    )
    return [
        Heading(1, say("{}: inverse kinematics", Given(story.robot.title))),
        Paragraph(first),
        *_source(story),
    ]


def robot_section(story: Story) -> list[Block]:
    """Table or axes, convention, parameters, frames."""
    blocks: list[Block] = [Heading(2, say("The robot"))]
    blocks += _table(story) if isinstance(story.robot.geometry, DhTable) else _axes(story)
    blocks += _parameters(story)
    blocks += [Paragraph(prose) for prose in frame_sentences(story)]
    return blocks


def _kinds(kinds: list[JointKind]) -> str:
    turning = [str(i) for i, kind in enumerate(kinds, 1) if kind is JointKind.REVOLUTE]
    sliding = [str(i) for i, kind in enumerate(kinds, 1) if kind is JointKind.PRISMATIC]
    if not sliding:
        return f"{counted(len(turning), 'revolute joint')}"
    if not turning:
        return f"{counted(len(sliding), 'prismatic joint')}"
    return (
        f"{counted(len(kinds), 'joint')}, {many('joint', turning)} revolute and "
        f"{many('joint', sliding)} prismatic"
    )


def _task(story: Story) -> str:
    task = story.robot.task
    if task.kind is TaskKind.COORDINATES:
        return f"Task: {many('the coordinate', list(task.coordinates))} of the tool.{_free(story)}"
    words = {
        TaskKind.POSE: "the pose of the tool, position and orientation",
        TaskKind.POSITION: "the position of the tool; its orientation follows",
        TaskKind.ORIENTATION: "the orientation of the tool; its position is not asked for",
        TaskKind.POINTING: "the position of the tool and the direction of its z axis",
    }
    return f"Task: {words[task.kind]}.{_free(story)}"


def _free(story: Story) -> str:
    if not story.robot.free:
        return ""
    joints = [str(joint) for joint in story.robot.free]
    return f" The caller gives the value of {many('joint', joints)}."


def _solutions(story: Story) -> str:
    rows = story.program.rows
    if rows == 1:
        return "Every pose within reach has one solution, row 0."
    names = [f"{place} {name}" for place, name in enumerate(story.branch_names)]
    count = counted(rows, "solution")
    if story.has_branch_words:
        return f"At most {count}, each always in the same row: {', '.join(names)}."
    return (
        f"At most {count}, each always in the same row, 0 to {rows - 1}; "
        "the tree below gives the branch signs of every row."
    )


def _source(story: Story) -> list[Block]:
    if not story.robot.source:
        return []
    return [paragraph("Source of the numbers: {}.", Given(story.robot.source.rstrip(".")))]


def _table(story: Story) -> list[Block]:
    geometry = story.robot.geometry
    assert isinstance(geometry, DhTable)
    limited = any(row.limits for row in geometry.rows)
    header = [say("joint"), say("{}", letter(r"\theta", "θ")), say("{}", letter("d", "d"))]
    header += [say("{}", letter("a", "a")), say("{}", letter(r"\alpha", "α"))]
    header += [say("limits")] if limited else []
    rows = [
        (*_cells(number, row), *([_limits(row.limits, row.kind, story)] if limited else []))
        for number, row in enumerate(geometry.rows, start=1)
    ]
    standard = geometry.convention is Convention.STANDARD
    which = "Standard" if standard else "Modified"
    before, own, x = _AXES
    text = (
        "{} convention: {}. Joint {} moves about or along {}; {} points along the common normal of "
        + ("{} and {}." if standard else "{} and the next axis.")
    )
    axis = before if standard else own
    parts = [say(which), _CONVENTIONS[geometry.convention], _I, axis, x]
    parts += [before, own] if standard else [own]
    return [Table(tuple(header), tuple(rows)), paragraph(text, *parts), *_variables(story)]


def _cells(number_: int, row: DhRow) -> tuple[Prose, ...]:
    theta_cell, d_cell = expression_symbol(row.theta), expression_symbol(row.d)
    if row.kind is JointKind.REVOLUTE:
        theta_cell = variable_symbol(number_, row.sign, row.theta)
    else:
        d_cell = variable_symbol(number_, row.sign, row.d)
    cells = (theta_cell, d_cell, expression_symbol(row.a), expression_symbol(row.alpha))
    return (say(str(number_)), *(say("{}", cell) for cell in cells))


def _limits(limits: tuple[float, float] | None, kind: JointKind, story: Story) -> Prose:
    if limits is None:
        return say("—")
    low, high = (limit_symbol(value, kind) for value in limits)
    if kind is JointKind.REVOLUTE:
        return say("{} to {}", low, high)
    return say("{} to {} {}", low, high, Given(story.robot.length_unit))


def _variables(story: Story) -> list[Block]:
    """What theta_i and r_i are for the joint values q_i."""
    changed: list[Formula] = []
    geometry = story.robot.geometry
    assert isinstance(geometry, DhTable)
    slides = False
    for number_, row in enumerate(geometry.rows, start=1):
        plain = row.sign > 0 and row.offset_is_zero if hasattr(row, "offset_is_zero") else None
        del plain
        offset = row.theta if row.kind is JointKind.REVOLUTE else row.d
        symbol = variable_symbol(number_, row.sign, offset)
        if row.kind is JointKind.PRISMATIC:
            slides = True
            changed.append(equal(letter("r", "r", str(number_)), symbol))
        elif symbol.text != joint_symbol(number_).text:
            changed.append(equal(theta(single(number_)), symbol))
    if not changed:
        return [paragraph("Below, {} is the joint variable {}.", _THETA_I, Symbol("q_i", "qᵢ"))]
    lengths = " and the length of a prismatic joint {}" if slides else "{}"
    r = Symbol("r_i", "rᵢ") if slides else say("")
    items = Listing(tuple(changed)) if len(changed) > 1 else changed[0]
    return [
        paragraph(
            "Below, {} is the angle in the table" + lengths + ": {}; the other angles are the joint "
            "variables {} themselves." if len(changed) < len(geometry.rows)
            else "Below, {} is the angle in the table" + lengths + ": {}.",
            _THETA_I, r, items, *([Symbol("q_i", "qᵢ")] if len(changed) < len(geometry.rows) else []),
        )
    ]


def _axes(story: Story) -> list[Block]:
    header = tuple(say(word) for word in ("joint", "type", "direction", "point", "limits"))
    limited = any(joint.limits for joint in story.robot.joints)
    rows = []
    for place, joint in enumerate(story.robot.joints, start=1):
        assert not isinstance(joint, DhRow)
        direction = _triple(joint.direction)
        point = say("—") if joint.kind is JointKind.PRISMATIC else _triple(joint.point)
        cells = [say(str(place)), say(joint.kind.value), direction, point]
        cells += [_limits(joint.limits, joint.kind, story)] if limited else []
        rows.append(tuple(cells))
    text = (
        "The axes are given in the reference position, where every {} is zero, in the base frame "
        "(document 001). Frame {} is fixed to link {}: its {} lies along axis {}, and joint {} turns "
        "or slides it about that axis; {} takes frame {} to frame {}."
    )
    q, z, a = Symbol("q_i", "qᵢ"), Symbol("z", "z"), Symbol("A_i", "Aᵢ")
    before = Symbol("i-1", "i−1")
    return [
        Table(header if limited else header[:-1], tuple(rows)),
        paragraph(text, q, _I, _I, z, _I, _I, a, before, _I),
    ]


def _triple(cells: tuple[object, object, object]) -> Prose:
    shown = [expression_symbol(cell) for cell in cells]  # type: ignore[arg-type]
    latex = "(" + ", ".join(symbol.latex for symbol in shown) + ")"
    return say("{}", Symbol(latex, "(" + ", ".join(symbol.text for symbol in shown) + ")"))


def _parameters(story: Story) -> list[Block]:
    if not story.robot.parameters:
        return []
    unit = Given(story.robot.length_unit)
    shown = [_parameter(each, unit) for each in story.robot.parameters]
    return [paragraph("Parameters: {}.", joined(shown))]


def _parameter(each: Parameter, unit: Given) -> Prose:
    symbol = parameter(each.name)
    value = Symbol(repr(each.value).removesuffix(".0"), repr(each.value).removesuffix(".0"))
    written = each.expression
    plain = isinstance(written, Number) or (
        isinstance(written, Negate) and isinstance(written.operand, Number)
    )
    if plain or isinstance(written, Name):
        return say("{} {}", equal(symbol, value), unit)
    return say("{} {}", equal(symbol, expression_symbol(written), value), unit)


__all__ = ["number", "opening", "relation", "robot_section"]
