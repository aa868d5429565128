"""Fills in the templates of the general algorithm."""

from __future__ import annotations

from textwrap import indent
from typing import TYPE_CHECKING

from dhgen.targets.general.rows import rows
from dhgen.targets.general.table import general_table
from dhgen.targets.general.wrist import wrist
from dhgen.targets.layout import INDENT, c_array
from dhgen.targets.numerical.emit import search, tools

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain
    from dhgen.program.ir import AllJoints
    from dhgen.targets.module import SolverModule
    from dhgen.targets.solver.module import Module
    from dhgen.targets.writing import Writing


def all_joints(whole: AllJoints, module: SolverModule, of: Module, writing: Writing) -> str:
    """What solves for all joints at once, in C."""
    parts = [tools(whole.descent, of, writing)]
    if whole.general is None:
        parts.append(search(whole.descent, of, writing))
    else:
        parts.append(source(whole.general, module.name, writing))
        parts.append(_rows(whole.general, module.chain, module.name, writing))
    return "\n".join(parts)


def runtime(kernel: GeneralKernel, name: str, writing: Writing) -> str:
    """What includes the algorithm of the runtime."""
    return writing.filled("general/runtime", P=name.upper(), table=general_table(kernel, name))


def source(kernel: GeneralKernel, name: str, writing: Writing) -> str:
    """The arm's table for the runtime, `<name>_general`."""
    table = general_table(kernel, name)
    return writing.filled("general/kernel", p=name, table=table, wrist=wrist(kernel))


def _rows(kernel: GeneralKernel, chain: Chain, name: str, writing: Writing) -> str:
    """The function `all_joints`; it calls the runtime and the descent."""
    solved = chain.solved  # with signs and offsets of joint values behind angles and lengths
    return writing.filled(
        "general/rows",
        p=name,
        rows=rows(kernel, chain),
        facing=_array("facing", [repr(float(joint.sign)) for joint in solved]),
        zero=_array("zero", [repr(joint.offset) for joint in solved]),
        table=general_table(kernel, name),
    )


def _array(name: str, entries: Sequence[str]) -> str:
    return indent(c_array(f"static const double {name}[{len(entries)}]", entries), INDENT)
