"""What forward kinematics and the Jacobian have in common, as a macro: for long sources."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from dhgen.program.ir import Let
from dhgen.program.walk import names_in
from dhgen.targets.c.declared import Declaration, dense
from dhgen.targets.c.language import C
from dhgen.targets.dialect import expression_text
from dhgen.targets.layout import GOES_ON, INDENT, WIDTH

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.program.ir import Expression, Program
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class Motion:
    """Both programs.

    Attributes:
        macro: Defines what both begin with.
        module: The robot, its two programs without that.
    """

    macro: Sequence[str]
    module: SolverModule


def motion_of(module: SolverModule) -> Motion:
    """Forward kinematics and Jacobian, and before them the values that both compute."""
    common = _common(module.forward, module.jacobian)
    values = [
        Declaration("double", name, expression_text(value, C())) for name, value in common.items()
    ]
    lines = ["#define MOTION", *dense(values, INDENT, WIDTH - len(GOES_ON))]
    macro = [line + GOES_ON for line in lines[:-1]] + [lines[-1].removesuffix(";")]
    forward, jacobian = (_without(each, common) for each in (module.forward, module.jacobian))
    return Motion(macro, replace(module, forward=forward, jacobian=jacobian))


def _common(first: Program, second: Program) -> dict[str, Expression]:
    """The values that both programs compute in equal words."""
    others = {each.name: each.expression for each in second.body if isinstance(each, Let)}
    own = {each.name for each in first.body if isinstance(each, Let)}
    common: dict[str, Expression] = {}
    for each in first.body:
        if not isinstance(each, Let) or others.get(each.name) != each.expression:
            continue
        if names_in(each.expression) & own <= common.keys():
            common[each.name] = each.expression
    return common


def _without(program: Program, common: dict[str, Expression]) -> Program:
    kept = (each for each in program.body if not (isinstance(each, Let) and each.name in common))
    return replace(program, body=tuple(kept))
