"""An arm of the general algorithm as a table in C, which its file hands to the runtime."""

from __future__ import annotations

from dataclasses import dataclass
from math import isinf
from typing import TYPE_CHECKING

from dhgen.general.loop import out_of_reach
from dhgen.general.vanishing import THERE
from dhgen.targets.general.constant_left_side import constant_left
from dhgen.targets.general.numbers import rigid, row

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel
    from dhgen.general.vanishing import Vanishing

# The bits of dhgen/runtime/c/dhgen/general/arm.h; below them are the joints of the loop that slide.
HIDDEN_SLIDE, LEFT_SLIDE, RIGHT_SLIDE, OFFSET_WRIST, FOUR_TURNS = (1 << n for n in range(6, 11))


@dataclass(frozen=True, slots=True)
class LeftSide:
    """The left side of a formulation, where it is constant.

    Attributes:
        name: What C calls it.
        joints: The formulation's joints.
        rows: Its monomials.
    """

    name: str
    joints: str
    rows: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Counts:
    """How many rows arrays have."""

    formulations: int
    constants: int
    motions: int
    given: int
    special: int


@dataclass(frozen=True, slots=True)
class GeneralTable:
    """Entries between braces, as C writes them.

    Attributes:
        most: Solutions that it may have.
        size: The length that is one in the loop.
        per_size: Its inverse.
        reach: The square of what is out of reach for all links in line.
        advance_c: Cosines of what is added to the joints' angles in the loop.
        advance_s: Their sines.
        constants: What links consist of, three rows of four.
        infinite_order: Of the determinant's zero where a hidden length is infinite, half of it.
        left_sides: Those that are constant.
        formulations: In the order in which they are tried.
        links: K0 ... K4, L and R: first constant, first motion, number of motions.
        motions: In links.
        given: The joints whose values the caller gives.
        given_shares: What these values add to each of them, where some do.
        special: Their values at which formulations vanish.
        counts: How many rows these have.
        tables: The arrays of the last two and the offset wrist by their names, 0 for none.
    """

    most: int
    size: float
    per_size: float
    reach: str
    advance_c: str
    advance_s: str
    constants: tuple[str, ...]
    infinite_order: int
    left_sides: tuple[LeftSide, ...]
    formulations: tuple[str, ...]
    links: str
    motions: tuple[str, ...]
    given: tuple[str, ...]
    given_shares: tuple[str, ...]
    special: tuple[str, ...]
    counts: Counts
    tables: str


def general_table(kernel: GeneralKernel) -> GeneralTable:
    """The table of an arm."""
    lefts = [constant_left(kernel, each) for each in kernel.formulations]
    names = [f"left_{number}" if left else "0" for number, left in enumerate(lefts)]
    joints = [row(each.joints) for each in kernel.formulations]
    signs = [repr(float(each.sign)) for each in kernel.formulations]
    loop, farthest = kernel.loop, out_of_reach(kernel.loop)
    constants = tuple(rigid(K) for link in kernel.links for K in link.constants)
    motions = tuple(
        f"{held.place}, {held.factor!r}" for link in kernel.links for held, _ in link.rest
    )
    given = _given(kernel)
    special = tuple(_special(each, loop.size) for each in kernel.vanishing)
    tables = (
        "given" if given else "0",
        "special" if special else "0",
        "&wrist" if kernel.wrist else "0",
    )
    return GeneralTable(
        most=kernel.rows,
        size=loop.size,
        per_size=1.0 / loop.size,
        reach="HUGE_VAL" if isinf(farthest) else repr(farthest),
        advance_c=row(c for c, _ in loop.advances),
        advance_s=row(s for _, s in loop.advances),
        constants=constants,
        infinite_order=kernel.first.order if kernel.hides_a_slide else 0,
        left_sides=tuple(
            LeftSide(*each) for each in zip(names, joints, lefts, strict=True) if each[2]
        ),
        formulations=tuple(
            f"{{ {all_joints} }}, {sign}, {left}"
            for all_joints, sign, left in zip(joints, signs, names, strict=True)
        ),
        links=_links(kernel),
        motions=motions,
        given=given,
        given_shares=tuple(map(row, kernel.given_shares)),
        special=special,
        counts=Counts(len(joints), len(constants), len(motions), len(given), len(special)),
        tables=", ".join(tables),
    )


def traits(kernel: GeneralKernel) -> int:
    """What an arm is like, as bits."""
    flags = {
        HIDDEN_SLIDE: kernel.hides_a_slide,
        LEFT_SLIDE: kernel.slides_beside,
        RIGHT_SLIDE: kernel.slides_on_the_right,
        OFFSET_WRIST: kernel.wrist is not None,
        FOUR_TURNS: not kernel.eliminations,
    }
    slides = sum(1 << place for place in kernel.loop.slides)
    return slides + sum(flag for flag, holds in flags.items() if holds)


def _links(kernel: GeneralKernel) -> str:
    texts, constant, motion = [], 0, 0
    for link in kernel.links:
        texts.append(f"{{ {constant}, {motion}, {len(link.rest)} }}")
        constant += len(link.constants)
        motion += len(link.rest)
    return ", ".join(texts)


def _given(kernel: GeneralKernel) -> tuple[str, ...]:
    """An offset of -0.0 leaves every value as it is, zeros of both signs too."""
    slides = {held.place: held.slides for link in kernel.links for held, _ in link.rest}
    shares = [any(row) for row in kernel.given_shares] or [False] * len(kernel.given)
    return tuple(
        f"{int(slides[place])}, {float(sign)!r}, {offset or -0.0!r}, "
        + (f"given_shares[{place}]" if shares[place] else "0")
        for place, (sign, offset) in enumerate(kernel.given)
    )


def _special(vanishing: Vanishing, size: float) -> str:
    """A quarter turn or no length at all."""
    value = vanishing.value
    formulations = hex(sum(1 << number for number in vanishing.formulations))
    if vanishing.slides:
        return f"{vanishing.place}, 0, 0.0, {THERE * size!r}, {formulations}"
    across = int(value.sine == 0.0)
    sign = -1.0 if value.cosine + value.sine < 0.0 else 1.0
    return f"{vanishing.place}, {across}, {sign!r}, {THERE!r}, {formulations}"
