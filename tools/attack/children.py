"""Forked children of the harness: quiet ones, and ones that answer."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable


def be_quiet() -> None:
    """Send what this process prints nowhere."""
    for stream in (1, 2):
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream)


def in_child(work: Callable[[], str]) -> str:
    """Return what ``work`` returns in a forked child: nothing of it stays in this process."""
    receive, send = os.pipe()
    pid = os.fork()
    if pid == 0:
        try:
            os.close(receive)
            answer = work()
        except BaseException as error:  # noqa: BLE001 - the parent raises it
            answer = f"!{type(error).__name__}: {error}"
        with os.fdopen(send, "w") as stream:
            stream.write(answer)
        os._exit(0)
    os.close(send)
    with os.fdopen(receive) as stream:
        answer = stream.read()
    os.waitpid(pid, 0)
    if not answer or answer.startswith("!"):
        raise RuntimeError(f"a child failed: {answer[1:] or 'it died'}")
    return answer


def wait_for_threads() -> None:
    """Wait for what a program waits for at its end: threads that force autosaves to the disk."""
    qt = sys.modules.get("PySide6.QtCore")
    if qt is not None:
        qt.QThreadPool.globalInstance().waitForDone()
