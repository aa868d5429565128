"""What a program's rows do on poses where they are tried, and what is to be done about it.

A derivation may satisfy its equations without meeting the whole pose, or only inaccurately, for
instance at right angles; the program is run on sample poses to find out.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.algebra import POSE_PLACES
from dhgen.kinematics.given import given_values
from dhgen.kinematics.numeric import numeric_arm
from dhgen.kinematics.task import task_entries, units
from dhgen.paul.degeneracy import degenerate_places, indeterminate_places
from dhgen.paul.kind import Kind
from dhgen.paul.types.lengths import determinant
from dhgen.program.interpret import interpret
from dhgen.program.ir import Roots
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain
    from dhgen.paul.derivation import Derivation
    from dhgen.program.interpret import Rows
    from dhgen.program.ir import Program
    from dhgen.tolerances import Tolerances


TRIED = 50  # poses of each sort
OTHER = 0.7  # from a pose's joint values to those of another seed, at least [rad or arm sizes]
SLIGHT = 1e-2  # less is the cosine or the sine of a twist that is nearly a right angle, or none
BESIDE = tuple(10.0**power for power in range(-13, -2))  # of right angles [rad or arm sizes]
APART = (1e-6, 1e-8, 1e-10)  # the same where each joint is as near as it likes


@dataclass(frozen=True, slots=True)
class Checks:
    """What is done about rows that do not reproduce their pose.

    Attributes:
        rows: Every row is compared with the pose.
        moved: They are in the frame from where that takes the fewest operations, not in the base.
        again: A row that fails this may pass by another value of a free joint.
        completes: A row that is not exact is refined, by some steps of damped least squares.
        refines: Rows that miss the pose by more than is promised are refined, where rows are not
            compared and not every inexact one is. A branch that follows an earlier root may come
            out just beyond its reach.
    """

    rows: bool
    moved: bool = False
    again: bool = False
    completes: bool = False
    refines: bool = False


def checks_needed(
    derivation: Derivation, tolerances: Tolerances, lowered: Callable[[Checks], Program]
) -> Checks:
    """No more than the arm needs.

    Args:
        derivation: What is to be computed.
        tolerances: Of the arithmetic that the program is for.
        lowered: The program with given checks.
    """
    chain = derivation.problem.algebra.chain
    degenerate = degenerate_places(derivation.pool, derivation.steps)
    q = np.concatenate([_everywhere(chain), degenerate])
    checks = Checks(rows=derivation.problem.overdetermined)
    program = lowered(checks)
    if not checks.rows and _has_strangers(chain, program, q):
        checks = Checks(rows=True)
        program = lowered(checks)
    if checks.rows and _follows_the_seed(chain, program, q):
        checks = replace(checks, again=True)
        program = lowered(checks)
    refined = _with_nested_refined(chain, checks, lowered)
    if not tolerances.is_finer_than_poses:
        return refined  # exact rows can't be recognized
    enough = TOLERANCES.exact if checks.rows else TOLERANCES.promised
    # by what an over-determined arm leaves aside rows may miss their poses beside any such place
    about = indeterminate_places(derivation.pool, derivation.steps) if checks.rows else degenerate
    q = np.concatenate([q, _beside(chain, about)])
    is_inexact = (
        _may_be_inexact(derivation, program, checks)
        or _is_inexact(chain, program, q, enough)
        or _loses_poses(chain, lowered(refined), q)
    )
    return replace(checks, completes=True) if is_inexact else refined


def _with_nested_refined(
    chain: Chain, checks: Checks, lowered: Callable[[Checks], Program]
) -> Checks:
    """The checks, with rows of nested roots refined to solutions, where there are any.

    Rows are refined, too, where a twist is almost a right angle: it barely fixes what a right angle
    would leave free. They are not where the caller gives an arm angle, which has to be met as well.
    """
    if checks.rows or chain.arm_angle or not any(chain.turning):
        return checks
    refined = replace(checks, refines=True)
    slight = any(not c.is_length and 0.0 < abs(c.value) < SLIGHT for c in chain.constants)
    return refined if slight or lowered(refined) != lowered(checks) else checks


def _may_be_inexact(derivation: Derivation, program: Program, checks: Checks) -> bool:
    """Whether there are poses of few digits that the tried ones don't show.

    Roots that nearly meet are good to few digits, and so is what a slide from its square points to
    where it is drawn in, and so are slides that nearly move in one plane. Where not every value of
    a free joint works, a value next to the ones that do nearly does.
    """
    rooted = any(isinstance(statement, Roots) for statement in program.body)
    drawn_in = any(step.kind is Kind.SQUARED_LENGTH for step in derivation.steps)
    algebra = derivation.problem.algebra
    coupled = any(
        step.kind is Kind.TWO_LENGTHS and not algebra.is_constant(determinant(step, algebra))
        for step in derivation.steps
    )
    return rooted or drawn_in or coupled or checks.again


def _everywhere(chain: Chain) -> FloatArray:
    """Joint vectors anywhere, at right angles, and half of each."""
    source = np.random.default_rng(17)
    anywhere = source.uniform(-2.5, 2.5, (TRIED, chain.dof))
    right = source.integers(-1, 3, anywhere.shape) * (np.pi / 2)
    mixed = np.where(source.random(anywhere.shape) < 0.5, right, anywhere)
    return np.concatenate([anywhere, right, mixed]) * units(chain)


def _beside(chain: Chain, places: FloatArray) -> FloatArray:
    """Joint vectors beside right angles: all joints as near as each other; and about half of them.

    These each as near as they like, and the others anywhere. And some beside given places.
    """
    source = np.random.default_rng(18)
    shape = len(BESIDE), TRIED, chain.dof
    unit = units(chain)
    right = source.integers(-1, 3, shape) * (np.pi / 2)
    near = np.array(BESIDE)[:, None, None] * source.uniform(-1.0, 1.0, shape)
    own = source.choice(APART, shape) * source.choice((-1.0, 1.0), shape)
    mixed = np.where(source.random(shape) < 0.5, right + own, source.uniform(-2.5, 2.5, shape))
    aside = np.array(BESIDE)[:, None, None] * source.uniform(-1.0, 1.0, places.shape)
    found = [(right + near) * unit, mixed * unit, places + aside * unit]
    return np.concatenate([each.reshape(-1, chain.dof) for each in found])


def _follows_the_seed(chain: Chain, program: Program, q: FloatArray) -> bool:
    """Whether rows are lost by another seed than the joint values that made the pose.

    A joint was free there, and not every value of it makes the arm take the pose. Each joint of the
    other seed is as far off as no other is: differences of joint values are others, too.
    """
    arm = numeric_arm(chain)
    poses, given = arm.pose(q), given_values(arm, q)
    off = OTHER * np.linspace(1.0, 2.0, chain.dof) * units(chain)
    own, other = (interpret(program, poses, seed, given) for seed in (q, q + off))
    return bool(np.any(own.solved & ~other.solved))


def _has_strangers(chain: Chain, program: Program, q: FloatArray) -> bool:
    """Whether rows come out that do not reproduce their pose.

    Equations may leave a part of the task unsaid, be it only at right angles; then every row has to
    be checked.
    """
    rows, misses = _misses(chain, program, q, q)
    return bool(np.any(misses[rows.solved] > TOLERANCES.consistent))


def _is_inexact(chain: Chain, program: Program, q: FloatArray, enough: float) -> bool:
    """Whether rows that pass for solutions miss by more."""
    found = (_misses(chain, program, q, seed) for seed in (q, np.zeros_like(q)))
    return any(bool(np.any(misses[rows.solved] > enough)) for rows, misses in found)


def _loses_poses(chain: Chain, program: Program, q: FloatArray) -> bool:
    """Whether poses are left without a row, with the joint values as the seed.

    Nothing is refined: that takes long, and keeps rows that meet their pose.
    """
    rows, misses = _misses(chain, replace(program, completion=None, refinement=None), q, q)
    left = q[~(rows.solved & (misses <= TOLERANCES.exact)).any(axis=1)]
    if not len(left):
        return False
    arm = numeric_arm(chain)
    rows = interpret(program, arm.pose(left), left, given_values(arm, left))
    return not bool(rows.solved.any(axis=1).all())


def _misses(
    chain: Chain, program: Program, q: FloatArray, seed: FloatArray
) -> tuple[Rows, FloatArray]:
    """The rows for the poses of joint vectors, and by how much each misses its pose."""
    arm = numeric_arm(chain)
    poses = arm.pose(q)
    rows = interpret(program, poses, seed, given_values(arm, q))
    reached = arm.pose(np.where(rows.solved[..., None], rows.q, 0.0))
    miss = np.abs(reached - poses[:, None])
    miss[..., :3, 3] /= chain.size
    named = [POSE_PLACES[name] for name in task_entries(chain.task)]
    return rows, np.max([miss[..., i, j] for i, j in named], axis=0)
