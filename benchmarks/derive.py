"""How long dhgen takes to derive: CPU time after imports, and the search's size.

    python -m benchmarks.derive [robots/x.yaml ...]

Each robot is derived five times in one process; the least and the median count, since the machine
may be shared. `lower` is what follows: from the derivation to the program.
"""

from __future__ import annotations

import statistics
import sys
import time
from pathlib import Path

from dhgen.errors import UnsolvedError
from dhgen.kinematics.build import build_chain
from dhgen.paul.derivation import derive
from dhgen.program.lower import lower
from dhgen.robot.load import load

ROUNDS = 5


def main(arguments: list[str]) -> None:
    """Prints one line a robot."""
    paths = [Path(argument) for argument in arguments] or sorted(Path("robots").glob("*.yaml"))
    print(f"{'robot':24s} {'derive, least':>14s} {'median':>8s} {'lower':>8s}  branches  types")
    for path in paths:
        print(_line(path))


def _line(path: Path) -> str:
    derived, lowered = [], []
    robot = load(path)
    try:
        for _ in range(ROUNDS):
            start = time.process_time()
            derivation = derive(build_chain(robot))
            middle = time.process_time()
            lower(derivation)
            derived.append(middle - start)
            lowered.append(time.process_time() - middle)
    except UnsolvedError as error:
        return f"{robot.name:24s} not solved: {str(error).splitlines()[0]}"
    types = " ".join(str(step.kind.value) for step in derivation.steps)
    return (
        f"{robot.name:24s} {min(derived):12.2f} s {statistics.median(derived):6.2f} s "
        f"{min(lowered):6.2f} s  {derivation.branches:8d}  {types}"
    )


if __name__ == "__main__":
    main(sys.argv[1:])
