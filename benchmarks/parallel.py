"""Parallel robots: closure of all legs on many poses, both models in a circle, and what they take.

    python -m benchmarks.parallel [--arms NAME ...] [--poses N]

Times are CPU time of the C, compiled anew, of a pose in a batch: the best of some rounds.
"""

from __future__ import annotations

import ctypes
import sys
import tempfile
import time
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from benchmarks.arms import CHECKOUT
from benchmarks.options import parallel_names, parser
from benchmarks.report import table
from dhgen.atomic_write import write_files
from dhgen.oracle.arm import arm
from dhgen.oracle.forward import forward
from dhgen.parallel.compile import ParallelCompilation, compile_file
from dhgen.parallel.native import Native, compiled
from dhgen.parallel.verify import are_inside
from dhgen.parallel.worked import reached, square
from dhgen.robot_files import read_file
from dhgen.runtime.python.platform import drives_of
from dhgen.status import Status

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.arrays import FloatArray
    from dhgen.parallel.module import ParallelModule

FLAGS = {"-O2": ("-O2",), "AVX2": ("-O2", "-march=x86-64-v3"), "native": ("-O3", "-march=native")}
TIMED = ("all joints", "driven")
HEAD = (
    *("robot", "poses", "modes", "closure", "fk back"),
    *(f"{joints}, {each} [ns]" for joints in TIMED for each in FLAGS),
)
ROUNDS = 30
SOME = 960  # poses of a timing
BESIDE = 1e-3  # where the direct model starts [robot sizes]


def main(arguments: list[str]) -> None:
    """Prints a line for every robot."""
    options_of = parser("benchmarks.parallel", __doc__, parallel_names())
    options_of.add_argument("--poses", type=int, default=10_000, metavar="N")
    options = options_of.parse_args(arguments)
    print(table(HEAD, [line(name, options.poses) for name in options.arms]))


def line(name: str, count: int) -> tuple[str, ...]:
    """A robot's line."""
    made = compile_file(read_file(CHECKOUT / "robots" / f"{name}.yaml"))
    assert isinstance(made, ParallelCompilation)
    with tempfile.TemporaryDirectory(prefix="dhgen-") as place:
        folder = Path(place)
        write_files(folder, made.files)
        builds = [built(made.module, folder, flags) for flags in FLAGS.values()]
        times = [
            f"{batch_time(made.module, native, joints):.0f}"
            for joints in TIMED
            for native in builds
        ]
        native = built(made.module, folder, FLAGS["AVX2"])
        poses = within_limits(made.module, native, count)
        modes, closure = closed(made.module, native, poses)
        back = led_back(made.module, native, poses)
    return name, str(count), str(modes), f"{closure:.0e}", f"{back}/{count}", *times


def built(module: ParallelModule, folder: Path, flags: Sequence[str]) -> Native:
    """The C of a robot, compiled."""
    native = compiled(module, folder, flags)
    assert native is not None, "no C compiler"
    return native


def within_limits(module: ParallelModule, native: Native, count: int) -> FloatArray:
    """Poses that all legs reach within limits."""
    poses = reached(module, lambda T: are_inside(native.batch(T)[1]), count, seed=11)
    return np.ascontiguousarray(poses)


def closed(module: ParallelModule, native: Native, poses: FloatArray) -> tuple[int, float]:
    """How many working modes there are, and the largest miss of any row, by the oracle's model."""
    q, status = native.batch(poses)
    worst = 0.0
    lengths = [row for row in module.freedoms if row < 3]
    for number, leg in enumerate(module.legs):
        dof = leg.solver.chain.dof
        rows = q[:, number, :, :dof]
        ends = square(leg.leg.base) @ forward(arm(leg.leg.chain), np.nan_to_num(rows))
        off = np.abs(ends - (poses @ square(leg.leg.end))[:, None])[:, :, lengths, 3]
        worst = max(worst, float(off[~np.isnan(rows).any(axis=2)].max()))
    modes = int((status == Status.OK).sum(axis=2).prod(axis=1).sum())
    return modes, worst / module.size


def led_back(module: ParallelModule, native: Native, poses: FloatArray) -> int:
    """On how many poses the direct model leads back from beside them."""
    back = 0
    for T in poses:
        _, q, status = native.ik(T)
        mode = np.array([rows[told == Status.OK][0] for rows, told in zip(q, status, strict=True)])
        drives = drives_of(module.driven_joints, mode)
        seed = T.copy()
        seed[0, 3] += BESIDE * module.size
        told, found, _ = native.fk(drives, seed)
        back += told >= 0 and bool(np.abs(found - T).max() < 1e-6)
    return back


def batch_time(module: ParallelModule, native: Native, joints: str) -> float:
    """CPU time of a pose in a batch [ns], of all joints or of those that are driven."""
    poses = within_limits(module, native, SOME)
    shape = SOME, len(module.legs), module.rows
    is_whole = joints == TIMED[0]
    solve = native.call_batch if is_whole else native.call_drives_batch
    size = module.joints if is_whole else module.driven
    q, status = np.empty((*shape, size)), np.empty(shape, np.uint8)
    pointers = [each.ctypes.data_as(ctypes.c_void_p) for each in (poses, q, status)]
    best = np.inf
    for _ in range(ROUNDS):
        start = time.process_time_ns()
        solve(SOME, *pointers)
        best = min(best, (time.process_time_ns() - start) / SOME)
    return best


if __name__ == "__main__":
    main(sys.argv[1:])
