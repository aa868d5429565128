"""The arm angle: the shoulder's rotation as a known matrix, and where it has no plane."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.conditions import unsigned, without_lengths
from dhgen.derivation.known_functions import by_joints
from dhgen.derivation.notation.names import letter, product_of, shoulder_target, single, theta
from dhgen.derivation.step_context import Singularity
from dhgen.derivation.text.blocks import say
from dhgen.derivation.text.formula import ZERO, Listing, Matrix, Symbol, equal
from dhgen.derivation.text.template import blocks_of
from dhgen.kinematics.ring import used_places
from dhgen.paul.arm_plane import SHOULDER

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.arm_plane import ArmPlane


PSI = Symbol(r"\psi", "ψ")


def shoulder_blocks(story: Story) -> list[Block]:
    """From the arm angle to B_0; nothing for arms to which none is given."""
    plane = story.derivation.pool.plane
    if plane is None:
        return []
    axis = "xy"[plane.reference]
    in_base = (("v", wrist_from_shoulder(story, plane)), ("z", plane.first))
    in_frame_3 = (("v", plane.wrist), ("e", plane.elbow), ("z", plane.fourth))
    dyads = Symbol(
        r"\mathbf{g}\,\mathbf{g}'^T + \mathbf{u}\,\mathbf{u}'^T + \mathbf{n}\,\mathbf{n}'^T",
        "g g′ᵀ + u u′ᵀ + n n′ᵀ",
    )
    return blocks_of(
        "shoulder",
        shoulder_frame=plane.shoulder_frame,
        wrist_frame=plane.wrist_frame,
        wrist_and_axis=_columns(story, in_base, prime=""),
        across=Symbol(rf"\mathbf{{z}} \times \mathbf{{{axis}}}", f"z × {axis}"),
        reference=_vector(axis),
        elbow_angle=theta(plane.elbow_angle),
        in_frame_3=_columns(story, in_frame_3, prime="′"),
        planar=plane.planar,
        links=product_of(range(1, SHOULDER + 1)),
        rotation=equal(shoulder_target(0), Symbol("(b_{ij})", "(bᵢⱼ)"), dyads),
        step=equal(letter("B", "B", "i"), Symbol(r"A_i^{-1} B_{i-1}", "Aᵢ⁻¹ Bᵢ₋₁")),
        usual_step=equal(Symbol("U_i", "Uᵢ"), Symbol(r"A_i^{-1} U_{i-1}", "Aᵢ⁻¹ Uᵢ₋₁")),
    )


def wrist_from_shoulder(story: Story, plane: ArmPlane) -> list[Polynomial]:
    """v, by the pose."""
    target = story.derivation.problem.target
    wrist = []
    for row in range(3):
        total = target.entry(row, 3) - plane.shoulder[row]
        for column, length in enumerate(plane.wrist_in_tool):
            total += target.entry(row, column) * length
        wrist.append(total)
    return wrist


def _columns(
    story: Story, vectors: Iterable[tuple[str, Iterable[Polynomial]]], prime: str
) -> Formula:
    """Every vector as a column; vectors of frame 3 have a prime."""
    shown = []
    for name, entries in vectors:
        column = Matrix(tuple((story.write(entry),) for entry in entries))
        shown.append(equal(_vector(name, prime), column))
    return Listing(tuple(shown))


def _vector(name: str, prime: str = "") -> Symbol:
    return Symbol(rf"\mathbf{{{name}}}" + "'" * len(prime), name + prime)


def arm_angle_places(story: Story) -> list[Singularity]:
    """Where the line from the shoulder to the wrist is axis 1; step 0 is the angle itself."""
    plane = story.derivation.pool.plane
    if plane is None:
        return []
    axis = "xy"[plane.reference]
    v, z = wrist_from_shoulder(story, plane), plane.first
    across = [v[i] * z[j] - v[j] * z[i] for i, j in ((0, 1), (2, 0), (1, 2))]
    left = [story.algebra.normal(entry) for entry in across if entry]
    meaning = say(
        "the wrist lies on axis 1: the line from the shoulder to it is that axis, and no plane is "
        "fixed by both"
    )
    effect = say(
        "{} takes the place of {}; close by, small motions of the tool turn the elbow far about "
        "that line while {} stays the same",
        Symbol(rf"\mathbf{{z}} \times \mathbf{{{axis}}}", f"z × {axis}"),
        Symbol(r"\mathbf{g} \times \mathbf{z}", "g × z"),
        PSI,
    )
    named = _named(story)
    condition = equal(*(named.get(entry) or unsigned(story, entry) for entry in left), ZERO)
    return [Singularity(0, condition, _in_joints(story, left), meaning, effect)]


def _named(story: Story) -> dict[Polynomial, Symbol]:
    """The coordinates of named points, and their opposites, by what they are in the pose."""
    target = story.derivation.problem.target
    found: dict[Polynomial, Symbol] = {}
    for point in story.derivation.pool.points:
        for row, name in enumerate(point.names):
            value = target.entry(row, 3)
            for column, length in enumerate(point.in_tool):
                value += target.entry(row, column) * length
            found |= dict.fromkeys((value, -value), story.letters[name])
    return found


def _in_joints(story: Story, across: list[Polynomial]) -> Formula | None:
    """The vectors without joint 1, which turns the two about axis 1, where that is upright."""
    algebra = story.algebra
    c, s = (algebra.generator(name) for name in (single(1).cosine, single(1).sine))
    if len(across) != 2:
        return None
    y, x = across
    turned = [by_joints(story, form) for form in (c * x + s * y, s * x - c * y)]
    shown = [without_lengths(algebra, form) for form in turned if form]
    first = {algebra.index[single(1).cosine], algebra.index[single(1).sine]}
    if not shown or any(used_places(form) & first for form in shown):
        return None
    return equal(*(unsigned(story, form) for form in shown), ZERO)
