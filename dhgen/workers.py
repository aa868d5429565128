"""Work on all cores, in processes that end with the one that they work for."""

from __future__ import annotations

import multiprocessing
import os
import signal
import tempfile
from concurrent.futures import ProcessPoolExecutor
from typing import TYPE_CHECKING, TypeVar

from dhgen.interrupts import interrupts_held

if TYPE_CHECKING:
    from collections.abc import Callable, Iterator, Sequence

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

    Ctrl-C waits until then: amid Python's own beginning of a process it would be told at length.
    """
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.pthread_sigmask(signal.SIG_UNBLOCK, {signal.SIGINT})
    tempfile.tempdir = folder
