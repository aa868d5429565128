"""How C writes the parts of a solver that have templates of their own."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.targets.general.emit import all_joints, runtime
from dhgen.targets.numerical.arrays import c_arrays
from dhgen.targets.writing import Writing

if TYPE_CHECKING:
    from dhgen.program.ir import AllJoints
    from dhgen.targets.module import SolverModule
    from dhgen.targets.solver.module import Module


def _all_joints(whole: AllJoints, module: SolverModule, of: Module) -> str:
    return all_joints(whole, module, of, IN_C)


def _included(whole: AllJoints, module: SolverModule) -> str:
    shape = module.chain.dof, module.solver.rows
    return runtime(whole.general, module.name, shape, IN_C)


IN_C: Writing = Writing("c/{}.c.jinja", c_arrays, _all_joints, _included)
