"""Comments, tables and checks of a C source as its templates name them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.printing.comments import plain
from dhgen.program.role import LIMIT_SLACK, LimitEnd
from dhgen.targets.c.table import c_ends
from dhgen.targets.constants import constant_texts, made_of, texts_of
from dhgen.targets.layout import GOES_ON, INDENT, WIDTH, listed, packed, paragraph
from dhgen.targets.module import made_text, stamp
from dhgen.targets.solver.task import meaning
from dhgen.tolerances import SINGLE

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.program.ir import Program
    from dhgen.program.role import Role
    from dhgen.targets.constants import ConstantText
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class CComments:
    """The comments of a robot's files.

    Attributes:
        about: What they are.
        made_h: Where the header comes from.
        made_c: Where the source comes from.
        stamp: By what they were made, and of what.
        frames: What poses are.
    """

    about: str
    made_h: str
    made_c: str
    stamp: str
    frames: str


@dataclass(frozen=True, slots=True)
class CTables:
    """Definitions of constants.

    Attributes:
        joints: The definitions of macros that list types, names and limits of the joints.
        branch_names: The name of every row, as lines.
        plain_names: The same where no nearest arm is tried first.
        constants: Of the programs, as lines.
        regular_constants: Those that only regular poses need.
        lane_constants: Those that only branches in lanes need.
    """

    joints: Sequence[str]
    branch_names: Sequence[str]
    plain_names: Sequence[str]
    constants: Sequence[str]
    regular_constants: Sequence[str]
    lane_constants: Sequence[str]


def c_comments(module: SolverModule) -> CComments:
    """The comments of a robot's files, filled in."""
    single = f", all in {SINGLE.name}" if module.precision is SINGLE else ""
    frames = (
        "Poses are row-major 4 x 4 matrices of the tool in the base frame, lengths in "
        f"{module.length_unit}, angles in rad{single}. {meaning(module.chain.task)}"
    )
    return CComments(
        about=paragraph(f"{module.name}: {plain(module.title)}", " * "),
        made_h=made_text(module, "c/solver.h.jinja", " * "),
        made_c=made_text(module, "c/solver.c.jinja", " * "),
        stamp=stamp(module.digest),
        frames=paragraph(frames, " * "),
    )


def c_tables(module: SolverModule, regular: Sequence[Program]) -> CTables:
    """Constants of a robot, and of its programs for regular poses, that with lanes last."""
    own, common, lanes = _constants(module, tuple(regular))
    return CTables(
        joints=_joints(module),
        branch_names=listed([f'"{text}"' for text in module.branches], INDENT),
        plain_names=listed([f'"{text}"' for text in module.solver.branches], INDENT),
        constants=_constant_lines(own, []),
        regular_constants=_constant_lines([each for each in common if each not in own], own),
        lane_constants=_constant_lines([each for each in lanes if each not in common], common),
    )


def local_constants(module: SolverModule, program: Program) -> list[str]:
    """The constants of a program alone, for a function of its own."""
    texts = texts_of(module, [program])
    return _constant_lines([each for each in texts if not _in_macros(each.role)], [])


def _joints(module: SolverModule) -> list[str]:
    """Macros of lists with commas between: they take no room unless they are used."""
    joints = module.chain.joints
    return [
        _macro(module, "TYPES", [f'"{module.chain.joint_types}"']),
        _macro(module, "NAMES", [f'"{name}"' for name in module.chain.joint_names]),
        _macro(module, "LIMITS", [f"{{ {c_ends(joint.limits)} }}" for joint in joints]),
    ]


def _macro(module: SolverModule, what: str, items: Sequence[str]) -> str:
    """The definition of a macro that lists something of the joints."""
    head = f"#define {module.name.upper()}_JOINT_{what}"
    *others, last = items
    pieces = [*(f"{item}," for item in others), last]
    line = " ".join([head, *pieces])
    if len(line) <= WIDTH:
        return line
    return f"{GOES_ON}\n".join([head, *packed(pieces, INDENT, width=WIDTH - len(GOES_ON))])


def _constants(
    module: SolverModule, regular: tuple[Program, ...]
) -> tuple[list[ConstantText], ...]:
    """The constants of all builds, of regular poses as well, and of branches in lanes as well."""
    return tuple(
        [each for each in constant_texts(module, some) if not _in_macros(each.role)]
        for some in ((), regular[:1], regular)
    )


def _in_macros(role: Role) -> bool:
    """Whether a constant is no variable: macros that compare with limits use it."""
    return isinstance(role, LimitEnd) or role == LIMIT_SLACK


def _constant_lines(constants: list[ConstantText], above: list[ConstantText]) -> list[str]:
    """Definitions of constants with a comment, and of constants that need none.

    Args:
        constants: The constants.
        above: The constants above them.
    """
    commented = [each for each in constants if each.comment]
    lines = _comment(made_of(constants, above))
    lines += ["static const double"] if commented else []
    for each in commented:
        lines += _constant(each, ";" if each is commented[-1] else ",")
    return lines + _bare([each for each in constants if not each.comment])


def _comment(pieces: list[str]) -> list[str]:
    if not pieces:
        return []
    mark, end = " * ", " */"
    *others, last = packed(pieces, mark, width=WIDTH - len(end))
    lines = [*others, last + end]
    return [f"/* {lines[0].removeprefix(mark)}", *lines[1:]]


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
    mark = "###"  # as long as the end, which must not be on a line of its own
    text = paragraph(f"{constant.comment}{mark}", f"{INDENT} * ").removesuffix(mark)
    return [f"{INDENT}/* {text} */", line]
