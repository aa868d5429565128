"""What the set-up hands to the runtime and to the writers of code."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin
from typing import TYPE_CHECKING

from dhgen.general.formulation import OTHERS
from dhgen.general.four_turns import FourTurns
from dhgen.general.links import Value
from dhgen.general.loop import JOINTS
from dhgen.method import Method

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.general.formulation import Formulation
    from dhgen.general.links import Link
    from dhgen.general.loop import Loop
    from dhgen.general.offset_wrist import OffsetWrist
    from dhgen.general.vanishing import Vanishing


MOST = 16  # solutions
SLIDES_OF_FOUR_TURNS = 2
# Harmonics beyond the eighth that are not rounding: the determinant vanishes identically, or the
# formulation has another degree.
NOISE_LIMIT = 1e-9
# A true angle that is displaced by more is no root at all: rounding moves even a triple one less.
NO_ROOT = 1e-3
# A ratio of singular values: of an angle that is not determined it is rounding, of axes which are
# parallel but for a calibration it is above 1e-5. What is emitted squares it.
UNDETERMINED = 1e-6

MOST_OF_FOUR_TURNS = 8


def general_method(slides: int) -> Method:
    """The method, by how many of the joints to be solved for slide."""
    return (Method.GENERAL_6R, Method.GENERAL_5R1P, Method.GENERAL_4R2P)[slides]


def most_solutions(slides: int) -> int:
    """How many solutions an arm may have, by how many of its joints slide.

    16 with one at most (M. Raghavan, B. Roth, 1990), 8 with two.
    """
    return MOST_OF_FOUR_TURNS if slides == SLIDES_OF_FOUR_TURNS else MOST


@dataclass(frozen=True, slots=True)
class Score:
    """How well a formulation does on the witnesses.

    Attributes:
        noise: Median of the harmonics 9 to 11 of the determinant over its largest value; they
            would be zero without rounding.
        typical: Median displacement of the true root by rounding [rad]. Near 1e-8 or above when
            every root is double.
        worst: Its 99 % quantile [rad].
        determined: How well φ5 follows from φ1, φ2 and φ3: 0 where a root belongs to two solutions,
            of which one would be lost, and the certificate would not notice. None where all joints
            follow in closed form: of an arm with two slides.
    """

    noise: float
    typical: float
    worst: float
    determined: float | None

    @property
    def fails(self) -> bool:
        """Whether there is no polynomial to speak of, or not one with a root for each solution."""
        no_polynomial = self.noise >= NOISE_LIMIT or self.typical >= NO_ROOT
        return no_polynomial or (self.determined is not None and self.determined <= UNDETERMINED)


@dataclass(frozen=True, slots=True)
class GeneralKernel:
    """Everything about an arm that does not depend on the pose.

    Attributes:
        loop: The arm as a loop of six joints, in arm sizes.
        formulations: In the order in which they are tried; the second one, for poses where the
            first one fails, with another hidden joint, unless the arm's structure leaves only one;
            then formulations for values of held joints at which the former vanish.
        scores: Of the formulations.
        vanishing: These values, and the formulations that are not tried there.
        wrist: When the arm has an offset wrist, whose polynomial is known in closed form: it is
            tried before the formulations.
        numbers: The joints' numbers in the arm, from 1.
        given: Sign and offset of every joint whose value the caller gives: its angle or length is
            sign q + offset.
        given_shares: What given values add to that, a factor of every one of them for each; empty
            where none adds to another's.
        pointing: Whether the last joint of the loop is not one of the arm's, but the tool's turn
            about its own axis, which the task leaves open.
        checked: Whether the joint of the loop behind the arm's is a turn that the arm does not
            have: where its angle does not come out as zero the arm cannot take the pose.
    """

    loop: Loop
    formulations: tuple[Formulation, ...]
    scores: tuple[Score, ...]
    vanishing: tuple[Vanishing, ...] = ()
    wrist: OffsetWrist | None = None
    numbers: tuple[int, ...] = (1, 2, 3, 4, 5, 6)
    given: tuple[tuple[int, float], ...] = ()
    given_shares: tuple[tuple[float, ...], ...] = ()
    pointing: bool = False
    checked: bool = False

    @property
    def links(self) -> tuple[Link, ...]:
        """The links of the loop, and the transforms before and behind the pose."""
        return (*self.loop.links, self.loop.left, self.loop.right)

    @property
    def rows(self) -> int:
        """How many solutions an arm may have."""
        return most_solutions(len(self.loop.slides))

    @property
    def degree(self) -> int:
        """Of the trigonometric polynomial: it has twice as many roots."""
        return self.rows // 2

    @property
    def method(self) -> Method:
        """How the arm is solved."""
        return general_method(len(self.loop.slides))

    @property
    def asked(self) -> int:
        """How many joints of the loop are the arm's; these come first."""
        return JOINTS - self.pointing - self.checked

    @property
    def first(self) -> Formulation:
        """The formulation that is tried first."""
        return self.formulations[0]

    @property
    def closed(self) -> tuple[OffsetWrist | FourTurns, ...]:
        """What has its polynomial in closed form, in the order in which it is tried."""
        if len(self.loop.slides) == SLIDES_OF_FOUR_TURNS:
            return tuple(FourTurns(f, self.loop.slides) for f in self.formulations)
        return () if self.wrist is None else (self.wrist,)

    @property
    def eliminations(self) -> tuple[Formulation, ...]:
        """The formulations whose polynomial is a determinant, tried after that."""
        return () if len(self.loop.slides) == SLIDES_OF_FOUR_TURNS else self.formulations

    @property
    def slides_on_the_right(self) -> bool:
        """Whether the formulations have a slide on the right side: all of them, or none."""
        every = [f.slides(self.loop.slides) for f in self.eliminations]
        return any(slides[place] for slides in every for place in OTHERS)

    @property
    def hides_a_slide(self) -> bool:
        """Whether the joint that is hidden slides: in all formulations, or in none."""
        return bool(self.eliminations) and self.first.joints[0] in self.loop.slides

    @property
    def slides_beside(self) -> bool:
        """Whether a slide is a partner of the hidden joint."""
        return bool(self.loop.slides) and not (self.slides_on_the_right or self.hides_a_slide)

    def held(self, free: Sequence[float]) -> tuple[Value, ...]:
        """Angles and lengths of the joints whose values the caller gives."""
        values = [s * q + offset for (s, offset), q in zip(self.given, free, strict=True)]
        for place, shares in enumerate(self.given_shares):
            values[place] += sum(share * q for share, q in zip(shares, free, strict=True))
        return tuple(Value(x, cos(x), sin(x)) for x in values)
