"""How long a derivation takes, from the command to the file: CPU time of a whole process.

    python -m benchmarks.explain [--arms NAME ...] [--write]

Each format of each arm is printed three times, by a process of its own that finds Python's own
code compiled; the least counts, since the machine may be shared. `--write` puts the table
into docs/benchmarks.md.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
from pathlib import Path

from benchmarks.arms import robot_path
from benchmarks.options import parser, show
from benchmarks.report import table
from dhgen.arguments import FORMATS

ROUNDS = 3
ARMS = ("scara", "ur5", "kuka_kr6_r900", "franka_panda", "xarm6")


def main(arguments: list[str]) -> None:
    """Prints one line an arm."""
    options = parser("benchmarks.explain", __doc__, ARMS).parse_args(arguments)
    rows = []
    for name in options.arms:
        rows.append((name, *(f"{explained(name, each):.2f} s" for each in FORMATS)))
        print(*rows[-1], flush=True)
    show(table(("arm", *FORMATS), rows), "explain", write=options.write)


def explained(name: str, wished: str) -> float:
    """CPU time of `dhgen explain` [s]."""
    with tempfile.TemporaryDirectory() as folder:
        out = str(Path(folder) / "derivation")
        command = "-m", "dhgen", "explain", str(robot_path(name)), "--format", wished
        return least(*command, "--out", out)


def least(*command: str) -> float:
    """The least CPU time of a few processes of Python [s].

    Raises:
        subprocess.CalledProcessError: One failed.
    """
    taken = []
    for _ in range(ROUNDS):
        before = os.times()
        subprocess.run([sys.executable, *command], check=True, capture_output=True)
        after = os.times()
        user = after.children_user - before.children_user
        taken.append(user + after.children_system - before.children_system)
    return min(taken)


if __name__ == "__main__":
    main(sys.argv[1:])
