"""Two folders of generated files against each other: are answers the same, and as fast?

    python -m benchmarks.compare OLD_FOLDER NEW_FOLDER ROBOT ... [--time] [--python]

Both are asked for the same poses: random ones, joints at multiples of a quarter turn (all of them,
or some), one joint 1e-13 to 1e-7 beside these, where the Jacobian loses rank and nearly, joints on
limits, out of reach, rounded to six digits, invalid; without a seed, with a random one, with the
joint values that made the pose. A line for every kind of call that differs says in how many calls
a bit, a status or what is returned differs, in how many the sets of solutions do (rows within
--tolerance, whole turns apart), and by how much values differ at most. Exit code 1 if anything
differs. The C is compared, in single precision, too, where both folders have it; with --python the
modules, with numba and without. --time shows ratios of CPU time instead, new to old.
"""

from __future__ import annotations

import argparse
import shlex
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from benchmarks.arms import robot_path
from benchmarks.compare import modules
from benchmarks.compare.answers import Difference, ask, differences, fewer, questions
from benchmarks.compare.libraries import Library, Shape, build, shape_of
from benchmarks.compare.timing import c_times, python_times, summary
from benchmarks.report import table
from dhgen.robot.load import load
from dhgen.robot.robot import JointKind

if TYPE_CHECKING:
    from collections.abc import Iterator

    from dhgen.robot.robot import Robot

SAME = "-O2 -ffp-contract=off"
FAST = "-O3 -march=native -fno-math-errno -fno-trapping-math -ffp-contract=fast"
HEAD = ("", "poses", "call", "calls", "differ", "in status", "in sets", "by at most")
TIMED = ("", "call", "old", "new", "new / old")
PLAIN_POSES = 25  # of every kind: without numba a pose takes milliseconds


def main(arguments: list[str]) -> int:
    """Prints what differs, or the ratios of times; the exit code."""
    chosen = _parser().parse_args(arguments)
    chosen.old, chosen.new = chosen.old.resolve(), chosen.new.resolve()
    chosen.flags = chosen.flags or (FAST if chosen.time else SAME)
    different = False
    for name in chosen.robots:
        robot = load(robot_path(name))
        with tempfile.TemporaryDirectory(prefix="dhgen-compare-") as folder:
            if chosen.time:
                rows = list(_times(robot, chosen, Path(folder)))
                print(f"\n{table(TIMED, rows)}", flush=True)
            else:
                different |= _report(list(_compare(robot, chosen, Path(folder))))
    return int(different)


def _parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(
        prog="python -m benchmarks.compare",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    made.add_argument("old", type=Path, metavar="OLD_FOLDER")
    made.add_argument("new", type=Path, metavar="NEW_FOLDER")
    made.add_argument("robots", nargs="+", metavar="ROBOT")
    made.add_argument("--time", action="store_true", help="ratios of CPU time")
    made.add_argument("--python", action="store_true", help="the modules instead of the C")
    made.add_argument("--poses", type=int, default=5000, help="of most kinds (5000)")
    made.add_argument("--tolerance", type=float, default=1e-6, help="of equal solutions (1e-6)")
    made.add_argument("--flags", help=f"for the C compiler ({SAME}; with --time {FAST})")
    made.add_argument("--new-flags", default="", help="more of them, for the new folder only")
    made.add_argument("--processes", type=int, default=10, help="that measure times (10)")
    made.add_argument("--rounds", type=int, default=20, help="of turns in each of them (20)")
    return made


def _compare(
    robot: Robot, chosen: argparse.Namespace, work: Path
) -> Iterator[tuple[str, Difference]]:
    """What differs, with what was called: the C, or a module."""
    turning = np.array([joint.kind is JointKind.REVOLUTE for joint in robot.joints])
    shapes = [shape_of(robot, chosen.old)]
    single = all((each / f"{robot.name}_f32.c").exists() for each in (chosen.old, chosen.new))
    if single and not chosen.python:
        shapes.append(shape_of(robot, chosen.old, single=True))
    for shape in shapes:
        old, new = (Library(shape, each) for each in _libraries(shape, chosen, work))
        asked = questions(robot, old, chosen.poses)
        if not chosen.python:
            for each in asked:
                answers = ask(old, each), ask(new, each)
                for found in differences(each.kind, *answers, turning, chosen.tolerance):
                    yield f"{shape.name}.c", found
            continue
        for way, numba in ((f"{shape.name}.py", True), (f"{shape.name}.py, no numba", False)):
            some = asked if numba else fewer(asked, PLAIN_POSES)
            both = [
                modules.answers(folder, shape.name, some, work, numba=numba)
                for folder in (chosen.old, chosen.new)
            ]
            for each in some:
                answers = both[0][each.kind], both[1][each.kind]
                for found in differences(each.kind, *answers, turning, chosen.tolerance):
                    yield way, found


def _times(
    robot: Robot, chosen: argparse.Namespace, work: Path
) -> Iterator[tuple[str, str, str, str, str]]:
    """Lines of times: random poses, and where joints are at multiples of a quarter turn."""
    shape = shape_of(robot, chosen.old)
    libraries = _libraries(shape, chosen, work)
    for each in questions(robot, Library(shape, libraries[0]), chosen.poses)[:2]:
        few = fewer([each], 2000)[0]
        often = chosen.processes, chosen.rounds
        if chosen.python:
            times = python_times((chosen.old, chosen.new), robot.name, few, work, *often)
        else:
            times = c_times(shape, libraries, few, work, *often)
        for line in summary(times):
            yield (f"{robot.name}, {each.kind}", *line)


def _libraries(shape: Shape, chosen: argparse.Namespace, work: Path) -> tuple[Path, Path]:
    old, new = work / f"{shape.name}-old.so", work / f"{shape.name}-new.so"
    flags = shlex.split(chosen.flags)
    build(shape, chosen.old, flags, old)
    build(shape, chosen.new, [*flags, *shlex.split(chosen.new_flags)], new)
    return old, new


def _report(found: list[tuple[str, Difference]]) -> bool:
    """Prints how much differs; whether anything does."""
    for what in dict.fromkeys(what for what, _ in found):
        mine = [each for of, each in found if of == what]
        calls, differ = sum(each.calls for each in mine), sum(each.differ for each in mine)
        sets = sum(each.sets or 0 for each in mine)
        print(f"{what}: {differ} of {calls} calls differ, {sets} in sets", flush=True)
    rows = [
        (what, each.kind, each.call, *_counts(each), f"{each.worst:.1e}")
        for what, each in found
        if each.differ
    ]
    if rows:
        print(f"\n{table(HEAD, rows)}\n", flush=True)
    return bool(rows)


def _counts(each: Difference) -> tuple[str, ...]:
    sets = "" if each.sets is None else str(each.sets)
    return str(each.calls), str(each.differ), str(each.statuses), sets


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
