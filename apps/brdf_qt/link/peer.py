"""One connection of the live link: lines in, lines out, never blocking and never growing.

What waits to be written is kept per topic, and a newer message of a topic takes the place of an older one.
So a program that reads slowly, or has stopped reading, costs the others one message per topic and no more.
"""

from __future__ import annotations

import logging

from PySide6.QtCore import QObject, Signal
from PySide6.QtNetwork import QLocalSocket

from brdf_qt.link.messages import MAX_BYTES, BadMessageError, Message, decode

log = logging.getLogger(__name__)

MAX_BAD_LINES = 20
_READ_BYTES = 256 * 1024


class Peer(QObject):
    """A connected socket that speaks the link's lines.

    Signals: ``arrived(peer, Message)`` for each well-formed line; ``lost(peer)`` once, when the connection has
    ended for whichever reason. After ``lost`` the object sends and emits nothing.
    """

    arrived = Signal(object, object)
    lost = Signal(object)

    def __init__(self, socket: QLocalSocket, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.role = ""
        self._socket = socket
        self._incoming = bytearray()
        self._waiting: dict[str, bytes] = {}
        self._bad_lines = 0
        self._open = True
        socket.setParent(self)
        socket.setReadBufferSize(2 * MAX_BYTES)
        socket.readyRead.connect(self._read)
        socket.bytesWritten.connect(self._write_waiting)
        socket.disconnected.connect(self._ended)
        socket.errorOccurred.connect(self._ended)

    def send(self, message: Message) -> None:
        """Write now where the socket has nothing left to write, otherwise keep the newest of each topic."""
        if not self._open:
            return
        self._waiting[message.topic] = message.line
        self._write_waiting()

    def close(self) -> None:
        """End the connection; ``lost`` is emitted unless it was before."""
        if self._open:
            self._open = False
            self._waiting.clear()
            self._socket.abort()
            self.lost.emit(self)

    def _write_waiting(self) -> None:
        while self._open and self._waiting and self._socket.bytesToWrite() == 0:
            topic = next(iter(self._waiting))
            self._socket.write(self._waiting.pop(topic))
            self._socket.flush()

    def _read(self) -> None:
        while self._open and self._socket.bytesAvailable() > 0:
            self._incoming += bytes(self._socket.read(_READ_BYTES).data())
            *lines, rest = self._incoming.split(b"\n")
            self._incoming = bytearray(rest)
            for line in lines:
                self._take(bytes(line))
            if len(self._incoming) > MAX_BYTES:
                log.warning("live link: a message is longer than %d bytes, closing its connection", MAX_BYTES)
                self.close()

    def _take(self, line: bytes) -> None:
        if not self._open or not line.strip():
            return
        try:
            if len(line) >= MAX_BYTES:
                raise BadMessageError(f"longer than {MAX_BYTES} bytes")
            message = decode(line)
        except BadMessageError as error:
            self.complain(str(error))
            return
        self.arrived.emit(self, message)

    def complain(self, reason: str) -> None:
        """Log a bad message; a connection that keeps sending them is closed."""
        self._bad_lines += 1
        log.warning("live link: dropped a message: %s", reason)
        if self._bad_lines >= MAX_BAD_LINES:
            log.warning("live link: %d bad messages, closing their connection", self._bad_lines)
            self.close()

    def _ended(self) -> None:
        if not self._open:
            return
        if self._socket.state() == QLocalSocket.LocalSocketState.ConnectedState:
            return  # an error that did not end the connection
        self._read()  # what the other side wrote before it ended
        if not self._open:
            return
        self._open = False
        self._waiting.clear()
        self.lost.emit(self)
