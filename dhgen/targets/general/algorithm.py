"""What the templates of the general algorithm name."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.general.loop import LINKS
from dhgen.targets.angles import Angles
from dhgen.targets.general.arctangent import GeneralArctangent
from dhgen.targets.general.arm import Arm, arm
from dhgen.targets.general.equations import Equations, equations
from dhgen.targets.general.links import Links, links
from dhgen.targets.general.sizes import Sizes
from dhgen.targets.general.spelling import CSpelling, c_spelling
from dhgen.targets.general.tables import Tables, tables
from dhgen.targets.general.tolerances import Tolerances
from dhgen.targets.general.wrist import Wrist, wrist

if TYPE_CHECKING:
    from dhgen.general.kernel import GeneralKernel


@dataclass(frozen=True, slots=True)
class Algorithm:
    """In every language.

    Attributes:
        p: What names begin with.
        P: The same in capitals.
        arm: How the arm is solved.
        tables: Arrays of numbers.
        equations: How they come from the loop.
        wrist: The numbers of an offset wrist, where there is one.
        sizes: Room, and how often things are repeated.
        tolerances: What counts as what.
        angles: Parts of a turn.
    """

    p: str
    P: str
    arm: Arm
    tables: Tables
    equations: Equations
    wrist: Wrist | None
    sizes: Sizes
    tolerances: Tolerances
    angles: Angles


@dataclass(frozen=True, slots=True)
class CAlgorithm:
    """In C only.

    Attributes:
        links: How the links of the loop are made.
        spelling: How slides and given joints are written.
        arctangent: What it is made of.
    """

    links: Links
    spelling: CSpelling
    arctangent: GeneralArctangent


def algorithm(kernel: GeneralKernel, name: str) -> Algorithm:
    """What both languages write alike of an arm."""
    return Algorithm(
        p=name,
        P=name.upper(),
        arm=arm(kernel),
        tables=tables(kernel, name),
        equations=equations(kernel),
        wrist=wrist(kernel),
        sizes=Sizes(),
        tolerances=Tolerances(),
        angles=Angles(),
    )


def c_algorithm(kernel: GeneralKernel, name: str) -> CAlgorithm:
    """What C writes of it."""
    places = [f"loop->link[{i}]" for i in range(LINKS)]
    return CAlgorithm(
        links=links(kernel, [*places, "P", "right"], "free_joints"),
        spelling=c_spelling(kernel, name),
        arctangent=GeneralArctangent(),
    )
