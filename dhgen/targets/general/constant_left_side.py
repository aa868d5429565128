"""The left side of a formulation that has the pose on its right: monomials that are constant."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from dhgen.targets.general.numbers import rows

if TYPE_CHECKING:
    from dhgen.general.formulation import Formulation
    from dhgen.general.kernel import GeneralKernel

LEFT = (0, 1, 2, 5)  # the links on that side


def constant_left(kernel: GeneralKernel, formulation: Formulation) -> tuple[str, ...]:
    """The monomials of the left side, a row for each, 27 numbers in it; none where they vary.

    They do with the pose, and with joints whose values the caller gives. Where a polynomial in
    closed form is tried before a formulation they are not worth their room.
    """
    from dhgen.general.trial import left_side  # noqa: PLC0415  takes time

    around = kernel.loop.links
    links = [formulation.behind(formulation.joints[place])[0] for place in LEFT]
    if kernel.closed or any(link is None or around[link].rest for link in links):
        return ()
    constants = [np.array(link.first)[None] for link in around]
    every = formulation.links(constants, np.eye(4)[None])
    return rows(left_side(formulation, every, kernel.loop.slides).tolist())
