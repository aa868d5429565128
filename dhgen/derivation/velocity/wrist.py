"""The Jacobian at the centre of a spherical wrist, in blocks of three joints."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.derivation.notation.matrices import expanded
from dhgen.derivation.velocity.columns import crossed, view_from
from dhgen.robot.task import Directions

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial

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
        columns = view_from(story, ARM).columns(centre)
        if not any(entry for moved, _ in columns[ARM:] for entry in moved):
            (first, *others), spins = zip(*columns, strict=True)
            moved = tuple(_shortest(story, centre, entry) for entry in first), *others
            return WristBlocks(_turned(moved[:ARM]), _turned(spins[:ARM]), _turned(spins[ARM:]))
    return None


def _turned(columns: tuple[Vector, ...]) -> Block:
    return tuple(zip(*columns, strict=True))


def adjugate(algebra: Algebra, block: Block) -> Block:
    """The inverse of three rows times the determinant: its rows are products of the columns."""
    columns = tuple(zip(*block, strict=True))
    return tuple(crossed(algebra, columns[i - 2], columns[i - 1]) for i in range(3))


@dataclass(frozen=True, slots=True)
class ArmRows:
    """J11 where one of its rows is that of joint 1 alone.

    Attributes:
        alone: That row, from 0.
        lever: What stands in it.
        rest: The two others, from 0.
        first: Of these the column of joint 1.
        inverse: Of these the columns of joints 2 and 3, inverted: for each of the two joints what
            stands above and, last, below the fraction.
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


def _shortest(story: Story, centre: int, entry: Polynomial) -> Polynomial:
    """The same as the entry, as another frame has it if that is shorter."""
    algebra = story.algebra
    value, found = expanded(algebra, entry), entry
    for frame in (1, 2):
        moved, _ = view_from(story, frame).columns(centre)[0]
        for each in (each for other in moved for each in (other, -other)):
            if len(each) < len(found) and expanded(algebra, each) == value:
                found = each
    return found
