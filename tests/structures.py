"""Arms of the structures that most code depends on, for tests that take seconds with each."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from collections.abc import Collection, Iterable
    from pathlib import Path

    from _pytest.mark import MarkDecorator, ParameterSet

BREADTH = pytest.mark.breadth  # once before a release: see pyproject.toml

STRUCTURES = (
    "cartesian",
    "cuspidal_3r",
    "fanuc_crx10ia",
    "franka_panda",
    "kuka_iiwa14_arm_angle",
    "planar_rrrr",
    "puma560",
    "scara",
    "scorbot_pointing",
    "spherical_wrist_general_arm",
    "stanford",
    "ur5",
)

# Of the arms made up for tests, one of each that has code of its own: another task, oblique slides,
# a given joint that a step or an elbow hangs on, two of them, awkward names, limits that choose
# rows, a general arm that stops where solutions meet, quotients that vanish, right angles written
# with four digits. What is particular to the later ones, tests of their own ask for.
ODD = (
    *("coupled_slides", "given_shoulder", "hard_wrist", "offset_stop", "pitch_arm"),
    *("rounded_twists", "two_free"),
    *("named_badly", "pan_tilt", "planar_4r", "slide_by_quotient", "tilting_gantry"),
    *("turned_head", "yaw_checked"),
)
OFTEN_ODD = ODD[:7]

# Those whose Python numba compiles in the tests, at up to half a minute each; the Python of the
# others runs there without it.
COMPILED = ("scara",)
COMPILED_SLOWLY = ("fanuc_crx10ia", "scorbot_pointing")

# Those of the general algorithm whose programs are run: numba compiles it once a process, and a C
# compiler what they share.
GENERAL = frozenset({"close_pair", "fanuc_crx10ia", "offset_stop"})


def one_of_each(names: Iterable[str]) -> list[ParameterSet]:
    """All names, as a test takes them: those of structures, slow odd ones, and others as breadth.

    What is the same for all arms of a structure fails for the first of them.
    """
    marks: dict[str, Any] = {
        **dict.fromkeys(STRUCTURES, ()),
        **dict.fromkeys(OFTEN_ODD, pytest.mark.slow),
    }
    return [pytest.param(name, marks=marks.get(name, BREADTH)) for name in names]


def says(path: Path, line: str) -> bool:
    """Whether a robot file has a line that begins like this.

    Tests are chosen by that: to read all robot files as dhgen does takes as long as to collect all
    tests, in each process that runs them.
    """
    return re.search(f"^{line}", path.read_text("utf-8"), re.MULTILINE) is not None


def those_in(first: Collection[str], names: Iterable[str]) -> list[ParameterSet]:
    """All names, as a test takes them, of which those that are not among the first are breadth."""
    return [pytest.param(name, marks=() if name in first else BREADTH) for name in names]


def first_of(cases: Iterable[Any], count: int = 1) -> list[ParameterSet]:
    """All cases, as a test takes them: those behind the first ones are breadth.

    Args:
        cases: Values of one parameter, or tuples of those of several, in an order of which the
            first ones fail where any does.
        count: How many of them always run.
    """
    return _marked(cases, count, BREADTH)


def quick_first(cases: Iterable[Any], count: int = 1) -> list[ParameterSet]:
    """All cases, as a test takes them: those behind the first ones are slow.

    Args:
        cases: As for first_of; those behind the first ones take seconds each.
        count: How many of them run in every call of pytest.
    """
    return _marked(cases, count, pytest.mark.slow)


def _marked(cases: Iterable[Any], count: int, mark: MarkDecorator) -> list[ParameterSet]:
    """All cases, those behind the first ones with a mark."""
    values = [case if isinstance(case, tuple) else (case,) for case in cases]
    return [pytest.param(*each, marks=mark if k >= count else ()) for k, each in enumerate(values)]
