"""A library of arrays on a GPU that keeps its stream to itself: it is reached by DLPack alone.

Its arrays are addresses of memory that is not there. It counts who holds each, as the deleters of
its capsules say, and writes down which streams were to be in order.
"""

from __future__ import annotations

import ctypes
from dataclasses import dataclass, field
from typing import Any

from dhgen.runtime.helpers.dhgen_arrays import _Tensor

OWN_STREAM = 9
GPU, CPU = 2, 1
CODES = {"float64": (2, 64), "float32": (2, 32), "uint8": (1, 8), "int32": (0, 32)}
_Deleter = ctypes.CFUNCTYPE(None, ctypes.c_void_p)
_Destructor = ctypes.CFUNCTYPE(None, ctypes.c_void_p)
_api = ctypes.pythonapi
_new = ctypes.PYFUNCTYPE(ctypes.py_object, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_void_p)(
    ("PyCapsule_New", _api)
)
_held = ctypes.PYFUNCTYPE(ctypes.c_void_p, ctypes.c_void_p, ctypes.c_char_p)(
    ("PyCapsule_GetPointer", _api)
)


class Managed(ctypes.Structure):
    """DLManagedTensor."""

    _fields_ = (("tensor", _Tensor), ("context", ctypes.c_void_p), ("deleter", _Deleter))


def _end_unused(capsule: int) -> None:
    """A capsule ends that nobody took over: its deleter is called on its behalf."""
    place = _held(capsule, b"dltensor")
    Managed.from_address(place).deleter(place)


def _delete(place: int) -> None:
    """Whoever held the array lets go of it."""
    wave, _ = _alive.pop(place)
    wave.holders -= 1
    wave.deleted += 1


_unused, _deleter = _Destructor(_end_unused), _Deleter(_delete)
_alive: dict[int, tuple[Wave, Managed]] = {}  # contents of capsules, by their addresses


@dataclass(eq=False)
class Waves:
    """The library: one of them a test."""

    next_place: int = (1 << 40) + 0x10000
    streams: list[int | None] = field(default_factory=list)  # that capsules were asked for
    taken: list[Any] = field(default_factory=list)  # what from_dlpack took over
    float64, float32, uint8, int32 = "float64", "float32", "uint8", "int32"

    def empty(self, shape: tuple[int, ...], *, dtype: str, device: str) -> Wave:
        assert device == "gpu"
        self.next_place += 0x1000
        return Wave(self, shape, dtype, place=self.next_place)

    def from_dlpack(self, other: Any) -> Wave:
        """Takes an array over for the library's own stream: the capsule is used, and kept."""
        assert other.__dlpack_device__() == (GPU, 0)
        capsule = other.__dlpack__(stream=OWN_STREAM)
        told = _Tensor.from_address(_held(id(capsule), b"dltensor"))
        found = Wave(self, tuple(told.shape[: told.axes]), "", place=told.data, keeps=capsule)
        self.taken.append(found)
        return found


@dataclass(eq=False)
class Wave:
    """An array of the library."""

    library: Waves
    shape: tuple[int, ...]
    dtype: str = "float64"
    place: int = (1 << 40) + 0x1000
    strides: tuple[int, ...] | None = None
    offset: int = 0
    where: tuple[int, int] = (GPU, 0)
    keeps: Any = None
    device: str = "gpu"
    holders: int = 0
    deleted: int = 0

    def __array_namespace__(self) -> Waves:
        return self.library

    def __dlpack_device__(self) -> tuple[int, int]:
        return self.where

    def __dlpack__(self, *, stream: int | None = None) -> Any:
        self.library.streams.append(stream)
        axes = len(self.shape)
        content = Managed()
        made = content.tensor
        made.data, made.offset, made.axes = self.place, self.offset, axes
        made.device_type, made.device = self.where
        (made.code, made.bits), made.lanes = CODES[self.dtype], 1
        made.shape = (ctypes.c_int64 * axes)(*self.shape)
        if self.strides is not None:
            made.strides = (ctypes.c_int64 * axes)(*self.strides)

        content.deleter = _deleter
        place = ctypes.addressof(content)
        _alive[place] = (self, content)
        self.holders += 1
        return _new(place, b"dltensor", ctypes.cast(_unused, ctypes.c_void_p))
