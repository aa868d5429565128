"""dhgen: a compiler from robot descriptions and Denavit-Hartenberg tables to exact kinematics.

    import dhgen

    arm = dhgen.load("ur5.urdf")  # URDF, xacro, MJCF, a robot file (YAML), or a dict like one
    T = arm.fk([0.1, -1.2, 1.5, 0.2, 0.9, 0.3])
    solver = arm.build()  # verified; takes a while the first time, and is kept
    q, status = solver.ik_all(T)

What these names need is imported when they are first asked for: `import dhgen` is quick.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from dhgen import errors
    from dhgen.errors import (
        CommandError,
        CompilerError,
        DhgenError,
        ImmobileError,
        PrecisionError,
        RobotFileError,
        UnsolvedError,
        VerificationError,
    )
    from dhgen.library.arm import Arm
    from dhgen.library.load import load
    from dhgen.library.solver import Solver

__version__ = "0.2.0.dev0"
__all__ = [
    "Arm",
    "CommandError",
    "CompilerError",
    "DhgenError",
    "ImmobileError",
    "PrecisionError",
    "RobotFileError",
    "Solver",
    "UnsolvedError",
    "VerificationError",
    "__version__",
    "errors",
    "load",
]

_PLACES = {"Arm": "library.arm", "Solver": "library.solver", "load": "library.load"}


def __getattr__(name: str) -> Any:  # noqa: ANN401
    if name not in __all__:
        raise AttributeError(f"module 'dhgen' has no attribute {name!r}")
    if name == "errors":
        return import_module("dhgen.errors")
    value = getattr(import_module(f"dhgen.{_PLACES.get(name, 'errors')}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
