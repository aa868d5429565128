"""The commands that read robot files: write, check, explain, survey.

What needs sympy is imported late, so that errors and --help come at once.
"""

from __future__ import annotations

import os
import sys
from dataclasses import replace
from shlex import quote
from typing import TYPE_CHECKING, TypeVar

from dhgen.arguments import ENDINGS, FORMATS, LANGUAGES, OUT
from dhgen.errors import CommandError, DhgenError, ImmobileError, VerificationError, about
from dhgen.method import Method
from dhgen.places_to_write import (
    print_replaced,
    refuse_mute,
    refuse_not_ours,
    refuse_occupied,
    refuse_taken,
    refuse_what_was_read,
)

if TYPE_CHECKING:
    import argparse
    from collections.abc import Callable, Iterable, Mapping
    from pathlib import Path

    from dhgen.compiler import Compilation
    from dhgen.errors import Diagnostic
    from dhgen.parallel.verify import ParallelReport
    from dhgen.robot_files import AnyFile, ParallelFile, RobotFile, RobotFiles
    from dhgen.targets.module import SolverModule
    from dhgen.verify.verify import Report

Verified = TypeVar("Verified", "Report", "ParallelReport")

FAULT = """\
{whose}; nothing was written
please report it, with the robot file"""
WHOSE = "this is a bug in dhgen, not a mistake in the file"
WHOSE_NOTED = "a note above may say why; if not, this is a bug in dhgen"


def _print_progress(text: str) -> None:
    """Prints progress, at a terminal."""
    if sys.stderr.isatty():
        print(f"  {text} ...", file=sys.stderr, flush=True)


def _compile(file: RobotFile, *, out: Path | None = None, single_file: bool = False) -> Compilation:
    from dhgen.compiler import compile_loaded  # noqa: PLC0415

    _print_notes(file.robot.notices)
    with about(file.path):
        return compile_loaded(file, _print_progress, out=out, single_file=single_file)


def _print_notes(notices: Iterable[Diagnostic]) -> None:
    for notice in notices:
        print(f"note: {notice}", file=sys.stderr)


def _read(options: argparse.Namespace) -> tuple[RobotFiles, int]:
    """The files that can be read, and the exit code; prints why others are refused."""
    from dhgen.robot_files import load_all  # noqa: PLC0415

    files = load_all(options.files)
    for refusal in files.refusals:
        print(refusal, file=sys.stderr)
    if options.numerical:
        files = replace(files, loaded=tuple(file.with_numerical() for file in files.loaded))
    return files, max((refusal.exit_code for refusal in files.refusals), default=0)


def write(options: argparse.Namespace) -> int:
    """Derives, verifies and writes; the exit code."""
    files, worst = _read(options)
    left = [path for path in files.paths if path not in {file.path for file in files.loaded}]
    for file in files.loaded:
        try:
            _write_one(file, options)
        except DhgenError as error:
            print(error, file=sys.stderr)
            if isinstance(error, (ImmobileError, VerificationError)):
                _print_notes(file.robot.doubts)
            if isinstance(error, VerificationError):
                whose = WHOSE_NOTED if file.robot.notices + file.robot.doubts else WHOSE
                print(FAULT.format(whose=whose), file=sys.stderr)
            worst = max(worst, error.exit_code)
            left.append(file.path)
    if left and len(files.paths) > 1:  # the reasons may be far above
        sys.stdout.flush()
        names = ", ".join(map(str, left))
        print(f"dhgen: nothing was written for {names}: see above", file=sys.stderr)
    return worst


def _write_one(file: AnyFile, options: argparse.Namespace) -> None:
    from dhgen.compiler import verified  # noqa: PLC0415
    from dhgen.derivation import derivation_summary, tool_at_zero  # noqa: PLC0415
    from dhgen.robot_files import ParallelFile  # noqa: PLC0415

    refuse_taken(file, options.out)
    refuse_not_ours(file.path, options.out, _expected(file, single_file=options.single_file))
    if isinstance(file, ParallelFile):
        _write_parallel(file, options)
        return
    compilation = _compile(file, out=options.out, single_file=options.single_file)
    module = compilation.module
    if options.numerical and module.method is not Method.NUMERICAL:
        print("note: --numerical was not needed", file=sys.stderr)
    print(f"{compilation.robot.name}: {compilation.robot.title}")
    print(derivation_summary(compilation.story))
    report = _written(
        file.path, compilation.files, lambda: verified(compilation, _print_progress), options.out
    )
    compiled = _compared(module) if report.compiled else "no C compiler found: C not tested"
    print(
        f"verified on {report.poses} poses: {report.solutions} solutions, largest residual "
        f"{report.residual:.1e} arm sizes; {compiled}"
    )
    if report.single is not None:
        print(f"in single precision: largest residual {report.single:.1e} arm sizes")
    print(tool_at_zero(module.chain, module.length_unit))
    print(f"all solutions counted by an independent search: dhgen survey {quote(str(file.path))}")
    print(f"wrote {', '.join(str(options.out / name) for name in _own(file, compilation))}\n")


def _expected(file: AnyFile, *, single_file: bool) -> list[str]:
    """The files that a robot file will make, as far as they are known before the work."""
    from dhgen.runtime import runtime_files  # noqa: PLC0415
    from dhgen.runtime.helpers import helper_files  # noqa: PLC0415

    return [*file.names, *helper_files(), *(() if single_file else runtime_files())]


def _written(
    source: Path, files: Mapping[str, str], verified: Callable[[], Verified], out: Path
) -> Verified:
    """The report of verification on a robot file's files, which are written once it has passed."""
    from dhgen.atomic_write import replace_files  # noqa: PLC0415
    from dhgen.verify.compiled import keep_compiled  # noqa: PLC0415

    refuse_not_ours(source, out, files)
    refuse_occupied([out / name for name in files])
    if not sys.stderr.isatty():  # where each stage is shown
        print("verifying what is to be written: this may take a minute ...", flush=True)
    report = verified()
    out.mkdir(parents=True, exist_ok=True)
    replace_files(out, {name: text.encode() for name, text in files.items()})
    for name, code in report.code.items():
        keep_compiled(code, out / f"{name}.py")
    return report


def _write_parallel(file: ParallelFile, options: argparse.Namespace) -> None:
    """Derives, verifies and writes a parallel robot with its legs."""
    from dhgen.parallel.compile import compile_parallel, verified_parallel  # noqa: PLC0415
    from dhgen.parallel.document import parallel_summary  # noqa: PLC0415

    _print_notes(file.robot.notices)
    with about(file.path):
        made = compile_parallel(
            file, _print_progress, out=options.out, single_file=options.single_file
        )
    print(f"{made.robot.name}: {made.robot.title}")
    print(parallel_summary(made.module))
    with about(file.path):
        report = _written(
            file.path, made.files, lambda: verified_parallel(made, _print_progress), options.out
        )
    compared = "Python and C agree" if report.compiled else "no C compiler found: C not tested"
    print(
        f"verified on {report.poses} poses of the platform: {report.modes} working modes, largest "
        f"miss of a leg {report.residual:.1e} robot sizes; {compared}"
    )
    own = [name for name in made.files if name.partition(".")[0] in file.stems]
    print(f"wrote {', '.join(str(options.out / name) for name in own)}\n")


def _print_untranslated(sentences: Iterable[str]) -> None:
    for sentence in sentences:
        print(
            f"note: no French for this sentence, which stays English: {sentence}", file=sys.stderr
        )


def _compared(module: SolverModule) -> str:
    if module.method is Method.NUMERICAL:
        return (
            "Python and C checked separately: which solution a start leads to depends on rounding"
        )
    return "Python and C agree"


def _own(file: RobotFile, compilation: Compilation) -> list[str]:
    files = [name for name in compilation.files if name.partition(".")[0] in file.stems]
    return files + [name for name in compilation.files if name.endswith(".svg")]


def check(options: argparse.Namespace) -> int:
    """Compares what is written with what the compiler makes; the exit code."""
    from dhgen.check import compare  # noqa: PLC0415

    files, refused = _read(options)
    for file in files.loaded:
        _print_notes(file.robot.notices)
    found = compare(files, options.out, _repeated(options), single_file=options.single_file)
    for message in (*found.refusals, *found.problems):
        print(message, file=sys.stderr)
    worst = max(refused, found.exit_code)
    if not worst:
        count = len(files.loaded)
        print(f"{options.out}: up to date with {count} robot file{'s' if count > 1 else ''}")
    return worst


def _repeated(options: argparse.Namespace) -> list[str]:
    """The options that a command which makes the same files has to repeat."""
    place = [] if options.out == OUT else ["--out", str(options.out)]
    words = {"--numerical": options.numerical, "--single-file": options.single_file}
    return place + [word for word, wanted in words.items() if wanted]


def _format(options: argparse.Namespace) -> str:
    """The format of what is explained: from the option, else from the file's ending.

    Raises:
        CommandError: What is printed is not the derivation, and can't have the format; or the
            ending of the file belongs to no format, or to another one.
    """
    what = _other_than_derivation(options)
    ending = "" if options.out is None else options.out.suffix.lower()
    if what is None:
        if options.format is None and ending not in ENDINGS:
            *endings, last = filter(None, ENDINGS)
            raise CommandError(
                f"dhgen: {options.out}: no format has the ending {ending}: write to "
                f"{', '.join(endings)} or {last}, or say --format"
            )
        if ending and options.format not in {None, ENDINGS.get(ending, options.format)}:
            raise CommandError(
                f"dhgen: {options.out}: the ending {ending} is that of {ENDINGS[ending]}, not of "
                f"--format {options.format}"
            )
        return str(options.format or ENDINGS[ending])
    if options.format not in {None, FORMATS[0]}:
        raise CommandError(f"dhgen: {what} is printed as text alone, not with --format")
    if options.language != LANGUAGES[0]:
        raise CommandError(f"dhgen: {what} is printed in English alone, not with --language")
    if options.format is None and ENDINGS.get(ending) != FORMATS[0]:
        raise CommandError(
            f"dhgen: {options.out}: {what} is printed as text alone: write to .txt, or say "
            f"--format {FORMATS[0]}"
        )
    return FORMATS[0]


def _other_than_derivation(options: argparse.Namespace) -> str | None:
    """What is to be printed in place of a derivation, as an option."""
    others = (f"--{each}" for each in ("alternatives", "program") if getattr(options, each))
    return next(others, None)


def explain(options: argparse.Namespace) -> int:
    """Prints a derivation, or writes it; the exit code."""
    from dhgen.derivation import alternatives_text, task_remarks  # noqa: PLC0415
    from dhgen.derivation.formats import derivation_as  # noqa: PLC0415
    from dhgen.derivation.languages import language_of  # noqa: PLC0415
    from dhgen.program.text import program_text  # noqa: PLC0415
    from dhgen.robot_files import ParallelFile, read_file  # noqa: PLC0415
    from dhgen.solved import solved  # noqa: PLC0415

    file = read_file(options.file)
    if options.out is None:
        refuse_mute()
    else:
        refuse_what_was_read(options.out, [options.file])
        refuse_occupied([options.out])
    wished = _format(options)
    file = file.with_numerical() if options.numerical else file
    _print_notes(file.robot.notices)
    if isinstance(file, ParallelFile):
        _finish(*_parallel_derivation(file, options, wished), options.out)
        return 0
    with about(file.path):
        story = solved(file, _print_progress)
    for remark in task_remarks(story.derivation.problem.algebra.chain):
        print(f"note: {remark}", file=sys.stderr)
    beside: Mapping[str, str] = {}
    if options.alternatives:
        text = alternatives_text(story.derivation) + "\n"
    elif options.program:
        text = program_text(story.program)
    else:
        language = language_of(options.language)
        text, beside = derivation_as(wished, story, str(options.file), language)
        _print_untranslated(language.untranslated)
    _finish(text, beside, options.out)
    return 0


def _finish(text: str, beside: Mapping[str, str], out: Path | None) -> None:
    """Prints a document, or writes it with the files beside it."""
    from dhgen.atomic_write import write_files  # noqa: PLC0415

    if out is None:
        print(text, end="")
    else:
        print_replaced(out, text)
        write_files(out.parent, {out.name: text, **beside})
        documents = [out, *(out.parent / name for name in beside if not name.endswith(".svg"))]
        print(f"wrote {', '.join(map(str, documents))}")


def _parallel_derivation(
    file: ParallelFile, options: argparse.Namespace, wished: str
) -> tuple[str, Mapping[str, str]]:
    """The derivation of a parallel robot in the format and the language that are asked for."""
    from dhgen.derivation.languages import language_of  # noqa: PLC0415
    from dhgen.parallel.compile import parallel_stories  # noqa: PLC0415
    from dhgen.parallel.printing import derivations_as  # noqa: PLC0415

    if what := _other_than_derivation(options):
        raise CommandError(f"dhgen: {what} is for serial arms: {options.file} has legs")
    with about(file.path):
        module, legs = parallel_stories(file, _print_progress)
    language = language_of(options.language)
    if options.out is None and wished != FORMATS[0]:
        print("note: the derivations of the legs are written beside --out FILE", file=sys.stderr)
    made = derivations_as(wished, module, legs, options.out, language)
    _print_untranslated(language.untranslated)
    return made


def survey(options: argparse.Namespace) -> int:
    """Tests many arms; the exit code."""
    refuse_mute()
    # matrices are small and every core has its own arm: threads inside would be in the way
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    from dhgen.survey.survey import survey as lines_of  # noqa: PLC0415
    from dhgen.survey.table import survey_text  # noqa: PLC0415

    lines = lines_of(options.paths, options.poses, options.recall, _print_progress)
    for remark in (remark for line in lines for remark in line.remarks):
        print(remark, file=sys.stderr)
    print(survey_text(lines), end="")
    if any(line.mistaken for line in lines):
        return 2
    return 0 if all(line.complete for line in lines) else 1
