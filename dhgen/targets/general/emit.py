"""Fills in the templates of the general algorithm."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.printing.templates import named
from dhgen.targets.general.algorithm import algorithm
from dhgen.targets.general.rows import rows

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain
    from dhgen.targets.writing import Writing


def source(kernel: GeneralKernel, name: str, writing: Writing) -> str:
    """The function `<name>_general`, with all that it needs but <math.h>, numba and numpy."""
    own = named(writing.algorithm(kernel, name))
    return writing.filled("general/kernel", **named(algorithm(kernel, name)), **own)


def all_joints(kernel: GeneralKernel, chain: Chain, name: str, writing: Writing) -> str:
    """The function `all_joints`; it calls `<name>_general` and the descent."""
    solved = chain.solved  # with signs and offsets of joint values behind angles and lengths
    return writing.filled(
        "general/rows",
        p=name,
        rows=rows(kernel, chain),
        facing=writing.array("facing", [repr(float(joint.sign)) for joint in solved]),
        zero=writing.array("zero", [repr(joint.offset) for joint in solved]),
        spelling=writing.algorithm(kernel, name).spelling,
    )
