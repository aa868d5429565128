"""What the code targets print: the programs of a robot and the facts around them."""

from __future__ import annotations

import math
import shlex
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from dhgen import __version__
from dhgen.kinematics.algebra import POSE_PLACES
from dhgen.kinematics.task import compared_entries
from dhgen.kinematics.turns import coupled_turns, has_poses_to_clamp
from dhgen.nominal.rows import row_names
from dhgen.printing.comments import plain_path
from dhgen.program.regular.limits import ArmLimits, Limits
from dhgen.program.regular.regular import regular
from dhgen.targets.layout import paragraph
from dhgen.tolerances import DOUBLE, Precision

if TYPE_CHECKING:
    from collections.abc import Container, Iterable

    from dhgen.kinematics.chain import Chain
    from dhgen.kinematics.link_table import LinkTable
    from dhgen.method import Method
    from dhgen.nominal.nominal import Nominal
    from dhgen.program.ir import Program
    from dhgen.program.policy import Policy
    from dhgen.program.regular.unguarded import Regular


FAN = 64  # values of a free joint that are tried first
LAST = 3  # column of a pose: its translation


@dataclass(frozen=True, slots=True)
class SolverModule:
    """A robot's programs, ready to be printed in any language.

    Attributes:
        name: The robot's identifier, and the suffix of the precision.
        title: What a person calls it.
        source: How the robot file is called, relative; may hold any character.
        chain: The arm.
        method: How it is solved.
        solver: From pose to rows of joint values.
        forward: From joint values to the pose.
        jacobian: From joint values to the geometric Jacobian.
        policy: What is done around the formulas at run time.
        length_unit: How lengths are called.
        arm_angle: From joint values to the arm angle, where the caller gives that.
        plane_miss: From them and the pose to what they miss the arm angle by, where rows need it.
        digest: Of the robot file.
        precision: The arithmetic that the programs are for; its suffix ends `name`.
        links: The table as the robot file has it.
        plain: Whether there is no fast path for regular poses.
        nominal: The nearest arm with a structure, where its rows are tried first.
        nearest_branches: The names of its rows, or of the nominal arm's: what rows begin with.
        owner: The parallel robot of which this is a kind of leg; empty for a robot of its own.
    """

    name: str
    title: str
    source: str
    chain: Chain
    method: Method
    solver: Program
    forward: Program
    jacobian: Program
    policy: Policy
    length_unit: str
    links: LinkTable
    arm_angle: Program | None = None
    plane_miss: Program | None = None
    digest: str = ""
    precision: Precision = DOUBLE
    plain: bool = False
    nominal: Nominal | None = None
    nearest_branches: tuple[str, ...] = ()
    owner: str = ""

    @property
    def robot(self) -> str:
        """The robot's identifier."""
        return self.name.removesuffix(self.precision.suffix)

    @property
    def branches(self) -> tuple[str, ...]:
        """The name of every row."""
        if not self.nearest_branches:
            return self.solver.branches
        return row_names(self.nearest_branches, self.solver.rows)

    @property
    def programs(self) -> tuple[Program, ...]:
        """All programs."""
        others = (each for each in (self.arm_angle, self.plane_miss) if each is not None)
        return self.solver, self.forward, self.jacobian, *others

    @property
    def weights(self) -> tuple[float, ...]:
        """What squared differences of joint values count: lengths in arm sizes."""
        slide = 1.0 / self.chain.size**2
        return tuple(1.0 if turns else slide for turns in self.chain.turning)


def has_to_be_finite(module: SolverModule, entries: Iterable[str]) -> list[str]:
    """The expressions that are finite if the used entries of the pose and given values are.

    A slide follows the pose wherever it is; then sums of squares have to be finite, too, and are
    where cubes are.
    """
    turns = all(module.chain.turning)
    return [each if turns else " * ".join([each] * 3) for each in entries]


@dataclass(frozen=True, slots=True)
class NamedEntry:
    """An entry of the pose that a row is compared with.

    Attributes:
        place: In sixteen numbers, row by row.
        weight: Of its miss: lengths count in arm sizes.
    """

    place: int
    weight: str


def named_entries(chain: Chain) -> list[NamedEntry]:
    """The entries of the task, in order."""
    places = (POSE_PLACES[name] for name in sorted(compared_entries(chain.task)))
    size = repr(1.0 / chain.size)
    return [
        NamedEntry(4 * row + column, size if column == LAST else "1.0") for row, column in places
    ]


def made_text(module: SolverModule, template: str, indent: str) -> str:
    """Where a file comes from; the lines after the first are indented."""
    return origin_text(module.source, module.robot, template, indent, owner=module.owner)


def stamp(digest: str) -> str:
    """By which version a file was made, and of which robot file."""
    return f"dhgen {__version__}; SHA-256 of the robot file: {digest}"


def origin_text(path: str, robot: str, template: str, indent: str, *, owner: str = "") -> str:
    """Where a file comes from; the lines after the first are indented.

    Args:
        path: How the robot file is called; may hold any character.
        robot: The identifier of the robot whose formulas these are.
        template: The template that the file was printed by.
        indent: The blanks before lines.
        owner: The parallel robot of which it is a kind of leg, if it is one.
    """
    source = plain_path(path)
    made = f"Inverse kinematics, generated from {source} and templates/{template}."
    # a path that can't be written here is for nobody to type from here
    command = shlex.join(["dhgen", source]) if source == path else "dhgen on that file"
    mended = f"Do not edit: run {command}."
    leg = f", of a leg of {owner}" if owner else ""
    reference = f"The formulas and where they come from: {robot}.md{leg}."
    return f"\n{indent}".join([paragraph(made, indent), paragraph(f"{mended} {reference}", indent)])


def slacks(module: SolverModule) -> list[float]:
    """By what each joint value may miss its limits [rad or length]."""
    angle = module.precision.tolerances.limit
    length = float(f"{angle * module.chain.size:.4g}")  # more digits are of no use
    return [angle if turns else length for turns in module.chain.turning]


def fan_steps(module: SolverModule) -> tuple[float, ...]:
    """From one value of a free joint that is tried to the next: half a fan is enough.

    Angles are tried in a whole turn, slides to both sides as far as their stroke, or where that
    is endless as in a turn of the arm.
    """
    lengths = (
        joint.limits[1] - joint.limits[0] if joint.limits else math.pi * module.chain.size
        for joint in module.chain.joints
    )
    return tuple(
        2.0 * (math.pi if turns else length) / FAN
        for turns, length in zip(module.chain.turning, lengths, strict=True)
    )


def regular_solver(module: SolverModule, asked: Container[int] | None = None) -> Regular | None:
    """The program of regular poses, with limits, where the files have one.

    Args:
        module: The robot.
        asked: The joints whose values are asked for, from 0; all if it is not given. The limits of
            the others count all the same.
    """
    if module.plain or coupled_turns(module.chain) is not None:
        return None
    table = module.precision.tolerances
    limit_slack = table.limit_slack if has_poses_to_clamp(module.chain) else None
    limits = tuple(_limits(module, range(module.chain.dof) if asked is None else asked))
    solver = regular(module.solver, ArmLimits(limits, limit_slack), table)
    if solver is None or asked is None:
        return solver
    values = tuple(value for joint, value in enumerate(solver.joints) if joint in asked)
    return replace(solver, joints=values)


def _limits(module: SolverModule, asked: Container[int]) -> list[Limits | None]:
    chain, limits = module.chain, [joint.limits for joint in module.chain.joints]
    size = chain.size
    each = zip(limits, slacks(module), chain.turning, strict=True)
    return [
        Limits(ends[0] - slack, ends[1] + slack, turns, 1.0 if turns else size, joint in asked)
        if ends
        else None
        for joint, (ends, slack, turns) in enumerate(each)
    ]
