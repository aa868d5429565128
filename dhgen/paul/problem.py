"""The inverse problem of a chain: which entries of U_0 are known, and what U_0 is.

For a pose, base and tool are taken to the left: U_0 = Z^-1 POS E^-1 (document 002). For partial
tasks E (and for a list Z too) remains in the chain, because moving it would mix
entries that the caller gives with entries that are ignored; all but a way along the tool's z axis,
of a task that gives that axis.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.errors import UnsolvedError
from dhgen.kinematics.algebra import POSE_NAMES, POSE_PLACES
from dhgen.kinematics.chain import Fixed
from dhgen.kinematics.product import Spans
from dhgen.kinematics.task import task_entries
from dhgen.kinematics.transform import Transform, compose, identity, inverse
from dhgen.paul.tool_axis import way_from_the_last_axis
from dhgen.robot.task import Directions, TaskKind

if TYPE_CHECKING:
    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.chain import Element
    from dhgen.kinematics.constants import Polynomial


@dataclass(frozen=True, slots=True)
class Problem:
    """What is asked of an arm.

    Attributes:
        algebra: The arm and its ring.
        spans: Products of the links A_1 ... A_n, with base and tool where they remain in the chain.
        target: U_0: known pose entries as generators or as what they equal for this arm.
        known: Names of the pose entries that the task gives and that are independent.
        base_left: Whether Z has been moved to the left.
        tool_left: What of E has been moved to the left: all, its last part, or nothing.
    """

    algebra: Algebra
    spans: Spans
    target: Transform
    known: frozenset[str]
    base_left: bool
    tool_left: Transform

    @property
    def overdetermined(self) -> bool:
        """Whether the task has more entries than the arm can choose: a pose has to be checked."""
        return self.algebra.chain.overdetermined

    @property
    def links(self) -> tuple[tuple[Element, ...], ...]:
        """The elements of A_1 ... A_n."""
        return self.spans.links

    @property
    def forward(self) -> Transform:
        """A_1 ... A_n, what U_0 equals."""
        return self.spans.product(0, len(self.links))


def build_problem(algebra: Algebra) -> Problem:
    """The inverse problem of an arm and its task."""
    chain = algebra.chain
    task = chain.task
    base_left = task.kind is not TaskKind.LIST
    links = [algebra.lifted(link) for link in chain.links]
    still = identity(algebra.ring)
    if not base_left and algebra.lift(chain.base) != still:
        links[0] = (Fixed(algebra.lift(chain.base)), *links[0])
    tool_left = tool = algebra.lift(chain.tool)
    if not task.names_rotation:
        tool_left = way_from_the_last_axis(algebra, (*links[-1], Fixed(tool)))
        rest = compose(tool, inverse(tool_left, algebra.normal), algebra.normal)
        links[-1] = (*links[-1], *([Fixed(rest)] if rest != still else []))
    spans = Spans(tuple(links), algebra)
    given = task_entries(task)
    if task.directions is Directions.YAW:
        _demand_level(spans.product(0, len(links)).entry(2, 0))
    target, known = _target(algebra, spans.product(0, len(links)), given)
    return Problem(
        algebra=algebra,
        spans=spans,
        target=target,
        known=known,
        base_left=base_left,
        tool_left=tool_left,
    )


def _demand_level(steepness: Polynomial) -> None:
    """Refuses arms that may turn the tool's x axis out of the level.

    Raises:
        UnsolvedError: The arm does.
    """
    if steepness:
        raise UnsolvedError(
            "the task names yaw, which asks for an arm that keeps the tool's x axis level, and "
            "this one does not: its t31 depends on the joints or is not zero\n"
            "a SCARA does, with the tool's x axis across the axes of its joints; see `tool`"
        )


def _target(
    algebra: Algebra, forward: Transform, given: frozenset[str]
) -> tuple[Transform, frozenset[str]]:
    """U_0 with the entries that are constant for this arm, or equal to another, substituted.

    SCARA: the approach vector is (0, 0, 1), t22 = t11, t12 = -t21. A pose that breaks such a
    relation is out of the arm's reach; the emitted code checks that.
    """
    independent: dict[str, Polynomial] = {}
    symbols: dict[str, Polynomial] = {}
    order = sorted(given, key=lambda name: (name[2] != "4", name[2], name[1]))
    for name in order:
        value = forward.entry(*POSE_PLACES[name])
        if algebra.is_constant(value):
            symbols[name] = value
            continue
        for other, reference in independent.items():
            if value in (reference, -reference):
                sign = 1 if value == reference else -1
                symbols[name] = sign * algebra.generator(other)
                break
        else:
            independent[name] = value
            symbols[name] = algebra.generator(name)
    full = {name: symbols.get(name, algebra.generator(name)) for name in POSE_NAMES}
    rows = tuple(tuple(full[f"t{i}{j}"] for j in (1, 2, 3)) for i in (1, 2, 3))
    origin = tuple(full[f"t{i}4"] for i in (1, 2, 3))
    return Transform(rows, origin), frozenset(independent)


class Withheld:
    """Which pose entries the task does not give."""

    def __init__(self, problem: Problem) -> None:
        index = problem.algebra.index
        self._places = [index[name] for name in POSE_NAMES if name not in problem.known]

    def __call__(self, polynomial: Polynomial) -> bool:
        """Whether a polynomial holds one of them."""
        return any(monomial[place] for monomial in polynomial for place in self._places)
