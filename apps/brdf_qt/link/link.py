"""The live link: programs of one user on one machine share what is being edited.

The first program is the hub: it listens on a local socket, the others connect to it, and it passes on what
they say. When the hub ends, another takes its place after a short random wait. No program ever waits for
another; each works alone as well.

Delivered is only the newest value of each topic of what has come, and only after it has passed the reader of its
document, on a thread of its own (:mod:`.parsing`). A newcomer receives the newest value of each topic.

What waits to be written to a program is kept per topic, and a newer message of a topic takes the place of an older
one. So a program that reads slowly, or has stopped reading, costs the others one message per topic and no more.
"""

from __future__ import annotations

import logging
import random
import uuid
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from PySide6.QtCore import QObject, Signal
from PySide6.QtNetwork import QLocalServer, QLocalSocket

from brdf_qt.link.address import LinkAddress, LinkAddressError, link_name
from brdf_qt.link.messages import (
    HELLO,
    MAX_BYTES,
    PEERS,
    Check,
    Message,
    document_checks,
    encode,
    next_seq,
)
from brdf_qt.link.parsing import MessageParser, Parsed
from brdf_qt.program.feature import Feature
from brdf_qt.work.timer import make_timer

log = logging.getLogger(__name__)

_RETRY_MS = (15, 90)
_MAX_RETRY_MS = 2000
_MAX_PEERS = 32
_MAX_BAD_LINES = 20
_READ_BYTES = 256 * 1024
_MOST_WAITING = 8 * MAX_BYTES
"""Bytes that may wait to be parsed before no more is read."""


@dataclass(eq=False)
class _Peer:
    """A connection: what it has sent of a line, and by topic what waits to be written to it."""

    socket: QLocalSocket
    role: str = ""
    incoming: bytes = b""
    waiting: dict[str, bytes] = field(default_factory=dict)
    bad_lines: int = 0
    open: bool = True


class LiveLink(Feature, QObject):
    """Publish and receive the newest value of a few topics.

    Parameters
    ----------
    role
        What this program is, for the others' status bars: ``"designer"``, ``"viewer"``…
    name
        The link's name; ``None``: the user's own link, or the one that ``BRDF_SUITE_LINK`` names.
    checks
        For each topic a function that raises where a value is not valid; ``None``: paint and view documents.

    Signals: ``received(topic, value)`` with the newest valid value from another program;
    ``peers_changed(count)`` with the number of other programs on the link. Start with :meth:`start`.
    """

    received = Signal(str, object)
    peers_changed = Signal(int)

    def __init__(
        self,
        role: str,
        *,
        name: str | None = None,
        checks: Mapping[str, Check] | None = None,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._role = role
        self.name = link_name() if name is None else name
        self._checks = checks
        self._id = uuid.uuid4().hex
        self._address: LinkAddress | None = None
        self._server: QLocalServer | None = None
        self._socket: QLocalSocket | None = None
        self._peers: list[_Peer] = []
        self.peers: tuple[str, ...] = ()
        """The roles of the other programs on the link, sorted."""
        self._latest: dict[str, Message] = {}
        self._parser: MessageParser | None = None
        self._running = False
        self._failures = 0
        self._retry = make_timer(self, self._join)

    @property
    def is_hub(self) -> bool:
        """Whether this program passes on what the others say."""
        return self._server is not None

    def start(self) -> None:
        """Look for the others; returns at once. Where the link cannot be, a log line says why."""
        if self._running:
            return
        try:
            self._address = LinkAddress(self.name)
        except LinkAddressError as error:
            log.warning("live link: %s", error)
            return
        if self._checks is None:
            self._checks = document_checks()
        self._parser = MessageParser(self._checks, self)
        self._parser.newest.update({topic: message.order for topic, message in self._latest.items()})
        self._parser.parsed.connect(self._take)
        self._running = True
        self._join()

    def close(self) -> None:
        """Leave the link; the others go on."""
        self._running = False
        self._retry.stop()
        if self._socket is not None:
            self._socket.abort()
        for peer in tuple(self._peers):
            self._end(peer)
        if self._parser is not None:
            self._parser.close()
            self._parser = None
        if self._server is not None and self._address is not None:
            self._server.close()
            self._server.deleteLater()
            self._server = None
            self._address.give_up()

    def publish(self, topic: str, value: dict[str, Any]) -> None:
        """Send the others the value of a topic now; programs that come later receive it as well.

        Raises
        ------
        BadMessageError
            The value is not plain JSON, or longer than a message may be.
        """
        known = self._latest.get(topic)
        message = encode(topic, value, self._id, next_seq(None if known is None else known.seq))
        self._keep(message)
        for peer in self._peers:
            self._send(peer, message)

    # Joining: hub where the lock is free, otherwise a connection to the program that holds it.

    def _join(self) -> None:
        if not self._running or self._peers or self._socket is not None or self._address is None:
            return
        if self._address.claim():
            self._serve(self._address)
            return
        self._socket = QLocalSocket(self)
        self._socket.connected.connect(self._connected)
        self._socket.errorOccurred.connect(self._not_connected)
        self._socket.connectToServer(self._address.socket_name)

    def _serve(self, address: LinkAddress) -> None:
        QLocalServer.removeServer(address.socket_name)
        server = QLocalServer(self)
        server.setSocketOptions(QLocalServer.SocketOption.UserAccessOption)
        server.newConnection.connect(self._accept)
        if not server.listen(address.socket_name):
            log.warning("live link: cannot listen on %s: %s", address.socket_name, server.errorString())
            server.deleteLater()
            address.give_up()
            self._join_later()
            return
        self._server = server
        self._failures = 0
        self._announce_peers()

    def _connected(self) -> None:
        socket, self._socket = self._socket, None
        if socket is None or not self._running:
            return
        self._failures = 0
        socket.connected.disconnect(self._connected)
        socket.errorOccurred.disconnect(self._not_connected)
        peer = self._add(socket)
        self._send(peer, encode(HELLO, {"role": self._role}, self._id, 0))
        for message in self._latest.values():
            self._send(peer, message)

    def _not_connected(self) -> None:
        if self._socket is not None:
            self._socket.deleteLater()
            self._socket = None
        self._failures += 1
        self._join_later()

    def _join_later(self) -> None:
        if self._running:
            wait = random.uniform(*_RETRY_MS) * 1.5 ** min(self._failures, 12)  # noqa: S311 - a wait
            self._retry.start(int(min(wait, _MAX_RETRY_MS)))

    def _accept(self) -> None:
        while self._server is not None and self._server.hasPendingConnections():
            socket = self._server.nextPendingConnection()
            if len(self._peers) >= _MAX_PEERS:
                log.warning("live link: more than %d programs, the newest is turned away", _MAX_PEERS)
                socket.abort()
                socket.deleteLater()
                continue
            peer = self._add(socket)
            for message in self._latest.values():
                self._send(peer, message)
            self._announce_peers()

    def _add(self, socket: QLocalSocket) -> _Peer:
        peer = _Peer(socket)
        socket.setParent(self)
        socket.setReadBufferSize(2 * MAX_BYTES)
        # Not by peer: a function that knew one would be called, too, when the link goes with its sockets.
        socket.readyRead.connect(self._read)
        socket.bytesWritten.connect(self._write_waiting)
        socket.disconnected.connect(self._end_disconnected)
        socket.errorOccurred.connect(self._end_disconnected)
        self._peers.append(peer)
        return peer

    def _end_disconnected(self, *_: object) -> None:
        self._read(everything=True)  # what the other side wrote before it ended
        for peer in tuple(self._peers):
            if peer.socket.state() != QLocalSocket.LocalSocketState.ConnectedState:
                self._end(peer)

    def _end(self, peer: _Peer) -> None:
        """End a connection; where it had ended before, nothing is done."""
        if not peer.open:
            return
        peer.open = False
        peer.waiting.clear()
        peer.socket.abort()
        peer.socket.deleteLater()
        self._peers.remove(peer)
        if self.is_hub:
            self._announce_peers()
            return
        self._set_roles(())
        self._join_later()

    # Lines of a connection.

    def _send(self, peer: _Peer, message: Message) -> None:
        """Write now where the socket has nothing left to write, otherwise keep the newest of each topic."""
        if peer.open:
            peer.waiting[message.topic] = message.line
            self._write_waiting()

    def _write_waiting(self, *_: object) -> None:
        for peer in tuple(self._peers):
            while peer.open and peer.waiting and peer.socket.bytesToWrite() == 0:
                topic = next(iter(peer.waiting))
                peer.socket.write(peer.waiting.pop(topic))
                peer.socket.flush()

    def _read(self, *, everything: bool = False) -> None:
        """Read what has come, unless much of it is not parsed yet; ``everything``: of a side that has ended."""
        parser = self._parser
        for peer in tuple(self._peers):
            while peer.open and parser is not None and peer.socket.bytesAvailable() > 0:
                if parser.waiting > _MOST_WAITING and not everything:
                    return  # the rest stays in the sockets, which slows down who sends it
                received = peer.incoming + bytes(peer.socket.read(_READ_BYTES).data())
                *lines, peer.incoming = received.split(b"\n")
                for line in lines:
                    if line.strip():
                        parser.put(peer, line)
                if len(peer.incoming) > MAX_BYTES:
                    log.warning(
                        "live link: a message is longer than %d bytes, closing its connection", MAX_BYTES
                    )
                    self._end(peer)

    def _complain(self, peer: _Peer, reason: str) -> None:
        """Log a bad message; a connection that keeps sending them is closed."""
        peer.bad_lines += 1
        log.warning("live link: dropped a message: %s", reason)
        if peer.bad_lines >= _MAX_BAD_LINES:
            log.warning("live link: %d bad messages, closing their connection", peer.bad_lines)
            self._end(peer)

    # Messages.

    def _take(self, found: list[Parsed]) -> None:
        """Hand out, and as the hub pass on, what is news in a batch of messages."""
        for one in found:
            message, peer = one.message, one.source
            if message is None:
                if one.invalid:
                    log.warning("live link: dropped %s", one.problem)
                elif peer.open:
                    self._complain(peer, one.problem)
            elif message.topic == HELLO:
                self._hello(peer, message.value)
            elif message.topic == PEERS:
                if not self.is_hub:
                    self._take_peers(peer, message.value)
            elif self._is_news(message):
                self._keep(message)
                for other in tuple(self._peers):
                    if other is not peer:
                        self._send(other, message)
                self.received.emit(message.topic, message.value)
        self._read()

    def _is_news(self, message: Message) -> bool:
        known = self._latest.get(message.topic)
        return known is None or message.order > known.order

    def _keep(self, message: Message) -> None:
        self._latest[message.topic] = message
        if self._parser is not None:
            self._parser.newest[message.topic] = message.order

    def _hello(self, peer: _Peer, value: dict[str, Any]) -> None:
        role = value.get("role")
        if not isinstance(role, str) or len(role) > 40:
            self._complain(peer, "a hello without a role")
        elif self.is_hub and role != peer.role:
            peer.role = role
            self._announce_peers()

    def _take_peers(self, peer: _Peer, value: dict[str, Any]) -> None:
        roles = value.get("roles")
        if not isinstance(roles, list) or not all(isinstance(role, str) for role in roles):
            self._complain(peer, "a list of peers that is not one")
            return
        self._set_roles(tuple(sorted(roles)))

    def _announce_peers(self) -> None:
        """As the hub: send each program which others there are (and ourselves)."""
        for peer in self._peers:
            others = [self._role, *(p.role for p in self._peers if p is not peer and p.role)]
            self._send(peer, encode(PEERS, {"roles": others}, self._id, 0))
        self._set_roles(tuple(sorted(p.role for p in self._peers if p.role)))

    def _set_roles(self, roles: tuple[str, ...]) -> None:
        if roles != self.peers:
            self.peers = roles
            self.peers_changed.emit(len(roles))
