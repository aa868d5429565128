"""A pose of an arm that is solved as a whole, with its polynomial, by the runtime's own code."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.derivation.example import drawn, least_singular, without_turns
from dhgen.derivation.whole_turns import are_inside, turned_rows
from dhgen.kinematics.given import given_values
from dhgen.kinematics.numeric import numeric_arm
from dhgen.nominal.postures import placed_by_posture
from dhgen.program.all_joints import whole_numbers
from dhgen.program.interpret import wrap
from dhgen.program.ir import AllJoints
from dhgen.runtime.plain import plain
from dhgen.runtime.python.status import FREE_JOINT, UNREACHABLE

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.derivation.story import Story
    from dhgen.general.kernel import GeneralKernel

POSES = 3  # that are solved to find one with many solutions
SAME = 1e-6  # a root and the angle of a solution, as cosine and sine
HARMONICS = 8


@dataclass(frozen=True, slots=True)
class WholeExample:
    """A pose with its solutions.

    Attributes:
        q: Joint values at the pose, (n,).
        T: The pose, (4, 4).
        given: What the caller gives besides it, (k,).
        rows: Joint values by row, (B, n), NaN in rows of postures that have no solution.
        inside: Which rows keep the limits, (B,).
        loop: The angles and lengths of the loop's joints in the followed row, (6,).
        followed: The row that is worked through.
        coefficients: a_0 ... a_8, b_1 ... b_8 of the polynomial in the joint's angle, or in the
            angle that represents its length, over the largest, (17,).
        roots: Its real roots, ascending in (-pi, pi].
        taken: Place of the root from which the row comes.
    """

    q: FloatArray
    T: FloatArray
    given: FloatArray
    rows: FloatArray
    inside: NDArray[np.bool_]
    loop: FloatArray
    followed: int
    coefficients: FloatArray
    roots: FloatArray
    taken: int


def find_whole_example(story: Story, kernel: GeneralKernel) -> WholeExample | None:
    """The pose with the most solutions, of poses farthest from singular ones.

    None where none of them has simple roots alone.
    """
    (statement,) = (each for each in story.program.body if isinstance(each, AllJoints))
    numbers, arm = whole_numbers(statement), numeric_arm(story.algebra.chain)
    q = drawn(arm.chain)
    q = q[are_inside(arm.chain, q)]
    q = q[np.argsort(-least_singular(arm, q), kind="stable")[:POSES]]
    found = [
        example
        for own, T, given in zip(q, arm.pose(q), given_values(arm, q), strict=True)
        if (example := _solved(story, kernel, numbers, (own, T, given))) is not None
    ]
    return max(found, key=lambda each: _count(each.rows), default=None)


def _solved(
    story: Story,
    kernel: GeneralKernel,
    numbers: FloatArray,
    case: tuple[FloatArray, FloatArray, FloatArray],
) -> WholeExample | None:
    """The pose of joint values; None where its solutions or its roots are in doubt."""
    q, T, given = case
    chain, entries = story.algebra.chain, tuple(map(float, T[:3].ravel()))
    every, status = plain("general.rows").solve_whole(
        numbers, entries, given.copy(), np.zeros(chain.dof)
    )
    flat = np.array(entries)
    if kernel.pointing:
        plain("general.rows").any_turn(T[:3].copy(), flat)
    places = plain("general.candidates").PLACES
    loops, missing = np.empty((places, 6)), np.empty(places)
    count = plain("general.search").solve_loop(numbers, flat, given.copy(), loops, missing)
    certified = count > 0 and not (status == FREE_JOINT).any()
    found = _polynomial(kernel, numbers, flat, given) if certified else None
    if found is None:
        return None
    coefficients, roots, sign = found
    solved = every[status != UNREACHABLE]
    if story.nominal is not None:
        solved = placed_by_posture(chain, story.nominal, every)
    rows = turned_rows(chain, solved)
    followed = int(np.nanargmin(np.abs(without_turns(chain, rows - q)).max(axis=1)))
    own = kernel.asked
    asked = [number - 1 for number in kernel.numbers[:own]]
    values = chain.drives.values(rows[followed])[asked]
    off = np.exp(1j * loops[:count, :own]) - np.exp(1j * values)
    loop = loops[int(np.abs(off).max(axis=1).argmin())]
    gaps = np.abs(_values(kernel, roots) - _value(kernel, loop, sign))
    taken = int(gaps.argmin())
    if np.abs(off).max(axis=1).min() > SAME or gaps[taken] > SAME:
        return None
    inside = are_inside(chain, solved)
    return WholeExample(q, T, given, rows, inside, loop, followed, coefficients, roots, taken)


def _count(rows: FloatArray) -> int:
    """How many rows hold a solution."""
    return int((~np.isnan(rows).any(axis=1)).sum())


def _polynomial(
    kernel: GeneralKernel, numbers: FloatArray, flat: FloatArray, given: FloatArray
) -> tuple[FloatArray, FloatArray, float] | None:
    """Coefficients, real roots and the sense of the angle; None where roots are not simple."""
    loop, equations, roots = (plain(f"general.{name}") for name in ("loop", "equations", "roots"))
    links, nothing = loop.close(numbers, flat, given.copy()), np.zeros((4, 12))
    joints, sign, E = np.zeros(6, np.int64), 1.0, np.empty((0, 0))
    kind = roots.DETERMINANT if kernel.wrist is None and kernel.eliminations else roots.CLOSED_FORM
    if loop.vanishing(numbers, given.copy()) & 1:
        return None
    if kernel.wrist is not None:
        nothing[0, :] = loop.invert(links[4])
    else:
        joints, sign = loop.joints_of(numbers, 0), loop.sign_of(numbers, 0)
        links = loop.around(numbers, 0, links)
        if kernel.eliminations:
            E = equations.equations(numbers, joints, links)
        else:
            plain("general.four_turns").split_links(numbers, joints, links, nothing)
    good, found, counts = roots.real_roots(numbers, kind, E, joints, links, nothing)
    if not (good and counts[0]) or counts[1]:
        return None
    samples = np.empty(plain("general.tables").SAMPLES)
    roots.sample(numbers, kind, E, joints, links, nothing, 0.0, 0.0, samples)
    coefficients = plain("general.circle").fit(samples)[0][: 2 * HARMONICS + 1]
    simple = found[0, : counts[0]]
    if not kernel.hides_a_slide:
        c, s = kernel.loop.advances[hidden_joint(kernel)]
        coefficients = _turned(coefficients, float(sign), math.atan2(s, c))
        simple = wrap(sign * simple + math.atan2(s, c))
    return coefficients / np.abs(coefficients).max(), np.asarray(np.sort(simple)), float(sign)


def _turned(coefficients: FloatArray, sign: float, by: float) -> FloatArray:
    """The polynomial in x = sign y + by, from that in y."""
    m = np.arange(HARMONICS + 1)
    harmonics = coefficients[: HARMONICS + 1] + 0j
    harmonics[1:] -= 1j * sign * coefficients[HARMONICS + 1 :]
    harmonics = harmonics * np.exp(-1j * m * by)
    return np.concatenate([harmonics.real, -harmonics.imag[1:]])


def hidden_joint(kernel: GeneralKernel) -> int:
    """The joint of the loop, from 0, that the polynomial is in."""
    return 5 if kernel.wrist is not None else kernel.first.joints[0]


def _values(kernel: GeneralKernel, roots: FloatArray) -> NDArray[Any]:
    """The hidden joint at the roots: a length in arm sizes, or a point of the circle."""
    if not kernel.hides_a_slide:
        return np.asarray(np.exp(1j * roots))
    length = plain("general.equations").hidden_length
    return np.array([length(math.cos(root), math.sin(root)) for root in roots])


def _value(kernel: GeneralKernel, loop: FloatArray, sign: float) -> complex:
    """The value of a solution."""
    value = float(loop[hidden_joint(kernel)])
    if kernel.hides_a_slide:
        return sign * value / kernel.loop.size
    return complex(math.cos(value), math.sin(value))
