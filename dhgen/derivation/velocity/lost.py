"""Which motion of the tool an arm loses where a factor of the determinant vanishes.

There the rows of the Jacobian are dependent: a force and a moment exist that do no work with any
joint. Where they are one force through a frame's origin, that point's velocity is lost along it; a
moment alone, turning about it. Of any other pair, the velocity along the force is lost while the
tool does not turn, and turning about the moment at a point while that point is at rest. What is
named holds at all postures that were drawn.
"""

from __future__ import annotations

import math
import random
from dataclasses import dataclass, replace
from functools import lru_cache, partial
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.notation.names import letter
from dhgen.derivation.text.blocks import Given, say
from dhgen.derivation.text.words import joined
from dhgen.derivation.velocity.posture import Posture, exact_value, spins_that_count
from dhgen.kinematics.chain import parallel_groups
from dhgen.robot.task import TaskKind

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Prose
    from dhgen.derivation.text.formula import Formula

POSTURES = 3
PLANAR = 3  # parallel axes that move a point in a plane and turn it there
TRIES = 12
STEPS = 12  # of a turn, where a sign change is looked for
HALVINGS = 30
CLEAR = 1e-3  # of the least singular value but one: nothing else is lost there
NEAR = 1e-6  # what is zero, of singular values, unit vectors and of lengths in arm sizes

# Joint values, angles as the formulas have them.
Values = dict[int, float]
Elsewhere = tuple[int, int] | None


@dataclass(frozen=True, slots=True)
class _Wrench:
    """What does no work, in the base's frame, lengths in arm sizes.

    Attributes:
        force: At the tool's origin.
        moment: About the tool's origin.
        frames: Frames 0 to n and the tool's, (n + 2, 3, 4).
        columns: What the joints that are solved for give the tool, the task's rows.
    """

    force: FloatArray
    moment: FloatArray
    frames: FloatArray
    columns: FloatArray

    def seen_from(self, frame: int) -> FloatArray:
        """The origins of all frames in one of them, (n + 2, 3)."""
        own = self.frames[frame]
        return np.asarray((self.frames[..., 3] - own[:, 3]) @ own[:, :3])

    def moment_about(self, frame: int) -> FloatArray:
        """The moment about a frame's origin."""
        arm = self.frames[-1][:, 3] - self.frames[frame][:, 3]
        return self.moment + np.cross(arm, self.force)


def lost_motion(
    story: Story, factor: Formula, others: Sequence[Formula], elsewhere: Elsewhere = None
) -> Prose | None:
    """The motion that is lost where a formula vanishes; None where it has no short name.

    Args:
        story: The arm.
        factor: A factor of the determinant.
        others: The other factors, which do not vanish there.
        elsewhere: A frame, and that of which the origin's velocity counts; None for the tool's.
    """
    wrenches = [wrench for (wrench,) in _wrenches(story, factor, others, elsewhere, 1)]
    if len(wrenches) < POSTURES:
        pairs = _wrenches(story, factor, others, elsewhere, 2)
        return _lost_velocities(story, list(pairs))
    if all(np.linalg.norm(each.force) < NEAR for each in wrenches):
        axis = _axis(story, wrenches, lambda each: each.moment)
        return None if axis is None else say("turning about {}", axis)
    points = _points(story, wrenches)
    point = next((k for k in points if all(_is_force_at(w, k) for w in wrenches)), None)
    if point is not None:
        return _lost_velocity(story, wrenches, point)
    turning = _lost_turning(story, wrenches, sorted(_wrist_frames(story)))
    if turning is not None:
        return turning
    axis = _axis(story, wrenches, _force)
    if axis is not None:
        return say("with the orientation kept, the velocity along {}", axis)
    turning = _lost_turning(story, wrenches, points)
    if turning is not None:
        return turning
    away = [frame for frame in range(story.dof + 1) if frame not in points]
    point = next((k for k in away if all(_is_force_at(w, k) for w in wrenches)), None)
    if point is not None:
        return _lost_velocity(story, wrenches, point)
    return _lost_turning(story, wrenches, away) or _lost_by_parallel_axes(story, wrenches)


def _lost_by_parallel_axes(story: Story, wrenches: list[_Wrench]) -> Prose | None:
    """The velocity that three joints about parallel axes in one plane don't give."""
    chain = story.algebra.chain
    places = {joint.number: place for place, joint in enumerate(chain.solved)}
    if chain.task.kind is not TaskKind.POSE:
        return None
    for run in parallel_groups(chain):
        if len(run) < PLANAR or not {joint for joint, _ in run} <= {*places}:
            continue
        columns = [places[joint] for joint, _ in run]

        def along(each: _Wrench, columns: list[int] = columns) -> FloatArray:
            """At right angles to all that they give without turning; zero where there is none."""
            own = each.columns[:, columns]
            z = own[3:, 0]
            rates = own[3:].T @ z
            slides = rates * own[:3] - own[:3, :1]
            left, sizes, _ = np.linalg.svd(slides)
            return np.cross(left[:, 0], z) if sizes[1] < NEAR else np.zeros(3)

        if any(np.linalg.norm(along(each)) < CLEAR for each in wrenches):
            continue
        axis = _axis(story, wrenches, along)
        if axis is not None:
            joints = joined([str(joint) for joint, _ in run])
            text = f"without turning, the velocity along {{}} that joints {joints} give"
            return say(text, axis)
    return None


def _lost_turning(story: Story, wrenches: list[_Wrench], points: list[int]) -> Prose | None:
    """The turning that a moment resists, with a frame's origin at rest."""
    for point in points:
        axis = _axis(story, wrenches, lambda each, at=point: each.moment_about(at))  # type: ignore[misc]
        if axis is not None:
            text = "with {} at rest, turning about {}"
            return say(text, point_name(story, point), axis)
    return None


def _lost_velocity(story: Story, wrenches: list[_Wrench], point: int) -> Prose | None:
    """The velocity that a force through a frame's origin resists."""
    named = point_name(story, point)
    axis = _axis(story, wrenches, _force)
    if axis is not None:
        return say("the velocity of {} along {}", named, axis)
    starts = (k for k in range(story.dof + 1) if all(_leads(w, k, point) for w in wrenches))
    start = next(starts, None)
    if start is None:
        return say("one velocity of {}, along no axis of a frame", named)
    text = "the velocity of {} along the line to the origin of frame {}"
    return say(text, named, Given(str(start)))


def _lost_velocities(story: Story, pairs: list[tuple[_Wrench, ...]]) -> Prose | None:
    """The velocities that all forces through a frame's origin across an axis resist."""
    if len(pairs) < POSTURES:
        return None
    first = [pair[0] for pair in pairs]
    every = [wrench for pair in pairs for wrench in pair]
    points = _points(story, first)
    point = next((k for k in points if all(_is_force_at(w, k) for w in every)), None)
    across = [replace(a, force=np.cross(a.force, b.force)) for a, b in pairs]
    left = _axis(story, across, _force, "z") or _axis(story, across, _force)
    if point is None or left is None:
        return None
    return say("every velocity of {} but along {}", point_name(story, point), left)


def _force(wrench: _Wrench) -> FloatArray:
    return wrench.force


def _points(story: Story, wrenches: list[_Wrench]) -> list[int]:
    """Frames whose origins move with the tool, the tool's own first."""
    held = _held(wrenches, -1)
    return [frame for frame in reversed(range(story.dof + 2)) if held[frame]]


def _held(wrenches: list[_Wrench], frame: int) -> NDArray[np.bool_]:
    """Which frames' origins have one place in a frame, at all postures."""
    first, *others = (each.seen_from(frame) for each in wrenches)
    moved = np.max([np.linalg.norm(each - first, axis=1) for each in others], axis=0)
    return np.asarray(moved < NEAR)


def _is_force_at(wrench: _Wrench, frame: int) -> bool:
    return bool(np.linalg.norm(wrench.moment_about(frame)) < NEAR)


def _wrenches(
    story: Story, factor: Formula, others: Sequence[Formula], elsewhere: Elsewhere, count: int
) -> Iterator[tuple[_Wrench, ...]]:
    """Those of some postures where the formula vanishes, and so many motions are lost by it."""
    source = random.Random(3)  # noqa: S311 - postures, no secrets
    given, named = _given_values(story, source), _named_rows(story, elsewhere)
    found = 0
    for _ in range(TRIES):
        values = _singular_values_of_joints(story, factor, given, source)
        if values is None:
            continue
        letters = _posture(story, values).letters()
        if any(abs(float(exact_value(other, letters))) < NEAR for other in others):
            continue  # as those of a folded arm with links of one length do
        lost = _lost(story, values, named, elsewhere)
        if len(lost) == count:
            yield lost
            found += 1
        if found == POSTURES:
            return


def _posture(story: Story, values: Values) -> Posture:
    chain = story.algebra.chain
    turns = {j: (math.cos(x), math.sin(x)) for j, x in values.items()}
    return Posture(story, turns, values, {c.name: c.value for c in chain.constants})


def _reach(story: Story) -> Values:
    """How far each joint's value is looked for on both sides of zero."""
    chain = story.algebra.chain
    return {j: math.pi if turns else chain.size for j, turns in enumerate(chain.turning, start=1)}


def _given_values(story: Story, source: random.Random) -> Values:
    """Random values of the joints that are given: what is behind them is one body with the tool."""
    reach = _reach(story)
    return {j: source.uniform(-reach[j], reach[j]) for j in story.algebra.chain.free}


def _singular_values_of_joints(
    story: Story, factor: Formula, given: Values, source: random.Random
) -> Values | None:
    """Random values of all joints but one, which makes the formula zero, and of those given."""
    reach = _reach(story)
    values = {j: source.uniform(-most, most) for j, most in reach.items()} | given

    def at(joint: int, value: float) -> float:
        letters = _posture(story, {**values, joint: value}).letters()
        return float(exact_value(factor, letters))

    for joint in sorted(values, key=lambda _: source.random()):
        if joint in given:
            continue
        step = 2.0 * reach[joint] / STEPS
        ends = [-reach[joint] + step * (k + 0.37) for k in range(STEPS)]
        signs = [at(joint, end) for end in ends]
        changes = [k for k in range(STEPS - 1) if signs[k] * signs[k + 1] < 0.0]
        if changes:
            k = source.choice(changes)
            return {**values, joint: _bisected(partial(at, joint), ends[k], ends[k + 1])}
    return None


def _bisected(function: Callable[[float], float], low: float, high: float) -> float:
    rising = function(low) < 0.0
    for _ in range(HALVINGS):
        middle = 0.5 * (low + high)
        if (function(middle) < 0.0) == rising:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def _named_rows(story: Story, elsewhere: Elsewhere) -> NDArray[np.intp]:
    """The rows of the Jacobian that are not zero for every posture, as those of a plane's z are."""
    source = random.Random(4)  # noqa: S311 - a posture, no secret
    values = {j: source.uniform(-most, most) for j, most in _reach(story).items()}
    return np.flatnonzero(np.abs(_jacobian(story, values, elsewhere)).max(axis=1) > NEAR)


def _jacobian(story: Story, values: Values, elsewhere: Elsewhere) -> FloatArray:
    """The Jacobian, perhaps seen from a frame for the velocity of one's origin, in arm sizes."""
    chain, posture = story.algebra.chain, _posture(story, values)
    J = np.array(posture.jacobian(), float)
    if elsewhere is not None:  # of whole poses alone
        frames = np.array(posture.frames()[0], float)
        frame, centre = elsewhere
        J[:3] += np.cross(J[3:].T, (frames[centre] - frames[-1])[:, 3]).T
        J = np.vstack([frames[frame][:, :3].T @ J[:3], frames[frame][:, :3].T @ J[3:]])
    J *= [1.0 if chain.turning[joint.number - 1] else chain.size for joint in chain.solved]
    J[: len(chain.task.position_rows)] /= chain.size
    return J


def _lost(
    story: Story, values: Values, named: NDArray[np.intp], elsewhere: Elsewhere
) -> tuple[_Wrench, ...]:
    """What does no work, each at right angles to the others; none where that is in doubt.

    Args:
        story: The arm.
        values: Its joints.
        named: The rows of the Jacobian that the task asks for.
        elsewhere: A frame, and that of which the origin's velocity counts.
    """
    chain = story.algebra.chain
    own = _posture(story, values).frames()[0]
    directions = spins_that_count(story, own)
    frames = np.array(own, float)
    frames[..., 3] /= chain.size
    rows = len(chain.task.position_rows)
    J = _jacobian(story, values, elsewhere)
    U, s, _ = np.linalg.svd(J[named])
    if np.any((s > NEAR) & (s < CLEAR)):
        return ()
    found = []
    for column in U[:, s <= NEAR].T:
        whole = np.zeros(len(J))
        whole[named] = column
        force, moment = np.zeros(3), np.zeros(3)
        force[list(chain.task.position_rows)] = whole[:rows]
        if directions:
            moment = np.array(directions, float).T @ whole[rows:]
        if elsewhere is not None:
            turned = frames[elsewhere[0]][:, :3]
            force, moment = turned @ force, turned @ moment
            moment += np.cross(frames[elsewhere[1]][:, 3] - frames[-1][:, 3], force)
        found.append(_Wrench(force, moment, frames, J))
    return tuple(found)


def _axis(
    story: Story,
    wrenches: list[_Wrench],
    vector: Callable[[_Wrench], FloatArray],
    names: str = "xyz",
) -> Formula | None:
    """The first axis of a frame, of those with given names, that vectors are along everywhere."""
    for frame in range(story.dof + 1):
        for name in names:
            column = "xyz".index(name)
            if all(_are_parallel(vector(w), w.frames[frame][:, column]) for w in wrenches):
                return letter(name, name, str(frame))
    return None


def _are_parallel(a: FloatArray, b: FloatArray) -> bool:
    return bool(np.linalg.norm(np.cross(a, b)) < NEAR)


def _leads(wrench: _Wrench, start: int, end: int) -> bool:
    """Whether the force is along the line between two origins."""
    line = wrench.frames[end][:, 3] - wrench.frames[start][:, 3]
    return bool(np.linalg.norm(line) > CLEAR) and _are_parallel(line, wrench.force)


@lru_cache(maxsize=8)
def _wrist_frames(story: Story) -> frozenset[int]:
    """Frames whose origins are the wrist centre, where the arm has one.

    The arm before the wrist holds it, and so does the tool.
    """
    if story.wrist is None:
        return frozenset()
    held = _held(_seen(story), story.wrist[0] - 1)
    return _tool_frames(story) & frozenset(np.flatnonzero(held).tolist())


@lru_cache(maxsize=8)
def _tool_frames(story: Story) -> frozenset[int]:
    """Frames whose origins the tool holds."""
    return frozenset(np.flatnonzero(_held(_seen(story), -1)).tolist())


def _seen(story: Story) -> list[_Wrench]:
    """The frames at postures that are not singular."""
    source, reach = random.Random(5), _reach(story)  # noqa: S311 - postures, no secrets
    given = _given_values(story, source)
    seen = []
    for _ in range(POSTURES):
        values = {j: source.uniform(-most, most) for j, most in reach.items()} | given
        frames = np.array(_posture(story, values).frames()[0], float)
        frames[..., 3] /= story.algebra.chain.size
        nothing = np.zeros(3)
        seen.append(_Wrench(nothing, nothing, frames, np.zeros((6, 0))))
    return seen


def point_name(story: Story, frame: int) -> Prose:
    """What the tool's point at the origin of a frame is called; the last is the tool's own."""
    if frame in _wrist_frames(story):
        return say("the wrist centre")
    if frame > story.dof:
        return say("the tool's origin")
    if frame in _tool_frames(story):
        return say("the origin of frame {}", Given(str(frame)))
    return say("the point of the tool at the origin of frame {}", Given(str(frame)))
