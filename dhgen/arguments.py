"""The words of the command line: options, files and the text of help."""

from __future__ import annotations

import argparse
import re
from functools import partial
from pathlib import Path

from dhgen import __version__
from dhgen.descriptions.snap import DEFAULT, MOST, NEGLIGIBLE
from dhgen.robot.source import quoted
from dhgen.robot.task import ARM_ANGLE

OUT = Path("generated")
FORMATS = ("text", "markdown", "latex", "html")  # of derivations
HTML = dict.fromkeys((".html", ".htm"), "html")
ENDINGS = {"": "text", ".txt": "text", ".md": "markdown", ".tex": "latex"} | HTML
LANGUAGES = ("en", "fr")  # of derivations
MOST_POSES = 100_000  # of one arm: the search takes up to an hour, and all are in memory at once
MOST_RECALLED = 10_000_000  # of one arm: minutes where a pose takes microseconds

EPILOG = """\
verbs:
  dhgen import ARM.urdf    write a robot file with a Denavit-Hartenberg table (--base, --tip)
  dhgen calibrate FILE --from CALIBRATION
                           write the robot file of one arm, with what was measured of it
  dhgen FILE ...           derive, show a summary, verify, and write generated/ (or --out DIR)
  dhgen --check FILE ...   compare generated/ with what the compiler makes; exit 1 when it is stale
  dhgen --numerical FILE   fall back to the numerical solver where nothing else works
  dhgen --single-file FILE write C and Python that hold what they need of the runtime
  dhgen explain FILE       print the whole derivation (--alternatives: all valid steps, by number;
                           --format latex, html, markdown: as a handout, --out FILE;
                           --language fr: in French)
  dhgen survey PATH ...    test many arms: are all solutions found? (--poses, --recall)
  dhgen --version          print the version

exit codes: 0 done, 1 stale or not solved, 2 a mistake in a file or on the command line,
130 interrupted
"""


def parser() -> argparse.ArgumentParser:
    """Of the command without a verb."""
    made = argparse.ArgumentParser(
        prog="dhgen",
        description="Exact inverse kinematics from Denavit-Hartenberg tables and URDF, as Python "
        "and C.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    made.add_argument(
        "files", nargs="+", type=_path, metavar="FILE", help="robot files (YAML), or URDF"
    )
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


def _add_axes(made: argparse.ArgumentParser) -> None:
    made.add_argument(
        "--axes", action="store_true", help="write axes in the reference position, not a table"
    )


def explain_parser() -> argparse.ArgumentParser:
    """Of `dhgen explain`."""
    made = argparse.ArgumentParser(
        prog="dhgen explain",
        description="Prints the derivation of a robot, in the terminal or as a handout.",
    )
    made.add_argument("file", type=_path, metavar="FILE", help="a robot file (YAML), or URDF")
    made.add_argument(
        "--format",
        choices=FORMATS,
        help="how: as text for a terminal, as Markdown for GitHub, as a LaTeX document with "
        "drawings of its own, or as one HTML file that needs no network (the last wants "
        "pip install 'dhgen[html]'); by default what the ending of --out says (.md, .tex, .html), "
        "else text",
    )
    made.add_argument(
        "--language",
        choices=LANGUAGES,
        default=LANGUAGES[0],
        help="of the derivation: English (default), or French with decimal commas; what the robot "
        "file says, such as its title, and the names of rows stay as they are",
    )
    made.add_argument(
        "--out",
        type=_path,
        metavar="FILE",
        help="write it to a file; figures of Markdown are written beside it, in figures/",
    )
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


def import_parser() -> argparse.ArgumentParser:
    """Of `dhgen import`."""
    made = argparse.ArgumentParser(
        prog="dhgen import",
        description="Writes the robot file of an arm in a URDF: a Denavit-Hartenberg table with "
        "named lengths, derived from its axes, compared with the URDF's own forward kinematics.",
    )
    made.add_argument(
        "file", type=_path, metavar="FILE", help="a robot description: URDF, xacro, MJCF"
    )
    made.add_argument(
        "--base",
        metavar="LINK",
        help="the link that poses are in (default: before the first joint)",
    )
    made.add_argument(
        "--tip", metavar="LINK", help="the link that poses are of (default: the longest arm's end)"
    )
    made.add_argument(
        "--snap",
        type=_tolerance,
        metavar="TOL",
        help="take as exact what is nearer than this to a multiple of 15 degrees [rad], or to zero "
        f"[arm sizes] (default: {DEFAULT:g} and {NEGLIGIBLE:g}; 1.57 needs 1e-3)",
    )
    _add_axes(made)
    made.add_argument(
        "--free",
        type=_joints,
        metavar="JOINTS",
        help="the joints, from 1, whose values the caller gives: 7, or 1,7, or none, or arm_angle "
        "(default: as many as there are above six, where that leaves the most structure)",
    )
    made.add_argument(
        "--package",
        type=partial(_pair, mark="="),
        action="append",
        default=[],
        metavar="NAME=DIR",
        help="of a xacro: where a ROS package is that is not above the file",
    )
    made.add_argument(
        "--arg",
        type=partial(_pair, mark=":="),
        action="append",
        default=[],
        metavar="NAME:=VALUE",
        help="of a xacro: the value of an argument; a note tells if it asks for no such one",
    )
    made.add_argument(
        "--out",
        type=_path,
        metavar="FILE",
        help="where to write, - for the terminal (default: the robot's name with .yaml)",
    )
    return made


def calibrate_parser() -> argparse.ArgumentParser:
    """Of `dhgen calibrate`."""
    made = argparse.ArgumentParser(
        prog="dhgen calibrate",
        description="Writes the robot file of one arm: that of its kind, with what was measured of "
        "this one. A calibration holds `kinematics:`, of each joint x, y, z [m], roll, pitch and "
        "yaw [rad] of its frame in the one before, as Universal Robots' driver extracts them; or "
        "`deltas:`, a list of what is added to theta, d, a, alpha of each row of the table, with "
        "beta, a turn about y behind a and alpha, for axes that are nearly parallel.",
    )
    made.add_argument("file", type=_path, metavar="FILE", help="the robot file of the arm's kind")
    made.add_argument(
        "--from",
        dest="calibration",
        type=_path,
        required=True,
        metavar="CALIBRATION",
        help="the calibration (YAML)",
    )
    _add_axes(made)
    made.add_argument(
        "--out",
        type=_path,
        metavar="FILE",
        help="where to write, - for the terminal (default: NAME_calibrated.yaml); the arm is "
        "called as the file is, without its ending",
    )
    return made


def _pair(word: str, mark: str) -> tuple[str, str]:
    name, found, value = word.partition(mark)
    if not name or not found:
        raise argparse.ArgumentTypeError(f"write NAME{mark}VALUE, not {quoted(word)}")
    return name, value


def _joints(word: str) -> tuple[int, ...] | str:
    if word in {"none", ARM_ANGLE}:
        return () if word == "none" else word
    numbers = word.split(",")
    if not all(re.fullmatch("[0-9]{1,2}", number) for number in numbers):
        raise argparse.ArgumentTypeError(f"write numbers of joints, 7 or 1,7, not {quoted(word)}")
    return tuple(map(int, numbers))


def _tolerance(word: str) -> float:
    try:
        value = float(word)
    except ValueError:
        value = -1.0
    if not 0.0 <= value <= MOST:
        raise argparse.ArgumentTypeError(f"must be a number from 0 to {MOST:g}, not {quoted(word)}")
    return value


def _path(word: str) -> Path:
    if not word:  # of which Path makes the folder one is in
        raise argparse.ArgumentTypeError("a path can't be empty")
    return Path(word)


def _count(word: str, least: int, most: int) -> int:
    if not word.isdecimal() or len(word) > len(str(most)) or not least <= int(word) <= most:
        wanted = f"must be a whole number from {least} to {most}"
        raise argparse.ArgumentTypeError(f"{wanted}, not {quoted(word)}")
    return int(word)
