"""What solves for all joints at once: the runtime, with the numbers of an arm."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING, Any

from dhgen.general.runtime_loop import runtime_loop
from dhgen.numerical.runtime_arm import runtime_arm
from dhgen.runtime.python.general.arm import general_numbers
from dhgen.runtime.python.numerical.arm import arm_numbers

if TYPE_CHECKING:
    from dhgen.arrays import FloatArray
    from dhgen.program.ir import AllJoints


def whole_solver(statement: AllJoints) -> tuple[Any, FloatArray]:
    """The runtime's function, from arm, pose, given values and seed to rows, and the arm."""
    return _solver(general=statement.general is not None), _numbers(statement)


@cache
def _solver(*, general: bool) -> Any:  # noqa: ANN401  numba's or Python's
    """What solves arms of a kind: compiled, as verification compiles it anyway."""
    if general:
        from dhgen.runtime.python.general.rows import solve_whole  # noqa: PLC0415  takes time

        return solve_whole
    from dhgen.runtime.python.numerical.search import solve_whole as descend  # noqa: PLC0415

    return descend


def _numbers(statement: AllJoints) -> FloatArray:
    arm = runtime_arm(statement.descent)
    if statement.general is None:
        return arm_numbers(arm)
    return general_numbers(arm, runtime_loop(statement.general))
