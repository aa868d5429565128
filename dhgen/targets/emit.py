"""All targets at once: the solvers of a robot by the names of their files."""

from __future__ import annotations

from functools import cache, partial
from types import MappingProxyType
from typing import TYPE_CHECKING

from dhgen.printing.templates import render
from dhgen.runtime import runtime_files
from dhgen.targets.c.files import c_files
from dhgen.targets.python.files import digested, python_files

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.targets.module import SolverModule

HELPERS = {
    "dhgen_native.py": "python/dhgen_native.py.jinja",
    "dhgen_pose.py": "python/dhgen_pose.py.jinja",
    "dhgen_pose.h": "c/dhgen_pose.h.jinja",
    "dhgen_pose.c": "c/dhgen_pose.c.jinja",
}


def emit(module: SolverModule, single: SolverModule | None) -> dict[str, str]:
    """The solver in every language, and the files that all robots share.

    Args:
        module: The programs.
        single: The same for single precision, if it is asked for: C only.
    """
    return {
        **python_files(module),
        **c_files(module),
        **({} if single is None else c_files(single)),
        **helpers(),
    }


@cache
def helpers() -> Mapping[str, str]:
    """The files that all robots share, by their paths in the folder: helpers and the runtime."""
    texts = {name: digested(partial(_helper, template)) for name, template in HELPERS.items()}
    return MappingProxyType({**texts, **runtime_files()})


def _helper(template: str, digest: str) -> str:
    return render(template, digest=digest)
