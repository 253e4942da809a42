"""The live link: programs of one user on one machine share what is being edited.

The first program is the hub: it listens on a local socket, the others connect to it, and it passes on what
they say. When the hub ends, another takes its place after a short random wait. No program ever waits for
another; each works alone as well.

Delivered is only the newest value of each topic, at most once per turn of the event loop, and only after it
has passed the reader of its document. A newcomer receives the newest value of each topic.
"""

from __future__ import annotations

import logging
import random
import uuid
from collections.abc import Mapping
from typing import Any

from PySide6.QtCore import QObject, Signal
from PySide6.QtNetwork import QLocalServer, QLocalSocket

from brdf_qt.link.address import LinkAddress, LinkAddressError, link_name
from brdf_qt.link.messages import HELLO, PEERS, Check, Message, document_checks, encode, next_seq
from brdf_qt.link.peer import Peer
from brdf_qt.work.timer import make_timer
from brdf_suite.errors import SuiteError

log = logging.getLogger(__name__)

_RETRY_MS = (15, 90)
_MAX_RETRY_MS = 2000
_MAX_PEERS = 32


class LiveLink(QObject):
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
        self._peers: list[Peer] = []
        self._roles: tuple[str, ...] = ()
        self._latest: dict[str, Message] = {}
        self._inbox: dict[tuple[str, str], tuple[Message, Peer]] = {}
        self._running = False
        self._failures = 0
        self._retry = make_timer(self, self._join)
        self._delivery = make_timer(self, self._deliver)

    @property
    def is_hub(self) -> bool:
        """Whether this program passes on what the others say."""
        return self._server is not None

    @property
    def peers(self) -> tuple[str, ...]:
        """The roles of the other programs on the link, sorted."""
        return self._roles

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
        self._running = True
        self._join()

    def close(self) -> None:
        """Leave the link; the others go on."""
        self._running = False
        self._retry.stop()
        self._delivery.stop()
        if self._socket is not None:
            self._socket.abort()
        for peer in tuple(self._peers):
            peer.close()
        self._stop_serving()

    def publish(self, topic: str, value: dict[str, Any]) -> None:
        """Send the others the value of a topic now; programs that come later receive it as well.

        Raises
        ------
        BadMessageError
            The value is not plain JSON, or longer than a message may be.
        """
        seen = [message.seq for message, _ in self._inbox.values() if message.topic == topic]
        if topic in self._latest:
            seen.append(self._latest[topic].seq)
        message = encode(topic, value, self._id, next_seq(max(seen, default=None)))
        self._latest[topic] = message
        for peer in self._peers:
            peer.send(message)

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

    def _stop_serving(self) -> None:
        if self._server is not None and self._address is not None:
            self._server.close()
            self._server.deleteLater()
            self._server = None
            self._address.give_up()

    def _connected(self) -> None:
        socket, self._socket = self._socket, None
        if socket is None or not self._running:
            return
        self._failures = 0
        socket.connected.disconnect(self._connected)
        socket.errorOccurred.disconnect(self._not_connected)
        peer = self._add(socket)
        peer.send(encode(HELLO, {"role": self._role}, self._id, 0))
        for message in self._latest.values():
            peer.send(message)

    def _not_connected(self) -> None:
        if self._socket is not None:
            self._socket.deleteLater()
            self._socket = None
        self._failures += 1
        self._join_later()

    def _join_later(self) -> None:
        if self._running:
            wait = random.uniform(*_RETRY_MS) * 1.5 ** min(self._failures, 12)
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
                peer.send(message)
            self._announce_peers()

    def _add(self, socket: QLocalSocket) -> Peer:
        peer = Peer(socket, self)
        peer.arrived.connect(self._arrived)
        peer.lost.connect(self._lost)
        self._peers.append(peer)
        return peer

    def _lost(self, peer: Peer) -> None:
        self._peers.remove(peer)
        peer.deleteLater()
        if self.is_hub:
            self._announce_peers()
            return
        self._set_roles(())
        self._join_later()

    # Messages.

    def _arrived(self, peer: Peer, message: Message) -> None:
        if message.topic == HELLO:
            self._hello(peer, message.value)
        elif message.topic == PEERS:
            if not self.is_hub:
                self._take_peers(peer, message.value)
        elif self._checks is None or message.topic not in self._checks:
            peer.complain(f"unknown topic {message.topic!r}")
        elif self._is_news(message):
            key = (message.topic, message.sender)
            waiting = self._inbox.get(key)
            if waiting is None or message.order > waiting[0].order:
                self._inbox[key] = (message, peer)
                self._delivery.start()

    def _is_news(self, message: Message) -> bool:
        known = self._latest.get(message.topic)
        return known is None or message.order > known.order

    def _deliver(self) -> None:
        """Hand out, and as the hub pass on, the newest valid message of each topic that came in this turn."""
        inbox, self._inbox = self._inbox, {}
        for message, source in sorted(inbox.values(), key=lambda item: item[0].order, reverse=True):
            if not self._is_news(message) or not self._is_valid(message):
                continue
            self._latest[message.topic] = message
            for peer in self._peers:
                if peer is not source:
                    peer.send(message)
            self.received.emit(message.topic, message.value)

    def _is_valid(self, message: Message) -> bool:
        try:
            (self._checks or {})[message.topic](message.value)
        except (SuiteError, ValueError, TypeError, KeyError, RecursionError) as error:
            log.warning("live link: dropped a %s that is not valid: %s", message.topic, error)
            return False
        return True

    def _hello(self, peer: Peer, value: dict[str, Any]) -> None:
        role = value.get("role")
        if not isinstance(role, str) or len(role) > 40:
            peer.complain("a hello without a role")
        elif self.is_hub and role != peer.role:
            peer.role = role
            self._announce_peers()

    def _take_peers(self, peer: Peer, value: dict[str, Any]) -> None:
        roles = value.get("roles")
        if not isinstance(roles, list) or not all(isinstance(role, str) for role in roles):
            peer.complain("a list of peers that is not one")
            return
        self._set_roles(tuple(sorted(roles)))

    def _announce_peers(self) -> None:
        """As the hub: send each program which others there are (and ourselves)."""
        for peer in self._peers:
            others = [self._role, *(p.role for p in self._peers if p is not peer and p.role)]
            peer.send(encode(PEERS, {"roles": others}, self._id, 0))
        self._set_roles(tuple(sorted(p.role for p in self._peers if p.role)))

    def _set_roles(self, roles: tuple[str, ...]) -> None:
        if roles != self._roles:
            self._roles = roles
            self.peers_changed.emit(len(roles))
