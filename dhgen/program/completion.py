"""Rows of a program that miss their pose: the runtime in plain Python, with the program's rows."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.kinematics.algebra import POSE_PLACES
from dhgen.kinematics.arm_angle import plane_miss
from dhgen.kinematics.task import compared_entries
from dhgen.numerical.runtime_arm import runtime_arm
from dhgen.runtime.plain import plain
from dhgen.runtime.python.numerical.arm import arm_numbers
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.numerical.kernel import NumericalKernel

    # From a pose, what the caller gives, a seed and how far roots are moved to rows, into the last
    # two: joint values, and what each row holds.
    Solve = Callable[..., None]


@dataclass(frozen=True)
class Completion:
    """How rows are completed.

    Attributes:
        kernel: The arm.
        rows: How many there are.
        turning: The joints, from 1, whose values add up to a root, each with its sign.
    """

    kernel: NumericalKernel
    rows: int
    turning: tuple[tuple[int, int], ...]

    def may_miss(self, poses: FloatArray, q: FloatArray) -> NDArray[np.bool_]:
        """Whether rows (N, B, n) miss their poses (N, 4, 4) by more than rounding next to the arm.

        Rows without a solution, NaN, do not.
        """
        places, size = self._entries, self.kernel.arm.chain.size
        lengths = np.array([1.0 / size if place % 4 == 3 else 1.0 for place in places])
        shape = (*q.shape[:2], 16)
        found = self.kernel.arm.pose(q.reshape(-1, q.shape[-1])).reshape(shape)
        off = (found - poses.reshape(-1, 1, 16))[..., list(places)] * lengths
        return np.asarray(np.linalg.norm(off, axis=-1) > TOLERANCES.exact)

    def complete(
        self,
        solve: Solve,
        pose: FloatArray,
        given: tuple[FloatArray, FloatArray],
        q: FloatArray,
        status: NDArray[np.uint8],
    ) -> None:
        """Splits close roots and refines the rows of a pose, in place.

        Args:
            solve: The program.
            pose: Shape (4, 4).
            given: What the caller gives besides, and the seed.
            q: Joint values (B, n).
            status: What each row holds (B,), in the runtime's words.
        """
        arm, free = self.kernel.arm, given[0].copy()

        def miss(T: FloatArray, psi: FloatArray, values: FloatArray, off: FloatArray) -> None:
            missed, rates = plane_miss(arm, T, float(psi[0]), values, TOLERANCES.free)
            off[0], off[1:] = missed, rates[:3]

        robot = solve, arm.pose, None, None, miss
        task = self._numbers, robot, tuple(map(float, pose[:3].ravel())), free
        if self.turning:
            plain("numerical.split_close_roots").split_close_roots(task, given[1].copy(), q, status)
        plain("numerical.refine_rows").refine_rows(task, q, status)

    @cached_property
    def _entries(self) -> tuple[int, ...]:
        """Places of the entries that the task names, in sixteen numbers."""
        names = sorted(compared_entries(self.kernel.arm.chain.task))
        return tuple(4 * row + column for row, column in (POSE_PLACES[name] for name in names))

    @cached_property
    def _numbers(self) -> FloatArray:
        """The arm as the runtime takes it: nothing else of it counts here."""
        chain, arm = self.kernel.arm.chain, plain("arm")
        none = (0.0,) * chain.dof
        found: Any = arm.arm_numbers(
            arm.Arm(
                types=chain.joint_types,
                limits=((0.0, 0.0),) * chain.dof,
                slacks=none,
                weights=none,
                paces=none,
                fan_steps=none,
                rows=self.rows,
                directions="none",
                miss_weights=(0.0,) * 6,
                size=chain.size,
                clamped=0.0,
                clamped_again=0.0,
                entries=self._entries,
                root_turns=tuple((joint - 1, float(sign)) for joint, sign in self.turning),
            ),
            arm_numbers(runtime_arm(self.kernel)),
        )
        return np.asarray(found)
