"""The loop of a general arm for the runtime."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.general.loop import out_of_reach
from dhgen.general.vanishing import THERE
from dhgen.numerical.runtime_arm import twelve
from dhgen.runtime.python.general.arm import Formulation, Inside, Link, Loop, Special, Wrist

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel
    from dhgen.general.links import Link as OwnLink
    from dhgen.general.vanishing import Vanishing


def runtime_loop(kernel: GeneralKernel) -> Loop:
    """The loop of a kernel."""
    loop = kernel.loop
    hidden, right = kernel.hides_a_slide, kernel.slides_on_the_right
    return Loop(
        size=loop.size,
        reach=out_of_reach(loop),
        links=tuple(map(_link, kernel.links)),
        advances=loop.advances,
        formulations=tuple(Formulation(f.joints, float(f.sign)) for f in kernel.formulations),
        slides=loop.slides,
        side="hidden" if hidden else "right" if right else "left",
        order=kernel.first.order if hidden else 0,
        given=tuple((float(sign), float(offset)) for sign, offset in kernel.given),
        given_shares=kernel.given_shares,
        special=tuple(_special(each, loop.size) for each in kernel.vanishing),
        wrist=wrist_numbers(kernel),
        pointing=kernel.pointing,
    )


def _link(link: OwnLink) -> Link:
    return Link(
        twelve(link.first),
        tuple(
            Inside(held.place, held.slides, held.factor, twelve(behind))
            for held, behind in link.rest
        ),
    )


def _special(vanishing: Vanishing, size: float) -> Special:
    """A quarter turn, or no length at all."""
    if vanishing.slides:
        return Special(vanishing.place, 0.0, 0.0, THERE * size, vanishing.formulations)
    value = vanishing.value
    return Special(vanishing.place, value.cosine, value.sine, THERE, vanishing.formulations)


def wrist_numbers(kernel: GeneralKernel) -> Wrist | None:
    """The offset wrist, where there is one."""
    arm = kernel.wrist
    if arm is None:
        return None
    K0, K1, K2, K3, _ = (link.first for link in kernel.loop.links)
    elbow = [K1[i][3] + arm.elbow * K1[i][2] for i in range(2)]
    centre = [K2[i][3] + arm.wrist_4 * K2[i][2] for i in range(2)]
    return Wrist(
        shoulder=arm.shoulder,
        wrist=arm.wrist_5,
        upper=arm.upper,
        lower=arm.lower,
        cosine=arm.cosine,
        sine=arm.sine,
        flip=arm.flip,
        sources=(K0[0][2], K0[1][2], *elbow, *centre, K3[0][2], K3[1][2]),
    )
