"""What is known of the joints at one point of a derivation.

Along a run of parallel axes the unknowns are differences between cut points: the angle sum from
cut a to cut b is known when a and b are connected. Solving theta1 and theta1 + theta2 therefore
gives theta2 without an equation of its own, and c12 with theta1 known is the same unknown as c2.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum
from dhgen.kinematics.chain import parallel_groups

if TYPE_CHECKING:
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.constants import Polynomial

Cut = tuple[int, int]  # (run, position in the run)
State = tuple[tuple[tuple[int, ...], ...], frozenset[int]]


@dataclass(frozen=True, slots=True)
class Runs:
    """The runs of parallel axes of an arm, and where each angle sum lies in them.

    Attributes:
        algebra: The arm.
        runs: (joint, direction) pairs of every run.
        place: Run and position of every revolute joint.
    """

    algebra: Algebra
    runs: tuple[tuple[tuple[int, int], ...], ...]
    place: dict[int, Cut]

    def ends(self, angle: AngleSum) -> tuple[Cut, Cut, int]:
        """Cuts before and after an angle sum, and its sign along the run."""
        run, first = self.place[angle.terms[0][0]]
        _, last = self.place[angle.terms[-1][0]]
        return (run, first), (run, last + 1), self.runs[run][first][1]

    def between(self, start: Cut, end: Cut) -> tuple[AngleSum, int]:
        """The angle sum between two different cuts of a run, and its sign from start to end."""
        run = self.runs[start[0]]
        low, high = sorted((start[1], end[1]))
        facing = run[low][1]
        terms = tuple((joint, sign * facing) for joint, sign in run[low:high])
        return AngleSum(terms), facing if start[1] < end[1] else -facing

    def cosine_sine(self, start: Cut, end: Cut) -> tuple[Polynomial, Polynomial]:
        """Cosine and sine of the turn from one cut to another of one run."""
        if start == end:
            return self.algebra.ring.one, self.algebra.ring.zero
        angle, sign = self.between(start, end)
        return (
            self.algebra.generator(angle.cosine),
            sign * self.algebra.generator(angle.sine),
        )


def build_runs(algebra: Algebra) -> Runs:
    """The runs of an arm."""
    runs = parallel_groups(algebra.chain)
    place = {
        joint: (number, position)
        for number, run in enumerate(runs)
        for position, (joint, _) in enumerate(run)
    }
    return Runs(algebra, runs, place)


@dataclass(frozen=True, slots=True)
class Knowledge:
    """A set of known angle sums and lengths.

    Attributes:
        runs: The arm's runs.
        components: For every run, the component number of each of its cuts.
        slides: Prismatic joints whose length is known.
    """

    runs: Runs
    components: tuple[tuple[int, ...], ...]
    slides: frozenset[int]

    @property
    def state(self) -> State:
        """What is known, as a key: two values that agree in it are the same knowledge."""
        return self.components, self.slides

    def component(self, cut: Cut) -> tuple[int, int]:
        """Which cuts are connected with this one."""
        return cut[0], self.components[cut[0]][cut[1]]

    def knows(self, angle: AngleSum) -> bool:
        """Whether an angle sum is known: never that of a passive row which is no sum of joints'."""
        if angle.terms[0][0] not in self.runs.place:
            return False
        start, end, _ = self.runs.ends(angle)
        return self.component(start) == self.component(end)

    def with_angle(self, angle: AngleSum) -> Knowledge:
        """What is known, and an angle sum."""
        (run, start), (_, end), _ = self.runs.ends(angle)
        row = self.components[run]
        low, high = sorted((row[start], row[end]))
        joined = tuple(low if each == high else each for each in row)
        return replace(
            self, components=(*self.components[:run], joined, *self.components[run + 1 :])
        )

    def with_slide(self, joint: int) -> Knowledge:
        """What is known, and the length of a prismatic joint."""
        return replace(self, slides=self.slides | {joint})

    @property
    def complete(self) -> bool:
        """Whether every joint is known."""
        turned = all(len(set(row)) == 1 for row in self.components)
        return turned and self.slides >= set(self.runs.algebra.slides)

    @property
    def missing(self) -> int:
        """How many angles and lengths have yet to be found."""
        turns = sum(len(set(row)) - 1 for row in self.components)
        return turns + len(self.runs.algebra.slides.keys() - self.slides)

    @property
    def open_joints(self) -> tuple[int, ...]:
        """The joints that are not known yet."""
        turned = [
            joint
            for run, row in zip(self.runs.runs, self.components, strict=True)
            for place, (joint, _) in enumerate(run)
            if row[place] != row[place + 1]
        ]
        return tuple(sorted(turned + [j for j in self.runs.algebra.slides if j not in self.slides]))

    def representative(self, angle: AngleSum) -> AngleSum:
        """The shortest angle sum that differs from an unknown one by what is known."""
        start, end, _ = self.runs.ends(angle)
        run = start[0]
        ends = {self.component(start), self.component(end)}
        size = len(self.components[run])
        pairs = sorted(
            (high - low, low, high)
            for low in range(size)
            for high in range(low + 1, size)
            if {self.component((run, low)), self.component((run, high))} == ends
        )
        _, low, high = pairs[0]
        return self.runs.between((run, low), (run, high))[0]

    def runs_along(self, angle: AngleSum) -> bool:
        """Whether an unknown angle sum begins with the cut its representative begins with."""
        start, _, _ = self.runs.ends(angle)
        low, _, _ = self.runs.ends(self.representative(angle))
        return self.component(start) == self.component(low)

    def rewritten(self, angle: AngleSum) -> tuple[Polynomial, Polynomial]:
        """Cosine and sine of an unknown angle sum by its representative's."""
        shortest = self.representative(angle)
        algebra = self.runs.algebra
        cosine, sine = algebra.generator(shortest.cosine), algebra.generator(shortest.sine)
        if shortest == angle:
            return cosine, sine
        start, end, sign = self.runs.ends(angle)
        low, high, facing = self.runs.ends(shortest)
        if not self.runs_along(angle):
            start, end, sign = end, start, -sign
        # angle = sign * turn(start, end), turn(start, end) = turn(start, low) + turn(low, high)
        # + turn(high, end), of which the middle one is facing * representative
        c1, s1 = self.runs.cosine_sine(start, low)
        c2, s2 = self.runs.cosine_sine(high, end)
        normal = algebra.normal
        c, s = normal(c1 * c2 - s1 * s2), normal(s1 * c2 + c1 * s2)
        sine = facing * sine
        return normal(c * cosine - s * sine), sign * normal(s * cosine + c * sine)


def initial_knowledge(algebra: Algebra) -> Knowledge:
    """Nothing but the joints that the caller gives."""
    runs = build_runs(algebra)
    components = tuple(tuple(range(len(run) + 1)) for run in runs.runs)
    knowledge = Knowledge(runs, components, frozenset())
    for joint in algebra.chain.free:
        if joint in algebra.slides:
            knowledge = knowledge.with_slide(joint)
        else:
            knowledge = knowledge.with_angle(AngleSum(((joint, 1),)))
    return knowledge
