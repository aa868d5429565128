"""The line on what else a step could have been."""

from __future__ import annotations

import re

import pytest

from dhgen.derivation import alternatives_text
from dhgen.derivation.notation.names import unknown_symbol
from dhgen.derivation.sections.other_ways import other_way
from dhgen.derivation.text.blocks import paragraph
from dhgen.derivation.text.plain import plain
from tests.derivation.stories import story
from tests.derived import derived

SAID = re.compile(r"Also possible(| instead of this step): (\S+) from (.*), type (\d), (.*)\.")


def listed(name: str) -> list[list[str]]:
    """By step what `dhgen explain --alternatives` lists."""
    return [part.splitlines() for part in alternatives_text(story(name).derivation).split("step ")]


@pytest.mark.parametrize("name", ["scara", "ur5", "planar_rr"])
def test_it_is_listed_among_the_alternatives_and_not_taken(name: str) -> None:
    of, lines = story(name), listed(name)[1:]
    said = 0
    for number in range(1, len(of.steps) + 1):
        for block in other_way(of, number):
            found = SAID.fullmatch(" ".join(plain(block).split()))
            assert found is not None
            instead, unknown, places, kind, why = found.groups()
            unknowns = [
                plain(paragraph("{}", unknown_symbol(u))) for u in of.steps[number - 1].unknowns
            ]
            assert (unknown not in unknowns) == bool(instead)
            here = [line for line in lines[number - 1] if f"{unknown}: type {kind}," in line]
            parts = places.split(" and ")
            here = [line for line in here if all(part in line for part in parts)]
            assert here
            assert not any("(taken)" in line for line in here)
            values = of.steps[number - 1].roots
            assert ("instead of" in why) == (f"{['one', 'two'][values - 1]} value" not in here[0])
            said += 1
    assert said > 1


def test_the_robot_file_can_choose_it() -> None:
    """The SCARA's theta_2 from U_1, type 6: the third step of the same steps takes it."""
    third = listed("scara")[3]
    (line,) = [each for each in third if "θ₂: type 6, two values, U₁[1,4] and U₁[2,4]" in each]
    number = int(line.split()[0])
    taken = derived(story("scara").algebra.chain, steps=(1, 1, number))
    assert taken.steps[2].kind.number == 6
    assert {(o.m, o.row, o.column) for o in taken.steps[2].origins} == {(1, 1, 4), (1, 2, 4)}
