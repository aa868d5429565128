"""Fills in the templates of the general algorithm."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.targets.general.table import general_table
from dhgen.targets.general.wrist import wrist
from dhgen.targets.layout import c_array
from dhgen.targets.numerical.emit import table

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.general.kernel import GeneralKernel
    from dhgen.program.ir import AllJoints
    from dhgen.targets.module import SolverModule
    from dhgen.targets.solver.module import Module
    from dhgen.targets.writing import Writing


def all_joints(whole: AllJoints, module: SolverModule, of: Module, writing: Writing) -> str:
    """What solves for all joints at once, in C."""
    if whole.general is None:
        return table(whole.descent, of, writing)
    solved = module.chain.solved  # with signs and offsets behind angles and lengths
    facing = _array("facing", [repr(float(joint.sign)) for joint in solved])
    zero = _array("zero", [repr(joint.offset) for joint in solved])
    general = source(whole.general, module.name, writing)
    return f"{general}\n{table(whole.descent, of, writing, facing, zero)}"


def runtime(
    kernel: GeneralKernel | None, name: str, shape: tuple[int, int], writing: Writing
) -> str:
    """What includes the algorithm of the runtime, or the numerical solver; for joints and rows."""
    return writing.filled(
        "numerical/runtime",
        P=name.upper(),
        dof=shape[0],
        rows=shape[1],
        table=None if kernel is None else general_table(kernel, name),
    )


def source(kernel: GeneralKernel, name: str, writing: Writing) -> str:
    """The arm's table for the runtime, `<name>_general`."""
    own = general_table(kernel, name)
    return writing.filled("general/kernel", p=name, table=own, wrist=wrist(kernel))


def _array(name: str, entries: Sequence[str]) -> str:
    return c_array(f"static const double {name}[{len(entries)}]", entries)
