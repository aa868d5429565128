"""The arctangent of the runtime: error, quadrants, signed zeros, NaN; plain and compiled."""

from __future__ import annotations

import math
import re
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any

import mpmath
import numpy as np
import pytest
from numba import njit

from dhgen.runtime.python import angles
from tests.runtime.arctangent import STEEP, arctangent_coefficients
from tests.runtime.plain import part

if TYPE_CHECKING:
    from collections.abc import Callable

    from dhgen.arrays import FloatArray


ULPS = 3.0  # the stated error; libraries differ in the directions that are asked


def plain() -> Any:
    return part("plain", "angles").atan2


def compiled() -> Any:
    """With the products and sums in one rounding, as the modules are compiled."""
    return njit(error_model="numpy", fastmath={"contract"})(plain())


def arguments() -> FloatArray:
    """All directions, near the axes and the diagonals too, and all lengths."""
    source = np.random.default_rng(91)
    angles = source.uniform(-math.pi, math.pi, 3000)
    eighths = source.integers(-8, 9, 3000) * (math.pi / 8)
    near = eighths + source.choice([-1, 1], 3000) * 10.0 ** source.uniform(-17, -1, 3000)
    turned = np.concatenate([angles, near])
    lengths = 10.0 ** source.uniform(-150, 150, len(turned))
    tiny = 10.0 ** source.uniform(-300, 0, (2000, 2)) * source.choice([-1, 1], (2000, 2))
    return np.concatenate([np.stack([np.sin(turned), np.cos(turned)], 1) * lengths[:, None], tiny])


def test_the_coefficients_are_those_of_the_interpolation() -> None:
    text = Path(str(angles.__file__)).read_text(encoding="utf-8")
    told = re.findall(r"p = (?:p \* u )?(\+|-) ?([\d.]+)$", text, re.MULTILINE)
    found = [float(sign + digits) for sign, digits in told]
    assert tuple(reversed(found)) == arctangent_coefficients()
    assert f"near > {STEEP!r} * far" in text


@pytest.mark.parametrize("made", [plain, compiled])
def test_error(made: Callable[[], Any]) -> None:
    function = made()
    worst = 0.0
    with mpmath.workprec(120):
        for y, x in arguments().tolist():
            exact = mpmath.atan2(y, x)
            got = function(y, x)
            worst = max(worst, abs(float((got - exact) / math.ulp(float(exact)))))
    assert worst < ULPS


@pytest.mark.parametrize("made", [plain, compiled])
def test_zeros_axes_and_nan(made: Callable[[], Any]) -> None:
    function = made()
    for y, x in product((0.0, -0.0, 1.5, -1.5), repeat=2):
        wanted = math.atan2(y, x)
        assert function(y, x) == wanted, (y, x)
        assert math.copysign(1.0, function(y, x)) == math.copysign(1.0, wanted), (y, x)
    for y, x in ((math.nan, 1.0), (1.0, math.nan), (math.nan, 0.0), (0.0, math.nan)):
        assert math.isnan(function(y, x))
