"""Lines and notes of a document: every keystroke is an edit, a stay in the field is one undo step.

Undo and redo belong to the document, not to the field; Ctrl+E, which X11 takes for the end of the line, to a command.
"""

from __future__ import annotations

from PySide6.QtCore import QEvent, QSignalBlocker, Qt, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent, QKeySequence
from PySide6.QtWidgets import QLineEdit, QPlainTextEdit, QWidget


def is_of_window(event: QEvent) -> bool:
    """Whether a field with the focus asks if these keys are its own, and they are a command's of the window.

    Undo and Redo, and Ctrl+E with or without Shift: End does what it would do in a line.
    """
    if event.type() != QEvent.Type.ShortcutOverride or not isinstance(event, QKeyEvent):
        return False
    keys, held = QKeySequence.StandardKey, Qt.KeyboardModifier
    bare = event.modifiers() & ~(held.ShiftModifier | held.KeypadModifier)
    to_end = event.key() == Qt.Key.Key_E and bare == held.ControlModifier
    return to_end or event.matches(keys.Undo) or event.matches(keys.Redo)


class TextLine(QLineEdit):
    """One line; ``edited(text)`` by the user only, the gesture pair around a stay in it."""

    edited = Signal(str)
    gesture_started = Signal()
    gesture_finished = Signal()

    def __init__(self, name: str, longest: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(name)
        self.setMaxLength(longest)
        self._going = False
        self.textEdited.connect(self._on_edited)
        self.editingFinished.connect(self._end)

    def set_text(self, text: str) -> None:
        """Show ``text`` without a signal; the cursor stays where the text is the same."""
        if text != self.text():
            self.setText(text)

    def _on_edited(self, text: str) -> None:
        if not self._going:
            self._going = True
            self.gesture_started.emit()
        self.edited.emit(text)

    def _end(self) -> None:
        if self._going:
            self._going = False
            self.gesture_finished.emit()

    def event(self, event: QEvent) -> bool:
        if is_of_window(event):
            event.ignore()
            return False
        return super().event(event)


class TextNotes(QPlainTextEdit):
    """Some lines; signals as :class:`TextLine`. Tab leaves the field."""

    edited = Signal(str)
    gesture_started = Signal()
    gesture_finished = Signal()

    def __init__(self, name: str, lines: int = 4, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAccessibleName(name)
        self.setTabChangesFocus(True)
        self.setUndoRedoEnabled(False)
        self.setFixedHeight(lines * self.fontMetrics().lineSpacing() + 12)
        self._going = False
        self.textChanged.connect(self._on_changed)

    def set_text(self, text: str) -> None:
        if text != self.toPlainText():
            with QSignalBlocker(self):
                self.setPlainText(text)

    def _on_changed(self) -> None:
        if not self._going:
            self._going = True
            self.gesture_started.emit()
        self.edited.emit(self.toPlainText())

    def event(self, event: QEvent) -> bool:
        if is_of_window(event):
            event.ignore()
            return False
        return super().event(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        if self._going:
            self._going = False
            self.gesture_finished.emit()
