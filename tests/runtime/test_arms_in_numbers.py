"""The array that the runtime gets of an arm: its forward model, its loop, its descents."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from dhgen.general.arm import general_kernel
from dhgen.general.runtime_loop import runtime_loop
from dhgen.kinematics.build import build_chain
from dhgen.kinematics.numeric import numeric_arm
from dhgen.numerical.kernel import numerical_kernel
from dhgen.numerical.runtime_arm import runtime_arm
from dhgen.robot.load import load
from dhgen.runtime.plain import plain
from dhgen.runtime.python.general.arm import general_numbers
from dhgen.runtime.python.numerical.arm import arm_numbers

if TYPE_CHECKING:
    from dhgen.kinematics.chain import Chain

ROBOTS = Path(__file__).parents[2] / "robots"
COUPLED = Path(__file__).parents[1] / "targets" / "coupled"
# with offsets and signs, slides, and joints whose values the caller gives
ARMS = ("general_5r1p", "kinova_gen3_7", "scara", "general_5r_pointing", "planar_rrrr")


@pytest.mark.parametrize("name", ARMS)
def test_the_forward_model_is_that_of_the_chain(name: str) -> None:
    chain = build_chain(load(ROBOTS / f"{name}.yaml"))
    arm = arm_numbers(runtime_arm(numerical_kernel(chain, redundant=False)))
    q = np.random.default_rng(1).uniform(-2.0, 2.0, (5, chain.dof))
    for values, T, J in zip(q, *numeric_arm(chain).moved(q), strict=True):
        P, columns = np.empty(12), np.empty((6, chain.dof))
        plain("numerical.forward").forward(arm, values, P, columns)
        np.testing.assert_allclose(P.reshape(3, 4), T[:3], atol=1e-14)
        np.testing.assert_allclose(columns, J, atol=1e-14)


@pytest.mark.parametrize("name", ARMS)
def test_misses_change_as_their_jacobian_says(name: str) -> None:
    """Central differences at a solution, where the Jacobian is that of the tool."""
    compare_with_differences(build_chain(load(ROBOTS / f"{name}.yaml")))


def test_misses_change_as_a_slide_says_that_turns_a_joint(tmp_path: Path) -> None:
    """Of a slide all rows are in arm sizes: also those that only turns of others have else."""
    text = (COUPLED / "geared_5r1p.yaml").read_text(encoding="utf-8")
    turned = text.replace("theta: q - 2/3*q2", "theta: q - 2/3*q2 + 2*q3")
    assert turned != text
    (tmp_path / "geared_5r1p.yaml").write_text(turned, encoding="utf-8")
    compare_with_differences(build_chain(load(tmp_path / "geared_5r1p.yaml")))


def compare_with_differences(chain: Chain) -> None:
    kernel = numerical_kernel(chain, redundant=False)
    arm, measure_miss = arm_numbers(runtime_arm(kernel)), plain("numerical.descent").measure_miss
    q = np.random.default_rng(2).uniform(-1.0, 1.0, chain.dof)
    goal = numeric_arm(chain).pose(q)[:3].copy(), np.zeros(0), None
    u = q[list(kernel.solved)] / kernel.units
    e, A = np.empty(kernel.equations), np.empty((kernel.equations, len(u)))
    assert measure_miss(arm, goal, q.copy(), u, e, A) < 1e-14
    for j in range(len(u)):
        ends = []
        for step in (1e-6, -1e-6):
            moved, ignored = u.copy(), A.copy()
            moved[j] += step
            measure_miss(arm, goal, q.copy(), moved, e, ignored)
            ends.append(e.copy())
        np.testing.assert_allclose((ends[1] - ends[0]) / 2e-6, A[:, j], atol=1e-8)


@pytest.mark.parametrize("name", ["general_5r1p", "kinova_gen3_7", "general_5r"])
def test_loops_close_as_matrices_do(name: str) -> None:
    chain = build_chain(load(ROBOTS / f"{name}.yaml"))
    kernel = general_kernel(chain)
    assert kernel is not None
    whole = runtime_arm(numerical_kernel(chain, redundant=False))
    arm = general_numbers(whole, runtime_loop(kernel))
    q = np.random.default_rng(3).uniform(-1.0, 1.0, chain.dof)
    T, free = numeric_arm(chain).pose(q), q[[number - 1 for number in chain.free]]
    links = plain("general.loop").close(arm, T[:3].ravel().copy(), free)
    held = kernel.held(free.tolist())
    for found, link in zip(links, kernel.loop.links, strict=False):
        np.testing.assert_allclose(found, np.ravel(link.at(held)[:3]), atol=1e-14)
    P = np.array(kernel.loop.left.at(held)) @ T @ np.array(kernel.loop.right.at(held))
    P[:3, 3] /= kernel.loop.size
    np.testing.assert_allclose(links[5], P[:3].ravel(), atol=1e-13)
