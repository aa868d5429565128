"""Arrays of libraries that keep their streams to themselves, by DLPack, without a GPU."""

from __future__ import annotations

import gc
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from dhgen.runtime.helpers import dhgen_arrays, dhgen_cuda
from tests.gpu import library as waves
from tests.gpu.library import CPU, OWN_STREAM, Wave, Waves
from tests.gpu.solvers import calls, launches, robot

if TYPE_CHECKING:
    import ctypes

LEGACY = 1
EVENTS = "ask", "destroy"


def read(array: Any, name: str = "T") -> dhgen_arrays.Array:
    return dhgen_arrays.Call(array, None).read(array, name)


@pytest.mark.parametrize("strides", [None, (16, 4, 1)])
@pytest.mark.parametrize(
    ("dtype", "kind"), [("float64", "<f8"), ("float32", "<f4"), ("uint8", "|u1"), ("int32", "<i4")]
)
def test_what_a_capsule_holds(dtype: str, kind: str, strides: tuple[int, ...] | None) -> None:
    wave = Wave(Waves(), (3, 4, 4), dtype, strides=strides, offset=32)
    assert read(wave) == dhgen_arrays.Array("T", wave.place + 32, (3, 4, 4), kind)


def test_axes_of_length_one_have_any_stride() -> None:
    assert read(Wave(Waves(), (1, 4, 4), strides=(99, 4, 1))).shape == (1, 4, 4)
    assert read(Wave(Waves(), (0, 4, 4), strides=(5, 7, 9))).shape == (0, 4, 4)
    with pytest.raises(TypeError, match="T must be contiguous"):
        read(Wave(Waves(), (3, 4, 4), strides=(16, 1, 4)))


def test_arrays_on_the_cpu_are_refused() -> None:
    assert read(Wave(Waves(), (3, 4, 4), where=(13, 0))).shape == (3, 4, 4)  # of both sides
    with pytest.raises(TypeError, match=r"T must be an array on a GPU, not tests.gpu.library.Wave"):
        read(Wave(Waves(), (3, 4, 4), where=(CPU, 0)))


def test_a_capsule_is_given_back_once_with_its_call() -> None:
    wave = Wave(Waves(), (3, 4, 4))
    call = dhgen_arrays.Call(wave, None)
    call.read(wave, "T")
    call.read(wave, "T")
    assert (wave.holders, wave.deleted) == (2, 0)
    del call
    gc.collect()
    assert (wave.holders, wave.deleted) == (0, 2)


def test_the_library_s_memory_is_filled_in_order(
    solver: dhgen_cuda.Solver, driver: ctypes.CDLL
) -> None:
    """Poses are ready on the kernels' stream; the library's waits for these; no copy is made."""
    made = Waves()
    T = Wave(made, (1000, 4, 4))
    q, status = solver.ik_batch(T)
    assert made.taken == [q, status]
    assert (q.shape, status.shape) == ((1000, 2, 4), (1000, 2))
    assert made.streams == [LEGACY, LEGACY, LEGACY, OWN_STREAM, OWN_STREAM]
    *_, first, second, freed, one, other, end = calls(driver)
    for launch in (first, second):
        assert f" on 1: 3e8 {T.place:x} 0 0 {q.place:x} {status.place:x} " in launch
    event = one.rpartition(" ")[2]
    assert freed == "free 10000000500 on 1"
    assert one == other == f"stream {OWN_STREAM} waits for {event}"
    assert end == "pop"


def pairs(told: list[list[str]]) -> list[list[str]]:
    return [words for words in told if len(words) == 2]


def test_arrays_live_until_kernels_have_run(
    solver: dhgen_cuda.Solver, driver: ctypes.CDLL, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whoever lets go of poses and results does not free them: kernels may not have begun."""
    made = Waves()
    T, later = Wave(made, (64, 4, 4)), Wave(made, (64, 4, 4))
    solver.count(T, careful=False)
    gc.collect()
    assert T.holders == 1
    monkeypatch.setenv("CUEVENT_PENDING", "1")
    solver.count(later)
    gc.collect()
    assert (T.holders, later.holders) == (1, 1)
    monkeypatch.delenv("CUEVENT_PENDING")
    solver.count(later, careful=False)
    gc.collect()
    assert (T.holders, T.deleted, later.holders) == (0, 1, 1)
    told = [call.split() for call in calls(driver)]
    asked, ended = ([event for word, event in pairs(told) if word == each] for each in EVENTS)
    assert asked == [ended[0], *ended]


def test_the_caller_s_stream(solver: dhgen_cuda.Solver, driver: ctypes.CDLL) -> None:
    made = Waves()
    q = Wave(made, (200, 4))
    assert solver.fk(q, stream=7).shape == (200, 4, 4)
    assert made.streams == [7, 7, OWN_STREAM]
    assert " on 7: c8 0 0 10000001000 " in launches(driver)[0]


def test_the_library_s_own_stream_waits_for_nothing(
    solver: dhgen_cuda.Solver, driver: ctypes.CDLL, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(waves, "OWN_STREAM", 7)
    solver.fk(Wave(Waves(), (200, 4)), stream=7)
    monkeypatch.setattr(waves, "OWN_STREAM", -1)  # by the protocol: nobody is to wait
    solver.fk(Wave(Waves(), (200, 4)))
    assert not [call for call in calls(driver) if "waits" in call]
    monkeypatch.setattr(waves, "OWN_STREAM", None)  # by the protocol: the stream of all
    solver.fk(Wave(Waves(), (200, 4)), stream=7)
    assert [call.rpartition(" ")[0] for call in calls(driver) if "waits" in call] == [
        "stream 1 waits for"
    ]


def test_no_poses(solver: dhgen_cuda.Solver, driver: ctypes.CDLL) -> None:
    q, status = solver.ik_batch(Wave(Waves(), (0, 4, 4)))
    assert (q.shape, status.shape, calls(driver)) == ((0, 2, 4), (0, 2), [])


def test_given_values_and_seeds(solver: dhgen_cuda.Solver, driver: ctypes.CDLL) -> None:
    assert solver
    made = Waves()
    panda = dhgen_cuda.cuda(robot("franka_panda"))
    given, seeds = (Wave(made, (64, n), place=(n << 8) + (1 << 40)) for n in (1, 7))
    panda.ik_batch(Wave(made, (64, 4, 4)), given, nearest=seeds, careful=False)
    assert ": 40 10000001000 10000000100 10000000700 " in launches(driver)[0]
    with pytest.raises(TypeError, match="q_free must be float64, not <f4"):
        panda.ik_batch(Wave(made, (64, 4, 4)), Wave(made, (64, 1), "float32"))


def test_arrays_that_nobody_may_write_to(solver: dhgen_cuda.Solver) -> None:
    made = Waves()
    out = Wave(made, (64,), "uint8")
    with pytest.raises(TypeError, match=r"arrays of tests can't be written to from outside: leave"):
        solver.count(Wave(made, (64, 4, 4)), out=out)


def test_numpy_takes_over_what_it_made() -> None:
    """By a library that is real: the same memory, on the device that it says."""
    made = np.arange(6.0)
    streams: list[int] = []
    call = dhgen_arrays.Call(made, 7)
    taken = call.taken_over(made, streams.append)
    assert np.shares_memory(taken, made)
    assert streams == [LEGACY]


def test_jax_takes_over_what_it_made() -> None:
    jax = pytest.importorskip("jax", reason="JAX is not installed")
    made = jax.numpy.arange(6.0)
    streams: list[int] = []
    call = dhgen_arrays.Call(made, 7)
    assert call.handed_over
    taken = call.taken_over(made, streams.append)
    assert taken.unsafe_buffer_pointer() == made.unsafe_buffer_pointer()
    assert streams == [LEGACY]
    with pytest.raises(TypeError, match="T must be an array on a GPU, not jax"):
        call.read(made, "T")
    new = call.new((3, 2), "|u1")
    assert (new.shape, new.dtype, new.device) == ((3, 2), "uint8", made.device)


def test_capsules_of_numpy_and_jax_are_read() -> None:
    """The layout of what they write is the one that is read: by their own capsules."""
    values = np.arange(48.0, dtype=np.float32).reshape(3, 4, 4)
    found = dhgen_arrays._of_capsule(values.__dlpack__(), "T")
    assert found == dhgen_arrays.Array("T", values.ctypes.data, (3, 4, 4), "<f4")
    with pytest.raises(TypeError, match="T must be contiguous"):
        dhgen_arrays._of_capsule(values.swapaxes(1, 2).__dlpack__(), "T")
    jax = pytest.importorskip("jax", reason="JAX is not installed")
    array = jax.numpy.arange(3, dtype="uint8")
    found = dhgen_arrays._of_capsule(array.__dlpack__(), "T")
    assert found == dhgen_arrays.Array("T", array.unsafe_buffer_pointer(), (3,), "|u1")
