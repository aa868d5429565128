"""What the user wrote, validated: the value that every later stage starts from."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING

from dhgen.robot.expression import ZERO

if TYPE_CHECKING:
    from dhgen.errors import Diagnostic
    from dhgen.robot.cell_notes import Taken
    from dhgen.robot.expression import Expression
    from dhgen.robot.task import Task

FLEET = "_fleet"  # ends the name of what is for arms with tables that come at run time


class JointKind(Enum):
    """How a joint moves."""

    REVOLUTE = "revolute"
    PRISMATIC = "prismatic"


class Convention(Enum):
    """The order of a Denavit-Hartenberg row."""

    STANDARD = "standard"  # Rz(theta) Tz(d) Tx(a) Rx(alpha)
    MODIFIED = "modified"  # Rx(alpha) Tx(a) Rz(theta) Tz(d)


@dataclass(frozen=True, slots=True)
class Parameter:
    """A named number of the robot file, e.g. a link length.

    Attributes:
        name: An identifier.
        expression: Its value as written; parameters defined before it may occur.
        value: The same as a float, in the file's unit (angles in radians).
    """

    name: str
    expression: Expression
    value: float


@dataclass(frozen=True, slots=True)
class Coupling:
    """What the drive of another joint adds to a joint: `theta: q - q2` has one of -1 times q2.

    Attributes:
        joint: The other joint, from 1.
        factor: What its variable is multiplied by, as written.
        value: The same as a float [this joint's unit per that joint's].
    """

    joint: int
    factor: Expression
    value: float


@dataclass(frozen=True, slots=True)
class DhRow:
    """One row of a Denavit-Hartenberg table.

    The variable q is in `theta` (revolute) or in `d` (prismatic), with `sign`; the expression
    kept there is the constant that is added to it: `theta: q + pi/2` has sign 1 and theta pi/2.
    A passive row has no q: the drives of other joints move it, `theta: -q3`.

    Attributes:
        kind: By the place of q, or of what is in its place.
        sign: +1 or -1, the factor of q; 0 in a passive row.
        theta: Joint angle (or its offset) [rad].
        d: Joint offset (or the constant added to q) [length].
        a: Link length [length].
        alpha: Twist [rad].
        limits: Lowest and highest q [rad or length], or None.
        b: A shift along y after the twist, of modified rows that the compiler makes from axes that
            are nearly parallel: their common normal is far away [length].
        name: What the joint is called elsewhere; empty where the file names no joints.
        couplings: What the drives of other joints add to q, by their numbers.
    """

    kind: JointKind
    sign: int
    theta: Expression
    d: Expression
    a: Expression
    alpha: Expression
    limits: tuple[float, float] | None = None
    b: Expression = ZERO
    name: str = ""
    couplings: tuple[Coupling, ...] = ()

    @property
    def offset(self) -> Expression:
        """What is added in the cell that moves."""
        return self.theta if self.kind is JointKind.REVOLUTE else self.d


@dataclass(frozen=True, slots=True)
class AxisJoint:
    """A joint given by its axis in the reference position (q = 0), in the base frame.

    Attributes:
        kind: Revolute about the axis, or prismatic along it.
        direction: Three components, not all zero, of any length.
        point: A point of the axis [length]; without meaning for a prismatic joint.
        limits: Lowest and highest q [rad or length], or None.
        name: What the joint is called elsewhere; empty where the file names no joints.
    """

    kind: JointKind
    direction: tuple[Expression, Expression, Expression]
    point: tuple[Expression, Expression, Expression]
    limits: tuple[float, float] | None = None
    name: str = ""


@dataclass(frozen=True, slots=True)
class DhTable:
    """A robot given by Denavit-Hartenberg rows.

    Attributes:
        convention: How rows are read.
        rows: From base to tool, passive ones among them. Couplings number the others.
    """

    convention: Convention
    rows: tuple[DhRow, ...]

    @property
    def driven(self) -> tuple[DhRow, ...]:
        """The rows with a variable of their own: the joints."""
        return tuple(row for row in self.rows if row.sign)

    @property
    def labels(self) -> tuple[str, ...]:
        """What the rows are called: by the numbers of the joints, a passive one 3p behind joint 3.

        One more of these behind the same joint is 3pp.
        """
        found: list[str] = []
        joints = 0
        for row in self.rows:
            joints += bool(row.sign)
            found.append(str(joints) if row.sign else f"{found[-1] if found else 0}p")
        return tuple(found)

    @property
    def drive_factors(self) -> tuple[tuple[float, ...], ...]:
        """What the drives' values are multiplied by for each row's angle or length."""
        places = iter(range(len(self.driven)))
        found = []
        for row in self.rows:
            factors = [0.0] * len(self.driven)
            if row.sign:
                factors[next(places)] = float(row.sign)
            for each in row.couplings:
                factors[each.joint - 1] = each.value
            found.append(tuple(factors))
        return tuple(found)


@dataclass(frozen=True, slots=True)
class ReferenceAxes:
    """A robot given by its axes in the reference position, and the tool's pose there."""

    axes: tuple[AxisJoint, ...]
    home: Frame


def joints_of(geometry: DhTable | ReferenceAxes) -> tuple[DhRow | AxisJoint, ...]:
    """The joints from base to tool, each with a variable of its own."""
    return geometry.driven if isinstance(geometry, DhTable) else geometry.axes


@dataclass(frozen=True, slots=True)
class Frame:
    """A constant frame as written: a translation and a rotation matrix, row by row.

    Attributes:
        xyz: The origin [length].
        rotation: Nine expressions; rpy and quaternions are already written out as products of
            sines and cosines, so exact angles are kept exact.
    """

    xyz: tuple[Expression, Expression, Expression]
    rotation: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class SumLimit:
    """Limits of a sum of joints' variables.

    Attributes:
        of: The sum: each variable with its factor.
        limits: Lowest and highest value [rad or length].
        kind: What it is a value of: all its joints turn, or all slide.
    """

    of: tuple[Coupling, ...]
    limits: tuple[float, float]
    kind: JointKind


@dataclass(frozen=True, slots=True)
class Robot:
    """A validated robot file.

    Attributes:
        name: Identifier that names the files and the C functions.
        title: What a person calls the robot.
        source: Where its numbers come from.
        parameters: The file's own parameters, in the file's order.
        geometry: A table, or axes in the reference position.
        base: Z in POS = Z T E, pose of the arm's base frame.
        tool: E in POS = Z T E, pose of the tool in the last frame.
        task: What of the pose the caller means.
        free: Joints (from 1) whose value the caller gives.
        arm_angle: Whether the caller gives the arm angle, in place of the value of a joint.
        steps: Which equations to take, by their numbers, for the first steps of the derivation.
        numerical: Whether the numerical solver may take an arm that nothing else solves.
        length_unit: How lengths are called, e.g. "m".
        float32: Whether C in single precision is wanted, too.
        plain: Whether solvers do without their fast path for regular poses.
        calibration: Whether solvers are wanted, too, whose table comes at run time.
        taken: The cells that are taken as exact values next to their own.
        sums: Limits of sums of joints' variables.
        notices: What was snapped to an exact value, looks like a slip, or is of no use.
        doubts: What may be why the arm's solvers do not pass, if they do not.
        owner: The parallel robot of which this is a kind of leg; empty for a robot of its own.
    """

    name: str
    title: str
    source: str
    parameters: tuple[Parameter, ...]
    geometry: DhTable | ReferenceAxes
    base: Frame
    tool: Frame
    task: Task
    free: tuple[int, ...] = ()
    arm_angle: bool = False
    steps: tuple[int, ...] = ()
    numerical: bool = False
    length_unit: str = "m"
    float32: bool = False
    plain: bool = False
    calibration: bool = False
    taken: tuple[Taken, ...] = ()
    sums: tuple[SumLimit, ...] = ()
    notices: tuple[Diagnostic, ...] = ()
    doubts: tuple[Diagnostic, ...] = ()
    owner: str = ""

    @property
    def is_coupled(self) -> bool:
        """Whether a drive moves more than its own joint, or sums of drives' values have limits."""
        rows = self.geometry.rows if isinstance(self.geometry, DhTable) else ()
        return bool(self.sums) or any(row.couplings for row in rows)

    @property
    def joints(self) -> tuple[DhRow | AxisJoint, ...]:
        """The joints from base to tool, each with a variable of its own."""
        return joints_of(self.geometry)
