"""The front door: a robot file in, verified solvers and their derivation out.

| stage  | from           | to             | where             |
|--------|----------------|----------------|-------------------|
| load   | YAML text      | Robot          | dhgen/robot       |
| model  | Robot          | Chain          | dhgen/kinematics  |
| derive | Chain          | Derivation     | dhgen/paul        |
| lower  | Derivation     | Program        | dhgen/program     |
| emit   | Program        | files, as text | dhgen/targets     |
| verify | files          | Report         | dhgen/verify      |

Every value between stages is frozen; data flows one way.
"""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from dhgen.kinematics.build import build_chain
from dhgen.paul.derivation import derive
from dhgen.program.forward import forward_program, jacobian_program
from dhgen.program.lower import lower
from dhgen.robot.load import load
from dhgen.targets.emit import emit
from dhgen.targets.module import SolverModule
from dhgen.verify.verify import verify

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.paul.derivation import Derivation
    from dhgen.robot.robot import Robot
    from dhgen.verify.verify import Report


@dataclass(frozen=True, slots=True)
class Compilation:
    """A robot file and what the compiler makes of it.

    Attributes:
        robot: The file, validated.
        derivation: Why the solver is what it is.
        module: The programs.
        files: Text of every file by its name.
    """

    robot: Robot
    derivation: Derivation
    module: SolverModule
    files: dict[str, str]


def compile_robot(path: Path, tell: Callable[[str], None] = lambda _: None) -> Compilation:
    """Everything but verification.

    Args:
        path: The robot file.
        tell: Is told what is being done, for progress.

    Raises:
        RobotFileError: The file has mistakes.
        UnsolvedError: No derivation solves the arm.
    """
    robot = load(path)
    tell("deriving")
    chain = build_chain(robot)
    derivation = derive(chain)
    tell("writing programs")
    module = SolverModule(
        name=robot.name,
        title=robot.title,
        source=source_name(path),
        chain=chain,
        solver=lower(derivation),
        forward=forward_program(chain),
        jacobian=jacobian_program(chain),
        length_unit=robot.length_unit,
    )
    return Compilation(robot, derivation, module, emit(robot, derivation, module))


def verified(compilation: Compilation, tell: Callable[[str], None] = lambda _: None) -> Report:
    """Writes the files to a passing folder and proves them there.

    Raises:
        VerificationError: They are not as promised.
    """
    tell("verifying")
    with tempfile.TemporaryDirectory(prefix="dhgen-") as folder:
        for name, text in compilation.files.items():
            (Path(folder) / name).write_text(text, encoding="utf-8")
        return verify(compilation.module, Path(folder))


def source_name(path: Path) -> str:
    """How emitted files call their source: its folder and name, the same from everywhere."""
    resolved = path.resolve()
    return f"{resolved.parent.name}/{resolved.name}".lstrip("/")
