"""The front door: a robot file in, verified solvers and their derivation out.

| stage  | from       | to           | where              |
|--------|------------|--------------|--------------------|
| import | URDF       | YAML text    | dhgen/descriptions |
| load   | YAML text  | Robot        | dhgen/robot        |
| model  | Robot      | Chain        | dhgen/kinematics   |
| derive | Chain      | Derivation   | dhgen/paul         |
| lower  | Derivation | Program      | dhgen/program      |
| print  | Derivation | its document | dhgen/derivation   |
| emit   | Program    | its solvers  | dhgen/targets      |
| verify | files      | Report       | dhgen/verify       |

Every value between stages is frozen; data flows one way.
"""

from __future__ import annotations

import tempfile
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING

from dhgen.atomic_write import write_files
from dhgen.calibrated import kind_of
from dhgen.derivation import derivation_files
from dhgen.errors import PrecisionError, VerificationError
from dhgen.kinematics.link_table import link_table
from dhgen.method import Method
from dhgen.program.lowering.lower import lower
from dhgen.program.lowering.programs import robot_programs
from dhgen.program.policy import policy_of
from dhgen.robot_files import led_to
from dhgen.solved import solved
from dhgen.targets.emit import emit
from dhgen.targets.module import SolverModule
from dhgen.targets.reserved import RESERVED
from dhgen.tolerances import DOUBLE, SINGLE
from dhgen.verify.single import verify_single
from dhgen.verify.verify import verify

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

    from dhgen.derivation.story import Story
    from dhgen.paul.derivation import Derivation
    from dhgen.program.ir import Program
    from dhgen.robot.robot import Robot
    from dhgen.robot_files import RobotFile
    from dhgen.targets.calibrated import Kind
    from dhgen.tolerances import Precision
    from dhgen.verify.verify import Report


@dataclass(frozen=True, slots=True)
class Compilation:
    """A robot file and what the compiler makes of it.

    Attributes:
        story: The file, validated, and how its arm is solved.
        module: The programs.
        single: The programs for single precision, where the file asks for them.
        kind: Arms with tables that come at run time, where it asks for these.
        files: Text of every file by its name.
    """

    story: Story
    module: SolverModule
    single: SolverModule | None
    kind: Kind | None
    files: Mapping[str, str]

    @property
    def robot(self) -> Robot:
        """The file, validated."""
        return self.story.robot

    @property
    def derivation(self) -> Derivation:
        """Why the solver is what it is."""
        return self.story.derivation


def compile_loaded(
    file: RobotFile,
    progress: Callable[[str], None] = lambda _: None,
    *,
    out: Path | None = None,
    single_file: bool = False,
) -> Compilation:
    """Everything after the robot file has been read, but verification.

    Args:
        file: The robot file, read.
        progress: Called with what is being done.
        out: The folder that the files are for, where it is known.
        single_file: Whether C and Python hold what they need of the runtime.

    Raises:
        UnsolvedError: No derivation solves the arm, or not with tables that come at run time.
        PrecisionError: The arm can't be solved in single precision, which the file asks for.
    """
    story, module = worked_out(file, progress, out=out)
    source = source_name(file.path, out)
    single = in_single_precision(story, file, source) if file.robot.float32 else None
    document = derivation_files(story, source)
    kind = kind_of(file.robot, module, RESERVED) if file.robot.calibration else None
    files = {**emit(module, single, kind, single_file=single_file), **document}
    return Compilation(story, module, single, kind, MappingProxyType(files))


def worked_out(
    file: RobotFile, progress: Callable[[str], None] = lambda _: None, *, out: Path | None = None
) -> tuple[Story, SolverModule]:
    """The derivation and the programs.

    Args:
        file: The robot file, read.
        progress: Called with what is being done.
        out: The folder that files are for, where it is known.

    Raises:
        UnsolvedError: No derivation solves the arm.
    """
    story = solved(file, progress)
    return story, _module(file, story, story.program, source_name(file.path, out), DOUBLE)


def in_single_precision(story: Story, file: RobotFile, source: str) -> SolverModule:
    """The programs for single precision.

    Args:
        story: How the arm is solved.
        file: The robot file, read.
        source: How emitted files call it.

    Raises:
        PrecisionError: The arm can't be solved in single precision.
    """
    _demand_closed_form(story.derivation)
    solver = lower(story.derivation, SINGLE.tolerances, RESERVED)
    return _module(file, story, solver, source, SINGLE)


def _module(
    file: RobotFile, story: Story, solver: Program, source: str, precision: Precision
) -> SolverModule:
    """The programs of a robot for some arithmetic, under the name that they bear there."""
    robot, derivation = file.robot, story.derivation
    name = robot.name + precision.suffix
    programs = robot_programs(derivation, solver, name, precision.tolerances, RESERVED)
    chain = derivation.problem.algebra.chain
    return SolverModule(
        name=name,
        title=robot.title,
        source=source,
        chain=chain,
        method=derivation.method,
        solver=programs.solver,
        forward=programs.forward,
        jacobian=programs.jacobian,
        policy=policy_of(chain, programs.solver, precision.tolerances),
        length_unit=robot.length_unit,
        links=link_table(robot),
        arm_angle=programs.arm_angle,
        plane_miss=programs.plane_miss,
        digest=file.digest,
        precision=precision,
        plain=robot.plain,
        nominal=story.nominal,
        nearest_branches=() if story.nominal is None else story.nominal.solver.branches,
        owner=robot.owner,
    )


def _demand_closed_form(derivation: Derivation) -> None:
    """Roots of polynomials lose half of their digits; of seven too few are left."""
    method = derivation.method
    if method is not Method.CLOSED_FORM:
        name = derivation.problem.algebra.chain.name
        what = "a quartic" if method is Method.QUARTIC else method
        raise PrecisionError(
            f"{name}: float32 is only for arms with a closed form; this one needs another method "
            f"({what}), which is too inaccurate in single precision: leave float32 out"
        )


def verified(compilation: Compilation, progress: Callable[[str], None] = lambda _: None) -> Report:
    """Writes the files to a passing folder and proves them there.

    Raises:
        VerificationError: They are not as promised.
    """
    progress("verifying")
    with tempfile.TemporaryDirectory(prefix="dhgen-") as folder:
        write_files(Path(folder), compilation.files)
        report = verify(compilation.module, Path(folder))
        if compilation.kind is not None:
            from dhgen.verify.calibrated import verify_kind  # noqa: PLC0415  the runtime takes its time

            code = verify_kind(compilation.kind, Path(folder))
            report = replace(report, code={**report.code, compilation.kind.module.name: code})
        if compilation.single is None:
            return report
        try:
            return replace(report, single=verify_single(compilation.single, Path(folder)))
        except VerificationError as error:
            way_out = "double precision passes: leave float32 out for now"
            raise VerificationError(f"{error}\n{way_out}") from error


def source_name(path: Path, out: Path | None = None) -> str:
    """How emitted files call their source, wherever they are made.

    By its folder and name; by its name alone where it lies in the folder that the files are for, or
    above: that may be the project's, which has another name in every checkout.
    """
    folder, name = led_to(path).parent, path.name
    if out is not None and led_to(out).is_relative_to(folder):
        return name
    return f"{folder.name}/{name}".lstrip("/")
