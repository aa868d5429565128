"""The words of the command line: options, files and what help says."""

from __future__ import annotations

import argparse
from functools import partial
from pathlib import Path

from dhgen import __version__
from dhgen.robot.source import quoted

OUT = Path("generated")
MOST_POSES = 100_000  # of one arm: the search takes up to an hour, and all are in memory at once
MOST_RECALLED = 10_000_000  # of one arm: minutes where a pose takes microseconds

EPILOG = """\
verbs:
  dhgen FILE ...           derive, show a summary, verify, and write generated/ (or --out DIR)
  dhgen --check FILE ...   compare generated/ with what the compiler makes; exit 1 when it is stale
  dhgen --numerical FILE   fall back to the numerical solver where nothing else works
  dhgen --single-file FILE write C and Python that hold what they need of the runtime
  dhgen explain FILE       print the whole derivation (--alternatives: all valid steps, by number)
  dhgen survey PATH ...    test many arms: are all solutions found? (--poses, --recall)
  dhgen --version          print the version

exit codes: 0 done, 1 stale or not solved, 2 a mistake in a file or on the command line,
130 interrupted
"""


def parser() -> argparse.ArgumentParser:
    """Of the command without a verb."""
    made = argparse.ArgumentParser(
        prog="dhgen",
        description="Exact inverse kinematics from Denavit-Hartenberg tables, as Python and C.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    made.add_argument("files", nargs="+", type=_path, metavar="FILE", help="robot files (YAML)")
    made.add_argument("--check", action="store_true", help="only compare, write nothing")
    made.add_argument(
        "--out",
        type=_path,
        default=OUT,
        metavar="DIR",
        help="where to write, or with --check what to compare (default: generated)",
    )
    _add_numerical(made)
    made.add_argument(
        "--single-file",
        action="store_true",
        help="write C and Python that hold what they need of the runtime, in place of its folders",
    )
    made.add_argument(
        "--version", action="version", version=f"dhgen {__version__}", help="print the version"
    )
    return made


def _add_numerical(made: argparse.ArgumentParser) -> None:
    made.add_argument(
        "--numerical",
        action="store_true",
        help="fall back to the numerical solver where nothing else works, like `numerical: true` "
        "in a robot file",
    )


def explain_parser() -> argparse.ArgumentParser:
    """Of `dhgen explain`."""
    made = argparse.ArgumentParser(
        prog="dhgen explain", description="Prints the derivation of a robot in the terminal."
    )
    made.add_argument("file", type=_path, metavar="FILE", help="a robot file (YAML)")
    made.add_argument(
        "--alternatives",
        action="store_true",
        help="print the valid equations of each step, by the numbers that `steps:` in a robot file "
        "takes",
    )
    made.add_argument("--program", action="store_true", help="print the emitted program")
    _add_numerical(made)
    return made


def survey_parser() -> argparse.ArgumentParser:
    """Of `dhgen survey`."""
    made = argparse.ArgumentParser(
        prog="dhgen survey",
        description="Tests the solvers of many arms: on random poses against an independent "
        "search for all solutions, and for an answer on every singular pose. "
        "Exit code 1 when an arm falls short or is not solved, 2 when a file has mistakes.",
    )
    made.add_argument(
        "paths",
        nargs="+",
        type=_path,
        metavar="PATH",
        help="robot files, folders of them, or JSON lists of tables",
    )
    made.add_argument(
        "--poses",
        type=partial(_count, least=1, most=MOST_POSES),
        default=200,
        metavar="N",
        help="random poses per arm, and a quarter as many of each singular kind "
        f"(default: 200, at most {MOST_POSES})",
    )
    made.add_argument(
        "--recall",
        type=partial(_count, least=0, most=MOST_RECALLED),
        default=20_000,
        metavar="N",
        help="random poses per arm on which only the joint values that made them are looked for "
        f"(default: 20000, at most {MOST_RECALLED})",
    )
    return made


def _path(word: str) -> Path:
    if not word:  # of which Path makes the folder one is in
        raise argparse.ArgumentTypeError("a path can't be empty")
    return Path(word)


def _count(word: str, least: int, most: int) -> int:
    if not word.isdecimal() or len(word) > len(str(most)) or not least <= int(word) <= most:
        wanted = f"must be a whole number from {least} to {most}"
        raise argparse.ArgumentTypeError(f"{wanted}, not {quoted(word)}")
    return int(word)
