"""A parallel robot's file to its solvers: the legs' chains are compiled as serial arms are."""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING

from dhgen.atomic_write import write_files
from dhgen.compiler import Compilation, compile_loaded, source_name, verified, worked_out
from dhgen.parallel.module import LegModule, ParallelModule, elimination_of
from dhgen.parallel.printing import parallel_document
from dhgen.parallel.targets import parallel_files
from dhgen.robot_files import ParallelFile

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from dhgen.derivation.story import Story
    from dhgen.parallel.robot import ParallelRobot
    from dhgen.parallel.verify import ParallelReport
    from dhgen.robot_files import AnyFile
    from dhgen.targets.module import SolverModule


@dataclass(frozen=True, slots=True)
class ParallelCompilation:
    """A parallel robot's file and what the compiler makes of it.

    Attributes:
        robot: The file, validated.
        chains: The legs' chains, each once, compiled.
        module: The legs' programs and where they stand.
        files: Text of every file by its name, those of the chains among them.
    """

    robot: ParallelRobot
    chains: tuple[Compilation, ...]
    module: ParallelModule
    files: Mapping[str, str]


def compile_file(
    file: AnyFile,
    tell: Callable[[str], None] = lambda _: None,
    *,
    out: Path | None = None,
    single_file: bool = False,
) -> Compilation | ParallelCompilation:
    """Everything after a robot file has been read, serial or parallel, but verification.

    Args:
        file: The robot file, read.
        tell: Is told what is being done, for progress.
        out: The folder that the files are for, where it is known.
        single_file: Whether C and Python hold what they need of the runtime.

    Raises:
        UnsolvedError: No derivation solves the arm, or a leg.
        PrecisionError: The arm can't be solved in single precision, which the file asks for.
    """
    if isinstance(file, ParallelFile):
        return compile_parallel(file, tell, out=out, single_file=single_file)
    return compile_loaded(file, tell, out=out, single_file=single_file)


def compile_parallel(
    file: ParallelFile,
    tell: Callable[[str], None] = lambda _: None,
    *,
    out: Path | None = None,
    single_file: bool = False,
) -> ParallelCompilation:
    """The same of a parallel robot."""
    chains = tuple(
        compile_loaded(chain, tell, out=out, single_file=single_file) for chain in file.chains
    )
    module = _joined(file, [each.module for each in chains], out)
    files: dict[str, str] = {}
    for each in chains:
        files |= each.files
    files |= parallel_files(module, single_file=single_file)
    files |= parallel_document(module)
    return ParallelCompilation(file.robot, chains, module, MappingProxyType(files))


def parallel_stories(
    file: ParallelFile, tell: Callable[[str], None] = lambda _: None
) -> tuple[ParallelModule, tuple[Story, ...]]:
    """What is printed of a parallel robot, without its files, and of each kind of leg.

    Raises:
        UnsolvedError: No derivation solves a leg.
    """
    made = [worked_out(chain, tell) for chain in file.chains]
    return _joined(file, [solver for _, solver in made], None), tuple(story for story, _ in made)


def _joined(
    file: ParallelFile, solvers: Sequence[SolverModule], out: Path | None
) -> ParallelModule:
    """A robot with its legs' solvers."""
    by_name = {solver.name: solver for solver in solvers}
    of_legs = [by_name[leg.chain.name] for leg in file.robot.legs]
    return ParallelModule(
        robot=file.robot,
        legs=tuple(map(LegModule, file.robot.legs, of_legs)),
        source=source_name(file.path, out),
        digest=file.digest,
        elimination=elimination_of(file.robot, of_legs),
    )


def verified_parallel(
    compilation: ParallelCompilation, tell: Callable[[str], None] = lambda _: None
) -> ParallelReport:
    """Writes the files to a passing folder and proves them there, the legs' chains first.

    Raises:
        VerificationError: They are not as promised.
    """
    from dhgen.parallel.verify import verify_parallel  # noqa: PLC0415  the runtime takes its time

    reports = [verified(chain, tell) for chain in compilation.chains]
    with tempfile.TemporaryDirectory(prefix="dhgen-") as folder:
        write_files(Path(folder), compilation.files)
        return verify_parallel(compilation.module, Path(folder), reports)
