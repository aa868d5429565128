"""An arm at joint values as lines, axes and frames in space."""

from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum
from typing import TYPE_CHECKING

import numpy as np

from dhgen.derivation.notation.names import letter, single, theta
from dhgen.derivation.text.show import show
from dhgen.derivation.text.style import PLAIN
from dhgen.derivation.text.walk import begins_negative
from dhgen.kinematics.chain import Fixed
from dhgen.kinematics.normal import normal_form
from dhgen.kinematics.numeric import numeric_arm
from dhgen.kinematics.ring import terms_in_numbers
from dhgen.kinematics.transform import inverse
from dhgen.robot.robot import Convention, DhTable

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.arrays import FloatArray
    from dhgen.derivation.story import Story
    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.numeric import NumericArm
    from dhgen.kinematics.transform import Transform

NOTHING = 1e-9  # of the arm's size


class Part(Enum):
    """What a line of the arm is."""

    BASE = "base"  # from the caller's frame to the arm's
    LINK = "link"
    SLIDE = "slide"  # as long as a joint's value
    TOOL = "tool"


@dataclass(frozen=True, slots=True)
class Member:
    """A straight piece of the arm.

    Attributes:
        part: What it is.
        after: How many joints are before it.
        start: Where it begins, (3,).
        end: Where it ends, (3,).
        name: How the formulas call its length.
    """

    part: Part
    after: int
    start: FloatArray
    end: FloatArray
    name: str

    @property
    def along(self) -> FloatArray:
        """From its start to its end."""
        return self.end - self.start


@dataclass(frozen=True, slots=True)
class Axis:
    """A joint in space.

    Attributes:
        number: From 1.
        turns: Whether it turns; it slides otherwise.
        origin: The origin of the frame that it moves in, (3,).
        z: The direction of its axis, (3,).
        x: A direction across, (3,).
        name: How its axis is called.
        value: How the formulas call its angle or length.
    """

    number: int
    turns: bool
    origin: FloatArray
    z: FloatArray
    x: FloatArray
    name: str
    value: str


@dataclass(frozen=True, slots=True)
class Skeleton:
    """An arm at joint values.

    Attributes:
        base: The arm's base frame, (4, 4).
        members: From the base to the tool.
        axes: The joints' axes, in order.
        frames: Frames 0 to n, each (4, 4).
        tool: The tool frame, (4, 4).
    """

    base: FloatArray
    members: tuple[Member, ...]
    axes: tuple[Axis, ...]
    frames: tuple[FloatArray, ...]
    tool: FloatArray

    @property
    def points(self) -> FloatArray:
        """Where members begin and end, from the caller's frame on, (m + 1, 3)."""
        first = self.members[0].start if self.members else self.base[:3, 3]
        return np.array([first, *(member.end for member in self.members)])


def scaled(arm: Skeleton, scale: float) -> Skeleton:
    """The arm with all lengths times a number."""
    scaling = np.ones((4, 4))
    scaling[:3, 3] = scale
    return replace(
        arm,
        base=arm.base * scaling,
        members=tuple(replace(m, start=m.start * scale, end=m.end * scale) for m in arm.members),
        axes=tuple(replace(axis, origin=axis.origin * scale) for axis in arm.axes),
        frames=tuple(frame * scaling for frame in arm.frames),
        tool=arm.tool * scaling,
    )


@dataclass(frozen=True, slots=True)
class _Piece:
    """A length along an axis of a frame.

    Attributes:
        vector: In the frame before it, (3,).
        name: How the formulas call it.
    """

    vector: FloatArray
    name: str


@dataclass(frozen=True, slots=True)
class _Still:
    """A constant transform, with the lengths in it one after the other."""

    part: Part
    matrix: FloatArray
    pieces: tuple[_Piece, ...]


class Skeletons:
    """An arm that can be looked at for many joint values."""

    def __init__(self, story: Story) -> None:
        chain = story.algebra.chain
        self._arm = numeric_arm(chain)
        still = _Reader(story).still
        self._base = still(chain.base, self._arm.base, Part.BASE)
        self._tool = still(chain.tool, self._arm.tool, Part.TOOL)
        matrices = iter(self._arm.elements)
        self._links: list[list[_Still | int]] = []
        for link in chain.links:
            self._links.append([])
            for element, matrix in zip(link, matrices, strict=False):
                if isinstance(element, Fixed) and not isinstance(matrix, int):
                    self._links[-1].append(still(element.transform, matrix, Part.LINK))
                elif isinstance(matrix, int):
                    self._links[-1].append(matrix)
        self._standard = is_standard(story)

    def at(self, q: FloatArray) -> Skeleton:
        """The arm at joint values."""
        walk = _Walk(self._arm, q, standard=self._standard)
        walk.pass_by(self._base)
        base = walk.T
        frames = [base]
        for link in self._links:
            for element in link:
                if isinstance(element, _Still):
                    walk.pass_by(element)
                else:
                    walk.move(element)
            frames.append(walk.T)
        walk.pass_by(self._tool)
        return Skeleton(base, tuple(walk.members), tuple(walk.axes), tuple(frames), walk.T)


class _Walk:
    """Goes from the base to the tool and keeps what it passes."""

    def __init__(self, arm: NumericArm, q: FloatArray, *, standard: bool) -> None:
        self.chain, self.standard = arm.chain, standard
        self.steps = arm.steps(np.asarray(q, np.float64))
        self.T: FloatArray = np.eye(4)
        self.members: list[Member] = []
        self.axes: list[Axis] = []

    def move(self, number: int) -> None:
        """A joint; a passive row, numbered behind them, has no axis of its own in figures."""
        if number > self.chain.dof:
            self.T = self.T @ self.steps[number - 1]
            return
        turns = self.chain.turning[number - 1]
        name = letter("z", "z", str(number - self.standard)).text
        value = theta(single(number)).text if turns else letter("r", "r", str(number)).text
        origin, x, z = self.T[:3, 3], self.T[:3, 0], self.T[:3, 2]
        self.axes.append(Axis(number, turns, origin, z, x, name, value))
        self.T = self.T @ self.steps[number - 1]
        self._member(Part.SLIDE, origin, self.T[:3, 3], value)

    def pass_by(self, still: _Still) -> None:
        """A constant transform."""
        at = self.T[:3, 3]
        for piece in still.pieces:
            after = at + self.T[:3, :3] @ piece.vector
            self._member(still.part, at, after, piece.name)
            at = after
        self.T = self.T @ still.matrix

    def _member(self, part: Part, start: FloatArray, end: FloatArray, name: str) -> None:
        if np.abs(end - start).max() > NOTHING * self.chain.size:
            self.members.append(Member(part, len(self.axes), start, end, name))


class _Reader:
    """Finds the lengths of constant transforms, and how the formulas call them."""

    def __init__(self, story: Story) -> None:
        self.story, self.chain = story, story.algebra.chain
        self.normal = normal_form(self.chain.ring, self.chain.constants, {})
        self.values = {each.name: each.value for each in self.chain.constants}
        self.standard = is_standard(story)

    def still(self, transform: Transform, matrix: FloatArray, part: Part) -> _Still:
        """A constant transform."""
        pieces = tuple(
            _Piece(vector, self._name(length))
            for vector, length in self._lengths(transform, matrix, part)
            if np.abs(vector).max() > NOTHING * self.chain.size
        )
        return _Still(part, matrix, pieces)

    def _lengths(
        self, transform: Transform, matrix: FloatArray, part: Part
    ) -> Iterable[tuple[FloatArray, Polynomial]]:
        """A translation along axes of one of its frames or the other, with their lengths.

        A row of a standard table goes along z and then along x. A row of a modified table goes
        along x and then along the next z, and axes lie in any direction of their frames.
        """
        x, y, z = transform.translation
        shift, e = matrix[:3, 3], np.eye(3)
        if not self.standard and part is Part.LINK and self._both(y, z):
            length = -inverse(transform, self.normal).translation[2]
            first, second = shift[0] * e[0], self._number(length) * matrix[:3, 2]
            if np.abs(first + second - shift).max() < NOTHING * self.chain.size:
                return [(first, x), (second, length)]
        order = (2, 0, 1) if self.standard or part is not Part.LINK else (0, 1, 2)
        return [(shift[k] * e[k], (x, y, z)[k]) for k in order]

    def _both(self, y: Polynomial, z: Polynomial) -> bool:
        least = NOTHING * self.chain.size
        return min(abs(self._number(y)), abs(self._number(z))) > least

    def _number(self, length: Polynomial) -> float:
        return float(sum(terms_in_numbers(length, self.values)))

    def _name(self, length: Polynomial) -> str:
        lifted = length.set_ring(self.story.algebra.ring)
        formula = self.story.write(lifted)
        if begins_negative(formula):
            formula = self.story.write(-lifted)
        return show(formula, PLAIN)


def is_standard(story: Story) -> bool:
    """Whether axis i is z of frame i - 1; otherwise it is z of frame i."""
    geometry = story.robot.geometry
    return isinstance(geometry, DhTable) and geometry.convention is Convention.STANDARD


def coordinate(name: str, index: int | str) -> str:
    """x_i as text."""
    return letter(name, name, str(index)).text
