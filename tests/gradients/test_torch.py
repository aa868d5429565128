"""Gradients in PyTorch: checked by its own differences along motions of a rigid body."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from dhgen.runtime.helpers import dhgen_grad
from tests.gradients.moves import POSTURES, inputs, move, robot
from tests.gradients.on_gpu import pretend

torch: Any = pytest.importorskip("torch", reason="PyTorch is not installed: it is gigabytes")
# What twists keep an arm's poses among those that it can take.
TWISTS = {"scara": (0, 1, 2, 5), "abb_irb460": (0, 1, 2, 5)}


def tensor(values: Any, *, wanted: bool = False) -> Any:
    return torch.tensor(np.asarray(values).tolist(), dtype=torch.float64, requires_grad=wanted)


def moved(T: Any, twist: Any) -> Any:
    """A pose after a twist, by the exponential of what its origin's velocity and w x are."""
    v, w = twist[:3], twist[3:]
    zero = 0.0 * v[0]
    across = torch.stack([zero, -w[2], w[1], w[2], zero, -w[0], -w[1], w[0], zero]).reshape(3, 3)
    R = torch.matrix_exp(across) @ T[:3, :3]
    top = torch.cat([R, (T[:3, 3] + v)[:, None]], 1)
    return torch.cat([top, T[3:]], 0)


@pytest.mark.parametrize("name", POSTURES)
def test_gradients_of_poses_on_the_move(name: str) -> None:
    T, *given = map(tensor, inputs(name, np.array([POSTURES[name]])))
    ik, axes = dhgen_grad.torch_ik(robot(name)), TWISTS.get(name, range(6))

    def rows(twist: Any, *q_free: Any) -> Any:
        whole = twist @ torch.eye(6, dtype=torch.float64)[list(axes)]
        q, status = ik(moved(T[0], whole), *q_free)
        assert not status.requires_grad
        return torch.where(dhgen_grad.solved(status), q, 0.0)

    start = tensor(np.zeros(len(axes)), wanted=True)
    at = [each[0].clone().requires_grad_() for each in given]
    assert torch.autograd.gradcheck(rows, (start, *at), eps=1e-6, atol=1e-6)


def test_stacks_and_single_precision() -> None:
    arm, (T, *_) = robot("ur5"), move("ur5").given
    ik = dhgen_grad.torch_ik(arm)
    whole = tensor(T, wanted=True)
    q, status = ik(whole.reshape(4, 5, 4, 4))
    assert (q.shape, status.shape, status.dtype) == ((4, 5, 8, 6), (4, 5, 8), torch.uint8)
    expected = arm.ik_batch(T)
    assert q.reshape(20, 8, 6).tolist() == expected[0].tolist()
    torch.where(dhgen_grad.solved(status), q, 0.0).square().sum().backward()
    single = torch.tensor(T.tolist(), dtype=torch.float32, requires_grad=True)
    rounded, status = ik(single)
    assert rounded.dtype == torch.float32
    torch.where(dhgen_grad.solved(status), rounded, 0.0).square().sum().backward()
    assert single.grad.dtype == torch.float32
    np.testing.assert_allclose(single.grad.tolist(), whole.grad.tolist(), atol=1e-3)


def test_nothing_comes_back_from_rows_without_a_solution() -> None:
    """A loss of NaN in them has gradients of NaN there, which go no further."""
    far = robot("ur5").fk(POSTURES["ur5"])
    far[0, 3] = 5.0
    T = tensor(far, wanted=True)
    q, _ = dhgen_grad.torch_ik(robot("ur5"))(T)
    q.square().sum().backward()
    assert T.grad.tolist() == np.zeros((4, 4)).tolist()


def test_gradients_are_of_the_first_order() -> None:
    T = tensor(robot("ur5").fk(POSTURES["ur5"]), wanted=True)
    q, status = dhgen_grad.torch_ik(robot("ur5"))(T)
    loss = torch.where(dhgen_grad.solved(status), q, 0.0).square().sum()
    (gradient,) = torch.autograd.grad(loss, T, create_graph=True)
    with pytest.raises(RuntimeError, match="once_differentiable"):
        gradient.sum().backward()


@pytest.mark.parametrize("name", ["ur5", "kuka_iiwa14", "welding_5r", "abb_irb460"])
def test_on_a_gpu_the_library_calculates(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    found = []
    calls: list[str] = []
    for there in (False, True):
        if there:
            calls = pretend(monkeypatch, torch.Tensor, torch.from_dlpack)
        given = [tensor(each, wanted=True) for each in move(name).given]
        q, status = dhgen_grad.torch_ik(robot(name))(*given)
        weights = torch.cos(torch.arange(q.numel(), dtype=torch.float64)).reshape(q.shape)
        (torch.where(dhgen_grad.solved(status), q, 0.0) * weights).sum().backward()
        found.append([each.grad for each in given])
    assert calls[:2] == ["ik_batch", "jacobian"]
    for here, other in zip(*found, strict=True):
        np.testing.assert_allclose(other.tolist(), here.tolist(), atol=1e-10)
