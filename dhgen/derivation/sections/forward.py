"""The forward model: A_i, T_i^0 reduced and expanded, the tool, relations, the Jacobian."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.matrices import expanded, forward_of, link_matrix
from dhgen.derivation.notation.names import (
    BASE,
    POSE,
    TOOL,
    forward_matrix,
    inverse,
    link,
    target,
)
from dhgen.derivation.sections.jacobian import jacobian_blocks, jacobian_columns
from dhgen.derivation.sections.transforms import (
    fills_pages,
    matrix_of,
    side_by_side,
    transform_blocks,
)
from dhgen.derivation.text.blocks import Display, Folded, Heading, display, paragraph, say
from dhgen.derivation.text.formula import (
    Call,
    Element,
    Listing,
    Symbol,
    equal,
    times,
)
from dhgen.kinematics.task import STEEPNESS
from dhgen.kinematics.transform import compose, identity
from dhgen.robot.task import Directions

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block
    from dhgen.derivation.text.formula import Formula, Relation


T_BASE_TOOL = Symbol(r"T_{\mathrm{base,tool}}", "T_base,tool")


def forward_section(story: Story) -> list[Block]:
    """The whole section."""
    blocks: list[Block] = [Heading(2, say("Forward"))]
    blocks += _links(story)
    blocks += _products(story)
    blocks += _expanded(story)
    blocks += _tool(story)
    blocks += _relations(story)
    return blocks + jacobian_blocks(story)


def forward_in_short(story: Story) -> list[Block]:
    """The forward model without the products, where no step of a derivation needs them."""
    chain = story.algebra.chain
    factors: list[Formula] = [link(i) for i in range(1, story.dof + 1)]
    blocks: list[Block] = [Heading(2, say("Forward")), *_links(story)]
    still, given = identity(chain.ring), []
    if chain.base != still:
        factors.insert(0, BASE)
        given.append(equal(BASE, matrix_of(story.algebra.lift(chain.base), story.write_forward)))
    if chain.tool != still:
        factors.append(TOOL)
        given.append(equal(TOOL, matrix_of(story.algebra.lift(chain.tool), story.write_forward)))
    blocks.append(
        paragraph(
            "The pose of the tool is their product; that of the first joints is {}:",
            equal(Symbol("T_i^0", "Tᵢ⁰"), Symbol(r"A_1 \cdots A_i", "A₁⋯Aᵢ")),
        )
    )
    blocks += [display(each) for each in (equal(T_BASE_TOOL, times(*factors)), *given)]
    return blocks + jacobian_columns(story)


def _links(story: Story) -> list[Block]:
    algebra = story.algebra
    matrices: list[Formula] = [
        equal(link(i), matrix_of(link_matrix(algebra, i), story.write_forward))
        for i in range(1, story.dof + 1)
    ]
    return [paragraph("The transforms of the joints:"), *side_by_side(matrices)]


def _products(story: Story) -> list[Block]:
    blocks: list[Block] = []
    if story.dof < 2:
        return blocks
    reduced = any(len(angle.terms) > 1 for angle in story.algebra.angles)
    note = ", in reduced form (sums of angles are kept)" if reduced else ""
    blocks.append(
        paragraph(
            "Their products {}" + note + ", with {}:",
            equal(Symbol("T_i^0", "Tᵢ⁰"), Symbol(r"A_1 \cdots A_i", "A₁⋯Aᵢ")),
            equal(forward_matrix(1), link(1)),
        )
    )
    left: list[Formula] = []
    for i in range(2, story.dof + 1):
        name, product = forward_matrix(i), forward_of(story.algebra, i)
        before = forward_matrix(i - 1), forward_of(story.algebra, i - 1)
        if fills_pages(name, product, story.write_forward):
            left.append(equal(name, times(before[0], link(i))))
        else:
            known = None if left else before
            blocks += transform_blocks(name, product, story.write_forward, known)
    if left:
        text = "Written out, the others would fill pages; they are left as products:"
        blocks += [paragraph(text), display(*left)]
    return blocks


def _expanded(story: Story) -> list[Block]:
    """T_n^0 with the sums of angles written out, where there are any."""
    algebra = story.algebra
    reduced = forward_of(algebra, story.dof)
    full = reduced.mapped(lambda entry: expanded(algebra, entry))
    name = forward_matrix(story.dof)
    if fills_pages(name, full, story.write_forward):
        return []
    changed = [
        equal(Element(name, row + 1, column + 1), story.write_forward(full.entry(row, column)))
        for column in range(4)
        for row in range(3)
        if full.entry(row, column) != reduced.entry(row, column)
    ]
    if not changed:
        return []
    intro = paragraph("In expanded form the entries of {} that hold sums of angles are", name)
    return [Folded("The same without sums of angles", (intro, display(*changed)))]


def _tool(story: Story) -> list[Block]:
    algebra = story.algebra
    chain = algebra.chain
    still = identity(algebra.ring)
    base, tool = algebra.lift(chain.base), algebra.lift(chain.tool)
    last = forward_matrix(story.dof)
    if base == still and tool == still:
        return [
            paragraph(
                f"The arm's base and the tool are frames 0 and {story.dof} themselves: {{}}.",
                equal(T_BASE_TOOL, last),
            )
        ]
    parts = [*([BASE] if base != still else []), last, *([TOOL] if tool != still else [])]
    given = [
        equal(name, matrix_of(transform, story.write_forward))
        for name, transform in ((BASE, base), (TOOL, tool))
        if transform != still
    ]
    joints = forward_of(algebra, story.dof)
    whole = compose(compose(base, joints, algebra.normal), tool, algebra.normal)
    frames = (
        "With the base frame {} and the tool frame {}"
        if len(given) == 2
        else ("With the base frame {}" if base != still else "With the tool frame {}")
    )
    names = [name for name, transform in ((BASE, base), (TOOL, tool)) if transform != still]
    blocks: list[Block] = [
        paragraph(frames + ",", *names),
        display(Listing(tuple(given)) if len(given) > 1 else given[0]),
    ]
    pose = equal(T_BASE_TOOL, times(*parts))
    if fills_pages(T_BASE_TOOL, whole, story.write_forward):
        return [*blocks, paragraph("the pose of the tool is {}.", pose)]
    known = None if fills_pages(last, joints, story.write_forward) else (last, joints)
    written = transform_blocks(T_BASE_TOOL, whole, story.write_forward, known)
    end = ":" if isinstance(written[0], Display) else "."
    return [*blocks, paragraph("the pose of the tool is {}" + end, pose), *written]


def _relations(story: Story) -> list[Block]:
    """Entries of U_0 that are constant for this arm, or equal to others."""
    problem = story.derivation.problem
    levelled = story.algebra.chain.task.directions is Directions.YAW
    found: list[Formula] = []
    for column in range(4):
        for row in range(3):
            name = f"t{row + 1}{column + 1}"
            entry = problem.target.entry(row, column)
            is_made_so = levelled and name == STEEPNESS
            if entry != story.algebra.generator(name) and not is_made_so:
                found.append(equal(story.letters[name], story.write(entry)))
    if not found:
        return []
    text = (
        "Let {} be the pose that the tool is to take, and {}. Whatever the joints do, some entries "
        "of {} are constant or repeat others; a pose that breaks these relations cannot "
        "be reached:"
    )
    given = paragraph(text, POSE, given_pose(story), target(0))
    return [given, display(Listing(tuple(found)))]


def moved_left(story: Story) -> tuple[bool, bool]:
    """Whether a base and a tool are moved to the side of the pose."""
    problem, algebra = story.derivation.problem, story.algebra
    still, chain = identity(algebra.ring), algebra.chain
    base = problem.base_left and algebra.lift(chain.base) != still
    return base, problem.tool_left != still


def given_pose(story: Story) -> Relation:
    """U_0 = Z^-1 POS E^-1 = (t_ij), without what does not move."""
    base, tool = moved_left(story)
    left, right = [inverse(BASE)] * base, [tool_back(story)] * tool
    return equal(target(0), times(*left, POSE, *right), Symbol("(t_{ij})", "(tᵢⱼ)"))


def tool_back(story: Story) -> Formula:
    """E^-1, or the way back along the tool's z axis."""
    if story.algebra.chain.task.names_rotation:
        return inverse(TOOL)
    length = story.derivation.problem.tool_left.translation[2]
    return Call("T_z", (story.write(-length),))
