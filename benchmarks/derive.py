"""How long dhgen takes to derive: CPU time after imports, and the search's size.

    python -m benchmarks.derive [--arms NAME ...] [--write]

Each arm is derived five times in one process, or as often as ten seconds allow; the least and the
median count, since the machine may be shared. `lower` is what follows: from the derivation to the
program. `method` has the types of the steps, 9 being the quartic, or says that the arm went to the
general 6R algorithm. `--write` puts the table into docs/benchmarks.md.
"""

from __future__ import annotations

import statistics
import sys
import time
from typing import TYPE_CHECKING

from benchmarks.arms import robot_path
from benchmarks.options import parser, show
from benchmarks.report import table
from dhgen.errors import UnsolvedError
from dhgen.kinematics.build import build_chain
from dhgen.paul.derive import derive
from dhgen.program.lowering.lower import lower
from dhgen.robot.load import load

if TYPE_CHECKING:
    from dhgen.paul.derivation import Derivation

ROUNDS = 5
ENOUGH = 10.0  # seconds for one arm
HEAD = ("arm", "derive, least", "median", "lower", "branches", "method")


def main(arguments: list[str]) -> None:
    """Prints one line an arm."""
    options = parser("benchmarks.derive", __doc__).parse_args(arguments)
    rows = []
    for name in options.arms:
        rows.append(measure(name))
        print(*rows[-1], flush=True)
    show(table(HEAD, rows), "derive", write=options.write)


def measure(name: str) -> tuple[str, ...]:
    """An arm's line."""
    derived: list[float] = []
    lowered: list[float] = []
    robot = load(robot_path(name))
    try:
        while len(derived) < ROUNDS and sum(derived) < ENOUGH:
            start = time.process_time()
            derivation = derive(build_chain(robot), numerical=robot.numerical)
            middle = time.process_time()
            lower(derivation)
            derived.append(middle - start)
            lowered.append(time.process_time() - middle)
    except UnsolvedError as error:
        reason = str(error).splitlines()[0]
        return name, "-", "-", "-", "-", f"not solved: {reason}"
    return (
        name,
        f"{min(derived):.2f} s",
        f"{statistics.median(derived):.2f} s",
        f"{min(lowered):.2f} s",
        str(derivation.branches),
        _method(derivation),
    )


def _method(derivation: Derivation) -> str:
    steps = [str(step.kind.value) for step in derivation.steps]
    return " ".join([*([derivation.whole.method] if derivation.whole else []), *steps])


if __name__ == "__main__":
    main(sys.argv[1:])
