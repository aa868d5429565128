"""Derivations of the documents' robots and of one arm of every structure, made once a process."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from dhgen.kinematics.build import build_chain
from dhgen.paul.derivation import derive
from dhgen.program.lower import lower
from dhgen.robot.load import load
from dhgen.targets.derivation.story import Story
from tests.robots.cases import NAMES as DOCUMENTED
from tests.structures import STRUCTURES

ROBOTS = Path(__file__).resolve().parents[2] / "robots"
GENERATED = ROBOTS.parent / "generated"
CHOSEN = {*DOCUMENTED, *STRUCTURES, "general_4r2p", "kinova_gen3_7"}
# Arms that no order of steps solves, as their committed files say.
WHOLE = sorted(
    name
    for name in CHOSEN
    if "static void all_joints(" in (GENERATED / f"{name}.c").read_text(encoding="utf-8")
)
NAMES = sorted(CHOSEN - set(WHOLE))


@cache
def story(name: str) -> Story:
    """A robot with its derivation and program."""
    robot = load(ROBOTS / f"{name}.yaml")
    derivation = derive(build_chain(robot), numerical=robot.numerical)
    return Story(robot, derivation, lower(derivation))
