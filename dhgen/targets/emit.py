"""All targets at once: the solvers of a robot by the names of their files."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.runtime import runtime_files
from dhgen.runtime.helpers import helper_files
from dhgen.targets.c.calibrated import kind_files
from dhgen.targets.c.files import c_files
from dhgen.targets.python.calibrated import kind_module
from dhgen.targets.python.files import python_files

if TYPE_CHECKING:
    from dhgen.targets.calibrated import Kind
    from dhgen.targets.module import SolverModule


def emit(
    module: SolverModule,
    single: SolverModule | None,
    kind: Kind | None,
    *,
    single_file: bool = False,
) -> dict[str, str]:
    """The solver in every language, and the files that all robots share.

    Args:
        module: The programs.
        single: The same for single precision, if it is asked for: C only.
        kind: Arms with tables that come at run time, if these are asked for.
        single_file: Whether C and Python hold what they need of the runtime.
    """
    return {
        **python_files(module, single_file=single_file),
        **c_files(module, single_file=single_file),
        **({} if single is None else c_files(single)),
        **({} if kind is None else kind_files(kind, single_file=single_file)),
        **({} if kind is None else kind_module(kind, single_file=single_file)),
        **helper_files(),
        **({} if single_file else runtime_files()),
    }
