"""How the inverse begins: U_0, named points, and the elements of the U matrices that are used."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import POSE_PLACES
from dhgen.kinematics.transform import Transform, compose, identity, inverse
from dhgen.paul.arm_plane import SHOULDER
from dhgen.paul.problem import task_entries
from dhgen.robot.task import TaskKind
from dhgen.targets.derivation.blocks import (
    Given,
    Heading,
    Paragraph,
    display,
    joined,
    paragraph,
    say,
    sentences,
)
from dhgen.targets.derivation.formula import Element, Listing, Product, Symbol, equal, times
from dhgen.targets.derivation.given_pose import BASE, POSE, TOOL, given_pose, moved_left
from dhgen.targets.derivation.matrices import (
    known_matrix,
    left_name,
    middle_name,
    sides,
)
from dhgen.targets.derivation.names import inverse as inverse_name
from dhgen.targets.derivation.names import letter, link, target
from dhgen.targets.derivation.polynomial import Writer, alphabet
from dhgen.targets.derivation.shoulder_section import shoulder_blocks
from dhgen.targets.derivation.style import LATEX, PLAIN, show
from dhgen.targets.derivation.types_table import types_table
from dhgen.targets.derivation.words import many
from dhgen.targets.walk import reads

if TYPE_CHECKING:
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.pool import BasePoint, Origin, Point
    from dhgen.targets.derivation.blocks import Block, Prose
    from dhgen.targets.derivation.formula import Formula
    from dhgen.targets.derivation.matrices import Form
    from dhgen.targets.derivation.story import Story


SEED = (
    "The seed is a set of joint values that the caller may give, such as the arm's present ones: a "
    "joint that the pose leaves free takes its value from there."
)


def inverse_beginning(story: Story) -> list[Block]:
    """Everything before the first step."""
    blocks: list[Block] = [Heading(2, say("Inverse"))]
    blocks += _given(story)
    blocks += types_table(story)
    blocks += _stay(story)
    for point in story.derivation.pool.points:
        if _is_used(story, point):
            blocks += _point(story, point)
    for base_point in story.derivation.pool.base_points:
        if _is_used(story, base_point):
            blocks += _base_point(story, base_point)
    return blocks + shoulder_blocks(story) + _matrices(story)


def _given(story: Story) -> list[Block]:
    """U_0, and its entries where base or tool are moved to the left."""
    left, right = moved_left(story)
    method = say(
        "Paul's method multiplies both sides of {} by {}, {} and so on from the left, {}, until an "
        "element holds one unknown or is of one of the types of document 003.",
        equal(target(0), Symbol(r"A_1 \cdots A_n", "A₁⋯Aₙ")),
        inverse_name(link(1)),
        inverse_name(link(2)),
        equal(Symbol("U_i", "Uᵢ"), Symbol(r"A_i^{-1} U_{i-1}", "Aᵢ⁻¹ Uᵢ₋₁")),
    )
    named = sorted(task_entries(story.algebra.chain.task))
    which = say("")
    if len(named) < 12:
        which = say(" Of its entries the task gives {}.", _named(story))
    blocks: list[Block] = [
        paragraph(
            "The pose {} of the tool is given, and with it {}.{} {}",
            POSE,
            given_pose(story),
            which,
            method,
        ),
        *_other_forms(story),
        *([paragraph(SEED)] if reads(story.program, "seed") else []),
    ]
    if left or right:
        blocks += _entries(story, left=left, right=right)
    return blocks


def _other_forms(story: Story) -> list[Block]:
    """How the forms come about that are none of Paul's U_i."""
    mixed = [o for step in story.steps for o in step.origins if o.is_mixed]
    texts: list[Prose] = []
    last = [inverse_name(link(story.dof - i)) for i in (0, 1)]
    if not all(origin.inverse for origin in mixed):
        text = "Some steps need the last joints on the left as well: there both sides are also "
        texts.append(say(text + "multiplied by {}, {} and so on from the right.", *last))
    if any(origin.inverse for origin in mixed):
        text = "Some equations are those of {}, in which a frame of the base is seen from the tool."
        texts.append(say(text, inverse_name(target(0))))
    return [Paragraph(sentences(texts))] if texts else []


def _named(story: Story) -> Prose:
    """The entries of U_0 that the task gives, without those that repeat others."""
    if story.algebra.chain.task.kind is TaskKind.ORIENTATION:
        return say("the nine of the rotation")
    known = sorted(story.derivation.problem.known)
    return say("{}", Listing(tuple(story.letters[name] for name in known)))


def _entries(story: Story, *, left: bool, right: bool) -> list[Block]:
    """The entries of U_0 by those of POS = (p_ij)."""
    algebra = story.algebra
    problem = story.derivation.problem
    entry = [[algebra.generator(f"t{i}{j}") for j in range(1, 5)] for i in range(1, 4)]
    given = Transform(tuple(tuple(row[:3]) for row in entry), tuple(row[3] for row in entry))
    if left:
        back = inverse(algebra.lift(algebra.chain.base), algebra.normal)
        given = compose(back, given, algebra.normal)
    if right:
        back = inverse(algebra.lift(algebra.chain.tool), algebra.normal)
        given = compose(given, back, algebra.normal)
    letters = dict(story.letters)
    for i in range(1, 4):
        for j in range(1, 5):
            letters[f"t{i}{j}"] = letter("p", "p", f"{i}{j}", f"p{i}{j}")
    writer = Writer(alphabet(algebra, letters), lambda _: 0)
    shown = [
        equal(story.letters[name], writer.write(given.entry(*POSE_PLACES[name])))
        for name in sorted(problem.known, key=lambda name: (name[2], name[1]))
    ]
    entries = equal(POSE, Symbol("(p_{ij})", "(pᵢⱼ)"))
    return [paragraph("With {} its entries are", entries), display(*shown)]


def _stay(story: Story) -> list[Block]:
    """Base and tool that stay on the right, because the task does not give the whole pose."""
    problem = story.derivation.problem
    chain = story.algebra.chain
    still = identity(chain.ring)
    stays: list[Prose] = []
    if not problem.base_left and chain.base != still:
        stays.append(say("{} stands for {}", link(1), times(BASE, link(1))))
    if not problem.tool_left and chain.tool != still:
        stays.append(say("{} stands for {}", link(chain.dof), times(link(chain.dof), TOOL)))
    if not stays:
        return []
    text = (
        "The task gives only a part of the pose; moving a constant frame to the other side would "
        "mix that part with the rest, so it stays where it is: in this section {}."
    )
    return [paragraph(text, joined(stays))]


def _is_used(story: Story, point: Point | BasePoint) -> bool:
    places = [story.algebra.index[name] for name in point.names]
    return any(
        monomial[place]
        for quotes in story.quotes
        for quote in quotes
        for side in (quote.left, quote.right)
        for monomial in side
        for place in places
    )


def _point(story: Story, point: Point) -> list[Block]:
    problem = story.derivation.problem
    k = story.frame_of(point)
    coordinates = []
    for row, name in enumerate(point.names):
        total = problem.target.entry(row, 3)
        for column, length in enumerate(point.in_tool):
            total += problem.target.entry(row, column) * length
        coordinates.append(equal(story.letters[name], story.write(total)))
    joints = many("joint", [str(j) for j in range(k + 1, story.dof + 1)])
    turn = "does" if k + 1 == story.dof else "do"
    assert story.wrist is not None or not story.is_wrist_frame(k)
    if story.wrist is not None and story.is_wrist_frame(k):
        first = "The wrist centre {} is the origin of frame {}, where the axes {}, {} and {} meet"
        three = [Given(str(joint)) for joint in story.wrist]
        head = say(first, Symbol("w", "w"), Given(str(k)), *three)
    else:
        text = "The pose gives a second point {}, the origin of frame {}"
        head = say(text, Symbol("w", "w"), Given(str(k)))
    text = (
        f"{{}}: {joints} {turn} not move it. In the last frame it is {{}}, so its position "
        "follows from the pose alone:"
    )
    entries = [story.write(entry) for entry in point.in_tool]
    shown = Symbol(*(f"({', '.join(show(e, style) for e in entries)})" for style in (LATEX, PLAIN)))
    return [paragraph(text, head, shown), display(*coordinates)]


def _base_point(story: Story, point: BasePoint) -> list[Block]:
    """A point of the base as the tool sees it: R' (b - t)."""
    target = story.derivation.problem.target
    name = letter("w", "w", point.names[0][1:-1])
    coordinates = []
    for column, own in enumerate(point.names):
        total = story.algebra.ring.zero
        for row, length in enumerate(point.in_base):
            total += target.entry(row, column) * (length - target.entry(row, 3))
        coordinates.append(equal(story.letters[own], story.write(total)))
    entries = [story.write(entry) for entry in point.in_base]
    shown = Symbol(*(f"({', '.join(show(e, style) for e in entries)})" for style in (LATEX, PLAIN)))
    text = "The point {} is fixed in the base. Seen from the last frame it is at {}:"
    return [paragraph(text, shown, name), display(*coordinates)]


def _matrices(story: Story) -> list[Block]:
    """Both sides of every element in the columns that the steps use, each once."""
    used: dict[tuple[bool, bool, int, int], list[Origin]] = {}
    for step in story.steps:
        for origin in step.origins:
            key = (origin.shoulder, origin.inverse, origin.m, -origin.k)
            used.setdefault(key, []).append(origin)
    blocks: list[Block] = []
    for _, origins in sorted(used.items()):
        form = story.form(origins[0].matrix)
        equations = [
            _element_equation(story, form, *place) for place in _wanted(story, form, origins)
        ]
        if equations:
            blocks.append(display(*equations))
            blocks.insert(len(blocks) - 1, paragraph("{}", _form_sentence(story, form)))
    if not blocks:
        return []
    text = "The elements that are used below, and their neighbours in column 4:"
    return [paragraph(text), *blocks]


def _form_sentence(story: Story, form: Form) -> Prose:
    """U_m = A_m^-1 U_{m-1} = A_{m+1} ... A_k."""
    m, k, inverted, shoulder = form.place
    name, middle = left_name(form.place, story.dof), middle_name(form.place)
    last = SHOULDER if shoulder else story.dof
    if inverted:
        seen = [Given(str(number)) for number in (m, k)]
        return say("{} (frame {} seen from frame {}):", equal(name, middle), *seen)
    if k == last:
        before: tuple[Formula, ...] = ()
        if m:
            earlier = left_name((m - 1, k, inverted, shoulder), story.dof)
            before = (Product((inverse_name(link(m)), earlier)),)
        return say("{}:", equal(name, *before, middle))
    moved = many("joint", [str(j) for j in range(k + 1, last + 1)])
    text = f"{{}} ({moved} moved to the side of {{}}):"
    return say(text, equal(name, middle), known_matrix(form.place))


def _wanted(story: Story, form: Form, origins: list[Origin]) -> list[tuple[int, int]]:
    """The elements to show: used ones, and the whole of column 4 where the task gives it."""
    withheld = {story.algebra.index[f"t{i}{j}"] for i in (1, 2, 3) for j in (1, 2, 3, 4)} - {
        story.algebra.index[name] for name in story.derivation.problem.known
    }

    def is_given(polynomial: Polynomial) -> bool:
        return not any(monomial[place] for monomial in polynomial for place in withheld)

    wanted = {(origin.row, origin.column) for origin in origins if origin.row}
    if any(origin.column == 4 for origin in origins):
        wanted |= {(row, 4) for row in (1, 2, 3) if is_given(form.left.entry(row - 1, 3))}
    kept = []
    for row, column in sorted(wanted, key=lambda place: (place[1], place[0])):
        left, right = sides(form, row, column)
        if left != right:
            kept.append((row, column))
    return kept


def _element_equation(story: Story, form: Form, row: int, column: int) -> Formula:
    left, right = sides(form, row, column)
    name = Element(left_name(form.place, story.dof), row, column)
    return equal(name, story.write(left), story.write_forward(right))
