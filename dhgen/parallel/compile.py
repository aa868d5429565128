"""A parallel robot's file to its solvers: the legs' chains are compiled as serial arms are."""

from __future__ import annotations

import tempfile
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, TypeVar

from dhgen.atomic_write import write_files
from dhgen.compiler import Compilation, compile_loaded, source_name, verified, worked_out
from dhgen.errors import UnsolvedError
from dhgen.kinematics.build import build_chain
from dhgen.parallel.module import LegModule, ParallelModule, elimination_of
from dhgen.parallel.printing import parallel_document
from dhgen.parallel.targets import parallel_files
from dhgen.paul.mobility import surplus
from dhgen.paul.refusal.redundancy import why_redundant
from dhgen.robot_files import ParallelFile

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from dhgen.derivation.story import Story
    from dhgen.legs.robot import ParallelRobot
    from dhgen.parallel.verify import ParallelReport
    from dhgen.robot_files import AnyFile, RobotFile
    from dhgen.targets.module import SolverModule

Made = TypeVar("Made")


@dataclass(frozen=True, slots=True)
class ParallelCompilation:
    """A parallel robot's file and what the compiler makes of it.

    Attributes:
        robot: The file, validated.
        chains: The legs' chains, each once, compiled.
        module: The robot as it is printed.
        files: Text of every file by its name, those of the chains among them.
    """

    robot: ParallelRobot
    chains: tuple[Compilation, ...]
    module: ParallelModule
    files: Mapping[str, str]


def compile_file(
    file: AnyFile,
    progress: Callable[[str], None] = lambda _: None,
    *,
    out: Path | None = None,
    single_file: bool = False,
) -> Compilation | ParallelCompilation:
    """Everything after a robot file has been read, serial or parallel, but verification.

    Args:
        file: The robot file, read.
        progress: Called with what is being done.
        out: The folder that the files are for, where it is known.
        single_file: Whether C and Python hold what they need of the runtime.

    Raises:
        UnsolvedError: No derivation solves the arm, or a leg.
        PrecisionError: The arm can't be solved in single precision, which the file asks for.
    """
    if isinstance(file, ParallelFile):
        return compile_parallel(file, progress, out=out, single_file=single_file)
    return compile_loaded(file, progress, out=out, single_file=single_file)


def compile_parallel(
    file: ParallelFile,
    progress: Callable[[str], None] = lambda _: None,
    *,
    out: Path | None = None,
    single_file: bool = False,
) -> ParallelCompilation:
    """Compiles a parallel robot."""
    chains = tuple(
        _of_legs(file, chain, partial(compile_loaded, out=out, single_file=single_file), progress)
        for chain in file.chains
    )
    module = _joined(file, [each.module for each in chains], out)
    files: dict[str, str] = {}
    for each in chains:
        files |= each.files
    files |= parallel_files(module, single_file=single_file)
    files |= parallel_document(module)
    return ParallelCompilation(file.robot, chains, module, MappingProxyType(files))


def parallel_stories(
    file: ParallelFile, progress: Callable[[str], None] = lambda _: None
) -> tuple[ParallelModule, tuple[Story, ...]]:
    """What is printed of a parallel robot, without its files, and of each kind of leg.

    Raises:
        UnsolvedError: No derivation solves a leg.
    """
    made = [_of_legs(file, chain, worked_out, progress) for chain in file.chains]
    return _joined(file, [solver for _, solver in made], None), tuple(story for story, _ in made)


def _of_legs(
    file: ParallelFile,
    chain: RobotFile,
    make: Callable[[RobotFile, Callable[[str], None]], Made],
    progress: Callable[[str], None],
) -> Made:
    """What is made of a kind of leg, all of whose joints are to be solved for.

    Raises:
        UnsolvedError: No derivation solves it, or joints of the leg depend on each other; the
            message begins with the numbers of the legs.
    """
    alike = [n for n, leg in enumerate(file.robot.legs, 1) if leg.chain == chain.robot]
    which = f"leg{'s' * (len(alike) > 1)} {', '.join(map(str, alike))}"
    model = build_chain(chain.robot)
    spare = surplus(model)
    if spare.count and not chain.robot.numerical:
        first, *others = why_redundant(model, spare)
        raise UnsolvedError("\n".join([f"{which}: {first}", *others]))
    try:
        return make(chain, progress)
    except UnsolvedError as error:
        raise UnsolvedError(f"{which}: {error}") from error


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
    compilation: ParallelCompilation, progress: Callable[[str], None] = lambda _: None
) -> ParallelReport:
    """Writes the files to a passing folder and proves them there, the legs' chains first.

    Raises:
        ImmobileError: The legs can't move the platform.
        VerificationError: They are not as promised.
    """
    from dhgen.parallel.verify import verify_parallel  # noqa: PLC0415  the runtime takes its time

    reports = [verified(chain, progress) for chain in compilation.chains]
    with tempfile.TemporaryDirectory(prefix="dhgen-") as folder:
        write_files(Path(folder), compilation.files)
        return verify_parallel(compilation.module, Path(folder), reports)
