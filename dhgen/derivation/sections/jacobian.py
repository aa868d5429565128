"""The geometric Jacobian: its columns by joint kind, written out where they are short."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.sections.drives import columns_by_drives
from dhgen.derivation.sections.tables import joints_of
from dhgen.derivation.text.blocks import display, paragraph
from dhgen.derivation.text.formula import Formula, Matrix, Symbol, equal, times
from dhgen.derivation.text.lines import WIDTH, width
from dhgen.derivation.text.words import many
from dhgen.kinematics.chain import Fixed, Passive, Slide, Turn
from dhgen.kinematics.product import product
from dhgen.kinematics.transform import compose, identity
from dhgen.robot.robot import Convention, DhTable

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.chain import Element
    from dhgen.kinematics.constants import Polynomial

_J = Symbol("J", "J")
_TOOL_ORIGIN = Symbol("o_n", "oₙ")


def jacobian_columns(story: Story) -> list[Block]:
    """The formula of a column."""
    by_drives = columns_by_drives(story)
    return [
        paragraph(
            "The geometric Jacobian {} takes joint velocities to the velocity of the tool's origin "
            "{} and its angular velocity. Its column {} is" + _of_kinds(story),
            *(_J, _TOOL_ORIGIN, Symbol("i", "i")),
        ),
        *_columns(story, by_angles=bool(by_drives)),
        *by_drives,
    ]


def _of_kinds(story: Story) -> str:
    """A clause with the kinds of columns, where the arm has both kinds of joints."""
    slides, joints = len(story.algebra.slides), len(story.algebra.chain.joints)
    return ", for a revolute and for a prismatic joint," if 0 < slides < joints else ""


def jacobian_blocks(story: Story) -> list[Block]:
    """The formula of a column, and the matrix when it is narrow enough."""
    blocks = jacobian_columns(story)
    apart = any(row.apart for row in story.algebra.chain.passive)
    if apart or any(not factor.is_integer() for factor in _factors(story.algebra)):
        return blocks
    rows = _rows(story.algebra)
    if sum(len(entry) for row in rows for entry in row) > WIDTH:  # a term is a character at least
        return blocks
    matrix = Matrix(tuple(tuple(story.write_forward(entry) for entry in row) for row in rows))
    columns = zip(*matrix.rows, strict=True)
    total = sum(max(width(e) for e in column if e is not None) + 2 for column in columns) + 6
    if total <= WIDTH:
        blocks += [paragraph("Written out,"), display(equal(_J, matrix))]
    return blocks


def _columns(story: Story, *, by_angles: bool) -> list[Block]:
    """The two kinds of columns, by angles and lengths or else by drives, and what is in them."""
    own = not isinstance(story.robot.geometry, DhTable) or (
        story.robot.geometry.convention is Convention.MODIFIED
    )
    z, o = ("z_i", "o_i") if own else ("z_{i-1}", "o_{i-1}")
    zt, ot = ("zᵢ", "oᵢ") if own else ("zᵢ₋₁", "oᵢ₋₁")
    turning = Symbol(
        rf"\begin{{bmatrix}} {z} \times (o_n - {o}) \\ {z} \end{{bmatrix}}",
        f"[{zt} × (oₙ − {ot}); {zt}]",
    )
    sliding = Symbol(rf"\begin{{bmatrix}} {z} \\ 0 \end{{bmatrix}}", f"[{zt}; 0]")
    slides, joints = len(story.algebra.slides), len(story.algebra.chain.joints)
    kinds = [turning] * (slides < joints) + [sliding] * (slides > 0)
    both = Symbol(
        r" \qquad \text{and} \qquad ".join(each.latex for each in kinds) + ",",
        "  and  ".join(each.text for each in kinds) + ",",
    )
    frame: Formula = Symbol("T_i^0", "Tᵢ⁰") if own else Symbol("T_{i-1}^0", "Tᵢ₋₁⁰")
    if story.algebra.chain.base != identity(story.algebra.chain.ring):
        frame = times(Symbol("Z", "Z"), frame)
    reversed_ = [str(j.number) for j in story.algebra.chain.joints if j.sign < 0]
    text = "where {} and {} are columns 3 and 4 of {}, and {} is column 4 of {}."
    if reversed_ and not by_angles:
        text += f" For {many('joint', reversed_)} it has the opposite sign, as the variable has."
    last = story.algebra.chain.links[-1]
    joint = next(k for k, element in enumerate(last) if isinstance(element, (Turn, Slide)))
    if own and any(isinstance(element, Passive) for element in last[joint:]):
        text += f" Those of joint {len(joints_of(story))} are of the frame before the passive rows."
    whole = Symbol(r"T_{\mathrm{base,tool}}", "T_base,tool")
    parts = (Symbol(z, zt), Symbol(o, ot), frame, _TOOL_ORIGIN, whole)
    return [display(both), paragraph(text, *parts)]


def _rows(algebra: Algebra) -> list[tuple[Polynomial, ...]]:
    """The six rows; every column is a derivative of the origin and an axis."""
    chain = algebra.chain
    elements: list[Element] = [e for link in chain.links for e in algebra.lifted(link)]
    base, tool = algebra.lift(chain.base), algebra.lift(chain.tool)
    whole = compose(compose(base, product(elements, algebra), algebra.normal), tool, algebra.normal)
    columns: list[list[Polynomial]] = [[algebra.ring.zero] * 6 for _ in chain.joints]
    for place, element in enumerate(elements):
        if isinstance(element, Fixed):
            continue
        before = compose(base, product(elements[:place], algebra), algebra.normal)
        for joint, count in element.signed:
            for row, entry in enumerate(before.column(2)):
                columns[joint - 1][row + 3 * element.turns] += count * entry
        if isinstance(element, Turn):  # of all that its angle moves
            moved = (derivative(algebra, e, element.joint) for e in whole.translation)
            columns[element.joint - 1][:3] = moved
    columns = [[algebra.normal(entry) for entry in column] for column in columns]
    matrix = chain.drives.matrix.astype(int).tolist()
    return [_by_drives(algebra, row, matrix) for row in zip(*columns, strict=True)]


def _by_drives(
    algebra: Algebra, row: tuple[Polynomial, ...], matrix: list[list[int]]
) -> tuple[Polynomial, ...]:
    """A row by the drives, of one by angles and lengths."""
    rates = zip(*matrix, strict=True)
    return tuple(
        sum((each * entry for each, entry in zip(rate, row, strict=True)), algebra.ring.zero)
        for rate in rates
    )


def _factors(algebra: Algebra) -> list[float]:
    return [share.factor for joint in algebra.chain.joints for share in joint.shares]


def derivative(algebra: Algebra, polynomial: Polynomial, joint: int) -> Polynomial:
    """The derivative by the angle of a joint."""
    total = algebra.ring.zero
    for angle in algebra.angles:
        facing = dict(angle.terms).get(joint)
        if facing is None:
            continue
        c, s = algebra.generator(angle.cosine), algebra.generator(angle.sine)
        total += facing * (polynomial.diff(s) * c - polynomial.diff(c) * s)
    return algebra.normal(total)
