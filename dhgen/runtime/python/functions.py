# SPDX-License-Identifier: MIT
"""The public functions of a robot, made from the texts in `calls` and `calls_given`."""

from __future__ import annotations

from dataclasses import dataclass
from types import FunctionType
from typing import TYPE_CHECKING, Any

from . import calls, calls_given
from .entry import Choice
from .jit import COMPILED, overload

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    import numpy as np
    from numpy.typing import NDArray

    from .jit import Compiling

PUBLIC = ("ik", "ik_all", "ik_batch", "ik_into", "warm_up")


@dataclass(frozen=True, slots=True)
class Solver:
    """A robot's own functions and numbers.

    Attributes:
        joints: The arm's joints, see `turns`.
        into: All solutions of a pose, merged into what calls it.
        many: All solutions of many poses; None if they are solved one by one.
        kinematics: Functions of joint values, fk first.
        given: How many values the caller gives besides the pose.
        apart: Functions that compile what stands apart in a file, one for each.
        words: What messages and docstrings say of the robot: no_pose, no_row, allocates, and
            `given` of values that the caller gives.
    """

    joints: NDArray[np.float64]
    into: Callable[..., int]
    many: Callable[..., None] | None
    kinematics: tuple[Callable[[Any], Any], ...]
    given: int
    apart: tuple[Callable[[], None], ...]
    words: Mapping[str, str]


def of_robot(robot: Mapping[str, Any], how: Compiling, solver: Solver) -> dict[str, Any]:
    """The functions of a robot, and what they name, by their names.

    Args:
        robot: The names of its module.
        how: How the functions of its file are compiled.
        solver: What is the robot's own.
    """
    dof, rows, given = robot["DOF"], robot["MAX_SOLUTIONS"], solver.given
    texts, words = vars(calls_given if given else calls), solver.words
    facts = {
        **words,
        "DOF": dof,
        "ROWS": rows,
        "GIVEN": given,
        "given_shape": "(N,) or (N, 1)" if given == 1 else f"(N, {given})",
    }
    names = {
        **texts,
        **facts,
        "into": solver.into,
        "kinematics": solver.kinematics,
        "apart": solver.apart,
        "choice": Choice(
            solver.joints,
            robot["BRANCHES"],
            words["no_pose"],
            words["no_row"],
            robot["Unreachable"],
        ),
        "__name__": robot["__name__"],
    }

    def add(name: str, compiled: Callable[[Any], Any] = lambda function: function) -> None:
        names[name] = compiled(_again(texts[name], names))

    def zeros(seed: Any) -> Any:  # noqa: ANN401
        for i in range(dof):
            seed[i] = 0.0
        return seed

    names["zeros"] = how.merged(zeros)
    for name in ("unseeded", "seeded"):
        add(name, how.jit)
    add("one_by_one", how.njit(nogil=True))
    names["many"] = solver.many if solver.many and COMPILED else names["one_by_one"]
    add("compiled_into", how.owned)
    for name in ("look_at", *PUBLIC):
        add(name)
    for name in PUBLIC:
        names[name].__doc__ = texts[name].__doc__.format(**facts)
    overload(names["ik_into"], strict=False)(lambda *_, **__: names["compiled_into"])
    return names


def _again(function: FunctionType, names: dict[str, Any]) -> FunctionType:
    """A function once more, with other values of what it names."""
    made = FunctionType(function.__code__, names, function.__name__, function.__defaults__)
    made.__kwdefaults__ = function.__kwdefaults__
    return made
