"""The chain: what every robot file becomes, constant and joint transforms in alternation.

Nothing after this module depends on whether the arm was written as a standard table, as a modified
table or as axes in the reference position. The links keep the frames of the document, so that U_i
is the document's U_i.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar

from dhgen.kinematics.drives import Drives
from dhgen.kinematics.normal import normal_form
from dhgen.kinematics.transform import Transform, compose, identity, turn_between
from dhgen.robot.robot import JointKind

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from sympy.polys.rings import PolyRing

    from dhgen.kinematics.constants import Constant
    from dhgen.kinematics.drives import Share, SumLimit
    from dhgen.robot.task import Task


@dataclass(frozen=True, slots=True)
class Fixed:
    """A constant transform between two joints."""

    transform: Transform


@dataclass(frozen=True, slots=True)
class Turn:
    """A rotation about z by the angle of a joint, times a sign."""

    turns: ClassVar[bool] = True
    joint: int
    sign: int = 1

    @property
    def signed(self) -> tuple[tuple[int, int], ...]:
        """The joint with the sign."""
        return ((self.joint, self.sign),)


@dataclass(frozen=True, slots=True)
class Slide:
    """A translation along z by the length of a joint, times a sign."""

    turns: ClassVar[bool] = False
    joint: int
    sign: int = 1

    @property
    def signed(self) -> tuple[tuple[int, int], ...]:
        """The joint with the sign."""
        return ((self.joint, self.sign),)


@dataclass(frozen=True, slots=True)
class Passive:
    """The motion of a passive row about or along z: drives of other joints move it.

    Attributes:
        place: Which passive row of the chain it is, from zero.
        label: What it is called: 3p behind joint 3.
        terms: The joints whose angles or lengths add up to its own, each with a whole number; a
            number of its own, behind those of the joints, where it is `apart`.
        turns: Whether it turns.
        shares: What the drives add to it.
        offset: What is added to these shares, so that they are the sum of the terms.
        sign: What all that is multiplied by: -1 on the way back.
        apart: Why its angle or length is no such sum, so that only least squares take it.
    """

    place: int
    label: str
    terms: tuple[tuple[int, int], ...]
    turns: bool
    shares: tuple[Share, ...]
    offset: float
    sign: int = 1
    apart: str = ""

    @property
    def signed(self) -> tuple[tuple[int, int], ...]:
        """The terms with the sign."""
        return tuple((joint, self.sign * times) for joint, times in self.terms)


Element = Fixed | Turn | Slide | Passive


@dataclass(frozen=True, slots=True)
class ChainJoint:
    """A joint as the algebra sees it: its angle or length is sign q + shares + offset.

    Attributes:
        number: From 1.
        kind: Revolute or prismatic.
        sign: +1 or -1.
        offset: What is added to sign q [rad or length].
        limits: Lowest and highest q, or None.
        name: What the robot file calls it; empty where it names no joints.
        shares: What other joints' drives add.
    """

    number: int
    kind: JointKind
    sign: int
    offset: float
    limits: tuple[float, float] | None
    name: str = ""
    shares: tuple[Share, ...] = ()


@dataclass(frozen=True, slots=True)
class Chain:
    """An arm: Z A_1 A_2 ... A_n E.

    Attributes:
        name: The robot's identifier.
        joints: From base to tool.
        links: The elements of A_1 ... A_n. A passive row is in the link of the joint before it, or
            of the one behind it in a modified table: there the frames of joints are those of links.
        base: Z, the arm's base frame in the caller's frame.
        tool: E, the tool in the last frame.
        constants: The generators of `ring` with their values.
        ring: Ring of the constant transforms.
        task: What of the pose the caller means.
        free: Joints, from 1, whose value the caller gives.
        size: Length that tolerances are relative to (see `arm_size`).
        arm_angle: Whether the caller gives the arm angle, in place of the value of a joint.
        sums: Limits of sums of drives' values.
    """

    name: str
    joints: tuple[ChainJoint, ...]
    links: tuple[tuple[Element, ...], ...]
    base: Transform
    tool: Transform
    constants: tuple[Constant, ...]
    ring: PolyRing
    task: Task
    free: tuple[int, ...]
    size: float
    arm_angle: bool = False
    sums: tuple[SumLimit, ...] = ()

    @property
    def dof(self) -> int:
        """The number of joints."""
        return len(self.joints)

    @property
    def drives(self) -> Drives:
        """How angles and lengths come from the values that the caller counts."""
        joints = self.joints
        return Drives(
            tuple(joint.sign for joint in joints),
            tuple(joint.offset for joint in joints),
            tuple(joint.shares for joint in joints),
        )

    @property
    def joint_names(self) -> tuple[str, ...]:
        """What the joints are called: as in the robot file, or joint1, joint2 and so on."""
        return tuple(joint.name or f"joint{joint.number}" for joint in self.joints)

    def named(self, numbers: Iterable[int]) -> str:
        """Joints as messages list them: 1, 3, or with names 1 (shoulder), 3 (elbow)."""
        names = {joint.number: f" ({joint.name})" for joint in self.joints if joint.name}
        return ", ".join(f"{number}{names.get(number, '')}" for number in numbers)

    @property
    def turning(self) -> tuple[bool, ...]:
        """Which of the joints turn; the others slide."""
        return tuple(joint.kind is JointKind.REVOLUTE for joint in self.joints)

    @property
    def joint_types(self) -> str:
        """R or P for every joint."""
        return "".join("R" if turns else "P" for turns in self.turning)

    @property
    def is_coupled(self) -> bool:
        """Whether a drive moves more than its own joint, or sums of drives' values have limits."""
        return self.drives.are_coupled or bool(self.passive or self.sums)

    @property
    def passive(self) -> tuple[Passive, ...]:
        """The motions of passive rows, from base to tool."""
        elements = (element for link in self.links for element in link)
        return tuple(element for element in elements if isinstance(element, Passive))

    @property
    def given(self) -> int:
        """How many values the caller gives besides the pose."""
        return len(self.free) + self.arm_angle

    @property
    def is_given_alone(self) -> bool:
        """Whether the angles and lengths of free joints hang on given values only."""
        return not any(self.solved_that_move(number) for number in self.free)

    def solved_that_move(self, number: int) -> list[int]:
        """The drives of others that move a joint, and are not given."""
        shares = self.joints[number - 1].shares
        return sorted(share.drive for share in shares if share.drive not in self.free)

    @property
    def overdetermined(self) -> bool:
        """Whether the task gives more independent numbers than the arm can choose."""
        return self.dof - self.given < self.task.dimension

    @property
    def solved(self) -> tuple[ChainJoint, ...]:
        """The joints that are asked for: all but those whose values the caller gives."""
        return tuple(joint for joint in self.joints if joint.number not in self.free)

    @property
    def solved_places(self) -> tuple[int, ...]:
        """The places of these joints, from 0."""
        return tuple(joint.number - 1 for joint in self.solved)


def arm_size(lengths: Iterable[float], joints: Sequence[ChainJoint]) -> float:
    """The sum of all lengths, or the farthest limit of a slide where that is more; 1 without any.

    All lengths of an arm with a slide may be the last digits of a calibration.
    """
    slides = [joint for joint in joints if joint.kind is JointKind.PRISMATIC]
    ends = [abs(end) for slide in slides for end in slide.limits or ()]
    return max(sum(map(abs, lengths)), *ends, 0.0) or 1.0


def parallel_groups(chain: Chain) -> tuple[tuple[tuple[int, int], ...], ...]:
    """Runs of revolute joints whose axes are always parallel: (joint, direction) pairs.

    The direction is +1 or -1, relative to the first axis of the run. Prismatic joints between them
    do not break a run, and passive rows only where they turn about another direction.
    """
    runs: list[tuple[tuple[int, int], ...]] = []
    for run in turning_runs(chain):
        turns = [(element.joint, facing) for element, facing in run if isinstance(element, Turn)]
        if turns:
            first = turns[0][1]
            runs.append(tuple((joint, first * facing) for joint, facing in turns))
    return tuple(runs)


def turning_runs(chain: Chain) -> tuple[tuple[tuple[Turn | Passive, int], ...], ...]:
    """All that turns, in runs of axes that are always parallel, with directions.

    The direction is +1 or -1, relative to the first axis of the run. What is no sum of joints'
    angles is a run of its own.
    """
    normal = normal_form(chain.ring, chain.constants, {})
    runs: list[list[tuple[Turn | Passive, int]]] = []
    since_first = still = identity(chain.ring)
    ends = False
    for element in (element for link in chain.links for element in link):
        if isinstance(element, Fixed):
            turned = Transform(element.transform.rotation, still.translation)
            since_first = compose(since_first, turned, normal)
        elif isinstance(element, Turn) or (isinstance(element, Passive) and element.turns):
            alone = isinstance(element, Passive) and bool(element.apart)
            facing = turn_between(since_first.rotation)
            if facing and runs and not alone and not ends:
                runs[-1].append((element, facing))
            else:
                runs.append([(element, 1)])
                since_first = still
            ends = alone
    return tuple(tuple(run) for run in runs)


def added_up(terms: Iterable[tuple[int, int]]) -> tuple[tuple[int, int], ...]:
    """Terms of a sum of angles, each joint once; what cancels is left out."""
    total: dict[int, int] = {}
    for joint, sign in terms:
        total[joint] = total.get(joint, 0) + sign
    return tuple((joint, sign) for joint, sign in total.items() if sign)
