"""Small labels for facts under a field."""

from __future__ import annotations

from brdf_qt.fields.labels import PlainLabel
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel


def note(text: str = "") -> QLabel:
    """Return a small label for facts under a field; hidden while it is empty."""
    label = PlainLabel(text)
    label.setWordWrap(True)
    label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    label.setVisible(bool(text))
    return label


def set_note(label: QLabel, text: str) -> None:
    """Show ``text``, or hide the label where it is empty."""
    label.setText(text)
    label.setVisible(bool(text))
