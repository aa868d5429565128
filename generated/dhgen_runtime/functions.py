# SPDX-License-Identifier: MIT
"""The public functions of a robot, made from texts in `one_pose`, `tiles` and `calls`."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from . import (
    at_once,
    calls,
    calls_given,
    careful,
    clamp,
    coupled,
    coupled_turns,
    duplicates,
    follow_seed,
    one_pose,
    pose,
    refine,
    retry,
    tiles,
    velocities,
)
from .arguments import of_each
from .entry import Choice, again
from .jit import COMPILED, overload
from .places import CLAMPS, COUPLING, FOLLOWS_SEED, KEEPS_LIMITS, MERGES, PER_LENGTH, RETRIES
from .words import no_pose, no_row, what_is_given

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from .arrays import Floats, Ints
    from .jit import Compiling

# Files of the runtime with functions that are called by address, and the steps that need them.
APART = (
    (refine, (MERGES, CLAMPS, FOLLOWS_SEED)),
    (clamp, (CLAMPS,)),
    (duplicates, (MERGES,)),
    (follow_seed, (FOLLOWS_SEED,)),
    (retry, (RETRIES, KEEPS_LIMITS)),
)
# Of a robot's module: what the runtime calls by address, in this order, and functions of joints.
CALLED = ("_solve", "fk", "jacobian", "arm_angle", "_arm_angle_miss")
OF_JOINTS = ("fk", "jacobian", "arm_angle")
ALWAYS = "at every pose"
PUBLIC = ("ik", "ik_all", "ik_batch", "ik_into", "joint_velocities", "warm_up")


@dataclass(frozen=True, slots=True)
class Formulas:
    """The formulas of regular poses, and how they lie in arrays; see `tiles`.

    Attributes:
        run: Computes with (kept, turns, rows, w) all values of w poses, merged into its callers.
        kept: How many values of a pose are kept.
        turns: How many arguments of functions there are.
        places: Of the joints' values of each row among `rows`, (rows, joints).
    """

    run: Callable[..., None]
    kept: int
    turns: int
    places: Sequence[Sequence[int]]

    @property
    def table(self) -> Ints:
        """The places as an array."""
        return np.array(self.places)

    def names(self, given: int) -> dict[str, Any]:
        """What functions that call them name.

        Args:
            given: How many values the caller gives.
        """
        statuses = int(self.table.max()) + 1
        filled = statuses + len(self.places)
        return {
            "formulas": self.run,
            "places": self.table,
            "KEPT": self.kept,
            "TURNS": self.turns,
            "FILLED": filled,
            "DOUBT": tiles.ENTRIES + given,
            "STATUSES": statuses,
            "KEPT_OF_TILE": tiles.TILE * self.kept,
            "TURNS_OF_TILE": tiles.TILE * self.turns,
            "FILLED_OF_TILE": tiles.TILE * filled,
        }


@dataclass(frozen=True, slots=True)
class Solver:
    """A robot's own functions and numbers.

    Attributes:
        arm: The arm's numbers.
        task: What counts of a pose besides coordinates, by the names of functions in `pose`.
        formulas: Of regular poses; None where there are none.
        counted: Which coordinates a pose names.
        given: How many values the caller gives besides the pose.
        apart: Functions that compile what is called by address in a file, one for each.
        at_once: Whether it is solved for all joints at once.
    """

    arm: Floats
    task: str = "pose"
    formulas: Formulas | None = None
    counted: tuple[bool, bool, bool] = (True, True, True)
    given: int = 0
    apart: tuple[Callable[[], None], ...] = ()
    at_once: bool = False


def of_robot(robot: Mapping[str, Any], how: Compiling, solver: Solver) -> dict[str, Any]:
    """The functions of a robot, and what they name, by their names.

    Args:
        robot: The names of its module.
        how: How the functions of its file are compiled.
        solver: What is the robot's own.
    """
    facts = _facts(robot, solver)
    names = _names(robot, how, solver) | facts
    _add_compiled(names, how, solver)
    for name in ("look_at", "many", *PUBLIC):
        names[name] = again(names[name], names)
    if solver.at_once and COMPILED:
        _solve_at_once(names, how, solver)
    for name in PUBLIC:
        text = names[name].__doc__
        names[name].__doc__ = text and text.format(**facts)  # `python -OO` leaves out all
    overload(names["ik_into"], strict=False)(lambda *_, **__: names["compiled_into"])
    overload(names["joint_velocities"], strict=False)(lambda *_: names["compiled_velocities"])
    return names


def _facts(robot: Mapping[str, Any], solver: Solver) -> dict[str, Any]:
    """What the texts for users say of a robot, by the names that stand in them."""
    given = solver.given
    return {
        "given": what_is_given(robot) if given else "",
        "allocates": "only where a pose is singular or rounded" if solver.formulas else ALWAYS,
        "DOF": robot["DOF"],
        "ROWS": robot["MAX_SOLUTIONS"],
        "GIVEN": given,
        "given_shape": "(N,) or (N, 1)" if given == 1 else f"(N, {given})",
    }


def _names(robot: Mapping[str, Any], how: Compiling, solver: Solver) -> dict[str, Any]:
    """What the functions of a robot name, but for each other and for what texts say of it."""
    dof, rows, given = robot["DOF"], robot["MAX_SOLUTIONS"], solver.given
    called = [name if name in robot else None for name in CALLED]
    return {
        **vars(velocities),
        **vars(tiles),
        **vars(one_pose),
        **vars(calls_given if given else calls),
        "arm": solver.arm,
        "counted": solver.counted,
        "robot": how.addresses(*called),
        "called": called,
        "kinematics": tuple(robot[name] for name in OF_JOINTS if name in robot),
        "slides": "P" in robot["JOINT_TYPES"],
        "read_rows": getattr(pose, f"read_{solver.task}"),
        "rotation_miss": getattr(pose, f"miss_of_{solver.task}"),
        "apart": (how.compile_apart, *compilers_of(solver.arm), *solver.apart),
        "choice": Choice(
            solver.arm,
            robot["BRANCHES"],
            no_pose(robot, solver.task, given),
            no_row(robot, solver.task, solver.counted, given),
            unreachable(robot),
        ),
        "shapes": f"T, q and status must have shapes (4, 4), ({rows}, {dof}), ({rows},)",
        "of_each": of_each,  # for the C, whose functions replace these
        "given_must": f"q_free must have shape ({given},)",
        "__name__": robot["__name__"],
        **(solver.formulas.names(given) if solver.formulas else {}),
        **(_given_names(robot, solver) if given else {}),
    }


def _add_compiled(names: dict[str, Any], how: Compiling, solver: Solver) -> None:
    """Makes the compiled functions of a robot anew; each finds in `names` what it calls."""
    dof = names["DOF"]

    def add(name: str, compiled: Callable[[Any], Any] = lambda function: function) -> None:
        names[name] = compiled(again(names[name], names))

    def zeros(seed: Any) -> Any:  # noqa: ANN401
        for i in range(dof):
            seed[i] = 0.0
        return seed

    names["zeros"] = how.merged(zeros)
    fast = "by_formulas" if solver.formulas else "never_regular"
    add(fast, how.merged)
    names["regular"] = names[fast]
    for name in ("read", "is_exact"):
        add(name, how.njit(forceinline=True))
    if solver.given:
        add("given_values")
    turns = "turned_alone" if solver.arm[COUPLING] == 0.0 else "turned_together"
    add(turns, how.merged)
    names["settle"] = names[turns]
    add("careful", how.jit)
    add("into", how.merged)
    for name in ("unseeded", "seeded"):
        add(name, how.jit)
    add("solve_alone", how.merged)
    many = "in_tiles" if solver.formulas and COMPILED else "one_by_one"
    add(many, how.njit(nogil=True))
    names["solve_many"] = names[many]
    add("velocities_at", how.jit)
    add("compiled_velocities", how.owned)
    add("compiled_into", how.owned)


def _solve_at_once(names: dict[str, Any], how: Compiling, solver: Solver) -> None:
    """Has poses solved by what is compiled once for all robots; numba functions call their own."""
    others = {"slides": names["slides"], "given": solver.given}
    own = at_once.own_numbers(how, names["called"], solver.counted, **others)
    calls = at_once.calls_of(solver.task, solver.arm, own, solver.given)
    for name in ("unseeded", "seeded"):
        inside = names[name].py_func
        overload(calls[name], strict=False)(lambda *_, inside=inside: inside)
    names.update(calls)


def unreachable(robot: Mapping[str, Any]) -> type[ValueError]:
    """The exception of a robot for a pose without solutions."""
    text = "There is no solution, or none inside the limits; the message says which."
    return type("Unreachable", (ValueError,), {"__module__": robot["__name__"], "__doc__": text})


def public(calls: Mapping[str, Any]) -> list[Any]:
    """What a module has of them, in the order of PUBLIC, and its exception."""
    return [*(calls[name] for name in PUBLIC), calls["choice"].unreachable]


def _given_names(robot: Mapping[str, Any], solver: Solver) -> dict[str, Any]:
    """What functions name that leave to the seed what the caller gives."""
    if "FREE_JOINTS" not in robot:  # the arm angle
        freely = {"reach": math.pi, "within": (-math.inf, math.inf)}
        return {"given_of_joints": lambda q: [robot["arm_angle"](q)], **freely}
    places = [number - 1 for number in robot["FREE_JOINTS"]]
    low, high = robot["JOINT_LIMITS"][places[0]]
    stroke = high - low if math.isfinite(high - low) else 1.0 / solver.arm[PER_LENGTH]
    turns = robot["JOINT_TYPES"][places[0]] == "R"
    near = {"reach": math.pi if turns else stroke, "within": (low, high)}
    return {"given_of_joints": lambda q: q[places], **near}


def compilers_of(arm: Floats) -> list[Callable[[], None]]:
    """What compiles the files of the runtime that an arm needs."""
    found = [careful.OWN.compile_apart, velocities.OWN.compile_apart]
    if arm[COUPLING] > 0.0:
        found += [coupled.OWN.compile_apart, coupled_turns.OWN.compile_apart]
    return found + [
        file.OWN.compile_apart for file, steps in APART if any(arm[step] > 0.0 for step in steps)
    ]
