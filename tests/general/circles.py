"""The runtime's roots on the circle, in plain Python, of polynomials that tests make up."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from dhgen.runtime.plain import plain
from dhgen.runtime.python.general.tables import HALF_CELLS, SAMPLE_C, SAMPLE_S

if TYPE_CHECKING:
    from collections.abc import Callable

    At = Callable[[np.ndarray, np.ndarray], np.ndarray]


@dataclass(frozen=True, slots=True)
class Roots:
    """Roots [rad] by their kinds.

    Attributes:
        simple: Where the polynomial changes its sign.
        double: Where it may touch zero.
        lifted: Where it turns back beside zero.
        unseen: Where a closer look shows none.
        complete: Whether these are certainly all.
    """

    simple: tuple[float, ...]
    double: tuple[float, ...]
    lifted: tuple[float, ...]
    unseen: tuple[float, ...]
    complete: bool


def _found(roots: np.ndarray, counts: np.ndarray) -> Roots:
    end = counts[1] + counts[4]
    return Roots(
        simple=tuple(roots[0, : counts[0]].tolist()),
        double=tuple(roots[1, : counts[1]].tolist()),
        lifted=tuple(roots[2, : counts[2]].tolist()),
        unseen=tuple(roots[1, counts[1] : end].tolist()),
        complete=counts[3] == 1,
    )


def noise(samples: np.ndarray) -> float:
    """The harmonics beyond the eighth over the largest sample."""
    return float(plain("general.circle").fit(samples)[2])


def roots(samples: np.ndarray, x: float = 0.0, y: float = 0.0) -> Roots:
    """What samples alone show, through a lens if there is one."""
    module: Any = plain("general.roots")
    _, found, counts = module._seen(samples, x, y, 0, HALF_CELLS, module.LIFTED_BY)
    return _found(found, counts)


def real_roots(at: At, vanishes: Callable[[float], bool] = lambda _: True) -> Roots | None:
    """What there is with closer looks at values; None of a polynomial that vanishes identically.

    Args:
        at: Values from the cosines and sines of angles.
        vanishes: Whether what they are computed from allows a root at an angle.
    """
    module: Any = plain("general.roots")

    def sample(*arguments: Any) -> None:
        *_, x, y, samples = arguments
        c, s, weight = module.through(x, y, SAMPLE_C, SAMPLE_S)
        samples[:] = at(c, s) * weight

    def keep(_: int, __: np.ndarray, angles: np.ndarray, count: int) -> int:
        kept = [angle for angle in angles[:count].tolist() if vanishes(angle)]
        angles[: len(kept)] = kept
        return len(kept)

    nothing, joints = np.empty((0, 0)), np.zeros(6, np.int64)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module, "sample", sample)
        patch.setattr(module, "keep_vanishing", keep)
        good, found, counts = module.real_roots(nothing, 0, nothing, joints, nothing, nothing)
    return _found(found, counts) if good else None
