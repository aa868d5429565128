"""Arms of the structures that most code depends on, for tests that take seconds with each."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from collections.abc import Iterable

    from _pytest.mark import ParameterSet

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
# with four digits.
ODD = (
    "coupled_slides",
    "given_shoulder",
    "hard_wrist",
    "named_badly",
    "offset_stop",
    "pan_tilt",
    "pitch_arm",
    "planar_4r",
    "rounded_twists",
    "slide_by_quotient",
    "tilting_gantry",
    "turned_head",
    "two_free",
    "yaw_checked",
)

# Those whose Python numba compiles in the tests, at up to half a minute each; the Python of the
# others runs there without it.
COMPILED = ("scara",)
COMPILED_SLOWLY = ("fanuc_crx10ia", "scorbot_pointing", "ur5")

# Those of the general algorithm whose programs are run: numba compiles it once a process, and a C
# compiler what they share.
GENERAL = frozenset({"close_pair", "fanuc_crx10ia", "offset_stop"})


def one_of_each(names: Iterable[str]) -> list[str | ParameterSet]:
    """All names, as a test takes them: but for an arm of each of these structures they are slow.

    What is the same for all arms of a structure fails for the first of them.
    """
    first = {*STRUCTURES, *ODD}
    return [name if name in first else pytest.param(name, marks=pytest.mark.slow) for name in names]
