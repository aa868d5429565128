"""The page of costs: what stands there is counted in the programs."""

from __future__ import annotations

import pytest

from benchmarks.costs import DOCUMENT, costs, written
from dhgen.method import Method
from tests.derivation.stories import ROBOTS, story

TOLD = written(DOCUMENT.read_text(encoding="utf-8"))


@pytest.mark.parametrize("name", ["planar_rr", "scara", "arm_6r", "puma560", "welding_5r"])
def test_the_page_has_what_is_counted(name: str) -> None:
    assert TOLD[name] == costs(name, story(name).program)


def test_every_arm_that_is_solved_step_by_step_is_on_the_page() -> None:
    for path in sorted((ROBOTS.parent / "generated").glob("*.py")):
        text = path.read_text(encoding="utf-8")
        if (ROBOTS / f"{path.stem}.yaml").is_file():
            by_steps = f'METHOD = "{Method.CLOSED_FORM}"' in text or f'"{Method.QUARTIC}"' in text
            assert by_steps == (path.stem in TOLD), path.stem
