"""What `ik_into` is called with: it converts nothing, and says what it cannot take."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numba import njit
from numba.core.errors import TypingError

from tests.generated.solvers import module
from tests.targets.made import in_python

POSE = np.eye(4)
VALUES, STATUSES = np.empty((2, 4)), np.empty(2, np.uint8)
READ_ONLY = np.empty((2, 4))
READ_ONLY.flags.writeable = False
WRONG = [
    ({"T": POSE.astype(np.float32)}, "T must be an array of float64, not float32"),
    ({"T": POSE.astype(int)}, "T must be an array of float64, not int64"),
    ({"T": POSE.tolist()}, "T must be an array of float64, not list"),
    ({"T": None}, "T must be an array of float64, not NoneType"),
    ({"T": 1.5}, "T must be an array of float64, not float"),
    ({"T": POSE[:3]}, r"T must have shape \(4, 4\), not \(3, 4\)"),
    ({"T": POSE[None]}, r"T must have shape \(4, 4\), not \(1, 4, 4\)"),
    ({"q": VALUES.astype(int)}, "q must be an array of float64, not int64"),
    ({"q": VALUES.astype(np.float32)}, "q must be an array of float64, not float32"),
    ({"q": VALUES.astype(complex)}, "q must be an array of float64, not complex128"),
    ({"q": VALUES.ravel()}, r"q must have shape \(2, 4\), not \(8,\)"),
    ({"q": READ_ONLY}, "q and status are filled: they can't be read-only"),
    ({"status": STATUSES.astype(bool)}, "status must be an array of uint8, not bool"),
    ({"status": STATUSES.astype(int)}, "status must be an array of uint8, not int64"),
    ({"status": STATUSES.astype(float)}, "status must be an array of uint8, not float64"),
    ({"status": STATUSES[:1]}, r"status must have shape \(2,\), not \(1,\)"),
    ({"q_seed": np.zeros(4, np.float32)}, "q_seed must be an array of float64, not float32"),
    ({"q_seed": [0.0] * 4}, "q_seed must be an array of float64, not list"),
    ({"q_seed": np.zeros(3)}, r"q_seed must have shape \(4,\), not \(3,\)"),
    ({"q_seed": np.full(4, np.nan)}, "q_seed must be finite"),
]


@pytest.fixture(params=["numba", "plain Python"])
def scara(request: pytest.FixtureRequest) -> Any:
    return module("scara") if request.param == "numba" else in_python("scara")


@pytest.mark.parametrize(("wrong", "told"), WRONG)
def test_what_is_wrong_is_said(scara: Any, wrong: dict[str, Any], told: str) -> None:
    right = {"T": POSE, "q": VALUES, "status": STATUSES, "q_seed": np.zeros(4)}
    with pytest.raises(ValueError, match=told):
        scara.ik_into(**right | wrong)


def test_values_of_free_joints_too() -> None:
    arguments = POSE, np.zeros(1, np.float32), VALUES, STATUSES
    with pytest.raises(ValueError, match="q_free must be an array of float64, not float32"):
        in_python("planar_4r").ik_into(*arguments)


def test_any_layout_serves(scara: Any) -> None:
    T = np.asfortranarray(scara.fk([0.1, 0.7, 0.2, 0.3]))
    T.flags.writeable = False
    q, status = np.asfortranarray(VALUES), np.empty(4, np.uint8)[::2]
    scara.ik_into(T, q, status)
    rows, statuses = scara.ik_all(T)
    assert np.isfinite(rows).all()
    np.testing.assert_array_equal(q, rows)
    np.testing.assert_array_equal(status, statuses)


def test_compiled_callers_are_told_when_they_are_compiled() -> None:
    solve = module("scara").ik_into

    @njit
    def call(T, q, status):  # type: ignore[no-untyped-def]
        return solve(T, q, status)

    with pytest.raises(TypingError, match="where an array of float64 with 2 axes is taken"):
        call(POSE, VALUES.astype(np.float32), STATUSES)
