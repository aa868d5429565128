# SPDX-License-Identifier: MIT
"""Arrays on a GPU, of any library: how they are read, made, and handed over in order.

Part of dhgen, which puts a copy of this file beside the robots that it generates.
`dhgen_cuda` calls it for each batch.

PyTorch, CuPy and Warp name the stream that is current, so kernels go there, and everything else on
that stream is in order by itself. Libraries that keep their streams to themselves, as JAX does, are
reached by DLPack's protocol for Python: arrays that kernels read are ready on the kernels' stream,
and those that they write are taken over by the library's own `from_dlpack`, whose stream waits for
the kernels. Their memory is the library's, too: it makes the arrays, which kernels fill.
"""

from __future__ import annotations

import ctypes
import importlib
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypeAlias

if TYPE_CHECKING:
    from collections.abc import Callable

GPUArray: TypeAlias = Any  # of a library that is not known here
KINDS = {"<f8": ("float64", "double"), "<f4": ("float32", "float"), "|u1": ("uint8", "")}
LEGACY = 1  # the stream of a library that names none, in both protocols
_INTERFACE = "__cuda_array_interface__"
_UNORDERED = -1  # in place of a stream: nobody is to wait
_ALIGNED = 16  # bytes that kernels read at once
_ON_GPU = (2, 13)  # DLPack's types of devices: CUDA, and its memory on both sides
_CODES = "iuf"  # DLPack's types of numbers


@dataclass(frozen=True, slots=True)
class Array:
    """What is asked of a caller's array."""

    name: str  # in messages
    pointer: int
    shape: tuple[int, ...]
    kind: str  # of its numbers: <f8

    def demand(self, kind: str, *shape: int) -> None:
        """Raises what is wrong with the type of its numbers, its shape, or where it begins."""
        if self.kind != kind:
            raise TypeError(f"{self.name} must be {KINDS[kind][0]}, not {self.kind}")
        if self.shape != shape:
            raise ValueError(f"{self.name} must be of shape {shape}, not {self.shape}")
        if self.pointer % _ALIGNED:
            raise ValueError(f"{self.name} must begin at a multiple of {_ALIGNED} bytes")

    def number(self) -> str:
        """The type of its numbers, which kernels have to calculate with."""
        if self.kind not in ("<f8", "<f4"):
            raise TypeError(f"{self.name} must be float32 or float64, not {self.kind}")
        return self.kind


class Call:
    """A call's arrays, all of one library, and its stream.

    Attributes:
        stream: The address of the stream that kernels go to.
        handed_over: Whether the library waits for kernels by DLPack alone: arrays that they read or
            write must then live until they have run, in `kept`.
        kept: Such arrays.
    """

    def __init__(self, like: GPUArray, stream: int | None) -> None:
        self._like, self._library = like, _library(like)
        self.handed_over = self._library not in _STREAMS and hasattr(like, "__dlpack__")
        self.stream = self._current() if stream is None else stream
        self.kept: list[GPUArray] = []

    def _current(self) -> int:
        """The stream that kernels go to unless the caller chooses one."""
        if self._library in _STREAMS:
            return _STREAMS[self._library](importlib.import_module(self._library), self._like)
        interface = None if self.handed_over else getattr(self._like, _INTERFACE, None)
        return (interface or {}).get("stream") or LEGACY

    def read(self, owner: GPUArray, name: str) -> Array:
        """An array by its interface, ready on the stream."""
        interface = None if self.handed_over else getattr(owner, _INTERFACE, None)
        if isinstance(interface, dict):
            return _of_interface(interface, name)
        on_gpu = hasattr(owner, "__dlpack_device__") and owner.__dlpack_device__()[0] in _ON_GPU
        if not (self.handed_over and on_gpu):
            what = f"{type(owner).__module__}.{type(owner).__name__}"
            raise TypeError(f"{name} must be an array on a GPU, not {what}")
        capsule = owner.__dlpack__(stream=self.stream)
        self.kept.append(capsule)  # nobody else takes it: its end gives the array free
        return _of_capsule(capsule, name)

    def new(self, shape: tuple[int, ...], kind: str) -> GPUArray:
        """An array of the library and on the GPU of the call's first."""
        name, like = KINDS[kind][0], self._like
        if self._library == "cupy":
            with like.device:
                return importlib.import_module("cupy").empty(shape, name)
        if self._library in _STREAMS:
            library = importlib.import_module(self._library)
        elif self.handed_over and hasattr(like, "__array_namespace__"):
            library = like.__array_namespace__()
        else:
            problem = f"arrays of {self._library} can't be made here"
            raise TypeError(f"{problem}: give those to be written to, out=")
        return library.empty(shape, dtype=getattr(library, name), device=like.device)

    def results(
        self, out: tuple[GPUArray, ...] | None, *wanted: tuple[str, tuple[int, ...], str]
    ) -> tuple[tuple[GPUArray, ...], dict[str, Array]]:
        """The arrays to be written to, and what kernels need of them, by their names.

        Args:
            out: The caller's, if it gives some.
            wanted: Of each a name, a shape, and the type of its numbers.
        """
        if out is not None and self.handed_over:
            problem = f"arrays of {self._library} can't be written to from outside"
            raise TypeError(f"{problem}: leave out=, and new ones come back")
        made = out or tuple(self.new(shape, kind) for _, shape, kind in wanted)
        arrays = {}
        for array, (name, shape, kind) in zip(made, wanted, strict=True):
            arrays[name] = self.read(array, name)
            arrays[name].demand(kind, *shape)
        return made, arrays

    def taken_over(self, made: GPUArray, order: Callable[[int], None]) -> GPUArray:
        """An array whose readers wait for what kernels write to it.

        Args:
            made: It, as the library made it.
            order: Makes a stream wait for the kernels.
        """
        library = made.__array_namespace__()
        return library.from_dlpack(_Ordered(made, self.stream, order))


@dataclass(frozen=True, slots=True)
class _Ordered:
    """An array for `from_dlpack`: whoever takes it over waits for what has been launched."""

    made: GPUArray
    stream: int
    order: Callable[[int], None]

    def __dlpack_device__(self) -> tuple[int, int]:
        where: tuple[int, int] = self.made.__dlpack_device__()
        return where

    def __dlpack__(self, *, stream: int | None = None, **asked: object) -> object:
        reader = LEGACY if stream is None else stream
        if reader not in (self.stream, _UNORDERED):
            self.order(reader)
        return self.made.__dlpack__(stream=stream, **asked)


class _Tensor(ctypes.Structure):
    """DLTensor, as version 0 and 1 of DLPack have it."""

    _fields_ = (
        ("data", ctypes.c_void_p),
        ("device_type", ctypes.c_int32),
        ("device", ctypes.c_int32),
        ("axes", ctypes.c_int32),
        ("code", ctypes.c_uint8),
        ("bits", ctypes.c_uint8),
        ("lanes", ctypes.c_uint16),
        ("shape", ctypes.POINTER(ctypes.c_int64)),
        ("strides", ctypes.POINTER(ctypes.c_int64)),  # in elements
        ("offset", ctypes.c_uint64),  # in bytes
    )


_content = ctypes.PYFUNCTYPE(ctypes.c_void_p, ctypes.py_object, ctypes.c_char_p)(
    ("PyCapsule_GetPointer", ctypes.pythonapi)
)


def _of_capsule(capsule: object, name: str) -> Array:
    """An array by a capsule of DLPack, which keeps it alive."""
    tensor = _Tensor.from_address(_content(capsule, b"dltensor"))
    shape, bits = tuple(tensor.shape[: tensor.axes]), tensor.bits * tensor.lanes
    code = _CODES[tensor.code] if tensor.code < len(_CODES) else "V"
    kind = f"{'|' if bits == 8 else '<'}{code}{bits // 8}"
    if tensor.strides:  # None of a dense array
        _demand_dense(name, shape, tensor.strides[: tensor.axes], 1)
    return Array(name, (tensor.data or 0) + tensor.offset, shape, kind)


def _of_interface(interface: dict[str, Any], name: str) -> Array:
    """An array by NVIDIA's interface, version 3."""
    shape, kind = tuple(interface["shape"]), interface["typestr"]
    if interface.get("strides") is not None:
        _demand_dense(name, shape, interface["strides"], int(kind[2:]))
    return Array(name, interface["data"][0] or 0, shape, kind)


def _demand_dense(name: str, shape: tuple[int, ...], strides: Any, size: int) -> None:  # noqa: ANN401
    """Raises if rows do not lie one after the other; axes of length one may have any stride."""
    dense = (size * math.prod(shape[k + 1 :]) for k in range(len(shape)))
    apart = (length > 1 and a != b for length, a, b in zip(shape, strides, dense, strict=True))
    if any(apart) and 0 not in shape:
        raise TypeError(f"{name} must be contiguous")


def _library(array: GPUArray) -> str:
    return type(array).__module__.partition(".")[0]


# The stream that is current where an array lives, of libraries that name it.
_STREAMS: dict[str, Callable[[Any, GPUArray], int]] = {
    "torch": lambda torch, like: torch.cuda.current_stream(like.device).cuda_stream,
    "cupy": lambda cupy, _: cupy.cuda.get_current_stream().ptr,
    "warp": lambda warp, like: warp.get_stream(like.device).cuda_stream,
}
