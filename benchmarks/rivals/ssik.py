"""ssik (Srinivasa): numeric dispatch, written as a module for the arm, its C++ core underneath."""

from __future__ import annotations

import importlib.util
from typing import TYPE_CHECKING, Any

import numpy as np

from benchmarks.contestant import Contestant, imported, timed, versioned
from benchmarks.screws import screws

if TYPE_CHECKING:
    from pathlib import Path

    from benchmarks.arms import Arm
    from benchmarks.contestant import Run
    from dhgen.arrays import FloatArray

GENERAL = "ikgeo.general_6r"


def contestants(arm: Arm, folder: Path) -> list[Contestant]:
    """One call of the module that `ssik build` writes, all solutions, limits left aside."""
    frame = screws(arm)
    manipulator = imported("ssik").Manipulator.from_axes(frame.directions, frame.offsets)
    artifact = _built(manipulator, arm.case.name, folder)

    def solve(T: FloatArray) -> list[FloatArray]:
        answers = (_solutions(artifact, T) for T in frame.without_home_rotation(T))
        return [np.array([s.q for s in each]).reshape(-1, arm.dof) for each in answers]

    def one(T: FloatArray) -> Run:
        poses = list(frame.without_home_rotation(T))

        def work() -> None:
            for pose in poses:
                _solutions(artifact, pose)

        return timed(work)

    return [Contestant(versioned("ssik"), "one call from Python", solve, one)]


def _built(manipulator: Any, name: str, folder: Path) -> Any:  # noqa: ANN401 - ssik's own types
    path = folder / f"{name}_ssik_ik.py"
    plan = manipulator.dispatch_plan
    if plan.solver_name == GENERAL:  # its wheels carry this table for their arms; C++ needs it
        table = folder / f"{name}_ssik_rr.npz"
        imported("ssik._native").bake_rr_tensor_npz(manipulator.kinbody, str(table))
    imported("ssik.core.codegen").emit_artifact(
        kb=manipulator.kinbody,
        plan=plan,
        module_name=path.stem,
        output_path=str(path),
    )
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _solutions(artifact: Any, pose: FloatArray) -> Any:  # noqa: ANN401 - ssik's own types
    return artifact.solve(pose, respect_limits=False)
