"""Arms from files, and their solutions against the oracle."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from dhgen.atomic_write import write_files
from dhgen.general.arm import general_kernel
from dhgen.kinematics.build import build_chain
from dhgen.kinematics.link_table import link_table
from dhgen.kinematics.numeric import numeric_arm
from dhgen.program.lowering.forward import forward_program, jacobian_program
from dhgen.program.lowering.lower import whole_program
from dhgen.program.policy import policy_of
from dhgen.robot.load import load
from dhgen.robot.robot import JointKind
from dhgen.runtime import c_runtime_files
from dhgen.targets.c.files import c_files
from dhgen.targets.module import SolverModule
from dhgen.targets.reserved import RESERVED
from dhgen.tolerances import DOUBLE
from tests.compiling import library
from tests.general.solved import is_complete, joint_values, solve
from tests.oracle.sets import all_solutions

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from dhgen.general.kernel import GeneralKernel
    from dhgen.kinematics.chain import Chain
    from dhgen.robot.robot import Robot
    from dhgen.verify.native import CompiledSolver


# Five joints without structure, and one that slides in the place of any.
TURNS = (
    "{theta: q + 0.7, d: 0.31, a: 0.2, alpha: 80 deg}",
    "{theta: q, d: 0.1, a: 0.4, alpha: 25 deg}",
    "{theta: -q, d: -0.17, a: 0.15, alpha: 70 deg}",
    "{theta: q, d: 0.2, a: 0.1, alpha: 95 deg}",
    "{theta: 1.1 - q, d: 0.15, a: 0.05, alpha: 50 deg}",
)
SLIDE = "{theta: 0.3, d: 0.1 - q, a: 0.15, alpha: 70 deg}"


def skew(folder: Path, rows: Sequence[str], free: Sequence[int] = (), task: str = "pose") -> Robot:
    """An arm of such joints with a tool that is tilted."""
    path = folder / "arm.yaml"
    head = f"name: arm\nconvention: modified\ntask: {task}\nfree: {list(free)}\n"
    tool = "tool: {xyz: [0.02, 0, 0.15], rpy: [0, 0.4, 0]}\n"
    text = "".join(f"  - {row}\n" for row in rows)
    path.write_text(f"{head}{tool}joints:\n{text}", encoding="utf-8")
    return load(path)


def written(folder: Path, rows: Sequence[str]) -> Robot:
    path = folder / "arm.yaml"
    text = "".join(f"  - {row}\n" for row in rows)
    path.write_text(f"name: arm\ntask: pose\njoints:\n{text}", encoding="utf-8")
    return load(path)


def without_derivation(arm: Robot) -> SolverModule:
    """The programs alone: the search for a closed form takes seconds, and finds none."""
    chain = build_chain(arm)
    kernel = general_kernel(chain)
    assert kernel is not None
    solver = whole_program(chain, kernel)
    return SolverModule(
        name=chain.name,
        title=arm.title,
        source="arm.yaml",
        chain=chain,
        method=kernel.method,
        solver=solver,
        forward=replace(forward_program(chain, RESERVED), name=chain.name),
        jacobian=replace(jacobian_program(chain, RESERVED), name=chain.name),
        policy=policy_of(chain, solver, DOUBLE.tolerances),
        length_unit=arm.length_unit,
        links=link_table(arm),
        arm_angle=None,
        precision=DOUBLE,
    )


def kernel_by(chain: Chain, method: str) -> GeneralKernel:
    """The general kernel of an arm, which is solved by this method."""
    kernel = general_kernel(chain)
    assert kernel is not None
    assert kernel.method == method
    return kernel


def compiled(module: SolverModule, folder: Path) -> CompiledSolver:
    """Its C, written there and compiled."""
    write_files(folder, {**c_files(module), **c_runtime_files()})
    return library(module, folder)


def poses(chain: Chain, count: int, seed: int) -> list[np.ndarray]:
    q = np.random.default_rng(seed).uniform(-1.5, 1.5, (count, chain.dof))
    return [np.asarray(numeric_arm(chain).pose(row)) for row in q]


def alike(rows: np.ndarray, others: np.ndarray, turning: np.ndarray) -> np.ndarray:
    """Which rows are which others, whole turns aside."""
    gap = rows[:, None] - others[None]
    turned = np.remainder(gap + np.pi, 2 * np.pi) - np.pi
    return np.asarray(np.abs(np.where(turning, turned, gap)).max(axis=2) < 1e-6)


def assert_all_solutions(robot: Robot, kernel: GeneralKernel, poses: Sequence[np.ndarray]) -> None:
    """All solutions, with a certificate, and those that the oracle finds, one to one."""
    chain = build_chain(robot)
    turning = np.array([joint.kind is JointKind.REVOLUTE for joint in chain.joints])
    for T in poses:
        found = solve(T, kernel)
        q = joint_values(found.q, chain)
        assert is_complete(T, kernel)
        assert 2 <= len(q) <= kernel.rows
        np.testing.assert_allclose(numeric_arm(chain).pose(q) - T, 0.0, atol=1e-9)
        same = alike(q, all_solutions(robot, T), turning)
        assert same.shape[0] == same.shape[1]
        assert (same.sum(axis=0) == 1).all()
        assert (same.sum(axis=1) == 1).all()
