"""What Ctrl-C does: it ends a process that starts, and takes effect in a command only between imports.

``KeyboardInterrupt`` in the initialization of a library in C becomes an ``ImportError`` that blames the installation,
ends the process with a message for developers, or leaves a module that is half there.
"""

from __future__ import annotations

import _thread
import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

_AGAIN_S = 0.02
_IMPORTS = "<frozen importlib._bootstrap>"
_put_off = threading.Event()
"""Set while an interrupt waits for the end of an import."""


def end_at_interrupt() -> None:
    """Let SIGINT end this process at once and in silence; for entry points, before they import what takes long.

    The command and the windows set handlers of their own later. Nothing changes where SIGINT is handled or ignored
    already. While the interpreter and this package are loaded, Python still answers with a traceback.
    """
    if _is_unhandled() and threading.current_thread() is threading.main_thread():
        signal.signal(signal.SIGINT, signal.SIG_DFL)


@contextmanager
def interrupts_between_imports() -> Iterator[None]:
    """Raise ``KeyboardInterrupt`` for SIGINT within the block, but in no import; nothing where SIGINT is handled."""
    if not _is_unhandled() or threading.current_thread() is not threading.main_thread():
        yield
        return
    _put_off.clear()
    before = signal.signal(signal.SIGINT, _interrupt)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
    if _put_off.is_set():  # the block ended before it came again
        _put_off.clear()
        raise KeyboardInterrupt


def _is_unhandled() -> bool:
    return signal.getsignal(signal.SIGINT) in (signal.default_int_handler, signal.SIG_DFL)


def _interrupt(number: int, frame: FrameType | None) -> None:
    at = frame
    while at is not None:
        if at.f_code.co_filename == _IMPORTS:
            _put_off.set()
            again = threading.Timer(_AGAIN_S, _thread.interrupt_main)
            again.daemon = True
            again.start()
            return
        at = at.f_back
    _put_off.clear()
    signal.default_int_handler(number, frame)
