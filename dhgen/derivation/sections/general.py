"""The inverse of an arm without a closed form: the elimination in words, equations and numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation.sections.elimination import elimination
from dhgen.derivation.sections.four_turns import four_turns
from dhgen.derivation.sections.general_closing import general_closing
from dhgen.derivation.sections.general_loop import (
    joint_symbol,
    loop_letters,
    loop_that_closes,
)
from dhgen.derivation.sections.near import near_blocks
from dhgen.derivation.sections.no_turn import check, one_more_turn
from dhgen.derivation.sections.offset_wrist import offset_wrist
from dhgen.derivation.text.blocks import Display, Heading, Paragraph, paragraph, say
from dhgen.derivation.text.words import joined, numeral

if TYPE_CHECKING:
    from dhgen.derivation.text.blocks import Block
    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain


POINTING = (
    "The task names where the tool is and where its z axis points, and leaves its turn about that "
    "axis open. That turn, {}, is taken as a sixth joint behind the tool: with any choice of the x "
    "and y axes the pose is then complete, and the value of the sixth joint is not needed."
)
UNRELATED = "No three neighbouring axes{} are parallel or meet in one point"
_FIRST = "an equation for the last of them, which this wrist allows, or by "
OF_MOVING = " of the joints that move"


def general_section(kernel: GeneralKernel, chain: Chain, unit: str) -> list[Block]:
    """What replaces the steps of Paul's method; `unit` is that of lengths."""
    blocks: list[Block] = [
        Heading(2, say("Inverse")),
        paragraph(f"{_why(kernel)} {_most(kernel)}"),
        *([paragraph(POINTING, joint_symbol(kernel, 5))] if kernel.pointing else []),
        *([one_more_turn(kernel)] if kernel.checked else []),
        *near_blocks(chain, unit),
        Paragraph(
            say("The forward model is a loop that closes:"),
            say("The loop."),
        ),
        Display((loop_that_closes(kernel),)),
        loop_letters(kernel, chain),
    ]
    if kernel.wrist is not None:
        blocks += offset_wrist(kernel, kernel.wrist, unit)
    if kernel.eliminations:
        blocks += elimination(kernel, chain)
    else:
        blocks += four_turns(kernel)
    return [
        *blocks,
        *_rest(kernel),
        *([check(kernel, chain)] if kernel.checked else []),
        *general_closing(kernel),
    ]


def _why(kernel: GeneralKernel) -> str:
    """Why the joints do not come one after the other, and what finds them."""
    steps = "order of the equations of Paul's method gives the joints one after the other."
    if kernel.eliminations:
        unrelated = UNRELATED.format(OF_MOVING if kernel.given else "")
        beginning = f"No {steps}" if kernel.pointing else f"{unrelated}, and no {steps}"
        return (
            f"{beginning} {_joints(kernel)} are found together{_given(kernel)}, by "
            f"{_FIRST if kernel.wrist else ''}the elimination of M. Raghavan and B. Roth (1993)."
        )
    return (
        f"No {steps} {_joints(kernel)}, four turns and two slides, are found "
        f"together{_given(kernel)}: the directions give three turns by the fourth, and the "
        "position an equation in that one."
    )


def _most(kernel: GeneralKernel) -> str:
    count = "sixteen" if kernel.eliminations else "eight"
    if kernel.checked:  # the arm itself has fewer as a rule, as `one_more_turn` says
        return f"Together they have at most {count} solutions."
    return f"An arm of this kind has at most {count} solutions."


def _joints(kernel: GeneralKernel) -> str:
    joints = f"the {numeral(kernel.asked)} joints"
    others = ["a turn behind them"] * kernel.checked + ["the tool's turn"] * kernel.pointing
    return joined([joints, *others]).capitalize()


def _given(kernel: GeneralKernel) -> str:
    """What the other joints are for."""
    others = sorted(set(range(1, 7 + len(kernel.given))) - set(kernel.numbers))
    if not others:
        return ""
    if len(others) == 1:
        return f" while joint {others[0]} keeps the value that the caller gives"
    return f" while joints {', '.join(map(str, others))} keep the values that the caller gives"


def _rest(kernel: GeneralKernel) -> list[Block]:
    others = [joint_symbol(kernel, each.joints[0]) for each in kernel.formulations[1:]]
    blocks: list[Block] = [
        Paragraph(
            say(
                "A simple root belongs to one solution and a double root to two. If the solutions "
                "found are as many as these roots, and their number is even, none is "
                "missing. Otherwise "
                + (
                    f"the same is done with {', then with '.join('{}' for _ in others)} in the "
                    f"place of {{}}, and then from a nearby pose."
                    if others
                    else "the search is repeated from a nearby pose and followed back."
                ),
                *others,
                *([joint_symbol(kernel, kernel.first.joints[0])] if others else []),
            ),
            say("4. The certificate."),
        ),
        paragraph(
            "Rows are ordered by the value of joint 1, then of joint 2 and so on. Where roots meet "
            "or the certificate fails, damped least squares from the seed (joint values that the "
            "caller may give) and from a few evenly spread starts add what they find."
        ),
    ]
    return blocks
