"""What is still known of the angles about two axes that are parallel at a singular place.

Turning about one of them can be undone about the other: the orientation gives the sum of their
angles where the axes have one direction, and the difference where they are opposite (document 004).
The entries of a known matrix say what it is where they are read with the joint between at rest.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.derivation.notation.matrices import expanded, of_single
from dhgen.derivation.notation.names import cosine, sine, single, target, theta
from dhgen.derivation.text.blocks import say
from dhgen.derivation.text.formula import (
    ONE,
    ZERO,
    Minus,
    Symbol,
    add,
    atan2,
    equal,
    minus,
    subtract,
)
from dhgen.derivation.text.words import joined as listed
from dhgen.kinematics.algebra import AngleSum
from dhgen.kinematics.chain import Turn, parallel_groups
from dhgen.kinematics.product import product
from dhgen.kinematics.ring import substitute, used_places

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

    from dhgen.derivation.notation.matrices import Form
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Prose
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial


@dataclass(frozen=True, slots=True)
class SumLeft:
    """The combinations of two angles that are known where their axes are parallel.

    Attributes:
        axes: The numbers of all axes that are parallel then.
        pair: The two angles; each may be a sum of those of its own parallel axes.
        joint: The one between them.
        by_sine: Whether its sine vanishes there, and not its cosine.
        facing: 1 when the sum is known where `between` is 1, -1 when the difference is.
    """

    axes: tuple[int, ...]
    pair: tuple[AngleSum, AngleSum]
    joint: int
    by_sine: bool
    facing: int

    @property
    def between(self) -> Formula:
        """The cosine or sine of the joint between, 1 or -1 there."""
        return (cosine if self.by_sine else sine)(single(self.joint))

    @property
    def vanishing(self) -> Formula:
        """Its other function."""
        return (sine if self.by_sine else cosine)(single(self.joint))

    def combination(self, between: int) -> Formula:
        """What is known where the joint between has 1 or -1."""
        first, second = map(theta, self.pair)
        return (add if between == self.facing else subtract)(first, second)

    @property
    def prose(self) -> Prose:
        """The sentence on it."""
        axes = f"axes {listed([str(joint) for joint in self.axes])} are parallel"
        known = [self.combination(sign) for sign in (1, -1)]
        where = [equal(self.between, one) for one in (ONE, minus(ONE))]
        text = f"{axes}, and only {{}} ({{}}) or {{}} ({{}}) is determined"
        (*_, (before, _)), ((behind, _), *_) = (angle.terms for angle in self.pair)
        if behind - before > 2 or any(len(angle.terms) > 1 for angle in self.pair):
            text = f"{axes}, and the orientation gives only {{}} ({{}}) or {{}} ({{}})"
        return say(text, known[0], where[0], known[1], where[1])


def sum_left(algebra: Algebra, joints: Polynomial | None) -> SumLeft | None:
    """The angles about the axes before and behind a joint that makes these parallel.

    Slides may be between: they turn nothing.

    Args:
        algebra: The arm's ring.
        joints: What vanishes there; the sine or the cosine of that joint, else there is no answer.
    """
    if joints is None or len(joints) != 1:
        return None
    used = used_places(joints)
    turning = [a for a in algebra.angles if used & {algebra.index[a.sine], algebra.index[a.cosine]}]
    if len(turning) != 1 or len(turning[0].terms) != 1 or len(used) != 1:
        return None
    k = turning[0].terms[0][0]
    elements = [e for link in algebra.chain.links for e in algebra.lifted(link)]
    turns = {e.joint: (place, e) for place, e in enumerate(elements) if isinstance(e, Turn)}
    beside = (
        max((j for j in turns if j < k), default=0),
        min((j for j in turns if j > k), default=0),
    )
    if not all(beside):
        return None
    (start, before), (end, behind) = (turns[joint] for joint in beside)
    lean = product(elements[start + 1 : end], algebra).rotation[2][2]
    by_sine = used == {algebra.index[single(k).sine]}
    straight = algebra.generator(single(k).cosine if by_sine else single(k).sine)
    if lean not in (straight, -straight):
        return None
    runs = [
        next(run for run in parallel_groups(algebra.chain) if joint in dict(run))
        for joint in beside
    ]
    facing = before.sign * behind.sign * dict(runs[0])[beside[0]] * dict(runs[1])[beside[1]]
    return SumLeft(
        tuple(joint for run in runs for joint, _ in run),
        (AngleSum(runs[0]), AngleSum(runs[1])),
        k,
        by_sine,
        facing if lean == straight else -facing,
    )


def read_off(story: Story, number: int, left: SumLeft) -> Prose | None:
    """What the sum and the difference are, by two entries of a known matrix.

    Args:
        story: The derivation.
        number: The step whose angle is free there, from 1.
        left: Of which angles.

    Returns:
        A sentence; None where no column of a known matrix has letters that say it.
    """
    for name, form, letters in _known_forms(story, number):
        for column in range(3):
            told = [_told(story, form, letters, column, left, sign) for sign in (1, -1)]
            if told[0] is not None and told[1] is not None:
                return say(
                    "With {} the entries of {} give {} ({}) or {} ({}).",
                    equal(left.vanishing, ZERO),
                    name,
                    told[0],
                    equal(left.between, ONE),
                    told[1],
                    equal(left.between, minus(ONE)),
                )
    return None


def _known_forms(
    story: Story, number: int
) -> Iterator[tuple[Formula, Form, Mapping[Polynomial, Formula]]]:
    """The matrix with letters, and U_0."""
    side = story.known_side
    if side is not None and side.after < number:
        yield side.symbol, story.form(side.place), side.letters
    yield target(0), story.form((0, story.dof, False, False)), {}


def _told(
    story: Story,
    form: Form,
    letters: Mapping[Polynomial, Formula],
    column: int,
    left: SumLeft,
    between: int,
) -> Formula | None:
    """theta_4 + theta_6 = atan2(u_21, u_11), by the entries of a column; else None."""
    algebra = story.algebra
    sign = between * left.facing
    first, second = left.pair
    turned = AngleSum((*first.terms, *((joint, sign * each) for joint, each in second.terms)))
    wanted = of_single(algebra, turned)
    straight = {
        algebra.index[single(left.joint).cosine]: algebra.ring(between if left.by_sine else 0),
        algebra.index[single(left.joint).sine]: algebra.ring(0 if left.by_sine else between),
    }
    found: dict[int, Formula] = {}
    for row in range(3):
        entry = substitute(expanded(algebra, form.right.entry(row, column)), straight)
        for place, function in enumerate(wanted):
            facing = (entry == function) - (entry == -function)
            known = story.written_with(facing * form.left.entry(row, column), letters)
            if facing and isinstance(known.operand if isinstance(known, Minus) else known, Symbol):
                found[place] = known
    if len(found) < 2:
        return None
    if sign < 0 and isinstance(found[1], Minus):  # theta_6 - theta_4 has the opposite sine
        return equal(subtract(theta(second), theta(first)), atan2(minus(found[1]), found[0]))
    return equal(left.combination(between), atan2(found[1], found[0]))
