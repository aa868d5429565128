"""Derivations of tables that are written in a test."""

from __future__ import annotations

from typing import TYPE_CHECKING

from dhgen.derivation import derivation_document
from dhgen.derivation.story import Story
from dhgen.kinematics.build import build_chain
from dhgen.program.lowering.lower import lower
from tests.derived import derived
from tests.kinematics.values import table

if TYPE_CHECKING:
    from dhgen.robot.robot import Robot


def made_of(*rows: str, **sections: str) -> str:
    """The derivation of a robot of these rows."""
    return made_for(table(*rows, **sections))


def made_for(robot: Robot) -> str:
    """The derivation of a robot."""
    derivation = derived(build_chain(robot))
    return derivation_document(Story(robot, derivation, lower(derivation)), "robots/x.yaml")
