"""A solver that was built: the functions and constants of its module, with C behind them or not."""

from __future__ import annotations

import importlib.util
import sys
from typing import TYPE_CHECKING, Any

from dhgen.errors import CompilerError
from dhgen.runtime.helpers.dhgen_native import BuildError, NoCompiler, native

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path
    from types import ModuleType

    import numpy as np
    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.library.arm import Arm

    Rows = tuple[FloatArray, NDArray[np.uint8]]

C, NUMBA, PYTHON = "C", "numba", "plain Python"


class Solver:
    """Exact inverse kinematics of an arm, as `arm.build()` gives it.

    Its functions and constants are those of the generated module, which `help(solver.ik)` and the
    like describe. It can be pickled: another process opens the same solver.

    Attributes:
        arm: What it was built of.
        module: The generated module.
        folder: Where it is kept, with its C, its header and its derivation.
        backend: What solves: "C", "numba" or "plain Python".
        NAME: Identifier of the robot.
        METHOD: How the arm is solved: "closed form", "quartic", "general 6R" ...
        DOF: The number of joints.
        JOINT_TYPES: R or P for every joint.
        JOINT_NAMES: What the joints are called.
        JOINT_LIMITS: Lowest and highest value of every joint, infinite without one.
        BRANCHES: What the rows of `ik_all` are called.
        MAX_SOLUTIONS: The number of rows.
        OK: The status of a row that holds a solution.
        UNREACHABLE: That of a row without one.
        FREE_JOINT: That of a solution of which a joint was indeterminate.
        OUT_OF_LIMITS: That of a solution with a joint beyond its limits.
        INVALID_POSE: That of all rows where T is no pose.
        Unreachable: What `ik` raises, a ValueError.
        fk: The pose (4, 4) of joint values (n,).
        jacobian: The geometric Jacobian (6, n) at joint values (n,).
        joint_velocities: The joint velocities (n,) of a twist (6,) at joint values (n,).
        frames: The frames of the base, of every link and of the tool, (n + 2, 4, 4).
        ik: The solution nearest to a seed, (n,), with limits and whole turns respected.
        ik_all: All rows (MAX_SOLUTIONS, n) and their statuses (MAX_SOLUTIONS,).
        ik_batch: The rows and statuses of many poses (N, 4, 4).
        ik_into: As `ik_all`, into arrays of the caller's; numba functions can call it.
        warm_up: Compiles what numba has not compiled yet.
        arm_angle: The arm angle of joint values, where the caller gives it; None of other arms.
    """

    arm: Arm
    module: ModuleType
    folder: Path
    backend: str
    NAME: str
    METHOD: str
    DOF: int
    JOINT_TYPES: str
    JOINT_NAMES: tuple[str, ...]
    JOINT_LIMITS: tuple[tuple[float, float], ...]
    BRANCHES: tuple[str, ...]
    MAX_SOLUTIONS: int
    OK: int
    UNREACHABLE: int
    FREE_JOINT: int
    OUT_OF_LIMITS: int
    INVALID_POSE: int
    Unreachable: type[ValueError]
    fk: Callable[[Any], FloatArray]
    jacobian: Callable[[Any], FloatArray]
    joint_velocities: Callable[[Any, Any], FloatArray]
    frames: Callable[[Any], FloatArray]
    ik: Callable[..., FloatArray]
    ik_all: Callable[..., Rows]
    ik_batch: Callable[..., Rows]
    ik_into: Callable[..., int]
    warm_up: Callable[[], None]
    arm_angle: Callable[[Any], float] | None

    def __init__(self, arm: Arm, folder: Path, *, in_c: bool) -> None:
        path = folder / f"{arm.name}.py"
        self.module = _imported(path)
        compiling = sys.modules[type(vars(self.module)["_HOW"]).__module__]
        self.backend = NUMBA if vars(compiling)["COMPILED"] else PYTHON
        if in_c:
            self._put_c_behind()
        self.arm, self.folder = arm, folder
        for name in Solver.__annotations__:
            if name not in vars(self):
                setattr(self, name, getattr(self.module, name, None))

    def _put_c_behind(self) -> None:
        try:
            self.module = native(self.module)
        except NoCompiler:
            return
        except BuildError as error:
            raise CompilerError(f"{error}\nwithout C: build(native=False)") from error
        self.backend = C

    def __repr__(self) -> str:
        rows = "1 row" if self.MAX_SOLUTIONS == 1 else f"{self.MAX_SOLUTIONS} rows"
        joints = f"{self.JOINT_TYPES}, {self.METHOD}, {rows}"
        return f"<dhgen.Solver of {self.NAME}: {joints}, by {self.backend}>"

    def __reduce__(self) -> tuple[Callable[..., Solver], tuple[Arm, bool]]:
        return _built_again, (self.arm, self.backend == C)


def _built_again(arm: Arm, in_c: bool) -> Solver:  # noqa: FBT001 - pickle passes no names
    """What another process built."""
    return arm.build(native=in_c)


def _imported(path: Path) -> ModuleType:
    """A kept module under a name of its own, which exceptions that are pickled name, too."""
    name = f"dhgen_solver_{path.parent.name}"
    if name in sys.modules:
        return sys.modules[name]
    spec = importlib.util.spec_from_file_location(name, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    try:
        spec.loader.exec_module(module)
    except BaseException:
        del sys.modules[name]
        raise
    return module
