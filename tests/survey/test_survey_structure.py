"""Arms are called what the field calls them."""

from __future__ import annotations

import pytest

from dhgen.kinematics.build import build_chain
from dhgen.survey.sources import arm_class, joint_letters
from tests.robots.cases import robot

CLASSES = {
    "puma560": ("RRRRRR", "spherical wrist, ortho-parallel"),
    "stanford": ("RRPRRR", "spherical wrist"),
    "ur5": ("RRRRRR", "parallel axes 2-3-4"),
    "scara": ("RRPR", "SCARA"),
    "scara_prrr": ("PRRR", "SCARA"),
    "planar_rr": ("RR", "planar, x, y"),
    "planar_rrr": ("RRR", "planar"),
    "cartesian": ("PPP", "Cartesian, position"),
    "wrist_zyz": ("RRR", "spherical wrist, orientation"),
    "kuka_youbot": ("RRRRR", "parallel axes 2-3-4"),
    "concurrent_345": ("RRRRRR", "axes 3-4-5 meet"),
    "cuspidal_3r": ("RRR", "general 3R, position"),
    "spherical_wrist_general_arm": ("RRRRRR", "spherical wrist"),
    "kuka_iiwa14": ("RRrRRRR", "spherical wrist"),
    "rrprrr": ("RRPRRR", "spherical wrist"),
    "scorbot_pointing": ("RRRRr", "parallel axes 2-3-4, pointing"),
}


@pytest.mark.parametrize("name", CLASSES)
def test_structure(name: str) -> None:
    chain = build_chain(robot(name))
    assert (joint_letters(chain), arm_class(chain)) == CLASSES[name]
