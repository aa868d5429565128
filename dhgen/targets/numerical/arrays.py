"""Numbers of joints that are solved for, as Python writes them."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING

from dhgen.runtime.python.numerical.arm import strides
from dhgen.targets.layout import python_array

if TYPE_CHECKING:
    from collections.abc import Iterable

    from dhgen.numerical.kernel import NumericalKernel


@dataclass(frozen=True, slots=True)
class Arrays:
    """Definitions of arrays.

    Attributes:
        solved: Places of the joints that are solved for.
        turning: Which of them turn.
        unit: What a step of one means for them.
        span_low: Where the ranges begin in which descents start.
        span_width: How wide these are.
        stride: From one start to the next, in parts of a range.
        measure: What a step of one moves, in arm sizes; empty where no coordinate counts.
    """

    solved: str
    turning: str
    unit: str
    span_low: str
    span_width: str
    stride: str
    measure: str


def python_arrays(kernel: NumericalKernel) -> Arrays:
    """Definitions in Python."""
    size, count = kernel.arm.chain.size, len(kernel.solved)
    return Arrays(
        solved=_array("solved", map(str, kernel.solved)),
        turning=_array("turning", map(str, kernel.turns)),
        unit=_numbers("unit", kernel.units),
        span_low=_numbers("span_low", (low for low, _ in kernel.spans)),
        span_width=_numbers("span_width", (high - low for low, high in kernel.spans)),
        stride=_numbers("stride", strides(count)),
        measure=_numbers("measure", (unit / size for unit in kernel.units if kernel.position)),
    )


def _array(name: str, values: Iterable[str]) -> str:
    texts = tuple(values)
    return python_array(f"_{name.upper()} = np.array", texts) if texts else ""


def _numbers(name: str, values: Iterable[float]) -> str:
    words = {inf: "math.inf", -inf: "-math.inf"}
    return _array(name, (words.get(value, repr(value)) for value in values))
