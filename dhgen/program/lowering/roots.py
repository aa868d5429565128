"""Signed square roots: what they are taken of, and the guards where they end or meet."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.program.ir import Failure
from dhgen.program.lowering.context import EarlierRoot

if TYPE_CHECKING:
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.context import Lowering


@dataclass(frozen=True, slots=True)
class Reach:
    """What a square root is taken of, and what is known of its sign.

    Attributes:
        discriminant: D.
        inside: Whether D is not negative, up to rounding.
        apart: Whether D is positive beyond rounding: the roots are two.
        clear: The same beyond rounding of what is good to few digits.
        degree: How many lengths its root is a product of.
    """

    discriminant: Node
    inside: Node
    apart: Node
    clear: Node
    degree: int


def reach_of(
    context: Lowering, discriminant: Node, limits: tuple[Node, Node, Node], degree: int
) -> Reach:
    """What is known of D by what rounding may add to it."""
    builder = context.builder
    reach, merge, blur = limits
    return Reach(
        discriminant,
        inside=not_below(context, discriminant, reach),
        apart=builder.apply("less", merge, discriminant),
        clear=builder.apply("less", blur, discriminant),
        degree=degree,
    )


def not_below(context: Lowering, discriminant: Node, slack: Node) -> Node:
    """Whether D is not negative, up to rounding.

    It is above a bound that grows with the pose, and not equal to it: where squares overflow both
    are minus infinity.

    Where rows are refined, this is as much more as earlier roots that D hangs on are less
    than the arm's size: what they fix has lost as many digits. Where a joint may have another value
    instead, no more: then one that works is looked for.
    """
    builder = context.builder
    chosen = [option.flag for option in context.angles.options()]
    for root in follows(context, discriminant):
        share = root.share
        if chosen:
            share = builder.select(builder.either(chosen), builder.integer(1), share)
        discriminant = builder.mul(discriminant, share)
    grows = builder.entries[slack].value is None
    return builder.apply("less" if grows else "at_most", builder.neg(slack), discriminant)


def follows(context: Lowering, value: Node) -> list[EarlierRoot]:
    """The earlier roots that a value hangs on, where rows are refined."""
    axes = context.builder.axes_of(value)
    return [root for root in context.roots if root.axis in axes]


def signed_root(context: Lowering, suffix: str, reach: Reach, free: Node | None = None) -> Node:
    """e sqrt(D): the guard for D < 0, the new sign, and the guard where both roots meet.

    Beside a place where an earlier angle is good to few digits only, roots that meet come out a
    little apart; they are then one row, as they are.

    Args:
        context: The program in the making.
        suffix: For names.
        reach: D.
        free: Whether the step fixes nothing, so that one root is enough.
    """
    builder = context.builder
    builder.guard(reach.inside, Failure.REACH, reach.discriminant, context.angles.options())
    apart = builder.name(reach.apart, f"apart{suffix}")
    kept = builder.select(apart, reach.discriminant, builder.integer(0))
    length = builder.name(builder.apply("sqrt", kept), f"w{suffix}")
    sign = context.new_sign(suffix)
    if context.checks.refines:
        context.roots.append(_earlier(context, sign, reach, length))
    met = builder.apply("not", apart)
    for near in context.angles.near:
        blurred = builder.apply("and", near, builder.apply("not", reach.clear))
        met = builder.apply("or", met, blurred)
    keep_one(context, sign, met if free is None else builder.apply("or", met, free))
    return builder.hint(builder.mul(sign, length), f"D{suffix}")


def _earlier(context: Lowering, sign: Node, reach: Reach, length: Node) -> EarlierRoot:
    """A root for later ones; where it vanishes, the size that rounding may give it."""
    builder, scales = context.builder, context.scales
    (axis,) = builder.axes_of(sign)
    least = scales.tolerance(math.sqrt(scales.tolerances.reach), reach.degree, "none")
    kept = builder.select(reach.apart, length, least)
    return EarlierRoot(axis, builder.div(kept, scales.power(reach.degree)))


def keep_one(context: Lowering, sign: Node, met: Node) -> None:
    """Where both signs give one solution, only + keeps it."""
    builder = context.builder
    plus = builder.apply("less", builder.integer(0), sign)
    keep = builder.apply("or", plus, builder.apply("not", met))
    builder.guard(keep, Failure.MERGED)


def over(context: Lowering, sign: Node, length: Node, free: Node, suffix: str) -> Node:
    """sign / length, where the length may be none."""
    builder = context.builder
    safe = builder.hint(builder.select(free, builder.integer(1), length), f"divisor{suffix}")
    return builder.hint(builder.div(sign, safe), f"factor{suffix}")
