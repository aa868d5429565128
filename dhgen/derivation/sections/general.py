"""The inverse of an arm without a closed form: what its templates name.

The prose is `templates/derivation/general.md.jinja`, with a template for each of the algorithms:
the elimination, the offset wrist's polynomial before it, or four turns and two slides.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from dhgen.derivation.geometry import size_in_words
from dhgen.derivation.notation.names import DET_J, letter
from dhgen.derivation.sections.constant_transforms import (
    constant_matrices,
    triangle_of_the_offset_wrist,
)
from dhgen.derivation.sections.turns import turns_inside
from dhgen.derivation.text.blocks import paragraph, say
from dhgen.derivation.text.formula import ZERO, Symbol, equal
from dhgen.derivation.text.template import blocks_of
from dhgen.derivation.text.words import joined, numeral
from dhgen.general.hidden_slide import UNIT
from dhgen.general.virtual_joint import NEARLY_NONE, NEARLY_NONE_IN_DOUBT
from dhgen.kinematics.chain import Slide, Turn
from dhgen.kinematics.neighbours import EXACT, axis_triples, short_number
from dhgen.paul.refusal.unsolved import NEARLY_CONCURRENT, NEARLY_PARALLEL
from dhgen.tolerances import TOLERANCES

if TYPE_CHECKING:
    from dhgen.derivation.story import Story
    from dhgen.derivation.text.blocks import Block, Prose
    from dhgen.general.formulation import Formulation
    from dhgen.general.kernel import GeneralKernel
    from dhgen.general.offset_wrist import OffsetWrist
    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.neighbours import Triple


def general_section(
    story: Story, kernel: GeneralKernel, nearest: list[Block], example: list[Block]
) -> list[Block]:
    """What replaces the steps of Paul's method.

    Args:
        story: The arm.
        kernel: The algorithm's constants.
        nearest: The blocks on the nearest arm with a structure, where its rows are tried first.
        example: A pose in numbers.
    """
    chain, motions = story.algebra.chain, begin_with_motions(kernel, story.algebra.chain)
    loop = [joint_symbol(kernel, place) for place in range(6)]
    values = _elimination(kernel) if kernel.eliminations else _four_turns(kernel)
    if kernel.wrist is not None:
        values |= _offset_wrist(story, kernel.wrist)
        values |= {f"axis_{place + 1}": str(kernel.numbers[place]) for place in range(5)}
    if kernel.checked:
        values |= _check(kernel)
    return blocks_of(
        "general",
        eliminates=bool(kernel.eliminations),
        no_three_axes=bool(kernel.eliminations) and not kernel.pointing,
        most="sixteen" if kernel.eliminations else "eight",
        wrist=kernel.wrist is not None,
        pointing=kernel.pointing,
        checked=kernel.checked,
        given=bool(kernel.given),
        behind_all=loop[5],
        hidden=loop[kernel.first.joints[0]],
        further=_further([loop[each.joints[0]] for each in kernel.formulations[1:]]),
        joints=_joints(kernel),
        others_given=_others_given(kernel),
        near=near_blocks(chain, story.robot.length_unit),
        nearest=nearest,
        example=example,
        turns=turns_inside(story),
        closes=loop_that_closes(kernel),
        begin_with_motions=motions,
        points_behind_table=_points_behind_table(kernel, chain),
        matrices=[] if motions or not _has_six_own(kernel) else constant_matrices(story),
        shared_roots=kernel.wrist is not None and not kernel.wrist.sine,
        or_length=say(" or {}", Symbol("r_i = 0", "rᵢ = 0")) if kernel.loop.slides else say(""),
        singular=equal(DET_J, ZERO),
        size=size_in_words(chain),
        **values,
    )


def _further(hidden: list[Symbol]) -> Prose | None:
    """The joints that further formulations hide."""
    return say(", then with ".join(["{}"] * len(hidden)), *hidden) if hidden else None


def _joints(kernel: GeneralKernel) -> str:
    joints = f"the {numeral(kernel.asked)} joints"
    others = ["a turn behind them"] * kernel.checked + ["the tool's turn"] * kernel.pointing
    return joined([joints, *others]).capitalize()


def _others_given(kernel: GeneralKernel) -> str:
    """What the other joints are for."""
    others = sorted(set(range(1, 7 + len(kernel.given))) - set(kernel.numbers))
    if not others:
        return ""
    if len(others) == 1:
        return f" while joint {others[0]} keeps the value that the caller gives"
    return f" while joints {', '.join(map(str, others))} keep the values that the caller gives"


def _elimination(kernel: GeneralKernel) -> dict[str, object]:
    slides = kernel.loop.slides
    names = ("one", "two", "idle", "fifth", "sixth")
    order = zip(names, kernel.first.joints[1:], strict=True)
    right = joint_symbol(kernel, slides[0]) if kernel.slides_on_the_right else None
    joints = dict(order)
    return {
        **{name: joint_symbol(kernel, place) for name, place in joints.items()},
        **{f"functions_{name}": _functions(kernel, place) for name, place in joints.items()},
        "hidden_first": loop_from_the_hidden_joint(kernel),
        "hides_a_slide": kernel.hides_a_slide,
        "right_slide": right,
        "slide_unit": f"{UNIT:g}",
        "variables": _variables(kernel),
    }


def _functions(kernel: GeneralKernel, place: int) -> Symbol:
    """1, the cosine and the sine of a turn; 1, a length and its square."""
    symbol, number = joint_symbol(kernel, place), str(kernel.numbers[place])
    if place in kernel.loop.slides:
        return Symbol(rf"1, {symbol.latex}, {symbol.latex}^2", f"1, {symbol.text}, {symbol.text}²")
    c, s = letter("c", "c", number), letter("s", "s", number)
    return Symbol(f"1, {c.latex}, {s.latex}", f"1, {c.text}, {s.text}")


def _variables(kernel: GeneralKernel) -> Prose:
    """In which the equations are polynomials: of both partners of the hidden joint."""
    partners = kernel.first.joints[1:3]
    symbols = [joint_symbol(kernel, place) for place in partners]
    slide = [place in kernel.loop.slides for place in partners]
    if not any(slide):
        return say("the half-angle tangents of {} and {}", *symbols)
    texts = ["the length {}" if each else "the half-angle tangent of {}" for each in slide]
    return say(" and ".join(texts), *symbols)


def _four_turns(kernel: GeneralKernel) -> dict[str, object]:
    """The turns, the hidden one first, and the slides, in the order of the loop from there on."""
    slides, order = kernel.loop.slides, kernel.first.joints
    turns = [joint_symbol(kernel, joint) for joint in order if joint not in slides]
    lengths = [joint_symbol(kernel, joint) for joint in order if joint in slides]
    return {
        **{f"turn_{number}": turn for number, turn in enumerate(turns, start=1)},
        **{f"slide_{number}": length for number, length in enumerate(lengths, start=1)},
    }


def _offset_wrist(story: Story, wrist: OffsetWrist) -> dict[str, object]:
    upper, lower, angle = triangle_of_the_offset_wrist(story)
    return {
        "upper": equal(Symbol("a", "a"), upper),
        "lower": equal(Symbol("r", "r"), lower),
        "angle": equal(Symbol(r"\psi", "ψ"), angle),
        "bent": bool(wrist.sine),
    }


def _has_six_own(kernel: GeneralKernel) -> bool:
    """Whether the loop is made of the arm's joints, all of them and no other."""
    return not kernel.given and kernel.asked == len(kernel.numbers)


def _check(kernel: GeneralKernel) -> dict[str, object]:
    """What a joint too few for the task takes: a turn that the arm does not have, and a check."""
    count = kernel.asked
    return {
        "turn": joint_symbol(kernel, count),
        "last": joint_symbol(kernel, count - 1),
        "count": numeral(count),
        "more": numeral(count + 1),
        "nearly_none": f"{NEARLY_NONE:g}",
        "nearly_none_in_doubt": f"{NEARLY_NONE_IN_DOUBT:g}",
        "consistent": _power(TOLERANCES.consistent),
        "refined": _power(TOLERANCES.refined),
    }


def _power(value: float) -> str:
    """A power of ten, without the zero that Python puts before its exponent."""
    return f"{value:.0e}".replace("e-0", "e-")


MISSED = "What keeps this arm from a closed form: "


def near_blocks(chain: Chain, unit: str) -> list[Block]:
    """By how much axes miss one point or one direction; lengths are in `unit`."""
    triples = [t for t in axis_triples(chain) if min(t.tilt, t.miss / chain.size) >= EXACT]
    apart = [t for t in triples if t.miss < NEARLY_CONCURRENT * chain.size]
    leaning = [t for t in triples if t not in apart and t.tilt < NEARLY_PARALLEL]
    clauses = [f"{_axes(t)} are not quite parallel but {_degrees(t)} apart" for t in leaning]
    clauses += [f"{_axes(t)} do not meet in one point: {_missed(t, chain, unit)}" for t in apart]
    return [paragraph(f"{MISSED}{'; '.join(clauses)}.")] if clauses else []


def _missed(triple: Triple, chain: Chain, unit: str) -> str:
    """How three axes lie that miss one point."""
    before, middle, behind = triple.joints
    near, far, between = (gap > EXACT * chain.size for gap in triple.gaps)
    length = f"{short_number(triple.miss, 4)} {unit}"
    if not (near or far):
        return f"axes {before} and {behind} meet axis {middle} at points {length} apart"
    if between or (near and far):
        return (
            "of the distances of neighbours, and of the feet of their common normals on axis "
            f"{middle}, the largest is {length}"
        )
    met, passing = ((before, middle), behind) if far else ((middle, behind), before)
    return f"axes {met[0]} and {met[1]} meet, and axis {passing} passes their point at {length}"


def _axes(triple: Triple) -> str:
    return f"axes {joined([str(joint) for joint in triple.joints])}"


def _degrees(triple: Triple) -> str:
    return f"{short_number(math.degrees(triple.tilt), 3)} degrees"


def loop_that_closes(kernel: GeneralKernel) -> Symbol:
    """The forward model as a loop."""
    joints = [_motion(kernel, place) for place in range(6)]
    links = [rf"{symbol.latex}\,K_{k}" for k, symbol in enumerate(joints[:5])]
    plain = " ".join(f"{symbol.text} K{k}" for k, symbol in enumerate(joints[:5]))
    return Symbol(
        rf"{' '.join(links)}\,{joints[5].latex} = P, "
        r"\qquad P = C_0^{-1}\,\mathit{POS}\,C_6^{-1}",
        f"{plain} {joints[5].text} = P,  P = C0⁻¹ POS C6⁻¹",
    )


def begin_with_motions(kernel: GeneralKernel, chain: Chain) -> bool:
    """Whether the transform between two joints is one link's constant part."""
    own = kernel.asked == len(chain.links) == len(kernel.numbers)
    return own and all(isinstance(link[0], Turn | Slide) for link in chain.links)


def _points_behind_table(kernel: GeneralKernel, chain: Chain) -> bool:
    """Whether the tool's turn follows five links, each a turn and then its constant part."""
    own = kernel.pointing and kernel.asked == len(chain.links) == chain.dof
    return own and all(isinstance(link[0], Turn) for link in chain.links)


def _motion(kernel: GeneralKernel, place: int) -> Symbol:
    number = kernel.numbers[place]
    if place in kernel.loop.slides:
        return Symbol(f"T_z(r_{number})", f"Tz(r{number})")
    return Symbol(rf"R_z(\theta_{number})", f"Rz(θ{number})")


def loop_from_the_hidden_joint(kernel: GeneralKernel) -> Symbol:
    """The loop with three joints on the left, the hidden one first, and three on the right."""
    first = kernel.first
    turns = [_moved(kernel, joint, first.sign) for joint in first.joints]
    back = [_moved(kernel, joint, -first.sign) for joint in first.joints]
    links = [_link(first, joint) for joint in first.joints]
    undone = [_link(first, joint, undone=True) for joint in first.joints]
    left = [links[5], turns[0], links[0], turns[1], links[1], turns[2], links[2]]
    right = [back[5], undone[4], back[4], undone[3], back[3]]
    sides = left, right
    return Symbol(
        " = ".join(r"\,".join(each.latex for each in side) for side in sides),
        " = ".join(" ".join(each.text for each in side) for side in sides),
    )


def _link(first: Formulation, joint: int, *, undone: bool = False) -> Symbol:
    """The transform behind a joint, in the direction in which the loop is read; or its inverse."""
    number, inverted = first.behind(joint)
    name, inverse = "P" if number is None else f"K_{number}", inverted != undone
    return Symbol(name + "^{-1}" * inverse, name.replace("_", "") + "⁻¹" * inverse)


def _moved(kernel: GeneralKernel, place: int, sign: int) -> Symbol:
    """The motion of a joint, or back."""
    motion = _motion(kernel, place)
    if sign > 0:
        return motion
    return Symbol(motion.latex.replace("(", "(-"), motion.text.replace("(", "(−"))


def joint_symbol(kernel: GeneralKernel, place: int) -> Symbol:
    """The angle or length of a joint of the loop, from 0."""
    number = kernel.numbers[place]
    if place in kernel.loop.slides:
        return Symbol(f"r_{number}", f"r{number}")
    return Symbol(rf"\theta_{number}", f"θ{number}")
