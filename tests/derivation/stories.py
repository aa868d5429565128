"""The derivations of all robots of the project, made once a process."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from dhgen.kinematics.build import build_chain
from dhgen.paul.derivation import derive
from dhgen.program.lower import lower
from dhgen.robot.load import load
from dhgen.targets.derivation.story import Story

ROBOTS = Path(__file__).resolve().parents[2] / "robots"
NAMES = sorted(path.stem for path in ROBOTS.glob("*.yaml"))


@cache
def story(name: str) -> Story:
    """A robot with its derivation and program."""
    robot = load(ROBOTS / f"{name}.yaml")
    derivation = derive(build_chain(robot), numerical=robot.numerical)
    return Story(robot, derivation, lower(derivation))
