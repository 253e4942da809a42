"""Messages of the link, decoded and checked on a thread of their own: a flood of them costs the window nothing.

What has come since the last turn is one batch. Of each topic only the newest valid message of a batch is handed on, so
a value that is replaced by the next one is decoded, and never checked.
"""

from __future__ import annotations

import threading
from collections.abc import Mapping
from dataclasses import dataclass
from queue import Empty, SimpleQueue
from typing import Any

from PySide6.QtCore import QObject, Qt, Signal

from brdf_qt.link.messages import (
    HELLO,
    MAX_BYTES,
    PEERS,
    BadMessageError,
    Check,
    Message,
    check_order,
    decode,
)
from brdf_suite.errors import SuiteError

_MOST_LINES = 1000


@dataclass(frozen=True)
class Parsed:
    """One line of a connection: the message in it, or what is wrong with it.

    ``invalid``: the envelope is right and the value is not, which is no fault of a program that only passes it on.
    """

    source: Any
    message: Message | None
    problem: str = ""
    invalid: bool = False


class MessageParser(QObject):
    """Decodes lines on a thread; ``parsed(found)`` hands out a batch, a list of :class:`Parsed`, on the main thread.

    Parameters
    ----------
    checks
        For each topic a function that raises where a value is not valid.
    """

    parsed = Signal(object)
    _made = Signal(object, int)

    def __init__(self, checks: Mapping[str, Check], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._checks = checks
        self._lines: SimpleQueue[tuple[Any, bytes] | None] = SimpleQueue()
        self.newest: dict[str, tuple[int, str]] = {}
        """By topic the order of the newest value that is known: older ones are left out. Written by the main thread."""
        self.waiting = 0
        """Bytes of lines that are not parsed yet."""
        self._made.connect(self._hand_out, Qt.ConnectionType.QueuedConnection)
        self._thread = threading.Thread(target=self._run, name="link messages", daemon=True)
        self._thread.start()

    def put(self, source: object, line: bytes) -> None:
        """Parse a line of a connection later on."""
        self.waiting += len(line)
        self._lines.put((source, line))

    def close(self) -> None:
        """End the thread; what waits is dropped."""
        self._made.disconnect(self._hand_out)
        self._lines.put(None)
        self._thread.join()

    def _hand_out(self, found: list[Parsed], size: int) -> None:
        self.waiting -= size
        self.parsed.emit(found)

    # Below here on the thread.

    def _run(self) -> None:
        while True:
            batch = [self._lines.get()]
            try:
                while len(batch) < _MOST_LINES:
                    batch.append(self._lines.get_nowait())
            except Empty:
                pass
            lines = [item for item in batch if item is not None]
            if len(lines) < len(batch):
                return
            self._made.emit(self._parse(lines), sum(len(line) for _, line in lines))

    def _parse(self, lines: list[tuple[Any, bytes]]) -> list[Parsed]:
        found: list[Parsed] = []
        values: dict[tuple[str, str], tuple[Message, object]] = {}
        for source, line in lines:
            try:
                if len(line) >= MAX_BYTES:
                    raise BadMessageError(f"longer than {MAX_BYTES} bytes")
                message = decode(line)
                if message.topic in (HELLO, PEERS):
                    found.append(Parsed(source, message))
                    continue
                if message.topic not in self._checks:
                    raise BadMessageError(f"unknown topic {message.topic!r}")
                known = self.newest.get(message.topic)
                check_order(message.seq, None if known is None else known[0])
            except BadMessageError as error:
                found.append(Parsed(source, None, str(error)))
                continue
            key = (message.topic, message.sender)
            if key not in values or message.order > values[key][0].order:
                values[key] = (message, source)
        taken = dict(self.newest)
        for message, source in sorted(values.values(), key=lambda item: item[0].order, reverse=True):
            if message.topic in taken and message.order <= taken[message.topic]:
                continue
            try:
                self._checks[message.topic](message.value)
            except (SuiteError, ValueError, TypeError, KeyError, RecursionError) as error:
                problem = f"a {message.topic} that is not valid: {error}"
                found.append(Parsed(source, None, problem, invalid=True))
                continue
            taken[message.topic] = message.order
            found.append(Parsed(source, message))
        return found
