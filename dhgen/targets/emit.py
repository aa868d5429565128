"""All targets at once: the files of a robot by their names."""

from __future__ import annotations

from functools import cache, partial
from types import MappingProxyType
from typing import TYPE_CHECKING

from dhgen.targets.c.files import c_files
from dhgen.targets.derivation import derivation_document
from dhgen.targets.python.files import digested, python_files
from dhgen.targets.templates import render

if TYPE_CHECKING:
    from collections.abc import Mapping

    from dhgen.paul.derivation import Derivation
    from dhgen.robot.robot import Robot
    from dhgen.targets.module import SolverModule

HELPERS = {
    "dhgen_native.py": "python/dhgen_native.py.jinja",
    "dhgen_pose.py": "python/dhgen_pose.py.jinja",
    "dhgen_pose.h": "c/dhgen_pose.h.jinja",
    "dhgen_pose.c": "c/dhgen_pose.c.jinja",
}


def emit(
    robot: Robot, derivation: Derivation, module: SolverModule, single: SolverModule | None
) -> dict[str, str]:
    """The solver in every language, the derivation, and the helpers that all robots share.

    Args:
        robot: The robot file.
        derivation: What the programs were made from.
        module: The programs.
        single: The same for single precision, if it is asked for: C only.
    """
    document = derivation_document(robot, derivation, module.solver, module.source)
    return {
        **python_files(module),
        **c_files(module),
        **({} if single is None else c_files(single)),
        f"{module.name}.md": document,
        **helpers(),
    }


@cache
def helpers() -> Mapping[str, str]:
    """The files that all robots share, by their names."""
    texts = {name: digested(partial(_helper, template)) for name, template in HELPERS.items()}
    return MappingProxyType(texts)


def _helper(template: str, digest: str) -> str:
    return render(template, digest=digest)
