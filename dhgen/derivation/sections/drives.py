"""Drives that move more than their own joint: from their values to the table's, and back."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.expressions import expression_symbol, variable_symbol
from dhgen.derivation.notation.names import joint_symbol, letter, single, theta
from dhgen.derivation.sections.tables import couplings_of, joints_of, sign_and_offset
from dhgen.derivation.text.blocks import Heading, display, joined, paragraph, say
from dhgen.derivation.text.formula import Formula, Symbol, add, equal, minus, times
from dhgen.derivation.text.words import many
from dhgen.robot.expression import ONE, ZERO, Negate
from dhgen.robot.robot import JointKind

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.robot.expression import Expression
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
    "These are the columns {} by the joints' own angles and lengths. A drive that moves several "
    "joints has a sum of them: {}."
)


def drives_section(story: Story) -> list[Block]:
    """From the drives' values to the angles and lengths of the formulas, and back."""
    drives = story.algebra.chain.drives
    moved = [number for number in drives.order if couplings_of(story, number)]
    if not moved:
        return []
    slides = [number in story.algebra.slides for number in moved]
    what = "length" if all(slides) else "value" if any(slides) else "angle"
    plural = len(moved) > 1
    which = many("joint", [str(number) for number in sorted(moved)])
    told = f"the {what}{'s' * plural} of {which} {'are' if plural else 'is'}"
    return [
        Heading(2, say("Coupled drives")),
        paragraph(_TEXT, Symbol("q_i", "qᵢ"), Symbol("i", "i"), say(told)),
        display(*(_there(story, number) for number in sorted(moved))),
        paragraph(_BACK, _letters(story)),
        display(*(drive_value(story, number) for number in moved)),
        paragraph(_EVERYWHERE),
    ]


def drive_value(story: Story, number: int) -> Formula:
    """The value of a drive: q_3 = theta_3 + q_2."""
    sign, offset = sign_and_offset(story, number)
    added = [_term(coupling) for coupling in couplings_of(story, number)]
    if offset != ZERO:
        added.append(_signed(offset))
    inner = inner_value(story, number)
    if sign > 0:
        return equal(joint_symbol(number), add(inner, *map(minus, added)))
    return equal(joint_symbol(number), add(*added, minus(inner)))


def inner_value(story: Story, number: int) -> Formula:
    """The angle or length of a joint, by its letter."""
    turns = joints_of(story)[number - 1].kind is JointKind.REVOLUTE
    return theta(single(number)) if turns else letter("r", "r", str(number))


def columns_by_drives(story: Story) -> list[Block]:
    """The Jacobian's columns by drives, where these are sums of those by angles and lengths."""
    sums: list[Prose] = []
    for drive in range(1, story.dof + 1):
        moved = [(n, each) for n in range(1, story.dof + 1) for each in couplings_of(story, n)]
        shares = [(number, each) for number, each in moved if each.joint == drive]
        if shares:
            own = _column(drive) if sign_and_offset(story, drive)[0] > 0 else minus(_column(drive))
            parts = [_times(each, _column(number)) for number, each in shares]
            sums.append(say("{}", equal(_of_drive(drive), add(own, *parts))))
    return [paragraph(_COLUMNS, Symbol(r"\partial_i", "∂ᵢ"), joined(sums))] if sums else []


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


def _column(number: int) -> Symbol:
    return letter(r"\partial", "∂", str(number))


def _of_drive(number: int) -> Symbol:
    return letter("J", "J", str(number))


def _term(coupling: Coupling) -> Formula:
    return _times(coupling, joint_symbol(coupling.joint))


def _times(coupling: Coupling, formula: Formula) -> Formula:
    """A drive's share, of what it is multiplied with."""
    factor = coupling.factor
    if isinstance(factor, Negate):
        return minus(_product(factor.operand, formula))
    return _product(factor, formula)


def _product(factor: Expression, formula: Formula) -> Formula:
    return formula if factor == ONE else times(_enclosed(factor), formula)


def _signed(offset: Expression) -> Formula:
    if isinstance(offset, Negate):
        return minus(_enclosed(offset.operand))
    return _enclosed(offset)


def _enclosed(expression: Expression) -> Symbol:
    """An expression as a factor or a term."""
    symbol = expression_symbol(expression)
    if " + " in symbol.text or " − " in symbol.text:
        return Symbol(f"({symbol.latex})", f"({symbol.text})")
    return symbol
