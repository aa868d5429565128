"""Golden derivations: the documents without their cost, which belongs to the program.

`python -m tests.derivation.golden` writes them anew; read the difference before it is committed.
"""

from __future__ import annotations

from pathlib import Path

from dhgen.derivation import derivation_document
from tests.derivation.stories import story

FOLDER = Path(__file__).resolve().parent / "golden"
NAMES = ("arm_6r", "planar_rr", "scara")


def made(name: str) -> str:
    """A derivation as Markdown, made here and now."""
    of = story(name)
    return derivation_document(of, f"robots/{of.robot.name}.yaml")


if __name__ == "__main__":
    for each in NAMES:
        (FOLDER / f"{each}.md").write_text(made(each), encoding="utf-8")
