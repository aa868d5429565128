"""What solves for all joints at once: the runtime, with the numbers of an arm."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from dhgen.general.runtime_loop import runtime_loop
from dhgen.numerical.runtime_arm import runtime_arm
from dhgen.runtime.python.general.arm import general_numbers
from dhgen.runtime.python.numerical.arm import arm_numbers

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.program.ir import AllJoints


def whole_solver(statement: AllJoints) -> Any:  # noqa: ANN401  numba's or Python's
    """The runtime's function for such arms: from arm, pose, given values and seed to rows.

    It is compiled, as verification compiles it anyway.
    """
    if statement.general is not None:
        from dhgen.runtime.python.general.rows import solve_whole  # noqa: PLC0415  takes time

        return solve_whole
    from dhgen.runtime.python.numerical.search import solve_whole as descend  # noqa: PLC0415

    return descend


def whole_numbers(statement: AllJoints) -> FloatArray:
    """The arm as the runtime takes it."""
    arm = runtime_arm(statement.descent)
    if statement.general is None:
        return arm_numbers(arm)
    return general_numbers(arm, runtime_loop(statement.general))
