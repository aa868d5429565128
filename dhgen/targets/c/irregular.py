"""C that tells how far a pose is from one in full precision: orthonormal, right-handed, finite."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from dhgen.robot.task import TaskKind
from dhgen.targets.c.declared import Declaration, dense
from dhgen.targets.layout import INDENT, wrapped
from dhgen.targets.module import has_to_be_finite

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.targets.module import SolverModule


ROWS = ("T", "(T + 4)", "(T + 8)")  # of a pose


@dataclass(frozen=True, slots=True)
class Irregularity:
    """A function that tells it: its head and its statements."""

    head: str
    lines: Sequence[str]


@dataclass(frozen=True, slots=True)
class Irregularities:
    """The functions: in lanes of poses, and for one pose with its columns in lanes."""

    wide: Irregularity
    four: Irregularity


def irregularities(module: SolverModule, inputs: list[str]) -> Irregularities:
    """The functions of a robot.

    Args:
        module: The robot.
        inputs: The parameters, % for the type of a number.
    """
    rotation = module.chain.task.names_rotation
    one = _side_by_side(module) if rotation else _plain(module, "double", "all_four({})")
    return Irregularities(
        wide=_function("wide", "wide", inputs, _plain(module, "wide", "{}")),
        four=_function("four", "double", inputs, one),
    )


def _function(result: str, number: str, inputs: list[str], lines: list[str]) -> Irregularity:
    given = ", ".join(inputs).replace("%", number)
    return Irregularity(f"HELPER {result} irregularity_{result}({given})", lines)


def finite_entries(module: SolverModule) -> list[str]:
    """What has to be finite of a pose besides its rotation."""
    return has_to_be_finite(
        module, (f"T[{4 * row + 3}]" for row in module.chain.task.position_rows)
    )


def finite_given(module: SolverModule) -> list[str]:
    """What has to be finite of the values that the caller gives."""
    return has_to_be_finite(module, (f"free_joints[{k}]" for k in range(module.chain.given)))


def _plain(module: SolverModule, number: str, result: str) -> list[str]:
    """Statements without lanes of their own; the result has {} in place of the sum."""
    task = module.chain.task
    finite = finite_entries(module) + finite_given(module)
    lines, terms = [], []
    if task.names_rotation:
        terms.append(f"misfit_{number}(T)")
    elif task.kind is TaskKind.POINTING:
        lines.append(
            f"{INDENT}const {number} zz = T[2] * T[2] + T[6] * T[6] + T[10] * T[10] - 1.0;"
        )
        terms.append("zz * zz")
    if task.kind is TaskKind.POSE:
        lines.append(
            f"{INDENT}const {number} w0 = T[12], w1 = T[13], w2 = T[14], w3 = T[15] - 1.0;"
        )
        terms.append("w0 * w0 + w1 * w1 + w2 * w2 + w3 * w3")
    if finite:
        terms.append(f"0.0 * ({' + '.join(finite)})")
    total = result.format(" + ".join(terms))
    return [*lines, *wrapped(f"{INDENT}return {total};", INDENT)]


def _side_by_side(module: SolverModule) -> list[str]:
    """The columns in lanes: their lengths and angles, and whether the rows are right-handed."""
    pose = module.chain.task.kind is TaskKind.POSE
    known = [(name, f"*(const four_at *){row}") for name, row in zip("xyz", ROWS, strict=True)]
    known += [(f"{row}1", f"shuffle({row}, {row}, 1, 2, 0, 3)") for row in "xyz"]
    known += [(f"{row}2", f"shuffle({row}, {row}, 2, 0, 1, 3)") for row in "xy"]
    known += [
        ("lengths", "x * x + y * y + z * z - 1.0"),
        ("angles", "x * x1 + y * y1 + z * z1"),
        ("mirror", "x1 * y2 - x2 * y1 - z"),
    ]
    total = "lengths * lengths + 2.0 * angles * angles + mirror * mirror"
    if pose:
        known.append(("last", "*(const four_at *)(T + 12) - (four){ 0.0, 0.0, 0.0, 1.0 }"))
        # of the fourth column only this is left: that it is finite
        total = f"({total}) * (four){{ 1.0, 1.0, 1.0, 0.0 }} + last * last"
    else:
        known.append(("sum", total))
        total = "shuffle(sum, all_four(0.0), 0, 1, 2, 7)"
    if given := finite_given(module):
        total += f" + 0.0 * ({' + '.join(given)})"
    lines = dense((Declaration("four", *each) for each in known), INDENT)
    return [*lines, *wrapped(f"{INDENT}return {total};", INDENT)]
