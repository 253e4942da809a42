"""Messages over the picture, and in no dialog: what happened, where, and what to do about it.

A message has a key. Showing another one with the same key replaces it, and ``dismiss(key)`` takes it away
once its reason is gone, so a drag through an unreachable value leaves no pile behind.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal

from PySide6.QtCore import QEvent, Qt, QTimer, Signal
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from brdf_qt.fields.form import icon_button
from brdf_qt.fields.labels import ElidedLabel, PlainLabel, plain_tip, set_bold
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.icons import icon
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.floating import Floating
from brdf_qt.work.timer import make_timer
from brdf_suite.errors import FileError, SuiteError

Severity = Literal["info", "warning", "error"]
_ICONS = {
    "info": ("info", ""),
    "warning": ("warning-fill", "warning"),
    "error": ("warning-octagon-fill", "bad"),
}
_WORDS = {"info": mark("Note"), "warning": mark("Warning"), "error": mark("Error")}


@dataclass(frozen=True)
class Message:
    """One message; ``actions`` are buttons, each a text and what it does (the message then leaves)."""

    key: str
    what: str
    where: str = ""
    todo: str = ""
    severity: Severity = "info"
    actions: tuple[tuple[str, Callable[[], None]], ...] = ()
    closable: bool = True


def message_of(error: BaseException, key: str, *, todo: str = "") -> Message:
    """Return the message for ``error``; a bug of ours is named as such, with where the log is."""
    if isinstance(error, FileError):
        folder, name = os.path.split(error.path.rstrip("/\\"))
        reason = tr_core(error.reason)
        what = f"{name}: {reason}" if name else _capitalized(reason)
        what += "" if reason.endswith("?") else "."
        place = tr_core(error.place or "")
        if " " in place:  # no name of a field
            place = _capitalized(place)
        both = tr("{place}, in {folder}").format(place=place, folder=folder)
        return Message(
            key, what, where=both if place and folder else place or folder, todo=todo, severity="error"
        )
    if isinstance(error, SuiteError):
        return Message(key, tr_core(str(error)), todo=todo, severity="error")
    what = tr("Internal error: {fault}").format(fault=f"{type(error).__name__}: {error}")
    todo = todo or tr("Your document is unchanged; save it. The log has the details.")
    return Message(key, what, todo=todo, severity="error")


def _capitalized(text: str) -> str:
    return text[:1].upper() + text[1:]


class _Row(QFrame):
    """A message, whole or in one line; its arrow, and a click on the line, ask for the whole of it."""

    closed = Signal(str)
    opened = Signal(str)

    def __init__(self, message: Message, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.message = message
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setAutoFillBackground(True)
        self.setBackgroundRole(self.backgroundRole().AlternateBase)
        self.setObjectName(f"message_{message.key}")
        self.setAccessibleName(f"{tr(_WORDS[message.severity])}: {message.what}")
        row = QHBoxLayout(self)
        row.setContentsMargins(8, 6, 8, 6)
        row.setSpacing(8)
        self._sign = PlainLabel()
        self._draw_sign()
        self._sign.setAccessibleName(tr(_WORDS[message.severity]))
        row.addWidget(self._sign, 0, Qt.AlignmentFlag.AlignTop)
        texts = QVBoxLayout()
        texts.setSpacing(2)
        self.what = self._label(message.what, bold=message.severity != "info")
        self._whole = [self.what, *(self._label(text) for text in (message.where, message.todo) if text)]
        self._line = ElidedLabel(message.what)
        self._line.setFont(self.what.font())
        self._line.setToolTip(plain_tip("\n".join(label.text() for label in self._whole)))
        self._line.hide()
        for label in (*self._whole, self._line):
            texts.addWidget(label)
        row.addLayout(texts, 1)
        self._arrow = QToolButton(arrowType=Qt.ArrowType.RightArrow, autoRaise=True)
        self._arrow.setToolTip(tr("Show the whole message"))
        self._arrow.setAccessibleName(tr("Show the whole message"))
        self._arrow.clicked.connect(lambda: self.opened.emit(self.message.key))
        self._arrow.hide()
        row.addWidget(self._arrow, 0, Qt.AlignmentFlag.AlignTop)
        for text, slot in message.actions:
            button = QPushButton(text)
            button.setObjectName(f"message_action_{text}")
            button.clicked.connect(lambda _=False, slot=slot: self._act(slot))
            row.addWidget(button, 0, Qt.AlignmentFlag.AlignVCenter)
        if message.closable:
            close = icon_button(
                "x", tr("Close this message"), lambda: self.closed.emit(self.message.key), flat=True
            )
            row.addWidget(close, 0, Qt.AlignmentFlag.AlignTop)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        # A label keeps the pixels of its picture, in the colour of the theme in which they were drawn.
        if event.type() == QEvent.Type.PaletteChange and hasattr(self, "_sign"):
            self._draw_sign()

    def _draw_sign(self) -> None:
        self._sign.setPixmap(icon(*_ICONS[self.message.severity]).pixmap(16, 16))

    @property
    def is_brief(self) -> bool:
        return not self._line.isHidden()

    def set_brief(self, brief: bool) -> None:
        for label in self._whole:
            label.setVisible(not brief)
        self._line.setVisible(brief)
        self._arrow.setVisible(brief)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        super().mouseReleaseEvent(event)
        if self.is_brief:
            self.opened.emit(self.message.key)

    def _label(self, text: str, *, bold: bool = False) -> QLabel:
        label = PlainLabel(text)
        label.setWordWrap(True)
        label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        policy = QSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        policy.setHeightForWidth(True)
        label.setSizePolicy(policy)
        label.setMinimumWidth(80)
        if bold:
            set_bold(label, True)
        return label

    def _act(self, slot: Callable[[], None]) -> None:
        self.closed.emit(self.message.key)
        slot()


class MessageBar(Floating):
    """A stack of messages over the picture. Notes go away by themselves, unless the pointer is on them.

    One is shown whole, the newest or the one that was asked for; the others take a line each, so that several of
    them leave the picture its room.
    """

    most = 4
    note_ms = 10_000
    """How long a note stays that asks for nothing."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(Qt.Edge.TopEdge, parent)
        self.setObjectName("messages")
        self._rows: dict[str, _Row] = {}
        self._open = ""
        self._box = QVBoxLayout(self)
        self._box.setContentsMargins(0, 0, 0, 0)
        self._box.setSpacing(4)
        self.hide()

    def show_message(self, message: Message) -> None:
        """Show ``message``, in the place of the one with the same key; texts of the core in the user's language."""
        message = replace(message, what=tr_core(message.what), todo=tr_core(message.todo))
        present = self._rows.get(message.key)
        if present is not None and present.message == message:
            return
        place = self._box.count()
        if present is not None:
            place = self._box.indexOf(present)
            self._drop(message.key)
        elif len(self._rows) >= self.most:
            self._drop(next(iter(self._rows)))
            place = self._box.count()
        row = _Row(message, self)
        row.closed.connect(self.dismiss)
        row.opened.connect(self.open)
        self._rows[message.key] = row
        if message.severity == "info" and message.closable and not message.actions:
            leaves = make_timer(row, lambda: self._leave(row, leaves), self.note_ms)
            leaves.start()
        self._box.insertWidget(place, row)
        self.open(message.key)
        self.show()

    def open(self, key: str) -> None:
        """Show this message whole and the others in a line."""
        self._open = key
        for other, row in self._rows.items():
            row.set_brief(other != key)

    def brief(self) -> tuple[str, ...]:
        """Return the keys of the messages that are shown in a line."""
        return tuple(key for key, row in self._rows.items() if row.is_brief)

    def dismiss(self, key: str) -> None:
        """Take the message away; nothing where there is none."""
        if key in self._rows:
            self._drop(key)
            if key == self._open:
                self.open(next(reversed(self._rows), ""))
        self.setVisible(bool(self._rows))

    def shown(self) -> dict[str, Message]:
        """Return the messages that are shown, by key."""
        return {key: row.message for key, row in self._rows.items()}

    def _leave(self, row: _Row, timer: QTimer) -> None:
        key = row.message.key
        if self._rows.get(key) is not row:
            return  # it has been dismissed, and is deleted at the next turn of the event loop
        if row.underMouse():
            timer.start()  # it is being read
        else:
            self.dismiss(key)

    def _drop(self, key: str) -> None:
        row = self._rows.pop(key)
        self._box.removeWidget(row)
        row.hide()
        row.deleteLater()
