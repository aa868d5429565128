"""The command line: `dhgen robots/scara.yaml`, `dhgen --check robots/*.yaml`, `dhgen explain`."""

from __future__ import annotations

import difflib
import io
import os
import re
import sys
import tempfile
from typing import TYPE_CHECKING

from dhgen.arguments import calibrate_parser, explain_parser, import_parser, parser, survey_parser
from dhgen.commands import check, explain, survey, write
from dhgen.errors import CommandError, DhgenError
from dhgen.robot_file_commands import calibrate, import_description
from dhgen.workers import collect_seldom, interrupts_repeated, reckon_alone

if TYPE_CHECKING:
    import argparse
    from collections.abc import Sequence
    from pathlib import Path


# What the first word may be meant as where it is no file.
MEANT = {
    **{verb: f"dhgen {verb}" for verb in ("explain", "import", "calibrate", "survey")},
    **{
        option: f"dhgen --{option}"
        for option in ("check", "numerical", "single-file", "help", "version")
    },
}
# Where nobody reads a command's output it is not known to have gone well: a derivation alone has
# been read as far as was wanted.
READER_GONE = 1
INTERRUPTED = 130  # the exit code in shells of a command that Ctrl-C has ended


def main(arguments: Sequence[str] | None = None) -> int:
    """Runs the command; returns the exit code."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    collect_seldom()
    reckon_alone()
    _open_closed()
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):  # a terminal that can't show a letter shows ?
            stream.reconfigure(errors="replace")
    code = 0
    try:
        with interrupts_repeated():
            code = _run(words)
        sys.stdout.flush()
    except DhgenError as error:
        code = error.exit_code
        _print_error(str(error))
    except KeyboardInterrupt:
        code = INTERRUPTED
        _print_error("dhgen: interrupted")
    except BrokenPipeError:  # the reader of our output has seen enough
        _lose_output()
        code = 0 if words[:1] == ["explain"] else max(code, READER_GONE)
    except OSError as error:
        code = 1
        _print_error(f"dhgen: {error.strerror or error}: {error.filename or 'output'}")
    return code


def _run(words: list[str]) -> int:
    if words[:1] == ["explain"]:
        return explain(_parsed(explain_parser(), words[1:]))
    if words[:1] == ["survey"]:
        return survey(_parsed(survey_parser(), words[1:]))
    if words[:1] == ["import"]:
        return import_description(import_parser().parse_args(words[1:]))
    if words[:1] == ["calibrate"]:
        return calibrate(calibrate_parser().parse_args(words[1:]))
    options = _parsed(parser(), words)
    _refuse_misspelt(options.files[0])
    if not options.check:
        _refuse_unwritable(options.out)
    return check(options) if options.check else write(options)


def _parsed(made: argparse.ArgumentParser, words: list[str]) -> argparse.Namespace:
    """The options of a command that takes descriptions, too, as `dhgen import` does without any."""
    options, unknown = made.parse_known_args(words)
    if unknown:
        named = [word.partition("=")[0] for word in unknown if word.startswith("--")]
        known = import_parser().format_help()
        hint = ""
        if named and all(re.search(rf"{re.escape(each)}\b", known) for each in named):
            hint = " (for dhgen import: write a robot file with it, and give that)"
        made.error(f"unrecognized arguments: {' '.join(unknown)}{hint}")
    return options


def _print_error(message: str) -> None:
    """Writes to stderr; who does not listen, there or to stdout, gets the exit code alone."""
    try:
        print(message, file=sys.stderr, flush=True)
        sys.stdout.flush()
    except OSError:
        _lose_output()


def _lose_output() -> None:
    """What is still to be written goes nowhere: Python would stumble over it when it ends."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for stream in (sys.stdout, sys.stderr):
        os.dup2(nowhere, stream.fileno())


def _open_closed() -> None:
    """Gives the streams that the caller has closed back: what is written there is lost.

    In the order of their numbers: each gets its own, which the next file would get else.
    """
    for name, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, mode, encoding="utf-8"))  # noqa: PTH123, SIM115


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
