"""What the arm angle says: the shoulder's rotation as a known matrix."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.notation.names import letter, product_of, shoulder_target, theta
from dhgen.derivation.text.blocks import Given, Paragraph, display, paragraph, say
from dhgen.derivation.text.formula import Listing, Matrix, Symbol, equal
from dhgen.paul.arm_plane import SHOULDER

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block
    from dhgen.derivation.text.formula import Formula
    from dhgen.kinematics.constants import Polynomial
    from dhgen.paul.arm_plane import ArmPlane

PSI = Symbol(r"\psi", "ψ")
SOURCE = (
    "M. Shimizu, H. Kakuya, W.-K. Yoon, K. Kitagaki, K. Kosuge, Analytical inverse kinematic "
    "computation for 7-DOF redundant manipulators with joint limits, IEEE Transactions on Robotics "
    "24, 2008"
)


def shoulder_blocks(story: Story) -> list[Block]:
    """From the arm angle to B_0; nothing for arms to which none is given."""
    plane = story.derivation.pool.plane
    if plane is None:
        return []
    return [
        _points(plane),
        _meaning(),
        *_in_base(story, plane),
        *_in_link(story, plane),
        _matrix(),
    ]


def _points(plane: ArmPlane) -> Block:
    text = (
        "Axes 1, 2 and 3 meet in the shoulder {}, the origin of frame {}, axes 5, 6 and 7 in the "
        "wrist {}, the origin of frame {}; the elbow {} is the point of axis 4 nearest to the "
        "shoulder. With the pose given, the elbow can still move on a circle about the line from "
        "{} to {}, and the arm angle {} says where it is"
    )
    s, w, e = (Symbol(name, name) for name in "SWM")  # E is the tool
    frames = [Given(str(number)) for number in (plane.shoulder_frame, plane.wrist_frame)]
    source = say(" ({}).", Given(SOURCE))
    prose = say(f"{text}{{}}", s, frames[0], w, frames[1], e, s, w, PSI, source)
    return Paragraph(prose, lead=say("The arm angle."))


def _meaning() -> Block:
    return paragraph(
        "It is the angle about that line from the plane of the line and axis 1: at zero the elbow "
        "leans towards the direction of axis 1."
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


def _in_base(story: Story, plane: ArmPlane) -> list[Block]:
    """Three unit vectors from the pose and the arm angle."""
    wrist = wrist_from_shoulder(story, plane)
    text = (
        "In the base frame {} leads from the shoulder to the wrist, and {} is the direction of "
        "axis 1:"
    )
    three = (
        "Unit vectors point along that line ({}), across the plane of the line and axis 1 ({}), "
        "from the line to the elbow ({}), and across the first and the third ({}):"
    )
    upright = (
        "Where {} is parallel to {} there is no such plane; then {} takes the place of {}, with {} "
        "the {} axis of the base frame."
    )
    v, z = _vector("v"), _vector("z")
    axis = "xy"[plane.reference]
    x = _vector("xy"[plane.reference])
    return [
        paragraph(text, v, z),
        display(Listing((equal(v, _column(story, wrist)), equal(z, _column(story, plane.first))))),
        paragraph(three, *(_vector(name) for name in "gbun")),
        display(
            _plain(r"\mathbf{g} = \mathbf{v} / |\mathbf{v}|", "g = v / |v|"),
            _plain(
                r"\mathbf{b} = \mathbf{g} \times \mathbf{z} / |\mathbf{g} \times \mathbf{z}|",
                "b = g × z / |g × z|",
            ),
            _plain(
                r"\mathbf{u} = \cos\psi \, (\mathbf{b} \times \mathbf{g}) + \sin\psi \, \mathbf{b}",
                "u = cos ψ (b × g) + sin ψ b",
            ),
            _plain(r"\mathbf{n} = \mathbf{g} \times \mathbf{u}", "n = g × u"),
        ),
        paragraph(
            upright,
            v,
            z,
            _plain(rf"\mathbf{{z}} \times \mathbf{{{axis}}}", f"z × {axis}"),
            _plain(r"\mathbf{g} \times \mathbf{z}", "g × z"),
            x,
            Given(axis),
        ),
    ]


def _in_link(story: Story, plane: ArmPlane) -> list[Block]:
    """The same three in frame 3, from the elbow's angle."""
    angle = plane.elbow_angle
    wrist, elbow, axis = (_primed(name) for name in "vez")
    text = (
        "In frame {} let {} lead from the shoulder to the wrist and {} to the elbow, and let {} be "
        "the direction of axis 4. They are known once {} is:"
    )
    vectors = (wrist, plane.wrist), (elbow, plane.elbow), (axis, plane.fourth)
    columns = Listing(tuple(equal(name, _column(story, vector)) for name, vector in vectors))
    if plane.planar:
        normal = _plain(
            r"\mathbf{n}' = \mathrm{sgn}(\mathbf{z}' \cdot (\mathbf{v}' \times \mathbf{e}'))\,"
            r"\mathbf{z}'",
            "n′ = sgn(z′ · (v′ × e′)) z′",
        )
        end = "Where the arm is stretched or folded, the sign is taken as positive."
    else:
        normal = _plain(
            r"\mathbf{n}' = \mathbf{v}' \times \mathbf{e}' / |\mathbf{v}' \times \mathbf{e}'|",
            "n′ = v′ × e′ / |v′ × e′|",
        )
        end = "The elbow never lies on the line, so this is always defined."
    return [
        paragraph(text, Given(str(SHOULDER)), wrist, elbow, axis, theta(angle)),
        display(columns),
        paragraph("In that frame the unit vectors {}, {} and {} are", *map(_vector, "gnu")),
        display(
            _plain(r"\mathbf{g}' = \mathbf{v}' / |\mathbf{v}'|", "g′ = v′ / |v′|"),
            normal,
            _plain(r"\mathbf{u}' = \mathbf{n}' \times \mathbf{g}'", "u′ = n′ × g′"),
        ),
        paragraph(end),
    ]


def _matrix() -> Block:
    """B_0, and what it is equal to."""
    entries = Symbol("(b_{ij})", "(bᵢⱼ)")
    dyads = _plain(
        r"\mathbf{g}\,\mathbf{g}'^T + \mathbf{u}\,\mathbf{u}'^T + \mathbf{n}\,\mathbf{n}'^T",
        "g g′ᵀ + u u′ᵀ + n n′ᵀ",
    )
    text = (
        "The joints before the elbow turn {} into {}. So the rotation of {} is known, {}, and the "
        "equations of the shoulder are those of an orientation, {} in place of {}."
    )
    triples = (
        _plain(r"\mathbf{g}', \mathbf{u}', \mathbf{n}'", "g′, u′, n′"),
        _plain(r"\mathbf{g}, \mathbf{u}, \mathbf{n}", "g, u, n"),
    )
    shoulder, links = shoulder_target(0), product_of(range(1, SHOULDER + 1))
    step = equal(letter("B", "B", "i"), Symbol(r"A_i^{-1} B_{i-1}", "Aᵢ⁻¹ Bᵢ₋₁"))
    usual = equal(Symbol("U_i", "Uᵢ"), Symbol(r"A_i^{-1} U_{i-1}", "Aᵢ⁻¹ Uᵢ₋₁"))
    return paragraph(text, *triples, links, equal(shoulder, entries, dyads), step, usual)


def _vector(name: str) -> Symbol:
    return Symbol(rf"\mathbf{{{name}}}", name)


def _primed(name: str) -> Symbol:
    return Symbol(rf"\mathbf{{{name}}}'", f"{name}′")


def _plain(latex: str, text: str) -> Symbol:
    """A formula of vectors, as it is printed."""
    return Symbol(latex, text)


def _column(story: Story, entries: Iterable[Polynomial]) -> Formula:
    return Matrix(tuple((story.write(entry),) for entry in entries))
