"""The inverse of an arm that is solved by iteration, with a pose in numbers.

The prose is `templates/derivation/numerical.md.jinja`.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.conditions import are_never_zero, unsigned, without_lengths
from dhgen.derivation.example import Example, drawn
from dhgen.derivation.geometry import size_in_words
from dhgen.derivation.notation.names import joint_symbol
from dhgen.derivation.sections.example import all_rows, pose_blocks
from dhgen.derivation.text.blocks import Display, Heading, display, paragraph, say
from dhgen.derivation.text.formula import ZERO, Listing, Matrix, Symbol, equal, subtract, times
from dhgen.derivation.text.template import blocks_of
from dhgen.derivation.values import figures, joint_value
from dhgen.derivation.velocity.columns import view_from
from dhgen.derivation.whole_turns import are_inside, turned_rows
from dhgen.kinematics.given import given_values
from dhgen.kinematics.product import product
from dhgen.kinematics.transform import identity
from dhgen.program.interpret import interpret
from dhgen.robot.task import COORDINATES, Directions
from dhgen.runtime.plain import plain

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.arrays import FloatArray
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.constants import Polynomial
    from dhgen.numerical.kernel import NumericalKernel

REGULAR = 0.05  # least singular value of the task's rows, lengths in arm sizes
NEAREST = 1e-7  # of the way to the seed along motions that keep the tool: none is left [rad]
E, HAT_J, SEED = Symbol("e", "e"), Symbol(r"\hat J", "J^"), Symbol(r"q^{\mathrm{seed}}", "q,seed")
STEP, TRANSPOSED = Symbol(r"\Delta q", "Δq"), Symbol(r"\hat J^{T}", "J^ᵀ")


def numerical_section(story: Story, kernel: NumericalKernel) -> list[Block]:
    """What replaces the steps of Paul's method."""
    search = plain("numerical.search")
    return blocks_of(
        "numerical",
        redundant=kernel.redundant,
        size=size_in_words(story.algebra.chain),
        damping=plain("numerical.descent").DAMPING,
        starts=search.STARTS,
        more_starts=search.REDUNDANT_STARTS - 1,
        rounds=search.ROUNDS,
        rows=kernel.rows,
        residual=f"{kernel.residual:.0e}",
        example=_example_blocks(story, kernel),
        parallel=_where_columns_are_parallel(story),
        given=bool(story.algebra.chain.given),
    )


@dataclass(frozen=True, slots=True)
class _Seeded:
    """A pose with its rows, the nearest of which is to a seed.

    Attributes:
        example: The pose.
        seed: Joint values, (n,).
    """

    example: Example
    seed: FloatArray


def _example_blocks(story: Story, kernel: NumericalKernel) -> list[Block]:
    found = _seeded(story, kernel)
    if found is None:
        return []
    example = found.example
    blocks: list[Block] = [Heading(2, say("An example")), *pose_blocks(story, example)]
    if not kernel.redundant:
        return [*blocks, *all_rows(story, example)]
    blocks += [
        paragraph("The seed is"),
        _joints(story, found.seed),
    ]
    if kernel.directions is Directions.NONE:
        blocks += _first_step(kernel, found)
    blocks += [
        paragraph("The steps end at row 0:"),
        _joints(story, example.rows[0]),
    ]
    if kernel.directions is Directions.NONE:
        blocks += _nearest(kernel, found)
    return [
        *blocks,
        paragraph("Put into the forward model it gives what the task names of the pose again."),
    ]


def _seeded(story: Story, kernel: NumericalKernel) -> _Seeded | None:
    """The drawn pose whose solution needs the least motion from the one before.

    None where drives move several joints, and where every solution touches a limit.
    """
    chain, arm = story.algebra.chain, kernel.arm
    if chain.is_coupled or chain.arm_angle:
        return None
    q = drawn(chain)
    seeds = np.roll(q, 1, axis=0)
    T, given = arm.pose(q), given_values(arm, q)
    rows = interpret(story.program, T, seeds, given).q
    best = None
    for k in range(len(q)):
        regular = np.linalg.svd(_rows(kernel, q[k]), compute_uv=False)[-1] > REGULAR
        if np.isnan(rows[k, 0]).any() or not regular:
            continue
        if kernel.redundant and not _is_nearest(kernel, rows[k, 0], seeds[k]):
            continue
        way = float(np.linalg.norm(rows[k, 0] - seeds[k]))
        if best is None or way < best[0]:
            best = way, k
    if best is None:
        return None
    k = best[1]
    turned, inside = turned_rows(chain, rows[k]), are_inside(chain, rows[k])
    return _Seeded(Example(q[k], T[k], given[k], turned, inside, 0), seeds[k])


def _rows(kernel: NumericalKernel, q: FloatArray) -> FloatArray:
    """The rows of the Jacobian that the task names of a position, in units, (m, n)."""
    chain = kernel.arm.chain
    J = kernel.arm.jacobian(q[None])[0][:, list(kernel.solved)] * np.array(kernel.units)
    J[:3] /= chain.size
    spins = J[3:] if kernel.directions is not Directions.NONE else J[:0]
    return np.asarray(np.vstack([J[list(kernel.position)], spins]))


def _difference(kernel: NumericalKernel, q: FloatArray, seed: FloatArray) -> FloatArray:
    """From the seed, in units."""
    return np.asarray((q - seed)[list(kernel.solved)] / np.array(kernel.units))


def _is_nearest(kernel: NumericalKernel, q: FloatArray, seed: FloatArray) -> bool:
    """Whether the way to the seed is a combination of the rows: no limit holds a joint."""
    if kernel.directions is not Directions.NONE:
        return True
    J, off = _rows(kernel, q), _difference(kernel, q, seed)
    left = off - np.linalg.pinv(J) @ (J @ off)
    return bool(np.abs(left).max() < NEAREST)


def _joints(story: Story, q: FloatArray) -> Display:
    """The values of all joints in a line."""
    values = enumerate(q.tolist(), start=1)
    return Display(
        (Listing(tuple(equal(joint_symbol(j), joint_value(story, j, x)) for j, x in values)),)
    )


def _column(values: Iterable[float]) -> Matrix:
    return Matrix(tuple((figures(float(each)),) for each in values))


def _matrix(rows: FloatArray) -> Matrix:
    return Matrix(tuple(tuple(figures(float(each)) for each in row) for row in rows))


def _first_step(kernel: NumericalKernel, found: _Seeded) -> list[Block]:
    """From the seed, where nothing pulls towards it yet."""
    descent = plain("numerical.descent")
    there = kernel.arm.pose(found.seed[None])[0]
    off = (found.example.T - there)[list(kernel.position), 3] / kernel.arm.chain.size
    J = _rows(kernel, found.seed)
    damping = descent.DAMPING * min(float(off @ off), 1.0) + descent.FLOOR
    step = J.T @ np.linalg.solve(J @ J.T + damping * np.eye(len(J)), off)
    at = [
        equal(Symbol(COORDINATES[row], COORDINATES[row]), figures(float(there[row, 3])))
        for row in kernel.position
    ]
    return [
        paragraph("There the tool is at {}. With", Listing(tuple(at))),
        display(
            equal(E, _column(off)),
            equal(HAT_J, _matrix(J)),
            equal(Symbol(r"\lambda", "λ"), figures(damping)),
        ),
        paragraph(f"the first step is, in {_unit(kernel)},"),
        display(equal(STEP, _column(step))),
    ]


def _nearest(kernel: NumericalKernel, found: _Seeded) -> list[Block]:
    """That no motion which leaves the tool where it is ends nearer to the seed."""
    q = found.example.rows[0]
    J, off = _rows(kernel, q), _difference(kernel, q, found.seed)
    factors = np.linalg.solve(J @ J.T, J @ off)
    return [
        paragraph(
            "No solution beside it is nearer to the seed: the difference from the seed is a "
            f"combination of the rows of {{}} there, in {_unit(kernel)}, and so at right angles to "
            "every motion that leaves the tool where it is:",
            HAT_J,
        ),
        display(
            equal(HAT_J, _matrix(J)),
            equal(
                subtract(Symbol("q", "q"), SEED), _column(off), times(TRANSPOSED, _column(factors))
            ),
        ),
    ]


def _unit(kernel: NumericalKernel) -> str:
    return "radians" if all(kernel.turns) else "radians and arm sizes"


def _where_columns_are_parallel(story: Story) -> Formula | None:
    """Two coordinates of a plane: where the columns of their rows are parallel to the last one.

    They are so with their differences, one link's own velocity each. Seen from a frame that turns
    in the plane the equations are shortest.
    """
    algebra, chain = story.algebra, story.algebra.chain
    planar = chain.task.position_rows == (0, 1) and chain.task.directions is Directions.NONE
    if not planar or chain.given or chain.passive or chain.base != identity(chain.ring):
        return None
    frames = range(chain.dof + 1)
    found = [each for frame in frames if (each := _parallel_columns(story, frame))]
    if not found:
        return None
    conditions = min(found, key=lambda each: sum(map(len, each)))
    return equal(*(unsigned(story, without_lengths(algebra, each)) for each in conditions), ZERO)


def _parallel_columns(story: Story, frame: int) -> list[Polynomial]:
    """In a frame; nothing where it leaves the plane, or the last column may vanish."""
    algebra = story.algebra
    links = [element for link in algebra.chain.links[:frame] for element in algebra.lifted(link)]
    level = product(links, algebra).column(2) == identity(algebra.ring).column(2)
    columns = [moved[:2] for moved, _ in view_from(story, frame).columns(story.dof + 1)]
    x, y = columns[-1]
    if not (level and are_never_zero(algebra, x, y)):
        return []
    apart = [(a - c, b - d) for (a, b), (c, d) in pairwise(columns)]
    return [form for a, b in reversed(apart) if (form := algebra.normal(a * y - b * x))]
