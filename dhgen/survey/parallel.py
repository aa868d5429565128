"""What the legs of a parallel robot are asked: every solution on poses of the platform.

The oracle of serial arms finds the solutions of each leg by search, from the robot file alone.
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from dhgen.atomic_write import write_files
from dhgen.errors import DhgenError
from dhgen.oracle.arm import arm, arm_size
from dhgen.parallel.native import compiled
from dhgen.parallel.worked import reached, square
from dhgen.survey.ask import Random, Singular, Tally, ask_singular
from dhgen.survey.recall import Recall, ask_recall
from dhgen.survey.table import Answers
from dhgen.survey.trial import Trial
from dhgen.verify.demands import RESIDUAL
from dhgen.verify.native import PORTABLE, compile_solver

if TYPE_CHECKING:
    from collections.abc import Callable

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.compiler import Compilation
    from dhgen.parallel.compile import ParallelCompilation
    from dhgen.parallel.module import ParallelModule
    from dhgen.parallel.native import Native

SINGULAR_SHARE = 4  # random poses for one of each singular kind of a leg


def parallel_answers(
    made: ParallelCompilation, poses: int, recall: int, cpu: float, progress: Callable[[str], None]
) -> Answers:
    """How the solver of a parallel robot does.

    Args:
        made: The robot.
        poses: How many random poses of the platform it is asked.
        recall: On how many of each kind of leg only its own joint values are looked for.
        cpu: What it took to make it [s].
        progress: Called with what is being done.
    """
    with tempfile.TemporaryDirectory(prefix="dhgen-") as name:
        folder = Path(name)
        write_files(folder, made.files)
        native = compiled(made.module, folder)
        if native is None:
            raise DhgenError("a survey needs a C compiler: cc, gcc, clang or $CC")
        trials = {each.robot.name: _trial(each, folder) for each in made.chains}
        what = f"searching for all solutions of {len(made.module.legs)} legs"
        progress(f"{made.module.name}: {what} on {poses} random poses")
        random = _ask(made.module, native, trials, _reached(made.module, native, poses))
        progress(f"{made.module.name}: singular poses of its legs")
        count = -(-poses // SINGULAR_SHARE)
        singular = [ask_singular(trial, count, RESIDUAL) for trial in trials.values()]
        progress(
            f"{made.module.name}: looking for its legs' own joint values on {recall} random poses"
        )
        recalled = [ask_recall(trial, recall) for trial in trials.values()]
    return _counted(made, random, singular, recalled, poses, cpu)


def _counted(
    made: ParallelCompilation,
    random: Random,
    singular: list[Singular],
    recalled: list[Recall],
    poses: int,
    cpu: float,
) -> Answers:
    answered = sum(each.answered for each in singular)
    return Answers(
        method=made.chains[0].module.method,
        degree=max(step.roots for each in made.chains for step in each.derivation.steps),
        rows=made.module.rows,
        cpu=cpu,
        poses=poses,
        expected=random.expected,
        found=random.found,
        spurious=random.spurious,
        unmet=random.unmet,
        residual=max(random.residual, *(each.residual for each in singular)),
        bound=RESIDUAL,
        singular=sum(each.poses for each in singular),
        answered=answered,
        tried=sum(each.poses for each in recalled),
        recalled=sum(each.recalled for each in recalled),
        faults=(
            *random.faults,
            *(fault for each in singular for fault in each.faults),
            *(fault for each in recalled for fault in each.faults),
        ),
    )


def _trial(chain: Compilation, folder: Path) -> Trial:
    module, robot = chain.module, chain.robot
    of = folder / f"{robot.name}.c", folder, robot.name, module.chain.dof, module.solver.rows, 0
    solver = compile_solver(*of, build=PORTABLE)
    assert solver is not None
    return Trial(robot, arm(robot), arm_size(robot), solver)


def _reached(module: ParallelModule, native: Native, count: int) -> FloatArray:
    """Poses of the platform that all legs reach, whatever their limits."""

    def keeps(poses: FloatArray) -> NDArray[np.bool_]:
        rows = native.batch(poses)[0]
        unreached = np.isnan(rows).reshape(*rows.shape[:2], -1).all(axis=-1)
        return np.asarray(~unreached.any(axis=-1))

    return reached(module, keeps, count, seed=1)


def _ask(
    module: ParallelModule, native: Native, trials: dict[str, Trial], poses: FloatArray
) -> Random:
    """What all legs answer at poses of the platform."""
    tally = Tally(RESIDUAL)
    for number, T in enumerate(poses):
        for leg, of_leg in zip(module.legs, native.ik(T)[1], strict=True):
            trial, dof = trials[leg.solver.name], leg.solver.chain.dof
            rows = of_leg[~np.isnan(of_leg[:, :dof]).any(axis=1), :dof]
            pose = np.linalg.inv(square(leg.leg.base)) @ T @ square(leg.leg.end)
            where = f"leg at {pose[:3, 3].tolist()}"
            tally.add(trial, pose, rows, np.zeros(dof), number, where)
    return tally.counted()
