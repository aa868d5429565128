"""Which matrix has letters for its entries, and which letters these are."""

from __future__ import annotations

from dhgen.robot.load import load_text
from tests.derivation.stories import story, story_of

WRIST = """
name: wristed
convention: standard
task: pose
parameters: {{{first}: 0.4, {second}: 0.3, {third}: 0.2, {fourth}: 0.1}}
joints:
  - {{theta: q, d: {first}, a: {second}, alpha: -pi/2}}
  - {{theta: q, a: {third}}}
  - {{theta: q, a: 0.05, alpha: -pi/2}}
  - {{theta: q, d: {fourth}, alpha: pi/2}}
  - {{theta: q, alpha: -pi/2}}
  - {{theta: q}}
"""


def letters(*lengths: str) -> set[str]:
    """How the letters of an arm begin whose lengths are called so."""
    names = dict(zip(("first", "second", "third", "fourth"), lengths, strict=True))
    side = story_of(load_text(WRIST.format(**names), "wristed.yaml")).known_side
    return set() if side is None else {name.text[0] for _, name in side.entries}


def test_no_letter_of_the_arm_is_taken() -> None:
    assert letters("d1", "a1", "a2", "d4") == {"u"}
    assert letters("u1", "a1", "a2", "d4") == {"g"}
    assert letters("u1", "gap", "k1", "h1") == {"v"}


def test_where_all_are_taken_the_steps_have_none() -> None:
    assert letters("u1", "gap", "k1", "v1") == {"h"}
    assert not letters("u1", "gap_k", "M1", "v1") & {"u", "g", "v"}
    assert letters("M", "N", "V", "d4") == set()


def test_the_one_that_makes_the_steps_shortest_is_taken() -> None:
    """U_1 would do for the first arm, too."""
    for name, place in (("spherical_wrist_general_arm", (3, 6)), ("franka_panda", (0, 3))):
        of = story(name)
        side = of.known_side
        assert side is not None
        assert side.place[:2] == place
