"""Whether an arm can be solved at all: does every joint matter, everywhere, for the task?

At a general position the Jacobian of the task has one column for each joint that is solved for.
When their rank is less than their number, joints can be moved against each other without moving
the tool: the arm is redundant for its task, or degenerate (collinear axes, all axes parallel or
concurrent).
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import combinations, pairwise
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.neighbours import EXACT, axis_triples, short_number
from dhgen.kinematics.numeric import numeric_arm
from dhgen.kinematics.task import task_jacobian, units
from dhgen.robot.robot import JointKind
from dhgen.robot.task import Task, TaskKind

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.kinematics.chain import Chain


POSITIONS = 3
NULL = 1e-9  # a singular value, or a joint's part in a null vector, this small is zero
NEARLY_NULL = 1e-4  # this is more than twists leave that were meant to be right angles
SAME_LINE = 1e-9
ROUNDING = 1e-14  # of the arm's size: what places of axes are computed to
PLAIN_TASKS = (
    TaskKind.DIRECTION,
    TaskKind.POSITION,
    TaskKind.ORIENTATION,
    TaskKind.POINTING,
    TaskKind.POSE,
)


@dataclass(frozen=True, slots=True)
class Surplus:
    """The joints that a task does not fix.

    Attributes:
        count: How many joints more there are than the task fixes, everywhere.
        joints: Those that can be moved against each other, from 1.
    """

    count: int
    joints: tuple[int, ...]


def surplus(chain: Chain, nothing: float = NULL) -> Surplus:
    """What the task leaves open at every pose, the free joints or the arm angle held.

    Args:
        chain: The arm.
        nothing: A singular value is zero if it is this part of the largest one.
    """
    source = np.random.default_rng(3)
    arm = numeric_arm(chain)
    solved = [joint.number for joint in chain.solved]
    moving = np.ones(len(solved), dtype=bool)
    count = len(solved)
    for _ in range(POSITIONS if solved else 0):
        jacobian = task_jacobian(arm, source.uniform(-2.0, 2.0, chain.dof) * units(chain))
        columns = jacobian[:, [number - 1 for number in solved]]
        _, values, rows = np.linalg.svd(columns)
        rank = int(np.sum(values > nothing * max(values.max(), NULL)))
        count = min(count, len(solved) - rank)
        null = rows[rank:]
        moving &= np.abs(null).max(axis=0, initial=0.0) > nothing**0.5
    return Surplus(
        max(count - chain.arm_angle, 0),
        tuple(j for j, moves in zip(solved, moving, strict=True) if moves),
    )


def open_from_the_start(chain: Chain, spare: Surplus) -> tuple[Chain, Surplus]:
    """The arm from which free joints are to be chosen, and what its task leaves open.

    Those that the file names are kept, if each of them leaves one joint less open. Otherwise one
    is in the way: its value is among what the task fixes.
    """
    bare = replace(chain, free=())
    whole = surplus(bare)
    works = whole.count == spare.count + len(chain.free)
    return (chain, spare) if works else (bare, whole)


def still_coordinates(chain: Chain) -> tuple[str, ...]:
    """The coordinates x, y, z that the task names and no joint moves, if others of them move."""
    listed = chain.task.kind in {TaskKind.LIST, TaskKind.POSITION}
    named = ["xyz"[row] for row in chain.task.position_rows] if listed else []
    moves = moving_coordinates(chain)
    still = tuple(name for name in named if name not in moves)
    return () if len(still) == len(named) else still


def moving_coordinates(chain: Chain) -> tuple[str, ...]:
    """The coordinates x, y, z of the tool that some joint moves."""
    q = np.random.default_rng(3).uniform(-2.0, 2.0, (POSITIONS, chain.dof)) * units(chain)
    rates = numeric_arm(chain).jacobian(q)[..., :3, :] * units(chain)
    most = np.abs(rates).max(axis=(0, 2))
    return tuple(n for n, rate in zip("xyz", most, strict=True) if rate > NULL * chain.size)


def _keeps_level(chain: Chain) -> bool:
    """Whether the tool's x axis is level wherever the arm is."""
    q = np.random.default_rng(5).uniform(-2.0, 2.0, (POSITIONS, chain.dof)) * units(chain)
    return bool(np.abs(numeric_arm(chain).pose(q)[..., 2, 0]).max() < EXACT)


def _pitch_is_a_sum(chain: Chain) -> bool:
    """Whether the pitch is a sum of joint angles: axes that are parallel and level tilt the tool.

    Any four joints have a pitch, of which few arms get a closed form; that of an arm in an upright
    plane is as good as a joint's angle.
    """
    q = np.random.default_rng(5).uniform(-2.0, 2.0, (POSITIONS, chain.dof)) * units(chain)
    arm = numeric_arm(chain)
    most = np.linalg.norm(arm.pose(q)[..., :2, 0], axis=-1)[..., None]  # the cosine of the pitch
    rates = np.abs(task_jacobian(arm, q, Task(TaskKind.LIST, (), ("pitch",)))[..., 0, :])
    return bool(rates.max() > EXACT and np.minimum(rates, np.abs(rates - most)).max() < EXACT)


def determining_tasks(chain: Chain) -> dict[str, Task]:
    """Other tasks that fix every joint, as the file writes them; the least demanding first."""
    return {
        task.text: task
        for task in _tasks(chain)
        if task != chain.task
        and task.dimension >= chain.dof - chain.given
        and not surplus(replace(chain, task=task)).count
    }


def tasks_of_what_moves(chain: Chain, spare: Surplus) -> list[Task]:
    """Tasks of an arm with spare joints that need all that its joints can choose, no more."""
    return [
        task
        for task in _tasks(chain)
        if task.dimension == chain.dof - chain.given - spare.count
        and surplus(replace(chain, task=task)).count == spare.count
    ]


def _tasks(chain: Chain) -> list[Task]:
    """Tasks that make sense for an arm, the least demanding first."""
    moving = moving_coordinates(chain)
    tasks = [Task(kind) for kind in PLAIN_TASKS]
    if len(moving) < 3:
        tasks.insert(0, Task(TaskKind.LIST, moving))
    if _keeps_level(chain):
        tasks.append(Task(TaskKind.LIST, moving, ("yaw",)))
    elif _pitch_is_a_sum(chain):
        tasks.append(Task(TaskKind.LIST, moving, ("pitch",)))
    return sorted(tasks, key=lambda task: task.dimension)


def crowded_axes(chain: Chain) -> list[str]:
    """Axes of neighbours that leave a joint too many: one line, or four parallel or concurrent.

    Three joints already do whatever turns about parallel axes do, or about one point.
    """
    parallel, same = list(_apart(chain)), axes_on_one_line(chain)
    meeting = [t.joints for t in axis_triples(chain) if t.miss < EXACT * chain.size]
    lines = _runs(list(same))
    return [
        *(_one_line(run, max(same[pair] for pair in pairwise(run))) for run in lines),
        *(
            f"axes {_listed(run)} are parallel"
            for run in _runs(parallel)
            if len(run) > 3 and run not in lines
        ),
        *(f"axes {_listed(run)} meet in one point" for run in _runs(meeting) if len(run) > 3),
        *_crowded_slides(chain),
    ]


def _crowded_slides(chain: Chain) -> list[str]:
    """Slides without a turn between them, of which one goes where the others go: the smallest sets.

    Two along one direction, or three in one plane.
    """
    directions, _ = numeric_arm(chain).axes(np.zeros(chain.dof))
    slides = [j.number for j in chain.solved if j.kind is not JointKind.REVOLUTE]
    for count, where in ((2, "along one direction"), (3, "in one plane")):
        found = [
            group
            for group in combinations(slides, count)
            if not any(chain.turning[group[0] - 1 : group[-1]])
            and np.linalg.svd(directions[[n - 1 for n in group]])[1].min() < SAME_LINE
        ]
        if found:
            return [f"joints {_listed(group)} slide {where}" for group in found]
    return []


def _apart(chain: Chain) -> dict[tuple[int, int], float]:
    """The pairs of neighbours whose axes are parallel, and how far these are apart.

    Slides between them turn no axis, but move it aside.
    """
    directions, points = numeric_arm(chain).axes(np.zeros(chain.dof))
    turning = [j.number for j in chain.solved if j.kind is JointKind.REVOLUTE]
    apart: dict[tuple[int, int], float] = {}
    for pair in pairwise(turning):
        first, second = (number - 1 for number in pair)
        z, between = directions[first], points[second] - points[first]
        if np.linalg.norm(np.cross(z, directions[second])) < SAME_LINE:
            apart[pair] = float(np.linalg.norm(np.cross(z, between)))
    return apart


def axes_on_one_line(chain: Chain) -> dict[tuple[int, int], float]:
    """The pairs of neighbours whose axes count as one line, and how far these are apart."""
    return {
        pair: apart if apart > ROUNDING * chain.size else 0.0
        for pair, apart in _apart(chain).items()
        if pair[1] == pair[0] + 1 and apart < SAME_LINE * chain.size
    }


def _one_line(run: tuple[int, ...], apart: float) -> str:
    if not apart:
        return f"axes {_listed(run)} are the same line"
    far = short_number(apart, 3)
    return f"axes {_listed(run)} are {far} apart, which at the arm's size counts as one line"


def _runs(groups: Sequence[tuple[int, ...]]) -> list[tuple[int, ...]]:
    """Groups that share all but their ends, joined."""
    runs: list[tuple[int, ...]] = []
    for group in groups:
        if runs and runs[-1][1 - len(group) :] == group[:-1]:
            runs[-1] = (*runs[-1], group[-1])
        else:
            runs.append(group)
    return runs


def _listed(run: tuple[int, ...]) -> str:
    *first, last = map(str, run)
    return f"{', '.join(first)} and {last}"
