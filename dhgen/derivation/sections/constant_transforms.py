"""What does not move in an arm whose joints are found together: matrices and lengths by letters."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import letter
from dhgen.derivation.sections.transforms import matrix_of, side_by_side
from dhgen.derivation.text.blocks import Folded
from dhgen.derivation.text.formula import atan2, equal, root
from dhgen.derivation.velocity.columns import crossed
from dhgen.kinematics.chain import Fixed, Slide, Turn
from dhgen.kinematics.product import product
from dhgen.kinematics.ring import constant_value
from dhgen.kinematics.transform import compose, dot, identity

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.chain import Element
    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.transform import Transform

Vector = tuple["Polynomial", ...]


def constant_matrices(story: Story) -> list[Block]:
    """C_0, K_0 to K_4 and C_6 of an arm of six joints as matrices, without identities."""
    algebra, chain = story.algebra, story.algebra.chain
    between: list[list[Element]] = [[]]
    for link in chain.links:
        for element in algebra.lifted(link):
            if isinstance(element, Fixed):
                between[-1].append(element)
            else:
                between.append([])
    constant = [product(each, algebra) for each in between]
    constant[0] = compose(algebra.lift(chain.base), constant[0], algebra.normal)
    constant[-1] = compose(constant[-1], algebra.lift(chain.tool), algebra.normal)
    names = [letter("C", "C", "0"), *(letter("K", "K", str(k)) for k in range(5))]
    names.append(letter("C", "C", "6"))
    shown = [
        equal(name, matrix_of(transform, story.write_forward))
        for name, transform in zip(names, constant, strict=True)
        if transform != identity(algebra.ring)
    ]
    return [Folded("The constant transforms as matrices", tuple(side_by_side(shown)))]


def triangle_of_the_offset_wrist(story: Story) -> tuple[Formula, Formula, Formula]:
    """|SB|, |BW| and the angle from BW to axis 4 about axis 3, by the lengths of the table.

    S is where axes 1 and 2 meet, B a point on axis 3, W where axes 4 and 5 meet.
    """
    algebra = story.algebra
    (p2, _), (p3, z3), (p4, z4), (p5, _) = (_axis(algebra, joint) for joint in (2, 3, 4, 5))
    along = dot(_apart(p5, p4), z4, algebra.normal)
    W = tuple(algebra.normal(p + along * z) for p, z in zip(p4, z4, strict=True))
    upper, lower = (_across(algebra, each, z3) for each in (_apart(p3, p2), _apart(W, p3)))
    turned = dot(crossed(algebra, lower, z4), z3, algebra.normal)
    facing = dot(lower, z4, algebra.normal)
    angle = atan2(story.write_forward(turned), story.write_forward(facing))
    return _length(story, upper), _length(story, lower), angle


def _axis(algebra: Algebra, joint: int) -> tuple[Vector, Vector]:
    """A point and the direction of an axis in the reference position."""
    found: list[Element] = []
    for element in (e for link in algebra.chain.links for e in algebra.lifted(link)):
        if isinstance(element, Turn | Slide):
            if element.joint == joint:
                return _as_axis(product(found, algebra), element.sign)
        else:
            found.append(element)
    raise ValueError(joint)


def _as_axis(frame: Transform, sign: int) -> tuple[Vector, Vector]:
    return frame.translation, tuple(sign * entry for entry in frame.column(2))


def _apart(one: Vector, other: Vector) -> Vector:
    return tuple(a - b for a, b in zip(one, other, strict=True))


def _across(algebra: Algebra, vector: Vector, axis: Vector) -> Vector:
    """What of a vector is across an axis."""
    along = dot(vector, axis, algebra.normal)
    return tuple(algebra.normal(v - along * z) for v, z in zip(vector, axis, strict=True))


def _length(story: Story, vector: Vector) -> Formula:
    """The length of a vector; of one along an axis of its frame the coordinate without its sign."""
    parts = [part for part in vector if part]
    if len(parts) == 1:
        facing = 1 if constant_value(story.algebra, parts[0]) > 0.0 else -1
        return story.write_forward(facing * parts[0])
    return root(story.write_forward(dot(vector, vector, story.algebra.normal)))
