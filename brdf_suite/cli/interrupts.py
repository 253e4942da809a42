"""Ctrl-C while modules are imported: it takes effect once they are.

``KeyboardInterrupt`` in the initialization of a library in C becomes an ``ImportError`` that blames the installation,
or leaves a module that is half there.
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


@contextmanager
def interrupts_between_imports() -> Iterator[None]:
    """Raise ``KeyboardInterrupt`` for SIGINT within the block, but in no import; nothing where SIGINT is handled."""
    is_default = signal.getsignal(signal.SIGINT) is signal.default_int_handler
    if not is_default or threading.current_thread() is not threading.main_thread():
        yield
        return
    signal.signal(signal.SIGINT, _interrupt)
    _put_off.clear()
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    if _put_off.is_set():  # the block ended before it came again
        _put_off.clear()
        raise KeyboardInterrupt


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
