"""The Python module's functions around the solver, where numba is absent."""

from __future__ import annotations

import inspect
from typing import Any

import numpy as np
import pytest

from dhgen.oracle.poses import random_joints
from tests.structures import ODD, first_of, one_of_each
from tests.targets.calling import FREE_JOINT, HELD, OK, OUT_OF_LIMITS
from tests.targets.made import NAMES, given, in_python, made, poses_of, robot

EVERY = [*NAMES, *ODD]


@pytest.mark.parametrize("name", one_of_each(EVERY))
def test_facts(name: str) -> None:
    module, arm = in_python(name), robot(name)
    assert (arm.name, len(arm.joints)) == (module.NAME, module.DOF)
    assert "".join(joint.kind.name[0] for joint in arm.joints) == module.JOINT_TYPES
    names = [arm.joints[k].name or f"joint{k + 1}" for k in range(module.DOF)]
    assert list(module.JOINT_NAMES) == names
    limits = [arm.joints[k].limits or (-np.inf, np.inf) for k in range(module.DOF)]
    assert list(module.JOINT_LIMITS) == limits
    assert len(module.BRANCHES) == len(set(module.BRANCHES)) == module.MAX_SOLUTIONS
    assert made(name).module.solver.rows == module.MAX_SOLUTIONS
    assert getattr(module, "FREE_JOINTS", ()) == arm.free


@pytest.mark.parametrize("name", one_of_each(EVERY))
def test_every_way_to_call_gives_the_same_rows(name: str) -> None:
    module = in_python(name)
    q = random_joints(robot(name), 3, seed=61)
    T = poses_of(name, q)
    batch, statuses = module.ik_batch(T, *given(name, q))
    assert batch.shape == (3, module.MAX_SOLUTIONS, module.DOF)
    for k in range(3):
        rows, status = module.ik_all(T[k], *given(name, q[k]))
        into, into_status = np.empty_like(rows), np.empty_like(status)
        count = module.ik_into(T[k], *given(name, q[k]), into, into_status)
        for others, other_status in ((batch[k], statuses[k]), (into, into_status)):
            np.testing.assert_array_equal(rows, others)
            np.testing.assert_array_equal(status, other_status)
        assert count == np.isin(status, (OK, FREE_JOINT)).sum()
        assert module.ik_all(T[k].tolist(), *given(name, q[k]))[1].tolist() == status.tolist()


@pytest.mark.parametrize("name", first_of(["scara", "planar_4r", "puma560"], count=2))
def test_branches_by_name_and_by_row(name: str) -> None:
    module = in_python(name)
    q = random_joints(robot(name), 10, seed=62)
    tried = 0
    for joints, T in zip(q, poses_of(name, q), strict=True):
        rows, status = module.ik_all(T, *given(name, joints))
        for row, branch in enumerate(module.BRANCHES):
            arguments = (T, *given(name, joints), joints)
            if status[row] in {OK, FREE_JOINT}:
                one = module.ik(*arguments, branch=branch)
                np.testing.assert_array_equal(one, module.ik(*arguments, branch=row))
                turns = (one - rows[row]) / (2 * np.pi)
                slides = np.array([kind == "P" for kind in module.JOINT_TYPES])
                np.testing.assert_allclose(
                    np.where(slides, 0, turns - np.round(turns)), 0, atol=1e-12
                )
                tried += 1
            else:
                with pytest.raises(module.Unreachable, match=f"in branch {branch}$"):
                    module.ik(*arguments, branch=branch)
    assert tried >= 5


def test_limits_may_be_left_aside() -> None:
    module = in_python("scara")
    q = np.array([0.3, 0.8, 0.05, 1.0])  # the slide's limits are -0.2 and 0
    T = poses_of("scara", q)
    assert module.ik_all(T)[1].tolist() == [OUT_OF_LIMITS] * 2
    with pytest.raises(module.Unreachable, match=r"^solutions found are beyond the joint limits$"):
        module.ik(T, q)
    np.testing.assert_allclose(module.ik(T, q, limits=False), q, atol=1e-12)
    far = T.copy()
    far[0, 3] = 10.0
    four = r"^the pose is out of reach, or one that 4 joints can't take$"
    with pytest.raises(module.Unreachable, match=four):
        module.ik(far, q)


def read_only(module: Any, which: int) -> Any:
    """Results of an earlier call, of which one can't be written to any more."""
    out = module.ik_batch(np.eye(4)[None])
    out[which].flags.writeable = False
    return out


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda m, T: m.ik_all(T[:3]), r"T must have shape \(4, 4\), not \(3, 4\)"),
        (lambda m, T: m.ik(T[None]), r"T must have shape \(4, 4\), not \(1, 4, 4\)"),
        (lambda m, T: m.ik_batch(T), r"T must have shape \(N, 4, 4\), not \(4, 4\)"),
        (lambda m, T: m.ik_all(T, np.zeros(5)), r"q_seed must have shape \(6,\), not \(5,\)"),
        (lambda m, T: m.ik(T, np.zeros((1, 6))), r"q_seed must have shape \(6,\), not \(1, 6\)"),
        (lambda m, T: m.ik(T, [0, 0, np.nan, 0, 0, 0]), "q_seed must be finite"),
        (
            lambda m, T: m.ik(T, branch="sideways"),
            "no branch 'sideways'; give a row, from 0, or a name: right-down-noflip,",
        ),
        (lambda m, T: m.ik(T, branch=8), "no branch 8; give a row, from 0, or a name: "),
        (lambda m, T: m.ik(T, branch=True), "no branch True; give a row"),
        (lambda m, T: m.ik(T, branch=np.arange(2)), "no branch array"),
        (lambda m, T: m.ik_batch(T[None], cores=True), "cores must be at least 1, or None"),
        (lambda m, T: m.ik((T + np.outer(T[0], T[3])).T), "last row not 0, 0, 0, 1 .is it tr"),
        (lambda m, _: m.fk(0.1), r"q must have shape \(6,\), not \(\)"),
        (lambda m, T: m.ik_all(T, 0.1), r"q_seed must have shape \(6,\), not \(\)"),
        (lambda m, _: m.ik_all(0.1), r"T must have shape \(4, 4\), not \(\)"),
        (lambda m, _: m.ik_batch(0.1), r"T must have shape \(N, 4, 4\), not \(\)"),
        (lambda m, _: m.fk(["0.1"] * 6), "q must hold real numbers, with shape"),
        (lambda m, _: m.fk(np.array(["0.1", *[0.1] * 5], object)), "q must hold real numbers"),
        (lambda m, _: m.fk([b"0.1"] * 6), "q must hold real numbers, with shape"),
        (lambda m, T: m.ik_all(T.astype(str)), "T must hold real numbers, with shape"),
        (lambda m, _: m.fk(np.zeros(6, "M8[s]")), "q must hold real numbers, with shape"),
        (lambda m, T: m.ik_all(T.size * [None]), "T must hold real numbers, with shape"),
        (lambda m, T: m.ik_all(T, [None] * 6), "q_seed must hold real numbers, with shape"),
        (lambda m, T: m.ik_batch(T[None], out=read_only(m, 0)), "q in out .* it is read-only"),
        (lambda m, T: m.ik_batch(T[None], out=read_only(m, 1)), "status in out .* it is read-only"),
        (lambda m, T: m.ik(T, branch=-1), "no branch -1; give a row"),
        (
            lambda m, T: m.ik(2.0 * T),
            "T is not a valid pose: not finite, or not a right-handed rotation",
        ),
    ],
)
def test_mistakes_are_told(call, message: str) -> None:  # type: ignore[no-untyped-def]
    with pytest.raises(ValueError, match=message):
        call(in_python("puma560"), np.eye(4))


def test_a_branch_may_be_a_number_of_numpy() -> None:
    module = in_python("puma560")
    q = np.linspace(0.1, 0.6, 6)
    rows, status = module.ik_all(module.fk(q))
    row = np.flatnonzero(status == module.OK)[-1]
    found = module.ik(module.fk(q), rows[row], branch=row)
    np.testing.assert_allclose(found, rows[row], atol=1e-12)


def test_a_batch_takes_a_value_a_pose_of_one_free_joint() -> None:
    module = in_python("planar_4r")
    T, q_free = np.array([module.fk([0.1 * k] * 4) for k in range(1, 4)]), [0.1, 0.2, 0.3]
    q, status = module.ik_batch(T, np.array(q_free)[:, None])
    assert (status == module.OK).any(axis=1).all()
    for values in (q_free, np.array(q_free), np.array([0.1, 9.0, 0.2, 9.0, 0.3])[::2]):
        others, other_status = module.ik_batch(T, values)
        np.testing.assert_array_equal(others, q)
        np.testing.assert_array_equal(other_status, status)


def test_free_joints_are_checked() -> None:
    module = in_python("planar_4r")
    with pytest.raises(ValueError, match=r"q_free must have shape \(1,\), not \(2,\)"):
        module.ik_all(np.eye(4), np.zeros(2))
    assert module.ik_all(np.eye(4), [np.nan])[1].tolist() == [module.INVALID_POSE] * 2
    with pytest.raises(ValueError, match="the value of a free joint not finite"):
        module.ik(np.eye(4), [np.nan])
    for wrong, told in (np.zeros(2), r"\(2,\)"), (0.1, r"\(\)"), (np.zeros((3, 2)), r"\(3, 2\)"):
        with pytest.raises(ValueError, match=rf"q_free must have shape \(3, 1\), not {told}"):
            module.ik_batch(np.tile(np.eye(4), (3, 1, 1)), wrong)
    T, q, status = np.eye(4), np.empty((2, 4)), np.empty(2, np.uint8)
    assert module.ik_into(T, np.array([np.inf]), q, status) == 0
    assert status.tolist() == [module.INVALID_POSE] * 2


@pytest.mark.parametrize("name", [name for name in EVERY if robot(name).free])
def test_free_joints_keep_the_value_that_is_given(name: str) -> None:
    module = in_python(name)
    q = random_joints(robot(name), 10, seed=63)
    free = [joint - 1 for joint in robot(name).free]
    for joints, T in zip(q, poses_of(name, q), strict=True):
        rows, status = module.ik_all(T, joints[free])
        held = rows[np.isin(status, HELD)]
        assert len(held)
        np.testing.assert_allclose(held[:, free], [joints[free]] * len(held), atol=1e-14)


def test_signatures_are_those_of_the_design() -> None:
    module = in_python("puma560")
    shown = {
        name: str(inspect.signature(getattr(module, name)))
        for name in ("fk", "jacobian", "ik", "ik_all", "ik_batch")
    }
    assert shown == {
        "fk": "(q)",
        "jacobian": "(q)",
        "ik": "(T, q_seed=None, *, branch=None, limits=True)",
        "ik_all": "(T, q_seed=None)",
        "ik_batch": "(T, *, cores=None, out=None)",
    }
    assert str(inspect.signature(in_python("planar_4r").ik_all)) == "(T, q_free=None, q_seed=None)"
