# SPDX-License-Identifier: MIT
"""Inverse kinematics with derivatives, for PyTorch and JAX.

Part of dhgen, which puts a copy of this file beside the robots that it generates.

    import dhgen_grad, scara
    ik = dhgen_grad.torch_ik(scara)  # or jax_ik, which jit and vmap take, too
    q, status = ik(T)  # T: (..., 4, 4); q: (..., rows, joints), as ik_batch of the module
    torch.where(status[..., None] == 0, q, 0.0).square().sum().backward()

Rows and statuses are those of `ik_batch`. A row's derivative is that of its solution: the joint
velocities with which the tool follows.

- A change of T is taken as the motion of a rigid body: the tool's origin moves as T[:3, 3] does,
  and its angular velocity is the w with w x R nearest to the change of R = T[:3, :3]. The rest of
  the change, which stretches or shears R, or is in the last row, changes no row, and gradients are
  zero along it. Where the task names a part of the rotation, only the change of that part matters.
- Arms of fewer joints, and redundant ones without values that the caller gives: least squares, and
  of these the least, lengths in arm sizes, as `joint_velocities` of the module.
- What the caller gives (`q_free`: values of joints, or the arm angle) has derivatives, too, and
  those of T are at fixed values of it.
- Near singular poses what the arm hardly can do is damped as in `joint_velocities`: joints move at
  most a hundred times as fast as the tool, lengths in arm sizes. There the solution itself has no
  derivative, or a greater one. This includes rows whose status is FREE_JOINT.
- Rows without a solution are NaN and have derivatives of zero, whatever comes back for them.

Derivatives are of the first order. PyTorch's functions have backward(), no forward mode; JAX's have
both. What lives on the CPU is solved by
the module that is given, which may be one of `dhgen_native`. Tensors on a GPU are solved there by
`dhgen_cuda`, and so are JAX's arrays; inside jit these come to the CPU and go back. The derivative
of the arm angle is found by differences, to nine digits, and on the CPU alone.
"""

from __future__ import annotations

import importlib
import math
from dataclasses import dataclass
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable
    from types import ModuleType

Array: TypeAlias = Any  # of NumPy, PyTorch or JAX
STEP = 1e-5  # of differences of the arm angle [rad]: they are right to its square
OK, FREE_JOINT, OUT_OF_LIMITS = 0, 2, 3  # statuses of rows that hold joint values


def torch_ik(robot: ModuleType) -> Callable[..., tuple[Array, Array]]:
    """A robot's inverse kinematics as a differentiable function of PyTorch's tensors.

    Args:
        robot: The robot's Python, or that of `dhgen_native`.

    Returns:
        A function of T (..., 4, 4), float64 or float32, and of what the caller gives besides
        (..., how many). Its results are q (..., rows, joints) in the type of T, and status (...,
        rows), bytes that have no gradient. It raises TypeError where arrays are neither float64 nor
        float32, or more or fewer than the arm takes, and ValueError where their shapes are wrong.

    Raises:
        TypeError: The argument is not a serial arm's module, or its table comes at run time.
    """
    torch: Any = importlib.import_module("torch")
    arm = Arm(robot)

    class Rows(torch.autograd.Function):  # type: ignore[misc]
        """All rows, and gradients by them."""

        @staticmethod
        def forward(ctx: Any, *given: Array) -> tuple[Array, Array]:  # noqa: ANN401
            T = arm.checked(*given)
            plain = [each.detach() for each in given]
            if on_gpu(T):
                q, status = arm.solve(arm.on_gpu, *(each.contiguous() for each in plain))
            else:
                found = arm.solve(robot, *map(np.from_dlpack, plain))
                q, status = map(torch.from_dlpack, found)
            ctx.save_for_backward(*given, q, status)
            return q.to(T.dtype), status

        @staticmethod
        @torch.autograd.function.once_differentiable  # type: ignore[untyped-decorator]
        def backward(ctx: Any, gradient: Array, _: Array) -> tuple[Array, ...]:  # noqa: ANN401
            *given, q, status = (each.detach() for each in ctx.saved_tensors)
            if on_gpu(q):
                space = Space(torch, torch.float64, q.device)
                found = arm.derivatives(space, arm.on_gpu, *given, q, status)
            else:
                values = map(np.from_dlpack, (*given, q, status))
                found = [*map(torch.from_dlpack, arm.derivatives(Space(np), robot, *values))]
            by_pose, *by_given = found
            wanted = torch.where(solved(status), gradient.to(by_pose.dtype), 0.0)
            T = torch.zeros_like(given[0], dtype=by_pose.dtype)
            T[..., :3, :] = torch.einsum("...rj,...rjab->...ab", wanted, by_pose)
            results = [T, *(torch.einsum("...rj,...rjg->...g", wanted, each) for each in by_given)]
            return tuple(each.to(like.dtype) for each, like in zip(results, given, strict=True))

    differentiable: Callable[..., tuple[Array, Array]] = Rows.apply
    return differentiable


def jax_ik(robot: ModuleType) -> Callable[..., tuple[Array, Array]]:
    """A robot's inverse kinematics as a differentiable function of JAX's arrays.

    Args:
        robot: The robot's Python, or that of `dhgen_native`.

    Returns:
        A function of T (..., 4, 4), and of what the caller gives besides (..., how many), for jit,
        vmap, jvp and grad. Its results are q (..., rows, joints) in the type of T, and status
        (..., rows), bytes. Derivatives have the digits of T's type: float64 wants jax_enable_x64.
        It raises TypeError where arrays are neither float64 nor float32, or more or fewer than the
        arm takes, and ValueError where their shapes are wrong.

    Raises:
        TypeError: The argument is not a serial arm's module, or its table comes at run time.
    """
    jax: Any = importlib.import_module("jax")
    arm = Arm(robot)

    @jax.custom_jvp  # type: ignore[untyped-decorator]
    def rows(T: Array, *q_free: Array) -> tuple[Array, Array]:
        arm.checked(T, *q_free)
        if on_gpu(T):
            q, status = arm.solve(arm.on_gpu, T, *q_free)
            return q, status
        many = (*T.shape[:-2], arm.rows)
        shapes, numbers = ((*many, arm.dof), many), (T.dtype, np.uint8)
        q, status = called(partial(arm.solve, robot), shapes, numbers, T, *q_free)
        return q, status

    @rows.defjvp  # type: ignore[untyped-decorator]
    def _forwards(given: tuple[Array, ...], changes: tuple[Array, ...]) -> Any:  # noqa: ANN401
        q, status = rows(*given)
        arrays = (*given, q, status)
        if on_gpu(given[0]):
            space = Space(jax.numpy, q.dtype, q.device)
            by_pose, *by_given = arm.derivatives(space, arm.on_gpu, *arrays)
        else:
            shapes = ((*q.shape, 3, 4), (*q.shape, arm.given))[: len(given)]
            function = partial(arm.derivatives, Space(np), robot)
            by_pose, *by_given = called(function, shapes, (q.dtype,) * len(given), *arrays)
        einsum = jax.numpy.einsum
        change = einsum("...rjab,...ab->...rj", by_pose, changes[0][..., :3, :])
        for by, value in zip(by_given, changes[1:], strict=True):
            change += einsum("...rjg,...g->...rj", by, value)
        # backwards: what comes back for rows without a solution may be NaN
        change = jax.numpy.where(solved(status), change, 0.0).astype(q.dtype)
        return (q, status), (change, np.zeros(status.shape, jax.dtypes.float0))

    def ik(T: Array, *q_free: Array) -> tuple[Array, Array]:
        found: tuple[Array, Array] = rows(*map(jax.numpy.asarray, (T, *q_free)))
        return found

    return ik


def called(
    function: Callable[..., Iterable[Array]],
    shapes: tuple[tuple[int, ...], ...],
    numbers: tuple[Any, ...],
    *arrays: Array,
) -> Any:  # noqa: ANN401
    """What a function of NumPy's arrays returns for JAX's, in jit, too.

    Args:
        function: It returns a few arrays.
        shapes: Theirs.
        numbers: The types of their numbers.
        arrays: What it takes.
    """
    jax: Any = importlib.import_module("jax")

    def call(*values: Array) -> tuple[Array, ...]:
        found = zip(function(*map(np.asarray, values)), numbers, strict=True)
        return tuple(np.asarray(each, number) for each, number in found)

    results = tuple(map(jax.ShapeDtypeStruct, shapes, numbers))
    return jax.pure_callback(call, results, *arrays, vmap_method="broadcast_all")


def on_gpu(array: Array) -> bool:
    """Whether an array lives on a GPU, and is one, not what jit takes for it."""
    if hasattr(array, "is_cuda"):
        return bool(array.is_cuda)
    traced = isinstance(array, importlib.import_module("jax").core.Tracer)
    return not traced and any(each.platform == "gpu" for each in array.devices())


def solved(status: Array) -> Array:
    """Whether rows hold joint values, (..., 1)."""
    return ((status == OK) | (status == FREE_JOINT) | (status == OUT_OF_LIMITS))[..., None]


@dataclass(frozen=True, slots=True)
class Space:
    """A library that calculates, and where."""

    xp: Any  # what NumPy, PyTorch and JAX have alike
    number: Any = np.float64
    device: Any = None

    def array(self, values: Array) -> Array:
        """Values as the library's."""
        where = {} if self.xp is np else {"device": self.device}
        return self.xp.asarray(values, dtype=self.number, **where)


class Arm:
    """What derivatives need of a robot.

    Attributes:
        dof: How many joints.
        rows: How many rows a pose has.
        given: How many values the caller gives.
    """

    def __init__(self, robot: ModuleType) -> None:
        if hasattr(robot, "calibrated"):
            problem = f"derivatives are of one arm: the table of {robot.NAME} comes at run time"
            raise TypeError(
                f"{problem}; dhgen calibrate writes its robot file, whose module has them"
            )
        if not hasattr(robot, "_ARM"):
            wanted = "a serial arm's module, as in 'import scara; dhgen_grad.torch_ik(scara)'"
            raise TypeError(f"{wanted} is what has derivatives here, not {robot!r}")
        names = vars(robot)
        numbers, places = names["_ARM"], names["_runtime"]("places")
        # a singular value of the Jacobian, lengths in arm sizes
        self._damped_below = names["_runtime"]("velocities").DAMPED_BELOW
        self.robot, self.dof, self.rows = robot, robot.DOF, robot.MAX_SOLUTIONS
        self._free = tuple(joint - 1 for joint in names.get("FREE_JOINTS", ()))
        self._angle: Callable[[Array], Array] | None = names.get("arm_angle")
        self.given = 1 if self._angle else len(self._free)
        counted = (places.POINTING, places.YAW, places.PITCH, places.TILT)
        rates = dict(zip(counted, (_of_pointing, _of_yaw, _of_pitch, _of_tilt), strict=True))
        self._rates = rates.get(numbers[places.DIRECTIONS])
        self._misses = numbers[places.MISS_WEIGHTS : places.MISS_WEIGHTS + 6].copy()
        if self._rates:
            self._misses[3:] = 1.0
        self._paces = 1.0 / np.sqrt(numbers[places.WEIGHT :: places.RECORD][: self.dof])

    @cached_property
    def on_gpu(self) -> Any:  # noqa: ANN401
        """The robot's solver for arrays on a GPU."""
        name = f"{__package__}.dhgen_cuda" if __package__ else "dhgen_cuda"
        return importlib.import_module(name).cuda(self.robot)

    def checked(self, *given: Array) -> Array:
        """The poses, if shapes are right."""
        T, *q_free = given
        if len(q_free) != (self.given > 0):
            takes = f"(..., {self.given}), besides T" if self.given else "nothing besides T"
            raise TypeError(f"{self.robot.NAME} takes {takes}")
        if tuple(T.shape[-2:]) != (4, 4):
            raise ValueError(f"T must be of shape (..., 4, 4), not {tuple(T.shape)}")
        for name, each in zip(("T", "q_free"), given, strict=False):
            if not str(each.dtype).endswith(("float64", "float32")):
                raise TypeError(f"{name} must be float64 or float32, not {each.dtype}")
        for each in q_free:
            if tuple(each.shape) != (*T.shape[:-2], self.given):
                wanted = f"{(*T.shape[:-2], self.given)}, as T is"
                raise ValueError(f"q_free must be of shape {wanted}, not {tuple(each.shape)}")
        return T

    def solve(self, solver: Any, T: Array, *q_free: Array) -> tuple[Array, Array]:  # noqa: ANN401
        """All rows of poses (..., 4, 4), by the module or on a GPU."""
        before = tuple(T.shape[:-2])
        flat = (each.reshape(-1, self.given) for each in q_free)
        q, status = solver.ik_batch(T.reshape(-1, 4, 4), *flat)
        return q.reshape(*before, self.rows, self.dof), status.reshape(*before, self.rows)

    def derivatives(self, space: Space, solver: Any, *arrays: Array) -> list[Array]:  # noqa: ANN401
        """The derivatives of rows by the first three rows of T, and by what the caller gives.

        Args:
            space: Where they are calculated.
            solver: What has `jacobian` and `fk` there.
            arrays: T, what the caller gives, and what `solve` found: q and status.

        Returns:
            (..., rows, joints, 3, 4), and (..., rows, joints, how many) if the caller gives some.
        """
        xp, (T, *_, q, status) = space.xp, arrays
        paces, misses = space.array(self._paces), space.array(self._misses)
        q = xp.where(solved(status), space.array(q), 0.0)
        flat, T = q.reshape(-1, self.dof), space.array(T)[..., None, :, :]
        J = solver.jacobian(flat).reshape(*q.shape[:-1], 6, self.dof)
        if self._rates:
            there = solver.fk(flat).reshape(*q.shape[:-1], 4, 4)
            J = _counted(space, self._rates(space, there)) @ J
        J = J * misses[:, None] * paces
        free, share = J, None
        if self.given:  # joints move so that what is given does not
            held = self._held(space, q) * paces
            square = (held * held).sum(-1)[..., None]
            share = xp.swapaxes(held / xp.where(square > 0.0, square, 1.0), -1, -2)
            free = J - J @ share @ held
        inverse = _damped_inverse(xp, free, self._damped_below)
        by_twist = inverse * paces[:, None] * misses
        if self._rates:
            by_twist = by_twist @ _counted(space, self._rates(space, T))
        columns = [0.5 * _cross(xp, by_twist[..., 3:], T[..., None, :3, k]) for k in range(3)]
        here = solved(status)[..., None]
        results = [xp.where(here[..., None], xp.stack([*columns, by_twist[..., :3]], -1), 0.0)]
        if share is not None:
            by_given = (share - inverse @ J @ share) * paces[:, None]
            results.append(xp.where(here, by_given, 0.0))
        return results

    def _held(self, space: Space, q: Array) -> Array:
        """The derivative of what the caller gives by joints, (how many, joints) or a stack."""
        if not self._angle:
            return space.array(np.eye(self.dof)[list(self._free)])
        if space.xp is not np:
            raise TypeError(f"{self.robot.NAME} has no derivative on a GPU: its arm angle is given")
        steps = STEP * np.eye(self.dof)
        rows = q.reshape(-1, 1, self.dof)
        ends = self._angle(rows + steps) - self._angle(rows - steps)
        turned = np.remainder(ends + math.pi, 2.0 * math.pi) - math.pi
        return (turned / (2.0 * STEP)).reshape(*q.shape[:-1], 1, self.dof)


def _counted(space: Space, rates: Array) -> Array:
    """What counts of twists: velocities, and rates of directions, (..., 6, 6)."""
    spins = space.array(np.eye(3, 6, 3))
    return space.array(np.diag([1.0, 1, 1, 0, 0, 0])) + spins.T @ rates @ spins


def _of_pointing(space: Space, T: Array) -> Array:
    """Rates of the tool's z axis by angular velocities, turned by a right angle."""
    z = T[..., :3, 2]
    return space.array(np.eye(3)) - z[..., :, None] * z[..., None, :]


def _of_yaw(space: Space, T: Array) -> Array:
    """The rate of the yaw, at which the tool's x axis turns about the vertical."""
    x, y, z = (T[..., k, 0] for k in range(3))
    slope = z / (x * x + y * y)
    row = space.xp.stack([-slope * x, -slope * y, 0.0 * z + 1.0], -1)
    return space.array(np.eye(3)[:, 2:]) * row[..., None, :]


def _of_pitch(space: Space, T: Array) -> Array:
    """The rate at which the end of the tool's x axis rises."""
    row = space.xp.stack([T[..., 1, 0], -T[..., 0, 0], 0.0 * T[..., 0, 0]], -1)
    return space.array(np.eye(3)[:, :1]) * row[..., None, :]


def _of_tilt(space: Space, T: Array) -> Array:
    """Rates of the vertical, as the tool sees it."""
    across = space.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 0.0]])
    return space.xp.swapaxes(T[..., :3, :3], -1, -2) @ across


def _damped_inverse(xp: Any, A: Array, below: float) -> Array:  # noqa: ANN401
    """The pseudoinverses of matrices, of which smaller singular values are damped."""
    U, s, Vh = xp.linalg.svd(A, full_matrices=False)
    square = s * s
    least = below * below
    shares = s / xp.where(square > least, square, least)
    return xp.swapaxes(Vh, -1, -2) * shares[..., None, :] @ xp.swapaxes(U, -1, -2)


def _cross(xp: Any, a: Array, b: Array) -> Array:  # noqa: ANN401
    """Products of vectors."""
    pairs = ((1, 2), (2, 0), (0, 1))
    return xp.stack([a[..., i] * b[..., k] - a[..., k] * b[..., i] for i, k in pairs], -1)
