"""What the set-up hands to the reference solver and to the writers of code."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin
from typing import TYPE_CHECKING

from dhgen.general.links import Value

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.general.formulation import Formulation
    from dhgen.general.loop import Loop
    from dhgen.general.offset_wrist import OffsetWrist


MOST = 16  # solutions


def method_name(*, slides: bool) -> str:
    """What the method is called, of an arm without and with a slide to be solved for."""
    return "general 5R1P" if slides else "general 6R"


@dataclass(frozen=True, slots=True)
class Score:
    """How well a formulation does on the witnesses.

    Attributes:
        noise: Median of the harmonics 9 to 11 of the determinant over its largest value; they
            would be zero without rounding.
        typical: Median displacement of the true root by rounding [rad]. Near 1e-8 or above when
            every root is double.
        worst: Its 99 % quantile [rad].
    """

    noise: float
    typical: float
    worst: float


@dataclass(frozen=True, slots=True)
class GeneralKernel:
    """Everything about an arm that does not depend on the pose.

    Attributes:
        loop: The arm as a loop of six joints, in arm sizes.
        first: The formulation that is tried first.
        second: One with another hidden joint, for poses where the first one fails; None when
            the arm's structure leaves only one.
        scores: Of `first` and `second`.
        wrist: When the arm has an offset wrist, whose polynomial is known in closed form: it is
            tried before the formulations.
        numbers: The joints' numbers in the arm, from 1.
        given: Sign and offset of every joint whose value the caller gives: its angle or length is
            sign q + offset.
    """

    loop: Loop
    first: Formulation
    second: Formulation | None
    scores: tuple[Score, ...]
    wrist: OffsetWrist | None = None
    numbers: tuple[int, ...] = (1, 2, 3, 4, 5, 6)
    given: tuple[tuple[int, float], ...] = ()

    @property
    def rows(self) -> int:
        """How many solutions an arm may have (M. Raghavan, B. Roth, 1990)."""
        return MOST

    @property
    def method(self) -> str:
        """What the method is called."""
        return method_name(slides=self.loop.slide is not None)

    @property
    def formulations(self) -> tuple[Formulation, ...]:
        """The one or two formulations in the order in which they are tried."""
        return (self.first,) if self.second is None else (self.first, self.second)

    def held(self, free: Sequence[float]) -> tuple[Value, ...]:
        """Angles and lengths of the joints whose values the caller gives."""
        values = [s * q + offset for (s, offset), q in zip(self.given, free, strict=True)]
        return tuple(Value(x, cos(x), sin(x)) for x in values)
