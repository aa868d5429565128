"""The command lines of the modules here: which arms, and whether to write."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from benchmarks.arms import CHECKOUT
from benchmarks.report import DOCUMENT, place
from benchmarks.results import machine

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path


def parser(
    module: str, about: str | None, arms: Sequence[str] | None = None
) -> argparse.ArgumentParser:
    """A parser with --arms and --write.

    Args:
        module: What stands after `python -m`.
        about: The module's docstring.
        arms: What may be named; every serial arm if nothing is given.
    """
    made = argparse.ArgumentParser(
        prog=f"python -m {module}",
        description=about,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    every = robot_names() if arms is None else list(arms)
    made.add_argument("--arms", nargs="+", choices=every, default=every, metavar="NAME")
    made.add_argument("--write", action="store_true", help="update the documents")
    return made


def robot_names() -> list[str]:
    """Every serial arm of the checkout."""
    return [path.stem for path in _robot_files() if not _has_legs(path)]


def parallel_names() -> list[str]:
    """Every parallel robot of the checkout."""
    return [path.stem for path in _robot_files() if _has_legs(path)]


def _robot_files() -> list[Path]:
    return sorted((CHECKOUT / "robots").glob("*.yaml"))


def _has_legs(path: Path) -> bool:
    return "\nlegs:\n" in path.read_text(encoding="utf-8")


def show(text: str, mark: str, *, write: bool) -> None:
    """Prints a table and whence it is, and puts both into docs/benchmarks.md if asked to."""
    text = f"{machine()}.\n\n{text}"
    print(f"\n{text}")
    if write:
        place(DOCUMENT, mark, text)
