# SPDX-License-Identifier: MIT
"""One arm of a kind, as callers hold it: its functions with their texts."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np

from .arguments import BYTE, array_of, of_each, results
from .calibrate import JOINTS, TABLE_SHAPE
from .calibration import MOVED, NUMBERS, TURNED
from .entry import poses_of, share

if TYPE_CHECKING:
    from collections.abc import Mapping

    from numpy.typing import ArrayLike

    from .arrays import Bytes, Floats
    from .entry import Choice


class CalibratedArm:
    """An arm with the table, or origins, that it was given: only read, by any number of threads.

    Attributes:
        table: theta, d, a, alpha of each row at q = 0, (6, 4); None where origins were given. Can't
            be written to.
        origins: x, y, z, roll, pitch, yaw of each frame in the one before, (7, 6); None where a
            table was given. Can't be written to.
        numbers: What these make of the arm, as `ik_into` of the module takes it; not to be
            changed.
        turned: By how much its tool is turned to that of the nominal arm at most, once that has
            other zeros, base and tool [rad].
        moved: By how much it is away at most [length].
    """

    __slots__ = ("_calls", "_choice", "moved", "numbers", "origins", "table", "turned")

    def __init__(self, given: Floats, arm: Floats, calls: Mapping[str, Any]) -> None:
        """Takes a table (6, 4), or origins (7, 6), and what `worked_out` made of them."""
        own, self.numbers, self._calls = given.view(), arm, calls
        own.flags.writeable = False  # the numbers would not follow
        self.table: Floats | None = own if own.shape == TABLE_SHAPE else None
        self.origins: Floats | None = None if self.table is own else own
        self._choice: Choice = calls["choice"](arm)
        self.turned, self.moved = (float(arm[at - NUMBERS]) for at in (TURNED, MOVED))

    def __repr__(self) -> str:
        """The module, and by how much the arm differs."""
        module, unit = self._calls["__name__"], self._calls["unit"]
        differs = f"{self.turned:.2g} rad, {self.moved:.2g} {unit}"
        return f"<arm of {module}, from the nominal one at most {differs}>"

    def __reduce__(self) -> tuple[Any, tuple[Floats]]:
        """Another process works the table, or the origins, out again."""
        if self.origins is not None:
            return self._calls["calibrated_by_origins"], (self.origins,)
        assert self.table is not None
        return self._calls["calibrated"], (self.table,)

    def fk(self, q: ArrayLike) -> Any:  # noqa: ANN401  numbers in the shape of the stack
        """The pose (4, 4) of joint values (6,), or of each in a stack of them."""
        return of_each(partial(self._calls["pose_at"], self.numbers), q, JOINTS)

    def jacobian(self, q: ArrayLike) -> Any:  # noqa: ANN401
        """The geometric Jacobian (6, 6): velocity of the tool's origin, then angular velocity."""
        return of_each(partial(self._calls["jacobian_at"], self.numbers), q, JOINTS)

    def joint_velocities(self, q: ArrayLike, twist: ArrayLike) -> Floats:
        """The joint velocities (6,) with which the tool moves by a twist.

        They are those of least squares, of these the least, and exact where the arm is regular.
        Near a singular pose what the arm hardly can do is damped: no joint velocity exceeds a
        hundred times the twist, lengths in arm sizes.

        Args:
            q: Joint values (6,).
            twist: Velocity of the tool's origin, then angular velocity, in the base's frame (6,).

        Raises:
            ValueError: An argument has the wrong shape.
        """
        values = array_of(q, (JOINTS,), "q"), array_of(twist, (6,), "twist")
        found: Floats = self._calls["velocities_at"](self.numbers, *values)
        return found

    def ik_all(self, T: ArrayLike, q_seed: ArrayLike | None = None) -> tuple[Floats, Bytes]:
        """All solutions: q (16, 6) and status (16,), in rows by posture (BRANCHES).

        Args:
            T: Pose (4, 4).
            q_seed: Values for joints that are indeterminate at this pose (6,); zeros without it.

        Raises:
            ValueError: An argument has the wrong shape, or the seed is not finite.
        """
        seed = np.zeros(JOINTS) if q_seed is None else array_of(q_seed, (JOINTS,), "q_seed")
        rows = self._calls["ROWS"]
        q, status = np.empty((rows, JOINTS)), np.empty(rows, BYTE)
        self._calls["seeded"](self.numbers, array_of(T, (4, 4), "T"), q, status, seed)
        return q, status

    def ik(
        self,
        T: ArrayLike,
        q_seed: ArrayLike | None = None,
        *,
        branch: str | int | None = None,
        limits: bool = True,
    ) -> Floats:
        """One solution (6,): the nearest to the seed.

        Angles are moved by whole turns into their limits.

        Args:
            T: Pose (4, 4).
            q_seed: Where the arm is (6,); zeros without it.
            branch: Only this row: a name from BRANCHES, or its number.
            limits: Whether joint limits count: True or False.

        Raises:
            Unreachable: There is no such solution; the message says why.
            ValueError: T is not a valid pose, branch does not exist, or limits is not True or
                False.
        """
        rows = self._choice.rows(branch, limits)
        return self._choice.nearest(self.ik_all(T, q_seed), q_seed, rows, limits)

    def ik_batch(
        self,
        T: ArrayLike,
        *,
        cores: int | None = None,
        out: tuple[Floats, Bytes] | None = None,
    ) -> tuple[Floats, Bytes]:
        """ik_all for N poses (N, 4, 4), shared among `cores` cores, by default all of them.

        Args:
            T: Poses (N, 4, 4).
            cores: How many threads share the poses.
            out: The arrays q and status to write to, from an earlier call or like those.

        Returns:
            q (N, 16, 6) and status (N, 16).

        Raises:
            ValueError: An argument has the wrong shape, or cores is not a whole number from 1.
        """
        poses = poses_of(T, cores)
        q, status = results(out, (len(poses), self._calls["ROWS"], JOINTS))
        share(partial(self._calls["many"], self.numbers), cores, poses, q, status)
        return q, status

    def ik_into(self, T: Floats, q: Floats, status: Bytes, q_seed: Floats | None = None) -> int:
        """All solutions into the caller's arrays: `ik_into` of the module for this arm."""
        count: int = self._calls["ik_into"](self.numbers, T, q, status, q_seed)
        return count
