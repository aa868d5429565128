"""A pose to reach, as a least-squares problem in numbers near one."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from dhgen.oracle.arm import Arm, arm, arm_size
from dhgen.oracle.arm_angle import elbow_in_link, elbow_of
from dhgen.oracle.forward import forward_with_derivatives
from dhgen.robot.task import Directions

if TYPE_CHECKING:
    from collections.abc import Sequence

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.robot.robot import Robot
    from dhgen.robot.task import Task

# Solutions beyond the limits are solutions too, with a status of their own, so the starts of a
# prismatic joint are drawn from its whole surroundings, in units of the arm's size.
PRISMATIC_REACH = 1.5


@dataclass(frozen=True, slots=True)
class Problem:
    """A pose to reach; all lengths, prismatic q included, are divided by `unit_length`.

    Attributes:
        model: The robot's numbers.
        unit_length: The arm's size, or the pose's distance if that is greater [file's unit].
        entries: (12,), which of the upper three rows of T the task names.
        target: (m,), their values.
        moving: The joints to find; the others are free joints whose value is given.
        q: (n,), holds the values of the free joints.
        tables: The model as `follow` takes it.
        elbow: Where an arm angle is given: the joints before the elbow, and its place (3,).
        drives: (n, n), what the drives' values are made of, where others' have a share in them.
    """

    model: Arm
    unit_length: float
    entries: NDArray[np.bool_]
    target: FloatArray
    moving: NDArray[np.intp]
    q: FloatArray
    tables: tuple[FloatArray, FloatArray]
    elbow: tuple[Arm, FloatArray] | None = None
    drives: NDArray[np.floating] | None = None

    @property
    def units(self) -> FloatArray:
        """(n,), what one of each joint is in the file's unit or in radians."""
        return np.where(self.model.revolute, 1.0, self.unit_length)

    def numbers_of(self, q: FloatArray) -> FloatArray:
        """What `residual` takes for the drives' values q (n,) [rad or the file's unit]."""
        joints = q if self.drives is None else np.linalg.solve(self.drives, q)
        return np.asarray(joints / self.units)

    def starts(self, count: int, random: np.random.Generator) -> FloatArray:
        """Random joint vectors, (count, n)."""
        reach = np.where(self.model.revolute, np.pi, PRISMATIC_REACH)[self.moving]
        q = np.tile(self.q, (count, 1))
        q[:, self.moving] = random.uniform(-reach, reach, (count, len(reach)))
        return q

    def residual(self, q: FloatArray) -> tuple[FloatArray, FloatArray]:
        """The task's error (N, m) and its Jacobian (N, m, moving joints) at q (N, n)."""
        T, dT = forward_with_derivatives(self.model, q)
        error = T[:, :3].reshape(len(q), 12)[:, self.entries] - self.target
        rows = dT[:, self.moving, :3].reshape(len(q), len(self.moving), 12)
        J = np.swapaxes(rows[..., self.entries], 1, 2)
        if self.elbow is None:
            return error, J
        upper, place = self.elbow
        count = len(upper.before)
        E, dE = forward_with_derivatives(upper, q[:, :count])
        rates = np.zeros((len(q), 3, q.shape[1]))
        rates[..., :count] = np.swapaxes(dE[..., :3, 3], 1, 2)
        missed = E[:, :3, 3] - place
        return np.concatenate([error, missed], axis=1), np.concatenate([J, rates], axis=1)


def state(robot: Robot, T: FloatArray, q_free: Sequence[float]) -> Problem:
    """The problem of reaching a pose T (4, 4), the free joints' values or the arm angle given."""
    model = arm(robot)
    distance = float(np.linalg.norm(T[:3, 3] - model.before[0, :3, 3]))
    unit_length = max(arm_size(robot), distance if names_position(robot.task) else 0.0)
    free = [joint - 1 for joint in robot.free]
    q = np.zeros(len(robot.joints))
    elbow = None
    one_by_one = _are_one_by_one(model, free)
    if robot.arm_angle:
        place = elbow_of(robot, T, float(q_free[0])) / unit_length
        elbow = elbow_in_link(robot).divided_by(unit_length), place
    else:
        q[free] = np.asarray(q_free, dtype=float)
    if one_by_one:
        q = model.shares @ q
    q /= np.where(model.revolute, 1.0, unit_length)
    target = T[:3].copy()
    target[:, 3] /= unit_length
    entries = task_entries(robot.task)
    moving = np.setdiff1d(np.arange(len(q)), free)
    scaled = (replace(model, shares=np.eye(len(q))) if one_by_one else model).divided_by(
        unit_length
    )
    return Problem(
        model=scaled,
        unit_length=unit_length,
        entries=entries,
        target=target.ravel()[entries],
        moving=moving,
        q=q,
        tables=_link_tables(scaled),
        drives=np.linalg.inv(model.shares) if model.is_coupled and one_by_one else None,
        elbow=elbow,
    )


def _are_one_by_one(model: Arm, free: list[int]) -> bool:
    """Whether joints are solved for, whatever drives have shares in them; else drives are.

    Passive rows are no joints, and a given drive is no given joint where others move that, too.
    """
    if model.has_passive:
        return False
    others = np.delete(model.shares[free], free, axis=1)
    return not others.any()


def _link_tables(model: Arm) -> tuple[FloatArray, FloatArray]:
    """The arm as `follow` takes it: links (n + 1, 3, 3, 4) and twists (n, 6)."""
    n = len(model.before)
    links, twists = np.zeros((n + 1, 3, 3, 4)), np.empty((n, 6))
    for joint, (before, twist) in enumerate(zip(model.before, model.twist, strict=True)):
        links[joint] = np.stack([before, before @ twist, before @ twist @ twist])[:, :3]
        xi = before @ twist @ np.linalg.inv(before)
        twists[joint] = xi[2, 1], xi[0, 2], xi[1, 0], *xi[:3, 3]
    links[n, 0] = model.end[:3]
    return links, twists


def task_entries(task: Task) -> NDArray[np.bool_]:
    """Which of the upper three rows of T a task names, row by row: shape (12,)."""
    entries = np.zeros((3, 4), dtype=bool)
    entries[list(task.position_rows), 3] = True
    match task.directions:
        case Directions.ROTATION:
            entries[:, :3] = True
        case Directions.POINTING:
            entries[:, 2] = True
        case Directions.YAW:  # T is of an arm that keeps its tool's x axis level
            entries[:2, 0] = True
        case Directions.PITCH:
            entries[2, 0] = True
        case Directions.TILT:
            entries[2, :3] = True
    return entries.ravel()


def names_position(task: Task) -> bool:
    """Whether any coordinate of the tool matters."""
    return bool(task_entries(task)[3::4].any())
