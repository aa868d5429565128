"""What dhgen says of mistakes in Python: in Python's words, with what was handed over."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import dhgen
from tests.library.arms import PLANAR
from tests.library.test_load import ARM, IIWA, TWO_ARMS, UR5


def with_rows(*rows: dict[str, Any], **keys: object) -> dict[str, Any]:
    """Two links with other rows."""
    return {**PLANAR, "parameters": {}, "joints": list(rows), **keys}


@pytest.mark.parametrize("source", [5, None, [PLANAR], 1.5])
def test_what_is_no_path_and_no_dict_is_named(source: Any) -> None:
    told = f"load takes a path, or a dict with keys of a robot file, not {type(source).__name__} "
    with pytest.raises(dhgen.CommandError, match=re.escape(told)):
        dhgen.load(source)


@pytest.mark.parametrize("snap", ["x", "1e-3", [1e-3], math.nan, True + 1j])
def test_a_tolerance_is_a_number(snap: Any) -> None:
    told = f"snap must be a number from 0 to 0.01, not {snap!r}"
    with pytest.raises(dhgen.CommandError, match=f"^{re.escape(told)}$"):
        dhgen.load(UR5, snap=snap)


@pytest.mark.parametrize(
    ("q", "told"),
    [
        (["a", 0], "q must hold real numbers, with shape (2,)"),
        ([None, 0], "q must hold real numbers, with shape (2,)"),
        ([0, 0, 0], "q must hold 2 joint values, with shape (2,) or (..., 2), not (3,)"),
        (0.3, "q must hold 2 joint values, with shape (2,) or (..., 2), not ()"),
        (np.zeros((2, 3)), "q must hold 2 joint values, with shape (2,) or (..., 2), not (2, 3)"),
    ],
)
@pytest.mark.parametrize("function", ["fk", "jacobian", "frames"])
def test_joint_values_that_are_none(arm: dhgen.Arm, function: str, q: Any, told: str) -> None:
    with pytest.raises(ValueError, match=f"^{re.escape(told)}$"):
        getattr(arm, function)(q)


def notes_of(error: BaseException) -> str:
    """What stands below an exception's text."""
    return "\n".join(getattr(error, "__notes__", []))


def test_options_that_the_command_advises_are_said_in_python(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("two.urdf").write_text(TWO_ARMS.format(ARM.format("left") + ARM.format("right")))
    with pytest.raises(dhgen.RobotFileError) as refused:
        dhgen.load("two.urdf")
    assert notes_of(refused.value).splitlines() == [
        "in Python:",
        "    dhgen.load('two.urdf', base='body', tip='left_fore')",
        "    dhgen.load('two.urdf', base='body', tip='right_fore')",
    ]
    assert dhgen.load("two.urdf", base="body", tip="left_fore").dof == 2
    with pytest.raises(dhgen.RobotFileError) as nowhere:
        dhgen.load("two.urdf", base="left_fore")
    assert "in Python:\n    dhgen.load('two.urdf', tip='LINK')" in notes_of(nowhere.value)


def test_an_arm_that_needs_the_numerical_solver_says_so_in_python(tmp_path: Path) -> None:
    four = {**PLANAR, "joints": PLANAR["joints"] * 2}
    path = tmp_path / "four.yaml"
    path.write_text(dhgen.load(four).text, encoding="utf-8")
    for source, shown in ((four, "..."), (path, repr(str(path)))):
        with pytest.raises(dhgen.UnsolvedError, match="--numerical would give") as refused:
            dhgen.load(source).derivation()
        assert f"in Python:\n    dhgen.load({shown}, numerical=True)" in notes_of(refused.value)


def test_an_arm_angle_is_what_is_free() -> None:
    assert dhgen.load(IIWA, free="arm_angle").free == "arm_angle"
    assert dhgen.load(IIWA, free=[3]).free == (3,)


def test_limits_that_an_arm_has_are_taken_back() -> None:
    arm = dhgen.load(PLANAR)
    rows = [
        dict(row, limits=ends) for row, ends in zip(PLANAR["joints"], arm.joint_limits, strict=True)
    ]
    again = dhgen.load({**PLANAR, "joints": rows})
    assert again.joint_limits == arm.joint_limits
    assert again.joint_limits[1] == (-math.inf, math.inf)
    for ends in ([-np.inf, np.inf], np.array([-np.inf, np.inf]), (-math.inf, math.inf)):
        rows[1]["limits"] = ends
        assert dhgen.load({**PLANAR, "joints": rows}).joint_limits == arm.joint_limits
    rows[1]["limits"] = [-1.0, math.inf]
    with pytest.raises(
        dhgen.RobotFileError, match=r"joints\[1\].limits\[1\]: 'inf' is not a number"
    ):
        dhgen.load({**PLANAR, "joints": rows})


def test_a_sum_that_stands_alone_is_told_to_be_a_list() -> None:
    one = {"of": "q1 + q2", "from": "-1", "to": "1"}
    with pytest.raises(dhgen.RobotFileError) as refused:
        dhgen.load({**PLANAR, "limits": one})
    told = "limits: expected a list of sums, e.g. [{of: q2 + q3, from: -80 deg, to: 150 deg}], not "
    assert str(refused.value).startswith(told)
    assert dhgen.load({**PLANAR, "limits": [one]}).file.robot.sums


@pytest.mark.parametrize(
    ("cell", "told"),
    [
        ("q2 + q1", "the variable of this row is called q here: write q for q2"),
        ("q + joint1", "unknown name 'joint1'; valid: q, q1, pi, deg, sqrt, sin, cos"),
        ("q + 150 dgr", "'dgr' is no unit: degrees are written '150 deg'"),
        ("q + 2 m1", "'m1' is no unit: a number stands alone, or before deg"),
    ],
)
def test_cells_that_nearly_say_what_is_meant(cell: str, told: str) -> None:
    with pytest.raises(dhgen.RobotFileError) as refused:
        dhgen.load(with_rows({"theta": "q", "a": 0.4}, {"theta": cell, "a": 0.3}))
    assert str(refused.value).startswith(f"joints[1].theta: {told}")


def test_one_angle_of_many_turns_is_noted() -> None:
    arm = dhgen.load(with_rows({"theta": "q", "a": 0.4, "limits": [-160, 1]}, {"theta": "q"}))
    (note,) = arm.notes
    assert note.endswith("'-160' is 25.5 turns: write -160 deg if degrees are meant")
    assert f"note: {note}" in str(arm)


@pytest.mark.parametrize(
    ("option", "told"),
    [
        ({"native": 3}, "native is True or False, not 3"),
        ({"native": "no"}, "native is True or False, not 'no'"),
        ({"progress": 3}, "progress takes a function of a text, or None, not 3"),
    ],
)
def test_options_of_a_build_are_what_they_should_be(option: dict[str, Any], told: str) -> None:
    """Found before anything is built, which takes a minute."""
    arm = dhgen.load(with_rows({"theta": "q", "a": 0.4}, {"theta": "q", "a": 0.3}))
    with pytest.raises(dhgen.CommandError, match=re.escape(told)):
        arm.build(**option)


def test_frames_are_those_of_the_built_solver(solver: dhgen.Solver) -> None:
    q = np.random.default_rng(4).uniform(-1, 1, (5, solver.arm.dof))
    frames = solver.arm.frames(q)
    assert frames.shape == (5, solver.arm.dof + 2, 4, 4)
    np.testing.assert_array_equal(frames, solver.frames(q))
    np.testing.assert_allclose(frames[:, -1], solver.arm.fk(q), atol=1e-15)
