"""The C of a parallel robot, compiled: its functions with arrays as Python's have them."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.errors import VerificationError
from dhgen.status import Status
from dhgen.verify.native import c_compiler, complaints_of

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from numpy.typing import NDArray

    from dhgen.arrays import FloatArray
    from dhgen.parallel.module import ParallelModule

    Statuses = NDArray[np.uint8]


class Native:
    """The compiled functions of a parallel robot, with arrays as Python's have them."""

    def __init__(self, module: ParallelModule, library: Any) -> None:  # noqa: ANN401
        self._library = library
        self._name = module.name
        self._shape = len(module.legs), module.rows, module.joints
        self._driven = len(module.legs), module.rows, module.driven
        self._drives = module.robot.drives

    def _call(self, function: str, *arrays: FloatArray | None) -> int:
        pointers = [None if a is None else a.ctypes.data_as(ctypes.c_void_p) for a in arrays]
        return int(self._library[f"{self._name}_{function}"](*pointers))

    def ik(self, T: FloatArray) -> tuple[int, FloatArray, Statuses]:
        """How many working modes there are, q and status."""
        q, status = np.empty(self._shape), np.empty(self._shape[:2], np.uint8)
        return self._call("ik", np.ascontiguousarray(T), None, q, status), q, status

    def nearest(self, T: FloatArray, seed: FloatArray) -> tuple[int, FloatArray]:
        """What ik_nearest returns, and q."""
        q = np.empty((self._shape[0], self._shape[2]))
        pose = np.ascontiguousarray(T)
        return self._call("ik_nearest", pose, np.ascontiguousarray(seed), q), q

    def batch(self, T: FloatArray) -> tuple[FloatArray, Statuses]:
        """All q and statuses."""
        q = np.empty((len(T), *self._shape))
        status = np.empty((len(T), *self._shape[:2]), np.uint8)
        poses = np.ascontiguousarray(T)
        self.call_batch(
            len(T), *(each.ctypes.data_as(ctypes.c_void_p) for each in (poses, q, status))
        )
        return q, status

    def ik_drives(self, T: FloatArray) -> tuple[int, FloatArray, Statuses]:
        """How many working modes there are, the driven joints of all rows, and status."""
        q, status = np.empty(self._driven), np.empty(self._shape[:2], np.uint8)
        return self._call("ik_drives", np.ascontiguousarray(T), q, status), q, status

    def drives_batch(self, T: FloatArray) -> tuple[FloatArray, Statuses]:
        """The same of many poses."""
        q = np.empty((len(T), *self._driven))
        status = np.empty((len(T), *self._shape[:2]), np.uint8)
        poses = np.ascontiguousarray(T)
        self.call_drives_batch(
            len(T), *(each.ctypes.data_as(ctypes.c_void_p) for each in (poses, q, status))
        )
        return q, status

    def call_drives_batch(self, count: int, *arrays: ctypes.c_void_p) -> None:
        """ik_drives_batch of poses, q and status by their addresses."""
        self._library[f"{self._name}_ik_drives_batch"](ctypes.c_size_t(count), *arrays)

    def call_batch(self, count: int, *arrays: ctypes.c_void_p) -> None:
        """ik_batch of poses, q and status by their addresses."""
        self._library[f"{self._name}_ik_batch"](ctypes.c_size_t(count), *arrays)

    def fk(self, drives: FloatArray, seed: FloatArray) -> tuple[int, FloatArray, FloatArray]:
        """What fk returns, the pose and q."""
        T, q = np.empty((4, 4)), np.empty((self._shape[0], self._shape[2]))
        return self._call("fk", drives, np.ascontiguousarray(seed), T, q), T, q

    def assemblies(self, drives: FloatArray) -> FloatArray:
        """All poses of drives' values.

        Raises:
            ValueError: They are a continuum, or the drives are not finite; the status is in the
                message.
        """
        T = np.empty((6, 4, 4))
        count = self._call("assemblies", drives, T)
        if count < 0:
            raise ValueError(Status(-count).name)
        return T[:count]

    def velocities(self, T: FloatArray, q: FloatArray) -> tuple[FloatArray, FloatArray]:
        """A and B."""
        A, B = np.empty((2, self._drives, self._drives))
        self._call("velocities", np.ascontiguousarray(T), np.ascontiguousarray(q), A, B)
        return A, B

    def singularities(self, T: FloatArray, q: FloatArray) -> FloatArray:
        """The smallest singular values of B and A."""
        least = np.empty(2)
        self._call("singularities", np.ascontiguousarray(T), np.ascontiguousarray(q), least)
        return least


def compiled(
    module: ParallelModule,
    folder: Path,
    flags: Sequence[str] = ("-O1",),
    compiler: str | None = None,
) -> Native | None:
    """The C of a robot and its legs, warnings as errors; None without a compiler.

    Args:
        module: The robot.
        folder: Where its files are, and the library goes.
        flags: For the compiler.
        compiler: Its path, if it is not the first one found.

    Raises:
        VerificationError: The compiler refuses the files.
    """
    compiler = compiler or c_compiler()
    if compiler is None:
        return None
    names = [module.name, *(chain.name for chain in module.robot.chains)]
    sources = [folder / f"{name}.c" for name in names]
    library = folder / f"{module.name}{len(list(folder.glob('*.so')))}.so"
    if complaints := complaints_of(compiler, flags, sources, library):
        raise VerificationError(f"{module.name}.c does not compile:\n{complaints}")
    return Native(module, ctypes.CDLL(str(library)))
