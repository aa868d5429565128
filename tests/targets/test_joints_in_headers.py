"""Types and limits of joints, as a robot's header lists them."""

from __future__ import annotations

import math
import subprocess
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.robot.robot import JointKind
from tests.targets.made import ROBOTS, robot

if TYPE_CHECKING:
    from pathlib import Path

GENERATED = ROBOTS.parent / "generated"
PROGRAM = """#include <math.h>
#include <stdio.h>
#include "{name}.h"
int main(void) {{
    static const {number} limits[{upper}_DOF][2] = {{ {upper}_JOINT_LIMITS }};
    puts({upper}_JOINT_TYPES);
    for (int i = 0; i < {upper}_DOF; i++)
        printf("%.17g %.17g\\n", (double)limits[i][0], (double)limits[i][1]);
    return 0;
}}
"""
WARNINGS = ("-std=c99", "-pedantic-errors", "-Wall", "-Wextra", "-Wconversion", "-Werror")


@pytest.mark.parametrize("name", ["scara", "scara_f32", "welding_5r", "kuka_kr6_r900"])
def test_macros_make_arrays(name: str, tmp_path: Path) -> None:
    """As the robot file has them, infinite where it has none; floats in single precision."""
    single = name.endswith("_f32")
    text = PROGRAM.format(name=name, upper=name.upper(), number="float" if single else "double")
    (tmp_path / "shows.c").write_text(text)
    command = ("gcc", *WARNINGS, f"-I{GENERATED}", "shows.c", "-o", "shows")
    subprocess.run(command, cwd=tmp_path, check=True)
    shown = subprocess.run([tmp_path / "shows"], capture_output=True, text=True, check=True)
    types, *limits = shown.stdout.splitlines()
    joints = robot(name.removesuffix("_f32")).joints
    assert types == "".join("R" if j.kind is JointKind.REVOLUTE else "P" for j in joints)
    found = [[float(end) for end in line.split()] for line in limits]
    written = [joint.limits or (-math.inf, math.inf) for joint in joints]
    np.testing.assert_allclose(found, written, rtol=1e-7 if single else 0.0, atol=0.0)
