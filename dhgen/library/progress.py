"""Messages while a solver is built: by default a line a stage, where a person waits."""

from __future__ import annotations

import sys


def show_progress(text: str) -> None:
    """Writes a line to stderr: at a terminal, in an interactive Python, in a notebook."""
    if hasattr(sys, "ps1") or sys.stderr.isatty():
        print(f"dhgen: {text} ...", file=sys.stderr, flush=True)  # noqa: T201


def no_progress(_: str) -> None:
    """For those who want no progress."""
