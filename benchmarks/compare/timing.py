"""Ratios of CPU time between two folders, in processes that each have fresh copies.

    python -m benchmarks.compare.timing ROUNDS COUNT QUESTION.npz SHAPE.json OLD.so NEW.so

A library's time depends on the physical pages it got: one library copied once was 14 % slower than
itself in every process. So every process copies both anew, at places moved by a file of random
length, and takes turns between them.
"""

from __future__ import annotations

import json
import os
import random
import shutil
import statistics
import subprocess
import sys
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from benchmarks.arms import CHECKOUT
from benchmarks.compare.libraries import Library, Shape
from benchmarks.compare.modules import nanoseconds
from benchmarks.memory import lined_up

if TYPE_CHECKING:
    from benchmarks.compare.answers import Question

    # what is called -> ns a pose, old and new, of every process
    Times = dict[str, list[tuple[float, float]]]

WAYS = {"one pose": False, "batch": True}
TURN = 0.01  # CPU seconds that a turn takes at least
PAGE = 4096


def c_times(
    shape: Shape,
    libraries: tuple[Path, Path],
    asked: Question,
    work: Path,
    processes: int,
    rounds: int,
) -> Times:
    """Of one pose and of a batch."""
    question = work / "timed.npz"
    np.savez(question, T=asked.T, given=asked.given)
    command = [sys.executable, "-m", __spec__.name, str(rounds), str(question)]
    path = os.pathsep.join(filter(None, (str(CHECKOUT), os.environ.get("PYTHONPATH"))))
    environment = os.environ | {"PYTHONPATH": path, "OPENBLAS_NUM_THREADS": "1"}
    times: Times = {way: [] for way in WAYS}
    for process in range(processes):
        places = [_fresh(library, work / f"fresh{process}") for library in libraries]
        arguments = [json.dumps(asdict(shape)), *map(str, places)]
        done = subprocess.run(
            [*command, *arguments], env=environment, capture_output=True, text=True, check=True
        )
        for way, pair in json.loads(done.stdout).items():
            times[way].append(tuple(pair))
        shutil.rmtree(work / f"fresh{process}")
    return times


def python_times(
    folders: tuple[Path, Path], name: str, asked: Question, work: Path, processes: int, rounds: int
) -> Times:
    """Of the modules with numba, each process one folder's, in alternation."""
    times: Times = {}
    for process in range(processes):
        order = (0, 1) if process % 2 == 0 else (1, 0)
        made = {k: nanoseconds(folders[k], name, asked, work, rounds) for k in order}
        for call, old in made[0].items():
            times.setdefault(call, []).append((old, made[1][call]))
    return times


def summary(times: Times) -> list[tuple[str, str, str, str]]:
    """For every call: old and new [ns], and the median of the ratios with their quartiles."""
    lines = []
    for call, pairs in times.items():
        old, new = (statistics.median(each) for each in zip(*pairs, strict=True))
        low, middle, high = np.quantile([new / old for old, new in pairs], [0.25, 0.5, 0.75])
        ratio = f"{middle:.3f} [{low:.3f} {high:.3f}]"
        lines.append((call, f"{old:.4g} ns", f"{new:.4g} ns", ratio))
    return lines


def _fresh(library: Path, folder: Path) -> Path:
    """A copy, on other pages."""
    folder.mkdir(exist_ok=True)
    padding = folder / f"{library.stem}.padding"
    padding.write_bytes(os.urandom(random.randrange(1, 64) * PAGE))  # noqa: S311
    return Path(shutil.copy(library, folder))


def main(rounds: str, question: str, shape: str, *libraries: str) -> None:
    """Prints ns a pose of every way, old and new: medians over rounds of turns in alternation."""
    asked, solvers = (
        np.load(question),
        [Library(Shape(**json.loads(shape)), Path(each)) for each in libraries],
    )
    T, given = lined_up(asked["T"]), lined_up(asked["given"])
    found = {}
    for way, batch in WAYS.items():
        once = max(solver.seconds(T, given, 1, batch=batch) for solver in solvers)
        repeats = max(1, round(TURN / max(once, 1e-9)))
        taken: list[list[float]] = [[] for _ in solvers]
        for turn in range(int(rounds)):
            for k in (0, 1) if turn % 2 == 0 else (1, 0):
                taken[k].append(solvers[k].seconds(T, given, repeats, batch=batch))
        found[way] = [1e9 * statistics.median(each) / (repeats * len(T)) for each in taken]
    json.dump(found, sys.stdout)


if __name__ == "__main__":
    main(*sys.argv[1:])
