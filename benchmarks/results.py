"""What a run measured, and the tables made of it."""

from __future__ import annotations

import platform
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from benchmarks.report import table, time_text
from dhgen.verify.native import c_compiler

if TYPE_CHECKING:
    from collections.abc import Sequence

    from benchmarks.arms import Case
    from benchmarks.contestant import Absentee, Contestant
    from benchmarks.quality import Quality
    from benchmarks.rounds import Timing


@dataclass(frozen=True, slots=True)
class Entry:
    """A contestant, how fast it is and how right."""

    contestant: Contestant
    timing: Timing
    quality: Quality


@dataclass(frozen=True, slots=True)
class Result:
    """Everybody on one arm.

    Attributes:
        case: The arm.
        entries: Who took part.
        absent: Who did not, and why.
    """

    case: Case
    entries: tuple[Entry, ...]
    absent: tuple[Absentee, ...]

    @property
    def best_rival(self) -> Entry | None:
        """The fastest that is not dhgen."""
        rivals = [entry for entry in self.entries if not entry.contestant.ours]
        return min(rivals, key=lambda entry: entry.timing.least, default=None)

    def own(self, way: str) -> Entry | None:
        """dhgen, called in one way."""
        found = (e for e in self.entries if e.contestant.ours and e.contestant.way == way)
        return next(found, None)


HEAD = ("solver", "least", "median", "× best rival", "found", "wrong", "residual", "aligned")


def arm_table(result: Result) -> str:
    """Everybody on one arm, the fastest first."""
    best = result.best_rival
    ordered = sorted(result.entries, key=lambda entry: entry.timing.least)
    lines = [table(HEAD, [_row(entry, best) for entry in ordered])]
    lines += [f"- {absentee.tool}: {absentee.why}" for absentee in result.absent]
    return "\n".join([lines[0], "", *lines[1:]]).rstrip()


def _row(entry: Entry, best: Entry | None) -> tuple[str, ...]:
    timing, quality = entry.timing, entry.quality
    ratio = f"{best.timing.least / timing.least:.2f}" if best else "-"
    return (
        entry.contestant.label,
        time_text(timing.least),
        time_text(timing.median),
        ratio,
        f"{quality.found:.2%}",
        f"{quality.wrong:.2%}",
        f"{quality.residual:.0e}",
        f"{quality.aligned:.0%}",
    )


def summary_table(results: Sequence[Result], ways: Sequence[tuple[str, str]]) -> str:
    """An arm a line: the best rival and dhgen called in several ways (heading, way)."""
    head = ("arm", "best other solver", *(heading for heading, _ in ways))
    return table(head, [_summary(result, [way for _, way in ways]) for result in results])


def _summary(result: Result, ways: Sequence[str]) -> tuple[str, ...]:
    best = result.best_rival
    rival = f"{best.contestant.label}: {time_text(best.timing.least)}" if best else "none"
    own = (result.own(way) for way in ways)
    cells = (time_text(entry.timing.least) if entry else "-" for entry in own)
    return (f"{result.case.name} ({result.case.kind})", rival, *cells)


def target_table(results: Sequence[Result]) -> str:
    """What was aimed at, and how far it is."""
    rows = [
        (
            result.case.name,
            way,
            time_text(aim),
            time_text(entry.timing.least),
            f"{entry.timing.least / aim:.2f}",
        )
        for result in results
        for way, aim in result.case.targets.items()
        if (entry := result.own(way)) is not None
    ]
    return table(("arm", "called", "target", "least", "÷ target"), rows)


VECTORS = {"avx512f": "AVX-512", "avx2": "AVX2"}


def machine() -> str:
    """The processor and its vectors, the compiler and Python, in a line."""
    processor = platform.processor() or platform.machine()
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    names = [line.split(":")[1].strip() for line in lines if line.startswith("model name")]
    compiler = c_compiler()
    version = ""
    if compiler:
        done = subprocess.run([compiler, "--version"], capture_output=True, text=True, check=False)
        version = done.stdout.splitlines()[0] if done.stdout else ""
    flags = next((set(line.split()) for line in lines if line.startswith("flags")), set())
    wide = next((word for flag, word in VECTORS.items() if flag in flags), "")
    parts = [names[0] if names else processor, wide, version, f"Python {platform.python_version()}"]
    return ", ".join(part for part in parts if part)
