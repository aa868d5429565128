"""A robot's solver for a GPU that is not there: arrays of a library, solved on the CPU.

It stands in the place of `dhgen_cuda.cuda`, so that all that happens around it is the library's.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from dhgen.runtime.helpers import dhgen_cuda, dhgen_grad

if TYPE_CHECKING:
    from collections.abc import Callable

    import pytest


@dataclass(frozen=True, slots=True)
class Solver:
    """What `dhgen_cuda.Solver` is to derivatives.

    Attributes:
        arm: The module that solves.
        kind: The type that arrays have to have.
        made: An array of the library, of NumPy's.
        calls: Is told what was called.
    """

    arm: Any
    kind: type
    made: Callable[[Any], Any]
    calls: list[str]

    def _of(self, name: str, *arrays: Any) -> Any:
        self.calls.append(name)
        assert all(isinstance(each, self.kind) for each in arrays)
        assert not any(getattr(each, "requires_grad", False) for each in arrays)
        return getattr(self.arm, name)(*(np.from_dlpack(each) for each in arrays))

    def ik_batch(self, *arrays: Any) -> tuple[Any, Any]:
        assert arrays[0].ndim == 3
        q, status = self._of("ik_batch", *arrays)
        return self.made(q), self.made(status)

    def jacobian(self, q: Any) -> Any:
        assert q.ndim == 2
        return self.made(self._of("jacobian", q))

    def fk(self, q: Any) -> Any:
        assert q.ndim == 2
        return self.made(self._of("fk", q))


def pretend(monkeypatch: pytest.MonkeyPatch, kind: type, made: Callable[[Any], Any]) -> list[str]:
    """Lets arrays of a library live on a GPU; what is called there comes to be in the list."""
    calls: list[str] = []
    monkeypatch.setattr(dhgen_grad, "on_gpu", lambda array: isinstance(array, kind))
    monkeypatch.setattr(dhgen_cuda, "cuda", lambda arm: Solver(arm, kind, made, calls))
    return calls
