"""Ctrl-C, wherever it comes."""

from __future__ import annotations

import _thread
import signal
import sys
from contextlib import contextmanager
from threading import Timer
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Iterator

LATER = 0.01  # [s] a call out of C has ended then


@contextmanager
def interrupts_repeated() -> Iterator[None]:
    """Repeats a KeyboardInterrupt that is lost, until it comes where errors are passed on.

    Where C calls Python they are not: they are told and forgotten. LLVM calls whenever it has made
    code. numba misses the code then, or goes on without a word.

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
