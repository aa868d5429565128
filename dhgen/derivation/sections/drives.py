"""Drives that move more than their own joint: from their values to the table's, and back."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.expressions import expression_symbol, variable_symbol
from dhgen.derivation.notation.names import joint_symbol, letter, link, single, theta
from dhgen.derivation.notation.signs import sign_and_size, summands
from dhgen.derivation.sections.tables import couplings_of, joints_of, sign_and_offset
from dhgen.derivation.text.blocks import Heading, display, joined, paragraph, say
from dhgen.derivation.text.formula import Formula, Symbol, add, equal, minus, times
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import PLAIN
from dhgen.derivation.text.words import many
from dhgen.kinematics.chain import Passive
from dhgen.robot import exact
from dhgen.robot.expression import ONE
from dhgen.robot.passive import followed
from dhgen.robot.robot import DhTable, JointKind

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.robot.expression import Expression
    from dhgen.robot.passive import Followed
    from dhgen.robot.robot import Coupling

_TEXT = (
    "The drives of this arm are coupled. {} is the value of drive {}, as the caller counts it; {} "
    "moved by other drives, too:"
)
_BACK = (
    "The forward model and the steps below are in {}. Of these, one after another, the drives have "
    "the values"
)
_EVERYWHERE = (
    "Rows, seeds, limits and whole turns, and the arguments of the forward model, are values of "
    "drives."
)
_COLUMNS = (
    "These are the columns {} by the joints' own angles and lengths{}. Those by the values of "
    "drives are, where they differ, {}."
)
_PASSIVE = (
    "Row {label} is passive: other drives move it. It is no joint, and its transform is part of "
    "{link}. Its {what} is"
)
_PASSIVE_ONLY = "{} is the value of drive {}, as the caller counts it."
_PASSIVE_COLUMNS = ", and that of {} is made in the same way, with the frame that it moves in"
_Q, _I = Symbol("q_i", "qᵢ"), Symbol("i", "i")


def drives_section(story: Story) -> list[Block]:
    """From the drives' values to the angles and lengths of the formulas, and back."""
    drives = story.algebra.chain.drives
    moved = [number for number in drives.order if couplings_of(story, number)]
    passive = _passive(story)
    if not moved and not passive:
        return []
    joints = _joints_moved(story, moved) if moved else [paragraph(_PASSIVE_ONLY, _Q, _I)]
    return [Heading(2, say("Coupled drives")), *joints, *passive, paragraph(_EVERYWHERE)]


def _joints_moved(story: Story, moved: list[int]) -> list[Block]:
    """Joints that drives of others move, too, and the way back to the drives."""
    slides = [number in story.algebra.slides for number in moved]
    what = "length" if all(slides) else "value" if any(slides) else "angle"
    plural = len(moved) > 1
    which = many("joint", [str(number) for number in sorted(moved)])
    clause = f"the {what}{'s' * plural} of {which} {'are' if plural else 'is'}"
    return [
        paragraph(_TEXT, _Q, _I, say(clause)),
        display(*(_there(story, number) for number in sorted(moved))),
        paragraph(_BACK, _letters(story)),
        display(*(drive_value(story, number) for number in moved)),
    ]


def _passive(story: Story) -> list[Block]:
    """What the rows without a drive follow, by drives and by joints, and where they are."""
    geometry, chain = story.robot.geometry, story.algebra.chain
    if not isinstance(geometry, DhTable):
        return []
    rows = dict(zip(geometry.labels, geometry.rows, strict=True))
    blocks: list[Block] = []
    for number, link_elements in enumerate(chain.links, start=1):
        for each in link_elements:
            if not isinstance(each, Passive):
                continue
            row = rows[each.label]
            cell = variable_symbol(0, 0, row.offset, row.couplings)
            what = "angle" if each.turns else "length"
            text = _PASSIVE.format(label=each.label, what=what, link="{}")
            sides = [passive_value(each), cell]
            if not each.apart:
                by_joints = _followed(story, followed(row, geometry.driven))
                sides += [by_joints] if show(by_joints, PLAIN) != cell.text else []
            blocks += [paragraph(text, link(number)), display(equal(*sides))]
    return blocks


def passive_value(passive: Passive) -> Formula:
    """The angle or length of a passive row, by its letter."""
    latex, text = (r"\theta", "θ") if passive.turns else ("r", "r")
    return letter(latex, text, passive.label)


def _followed(story: Story, found: Followed) -> Formula:
    """A sum of angles or lengths of joints: -theta_2 - theta_3 + pi/2."""
    parts: list[Formula] = []
    for joint, count in found.terms:
        inner = inner_value(story, joint)
        part = (
            inner if abs(count) == 1 else times(expression_symbol(exact.number(abs(count))), inner)
        )
        parts.append(minus(part) if count < 0 else part)
    return add(*parts, *signed_terms(found.offset))


def drive_value(story: Story, number: int) -> Formula:
    """The value of a drive: q_3 = theta_3 + q_2."""
    sign, offset = sign_and_offset(story, number)
    added = [_term(coupling) for coupling in couplings_of(story, number)]
    added += signed_terms(offset)
    inner = inner_value(story, number)
    if sign > 0:
        return equal(joint_symbol(number), add(inner, *map(minus, added)))
    return equal(joint_symbol(number), add(*added, minus(inner)))


def inner_value(story: Story, number: int) -> Formula:
    """The angle or length of a joint, by its letter."""
    turns = joints_of(story)[number - 1].kind is JointKind.REVOLUTE
    return theta(single(number)) if turns else letter("r", "r", str(number))


def columns_by_drives(story: Story) -> list[Block]:
    """The Jacobian's columns by drives, where these are sums of columns by angles and lengths."""
    geometry = story.robot.geometry
    if not isinstance(geometry, DhTable):
        return []
    rows = list(zip(geometry.labels, geometry.rows, strict=True))
    coupled = any(row.couplings for row in geometry.rows)
    sums: list[Prose] = []
    for drive in range(1, story.dof + 1):
        shares = [
            (label, each) for label, row in rows for each in row.couplings if each.joint == drive
        ]
        sign = sign_and_offset(story, drive)[0]
        if coupled and (shares or sign < 0):
            column = _column(str(drive))
            own = column if sign > 0 else minus(column)
            parts = [_times(each, _column(label)) for label, each in shares]
            sums.append(say("{}", equal(_of_drive(drive), add(own, *parts))))
    if not sums:
        return []
    passive = [label for label, row in rows if not row.sign]
    beside = say(_PASSIVE_COLUMNS.format(many("row", passive))) if passive else say("")
    return [paragraph(_COLUMNS, Symbol(r"\partial_i", "∂ᵢ"), beside, joined(sums))]


def _there(story: Story, number: int) -> Formula:
    row = (number, *sign_and_offset(story, number), couplings_of(story, number))
    return equal(inner_value(story, number), variable_symbol(*row))


def _letters(story: Story) -> Prose:
    angle, length = Symbol(r"\theta_i", "θᵢ"), Symbol("r_i", "rᵢ")
    if not story.algebra.slides:
        return say("{}", angle)
    return say("{}", length) if all(_slides(story)) else say("{} and {}", angle, length)


def _slides(story: Story) -> list[bool]:
    return [number in story.algebra.slides for number in range(1, story.dof + 1)]


def _column(label: str) -> Symbol:
    return letter(r"\partial", "∂", label)


def _of_drive(number: int) -> Symbol:
    return letter("J", "J", str(number))


def _term(coupling: Coupling) -> Formula:
    return _times(coupling, joint_symbol(coupling.joint))


def _times(coupling: Coupling, formula: Formula) -> Formula:
    """A drive's share, of what it is multiplied with."""
    sign, factor = sign_and_size(coupling.factor)
    product = _product(factor, formula)
    return product if sign > 0 else minus(product)


def _product(factor: Expression, formula: Formula) -> Formula:
    return formula if factor == ONE else times(_enclosed(factor), formula)


def signed_terms(offset: Expression) -> list[Formula]:
    """The terms of what is added to a variable."""
    terms = [(sign, _enclosed(term)) for sign, term in summands(offset)]
    return [term if sign > 0 else minus(term) for sign, term in terms]


def _enclosed(expression: Expression) -> Symbol:
    """An expression as a factor or a term."""
    symbol = expression_symbol(expression)
    if " + " in symbol.text or " − " in symbol.text:
        return Symbol(f"({symbol.latex})", f"({symbol.text})")
    return symbol
