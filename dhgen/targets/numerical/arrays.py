"""Numbers of joints that are solved for, and of coordinates, as a language writes them."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING

from dhgen.runtime.python.numerical.arm import strides
from dhgen.targets.layout import python_array

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

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
        coordinate: Rows of the coordinates that the task names; empty without any.
        least_u: Bounds; empty where descents have none.
        most_u: The same.
    """

    solved: str
    turning: str
    unit: str
    span_low: str
    span_width: str
    stride: str
    measure: str
    coordinate: str
    least_u: str
    most_u: str


def python_arrays(kernel: NumericalKernel) -> Arrays:
    """Definitions in Python."""

    def written(name: str, values: tuple[str, ...]) -> str:
        return python_array(f"_{name.upper()} = np.array", values)

    return _arrays(kernel, "math.inf", ("False", "True"), written)


def _arrays(
    kernel: NumericalKernel,
    infinity: str,
    truths: tuple[str, str],
    written: Callable[[str, tuple[str, ...]], str],
) -> Arrays:
    size, count = kernel.arm.chain.size, len(kernel.solved)
    words = {inf: infinity, -inf: f"-{infinity}"}

    def array(name: str, values: Iterable[str]) -> str:
        texts = tuple(values)
        return written(name, texts) if texts else ""

    def numbers(name: str, values: Iterable[float]) -> str:
        return array(name, (words.get(value, repr(value)) for value in values))

    return Arrays(
        solved=array("solved", map(str, kernel.solved)),
        turning=array("turning", (truths[turns] for turns in kernel.turns)),
        unit=numbers("unit", kernel.units),
        span_low=numbers("span_low", (low for low, _ in kernel.spans)),
        span_width=numbers("span_width", (high - low for low, high in kernel.spans)),
        stride=numbers("stride", strides(count)),
        measure=numbers("measure", (unit / size for unit in kernel.units if kernel.position)),
        coordinate=array("coordinate", map(str, kernel.position)),
        least_u=numbers("least_u", kernel.lowest if kernel.bounded else ()),
        most_u=numbers("most_u", kernel.highest if kernel.bounded else ()),
    )
