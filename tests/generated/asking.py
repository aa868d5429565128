"""The committed C, asked one pose at a time with a seed."""

from __future__ import annotations

import re
from functools import cache

from dhgen.oracle.arm import arm, arm_size
from dhgen.survey.trial import Trial
from tests.generated.solvers import GENERATED, NAMES, library, robot


@cache
def trial(name: str) -> Trial:
    """The solver with its measures."""
    return Trial(robot(name), arm(robot(name)), arm_size(robot(name)), library(name))


def labels(name: str) -> list[str]:
    """What the rows are called."""
    text = (GENERATED / f"{name}.c").read_text(encoding="utf-8")
    found = re.search(rf"{name}_branches\[\d+\] = \{{(.*?)\}};", text, re.DOTALL)
    assert found is not None
    return re.findall(r'"([^"]*)"', found[1])


# Rows of these arms are roots of a polynomial: they have an order, but no meaning to keep.
POLYNOMIAL = frozenset(name for name in NAMES if any("root" in label for label in labels(name)))
GENERAL = frozenset(name for name in NAMES if "root16" in labels(name))
