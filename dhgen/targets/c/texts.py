"""Comments, tables and checks of a C source as its templates name them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.printing.comments import plain
from dhgen.program.role import GRAZE, LimitEnd, Source
from dhgen.targets.c.irregular import finite_entries, finite_given
from dhgen.targets.constants import constant_texts
from dhgen.targets.layout import INDENT, WIDTH, c_array, listed, packed, paragraph
from dhgen.targets.module import made_text, named_entries, slacks
from dhgen.targets.solver.searches import fan_steps
from dhgen.targets.solver.task import meaning
from dhgen.tolerances import SINGLE

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.program.ir import Program
    from dhgen.program.role import Role
    from dhgen.targets.c.entries import Entries
    from dhgen.targets.constants import ConstantText
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class CComments:
    """What files say of themselves.

    Attributes:
        about: What they are.
        made_h: Where the header comes from.
        made_c: Where the source comes from.
        frames: What poses are.
    """

    about: str
    made_h: str
    made_c: str
    frames: str


@dataclass(frozen=True, slots=True)
class CTables:
    """Definitions of constants.

    Attributes:
        branch_names: The name of every row, as lines.
        lowest: Limits.
        highest: The same.
        revolute: Which joints turn.
        slack: By what joint values may miss their limits.
        weight: Of squared differences of joint values.
        fan_step: From one value of a free joint that is tried to the next.
        constants: Of the programs, as lines.
        lane_constants: Those that only branches in lanes need.
    """

    branch_names: Sequence[str]
    lowest: str
    highest: str
    revolute: str
    slack: str
    weight: str
    fan_step: str
    constants: Sequence[str]
    lane_constants: Sequence[str]


@dataclass(frozen=True, slots=True)
class CPose:
    """How a pose is read.

    Attributes:
        entries: The lines that give its entries their names.
        entries_macro: The definition of a macro that does, where all programs read the same.
        finite: Whether all that has to be finite of it is.
        given_finite: The same of the values that the caller gives.
        named_places: Places of the entries that the task names.
        named_count: How many they are.
        length_weight: What a length counts of what is missed.
    """

    entries: Sequence[str]
    entries_macro: Sequence[str]
    finite: str
    given_finite: str
    named_places: str
    named_count: int
    length_weight: str


def c_comments(module: SolverModule) -> CComments:
    """What a robot's files say of themselves."""
    single = f", all in {SINGLE.name}" if module.precision is SINGLE else ""
    frames = (
        "Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in "
        f"{module.length_unit}, angles in rad{single}. {meaning(module.chain.task)}"
    )
    return CComments(
        about=paragraph(f"{module.name}: {plain(module.title)}", " * "),
        made_h=made_text(module, "c/solver.h.jinja", " * "),
        made_c=made_text(module, "c/solver.c.jinja", " * "),
        frames=paragraph(frames, " * "),
    )


def c_pose(module: SolverModule, entries: Entries) -> CPose:
    """How a robot's pose is read, its entries in this way."""
    places = [str(entry.place) for entry in named_entries(module.chain)]
    return CPose(
        entries=entries.lines,
        entries_macro=entries.macro,
        finite=_all_finite(finite_entries(module)),
        given_finite=_all_finite(finite_given(module)),
        named_places=c_array(f"static const int named[{len(places)}]", places),
        named_count=len(places),
        length_weight=repr(1.0 / module.chain.size),
    )


def _all_finite(values: list[str]) -> str:
    return " && ".join(f"isfinite({each})" for each in values)


def c_tables(module: SolverModule, regular: Sequence[Program]) -> CTables:
    """Constants of a robot, and of its programs for regular poses, that with lanes last."""
    limits = [joint.limits for joint in module.chain.joints]
    low = [repr(pair[0]) if pair else "-INFINITY" for pair in limits]
    high = [repr(pair[1]) if pair else "INFINITY" for pair in limits]
    flags = ["1" if turns else "0" for turns in module.chain.turning]
    dof = module.chain.dof
    common, only = _constants(module, regular)
    return CTables(
        branch_names=listed([f'"{text}"' for text in module.branches], INDENT),
        lowest=c_array(f"static const double lowest[{dof}]", low),
        highest=c_array(f"static const double highest[{dof}]", high),
        revolute=c_array(f"static const int revolute[{dof}]", flags),
        slack=_slack(module),
        weight=c_array(f"static const double weight[{dof}]", map(repr, module.weights)),
        fan_step=c_array(f"static const double fan_step[{dof}]", map(repr, fan_steps(module))),
        constants=_constant_lines(common),
        lane_constants=_constant_lines(only),
    )


def _slack(module: SolverModule) -> str:
    """By what the value of `joint` may miss its limits."""
    slack = dict(zip(module.chain.turning, slacks(module), strict=True))
    if len(set(slack.values())) == 1:
        return repr(next(iter(slack.values())))
    return f"(revolute[joint] ? {slack[True]!r} : {slack[False]!r})"


def _constants(
    module: SolverModule, regular: Sequence[Program]
) -> tuple[list[ConstantText], list[ConstantText]]:
    """The constants of all builds, and those that only branches in lanes need."""
    programs = tuple(regular)
    common, every = (
        [each for each in constant_texts(module, some) if not _in_macros(each.role)]
        for some in (programs[:1], programs)
    )
    return common, [each for each in every if each not in common]


def _in_macros(role: Role) -> bool:
    """Whether a constant is no variable: it stands in macros that compare with limits."""
    return isinstance(role, LimitEnd) or role == GRAZE


def _constant_lines(constants: list[ConstantText]) -> list[str]:
    """Definitions of those with a comment, of coefficients, and of those whose names say all."""
    coefficients = [each for each in constants if each.role is Source.COEFFICIENT]
    told = [each for each in constants if each.comment and each not in coefficients]
    lines = ["static const double"] if told else []
    for each in told:
        lines += _constant(each, ";" if each is told[-1] else ",")
    if coefficients:
        lines += ["/* coefficients */", *_bare(coefficients)]
    return lines + _bare([each for each in constants if not each.comment])


def _bare(constants: list[ConstantText]) -> list[str]:
    """A definition without comments, if there is anything to be defined."""
    if not constants:
        return []
    first, *others = (f"{each.name} = {each.value}" for each in constants)
    *full, last = packed([f"static const double {first}", *others], "", ", ")
    return [*(f"{line}," for line in full), f"{last};"]


def _constant(constant: ConstantText, end: str) -> list[str]:
    line = f"{INDENT}{constant.name} = {constant.value}{end}"
    if len(line) + len(constant.comment) + 7 <= WIDTH:
        return [f"{line} /* {constant.comment} */"]
    # the end of a comment has to fit, too
    told = paragraph(f"{constant.comment} ##", f"{INDENT} * ").replace(" ##", "").rstrip()
    return [f"{INDENT}/* {told} */", line]
