"""The names of rows: what a person sees of the arm, found by looking at the solutions of poses.

The sign of the elbow's step alone does not determine which elbow is up: where the arm reaches over
itself it is the other one, so that the name goes by the product of two signs (Lee and Ziegler 1984,
ARM and ELBOW). Which signs these are is found here: a name is taken where every solution of every
sample pose looks like it, and "elbow+" or "shoulder+" elsewhere.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import combinations
from typing import TYPE_CHECKING

import numpy as np

from dhgen.descriptions.misses import GAP
from dhgen.kinematics.algebra import AngleSum
from dhgen.kinematics.numeric import numeric_arm
from dhgen.paul.kind import Part
from dhgen.program.interpret import interpret

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from dhgen.arrays import FloatArray
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.numeric import NumericArm
    from dhgen.paul.derivation import Derivation
    from dhgen.paul.step import Step
    from dhgen.program.ir import Axis, Program

SAMPLES = 60
FEWEST = 20  # solutions that have to show a posture
EXACT = 1e-9  # of the arm's size, or of 1: what counts as zero
CLEAR = 1e-4  # of the arm's size: nearer to the border of two postures nothing is seen


@dataclass(frozen=True, slots=True)
class Look:
    """What rows look like.

    Attributes:
        words: Of rows with 1, and with -1.
        seen: 1 or -1, shape (poses, rows); 0 where nothing is seen.
    """

    words: tuple[str, str]
    seen: FloatArray


def with_postures(
    program: Program, derivation: Derivation, zero: Sequence[float] | None = None
) -> Program:
    """A solver whose rows have the names of what is seen of them.

    Args:
        program: The solver.
        derivation: What it does.
        zero: The joint values at which the arm stands as people know it; None where these are zero.
    """
    chain = derivation.problem.algebra.chain
    steps = [derivation.steps[axis.step - 1] for axis in program.axes]
    axes = [
        replace(axis, meaning=_WORDS[_part(chain, step)]) if axis.count == 2 else axis
        for axis, step in zip(program.axes, steps, strict=True)
    ]
    watched = [
        place
        for place, axis in enumerate(axes)
        if axis.count == 2 and axis.meaning != _WORDS["wrist"]
    ]
    found = _solutions(program, derivation, zero) if watched else None
    if found is not None and not np.isnan(found.q).all():
        for place in watched:
            if (look := _look(found, steps[place], place, program)) is not None:
                axes[place] = _named(axes, place, look)
    return replace(program, axes=tuple(_distinguished(axes, steps)))


_WORDS = {
    "shoulder": ("shoulder+", "shoulder-"),
    "elbow": ("elbow+", "elbow-"),
    "slide": ("slide+", "slide-"),
    "wrist": ("noflip", "flip"),
}
"""Of the values of a sign, + first, where nothing is seen of them."""

WRIST = 3  # joints that turn the tool


def _part(chain: Chain, step: Step) -> str:
    """The part of the arm that the two values of a step place."""
    part, joint = step.kind.value.part, _joint(step)
    if part is not Part.END:
        return str(part.value)
    places = bool(chain.task.position_rows)
    if joint == 1 and places:
        return "shoulder"
    return "wrist" if _turns_the_tool(chain, joint) else "elbow"


def _turns_the_tool(chain: Chain, joint: int) -> bool:
    """Whether a joint is one of a wrist's: it turns the tool, and carries no link with an axis.

    Of an arm that is asked for positions no joint is, nor one whose next axis is parallel.
    """
    turning = [number for number, turns in enumerate(chain.turning, 1) if turns]
    if not chain.task.directions.dimension or joint not in turning[-WRIST:]:
        return False
    if joint == turning[-1]:
        return True
    directions, _ = numeric_arm(chain).axes(np.zeros(chain.dof))
    after = turning[turning.index(joint) + 1]
    return bool(np.linalg.norm(np.cross(directions[joint - 1], directions[after - 1])) > EXACT)


def _joint(step: Step) -> int:
    """The joint that is placed: of a sum of angles the first for an elbow, else the last."""
    unknown = step.unknowns[0]
    if not isinstance(unknown, AngleSum):
        return unknown.joint
    return unknown.terms[0 if step.kind.is_two_links else -1][0]


def _distinguished(axes: list[Axis], steps: list[Step]) -> Iterator[Axis]:
    """Words that two axes have in common get the number of a joint, or of a sum's joints."""
    words = [axis.meaning for axis in axes]
    joints = [(a.meaning, _joint(step)) for a, step in zip(axes, steps, strict=True)]
    for axis, step in zip(axes, steps, strict=True):
        if axis.count == 2 and words.count(axis.meaning) > 1:
            joint = _joint(step)
            alone = joints.count((axis.meaning, joint)) == 1
            number = str(joint) if alone else _joints(step)
            yield replace(axis, meaning=tuple(_numbered(word, number) for word in axis.meaning))
        else:
            yield axis


def _joints(step: Step) -> str:
    """The joints of a step's angle: 23 of a sum of two."""
    unknown = step.unknowns[0]
    terms = unknown.terms if isinstance(unknown, AngleSum) else ((unknown.joint, 1),)
    return "".join(str(joint) for joint, _ in terms)


def _numbered(word: str, number: str) -> str:
    sign = word[-1] if word[-1] in "+-" else ""
    return f"{word.removesuffix(sign)}{number}{sign}"


# ------------------------------------------------------------------------------- sample poses


@dataclass(frozen=True, slots=True)
class Solutions:
    """Solutions of sample poses, and where the arm's axes are in them.

    Attributes:
        arm: The arm.
        q: Joint values (poses, rows, n), NaN where there is no solution.
        directions: Of the axes in the caller's frame, (poses, rows, n, 3); behind them are those of
            passive rows.
        points: A point of each axis, of the same shape.
        tool: The tool's origin, (poses, rows, 3).
        zero: The joint values at which the arm stands as people know it, (n,).
    """

    arm: NumericArm
    q: FloatArray
    directions: FloatArray
    points: FloatArray
    tool: FloatArray
    zero: FloatArray

    @property
    def size(self) -> float:
        """The arm's size [length]."""
        return self.arm.chain.size

    def turns(self, joint: int) -> bool:
        """Whether there is a joint of this number, from 1, and it turns."""
        return 1 <= joint <= self.arm.chain.dof and self.arm.chain.turning[joint - 1]

    def next_turning(self, joint: int, step: int) -> int:
        """The next joint that turns, upwards or downwards; 0 or beyond the last without one."""
        joint += step
        while 1 <= joint <= self.arm.chain.dof and not self.turns(joint):
            joint += step
        return joint

    def axis(self, joint: int) -> FloatArray:
        """Directions of an axis, (poses, rows, 3)."""
        return self.directions[..., joint - 1, :]

    def point(self, joint: int) -> FloatArray:
        """Points of an axis, (poses, rows, 3)."""
        return self.points[..., joint - 1, :]

    def parallel(self, joint: int, other: int) -> bool:
        """Whether two axes are parallel in all solutions."""
        crossed = np.cross(self.axis(joint), self.axis(other))
        return bool(np.nanmax(np.abs(crossed)) < EXACT)

    def nearest(self, joint: int, other: int) -> FloatArray:
        """The point of an axis that is nearest to another one; any where they are parallel."""
        if self.parallel(joint, other):
            return self.point(joint)
        u, v = self.axis(joint), self.axis(other)
        gap = self.point(other) - self.point(joint)
        uv = _dot(u, v)
        along = (_dot(gap, u) - uv * _dot(gap, v)) / (1.0 - uv * uv)
        return self.point(joint) + along[..., None] * u


def _solutions(program: Program, derivation: Derivation, zero: Sequence[float] | None) -> Solutions:
    chain = derivation.problem.algebra.chain
    arm = numeric_arm(chain)
    reach = [np.pi if turns else chain.size for turns in chain.turning]
    source = np.random.default_rng(11)
    q = source.uniform(-1.0, 1.0, (SAMPLES, chain.dof)) * reach
    given = q[:, [joint - 1 for joint in chain.free]]
    if chain.arm_angle:
        given = source.uniform(-np.pi, np.pi, (SAMPLES, 1))
    # what rows are called, the formulas show; it takes far longer to split those that nearly meet
    formulas = replace(program, completion=None, refinement=None)
    rows = interpret(formulas, arm.pose(q), q, given)
    found = np.where((rows.free | rows.close)[..., None], np.nan, rows.q)
    return _drawn(arm, found, np.zeros(chain.dof) if zero is None else np.array(zero))


def _drawn(arm: NumericArm, q: FloatArray, zero: FloatArray) -> Solutions:
    return Solutions(arm, q, *arm.all_axes(q), arm.pose(q)[..., :3, 3], zero)


# ------------------------------------------------------------------------------- what is seen


def _look(found: Solutions, step: Step, place: int, program: Program) -> Look | None:
    part = _part(found.arm.chain, step)
    if part == "slide":
        return _slide(found, step.lengths[0].joint, place, program)
    if part == "elbow":
        return _elbow(found, _joint(step))
    return _shoulder(found) if part == "shoulder" else None


def _slide(found: Solutions, joint: int, place: int, program: Program) -> Look:
    """Whether a slide is farther out than in the row with the other sign."""
    counts = [axis.count for axis in program.axes]
    values = found.q[..., joint - 1].reshape(len(found.q), *counts)
    apart = (values - np.flip(values, place + 1)).reshape(len(found.q), -1)
    return Look(("forward", "backward"), _seen(apart, found.size))


def _elbow(found: Solutions, joint: int) -> Look | None:
    """On which side the elbow is of the line from the shoulder to what comes after the elbow."""
    pairs = [(found.next_turning(j, -1), j) for j in (joint, found.next_turning(joint, 1))]
    pair = next((each for each in pairs if _bends(found, *each)), None)
    if pair is None:
        return None
    shoulder, elbow = pair
    axis = found.axis(elbow)
    line = _across(_end_of_forearm(found, elbow) - found.point(shoulder), axis)
    away = _across(found.point(elbow) - found.point(shoulder), axis)
    upright = np.abs(axis[..., 2])
    if np.nanmin(upright) > 1.0 - EXACT:
        # seen from above, on the way from the shoulder to the end
        side = line[..., 0] * away[..., 1] - line[..., 1] * away[..., 0]
        return Look(("left", "right"), _seen(side, found.size**2))
    if np.nanmax(upright) > EXACT:
        return None
    off = away - (_dot(away, line) / _dot(line, line))[..., None] * line
    seen = np.where(_reaches_back(found, line), 0.0, _seen(off[..., 2], found.size))
    return Look(("up", "down"), seen)


def _bends(found: Solutions, shoulder: int, elbow: int) -> bool:
    """Whether there are two joints that turn about parallel axes, apart from each other."""
    if not (found.turns(shoulder) and found.turns(elbow) and found.parallel(shoulder, elbow)):
        return False
    gap = _across(found.point(elbow) - found.point(shoulder), found.axis(elbow))
    return bool(np.nanmin(np.abs(gap).max(axis=-1)) > EXACT * found.size)


def _end_of_forearm(found: Solutions, elbow: int) -> FloatArray:
    """The next axis where that is parallel, else the wrist's centre, else the tool."""
    passive = found.arm.passive_behind(elbow)
    if passive is not None and found.parallel(elbow, passive):
        return found.point(passive)
    after = found.next_turning(elbow, 1)
    if not found.turns(after):
        return found.tool
    if found.parallel(elbow, after):
        return found.point(after)
    further = found.next_turning(after, 1)
    return found.nearest(after, further) if found.turns(further) else found.tool


def _reaches_back(found: Solutions, line: FloatArray) -> FloatArray | bool:
    """Whether the line from the shoulder to the end points back, seen from where the wrist is.

    So it does where the wrist is nearer to axis 1 than the shoulder.
    """
    wrist = _wrist(found)
    if wrist is None:
        return False
    ahead = np.cross(found.axis(2), found.axis(1))
    return np.asarray(_dot(wrist, ahead) * _dot(line, ahead) < CLEAR * found.size**2)


def _shoulder(found: Solutions) -> Look | None:
    """Where the plane of the arm is, seen along the way from axis 1 to the wrist.

    Beside axis 1 where the shoulder has an offset, more than a calibration brings: the arm is a
    left or a right one. Otherwise the arm faces the wrist or reaches over itself.
    """
    if not found.turns(1) or not found.turns(2):
        return None
    first, across = found.axis(1), found.axis(2)
    if np.nanmax(np.abs(_dot(first, across))) > EXACT or np.nanmax(np.abs(first[..., :2])) > EXACT:
        return None
    wrist = _wrist(found)
    if wrist is None:
        return None
    ahead = np.cross(across, first)  # horizontal, in the plane of the arm
    beside, reach = _dot(wrist, across), _dot(wrist, ahead)
    if np.nanmax(np.abs(beside)) > GAP * found.size:
        # who looks ahead has the axis `across` on the left if axis 1 points up
        seen = _seen(first[..., 2] * beside * reach, found.size**2)
        return Look(("left", "right"), seen)
    return Look(("front", "back"), _seen(_faces(found, ahead) * reach, found.size))


def _wrist(found: Solutions) -> FloatArray | None:
    """From axis 1 to the last point of the arm that is always as far beside axis 1."""
    place = _wrist_place(found)
    return None if place is None else _points_after_2(found)[place]


def _wrist_place(found: Solutions) -> int | None:
    """Which of the points after joint 2 that is."""
    if not (found.turns(1) and found.turns(2)) or found.parallel(1, 2):
        return None
    beside = [_dot(point, found.axis(2)) for point in _points_after_2(found)]
    kept = [np.nanmax(each) - np.nanmin(each) < EXACT * found.size for each in beside]
    return max((place for place, keep in enumerate(kept) if keep), default=None)


def _points_after_2(found: Solutions) -> list[FloatArray]:
    """From axis 1 to points of axes, to where neighbours are nearest, and to the tool."""
    last = found.arm.chain.dof
    points = []
    for joint in range(3, last + 1):
        points.append(found.point(joint))
        if found.turns(joint) and found.turns(joint + 1):
            points.append(found.nearest(joint, joint + 1))
    return [point - found.point(1) for point in (*points, found.tool)]


def _faces(found: Solutions, ahead: FloatArray) -> float:
    """1 if the arm faces ahead, -1 if it faces the other way.

    It faces where its shoulder is; one that is on axis 1, where its wrist is when all joint values
    are zero; and one that is upright then, where the base's x axis goes with joint 1. An offset
    that only a calibration brings moves no shoulder off axis 1.
    """
    shoulder = float(np.nanmean(_dot(found.point(2) - found.point(1), ahead)))
    if abs(shoulder) > GAP * found.size:
        return float(np.sign(shoulder))
    zero = _drawn(found.arm, found.zero[None, None], found.zero)
    forward = np.cross(zero.axis(2), zero.axis(1))
    place = _wrist_place(found)
    assert place is not None
    at_zero = float(_dot(_points_after_2(zero)[place], forward)[0, 0])
    if abs(at_zero) > CLEAR * found.size:
        return float(np.sign(at_zero))
    x, y, _ = forward[0, 0]
    return 1.0 if x > EXACT or (x > -EXACT and y > 0.0) else -1.0


def _dot(u: FloatArray, v: FloatArray) -> FloatArray:
    return np.asarray((u * v).sum(axis=-1))


def _across(vector: FloatArray, axis: FloatArray) -> FloatArray:
    """The part of a vector that is perpendicular to an axis."""
    return np.asarray(vector - _dot(vector, axis)[..., None] * axis)


def _seen(value: FloatArray, unit: float) -> FloatArray:
    clear = np.abs(np.nan_to_num(value)) > CLEAR * unit
    return np.where(clear, np.sign(value), 0.0)


# ------------------------------------------------------------------------------- which signs


def _named(axes: list[Axis], place: int, look: Look) -> Axis:
    """An axis with the words of a look, if the look goes by a product of signs."""
    axis = axes[place]
    counts = [each.count for each in axes]
    others = [p for p, count in enumerate(counts) if count == 2 and p != place]
    grids = np.meshgrid(*(np.arange(count) for count in counts), indexing="ij")
    signs = [1.0 - 2.0 * grid.reshape(-1) for grid in grids]
    if np.count_nonzero(look.seen) < FEWEST:
        return axis
    for count in range(len(others) + 1):
        for factors in combinations(others, count):
            product = look.seen * np.prod([signs[p] for p in (place, *factors)], axis=0)
            shown = np.unique(product[product != 0.0])
            if len(shown) == 1:
                plus, minus = look.words if shown[0] > 0.0 else look.words[::-1]
                return replace(axis, meaning=(plus, minus), factors=factors)
    return axis
