"""The contents of a robot description: links and the joints between them."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.robot.source import SourceText, Span

    Vector = tuple[float, float, float]


class Motion(Enum):
    """The types of joints of URDF, and the ball of MJCF."""

    FIXED = "fixed"
    REVOLUTE = "revolute"
    CONTINUOUS = "continuous"
    PRISMATIC = "prismatic"
    PLANAR = "planar"
    FLOATING = "floating"
    BALL = "ball"

    @property
    def is_actuated(self) -> bool:
        """Whether one variable moves it."""
        return self in {Motion.REVOLUTE, Motion.CONTINUOUS, Motion.PRISMATIC}

    @property
    def is_loose(self) -> bool:
        """Whether it moves in several ways at once, which no serial arm has."""
        return self in {Motion.PLANAR, Motion.FLOATING, Motion.BALL}

    @property
    def turns(self) -> bool:
        """Whether it rotates about an axis."""
        return self in {Motion.REVOLUTE, Motion.CONTINUOUS}


@dataclass(frozen=True, slots=True)
class Mimic:
    """What moves a joint without a drive: another one.

    Attributes:
        joint: The name of the other one.
        multiplier: What its value is multiplied by.
        offset: What is added [rad or length].
        is_linear: Whether that is all: an MJCF may have higher powers besides.
    """

    joint: str
    multiplier: float = 1.0
    offset: float = 0.0
    is_linear: bool = True


@dataclass(frozen=True, slots=True)
class Joint:
    """A joint of a description.

    Attributes:
        name: As the description calls it.
        motion: How it moves.
        parent: The link that it is on.
        child: The link that it moves.
        xyz: Origin of the joint's frame in the parent's [length].
        rpy: Roll, pitch and yaw of the joint's frame, about fixed axes [rad].
        axis: Direction in the joint's frame, of any length but zero.
        limits: Lowest and highest value, as written; None where nothing is written.
        mimics: What this one follows, if it does.
        place: Its place in the file.
        unread: Attributes that no URDF has, each with its element: ("origin", "RPY").
    """

    name: str
    motion: Motion
    parent: str
    child: str
    xyz: Vector
    rpy: Vector
    axis: Vector
    limits: tuple[float, float] | None
    mimics: Mimic | None
    place: Span
    unread: tuple[tuple[str, str], ...] = ()

    @property
    def is_driven(self) -> bool:
        """Whether a variable of its own moves it."""
        return self.motion.is_actuated and self.mimics is None


@dataclass(frozen=True, slots=True)
class Description:
    """A tree of links.

    Attributes:
        name: Of the robot.
        kind: Of the file, for people: "URDF".
        root: The link that no joint moves.
        joints: By the link that they move.
        source: The text, for remarks.
        closures: Pairs of links that something holds together besides the joints between them.
        notes: On how the file was read.
    """

    name: str
    kind: str
    root: str
    joints: Mapping[str, Joint]
    source: SourceText
    closures: tuple[tuple[str, str], ...] = ()
    notes: tuple[str, ...] = ()

    def joints_to(self, link: str) -> tuple[Joint, ...]:
        """The joints from the root to a link, in this order."""
        found: list[Joint] = []
        while link in self.joints:
            found.append(self.joints[link])
            link = found[-1].parent
        return tuple(reversed(found))

    def children(self) -> dict[str, list[Joint]]:
        """The joints on every link that has any, in the file's order."""
        found: dict[str, list[Joint]] = {}
        for joint in self.joints.values():
            found.setdefault(joint.parent, []).append(joint)
        return found
