"""The Python of a folder, called in a process of its own.

    python -m benchmarks.compare.modules FOLDER NAME QUESTIONS.npz ANSWERS.npz [TURNS]

Two folders have modules of one name, and may each have a runtime of their own: they can't be in one
process. Questions come and answers go in files; with TURNS the calls are timed that many times
instead. Without numba where NUMBA_DISABLE_JIT is 1.
"""

from __future__ import annotations

import importlib
import os
import subprocess
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from benchmarks.arms import CHECKOUT
from benchmarks.compare.answers import Question, ask

if TYPE_CHECKING:
    from collections.abc import Callable
    from types import ModuleType

    from numpy.typing import NDArray

    from benchmarks.compare.libraries import Answer
    from dhgen.arrays import FloatArray

FIELDS = ("q", "T", "given", "seeds")
SEPARATOR = "|"  # between what an array is and what it is of
TIMED = 512  # poses
BATCH = 4096


class Module:
    """A module's functions; arrays of N poses go in and come out."""

    def __init__(self, module: ModuleType) -> None:
        self._module: Any = module
        self._given = hasattr(module, "arm_angle") or bool(getattr(module, "FREE_JOINTS", ()))

    def fk(self, q: FloatArray) -> NDArray[Any]:
        """Poses (N, 4, 4) of joint values (N, n)."""
        return np.array([self._module.fk(each) for each in q])

    def jacobian(self, q: FloatArray) -> NDArray[Any]:
        """Jacobians (N, 6, n) of joint values (N, n)."""
        return np.array([self._module.jacobian(each) for each in q])

    def ik(self, T: FloatArray, given: FloatArray, seed: FloatArray | None) -> Answer:
        """All rows of poses (N, 4, 4); statuses and, last, how many are solutions."""
        size = (len(T), self._module.MAX_SOLUTIONS)
        q, status = np.full((*size, self._module.DOF), np.nan), np.zeros(size, np.uint8)
        returned = np.zeros(len(T), np.int64)
        for k, pose in enumerate(T):
            inputs = self._inputs(pose, given[k])
            seeded = () if seed is None else (seed[k],)
            returned[k] = self._module.ik_into(*inputs, q[k], status[k], *seeded)
        return q, np.column_stack([status, returned])

    def nearest(self, T: FloatArray, given: FloatArray, seed: FloatArray) -> Answer:
        """What `ik` returns, and whether it raises something instead."""
        q, refused = np.full((len(T), self._module.DOF), np.nan), np.zeros(len(T), np.int64)
        for k, pose in enumerate(T):
            try:
                q[k] = self._module.ik(*self._inputs(pose, given[k]), q_seed=seed[k])
            except self._module.Unreachable:
                refused[k] = 1
            except ValueError:  # not a valid pose
                refused[k] = 2
        return q, refused[:, None]

    def batch(self, T: FloatArray, given: FloatArray) -> Answer:
        """All rows of poses (N, 4, 4), and statuses."""
        q, status = self._module.ik_batch(*self._inputs(T, given), cores=1)
        return q, status.astype(np.int64)

    def nanoseconds(self, question: Question, turns: int) -> dict[str, float]:
        """CPU time of a pose by every kind of call, the median of so many turns."""
        T, given, seeds = question.T[:TIMED], question.given[:TIMED], question.seeds[:TIMED]
        many = -(-BATCH // len(question.T))
        large = tuple(
            np.concatenate([each] * many)[:BATCH] for each in (question.T, question.given)
        )
        size = (self._module.MAX_SOLUTIONS, self._module.DOF)
        q, status = np.empty(size), np.empty(size[0], np.uint8)
        out = np.empty((BATCH, *size)), np.empty((BATCH, size[0]), np.uint8)
        inputs = [self._inputs(pose, value) for pose, value in zip(T, given, strict=True)]

        def into() -> None:
            for each in inputs:
                self._module.ik_into(*each, q, status)

        def seeded() -> None:
            for each, seed in zip(inputs, seeds, strict=True):
                self._module.ik_into(*each, q, status, seed)

        def every() -> None:
            for each in inputs:
                self._module.ik_all(*each)

        def batch() -> None:
            self._module.ik_batch(*self._inputs(*large), cores=1, out=out)

        calls = {"ik_into": into, "ik_into, seeded": seeded, "ik_all": every, "ik_batch": batch}
        poses = dict.fromkeys(calls, len(inputs)) | {"ik_batch": BATCH}
        return {name: _median(call, turns) / poses[name] for name, call in calls.items()}

    def _inputs(self, T: FloatArray, given: FloatArray) -> tuple[FloatArray, ...]:
        return (T, given) if self._given else (T,)


def answers(
    folder: Path, name: str, asked: list[Question], work: Path, *, numba: bool
) -> dict[str, dict[str, Answer]]:
    """What a folder's module answers, by the kind of poses and what was called."""
    made = _run(folder, name, asked, work, numba=numba)
    found: dict[str, dict[str, Answer]] = {}
    for key in made.files:
        kind, call, part = key.split(SEPARATOR)
        if part == "values":
            states = made[SEPARATOR.join((kind, call, "states"))]
            found.setdefault(kind, {})[call] = (made[key], states)
    return found


def nanoseconds(
    folder: Path, name: str, asked: Question, work: Path, turns: int
) -> dict[str, float]:
    """CPU time of a pose by every kind of call, in a fresh process."""
    made = _run(folder, name, [asked], work, str(turns), numba=True)
    return {call: float(made[call]) for call in made.files}


def _run(
    folder: Path, name: str, asked: list[Question], work: Path, *more: str, numba: bool
) -> Any:  # noqa: ANN401 - numpy has no public type for what load returns
    question, answer = work / "questions.npz", work / "answers.npz"
    arrays = {
        SEPARATOR.join((each.kind, field)): getattr(each, field)
        for each in asked
        for field in FIELDS
    }
    np.savez(question, **arrays)
    command = [sys.executable, "-m", __spec__.name, str(folder), name, str(question), str(answer)]
    settings = {"NUMBA_DISABLE_JIT": "0" if numba else "1", "NUMBA_NUM_THREADS": "1"}
    path = os.pathsep.join(filter(None, (str(CHECKOUT), os.environ.get("PYTHONPATH"))))
    environment = os.environ | settings | {"PYTHONPATH": path}
    subprocess.run([*command, *more], env=environment, check=True)
    return np.load(answer)


def _median(call: Callable[[], None], turns: int) -> float:
    call()
    taken = []
    for _ in range(turns):
        start = time.process_time_ns()
        call()
        taken.append(time.process_time_ns() - start)
    return float(np.median(taken))


def main(folder: str, name: str, questions: str, answer: str, turns: str = "") -> None:
    """Answers the questions of a file into another."""
    sys.path.insert(0, folder)
    module = importlib.import_module(name)
    assert Path(str(module.__file__)).parent == Path(folder).resolve(), module.__file__
    solver, asked = Module(module), np.load(questions)
    made: dict[str, Any] = {}
    for kind in dict.fromkeys(key.split(SEPARATOR)[0] for key in asked.files):
        question = Question(kind, *(asked[SEPARATOR.join((kind, field))] for field in FIELDS))
        if turns:
            made |= solver.nanoseconds(question, int(turns))
            continue
        for call, (values, states) in ask(solver, question).items():
            made[SEPARATOR.join((kind, call, "values"))] = values
            made[SEPARATOR.join((kind, call, "states"))] = states
    np.savez(answer, **made)


if __name__ == "__main__":
    main(*sys.argv[1:])
