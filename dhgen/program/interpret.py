"""The meaning of a program: a NumPy interpreter over many poses at once.

Every value is an array of shape (poses, 2 or 1, 2 or 1, ...), one place for each branch sign.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.program.all_joints import whole_numbers, whole_solver
from dhgen.program.completion import Completion
from dhgen.program.ir import (
    AllJoints,
    Apply,
    Guard,
    Integer,
    Joint,
    Let,
    Pose,
    Roots,
    Variable,
)
from dhgen.runtime.python.status import CLOSE, FREE_JOINT, OK, UNREACHABLE

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.program.ir import Expression, Program

    Array = NDArray[Any]


@dataclass(frozen=True, slots=True)
class Polynomial:
    """The polynomial of a program's roots, as every row has it.

    Attributes:
        coefficients: a0, a1, b1, a2, b2 as in `Roots`, (B, 5).
        root: The row's own root, (B,), NaN where there is none.
    """

    coefficients: FloatArray
    root: FloatArray


@dataclass(frozen=True, slots=True)
class Rows:
    """What a program gives for N poses and B rows.

    Attributes:
        q: Joint values, shape (N, B, n), NaN where there is no solution.
        solved: Shape (N, B).
        free: Whether some joint took the seed's value, shape (N, B).
        close: Whether none did, and roots that nearly meet or a joint that is nearly free are in
            it, shape (N, B).
    """

    q: FloatArray
    solved: NDArray[np.bool_]
    free: NDArray[np.bool_]
    close: NDArray[np.bool_]


def interpret(
    program: Program,
    poses: FloatArray,
    seed: FloatArray | None = None,
    free: FloatArray | None = None,
) -> Rows:
    """Runs a program.

    Args:
        program: What to run.
        poses: Shape (N, 4, 4).
        seed: Values for joints that are indeterminate, shape (N, n) or (n,); zeros without it.
        free: Values of the joints that the caller gives, shape (N, k) or (k,).
    """
    run = _Run(program, poses, seed, free)
    rows = run.rows()
    kernel = program.completion or program.refinement
    if kernel is None:
        return rows
    completion, q = Completion(kernel, rows.q.shape[1], program.turning), rows.q.copy()
    doubtful = rows.close | completion.may_miss(poses, q)
    for k in np.flatnonzero(doubtful.any(axis=1)):
        status = np.where(rows.close[k], CLOSE, np.where(rows.solved[k], OK, UNREACHABLE))
        given = run.given(int(k))
        completion.complete(run.solve, poses[k], given, q[k], status.astype(np.uint8))
    solved = np.asarray(~np.isnan(q).any(axis=-1))
    return replace(rows, q=q, solved=solved, free=rows.free & solved)


def outputs(
    program: Program,
    poses: FloatArray,
    seed: FloatArray | None = None,
    free: FloatArray | None = None,
) -> list[NDArray[Any]]:
    """Runs a program without guards: its outputs, each of shape (N, B). Arguments as above."""
    return _Run(program, poses, seed, free).outputs()


def polynomial(
    program: Program, pose: FloatArray, seed: FloatArray, free: FloatArray
) -> Polynomial | None:
    """The polynomial whose roots a program takes; None for programs without.

    Args:
        program: What to run.
        pose: Shape (4, 4).
        seed: Values for joints that are indeterminate, shape (n,).
        free: Values of the joints that the caller gives, shape (k,).
    """
    taken = next((each for each in program.body if isinstance(each, Roots)), None)
    return None if taken is None else _Run(program, pose[None], seed, free).polynomial(taken)


class _Run:
    def __init__(
        self,
        program: Program,
        poses: FloatArray,
        seed: FloatArray | None,
        free: FloatArray | None,
        moved: Array | None = None,
    ) -> None:
        self._program = program
        self._poses = poses
        count = len(poses)
        self._by = np.zeros(count) if moved is None else moved
        dof = len(program.outputs) if seed is None else np.shape(seed)[-1]
        given = 0 if free is None else np.shape(free)[-1]
        self._given = {
            "seed": np.broadcast_to(np.zeros(dof) if seed is None else seed, (count, dof)),
            "free": np.broadcast_to(np.zeros(0) if free is None else free, (count, given)),
        }
        self._shape = (count, *(axis.count for axis in program.axes))
        self._values: dict[str, Array] = {c.name: np.array(c.value) for c in program.constants}
        for place, axis in enumerate(program.axes):
            sign = np.array([1.0, -1.0])
            self._values[axis.name] = sign.reshape(
                [2 if p == place + 1 else 1 for p in range(len(self._shape))]
            )

    def given(self, pose: int) -> tuple[FloatArray, FloatArray]:
        """What the caller gives besides a pose, and the seed."""
        return self._given["free"][pose], self._given["seed"][pose]

    def solve(
        self,
        pose: tuple[float, ...],
        free: FloatArray,
        seed: FloatArray,
        moved: float,
        q: FloatArray,
        status: Array,
    ) -> None:
        """Fills the rows of a pose that have a solution, with all roots moved by an angle."""
        T = np.array([*pose, 0.0, 0.0, 0.0, 1.0]).reshape(1, 4, 4)
        rows = _Run(self._program, T, seed, free, np.array([moved])).rows()
        q[rows.solved[0]] = rows.q[0, rows.solved[0]]
        status[rows.solved[0]] = OK

    def outputs(self) -> list[Array]:
        with np.errstate(all="ignore"):
            for statement in self._program.body:
                if isinstance(statement, Let):
                    self._values[statement.name] = self._value(statement.expression)
            return [self._flat(self._value(output)) for output in self._program.outputs]

    def rows(self) -> Rows:
        alive = np.ones(self._shape, dtype=bool)
        close = np.zeros(self._shape, dtype=bool)
        with np.errstate(all="ignore"):
            for statement in self._program.body:
                if isinstance(statement, Let):
                    self._values[statement.name] = self._value(statement.expression)
                elif isinstance(statement, Roots):
                    found, near = self._roots(statement)
                    self._values[self._program.axes[statement.axis].name] = found
                    close = close | near
                elif isinstance(statement, AllJoints):
                    self._values |= self._all_joints(statement)
                elif isinstance(statement, Guard):
                    alive &= self._value(statement.condition)
            joints = [self._flat(self._value(output)) for output in self._program.outputs]
        chosen = np.zeros(self._shape, dtype=bool)
        for _, name in self._program.free:
            chosen |= self._values[name]
        if self._program.turning:
            for name in self._program.near:
                close = close | self._values[name]
        solved = self._flat(alive)
        q = np.stack(joints, axis=-1)
        q[~solved] = np.nan
        free = self._flat(chosen) & solved
        return Rows(q, solved, free, np.asarray(self._flat(close) & solved & ~free))

    def polynomial(self, taken: Roots) -> Polynomial:
        self.rows()
        root = self._values[self._program.axes[taken.axis].name]
        values = [self._flat(self._value(each))[0] for each in taken.coefficients[:5]]
        return Polynomial(np.stack(values, axis=-1), self._flat(root)[0])

    def _roots(self, statement: Roots) -> tuple[Array, Array]:
        """The roots along their axis, for all poses and all values of earlier axes; which meet."""
        from dhgen.program.circle import roots_of  # noqa: PLC0415  takes time

        values = np.broadcast_arrays(*(self._value(each) for each in statement.coefficients))
        shape = [*values[0].shape]
        if len(shape) < len(self._shape):  # constant coefficients
            shape = [1] * len(self._shape)
        flat = np.stack([value.reshape(-1) for value in values], axis=-1)
        each, places = np.unique(flat, axis=0, return_inverse=True)
        found, close = roots_of(each)

        def along_axis(numbers: Array) -> Array:
            whole = numbers[places.reshape(-1)].reshape(*shape, -1)
            return np.moveaxis(whole, -1, statement.axis + 1).squeeze(statement.axis + 2)

        return along_axis(found) + self._column(self._by), along_axis(close)

    def _all_joints(self, statement: AllJoints) -> dict[str, Array]:
        """All joints of all solutions along the only axis, by the runtime."""
        solve, arm = whole_solver(statement), whole_numbers(statement)
        values = np.full((*self._shape, len(statement.names)), np.nan)
        found, chosen = np.zeros(self._shape, dtype=bool), np.zeros(self._shape, dtype=bool)
        for k, pose in enumerate(self._poses):
            entries = tuple(map(float, pose[:3].ravel()))
            seed, free = self._given["seed"][k].copy(), self._given["free"][k].copy()
            values[k], status = solve(arm, entries, free, seed)
            found[k], chosen[k] = status != UNREACHABLE, status == FREE_JOINT
        places = {name: values[..., place] for place, name in enumerate(statement.names)}
        return places | {statement.found: found, statement.chosen: chosen}

    def _flat(self, value: Array) -> Array:
        return np.broadcast_to(value, self._shape).reshape(self._shape[0], -1).copy()

    def _column(self, values: Array) -> Array:
        return values.reshape(-1, *(1 for _ in self._program.axes))

    def _value(self, expression: Expression) -> Array:
        match expression:
            case Variable(name):
                return self._values[name]
            case Integer(value):
                return np.array(float(value))
            case Pose(row, column):
                return self._column(self._poses[:, row - 1, column - 1])
            case Joint(number, role):
                return self._column(self._given[role][:, number - 1])
            case Apply(operator, operands):
                return _OPERATORS[operator](*(self._value(operand) for operand in operands))


def wrap(angle: Array) -> Array:
    """The angle moved by whole turns to (-pi, pi]."""
    return angle - 2.0 * np.pi * np.ceil(angle / (2.0 * np.pi) - 0.5)


_OPERATORS: dict[str, Callable[..., Array]] = {
    "add": np.add,
    "sub": np.subtract,
    "mul": np.multiply,
    "div": np.divide,
    "neg": np.negative,
    "abs": np.abs,
    "sqrt": np.sqrt,
    "atan2": np.arctan2,
    "copysign": np.copysign,
    "sin": np.sin,
    "cos": np.cos,
    "wrap": wrap,
    "select": np.where,
    "less": np.less,
    "at_most": np.less_equal,
    "and": np.logical_and,
    "or": np.logical_or,
    "not": np.logical_not,
    "maximum": np.maximum,
}
