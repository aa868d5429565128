"""The command line: `dhgen robots/scara.yaml`, `dhgen --check robots/*.yaml`, `dhgen explain`."""

from __future__ import annotations

import argparse
import difflib
import io
import os
import sys
import tempfile
from dataclasses import replace
from importlib import metadata
from pathlib import Path
from typing import TYPE_CHECKING

from dhgen.errors import CommandError, DhgenError, VerificationError, about
from dhgen.method import Method

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from dhgen.compiler import Compilation
    from dhgen.errors import Diagnostic
    from dhgen.robot_files import RobotFile, RobotFiles
    from dhgen.targets.module import SolverModule

FAULT = """\
{whose}; nothing was written
please report it, with the robot file"""
WHOSE = "this is a bug in dhgen, not a mistake in the file"
WHOSE_NOTED = "a note above may say why; if not, this is a bug in dhgen"

OUT = Path("generated")

# What the first word may be meant as where it is no file.
MEANT = {
    **{verb: f"dhgen {verb}" for verb in ("explain", "survey")},
    **{option: f"dhgen --{option}" for option in ("check", "numerical", "help", "version")},
}

EPILOG = """\
verbs:
  dhgen FILE ...           derive, show a summary, verify, and write generated/ (or --out DIR)
  dhgen --check FILE ...   compare generated/ with what the compiler makes; exit 1 when it is stale
  dhgen --numerical FILE   fall back to the numerical solver where nothing else works
  dhgen explain FILE       print the whole derivation (--alternatives: other valid steps)
  dhgen survey PATH ...    test many arms: are all solutions found? (--poses N)
  dhgen --version          print the version

exit codes: 0 done, 1 stale or not solved, 2 a mistake in a file or on the command line
"""


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command; returns the exit code."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    _open_closed()
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # a terminal that can't show a letter shows ?
            stream.reconfigure(errors="replace")
    try:
        if words[:1] == ["explain"]:
            return _explain(_explain_parser().parse_args(words[1:]))
        if words[:1] == ["survey"]:
            return _survey(_survey_parser().parse_args(words[1:]))
        options = _parser().parse_args(words)
        _refuse_misspelt(options.files[0])
        if not options.check:
            _refuse_unwritable(options.out)
        return _check(options) if options.check else _write(options)
    except DhgenError as error:
        print(error, file=sys.stderr)
        return error.exit_code
    except BrokenPipeError:  # the reader of our output has seen enough
        sys.stderr.close()
        return 0
    except OSError as error:
        print(f"dhgen: {error.strerror or error}: {error.filename or 'output'}", file=sys.stderr)
        return 1


def _open_closed() -> None:
    """Gives the streams that the caller has closed back: what is written there is lost.

    In the order of their numbers: each gets its own, which the next file would get else.
    """
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, mode, encoding="utf-8"))  # noqa: PTH123, SIM115


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="dhgen",
        description="Exact inverse kinematics from Denavit-Hartenberg tables, as Python and C.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("files", nargs="+", type=_path, metavar="FILE", help="robot files (YAML)")
    parser.add_argument("--check", action="store_true", help="only compare, write nothing")
    parser.add_argument(
        "--out",
        type=_path,
        default=OUT,
        metavar="DIR",
        help="where to write, or with --check what to compare (default: generated)",
    )
    _add_numerical(parser)
    parser.add_argument(
        "--version", action="version", version=f"dhgen {_version()}", help="print the version"
    )
    return parser


def _version() -> str:
    try:
        return metadata.version("dhgen")
    except metadata.PackageNotFoundError:  # a checkout
        return "(not installed)"


def _refuse_mute() -> None:
    """Stops where standard output was closed, for commands that do nothing but print."""
    if sys.__stdout__ is None:
        raise CommandError("dhgen: standard output is closed: there is nothing to print to")


def _refuse_misspelt(first: Path) -> None:
    """Stops where the first word is no file but reads like a verb or an option."""
    close = difflib.get_close_matches(str(first), MEANT, n=1)
    if close and not first.exists():
        raise CommandError(f"dhgen: no file '{first}'; did you mean '{MEANT[close[0]]}'?")


def _refuse_unwritable(out: Path) -> None:
    """Tries whether files can be written to a folder, before seconds of work; leaves no trace."""
    present = next(folder for folder in (out, *out.absolute().parents) if os.path.lexists(folder))
    try:
        with tempfile.TemporaryFile(dir=present):
            pass
    except OSError as error:
        reason = f"{present}: {error.strerror}"
        raise CommandError(f"dhgen: can't write to the folder {out} ({reason})") from None


def _refuse_occupied(paths: Sequence[Path]) -> None:
    """Stops before anything is written, where something that is there can't be written over."""
    for path in paths:
        if path.is_dir():
            raise CommandError(f"dhgen: can't write {path}: it is a folder")
        if path.exists() and not os.access(path, os.W_OK):
            raise CommandError(f"dhgen: can't write {path}: the file is read-only")


def _add_numerical(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--numerical",
        action="store_true",
        help="fall back to the numerical solver where nothing else works, like `numerical: true` "
        "in a robot file",
    )


def _explain_parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="dhgen explain", description="Prints the derivation of a robot in the terminal."
    )
    parser.add_argument("file", type=_path, metavar="FILE", help="a robot file (YAML)")
    parser.add_argument(
        "--alternatives", action="store_true", help="print the other valid equations of each step"
    )
    parser.add_argument("--program", action="store_true", help="print the emitted program")
    _add_numerical(parser)
    return parser


def _survey_parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="dhgen survey",
        description="Tests the solvers of many arms: on random poses against an independent "
        "search for all solutions, and for an answer on every singular pose. "
        "Exit code 1 when an arm falls short or is not solved, 2 when a file has mistakes.",
    )
    parser.add_argument(
        "paths",
        nargs="+",
        type=_path,
        metavar="PATH",
        help="robot files, folders of them, or JSON lists of tables",
    )
    parser.add_argument(
        "--poses",
        type=_positive,
        default=200,
        metavar="N",
        help="random poses per arm, and a quarter as many of each singular kind (default: 200)",
    )
    return parser


def _path(word: str) -> Path:
    if not word:  # of which Path makes the folder one is in
        raise argparse.ArgumentTypeError("a path can't be empty")
    return Path(word)


def _positive(word: str) -> int:
    if not word.isdecimal() or int(word) < 1:
        raise argparse.ArgumentTypeError(f"must be a whole number above zero, not '{word}'")
    return int(word)


def _tell(text: str) -> None:
    """Progress, for those who wait at a terminal."""
    if sys.stderr.isatty():
        print(f"  {text} ...", file=sys.stderr, flush=True)


def _compile(file: RobotFile, *, out: Path | None = None) -> Compilation:
    from dhgen.compiler import compile_loaded  # noqa: PLC0415 - errors and --help need no sympy

    _tell_notes(file.robot.notices)
    with about(file.path):
        return compile_loaded(file, _tell, out=out)


def _tell_notes(notices: Iterable[Diagnostic]) -> None:
    for notice in notices:
        print(f"note: {notice}", file=sys.stderr)


def _read(options: argparse.Namespace) -> tuple[RobotFiles, int]:
    """The files, those that are refused told, and the exit code for these."""
    from dhgen.robot_files import load_all  # noqa: PLC0415

    files = load_all(options.files)
    for refusal in files.refusals:
        print(refusal, file=sys.stderr)
    if options.numerical:
        files = replace(files, loaded=tuple(file.with_numerical() for file in files.loaded))
    return files, max((refusal.exit_code for refusal in files.refusals), default=0)


def _write(options: argparse.Namespace) -> int:
    files, worst = _read(options)
    left = [path for path in files.paths if path not in {file.path for file in files.loaded}]
    for file in files.loaded:
        try:
            _write_one(file, options)
        except DhgenError as error:
            print(error, file=sys.stderr)
            if isinstance(error, VerificationError):
                _tell_notes(file.robot.doubts)
                whose = WHOSE_NOTED if file.robot.notices + file.robot.doubts else WHOSE
                print(FAULT.format(whose=whose), file=sys.stderr)
            worst = max(worst, error.exit_code)
            left.append(file.path)
    if left and len(files.paths) > 1:  # the reasons may stand far above
        sys.stdout.flush()
        told = ", ".join(map(str, left))
        print(f"dhgen: nothing was written for {told}: see above", file=sys.stderr)
    return worst


def _write_one(file: RobotFile, options: argparse.Namespace) -> None:
    from dhgen.compiler import verified  # noqa: PLC0415
    from dhgen.targets.derivation import derivation_summary  # noqa: PLC0415

    compilation = _compile(file, out=options.out)
    module = compilation.module
    if options.numerical and module.method is not Method.NUMERICAL:
        print("note: --numerical was not needed", file=sys.stderr)
    print(f"{compilation.robot.name}: {compilation.robot.title}")
    print(derivation_summary(compilation.robot, compilation.derivation, module.solver))
    _refuse_occupied([options.out / name for name in compilation.files])
    report = verified(compilation, _tell)
    options.out.mkdir(parents=True, exist_ok=True)
    for name, text in compilation.files.items():
        (options.out / name).write_text(text, encoding="utf-8", newline="\n")
    compiled = _compared(module) if report.compiled else "no C compiler found: C not tested"
    print(
        f"verified on {report.poses} poses: {report.solutions} solutions, largest residual "
        f"{report.residual:.1e} arm sizes; {compiled}"
    )
    if report.single is not None:
        print(f"in single precision: largest residual {report.single:.1e} arm sizes")
    print(f"wrote {', '.join(str(options.out / name) for name in _own(compilation))}\n")


def _compared(module: SolverModule) -> str:
    if module.method is Method.NUMERICAL:
        return (
            "Python and C checked separately: which solution a start leads to depends on rounding"
        )
    return "Python and C agree"


def _own(compilation: Compilation) -> list[str]:
    stems = [compilation.robot.name, *([compilation.single.name] if compilation.single else [])]
    return [name for name in compilation.files if Path(name).stem in stems]


def _check(options: argparse.Namespace) -> int:
    from dhgen.check import compare  # noqa: PLC0415

    files, refused = _read(options)
    for file in files.loaded:
        _tell_notes(file.robot.notices)
    found = compare(files, options.out, _repeated(options))
    for told in (*found.refusals, *found.problems):
        print(told, file=sys.stderr)
    worst = max(refused, found.exit_code)
    if not worst:
        count = len(files.loaded)
        print(f"{options.out}: up to date with {count} robot file{'s' if count > 1 else ''}")
    return worst


def _repeated(options: argparse.Namespace) -> list[str]:
    """What of a command another one has to say, too, to make the same files in the same place."""
    place = [] if options.out == OUT else ["--out", str(options.out)]
    return place + ["--numerical"] * options.numerical


def _explain(options: argparse.Namespace) -> int:
    from dhgen.program.text import program_text  # noqa: PLC0415
    from dhgen.robot_files import RobotFile  # noqa: PLC0415
    from dhgen.targets.derivation import alternatives_text, derivation_terminal  # noqa: PLC0415

    file = RobotFile.read(options.file)
    _refuse_mute()
    compilation = _compile(file.with_numerical() if options.numerical else file)
    derivation, program = compilation.derivation, compilation.module.solver
    if options.alternatives:
        print(alternatives_text(derivation))
    elif options.program:
        print(program_text(program), end="")
    else:
        print(derivation_terminal(compilation.robot, derivation, program))
    return 0


def _survey(options: argparse.Namespace) -> int:
    _refuse_mute()
    # matrices are small and every core has its own arm: threads inside would be in the way
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    from dhgen.survey.survey import survey  # noqa: PLC0415
    from dhgen.survey.table import survey_text  # noqa: PLC0415

    lines = survey(options.paths, options.poses, _tell)
    for remark in (remark for line in lines for remark in line.remarks):
        print(remark, file=sys.stderr)
    print(survey_text(lines), end="")
    if any(line.mistaken for line in lines):
        return 2
    return 0 if all(line.complete for line in lines) else 1
