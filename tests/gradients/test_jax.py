"""Derivatives in JAX, both ways, in jit and vmap."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from dhgen.runtime.helpers import dhgen_grad
from tests.gradients.moves import POSTURES, move, robot
from tests.gradients.on_gpu import pretend
from tests.structures import quick_first

if TYPE_CHECKING:
    from collections.abc import Iterator

jax: Any = pytest.importorskip("jax", reason="JAX is not installed")


@pytest.fixture(autouse=True)
def _doubles() -> Iterator[None]:
    before = jax.config.jax_enable_x64
    jax.config.update("jax_enable_x64", True)  # noqa: FBT003
    yield
    jax.config.update("jax_enable_x64", before)


def loss(ik: Any, weights: Any, *given: Any) -> Any:
    """A number that every row with a solution has a part in."""
    q, status = ik(*given)
    return (jax.numpy.where(dhgen_grad.solved(status), q, 0.0) * weights).sum()


@pytest.mark.parametrize("name", POSTURES)
def test_rows_move_as_their_derivatives_say(name: str) -> None:
    moved = move(name, 4)
    ik = jax.jit(dhgen_grad.jax_ik(robot(name)))
    (q, status), (joints, _) = jax.jvp(ik, tuple(moved.given), tuple(moved.rates))
    assert q.dtype == np.float64
    assert status.tolist() == moved.status.tolist()
    found = dhgen_grad.solved(moved.status)[..., 0]
    np.testing.assert_allclose(np.asarray(joints)[found], moved.joints[found], atol=1e-8)
    assert (np.asarray(joints)[~found] == 0.0).all()


@pytest.mark.parametrize("name", ["ur5", "kuka_iiwa14_arm_angle"])
def test_backwards_it_is_the_same(name: str) -> None:
    moved = move(name, 4)
    ik, many = dhgen_grad.jax_ik(robot(name)), (4, *moved.joints.shape[1:])
    weights = np.random.default_rng(7).normal(size=many)
    places = tuple(range(2, 2 + len(moved.given)))
    gradients = jax.grad(loss, places)(ik, weights, *moved.given)
    joints = np.where(dhgen_grad.solved(moved.status), moved.joints, 0.0)
    along = sum((a * b).sum() for a, b in zip(gradients, moved.rates, strict=True))
    assert float(along) == pytest.approx((joints * weights).sum(), abs=1e-6)
    compiled = jax.jit(jax.grad(loss, places), static_argnums=0)
    for variant in (
        compiled(ik, weights, *moved.given),
        jax.vmap(jax.grad(loss, places), (None, *[0] * (1 + len(places))))(
            ik, weights, *moved.given
        ),
    ):
        for a, b in zip(variant, gradients, strict=True):
            np.testing.assert_allclose(a, b, atol=1e-12)


def test_nothing_comes_back_from_rows_without_a_solution() -> None:
    far = robot("ur5").fk(POSTURES["ur5"])
    far[0, 3] = 5.0
    ik = dhgen_grad.jax_ik(robot("ur5"))
    gradient = jax.grad(lambda T: (ik(T)[0] ** 2).sum())(far)
    assert gradient.tolist() == np.zeros((4, 4)).tolist()


def test_single_precision() -> None:
    (T,) = move("ur5", 4).given
    ik = dhgen_grad.jax_ik(robot("ur5"))
    single = jax.numpy.asarray(T, np.float32)
    q, _status = ik(single)
    assert q.dtype == np.float32
    gradient = jax.grad(loss, 2)(ik, 1.0, single)
    assert gradient.dtype == np.float32
    np.testing.assert_allclose(gradient, jax.grad(loss, 2)(ik, 1.0, T), atol=1e-3)
    with pytest.raises(TypeError, match="T must be float64 or float32, not int"):
        ik(np.eye(4, dtype=int))


@pytest.mark.parametrize(
    "name", quick_first(["ur5", "welding_5r", "kuka_iiwa14", "abb_irb460"], count=2)
)
def test_on_a_gpu_the_library_calculates(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Outside jit; inside poses come to the CPU."""
    given = [*map(jax.numpy.asarray, move(name).given)]
    ik = dhgen_grad.jax_ik(robot(name))
    places = tuple(range(2, 2 + len(given)))
    expected = jax.grad(loss, places)(ik, 1.0, *given)
    kind = type(given[0])
    calls = pretend(monkeypatch, kind, jax.numpy.asarray)
    there = dhgen_grad.jax_ik(robot(name))
    found = jax.grad(loss, places)(there, 1.0, *given)
    assert calls[:2] == ["ik_batch", "jacobian"]
    for a, b in zip(found, expected, strict=True):
        np.testing.assert_allclose(a, b, atol=1e-10)
    calls.clear()
    jax.jit(there)(*given)
    assert calls == []
