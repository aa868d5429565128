"""Angles that are known so far: of joints, and of sums of joints about parallel axes.

A joint's angle is a difference of solved sums (q3 = theta23 - q2), a sum that an equation names is
composed of solved ones; both are paths between cuts of a run of parallel axes.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.kinematics.algebra import AngleSum
from dhgen.paul.knowledge import build_runs
from dhgen.program.building.schedule import Option
from dhgen.robot.robot import JointKind

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from dhgen.kinematics.algebra import Algebra
    from dhgen.kinematics.chain import Chain, ChainJoint, Passive
    from dhgen.kinematics.drives import Share
    from dhgen.paul.knowledge import Cut
    from dhgen.program.building.builder import Builder
    from dhgen.program.building.graph import Node
    from dhgen.program.lowering.polynomials import PolynomialLowering


Path = list[tuple[AngleSum, int]]  # solved sums, with their signs along the run


class Angles:
    """What is known of the joints.

    Args:
        algebra: The arm and its ring.
        builder: Where values go.
        polynomials: Gets what became known.
        values: Values of the ring's generators by name; solved ones are added.
    """

    def __init__(
        self,
        algebra: Algebra,
        builder: Builder,
        polynomials: PolynomialLowering,
        values: dict[str, Node],
    ) -> None:
        self._algebra = algebra
        self._builder = builder
        self._polynomials = polynomials
        self._values = values
        self._runs = build_runs(algebra)
        self._joints = JointVariables(algebra.chain, builder)
        self._angles: dict[AngleSum, Node] = {}
        self._free: dict[int, list[Node]] = {}
        self._near: list[Option] = []

    def solved(self, angle: AngleSum, cosine: Node, sine: Node) -> None:
        """An angle sum became known by its cosine and sine."""
        self._known(angle, cosine, sine)
        value = self._builder.apply("atan2", sine, cosine)
        self._angles[angle] = self._builder.hint(value, f"theta{angle.suffix}")

    def solved_by_angle(self, angle: AngleSum, value: Node) -> None:
        """An angle sum became known itself."""
        self._known(angle, self._builder.apply("cos", value), self._builder.apply("sin", value))
        self._angles[angle] = value

    def solved_slide(self, name: str, value: Node) -> None:
        """The length of a prismatic joint became known."""
        self._values[name] = self._builder.name(value, name)
        self._polynomials.solved(name)

    def chosen_slide(self, joint: int, flag: Node) -> Node:
        """The length for the seed's value, which a slide takes where the flag is true."""
        self._free.setdefault(joint, []).append(flag)
        return self._joints.seed(joint)

    def take_given(self, joint: int) -> None:
        """The caller gives the value of this joint."""
        value = self._joints.given(joint)
        if joint in self._algebra.slides:
            self.solved_slide(self._algebra.slides[joint], value)
            return
        self.solved_by_angle(AngleSum(((joint, 1),)), value)

    def compose(self, angle: AngleSum) -> None:
        """Cosine and sine of an angle sum from cosines and sines of solved angles."""
        start, end, facing = self._runs.ends(angle)
        path = self._connect(start, end)
        assert path is not None
        builder = self._builder
        cosine, sine = builder.integer(1), builder.integer(0)
        for part, sign in path:
            c, s = self._values[part.cosine], self._values[part.sine]
            s = s if sign * facing > 0 else builder.neg(s)
            cosine, sine = (
                builder.sub(builder.mul(cosine, c), builder.mul(sine, s)),
                builder.add(builder.mul(sine, c), builder.mul(cosine, s)),
            )
        self._known(angle, cosine, sine)

    def seed(self, angle: AngleSum) -> Node:
        """An angle sum with the seed's values for its unknown joints."""
        builder = self._builder
        total = builder.integer(0)
        for joint, sign in angle.terms:
            known = self._path(joint) is not None
            part = self._of(joint) if known else self._joints.seed(joint)
            total = builder.add(total, part if sign > 0 else builder.neg(part))
        return total

    def chosen(self, angle: AngleSum, flag: Node) -> None:
        """The unknown joints of this angle sum take the seed's values where the flag is true."""
        for joint, _ in angle.terms:
            if self._path(joint) is None:
                self._free.setdefault(joint, []).append(flag)

    def nearly_chosen(self, joint: int, flag: Node, value: Node) -> None:
        """A joint is so nearly free where the flag is true that its value is good to no digit."""
        self._near.append(Option(joint, flag, value))

    @property
    def near(self) -> list[Node]:
        """Whether a joint is nearly free, a truth value for each."""
        return [option.flag for option in self._near]

    def options(self) -> list[Option]:
        """The joints that may have been chosen so far; what is free comes last, and decides."""
        return [*self._near, *self.free_options()]

    def free_options(self) -> list[Option]:
        """The options that were free and took the seed's value."""
        return [Option(joint, flag) for joint, flags in self._free.items() for flag in flags]

    def free_joints(self) -> list[tuple[int, Node]]:
        """For every joint that may have been chosen, whether it was, by each of its steps."""
        return [(joint, flag) for joint, flags in sorted(self._free.items()) for flag in flags]

    def joint_value(self, joint: int) -> Node:
        """The value of a joint as the caller counts it."""
        slide = self._algebra.slides.get(joint)
        inner = self._of(joint) if slide is None else self._values[slide]
        others = [self.joint_value(share.drive) for share in self._joints.shares(joint)]
        return self._joints.result(joint, inner, others, wrapped=inner in self._angles.values())

    def _known(self, angle: AngleSum, cosine: Node, sine: Node) -> None:
        self._builder.name(cosine, angle.cosine)
        self._builder.name(sine, angle.sine)
        self._values[angle.cosine], self._values[angle.sine] = cosine, sine
        self._polynomials.solved(angle.cosine, angle.sine)

    def _path(self, joint: int) -> Path | None:
        """Solved angle sums that add up to a joint's angle."""
        run, place = self._runs.place[joint]
        return self._connect((run, place), (run, place + 1))

    def _connect(self, start: Cut, end: Cut) -> Path | None:
        """The shortest chain of solved angle sums between two cuts."""
        reached: dict[Cut, Path] = {start: []}
        frontier = [start]
        while frontier:
            cut = frontier.pop(0)
            for angle in self._angles:
                low, high, sign = self._runs.ends(angle)
                for here, there, facing in ((low, high, sign), (high, low, -sign)):
                    if here == cut and there not in reached:
                        reached[there] = [*reached[cut], (angle, facing)]
                        frontier.append(there)
        return reached.get(end)

    def _of(self, joint: int) -> Node:
        """The angle of a joint that is known."""
        run, place = self._runs.place[joint]
        facing = self._runs.runs[run][place][1]
        path = self._path(joint)
        assert path is not None
        builder = self._builder
        total = builder.integer(0)
        for angle, sign in path:
            part = self._angles[angle]
            total = builder.add(total, part if sign * facing > 0 else builder.neg(part))
        return total


class JointVariables:
    """q of every joint and the angle or length behind it: sign and offset apart.

    Args:
        chain: The arm.
        builder: Where values go.
    """

    def __init__(self, chain: Chain, builder: Builder) -> None:
        self._chain = chain
        self._builder = builder

    def shares(self, joint: int) -> tuple[Share, ...]:
        """What other joints' drives add to a joint that is solved for."""
        return () if joint in self._chain.free else self._chain.joints[joint - 1].shares

    def seed(self, joint: int) -> Node:
        """The angle or length for the seed's values."""
        return driven(self._builder, self._chain.joints[joint - 1], self._builder.seed)

    def given(self, joint: int) -> Node:
        """The angle or length for the values that the caller gives for free joints."""
        return driven(self._builder, self._chain.joints[joint - 1], self._given)

    def result(self, joint: int, inner: Node, others: Sequence[Node], *, wrapped: bool) -> Node:
        """The joint's value for its angle or length.

        Args:
            joint: Its number, from 1.
            inner: The angle or length.
            others: The values of the other joints that have a share in it.
            wrapped: Whether an angle is known to lie in (-pi, pi].
        """
        builder, known = self._builder, self._chain.joints[joint - 1]
        if joint in self._chain.free:
            return self._given(joint)
        value = builder.sub(inner, self._offset(joint))
        for share, other in zip(known.shares, others, strict=True):
            factor = factor_constant(builder, str(joint), share)
            value = builder.sub(value, builder.mul(factor, other))
        value = value if known.sign > 0 else builder.neg(value)
        as_it_is = wrapped and known.offset == 0.0 and not known.shares
        return (
            value if known.kind is JointKind.PRISMATIC or as_it_is else builder.apply("wrap", value)
        )

    def _given(self, joint: int) -> Node:
        return self._builder.given(self._chain.free.index(joint) + 1)

    def _offset(self, joint: int) -> Node:
        return offset_constant(self._builder, self._chain.joints[joint - 1])


def driven(builder: Builder, joint: ChainJoint, value: Callable[[int], Node]) -> Node:
    """The angle or length of a joint, where the drives have some values by their numbers."""
    own = value(joint.number)
    total = own if joint.sign > 0 else builder.neg(own)
    for share in joint.shares:
        factor = factor_constant(builder, str(joint.number), share)
        total = builder.add(total, builder.mul(factor, value(share.drive)))
    return builder.add(total, offset_constant(builder, joint))


def followed(builder: Builder, passive: Passive, value: Callable[[int], Node]) -> Node:
    """The angle or length of a passive row but for what is constant in its link."""
    total = builder.integer(0)
    for share in passive.shares:
        factor = factor_constant(builder, passive.label, share)
        total = builder.add(total, builder.mul(factor, value(share.drive)))
    if not passive.offset:
        return total
    meaning = f"offset of the passive row {passive.label}" + " [rad]" * passive.turns
    name, power = f"offset{passive.label}", int(not passive.turns)
    return builder.add(total, builder.constant(name, passive.offset, meaning, power))


def factor_constant(builder: Builder, label: str, share: Share) -> Node:
    """What a drive's value is multiplied by in the row of another joint, or in a passive one."""
    if share.factor.is_integer():
        return builder.integer(int(share.factor))
    meaning = f"{share.meaning}: what q{share.drive} counts in joint {label}"
    return builder.constant(f"factor{label}{share.drive}", share.factor, meaning)


def offset_constant(builder: Builder, joint: ChainJoint) -> Node:
    """What is to be added to the value of a joint."""
    if joint.offset == 0.0:
        return builder.integer(0)
    turns = joint.kind is JointKind.REVOLUTE
    meaning = f"offset of joint {joint.number}" + (" [rad]" if turns else "")
    power = 0 if turns else 1
    return builder.constant(f"offset{joint.number}", joint.offset, meaning, power)
