"""The survey: every arm compiled, its C put to work, its answers counted."""

from __future__ import annotations

import tempfile
import time
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from dhgen.atomic_write import write_files
from dhgen.compiler import Compilation, compile_loaded
from dhgen.errors import DhgenError, RobotFileError
from dhgen.kinematics.build import build_chain
from dhgen.method import Method
from dhgen.oracle.arm import arm, arm_size
from dhgen.parallel.compile import compile_parallel
from dhgen.robot_files import ParallelFile, read_file
from dhgen.runtime import c_runtime_files
from dhgen.survey.ask import ask_random, ask_singular
from dhgen.survey.parallel import parallel_answers
from dhgen.survey.recall import ask_recall
from dhgen.survey.sources import arm_class, joint_letters, robot_files
from dhgen.survey.table import Answers, Line
from dhgen.survey.trial import Trial
from dhgen.verify.demands import GENERAL_RESIDUAL, RESIDUAL
from dhgen.verify.native import NATIVE, PORTABLE, compile_solver
from dhgen.workers import side_by_side

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from dhgen.paul.derivation import Derivation
    from dhgen.survey.sources import Source

SINGULAR_SHARE = 4  # random poses for one of each singular kind


def survey(
    given: Sequence[Path],
    poses: int,
    recall: int = 0,
    progress: Callable[[str], None] = lambda _: None,
) -> tuple[Line, ...]:
    """Surveys robot files, folders of them and lists in JSON, on all cores.

    Args:
        given: Where the arms are.
        poses: Random poses of each; a quarter as many of every singular kind.
        recall: Random poses of each on which only its own joint values are looked for.
        progress: Called with every arm that is done, and for a single one with what is being done.

    Raises:
        RobotFileError: A path does not exist, or a list can't be read. Mistakes in single robot
            files are in their lines.
    """
    lines: list[Line] = []
    with tempfile.TemporaryDirectory(prefix="dhgen-survey-") as folder:
        files = robot_files(given, Path(folder))
        make = partial(survey_arm, poses=poses, recall=recall)
        if len(files) == 1:  # which is made in this process
            make = partial(make, progress=progress)
        for line in side_by_side(make, files):
            lines.append(_alone(line, lines))
            progress(f"{len(lines)} of {len(files)}: {line.name}")
    return tuple(lines)


def survey_arm(
    source: Source, poses: int, recall: int = 0, progress: Callable[[str], None] = lambda _: None
) -> Line:
    """One arm's line; equal at every run but for the CPU time."""
    name, joints, structure = source.name, "", ""
    remarks: tuple[str, ...] = ()
    try:
        file = read_file(source.path)
        if isinstance(file, ParallelFile):
            return _parallel_line(file, source, poses, recall, progress)
        robot = file.robot
        name = robot.name
        remarks = tuple(f"note: {source.located(notice)}" for notice in robot.notices)
        chain = build_chain(robot)
        joints, structure = joint_letters(chain), arm_class(chain)
        start = time.process_time()
        compilation = compile_loaded(file, progress)
        cpu = time.process_time() - start
        answers = _answers(compilation, poses, recall, cpu, progress)
    except RobotFileError as error:
        notes = (f"note: {source.located(note)}" for note in error.notes)
        remarks = (*map(source.located, error.diagnostics), *notes)
        first = remarks[0].splitlines()[0]
        return Line(name, joints, structure, None, first, mistaken=True, remarks=remarks)
    except DhgenError as error:
        first = str(error).splitlines()[0]
        return Line(name, joints, structure, None, first, remarks=remarks)
    return Line(name, joints, structure, answers, remarks=remarks)


def _parallel_line(
    file: ParallelFile, source: Source, poses: int, recall: int, progress: Callable[[str], None]
) -> Line:
    """The line of a parallel robot; its legs' joints count, each leg's once."""
    robot = file.robot
    remarks = tuple(f"note: {source.located(notice)}" for notice in robot.notices)
    chains = [build_chain(leg.chain) for leg in robot.legs]
    types = dict.fromkeys(joint_letters(chain) for chain in chains)
    joints = f"{len(chains)}-{'/'.join(types)}"
    structure = f"parallel, {robot.task.text.strip('[]')}"
    start = time.process_time()
    made = compile_parallel(file, progress)
    cpu = time.process_time() - start
    answers = parallel_answers(made, poses, recall, cpu, progress)
    return Line(robot.name, joints, structure, answers, remarks=remarks)


def _alone(line: Line, others: Sequence[Line]) -> Line:
    """A name identifies an arm: the second of that name has no line of its own."""
    if all(line.name != other.name for other in others):
        return line
    reason = f"another arm above has the same name, '{line.name}'"
    return replace(line, answers=None, reason=reason, mistaken=True)


def _answers(
    compilation: Compilation, poses: int, recall: int, cpu: float, progress: Callable[[str], None]
) -> Answers:
    robot, module = compilation.robot, compilation.module
    derivation = compilation.derivation
    bound = RESIDUAL if derivation.whole is None else GENERAL_RESIDUAL
    with tempfile.TemporaryDirectory(prefix="dhgen-") as folder:
        source = Path(folder) / f"{robot.name}.c"
        own = {name: compilation.files[name] for name in (source.name, f"{robot.name}.h")}
        write_files(Path(folder), {**own, **c_runtime_files()})
        rows, free = module.solver.rows, module.chain.given
        of = source, Path(folder), robot.name, len(robot.joints), rows, free
        c, fast = (compile_solver(*of, build=build) for build in (PORTABLE, NATIVE))
        if c is None or fast is None:
            raise DhgenError("a survey needs a C compiler: cc, gcc, clang or $CC")
        trial = Trial(robot, arm(robot), arm_size(robot), c)
        progress(f"{robot.name}: searching for all solutions on {poses} random poses")
        random = ask_random(trial, poses, bound)
        progress(f"{robot.name}: singular poses")
        singular = ask_singular(trial, -(-poses // SINGULAR_SHARE), bound)
        progress(f"{robot.name}: looking for its own joint values on {recall} random poses")
        recalled = ask_recall(replace(trial, solver=fast), recall)
    return Answers(
        method=module.method,
        degree=_degree(derivation),
        rows=rows,
        cpu=cpu,
        poses=poses,
        expected=random.expected,
        found=random.found,
        spurious=random.spurious,
        unmet=random.unmet,
        residual=max(random.residual, singular.residual),
        bound=bound,
        singular=singular.poses,
        answered=singular.answered,
        tried=recalled.poses,
        recalled=recalled.recalled,
        faults=(*random.faults, *singular.faults, *recalled.faults),
    )


def _degree(derivation: Derivation) -> int:
    """Of the highest polynomial: as many roots as a step has; 0 where there is none."""
    if derivation.method is Method.NUMERICAL:
        return 0
    if derivation.whole is not None:
        return derivation.branches
    return max((step.roots for step in derivation.steps), default=1)
