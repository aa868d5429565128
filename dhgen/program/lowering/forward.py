"""The forward programs: T_base_tool and the geometric Jacobian, joint by joint."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.chain import Fixed, Passive, Slide, Turn
from dhgen.program.building.builder import Builder
from dhgen.program.lowering.angles import driven, factor_constant, followed
from dhgen.program.lowering.vectors import cross
from dhgen.program.reserved import NOTHING, Reserved
from dhgen.program.role import Source

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain, Element
    from dhgen.kinematics.constants import Polynomial
    from dhgen.kinematics.drives import Share
    from dhgen.kinematics.transform import Transform
    from dhgen.program.building.graph import Node
    from dhgen.program.ir import Program

Vector = list["Node"]


def forward_program(chain: Chain, reserved: Reserved = NOTHING) -> Program:
    """The twelve entries of Z A_1 ... A_n E, row by row."""
    walk = Walk(chain, "f", reserved)
    walk.along_arm()
    results = {
        f"T{row + 1}{column + 1}": walk.columns[column][row]
        for row in range(3)
        for column in range(4)
    }
    return walk.builder.finish_entries(chain.name, results)


def jacobian_program(chain: Chain, reserved: Reserved = NOTHING) -> Program:
    """The geometric Jacobian, 6 x n, row by row: velocity of the tool's origin, angular velocity.

    Column i is (z x (p - o), z) for a revolute joint with axis z through o, and (z, 0) for a
    prismatic one (B. Siciliano et al., Robotics, 2009, equations 3.30 and 3.29).
    """
    walk = Walk(chain, "g", reserved)
    walk.along_arm()
    builder = walk.builder
    tip = walk.columns[3]

    def column(axis: Vector, origin: Vector | None) -> Vector:
        if origin is None:
            return [*axis, *(builder.integer(0) for _ in range(3))]
        arm = [builder.sub(p, o) for p, o in zip(tip, origin, strict=True)]
        return [*cross(builder, axis, arm), *axis]

    columns = _by_drives(builder, chain, [column(*axis) for axis in walk.axes])
    for passive, axis in zip(chain.passive, walk.passive_axes, strict=True):
        _add_shares(builder, columns, passive.label, passive.shares, column(*axis))
    results = {
        f"J{row + 1}{column + 1}": entry
        for row, entries in enumerate(zip(*columns, strict=True))
        for column, entry in enumerate(entries)
    }
    return builder.finish_entries(chain.name, results)


def _by_drives(builder: Builder, chain: Chain, columns: list[Vector]) -> list[Vector]:
    """A column for each drive, from the columns of joints' motions along their own axes."""
    found = list(columns)
    for joint, column in zip(chain.joints, columns, strict=True):
        own = column if joint.sign > 0 else [builder.neg(entry) for entry in column]
        _add_shares(builder, found, str(joint.number), joint.shares, own)
    return found


def _add_shares(
    builder: Builder, columns: list[Vector], label: str, shares: tuple[Share, ...], own: Vector
) -> None:
    """Adds to the columns of drives what they have of one that they move, too."""
    for share in shares:
        factor = factor_constant(builder, label, share)
        columns[share.drive - 1] = [
            builder.add(entry, builder.mul(factor, more))
            for entry, more in zip(columns[share.drive - 1], own, strict=True)
        ]


class Walk:
    """The frame carried along the arm.

    Attributes:
        builder: Where values go.
        columns: x, y, z and origin of the frame reached.
        axes: For every joint met its axis, and a point on it (None for prismatic joints).
        passive_axes: Of every passive row met the same.
        joints: For every joint met the columns of the frame whose z it turns about or slides along.
        frames: The columns of the base frame and of the frame after every link.
    """

    def __init__(self, chain: Chain, folded: str, reserved: Reserved) -> None:
        own = {constant.name for constant in chain.constants} | {"T", "J", "q"}
        self.builder = Builder(reserved.with_own(own), folded)
        self._chain = chain
        self._values = {constant.name: constant for constant in chain.constants}
        one, zero = self.builder.integer(1), self.builder.integer(0)
        self.columns: list[Vector] = [
            [one if row == column else zero for row in range(3)] for column in range(4)
        ]
        self.axes: list[tuple[Vector, Vector | None]] = []
        self.passive_axes: list[tuple[Vector, Vector | None]] = []
        self.joints: list[list[Vector]] = []
        self.frames: list[list[Vector]] = []

    def along_arm(self) -> None:
        """From the base frame to the tool."""
        self._fixed(self._chain.base)
        self.frames.append(list(self.columns))
        for number, link in enumerate(self._chain.links, start=1):
            for element in link:
                self._element(element)
            self._name_frame(number)
            self.frames.append(list(self.columns))
        self._fixed(self._chain.tool)

    def _name_frame(self, number: int) -> None:
        """x3_y is the y component of the x axis of frame 3, p3_x its origin's x coordinate."""
        for letter, column in zip("xyzp", self.columns, strict=True):
            for component, entry in zip("xyz", column, strict=True):
                self.builder.hint(entry, f"{letter}{number}_{component}")

    def _element(self, element: Element) -> None:
        if isinstance(element, Turn | Slide):
            self.joints.append(list(self.columns))
        match element:
            case Fixed(transform):
                self._fixed(transform)
            case Turn(joint):
                self.axes.append((self._facing(joint), list(self.columns[3])))
                self._turn(self._inner(joint), str(joint))
            case Slide(joint):
                self.axes.append((self._facing(joint), None))
                self.columns[3] = self._moved(self.columns[2], self._inner(joint))
            case Passive():
                point = list(self.columns[3]) if element.turns else None
                self.passive_axes.append((list(self.columns[2]), point))
                value = followed(self.builder, element, self.builder.joint)
                if element.turns:
                    self._turn(value, element.label)
                else:
                    self.columns[3] = self._moved(self.columns[2], value)

    def _facing(self, joint: int) -> Vector:
        """The axis along which the joint's value counts: -z where its sign is -1."""
        axis = list(self.columns[2])
        if self._chain.joints[joint - 1].sign > 0:
            return axis
        return [self.builder.neg(entry) for entry in axis]

    def _inner(self, joint: int) -> Node:
        return driven(self.builder, self._chain.joints[joint - 1], self.builder.joint)

    def _turn(self, angle: Node, label: str) -> None:
        builder = self.builder
        cosine = builder.name(builder.apply("cos", angle), f"c{label}")
        sine = builder.name(builder.apply("sin", angle), f"s{label}")
        x, y = self.columns[0], self.columns[1]
        pairs = list(zip(x, y, strict=True))
        self.columns[0] = [
            builder.add(builder.mul(cosine, a), builder.mul(sine, b)) for a, b in pairs
        ]
        self.columns[1] = [
            builder.sub(builder.mul(cosine, b), builder.mul(sine, a)) for a, b in pairs
        ]

    def _fixed(self, transform: Transform) -> None:
        origin = self.columns[3]
        for column, entry in zip(self.columns[:3], transform.translation, strict=True):
            origin = self._plus(origin, column, self._number(entry))
        turned = []
        for j in range(3):
            total: Vector = [self.builder.integer(0)] * 3
            for i in range(3):
                total = self._plus(total, self.columns[i], self._number(transform.entry(i, j)))
            turned.append(total)
        self.columns = [*turned, origin]

    def _moved(self, axis: Vector, length: Node) -> Vector:
        return self._plus(self.columns[3], axis, length)

    def _plus(self, start: Vector, axis: Vector, length: Node) -> Vector:
        builder = self.builder
        return [builder.add(a, builder.mul(length, b)) for a, b in zip(start, axis, strict=True)]

    def _number(self, polynomial: Polynomial) -> Node:
        builder = self.builder
        names = [symbol.name for symbol in polynomial.ring.symbols]
        total = builder.integer(0)
        for monomial, coefficient in polynomial.terms():
            part = builder.div(
                builder.integer(int(coefficient.numerator)),
                builder.integer(int(coefficient.denominator)),
            )
            for name, exponent in zip(names, monomial, strict=True):
                for _ in range(exponent):
                    known = self._values[name]
                    power = int(known.is_length)
                    constant = builder.constant(name, known.value, known.meaning, power, Source.ARM)
                    part = builder.mul(part, constant)
            total = builder.add(total, part)
        return total
