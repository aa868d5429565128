"""An arm of the general algorithm: its sizes and its table, as C writes them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.printing.templates import render
from dhgen.targets.general.table import general_table, traits
from dhgen.targets.general.wrist import wrist

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel


def general_sizes(upper: str, kernel: GeneralKernel) -> list[str]:
    """What the algorithm is compiled for; for a robot, by its name in capitals."""
    return [
        f"#define DHGEN_TRAITS {traits(kernel):#x}u /* what the arm needs of it */",
        f"#ifdef {upper}_LANES",
        f"#define DHGEN_GENERAL_LANES {upper}_LANES",
        "#endif",
    ]


def general_source(kernel: GeneralKernel) -> str:
    """The table `general`."""
    return render("c/general.c.jinja", table=general_table(kernel), wrist=wrist(kernel))
