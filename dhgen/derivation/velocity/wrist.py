"""The Jacobian at the centre of a spherical wrist, in blocks of three joints."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.derivation.notation.matrices import expanded
from dhgen.kinematics.chain import Fixed, Slide, Turn
from dhgen.kinematics.product import product, reversed_elements
from dhgen.robot.task import Directions

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.derivation.story import Story
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.chain import Element
    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.transform import Transform

ARM = 3  # joints before the wrist, and the frame in which the blocks are shortest
CENTRES = (4, 5, 6)  # frames of which one has its origin there, as a rule the first

Vector = tuple["Polynomial", ...]
Block = tuple[Vector, ...]


@dataclass(frozen=True, slots=True)
class WristBlocks:
    """[J11 0; J21 J22], of the wrist centre's velocity and the angular velocity in frame 3.

    Attributes:
        arm: J11.
        turned: J21.
        hand: J22.
    """

    arm: Block
    turned: Block
    hand: Block


def wrist_blocks(story: Story) -> WristBlocks | None:
    """The blocks; None for arms that are not three joints and a wrist of three."""
    chain = story.algebra.chain
    poses = chain.task.directions is Directions.ROTATION and len(chain.task.position_rows) == 3
    plain = all(constant.is_length for constant in chain.constants)  # else they fill pages
    plain = plain and not (chain.drives.are_coupled or chain.passive)
    if chain.dof != 2 * ARM or story.wrist is None or chain.given or not (plain and poses):
        return None
    for centre in CENTRES:
        columns = list(velocity_columns(story.algebra, ARM, centre, 2 * ARM))
        if not any(entry for moved, _ in columns[ARM:] for entry in moved):
            (first, *others), spins = zip(*columns, strict=True)
            moved = tuple(_shortest(story.algebra, centre, entry) for entry in first), *others
            return WristBlocks(_turned(moved[:ARM]), _turned(spins[:ARM]), _turned(spins[ARM:]))
    return None


def _turned(columns: tuple[Vector, ...]) -> Block:
    return tuple(zip(*columns, strict=True))


def velocity_columns(
    algebra: Algebra, frame: int, centre: int | None, last: int
) -> Iterator[tuple[Vector, Vector]]:
    """What joints give a point of velocity, and the angular velocity, in a frame.

    Args:
        algebra: The arm's ring.
        frame: In which the columns are written.
        centre: The frame of which the point is the origin; None for the tool.
        last: The last joint that is asked.
    """
    chain = algebra.chain
    elements: list[Element] = [e for link in chain.links for e in algebra.lifted(link)]
    ends = [0]
    for link in chain.links:
        ends.append(ends[-1] + len(link))
    elements.append(Fixed(algebra.lift(chain.tool)))
    end = len(elements) if centre is None else ends[centre]
    point = between(algebra, elements, ends[frame], end).translation
    still = (algebra.ring.zero,) * 3
    for place, element in enumerate(elements):
        if not isinstance(element, Turn | Slide) or element.joint > last:
            continue
        sign = element.sign * chain.joints[element.joint - 1].sign
        at = between(algebra, elements, ends[frame], place)
        axis = tuple(sign * entry for entry in at.column(2))
        if isinstance(element, Slide):
            yield axis, still
            continue
        arm = tuple(a - b for a, b in zip(point, at.translation, strict=True))
        yield crossed(algebra, axis, arm), axis


def approach(algebra: Algebra, frame: int) -> Vector:
    """The tool's z axis in a frame."""
    links = algebra.chain.links
    behind: list[Element] = [e for link in links[frame:] for e in algebra.lifted(link)]
    return product([*behind, Fixed(algebra.lift(algebra.chain.tool))], algebra).column(2)


def between(algebra: Algebra, elements: list[Element], start: int, end: int) -> Transform:
    """The frame before one element seen from that before another."""
    if start <= end:
        return product(elements[start:end], algebra)
    return product(reversed_elements(elements[end:start], algebra), algebra)


def crossed(algebra: Algebra, a: Vector, b: Vector) -> Vector:
    """The vector product."""
    return tuple(algebra.normal(a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2]) for i in range(3))


def adjugate(algebra: Algebra, block: Block) -> Block:
    """The inverse of three rows times the determinant: its rows are products of the columns."""
    columns = tuple(zip(*block, strict=True))
    return tuple(crossed(algebra, columns[i - 2], columns[i - 1]) for i in range(3))


def determinant(algebra: Algebra, block: Block) -> Polynomial:
    """Of three rows."""
    first = [row[0] for row in block]
    inverse = adjugate(algebra, block)[0]
    return algebra.normal(
        sum((a * b for a, b in zip(first, inverse, strict=True)), algebra.ring.zero)
    )


@dataclass(frozen=True, slots=True)
class ArmRows:
    """J11 where one of its rows is that of joint 1 alone.

    Attributes:
        alone: That row, from 0.
        lever: Its entry.
        rest: The two others, from 0.
        first: Of these the column of joint 1.
        inverse: Of these the columns of joints 2 and 3, inverted: for each of the two joints the
        numerators and, last, the denominator.
    """

    alone: int
    lever: Polynomial
    rest: tuple[int, int]
    first: Vector
    inverse: Block


def arm_rows(story: Story, blocks: WristBlocks) -> ArmRows | None:
    """The rows of the arm; None where joint 1 moves the wrist centre along with others."""
    algebra = story.algebra
    alone = [row for row in range(ARM) if not any(blocks.arm[row][1:])]
    if not alone:
        return None
    row = alone[0]
    first_row, second_row = (each for each in range(ARM) if each != row)
    rest = first_row, second_row
    (a, b), (c, d) = (blocks.arm[each][1:] for each in rest)
    size = algebra.normal(a * d - b * c)
    inverse = (_reduced(d, -b, size), _reduced(-c, a, size))
    first = tuple(blocks.arm[each][0] for each in rest)
    return ArmRows(row, blocks.arm[row][0], rest, first, inverse)


def _reduced(*forms: Polynomial) -> Vector:
    """Polynomials without the monomial that all of them share."""
    common = tuple(map(min, zip(*(monomial for form in forms for monomial in form), strict=True)))
    ring = forms[0].ring
    return tuple(
        ring.from_dict(
            {
                tuple(e - p for e, p in zip(monomial, common, strict=True)): coefficient
                for monomial, coefficient in form.terms()
                if coefficient
            }
        )
        for form in forms
    )


def _shortest(algebra: Algebra, centre: int, entry: Polynomial) -> Polynomial:
    """The entry, or what another frame has for it if that is shorter."""
    value, found = expanded(algebra, entry), entry
    for frame in (1, 2):
        moved, _ = next(velocity_columns(algebra, frame, centre, 1))
        for each in (each for other in moved for each in (other, -other)):
            if len(each) < len(found) and expanded(algebra, each) == value:
                found = each
    return found
