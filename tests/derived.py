"""Derivations that a process makes once: tests of many folders ask for those of the same robots."""

from __future__ import annotations

from functools import cache
from typing import TYPE_CHECKING

from dhgen.paul.derive import derive

if TYPE_CHECKING:
    from collections.abc import Sequence

    from dhgen.kinematics.chain import Chain
    from dhgen.paul.derivation import Derivation


def derived(chain: Chain, *, numerical: bool = False, steps: Sequence[int] = ()) -> Derivation:
    """What `derive` gives for an arm. Who changes how it works calls that itself."""
    return _derived(chain, numerical, tuple(steps))


@cache
def _derived(chain: Chain, numerical: bool, steps: tuple[int, ...]) -> Derivation:  # noqa: FBT001
    return derive(chain, numerical=numerical, steps=steps)
