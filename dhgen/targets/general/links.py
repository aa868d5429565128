"""How the links of the loop come from constants and from joints whose values the caller gives."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.general.vanishing import THERE

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.general.kernel import GeneralKernel
    from dhgen.general.links import Held
    from dhgen.general.vanishing import Vanishing


@dataclass(frozen=True, slots=True)
class GivenJoint:
    """A joint whose value the caller gives.

    Attributes:
        place: Which of them, from 0.
        value: Its angle or length.
        turns: Whether it turns.
    """

    place: int
    value: str
    turns: bool


@dataclass(frozen=True, slots=True)
class HeldMotion:
    """Such a joint inside a link: `motion` by `by`, and which of the constants stands behind it."""

    motion: str
    by: str
    behind: int


@dataclass(frozen=True, slots=True)
class LinkText:
    """A link: where it goes, which of the constants it begins with, and what follows."""

    to: str
    first: int
    held: tuple[HeldMotion, ...]


@dataclass(frozen=True, slots=True)
class Special:
    """A value of such a joint at which formulations vanish.

    Attributes:
        close: What is next to nothing there.
        ahead: What is positive; empty for a length.
        within: How little next to nothing is.
        formulations: Bit i: formulation i is not tried there.
    """

    close: str
    ahead: str
    within: str
    formulations: str


@dataclass(frozen=True, slots=True)
class Links:
    """The links K0 ... K4, L and R.

    Attributes:
        given: The joints whose values the caller gives.
        turning: Whether one of them turns inside a link.
        sliding: Whether one of them slides there.
        every: The links.
        special: Values that are given at which formulations vanish.
    """

    given: tuple[GivenJoint, ...]
    turning: bool
    sliding: bool
    every: tuple[LinkText, ...]
    special: tuple[Special, ...]


def links(kernel: GeneralKernel, to: Sequence[str], array: str) -> Links:
    """The links of an arm.

    Args:
        kernel: The arm.
        to: Where its links go.
        array: Where the values are that the caller gives.
    """
    held = [each for link in kernel.links for each, _ in link.rest]
    every = _links(kernel, to)
    return Links(
        given=_given(kernel, held, array),
        turning=any(not each.slides for each in held),
        sliding=any(each.slides for each in held),
        every=every,
        special=tuple(_special(each, kernel.loop.size) for each in kernel.vanishing),
    )


def _special(vanishing: Vanishing, size: float) -> Special:
    """A quarter turn or no length at all."""
    place, value = vanishing.place, vanishing.value
    formulations = hex(sum(1 << number for number in vanishing.formulations))
    if vanishing.slides:
        return Special(f"given_{place}", "", repr(THERE * size), formulations)
    across, along = ("s", "c") if value.sine == 0.0 else ("c", "s")
    sign = "-" if value.cosine + value.sine < 0.0 else ""
    return Special(f"{across}_{place}", f"{sign}{along}_{place}", repr(THERE), formulations)


def _given(kernel: GeneralKernel, held: Sequence[Held], array: str) -> tuple[GivenJoint, ...]:
    slides = {each.place: each.slides for each in held}
    return tuple(
        GivenJoint(
            place=place,
            value=f"{'-' if sign < 0 else ''}{array}[{place}]{_plus(offset)}",
            turns=not slides[place],
        )
        for place, (sign, offset) in enumerate(kernel.given)
    )


def _plus(offset: float) -> str:
    if not offset:
        return ""
    return f" - {-offset!r}" if offset < 0.0 else f" + {offset!r}"


def _links(kernel: GeneralKernel, to: Sequence[str]) -> tuple[LinkText, ...]:
    texts = []
    first = 0
    for link, place in zip(kernel.links, to, strict=True):
        behind = range(first + 1, first + 1 + len(link.rest))
        motions = [_motion(held, at) for (held, _), at in zip(link.rest, behind, strict=True)]
        texts.append(LinkText(place, first, tuple(motions)))
        first = behind.stop
    return tuple(texts)


def _motion(held: Held, behind: int) -> HeldMotion:
    if held.slides:
        return HeldMotion("slide", f"{held.factor!r} * given_{held.place}", behind)
    sign = "-" if held.factor < 0.0 else ""
    return HeldMotion("turn", f"c_{held.place}, {sign}s_{held.place}", behind)
