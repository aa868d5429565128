"""The determinant of the Jacobian, taken apart: of every block of its rows the factors.

In normal form a product may look like none, so the minors of small blocks stay as they are.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from functools import cache, lru_cache
from typing import TYPE_CHECKING

from sympy.core.random import seed

from dhgen.derivation.conditions import are_never_zero, unsigned
from dhgen.derivation.notation.matrices import expanded
from dhgen.derivation.text.formula import (
    ZERO,
    Minus,
    Power,
    Relation,
    Symbol,
    factors_of,
    times,
)
from dhgen.derivation.velocity.task_rows import ways_to_see
from dhgen.kinematics.ring import primitive

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.derivation.step_context import Singularity
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.formula import Formula
    from dhgen.derivation.velocity.columns import Vector
    from dhgen.derivation.velocity.task_rows import Rows, Seen
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial

MOST_TERMS = 200  # of a determinant that is taken apart, and of the minors that it is made of
FEW = 3  # rows whose minors stay as they are
SMALL = 2 * FEW**3  # the effort of two such blocks, which are taken apart in every frame
SEED = 1  # the same input takes the same time
LONGEST = 20  # terms of a factor that still says something to a reader
OF_VELOCITY = Symbol(r"\det J_v", "det Jᵥ")

Powers = Counter["Polynomial"]


@dataclass(frozen=True, slots=True)
class Factor:
    """What the determinant is a multiple of.

    Attributes:
        formula: As it is printed.
        power: How often it is a factor.
        place: The first place where it is listed; None where no step has it as its condition.
        written_out: The formula in the letters of the arm alone.
        is_never_zero: Whether the numbers of the arm keep it from vanishing.
    """

    formula: Formula
    power: int
    place: Singularity | None
    written_out: Formula
    is_never_zero: bool = False


@dataclass(frozen=True, slots=True)
class Block:
    """Columns of velocities, with a determinant that is too long to be written out.

    Attributes:
        frame: In which they are written.
        centre: The frame of which the origin has these velocities.
        columns: By the numbers of the joints that give them.
    """

    frame: int
    centre: int
    columns: tuple[tuple[int, Vector], ...]


@dataclass(frozen=True, slots=True)
class Determinant:
    """The determinant in factors.

    Attributes:
        constant: What does not move: a number and powers of lengths.
        factors: What does.
        rows: How many rows of the Jacobian are not zero, among those that the task names.
        block: What the factor `OF_VELOCITY` is of; None where only the position is looked at.
        elsewhere: A frame, and that with whose origin's velocity the rows are as many as the
            columns, where with the tool's they are more; else None.
    """

    constant: Formula
    factors: tuple[Factor, ...]
    rows: int
    block: Block | None = None
    elsewhere: tuple[int, int] | None = None

    @property
    def formula(self) -> Formula:
        """All of it."""
        return times(self.constant, *(raised(f.formula, f.power) for f in self.factors))


def raised(formula: Formula, power: int) -> Formula:
    """A formula with an exponent that is not one."""
    return formula if power == 1 else Power(formula, power)


@dataclass(frozen=True, slots=True)
class _Parts:
    """A determinant taken apart.

    Attributes:
        still: A monomial that does not move.
        powers: How often polynomials are factors.
        long: The columns of a block of velocities that stays a determinant.
        elsewhere: The frame and that of the origin with the velocities, where it has to be these.
    """

    still: Polynomial
    powers: Powers
    long: tuple[int, ...]
    elsewhere: tuple[int, int] | None = None

    @property
    def length(self) -> tuple[int, str]:
        """How many terms all factors have; then by alphabet."""
        return sum(map(len, self.powers)), str((self.still, *self.powers))


def determinant_of(
    story: Story, places: Sequence[Singularity] = (), *, by_position: bool = False
) -> Determinant | None:
    """A number and letters that do not move, times the factors; None where one fills pages.

    Args:
        story: The derivation.
        places: What the table of singular configurations lists.
        by_position: Whether the rows are those of the position alone.
    """
    parts = _shortest_parts(story, by_position=by_position)
    if parts is None:
        return None
    constant, factors = written(story, places, parts.still, parts.powers)
    block = _shortest_block(story, parts.long) if parts.long and not by_position else None
    if parts.long and block is None and not by_position:
        return None
    return Determinant(constant, factors, len(story.algebra.chain.solved), block, parts.elsewhere)


def written(
    story: Story, places: Sequence[Singularity], still: Polynomial, powers: Powers
) -> tuple[Formula, tuple[Factor, ...]]:
    """A monomial that does not move and factors of a determinant as they are printed."""
    algebra, constants, moving = story.algebra, [], []
    for form, power in powers.items():
        forward = story.write_forward(form)
        if algebra.is_constant(form):
            constants.append(raised(forward, power))
            continue
        never = are_never_zero(algebra, form)
        if len(form) > LONGEST:
            moving.append(Factor(OF_VELOCITY, power, None, forward, never))
            continue
        shown = unsigned(story, form)
        if power % 2 and shown != forward:
            still = -still
        moving.append(Factor(shown, power, _place_of(shown, places), shown, never))
    return times(story.write_forward(still), *constants), tuple(moving)


def _place_of(factor: Formula, places: Iterable[Singularity]) -> Singularity | None:
    """The first place whose condition in joints has a factor."""
    for place in places:
        joints = place.joints
        if isinstance(joints, Relation) and len(joints.sides) == 2 and joints.sides[1] == ZERO:
            side = joints.sides[0]
            factors = factors_of(side.operand if isinstance(side, Minus) else side)
            if factor in {each.base if isinstance(each, Power) else each for each in factors}:
                return place
    return None


@lru_cache(maxsize=8)
def _shortest_parts(story: Story, *, by_position: bool) -> _Parts | None:
    """In the frame in which they are shortest."""
    ways, every = ways_to_see(story, by_position=by_position), []
    for way in ways:
        if way.triangle.effort > max(ways[0].triangle.effort, SMALL):
            break
        parts = _taken_apart(story.algebra, way)
        if parts is not None:
            every.append(parts)
        elif way.triangle.effort > SMALL:
            break
    return min(every, key=lambda each: each.length, default=None)


def _taken_apart(algebra: Algebra, seen: Seen) -> _Parts | None:
    """The factors of the blocks of a matrix; None where one is long and no block of velocities."""
    still, powers = algebra.ring.ground_new(seen.triangle.sign), Powers()
    long: tuple[int, ...] = ()
    for rows, columns in seen.triangle.blocks:
        block = tuple(tuple(seen.rows[row][column] for column in columns) for row in rows)
        size = determinant(algebra, block)
        if not size:
            return None
        scale, found = factors_with_powers(algebra, size)
        if any(len(form) > LONGEST for form in found):
            if long or not seen.are_velocities(rows) or columns[-1] >= len(algebra.chain.solved):
                return None
            long, scale, found = columns, algebra.ring.one, Powers({algebra.normal(size): 1})
        still *= scale
        powers += found
    return _Parts(still, powers, long, None if seen.is_of_poses else (seen.frame, seen.centre))


def factors_with_powers(algebra: Algebra, size: Polynomial) -> tuple[Polynomial, Powers]:
    """A monomial that does not move, and the other factors."""
    seed(SEED)  # sympy draws places at random, and may take for ever at some
    scale, factors = size.factor_list()
    still, others = algebra.ring.ground_new(scale), Powers()
    for factor, power in factors:
        forms = (algebra.normal(factor), algebra.normal(expanded(algebra, factor)))
        number_, form = primitive(min(forms, key=len))
        still *= number_**power
        if len(form) == 1 and algebra.is_constant(form):
            still *= form**power
        else:
            others[form] += power
    for each in algebra.chain.constants:
        if each.cosine is not None:  # c^2 - 1
            ends = [algebra.generator(each.cosine) + one for one in (1, -1)]
            power = min(others[end] for end in ends)
            still *= (-(algebra.generator(each.name) ** 2)) ** power
            others -= Powers(dict.fromkeys(ends, power))
    return still, others


def _shortest_block(story: Story, columns: tuple[int, ...]) -> Block | None:
    """The velocities of some joints, in the arm's frame in which they are shortest, if any."""
    found = []
    for seen in ways_to_see(story):
        rows = tuple(range(len(columns)))
        if seen.frame < 0 or (rows, columns) not in seen.triangle.blocks:
            continue
        vectors = [tuple(seen.rows[row][column] for row in rows) for column in columns]
        found.append((sum(len(entry) for each in vectors for entry in each), seen, vectors))
    if not found:
        return None
    _, seen, vectors = min(found, key=lambda each: (each[0], each[1].frame, each[1].centre))
    joints = [story.algebra.chain.solved[column].number for column in columns]
    return Block(seen.frame, seen.centre, tuple(zip(joints, vectors, strict=True)))


def determinant(algebra: Algebra, rows: Rows) -> Polynomial | None:
    """By minors, rows with most zeros first; None where one has too many terms."""
    count = len(rows)
    order = sorted(range(count), key=lambda row: sum(map(bool, rows[row])))
    turned = sum(order[i] > order[j] for j in range(count) for i in range(j))

    @cache
    def minor(left: tuple[int, ...]) -> Polynomial | None:
        """Of the last rows, in these columns."""
        if not left:
            return algebra.ring.one
        total = algebra.ring.zero
        for place, column in enumerate(left):
            entry = rows[order[count - len(left)]][column]
            if entry:
                below = minor(left[:place] + left[place + 1 :])
                if below is None:
                    return None
                total += (-1) ** place * entry * below
        if count > FEW:
            total = algebra.normal(total)
        return None if len(total) > MOST_TERMS else total

    size = minor(tuple(range(count)))
    return None if size is None else (-1) ** turned * size
