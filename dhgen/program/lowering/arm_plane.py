"""The shoulder's rotation from the pose, the arm angle and the elbow's angle; and the arm angle.

Along the line from shoulder to wrist, in the direction of the elbow, and across both stand three
unit vectors: in the base they are known from the pose and the arm angle, in frame 3 from the
elbow's angle. One triple in terms of the other is the rotation of A_1 A_2 A_3. The elbow's own
distance from the line does not occur: a stretched arm, too, has its plane.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import SHOULDER_NAMES, AngleSum
from dhgen.kinematics.arm_angle import wrist_in_tool
from dhgen.kinematics.numeric import numeric_arm
from dhgen.paul.arm_plane import SHOULDER
from dhgen.program.building.tolerance_constants import tolerance_constant
from dhgen.program.lowering.forward import Walk
from dhgen.program.lowering.short import is_short
from dhgen.program.lowering.vectors import chosen, cross, inner, length, minus, plus, scaled
from dhgen.program.reserved import NOTHING, Reserved
from dhgen.program.role import Tolerance
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.arm_plane import ArmPlane
    from dhgen.paul.derivation import Derivation
    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node
    from dhgen.program.ir import Program
    from dhgen.program.lowering.context import Lowering
    from dhgen.tolerances import Tolerances

    Vector = list[Node]


def lower_shoulder(context: Lowering, plane: ArmPlane, wrist: Vector) -> dict[str, Node]:
    """The entries of the shoulder's rotation by their names.

    Args:
        context: The program in the making; the elbow's angle is known.
        plane: Shoulder, elbow and wrist.
        wrist: The wrist in the base frame.
    """
    builder = context.builder
    w = minus(builder, wrist, _lowered(context, plane.shoulder))
    in_base = _base_vectors(context, plane, w)
    in_three = _link_vectors(context, plane)
    folded = _folded(context, w) if plane.folds else None
    found: dict[str, Node] = {}
    for row, names in enumerate(SHOULDER_NAMES):
        for column, name in enumerate(names):
            entry = inner(builder, [v[row] for v in in_base], [v[column] for v in in_three])
            if folded is not None:
                held = context.at_seed(plane.rotation[row][column])
                entry = builder.select(folded, held, entry)
            found[name] = builder.name(entry, name.replace("__", ""))
    return found


def _folded(context: Lowering, w: Vector) -> Node:
    """Whether the wrist is in the shoulder, which may turn as it likes then: the seed says how."""
    folded = is_short(context, length(context.builder, w), 1, "no_reach")
    for joint in range(1, SHOULDER + 1):
        context.angles.chosen(AngleSum(((joint, 1),)), folded)
    return folded


def _base_vectors(context: Lowering, plane: ArmPlane, w: Vector) -> tuple[Vector, ...]:
    """Along the arm, towards the elbow, and across, in the base frame."""
    builder = context.builder
    first = _lowered(context, plane.first)
    axis = [builder.integer(int(place == plane.reference)) for place in range(3)]
    across = cross(builder, first, axis)
    if context.normal(plane.first[plane.reference]):  # not at right angles
        across = scaled(builder, builder.div(builder.integer(1), length(builder, across)), across)
    along = _unit(context, w, first if plane.folds else None, "reach")
    reference = cross(builder, along, first)
    size = builder.name(length(builder, reference), "lean")
    limit = context.scales.tolerance(context.scales.tolerances.free, 0, "free")
    aside = builder.name(builder.apply("at_most", size, limit), "upright")
    safe = builder.select(aside, builder.integer(1), size)
    b = scaled(builder, builder.div(builder.integer(1), safe), reference)
    b = chosen(builder, aside, across, b)
    a = cross(builder, b, along)
    psi = builder.given(1)
    cosine = builder.name(builder.apply("cos", psi), "cos_psi")
    sine = builder.name(builder.apply("sin", psi), "sin_psi")
    towards = plus(builder, scaled(builder, cosine, a), scaled(builder, sine, b))
    normal = minus(builder, scaled(builder, cosine, b), scaled(builder, sine, a))
    for letter, vector in zip("gun", (along, towards, normal), strict=True):
        for component, entry in zip("xyz", vector, strict=True):
            builder.hint(entry, f"{letter}{component}")
    return along, towards, normal


def _link_vectors(context: Lowering, plane: ArmPlane) -> tuple[Vector, ...]:
    """The same three in frame 3."""
    builder = context.builder
    fourth = _lowered(context, plane.fourth)
    elbow = cross(builder, fourth, _lowered(context, plane.elbow))
    along = _unit(context, _lowered(context, plane.wrist), elbow if plane.folds else None, "arm")
    if plane.planar:
        normal = scaled(builder, _side(context, plane), fourth)
    else:
        normal = _unit(context, _lowered(context, plane.normal), None, "normal")
    return along, cross(builder, normal, along), normal


def _side(context: Lowering, plane: ArmPlane) -> Node:
    """+1 where the arm is bent to the positive side of axis 4, or straight; else -1."""
    builder = context.builder
    parts = [f * n for f, n in zip(plane.fourth, plane.normal, strict=True)]
    bent = builder.name(context.lower(context.normal(sum(parts[1:], parts[0]))), "bent")
    limit = _straight(builder, context.chain, plane, context.scales.tolerances)
    behind = builder.apply("less", bent, builder.neg(limit))
    side = builder.select(behind, builder.integer(-1), builder.integer(1))
    return builder.name(side, "side")


def _unit(context: Lowering, vector: Vector, instead: Vector | None, name: str) -> Vector:
    """A vector of length one; another, of any length, where there is no length to speak of."""
    builder = context.builder
    size = builder.name(length(builder, vector), name)
    one = builder.integer(1)
    if instead is None:
        return scaled(builder, builder.div(one, size), vector)
    none = is_short(context, size, 1, f"no_{name}")
    vector = scaled(builder, builder.div(one, builder.select(none, one, size)), vector)
    other = scaled(builder, builder.div(one, length(builder, instead)), instead)
    return chosen(builder, none, other, vector)


def _lowered(context: Lowering, vector: tuple[Polynomial, ...]) -> Vector:
    return [context.lower(entry) for entry in vector]


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
        limit = _straight(builder, chain, plane, tolerances)
        behind = builder.apply("less", bent, builder.neg(limit))
        side = builder.select(behind, builder.integer(-1), builder.integer(1))
        normal = scaled(builder, side, elbow.fourth)
    results = {"psi": elbow.angle(w, length(builder, w), normal)}
    return builder.finish(chain.name, results, [])


def plane_miss_program(
    derivation: Derivation, tolerances: Tolerances = TOLERANCES, reserved: Reserved = NOTHING
) -> Program | None:
    """By how much joint values miss the arm angle, and how fast joints 1, 2 and 3 change that.

    The elbow's plane is told about the line to the wrist of the pose: joint values that miss the
    pose by a little are led to the arm angle that was asked for. Of an arm that can be straight
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


def _straight(builder: Builder, chain: Chain, plane: ArmPlane, tolerances: Tolerances) -> Node:
    """The elbow's side where the arm is as good as stretched: where its two angles are merged.

    They are for (2 A)^2 - Z^2 < 2 d |Z|, with A the plane's area and d what merges squared lengths;
    the side s of the elbow is half of the root of the left-hand side.
    """
    value = math.sqrt(tolerances.merge * chain.size**2 * plane.area)
    meaning = "a stretched arm: its elbow is on either side"
    return builder.constant("straight_limit", value, meaning, 2, Tolerance("straight", 2))
