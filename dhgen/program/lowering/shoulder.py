"""The shoulder's rotation from the pose, the arm angle and the elbow's angle.

Along the line from shoulder to wrist, in the direction of the elbow, and across both are three
unit vectors: in the base they are known from the pose and the arm angle, in frame 3 from the
elbow's angle. One triple in terms of the other is the rotation of A_1 A_2 A_3. The elbow's own
distance from the line does not occur: a stretched arm, too, has its plane.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import SHOULDER_NAMES, AngleSum
from dhgen.paul.arm_plane import SHOULDER
from dhgen.program.lowering.arm_angle import straight_limit
from dhgen.program.lowering.coefficients import is_short
from dhgen.program.lowering.vectors import chosen, cross, inner, length, minus, plus, scaled

if TYPE_CHECKING:
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.arm_plane import ArmPlane
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.context import Lowering

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
    """Whether the wrist is in the shoulder, which may turn as it likes then: as the seed has it."""
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
    """The three link vectors in frame 3."""
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
    limit = straight_limit(builder, context.chain, plane, context.scales.tolerances, solved=True)
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
