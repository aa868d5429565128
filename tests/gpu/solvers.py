"""A robot's solver for a GPU that is not there, and what calls itself torch.

In place of NVIDIA's driver there is one that writes down how it is called, driver.c.txt, and arrays
are addresses of memory that is not there.
"""

from __future__ import annotations

from types import ModuleType
from typing import TYPE_CHECKING, Any

from tests.gpu.nvrtc import GENERATED

if TYPE_CHECKING:
    import ctypes

ON_GPU = 1 << 40
STREAM = 77
TYPES = {"float64": "<f8", "float32": "<f4", "uint8": "|u1"}


class Tensor:
    """An array of what calls itself torch."""

    def __init__(self, place: int, shape: tuple[int, ...], kind: str = "<f8") -> None:
        self.device, self.place, self.shape, self.kind = "cuda:0", place, shape, kind
        self.strides: tuple[int, ...] | None = None
        self.stream: int | None = None

    @property
    def __cuda_array_interface__(self) -> dict[str, Any]:
        told = {"typestr": self.kind, "strides": self.strides, "data": (self.place, False)}
        return told | {"shape": self.shape, "stream": self.stream}


def robot(name: str = "scara") -> ModuleType:
    """What is asked of a robot's module."""
    rows, dof, given = {
        "scara": (2, 4, ()),
        "franka_panda": (8, 7, (7,)),
        "cuspidal_3r": (4, 3, ()),
        "xarm6": (16, 6, ()),
    }[name]
    found = ModuleType(name)
    found.__file__ = str(GENERATED / f"{name}.py")
    vars(found).update(NAME=name, DOF=dof, BRANCHES=("",) * rows, ik_all=None)
    if given:
        vars(found).update(FREE_JOINTS=given)
    return found


def poses(n: int, kind: str = "<f8", rows: int = 4) -> Tensor:
    return Tensor(ON_GPU + 0x1000, (n, rows, 4), kind)


def calls(driver: ctypes.CDLL) -> list[str]:
    found: list[str] = driver.calls_so_far().decode().splitlines()
    driver.forget_calls()
    return found


def launches(driver: ctypes.CDLL) -> list[str]:
    """Kernels by their names, and what they were given."""
    found = calls(driver)
    names = dict(call.split(" ", 2)[1:] for call in found if call.startswith("function"))
    told = [call.split(" ", 2)[1:] for call in found if call.startswith("launch")]
    return [f"{names[number]} {rest}" for number, rest in told]
