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
GENERATED = ROBOTS.parent / "generated"
# Arms that no order of steps solves, as their committed files say.
WHOLE = sorted(
    path.stem
    for path in ROBOTS.glob("*.yaml")
    if "static void all_joints(" in (GENERATED / f"{path.stem}.c").read_text(encoding="utf-8")
)
NAMES = sorted({path.stem for path in ROBOTS.glob("*.yaml")} - set(WHOLE))


@cache
def story(name: str) -> Story:
    """A robot with its derivation and program."""
    robot = load(ROBOTS / f"{name}.yaml")
    derivation = derive(build_chain(robot), numerical=robot.numerical)
    return Story(robot, derivation, lower(derivation))
