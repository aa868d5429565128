"""Steps have one name: in the page on promises, in the policy, in both languages of the runtime."""

from __future__ import annotations

import re
from dataclasses import fields
from pathlib import Path

from dhgen.program.policy import Policy

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
PAGE = (ROOT / "docs/promises.md").read_text(encoding="utf-8")
STEPS = [
    [cell.strip() for cell in line.strip("|").split("|")]
    for line in PAGE.splitlines()
    if line.startswith("| `")
]


def test_steps_are_files_of_the_runtime() -> None:
    assert len(STEPS) > 10
    for step, *_ in STEPS:
        for folder, end in (("c/dhgen", ".h"), ("python", ".py")):
            assert (ROOT / "dhgen/runtime" / folder / (step.strip("`") + end)).is_file()


def test_every_part_of_the_policy_belongs_to_a_step() -> None:
    told = {name for _, _, names, _ in STEPS for name in re.findall(r"`(\w+)`", names)}
    assert told == {field.name for field in fields(Policy)}


def test_steps_are_tested_under_their_heading() -> None:
    """Of a heading the folder has the first words."""
    headings = [line[3:].casefold() for line in PAGE.splitlines() if line.startswith("## ")]
    folders = {path.parent.name.replace("_", " ") for path in HERE.glob("*/test_*.py")}
    assert all(any(each.startswith(name) for each in headings) for name in folders)
    assert {heading for *_, heading in STEPS} <= folders
