"""Files that a file manager opens: the program that runs already shows them, instead of another window.

The first program of its kind listens on a local socket of this user. ``--open FILE…`` connects to it and sends the
names; where none listens, the files are opened in the new window.
"""

from __future__ import annotations

import json
import logging
from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtNetwork import QLocalServer, QLocalSocket
from PySide6.QtWidgets import QWidget

from brdf_qt.link.address import LinkAddress, LinkAddressError, link_name

log = logging.getLogger(__name__)

_MOST_BYTES = 1 << 16
_MOST_FILES = 64
_WAIT_MS = 3000
_TAKEN = b"ok\n"


def hand_over(role: str, files: Sequence[Path]) -> bool:
    """Have the program of this role that runs already open files; False where none runs, or it does not answer."""
    address = _address(role)
    if address is None:
        return False
    socket = QLocalSocket()
    socket.connectToServer(address.socket_name)
    if not socket.waitForConnected(_WAIT_MS):
        return False
    socket.write(json.dumps([str(file.absolute()) for file in files]).encode() + b"\n")
    socket.flush()
    while not socket.canReadLine():
        if not socket.waitForReadyRead(_WAIT_MS):
            return False
    return bytes(socket.readLine().data()) == _TAKEN


class OpenFiles(QObject):
    """Listens for files to open, where no other program of the role does; ``window`` comes to the front with them.

    Signal: ``requested(list[Path])``.
    """

    requested = Signal(list)

    def __init__(self, role: str, window: QWidget) -> None:
        super().__init__(window)
        self._window = window
        self._address = _address(role)
        self._server = QLocalServer(self)
        self._server.setSocketOptions(QLocalServer.SocketOption.UserAccessOption)
        self._server.newConnection.connect(self._accept)
        if self._address is not None and self._address.claim():
            QLocalServer.removeServer(self._address.socket_name)
            if not self._server.listen(self._address.socket_name):
                log.warning("files of other programs: %s", self._server.errorString())

    def close(self) -> None:
        """Listen no more."""
        if self._server.isListening():
            self._server.close()
        if self._address is not None:
            self._address.give_up()

    def _accept(self) -> None:
        while self._server.hasPendingConnections():
            socket = self._server.nextPendingConnection()
            socket.setReadBufferSize(_MOST_BYTES)
            socket.disconnected.connect(socket.deleteLater)
            socket.readyRead.connect(self._read)

    def _read(self) -> None:
        socket = self.sender()
        if not isinstance(socket, QLocalSocket):
            return
        if not socket.canReadLine():
            if socket.bytesAvailable() >= _MOST_BYTES:
                socket.abort()
            return
        files = _files(bytes(socket.readLine().data()))
        if not files:
            socket.abort()
            return
        socket.write(_TAKEN)
        socket.flush()  # before the files are opened: who asked does not wait long
        socket.disconnectFromServer()
        self.open(files)

    def open(self, files: list[Path]) -> None:
        """Bring the window to the front, and request the files."""
        self._window.setWindowState(self._window.windowState() & ~Qt.WindowState.WindowMinimized)
        self._window.raise_()
        self._window.activateWindow()
        self.requested.emit(files)


def _files(line: bytes) -> list[Path]:
    """Return the files of a message; none where it is not one."""
    try:
        names = json.loads(line)
    except (ValueError, RecursionError):
        return []
    if not isinstance(names, list) or not 0 < len(names) <= _MOST_FILES:
        return []
    if not all(isinstance(name, str) and name and "\0" not in name for name in names):
        return []
    return [path for path in map(Path, names) if path.is_absolute()]


def _address(role: str) -> LinkAddress | None:
    try:
        return LinkAddress(f"{link_name()}-{role}")
    except LinkAddressError as error:
        log.warning("files of other programs: %s", error)
        return None
