"""The loop's solutions for a kernel, by the runtime as numba compiles it once for all arms."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from dhgen.general.runtime_loop import runtime_loop
from dhgen.kinematics.rigid import IDENTITY
from dhgen.numerical.runtime_arm import twelve
from dhgen.runtime.plain import plain
from dhgen.runtime.python.general import search
from dhgen.runtime.python.general.arm import general_numbers
from dhgen.runtime.python.general.candidates import PLACES
from dhgen.runtime.python.general.loop import close, vanishing
from dhgen.runtime.python.general.tables import SAMPLE_C, SAMPLE_S
from dhgen.runtime.python.jit import of_file
from dhgen.runtime.python.numerical.arm import Arm, ChainJoint, Joint

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from dhgen.arrays import FloatArray
    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain

OWN = of_file(__file__)
solve_loop, from_nearby, attempt = search.solve_loop, search._from_nearby, search._try


@dataclass(frozen=True, slots=True)
class Solved:
    """The solutions of one pose.

    Attributes:
        q: (k, 6), sorted by q1, then q2 ..., singular ones and nearly so last.
        residual: (k,), by how much the loop stays open [arm sizes, rad].
        certain: Whether these are certainly all, and none is singular.
    """

    q: FloatArray
    residual: FloatArray
    certain: bool


def joint_values(angles: FloatArray, chain: Chain) -> FloatArray:
    """The values (k, n) of the joints that are solved for, from the loop's angles and lengths."""
    signs = np.array([joint.sign for joint in chain.solved])
    offsets = [joint.offset for joint in chain.solved]
    return np.asarray(signs * (angles[:, : len(signs)] - offsets))


def tried(kernel: GeneralKernel, free: Sequence[float]) -> list[int]:
    """The formulations that are tried at given values."""
    useless = plain("general.loop").vanishing(numbers(kernel), np.array(free, dtype=float))
    return [number for number in range(len(kernel.formulations)) if not useless >> number & 1]


def four_turns_samples(kernel: GeneralKernel, T: np.ndarray, number: int) -> FloatArray:
    """The polynomial in closed form of an arm with two slides at the sample angles."""
    arm, loop, four_turns = numbers(kernel), plain("general.loop"), plain("general.four_turns")
    joints, between = loop.joints_of(arm, number), np.zeros((4, 12))
    closed = loop.close(arm, np.array(T, dtype=float)[:3].ravel(), np.zeros(0))
    links = loop.around(arm, number, closed)
    four_turns.split_links(arm, joints, links, between)
    return np.array(
        [
            four_turns.four_turns_polynomial(arm, joints, links, between, c, s)
            for c, s in zip(SAMPLE_C, SAMPLE_S, strict=True)
        ]
    )


def numbers(kernel: GeneralKernel) -> FloatArray:
    """The array of a kernel without a chain: the loop alone is the arm's."""
    unit = twelve(IDENTITY)
    whole = Arm(
        rows=kernel.rows,
        size=1.0,
        coordinates=(0, 1, 2),
        directions="rotation",
        joints=tuple(Joint(place) for place in range(6)),
        base=unit,
        chain=(ChainJoint(unit),) * 6,
        free=tuple(range(6, 6 + len(kernel.given))),
    )
    return general_numbers(whole, runtime_loop(kernel))


def solve(T: np.ndarray, kernel: GeneralKernel, free: Sequence[float] = ()) -> Solved:
    """All solutions of T = C0 J1(q1) C1 ... J6(q6) C6."""
    return _solved(T, kernel, free, _solve_loop)


def solve_slowly(T: np.ndarray, kernel: GeneralKernel, free: Sequence[float] = ()) -> Solved:
    """The same in plain Python, as the compiler itself runs it."""
    with np.errstate(divide="ignore", invalid="ignore"):  # as compiled code divides
        return _solved(T, kernel, free, plain("general.search").solve_loop)


def correct_slowly(
    T: np.ndarray, kernel: GeneralKernel, nearby: np.ndarray
) -> tuple[FloatArray, bool]:
    """From near solutions (k, 6) to these in plain Python, and whether they are exact and apart."""
    angles, none = np.array(nearby), np.zeros(0)
    with np.errstate(divide="ignore", invalid="ignore"):
        said = plain("general.search").corrected(numbers(kernel), _pose(T, kernel), none, angles)
    return angles, bool(said)


def _solved(
    T: np.ndarray,
    kernel: GeneralKernel,
    free: Sequence[float],
    solve_loop: Callable[..., int],
) -> Solved:
    q, residual = np.empty((PLACES, 6)), np.empty(PLACES)
    given = np.array(free, dtype=float)
    count = solve_loop(numbers(kernel), _pose(T, kernel), given, q, residual)
    found = count if count >= 0 else -1 - count
    return Solved(q[:found], residual[:found], count >= 0)


def is_complete(T: np.ndarray, kernel: GeneralKernel, free: Sequence[float] = ()) -> bool:
    """Whether a certificate, or poses close by, show all solutions, be some of them singular."""
    return bool(_is_complete(numbers(kernel), _pose(T, kernel), np.array(free, dtype=float)))


@OWN.jit
def _solve_loop(
    arm: FloatArray,
    T: FloatArray,
    free: FloatArray,
    q: FloatArray,
    residual: FloatArray,
) -> int:
    return solve_loop(arm, T, free, q, residual)


@OWN.jit
def _is_complete(arm: FloatArray, T: FloatArray, free: FloatArray) -> bool:
    useless, closed = vanishing(arm, free), close(arm, T, free)
    q, residual, marks = np.empty((PLACES, 6)), np.empty(PLACES), np.zeros(PLACES, np.int64)
    doubles = np.zeros(1, np.int64)
    complete, count = attempt(arm, closed, useless, q, residual, marks, doubles)
    if not complete:
        complete, count = from_nearby(arm, closed, useless, q, residual, marks, count)
    return complete


def _pose(T: np.ndarray, kernel: GeneralKernel) -> FloatArray:
    """The twelve numbers of a pose, with any rotation that fits where the tool only points."""
    flat: FloatArray = np.array(T, dtype=float)[:3].ravel()
    if kernel.pointing:
        plain("general.rows").any_turn(flat.reshape(3, 4), flat)
    return flat
