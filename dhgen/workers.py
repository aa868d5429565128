"""Work on all cores, and Ctrl-C, wherever it comes: processes end with the one they work for."""

from __future__ import annotations

import _thread
import gc
import multiprocessing
import os
import shutil
import signal
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing.connection import wait
from threading import Thread, Timer
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence


LATER = 0.01  # [s] a call out of C has ended then
SELDOM = (100_000, 50, 100)  # in place of 700, 10 and 10


@contextmanager
def interrupts_repeated() -> Iterator[None]:
    """Repeats a KeyboardInterrupt that is lost, until it comes where errors are passed on.

    Where C calls Python they are not: they are printed and forgotten. LLVM calls whenever it has
    made code. numba misses the code then, or goes on silently.

    Raises:
        KeyboardInterrupt: Also in place of errors after one that was lost: they may come from that.
    """
    kept, repeated = sys.unraisablehook, list[Timer]()

    def repeat(lost: sys.UnraisableHookArgs) -> None:
        if lost.exc_type is not KeyboardInterrupt:
            kept(lost)
            return
        repeated.append(Timer(LATER, _thread.interrupt_main))
        repeated[-1].start()

    sys.unraisablehook = repeat
    try:
        yield
    except Exception as error:
        if repeated:
            raise KeyboardInterrupt from error
        raise
    finally:
        sys.unraisablehook = kept
        for timer in repeated:  # none may come when nobody waits for it any more
            timer.cancel()
            timer.join()


@contextmanager
def interrupts_held() -> Iterator[None]:
    """Lets Ctrl-C wait until the end; a process that begins meanwhile holds it, too."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def collect_seldom() -> None:
    """Has Python look for circles of values less often, in a process that is the command's own.

    Derivations keep many small values alive that are in none: to look through them again and again
    takes a tenth of the time.
    """
    gc.set_threshold(*SELDOM)


def reckon_alone() -> None:
    """Has NumPy begin no threads for its matrices, in a process that is the command's own.

    They are small here: threads would wait, busily, for work that never comes. It is set before
    NumPy is loaded, and for the workers, which are as many as there are cores.
    """
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


Item = TypeVar("Item")
Made = TypeVar("Made")


def side_by_side(make: Callable[[Item], Made], items: Sequence[Item]) -> Iterator[Made]:
    """What a function makes of each, in their order; of a single one in this process.

    Where nobody waits for the rest any more, as after Ctrl-C, workers are stopped amid their work.
    """
    count = min(len(items), os.cpu_count() or 1)
    if count <= 1:
        yield from map(make, items)
        return
    passing = tempfile.TemporaryDirectory(prefix="dhgen-", ignore_cleanup_errors=True)
    with passing as folder, ProcessPoolExecutor(count, None, _begin, (folder,)) as pool:
        try:
            with interrupts_held():  # by the workers until they have begun
                made = pool.map(make, items)
            yield from made
        except BaseException:
            for process in multiprocessing.active_children():
                process.terminate()
            raise


def _begin(folder: str) -> None:
    """Lets a worker end at once and without a word; what it leaves behind is in the folder.

    Ctrl-C waits until then: while Python starts a process it would be reported at length.
    """
    collect_seldom()
    Thread(target=_end_with_parent, args=(folder,), daemon=True).start()
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
    tempfile.tempdir = folder


def _end_with_parent(folder: str) -> None:
    """Ends a worker whose command was killed: it would wait for the next item for ever."""
    parent = multiprocessing.parent_process()
    if parent is not None:
        wait([parent.sentinel])
        shutil.rmtree(folder, ignore_errors=True)
        os._exit(1)
