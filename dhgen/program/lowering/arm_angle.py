"""The arm angle of joint values, and by how much they miss one."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.arm_angle import straight_side, wrist_in_tool
from dhgen.kinematics.numeric import numeric_arm
from dhgen.paul.arm_plane import SHOULDER
from dhgen.program.building.tolerance_constants import tolerance_constant
from dhgen.program.lowering.forward import Walk
from dhgen.program.lowering.vectors import chosen, cross, inner, length, minus, scaled
from dhgen.program.reserved import NOTHING, Reserved
from dhgen.program.role import Tolerance
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain
    from dhgen.paul.arm_plane import ArmPlane
    from dhgen.paul.derivation import Derivation
    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node
    from dhgen.program.ir import Program
    from dhgen.tolerances import Tolerances

    Vector = list[Node]

ROUNDED = 0.97  # how much of an elbow's side rounding of the pose leaves where branches merge


def arm_angle_program(
    derivation: Derivation, tolerances: Tolerances = TOLERANCES, reserved: Reserved = NOTHING
) -> Program | None:
    """The arm angle of joint values, in (-pi, pi]; None for arms to which none is given.

    Where the solver takes a fixed direction instead of one that is lost, this does, too: the arm
    angle of a solution is the one that was asked for. Zero where the wrist is in the shoulder.
    """
    plane, chain = derivation.pool.plane, derivation.problem.algebra.chain
    if plane is None:
        return None
    elbow = _Elbow(Walk(chain, "n", reserved), plane, tolerances)
    builder = elbow.walk.builder
    w = minus(builder, elbow.walk.frames[plane.wrist_frame][3], elbow.shoulder)
    normal = cross(builder, w, elbow.elbow)
    if plane.planar:
        bent = inner(builder, normal, elbow.fourth)
        limit = straight_limit(builder, chain, plane, tolerances)
        behind = builder.apply("less", bent, builder.neg(limit))
        side = builder.select(behind, builder.integer(-1), builder.integer(1))
        normal = scaled(builder, side, elbow.fourth)
    results = {"psi": elbow.angle(w, length(builder, w), normal)}
    return builder.finish(chain.name, results, [])


def plane_miss_program(
    derivation: Derivation, tolerances: Tolerances = TOLERANCES, reserved: Reserved = NOTHING
) -> Program | None:
    """By how much joint values miss the arm angle, and how fast joints 1, 2 and 3 change that.

    The elbow's plane is taken about the line to the wrist of the pose: joint values that miss the
    pose by a little are refined to the arm angle that was asked for. Of an arm that can be straight
    both sides of that line are taken for one. As `plane_miss` in `dhgen.kinematics.arm_angle`.
    """
    plane, chain = derivation.pool.plane, derivation.problem.algebra.chain
    if plane is None:
        return None
    elbow = _Elbow(Walk(chain, "n", reserved), plane, tolerances)
    walk, builder = elbow.walk, elbow.walk.builder
    w = minus(builder, _wrist(builder, chain), elbow.shoulder)
    reach, e = builder.name(length(builder, w), "reach"), elbow.elbow
    normal = elbow.fourth if plane.planar else cross(builder, w, e)
    off = builder.sub(builder.given(1), elbow.angle(w, reach, normal))
    two = builder.integer(2)
    miss = builder.apply("wrap", builder.mul(two, off) if plane.planar else off)
    miss = builder.div(miss, two) if plane.planar else miss
    safe = reach
    if plane.folds:
        least = tolerance_constant(builder, Tolerance("free", 1), tolerances.free * chain.size)
        none = builder.apply("at_most", reach, least)
        safe = builder.select(none, builder.integer(1), reach)
        miss = builder.select(none, builder.integer(0), miss)
    about = scaled(builder, builder.div(builder.integer(1), safe), w)
    if not plane.planar:
        ahead = scaled(builder, inner(builder, e, e), w)
        back = scaled(builder, inner(builder, e, w), e)
        square = inner(builder, normal, normal)
        about = scaled(builder, builder.div(reach, square), minus(builder, ahead, back))
    results = {"off": miss}
    for joint, (axis, _) in enumerate(walk.axes[:SHOULDER], start=1):
        results[f"rate{joint}"] = inner(builder, axis, about)
    return builder.finish_entries(chain.name, results)


class _Elbow:
    """Shoulder, elbow and the axes of an arm at joint values, as values of a program.

    Attributes:
        walk: The arm.
        shoulder: Where axes 1, 2 and 3 meet.
        fourth: The direction of axis 4.
        elbow: From the shoulder to the point of axis 4 nearest to it.
    """

    def __init__(self, walk: Walk, plane: ArmPlane, tolerances: Tolerances) -> None:
        self.walk = walk
        self.walk.along_arm()
        builder = self.walk.builder
        self._plane, self._tolerances = plane, tolerances
        self.shoulder = self.walk.frames[plane.shoulder_frame][3]
        joint = self.walk.joints[3]
        self.fourth = joint[2]
        start = minus(builder, joint[3], self.shoulder)
        along = inner(builder, self.fourth, start)
        self.elbow = minus(builder, start, scaled(builder, along, self.fourth))

    def angle(self, w: Vector, reach: Node, normal: Vector) -> Node:
        """The arm angle of a plane with this normal about the line w, of length reach."""
        builder = self.walk.builder
        first = self.walk.joints[0][2]
        across = cross(builder, first, self.walk.frames[0][self._plane.reference])
        reference = cross(builder, w, first)
        size = length(builder, reference)
        least = tolerance_constant(builder, Tolerance("free", 0), self._tolerances.free)
        aside = builder.apply("at_most", size, builder.mul(least, reach))
        b = chosen(builder, aside, across, reference)
        a = cross(builder, b, w)
        u = cross(builder, normal, w)
        sine, cosine = builder.mul(reach, inner(builder, u, b)), inner(builder, u, a)
        return builder.apply("atan2", sine, cosine)


def _wrist(builder: Builder, chain: Chain) -> Vector:
    """The wrist of the pose."""
    place = wrist_in_tool(numeric_arm(chain))
    found = []
    for row in range(1, 4):
        total = builder.pose(row, 4)
        for column, value in enumerate(place, start=1):
            meaning = "the wrist in the tool's frame"
            known = builder.constant(f"wrist_{'xyz'[column - 1]}", float(value), meaning, 1)
            total = builder.add(total, builder.mul(builder.pose(row, column), known))
        found.append(total)
    return found


def straight_limit(
    builder: Builder, chain: Chain, plane: ArmPlane, tolerances: Tolerances, *, solved: bool = False
) -> Node:
    """The elbow's side up to which the arm is as good as stretched.

    Args:
        builder: Where the constant goes.
        chain: The arm.
        plane: Its shoulder, elbow and wrist.
        tolerances: Of the arithmetic that the program is for.
        solved: Whether the side is that of a solution: joint values that have a side have one
            also as a solution, whatever rounding has made of their pose.
    """
    value = straight_side(chain.size, plane.area, tolerances.merge)
    if solved:
        meaning = "the same of a solution, whose pose is rounded"
        return builder.constant("solved_limit", ROUNDED * value, meaning, 2, Tolerance("solved", 2))
    meaning = "a stretched arm: its elbow is on either side"
    return builder.constant("straight_limit", value, meaning, 2, Tolerance("straight", 2))
