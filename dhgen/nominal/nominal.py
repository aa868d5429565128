"""Solving the nearest arm with a structure: its closed form, and where that shows all rows."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from dhgen.kinematics.build import build_chain
from dhgen.kinematics.neighbours import EXACT, axis_triples
from dhgen.kinematics.numeric import numeric_arm
from dhgen.method import Method
from dhgen.nominal.certificate import certified
from dhgen.nominal.nearest import nearest_arms
from dhgen.paul.derive import derive
from dhgen.program.interpret import outputs
from dhgen.program.lowering.lower import lower
from dhgen.program.regular.regular import regular
from dhgen.robot.load import load_text
from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain
    from dhgen.nominal.nearest import Nearest
    from dhgen.paul.derivation import Derivation
    from dhgen.program.ir import Program
    from dhgen.program.regular.unguarded import Regular
    from dhgen.program.reserved import Reserved

NAME = "nearest"
TWISTS = ("0", "pi/2", "pi")
POSES = 1000
JOINTS = 6
WORTH = 0.5  # of poses have to be certain: solving the nearest arm takes time that others lose


@dataclass(frozen=True, slots=True)
class Nominal:
    """The nearest arm with a structure, solved.

    Attributes:
        nearest: Its numbers.
        chain: The arm of its table alone.
        solver: Its closed form.
        regular: The same of regular poses, left where its rows may not be all of the arm's.
        derivation: What the closed form is made of.
        certain: At which part of random poses they are.
    """

    nearest: Nearest
    chain: Chain
    solver: Program
    regular: Regular
    derivation: Derivation
    certain: float


def nominal_arm(chain: Chain, reserved: Reserved) -> Nominal | None:
    """The nearest arm with a closed form; None where there is none that helps.

    Args:
        chain: The arm.
        reserved: Names that are kept for others.
    """
    if not _is_asked_alone(chain):
        return None
    found = (_solved(chain, nearest, reserved) for nearest in nearest_arms(chain))
    best = next((each for each in found if each is not None), None)
    return None if best is None or best.certain < WORTH else best


def _solved(chain: Chain, nearest: Nearest, reserved: Reserved) -> Nominal | None:
    """The closed form of a near arm; None where it has none, or none with bounds."""
    near = build_chain(load_text(_robot_file(chain, nearest), NAME))
    if not _has_structure(near):
        return None
    derivation = derive(near)
    if derivation.method is not Method.CLOSED_FORM:
        return None
    names = frozenset(constant.name for constant in chain.constants)
    solver = replace(lower(derivation, reserved=reserved, zero=_zero(chain, nearest)), name=NAME)
    whole = regular(solver)
    own = None if whole is None else certified(whole, near.given, names)
    if own is None:
        return None
    return Nominal(nearest, near, solver, own, derivation, _certain(chain, nearest, own))


def _is_asked_alone(chain: Chain) -> bool:
    """Whether a pose asks for six joints, and all turn.

    Their angles are what its closed form gives: drives may be coupled.
    """
    turns = len(chain.solved) == JOINTS and all(chain.turning)
    asked = chain.task.kind is TaskKind.POSE and not chain.arm_angle
    return turns and asked and not chain.passive


def _has_structure(chain: Chain) -> bool:
    """Whether three axes side by side are parallel, or meet."""
    return any(min(t.tilt, t.miss / chain.size) < EXACT for t in axis_triples(chain))


def _robot_file(chain: Chain, nearest: Nearest) -> str:
    table = nearest.table
    twists = [
        repr(alpha) if quarter is None else TWISTS[quarter]
        for quarter, alpha in zip(table.quarters, table.alpha, strict=True)
    ]
    cells = zip(
        _thetas(chain, nearest), (*table.d, 0.0), (*table.a, 0.0), (*twists, "0"), strict=True
    )
    links = [f"  - {{theta: {q}, d: {d!r}, a: {a!r}, alpha: {alpha}}}" for q, d, a, alpha in cells]
    head = f"name: {NAME}\ntitle: {NAME}\nsource: computed\nconvention: standard\njoints:"
    free = [f"free: {list(chain.free)}"] if chain.free else []
    return "\n".join([head, *links, *free, "task: pose", ""])


def _thetas(chain: Chain, nearest: Nearest) -> list[str]:
    """What the table's joints are: angles, those of given joints by the values that come in."""
    return [
        f"{'-' if joint.sign < 0 else ''}q + ({joint.offset + more!r})"
        if joint.number in chain.free
        else "q"
        for joint, more in zip(chain.joints, nearest.offsets, strict=True)
    ]


def _zero(chain: Chain, nearest: Nearest) -> list[float]:
    """The near arm's joint values where the arm's are zero."""
    return [
        0.0 if joint.number in chain.free else joint.offset + more
        for joint, more in zip(chain.joints, nearest.offsets, strict=True)
    ]


def _certain(chain: Chain, nearest: Nearest, solver: Regular) -> float:
    """At which part of random poses no branch may end near by."""
    q = np.random.default_rng(0).uniform(-np.pi, np.pi, (POSES, chain.dof))
    poses = np.array(nearest.left) @ numeric_arm(chain).pose(q) @ np.array(nearest.right)
    given = np.empty((POSES, len(chain.free) + 2))
    given[:, :-2] = q[:, [number - 1 for number in chain.free]]
    given[:, -2:] = nearest.deviation.ball
    return float(1.0 - np.mean(left_poses(solver, poses, given)))


def left_poses(solver: Regular, poses: FloatArray, given: FloatArray) -> NDArray[np.bool_]:
    """Which poses a certified program leaves, since one of its branches may end near by.

    Args:
        solver: The program.
        poses: Of its arm, (N, 4, 4).
        given: What it is given besides, by how much the other arm may be away last, (N, k).
    """
    doubts = outputs(solver.program, poses, free=given)[len(solver.joints) :]
    ended = [each.reshape(len(poses), -1).any(axis=1) for each in doubts]
    return np.asarray(np.any(ended, axis=0))
