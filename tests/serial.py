"""The robot files of serial arms; those of parallel robots have legs, and tests of their own."""

from __future__ import annotations

from pathlib import Path

ROBOTS = Path(__file__).resolve().parents[1] / "robots"


def is_parallel(path: Path) -> bool:
    """Whether a robot file has legs."""
    return "\nlegs:\n" in path.read_text(encoding="utf-8")


PARALLEL = [path.stem for path in sorted(ROBOTS.glob("*.yaml")) if is_parallel(path)]
SERIAL = [path.stem for path in sorted(ROBOTS.glob("*.yaml")) if path.stem not in PARALLEL]
