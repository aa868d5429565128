"""Derivations of one arm of every structure, made once a process, and the documents of all arms."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

from dhgen.derivation.story import Story
from dhgen.kinematics.build import build_chain
from dhgen.program.lowering.lower import lower
from dhgen.robot.load import load
from dhgen.targets.reserved import RESERVED
from tests.derived import derived
from tests.serial import SERIAL
from tests.structures import STRUCTURES, those_in

if TYPE_CHECKING:
    from dhgen.robot.robot import Robot

ROBOTS = Path(__file__).resolve().parents[2] / "robots"
GENERATED = ROBOTS.parent / "generated"
CHOSEN = set(STRUCTURES)
# Arms that no order of steps solves, as their committed files say.
ALL_WHOLE = [
    name for name in SERIAL if "_rows(&" in (GENERATED / f"{name}.c").read_text(encoding="utf-8")
]
WITH_STEPS = sorted(set(SERIAL) - set(ALL_WHOLE))
WHOLE = sorted(CHOSEN.intersection(ALL_WHOLE))
NAMES = sorted(CHOSEN.intersection(WITH_STEPS))
# Two of them take as long as the others together; what their steps are made of, the others have.
EACH = those_in(set(NAMES) - {"franka_panda", "spherical_wrist_general_arm"}, NAMES)
# What no arm of robots/ needs: types 10 and 11, type 3 with a second equation that is stretched,
# and a pose that is moved along the tool's z axis.
OWN = {
    "tilted_slide": Path(__file__).parent,
    "upright_shoulder": Path(__file__).parents[1] / "targets/robots",
    "coupled_slides": Path(__file__).parents[1] / "targets/robots",
    "tilted_tool": Path(__file__).parents[1] / "targets/robots",
}


def document(name: str) -> str:
    """The derivation as it is committed, which `dhgen --check` holds to what is made."""
    return (GENERATED / f"{name}.md").read_text(encoding="utf-8")


@cache
def story(name: str) -> Story:
    """A robot with its derivation and program."""
    return story_of(load(OWN.get(name, ROBOTS) / f"{name}.yaml"))


def story_of(robot: Robot) -> Story:
    """The same of a robot that has no file."""
    derivation = derived(build_chain(robot), numerical=robot.numerical)
    return Story(robot, derivation, lower(derivation, reserved=RESERVED))
